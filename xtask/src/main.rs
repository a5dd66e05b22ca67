//! Chores of the workspace; `cargo xtask test` is what continuous integration runs.

fn main() {}
