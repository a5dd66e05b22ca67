//! The `striata` command.
//!
//! In reading order: `args` defines the command line; `commands` contains a module for each verb, and a
//! folder for those with several parts (`build`, `demo`, `extract`, `info`, `render`); `strip_lists` prepares
//! strips for glTF files.
//!
//! Data goes to stdout; messages and progress bars go to stderr. Exit codes: 0 is success, 1 an error that
//! the user can fix, 2 an internal error.

mod args;
mod commands;
mod strip_lists;

use std::process::ExitCode;

fn main() -> ExitCode {
    striata_command::run(commands::run)
}
