//! Code shared by the commands of striata: flags, input and output of files, progress, tables, and failures.
//!
//! In reading order: [`args`] are the flags; [`failure`], [`output`] and [`clock`] report results, errors and
//! times; [`input`], [`shapes`], [`scene`] and [`save`] read and write meshes and scenes; [`sequence`],
//! [`strip_chain`], [`strip_report`], [`fan_cover`], [`stream`] and [`level`] carry out
//! what the flags ask for; [`page`] formats reports as HTML.
//!
//! Data goes to stdout; progress and messages go to stderr. Exit codes: 0 is success, 1 an error that the
//! user can fix, 2 an internal error.

pub mod args;
pub mod clock;
#[cfg(feature = "gpu")]
pub mod driver_messages;
pub mod failure;
pub mod fan_cover;
pub mod input;
pub mod level;
pub mod output;
pub mod page;
pub mod save;
pub mod scene;
pub mod sequence;
pub mod shapes;
pub mod stream;
pub mod strip_chain;
pub mod strip_report;

use std::ffi::OsString;
use std::io::{self, Write as _};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use clap::Parser;

use crate::failure::{Failure, report_panic};

/// Parses the words of the command line, runs `work`, and turns the result into an exit code. `hint` may say what to do
/// about words that cannot be parsed.
pub fn run<C: Parser>(
    words: impl IntoIterator<Item = OsString>,
    hint: impl FnOnce(&clap::Error) -> Option<String>,
    work: impl FnOnce(&C) -> Result<(), Failure>,
) -> ExitCode {
    let cli = match C::try_parse_from(words) {
        Ok(cli) => cli,
        Err(error) => return print_parser_message(&error, hint(&error)),
    };
    std::panic::set_hook(Box::new(report_panic));
    // After a panic only the exit code is used, so inconsistent state cannot be observed.
    match catch_unwind(AssertUnwindSafe(|| work(&cli))) {
        Ok(Ok(())) => ExitCode::SUCCESS,
        Ok(Err(failure)) => failure.announce(),
        Err(_) => ExitCode::from(Failure::INTERNAL_ERROR),
    }
}

/// Prints what the parser returned instead of arguments: an error, or the text of `--help` or `--version`.
fn print_parser_message(error: &clap::Error, hint: Option<String>) -> ExitCode {
    // If even the terminal is gone, nothing is left to do.
    let _ = error.print();
    if let Some(hint) = hint {
        let _ = writeln!(io::stderr(), "hint: {hint}");
    }
    if error.use_stderr() { ExitCode::from(Failure::USER_ERROR) } else { ExitCode::SUCCESS }
}

/// The example of the README, compiled as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
