//! The command as a release has it: one archive for each platform, which the installers unpack.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use sha2::{Digest, Sha256};

use crate::steps::{self, cargo, say};
use crate::web::rustc_output;
use crate::{machine, target_folder, workspace};

/// Version of the GNU C library that binaries for Linux need at most: that of manylinux2014.
const OLDEST_GLIBC: &str = "2.17";

/// Libraries that every Linux with the GNU C library has.
const SYSTEM_LIBRARIES: [&str; 8] =
    ["linux-vdso", "ld-linux", "libc.so", "libm.so", "libdl.so", "libpthread.so", "librt.so", "libgcc_s.so"];

/// Builds the command for a platform and packs it with its licenses.
///
/// # Errors
/// If it does not compile, or cannot be packed.
pub(crate) fn archive(target: &str, has_zig: bool) -> Result<PathBuf> {
    let verb = if has_zig { "zigbuild" } else { "build" };
    let with_glibc = format!("{target}.{OLDEST_GLIBC}");
    let cargo_target = if has_zig { &with_glibc } else { target };
    let package = [verb, "-p", "striata-cli", "--features", "full", "--profile", "dist", "--locked"];
    steps::run(cargo(&package).args(["--target", cargo_target]))?;
    let program = if target.contains("windows") { "striata.exe" } else { "striata" };
    pack(target, &target_folder()?.join(target).join("dist").join(program))
}

/// Packs a program in the archive of a platform.
fn pack(target: &str, program: &Path) -> Result<PathBuf> {
    let kit = target_folder()?.join("release-kit");
    let name = format!("striata-{target}");
    let content = kit.join(&name);
    machine::remove_folder(&content)?;
    fs::create_dir_all(&content)?;
    let manual = workspace().join("crates/striata-cli/README.md");
    let licenses = ["LICENSE-APACHE", "LICENSE-MIT"].map(|license| workspace().join(license));
    for file in [program.to_owned(), manual].into_iter().chain(licenses) {
        let file_name = file.file_name().context("a path without a file name")?;
        fs::copy(&file, content.join(file_name)).with_context(|| file.display().to_string())?;
    }
    let archive = format!("{name}.tar.gz");
    // Windows has this program too. Relative names, since it takes `C:` for a machine.
    steps::run(Command::new("tar").args(["-czf", &archive, &name]).current_dir(&kit))?;
    Ok(kit.join(archive))
}

/// Builds the archive of this machine, installs it as users do, and runs the command without anything around it.
///
/// # Errors
/// If any of this fails, or the command needs libraries that a bare system lacks.
pub(crate) fn check() -> Result<()> {
    let target = rustc_output(&["--print", "host-tuple"])?;
    check_archive(&archive(target.trim(), false)?)
}

/// Installs an archive into an empty folder, and runs what is in it.
fn check_archive(archive: &Path) -> Result<()> {
    let kit = archive.parent().context("an archive is in a folder")?;
    let name = archive.file_name().unwrap_or_default().to_string_lossy();
    let sum: String = Sha256::digest(fs::read(archive)?).iter().map(|byte| format!("{byte:02x}")).collect();
    fs::write(kit.join("SHA256SUMS"), format!("{sum}  {name}\n"))?;
    let bin = kit.join("bin");
    machine::remove_folder(&bin)?;
    let mut install = Command::new("sh");
    install.arg(workspace().join(".github/install.sh"));
    install.env("STRIATA_RELEASE", format!("file://{}", kit.display())).env("STRIATA_BIN", &bin);
    steps::run(&mut install)?;
    let program = bin.join("striata");
    for arguments in [&["version"][..], &["simplify", "shape:torus", "small.glb", "--ratio", "0.1"]] {
        steps::run(Command::new(&program).args(arguments).env_clear().current_dir(&bin))?;
    }
    if cfg!(target_os = "linux") {
        check_libraries(&program)?;
    }
    say(&format!("{name}: {} bytes", fs::metadata(archive)?.len()));
    Ok(())
}

/// Checks that the dynamic linker needs nothing that distributions package apart.
fn check_libraries(program: &Path) -> Result<()> {
    let output = Command::new("ldd").arg(program).output().context("cannot start ldd")?;
    let listed = String::from_utf8_lossy(&output.stdout).into_owned();
    for line in listed.lines() {
        let is_known = SYSTEM_LIBRARIES.iter().any(|library| line.contains(library));
        ensure!(is_known, "{} needs a library that a bare Linux lacks: {}", program.display(), line.trim());
    }
    Ok(())
}
