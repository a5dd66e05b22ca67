//! Checks licenses, sources and duplicates of all dependencies with `cargo deny` (see `deny.toml`).

use anyhow::Result;

use crate::machine::starts;
use crate::steps::{self, cargo};

/// Returns why this cannot be checked on this machine, if it cannot.
pub(crate) fn obstacle() -> Option<&'static str> {
    (!starts("cargo-deny")).then_some("cargo-deny is not installed; run `cargo install cargo-deny --locked`")
}

/// Checks everything except advisories, which require the network and change independently of this
/// repository.
///
/// # Errors
/// If a dependency violates a rule.
pub(crate) fn check() -> Result<()> {
    steps::run(&mut cargo(&["deny", "check", "--hide-inclusion-graph", "licenses", "bans", "sources"]))
}
