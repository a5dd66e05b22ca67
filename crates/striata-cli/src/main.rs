//! The `striata` command.
//!
//! In reading order: `command_line` and `args` define the command line; `commands` contains a module for each
//! verb, and a folder for those with several parts (`build`, `demo`, `info`, `render`), and `levels` for those that
//! write levels; `strip_lists` prepares strips for glTF files.
//!
//! Data goes to stdout; messages and progress go to stderr. Exit codes: 0 is success, 1 an error in the files or
//! on the machine, 2 an error on the command line, 3 an internal error.

mod args;
mod command_line;
mod commands;
mod strip_lists;

use std::process::ExitCode;

fn main() -> ExitCode {
    let words = command_line::translated(std::env::args_os());
    striata_command::run(words, command_line::hint, commands::run)
}
