//! Checks that the workspace compiles with the oldest supported Rust, which is `rust-version`.

use std::process::Command;

use anyhow::Result;

use crate::command::FULL;
use crate::machine::starts;
use crate::steps::{self, say};
use crate::web::rustc_output;
use crate::workspace;

/// The oldest supported Rust version, inherited from the workspace like in every crate.
const RUST_VERSION: &str = env!("CARGO_PKG_RUST_VERSION");

/// Returns why this cannot be checked on this machine, if it cannot.
pub(crate) fn obstacle() -> Option<String> {
    let is_checkable = is_this_rust() || starts("rustup");
    (!is_checkable)
        .then(|| format!("this is not Rust {RUST_VERSION}, and rustup is not available to install it"))
}

/// Compiles the workspace with the oldest supported Rust, unless that is the current one.
///
/// # Errors
/// If the toolchain cannot be installed or the workspace does not compile.
pub(crate) fn check() -> Result<()> {
    if is_this_rust() {
        say(&format!("this is Rust {RUST_VERSION}, so the other checks already cover it"));
        return Ok(());
    }
    let toolchain = if RUST_VERSION.matches('.').count() == 1 {
        format!("{RUST_VERSION}.0")
    } else {
        RUST_VERSION.to_owned()
    };
    let is_installed = Command::new("rustup").args(["run", &toolchain, "rustc", "--version"]).output();
    if !is_installed.is_ok_and(|output| output.status.success()) {
        let install = ["toolchain", "install", &toolchain, "--profile", "minimal", "--no-self-update"];
        steps::run_twice(Command::new("rustup").args(install))?;
    }
    let check = ["run", &toolchain, "cargo", "check", "--workspace", "--features", FULL];
    steps::run(Command::new("rustup").args(check).current_dir(workspace()).env_remove("RUSTC"))
}

fn is_this_rust() -> bool {
    rustc_output(&["--version"]).is_ok_and(|output| is_release_of(&output, RUST_VERSION))
}

/// Whether the output of `rustc --version` names a release of the `expected` version; the patch number may
/// differ.
fn is_release_of(version_output: &str, expected: &str) -> bool {
    let minor = |version: &str| version.split('.').take(2).map(str::to_owned).collect::<Vec<_>>();
    let version = version_output.split_whitespace().nth(1).unwrap_or_default();
    !version.contains('-') && minor(version) == minor(expected)
}

#[cfg(test)]
mod tests {
    use super::is_release_of;

    #[test]
    fn releases_are_recognized_by_major_and_minor_version() {
        assert!(is_release_of("rustc 1.95.0 (59807616e 2026-04-14)", "1.95"));
        assert!(is_release_of("rustc 1.95.2", "1.95.0"));
        assert!(!is_release_of("rustc 1.96.0 (59807616e 2026-04-14)", "1.95"));
        assert!(!is_release_of("rustc 1.95.0-nightly (59807616e 2026-04-14)", "1.95"));
        assert!(!is_release_of("", "1.95"));
    }
}
