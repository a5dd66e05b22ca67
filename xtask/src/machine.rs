//! What the machine must have beside Rust and git, and how a bare Debian or Ubuntu gets it.

use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Result, bail};

use crate::steps::{run, run_twice, say};

/// What one package brings, and how to tell that it is there.
struct Wanted {
    sign: Sign,
    package: &'static str,
}

enum Sign {
    /// One of these programs starts.
    Program(&'static [&'static str]),
    /// One of these programs is in the path; those that know no `--version`.
    InPath(&'static [&'static str]),
    /// The linker knows a library of this name.
    Library(&'static str),
    /// A folder of this name holds a file.
    Filled(&'static str),
}

const WANTED: [Wanted; 12] = [
    // The simplifier's yardstick, a dev-dependency, is C++.
    Wanted { sign: Sign::Program(&["c++", "g++", "clang++"]), package: "g++" },
    // The glTF validator and the browser tests run on Node.js.
    Wanted { sign: Sign::Program(&["node"]), package: "nodejs" },
    Wanted { sign: Sign::Program(&["npm"]), package: "npm" },
    // The viewer page is tested in a browser.
    Wanted { sign: Sign::InPath(&["chromium"]), package: "chromium" },
    // Pictures are tested on a graphics driver that draws on the processor.
    Wanted { sign: Sign::Library("libvulkan.so.1"), package: "libvulkan1" },
    Wanted { sign: Sign::Filled("/usr/share/vulkan/icd.d"), package: "mesa-vulkan-drivers" },
    // The window is tested on a display without a screen, with the libraries that every desktop has.
    Wanted { sign: Sign::InPath(&["xvfb-run"]), package: "xvfb" },
    Wanted { sign: Sign::InPath(&["xauth"]), package: "xauth" },
    Wanted { sign: Sign::Library("libxkbcommon-x11.so.0"), package: "libxkbcommon-x11-0" },
    Wanted { sign: Sign::Library("libXcursor.so.1"), package: "libxcursor1" },
    Wanted { sign: Sign::Library("libXi.so.6"), package: "libxi6" },
    Wanted { sign: Sign::Library("libXrandr.so.2"), package: "libxrandr2" },
];

impl Wanted {
    fn is_there(&self) -> bool {
        match self.sign {
            Sign::Program(programs) => programs.iter().any(|program| starts(program)),
            Sign::InPath(programs) => programs.iter().any(|program| is_in_path(program)),
            Sign::Library(name) => {
                let known = Command::new("ldconfig").arg("-p").env("PATH", "/usr/sbin:/sbin").output();
                known.is_ok_and(|o| String::from_utf8_lossy(&o.stdout).contains(name))
            }
            Sign::Filled(folder) => std::fs::read_dir(folder).is_ok_and(|mut files| files.next().is_some()),
        }
    }
}

/// Installs what is missing.
///
/// # Errors
/// Where something is missing and cannot be installed.
pub(crate) fn prepare() -> Result<()> {
    let missing: Vec<&str> = WANTED.iter().filter(|w| !w.is_there()).map(|w| w.package).collect();
    if missing.is_empty() {
        say("compilers, node, chromium, a display and a graphics driver are there");
        return Ok(());
    }
    if !starts("apt-get") {
        bail!("missing: {}; please install them, there is no apt-get to do it with", missing.join(", "));
    }
    run_twice(as_root("apt-get").args(["update", "-q"]))?;
    run_twice(as_root("apt-get").args(["install", "-y", "-q", "--no-install-recommends"]).args(missing))
}

/// True where the compiler can make wasm32 code; adds the target where rustup can.
pub(crate) fn has_wasm_target() -> bool {
    if target_is_installed() {
        return true;
    }
    if starts("rustup") {
        // The answer is whether it is there afterwards.
        let _ = run_twice(Command::new("rustup").args(["target", "add", WASM_TARGET]));
    }
    target_is_installed()
}

/// The target that web pages run.
pub(crate) const WASM_TARGET: &str = "wasm32-unknown-unknown";

fn target_is_installed() -> bool {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(rustc).args(["--print", "target-libdir", "--target", WASM_TARGET]).output();
    output.is_ok_and(|o| Path::new(String::from_utf8_lossy(&o.stdout).trim()).is_dir())
}

/// Removes a folder with all it holds; one that is not there is fine.
///
/// # Errors
/// What the system reports.
pub(crate) fn remove_folder(folder: &Path) -> Result<()> {
    match std::fs::remove_dir_all(folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(error.into()),
        _ => Ok(()),
    }
}

/// Packages of the folder's lock file, into its `node_modules`.
///
/// # Errors
/// Where npm fails twice.
pub(crate) fn npm_install(folder: &Path) -> Result<()> {
    run_twice(Command::new("npm").args(["ci", "--no-audit", "--no-fund"]).current_dir(folder))
}

/// Runs npm in a folder.
///
/// # Errors
/// Where it fails.
pub(crate) fn npm(folder: &Path, arguments: &[&str]) -> Result<()> {
    run(Command::new("npm").args(arguments).current_dir(folder))
}

/// Runs a script with Node.js.
///
/// # Errors
/// Where it fails.
pub(crate) fn node(folder: &Path, arguments: &[std::ffi::OsString]) -> Result<()> {
    run(Command::new("node").args(arguments).current_dir(folder))
}

fn as_root(program: &str) -> Command {
    let id = Command::new("id").arg("-u").output();
    if id.is_ok_and(|o| o.stdout.trim_ascii() == b"0") || !starts("sudo") {
        let mut command = Command::new(program);
        command.env("DEBIAN_FRONTEND", "noninteractive");
        return command;
    }
    let mut command = Command::new("sudo");
    command.args(["DEBIAN_FRONTEND=noninteractive", program]);
    command
}

fn is_in_path(program: &str) -> bool {
    std::env::var_os("PATH")
        .is_some_and(|path| std::env::split_paths(&path).any(|folder| folder.join(program).is_file()))
}

/// Whether a program is there and says its version.
pub(crate) fn starts(program: &str) -> bool {
    let quiet = || Stdio::null();
    let status =
        Command::new(program).arg("--version").stdin(quiet()).stdout(quiet()).stderr(quiet()).status();
    status.is_ok_and(|s| s.success())
}
