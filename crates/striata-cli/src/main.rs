//! The `striata` command.
//!
//! Data goes to stdout, talk and progress bars to stderr. Exit codes: 0 done, 1 the user can fix it, 2 our fault.

mod args;
mod commands;
mod strip_lists;

use std::process::ExitCode;

fn main() -> ExitCode {
    striata_command::run(commands::run)
}
