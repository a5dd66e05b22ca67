//! What striata's commands share: the flags that several verbs take, reading and writing of files, progress bars and
//! tables, and failures with their hints and exit codes.
//!
//! In reading order: [`args`] are the flags; [`failure`], [`output`] and [`clock`] say how it goes; [`input`], [`shapes`] and [`save`]
//! read and write; [`sequence`], [`texture_contrast`], [`strip_chain`], [`strip_report`], [`fan_cover`], [`stream`] and [`level`] do what
//! the flags ask; [`page`] lays reports out for a browser.
//!
//! Data goes to stdout; progress and messages go to stderr. Exit codes: 0 done, 1 the user can fix it, 2 our fault.

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
pub mod sequence;
pub mod shapes;
pub mod stream;
pub mod strip_chain;
pub mod strip_report;
pub mod texture_contrast;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use clap::Parser;

use crate::failure::{Failure, announce_panic};

/// Reads the command line, does what it asks, and turns what comes of it into an exit code.
pub fn run<C: Parser>(work: impl FnOnce(&C) -> Result<(), Failure>) -> ExitCode {
    let cli = match C::try_parse() {
        Ok(cli) => cli,
        Err(error) => return refuse_arguments(&error),
    };
    std::panic::set_hook(Box::new(announce_panic));
    // State that a panic may leave half-done is not used again: only the exit code is.
    match catch_unwind(AssertUnwindSafe(|| work(&cli))) {
        Ok(Ok(())) => ExitCode::SUCCESS,
        Ok(Err(failure)) => failure.announce(),
        Err(_) => ExitCode::from(Failure::OURS),
    }
}

/// `--help` and `--version` come this way too, and are no failure.
fn refuse_arguments(error: &clap::Error) -> ExitCode {
    // Nothing is left to do if even the terminal is gone.
    let _ = error.print();
    if error.use_stderr() { ExitCode::from(Failure::USERS) } else { ExitCode::SUCCESS }
}

/// The readme's example, compiled with the documentation's tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
