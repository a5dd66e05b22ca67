//! The `striata` command.
//!
//! In reading order: `args` says what can be asked, `commands` holds the verbs (`build`, `info` and `extract`
//! in folders of their own, each with its report), and `strip_lists` the strips of levels for those that
//! write them.
//!
//! Data goes to stdout, talk and progress bars to stderr. Exit codes: 0 done, 1 the user can fix it, 2 our
//! fault.

mod args;
mod commands;
mod strip_lists;

use std::process::ExitCode;

fn main() -> ExitCode {
    striata_command::run(commands::run)
}
