//! Licenses, sources and duplicates of what the workspace depends on, by `cargo deny`; `deny.toml` says what
//! is allowed.

use anyhow::Result;

use crate::machine::starts;
use crate::steps::{self, cargo};

/// Why they cannot be checked here, if they cannot.
pub(crate) fn obstacle() -> Option<&'static str> {
    (!starts("cargo-deny")).then_some("there is no cargo-deny; `cargo install cargo-deny --locked` gets it")
}

/// Checks all but advisories, which need the network and change without any change here.
///
/// # Errors
/// What is not allowed.
pub(crate) fn check() -> Result<()> {
    steps::run(&mut cargo(&["deny", "check", "--hide-inclusion-graph", "licenses", "bans", "sources"]))
}
