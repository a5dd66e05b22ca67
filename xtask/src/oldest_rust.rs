//! The oldest Rust that compiles the workspace, which `rust-version` claims.

use std::process::Command;

use anyhow::Result;

use crate::command::FULL;
use crate::machine::starts;
use crate::steps::{self, say};
use crate::web::said_by_rustc;
use crate::workspace;

/// What is claimed; this crate takes it from the workspace, as all do.
pub(crate) const CLAIMED: &str = env!("CARGO_PKG_RUST_VERSION");

/// Why the claim cannot be checked here, if it cannot.
pub(crate) fn obstacle() -> Option<String> {
    let is_checkable = is_this_rust() || starts("rustup");
    (!is_checkable).then(|| format!("this is not Rust {CLAIMED}, and there is no rustup to get it with"))
}

/// Compiles the workspace with the Rust that is claimed, if that is not the one that compiles it anyway.
///
/// # Errors
/// What cannot be installed or does not compile.
pub(crate) fn check() -> Result<()> {
    if is_this_rust() {
        say(&format!("this is Rust {CLAIMED}, so all that compiles here confirms the claim"));
        return Ok(());
    }
    let toolchain =
        if CLAIMED.matches('.').count() == 1 { format!("{CLAIMED}.0") } else { CLAIMED.to_owned() };
    let is_there = Command::new("rustup").args(["run", &toolchain, "rustc", "--version"]).output();
    if !is_there.is_ok_and(|output| output.status.success()) {
        let install = ["toolchain", "install", &toolchain, "--profile", "minimal", "--no-self-update"];
        steps::run_twice(Command::new("rustup").args(install))?;
    }
    let check = ["run", &toolchain, "cargo", "check", "--workspace", "--features", FULL];
    steps::run(Command::new("rustup").args(check).current_dir(workspace()).env_remove("RUSTC"))
}

fn is_this_rust() -> bool {
    said_by_rustc(&["--version"]).is_ok_and(|said| is_release_of(&said, CLAIMED))
}

/// Whether a compiler that says this about itself is the claimed one, whatever its last number.
fn is_release_of(said: &str, claimed: &str) -> bool {
    let minor = |version: &str| version.split('.').take(2).map(str::to_owned).collect::<Vec<_>>();
    let version = said.split_whitespace().nth(1).unwrap_or_default();
    !version.contains('-') && minor(version) == minor(claimed)
}

#[cfg(test)]
mod tests {
    use super::is_release_of;

    #[test]
    fn the_claimed_rust_is_known_by_its_words() {
        assert!(is_release_of("rustc 1.95.0 (59807616e 2026-04-14)", "1.95"));
        assert!(is_release_of("rustc 1.95.2", "1.95.0"));
        assert!(!is_release_of("rustc 1.96.0 (59807616e 2026-04-14)", "1.95"));
        assert!(!is_release_of("rustc 1.95.0-nightly (59807616e 2026-04-14)", "1.95"));
        assert!(!is_release_of("", "1.95"));
    }
}
