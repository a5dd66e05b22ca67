//! The `striata` command.

fn main() {}
