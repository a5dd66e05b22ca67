//! Checks for the tools and libraries that the tests need, and installs them on Debian and Ubuntu.

use std::path::Path;
use std::process::{Command, Stdio};

use anyhow::{Result, bail};

use crate::steps::{run, run_twice, say};

/// A required system package, and how to detect that it is installed.
struct Requirement {
    evidence: Evidence,
    package: &'static str,
}

enum Evidence {
    /// One of these programs starts.
    Program(&'static [&'static str]),
    /// One of these programs is in the path (for programs without `--version`).
    InPath(&'static [&'static str]),
    /// The dynamic linker finds this library.
    Library(&'static str),
    /// Python can import these modules.
    PythonModules(&'static str),
    /// This folder is not empty.
    NonEmptyFolder(&'static str),
}

const REQUIREMENTS: &[Requirement] = &[
    // A dev-dependency that the simplifier is compared with is written in C++.
    Requirement { evidence: Evidence::Program(&["c++", "g++", "clang++"]), package: "g++" },
    // The glTF validator and the browser tests run on Node.js.
    Requirement { evidence: Evidence::Program(&["node"]), package: "nodejs" },
    Requirement { evidence: Evidence::Program(&["npm"]), package: "npm" },
    // The Python package is tested in a virtual environment.
    Requirement { evidence: Evidence::PythonModules("venv, ensurepip"), package: "python3-venv" },
    // Open3D, whose meshes the Python package accepts, is linked with it.
    Requirement { evidence: Evidence::Library("libusb-1.0.so.0"), package: "libusb-1.0-0" },
    // The viewer page is tested in two browsers; Firefox needs OpenGL.
    Requirement { evidence: Evidence::InPath(&["chromium"]), package: "chromium" },
    Requirement { evidence: Evidence::InPath(&["firefox-esr"]), package: "firefox-esr" },
    Requirement { evidence: Evidence::Library("libGL.so.1"), package: "libgl1" },
    Requirement { evidence: Evidence::Library("libEGL.so.1"), package: "libegl1" },
    // Pictures are tested with a graphics driver that renders on the CPU.
    Requirement { evidence: Evidence::Library("libvulkan.so.1"), package: "libvulkan1" },
    Requirement {
        evidence: Evidence::NonEmptyFolder("/usr/share/vulkan/icd.d"),
        package: "mesa-vulkan-drivers",
    },
    // Firefox is tested on a virtual display.
    Requirement { evidence: Evidence::InPath(&["xvfb-run"]), package: "xvfb" },
    Requirement { evidence: Evidence::InPath(&["xauth"]), package: "xauth" },
];

impl Requirement {
    fn is_installed(&self) -> bool {
        match self.evidence {
            Evidence::Program(programs) => programs.iter().any(|program| starts(program)),
            Evidence::InPath(programs) => programs.iter().any(|program| is_in_path(program)),
            Evidence::Library(name) => {
                let known = Command::new("ldconfig").arg("-p").env("PATH", "/usr/sbin:/sbin").output();
                known.is_ok_and(|o| String::from_utf8_lossy(&o.stdout).contains(name))
            }
            Evidence::PythonModules(names) => {
                let import = Command::new("python3").args(["-c", &format!("import {names}")]).output();
                import.is_ok_and(|o| o.status.success())
            }
            Evidence::NonEmptyFolder(folder) => {
                std::fs::read_dir(folder).is_ok_and(|mut files| files.next().is_some())
            }
        }
    }
}

/// Installs missing packages.
///
/// # Errors
/// If a package is missing and cannot be installed.
pub(crate) fn prepare() -> Result<()> {
    let missing: Vec<&str> = REQUIREMENTS.iter().filter(|r| !r.is_installed()).map(|r| r.package).collect();
    if missing.is_empty() {
        say("compilers, node, python, chromium, firefox, a display and a graphics driver are available");
        return Ok(());
    }
    if !starts("apt-get") {
        bail!("missing packages: {}; please install them (apt-get is not available)", missing.join(", "));
    }
    run_twice(as_root("apt-get").args(["update", "-q"]))?;
    run_twice(as_root("apt-get").args(["install", "-y", "-q", "--no-install-recommends"]).args(missing))
}

/// Whether the compiler has the wasm32 target; adds it if rustup can.
pub(crate) fn has_wasm_target() -> bool {
    if target_is_installed() {
        return true;
    }
    if starts("rustup") {
        // Success is checked below.
        let _ = run_twice(Command::new("rustup").args(["target", "add", WASM_TARGET]));
    }
    target_is_installed()
}

/// Compilation target for web pages.
pub(crate) const WASM_TARGET: &str = "wasm32-unknown-unknown";

fn target_is_installed() -> bool {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let output = Command::new(rustc).args(["--print", "target-libdir", "--target", WASM_TARGET]).output();
    output.is_ok_and(|o| Path::new(String::from_utf8_lossy(&o.stdout).trim()).is_dir())
}

/// Removes a folder with its contents, if it exists.
///
/// # Errors
/// If the folder cannot be removed.
pub(crate) fn remove_folder(folder: &Path) -> Result<()> {
    match std::fs::remove_dir_all(folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => Err(error.into()),
        _ => Ok(()),
    }
}

/// Installs the npm packages of a folder's lock file.
///
/// # Errors
/// If npm fails twice.
pub(crate) fn npm_install(folder: &Path) -> Result<()> {
    run_twice(Command::new("npm").args(["ci", "--no-audit", "--no-fund"]).current_dir(folder))
}

/// Runs npm in a folder.
///
/// # Errors
/// If it fails.
pub(crate) fn npm(folder: &Path, arguments: &[&str]) -> Result<()> {
    run(Command::new("npm").args(arguments).current_dir(folder))
}

/// Runs a script with Node.js.
///
/// # Errors
/// If it fails.
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

/// Whether a program can be started with `--version`.
pub(crate) fn starts(program: &str) -> bool {
    let quiet = || Stdio::null();
    let status =
        Command::new(program).arg("--version").stdin(quiet()).stdout(quiet()).stderr(quiet()).status();
    status.is_ok_and(|s| s.success())
}
