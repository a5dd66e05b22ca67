//! The `striata` command.
//!
//! Data goes to stdout, talk and progress bars to stderr. Exit codes: 0 done, 1 the user can fix it, 2 our fault.

mod args;
mod clock;
mod commands;
mod failure;
mod fan_cover;
#[cfg(feature = "gpu")]
mod hush;
mod input;
mod level;
mod output;
mod page;
mod picture;
mod save;
mod sequence;
mod shapes;
mod stream;
mod strip_chain;
mod strip_lists;
mod strip_report;
mod texture_contrast;
mod viewer_page;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;

use clap::Parser;

use crate::failure::{Failure, announce_panic};

fn main() -> ExitCode {
    let cli = match args::Cli::try_parse() {
        Ok(cli) => cli,
        Err(error) => return refuse_arguments(&error),
    };
    std::panic::set_hook(Box::new(announce_panic));
    // State that a panic may leave half-done is not used again: only the exit code is.
    match catch_unwind(AssertUnwindSafe(|| commands::run(&cli))) {
        Ok(Ok(())) => ExitCode::SUCCESS,
        Ok(Err(failure)) => failure.announce(),
        Err(_) => ExitCode::from(Failure::OURS),
    }
}

/// `--help` and `--version` come this way too, and are no failure.
fn refuse_arguments(error: &clap::Error) -> ExitCode {
    // Nothing is left to do where even the terminal is gone.
    let _ = error.print();
    if error.use_stderr() { ExitCode::from(Failure::USERS) } else { ExitCode::SUCCESS }
}
