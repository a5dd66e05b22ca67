//! Code shared by the commands of striata: flags, input and output of files, progress, tables, and failures.
//!
//! In reading order: [`args`] are the flags; [`failure`], [`output`] and [`clock`] report results, errors and
//! times; [`input`], [`shapes`], [`scene`] and [`save`] read and write meshes and scenes; [`sequence`],
//! [`strip_chain`], [`strip_report`], [`fan_cover`], [`stream`] and [`level`] carry out
//! what the flags ask for; [`page`] formats reports as HTML.
//!
//! Data goes to stdout; progress and messages go to stderr. Exit codes: 0 is success, 1 an error in the files or
//! on the machine, 2 an error on the command line, 3 an internal error.

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

use crate::failure::{Failure, FailureKind, panic_message, print_json, report_panic};

/// Parses the words of the command line, runs `work`, and turns the result into an exit code. `hint` may say what to do
/// about words that cannot be parsed. With `--json` among the words, errors are printed as JSON too.
pub fn run<C: Parser>(
    words: impl IntoIterator<Item = OsString>,
    hint: impl FnOnce(&clap::Error) -> Option<String>,
    work: impl FnOnce(&C) -> Result<(), Failure>,
) -> ExitCode {
    let words: Vec<OsString> = words.into_iter().collect();
    // Words that cannot be parsed may ask for JSON too.
    let is_json = words.iter().take_while(|&word| word != "--").any(|word| word == "--json");
    let cli = match C::try_parse_from(words) {
        Ok(cli) => cli,
        Err(error) => return print_parser_message(&error, hint(&error), is_json),
    };
    std::panic::set_hook(Box::new(report_panic));
    // After a panic only the exit code is used, so inconsistent state cannot be observed.
    match catch_unwind(AssertUnwindSafe(|| work(&cli))) {
        Ok(Ok(())) => ExitCode::SUCCESS,
        Ok(Err(failure)) => failure.announce(is_json),
        Err(panic) => {
            if is_json {
                print_json(FailureKind::Internal, &panic_message(&*panic), None);
            }
            ExitCode::from(FailureKind::Internal.exit_code())
        }
    }
}

/// Prints what the parser returned instead of arguments: an error, or the text of `--help` or `--version`.
fn print_parser_message(error: &clap::Error, hint: Option<String>, is_json: bool) -> ExitCode {
    // If even the terminal is gone, nothing is left to do.
    let _ = error.print();
    if !error.use_stderr() {
        return ExitCode::SUCCESS;
    }
    if let Some(hint) = &hint {
        let _ = writeln!(io::stderr(), "hint: {hint}");
    }
    if is_json {
        let text = error.render().to_string();
        let (message, tip) = parts_of_parser_message(&text);
        print_json(FailureKind::Usage, &message, hint.as_deref().or(tip));
    }
    ExitCode::from(FailureKind::Usage.exit_code())
}

/// Returns the first paragraph of an error of the parser in one line, and the tip that follows, if any.
fn parts_of_parser_message(text: &str) -> (String, Option<&str>) {
    let first = text.split("\n\n").next().unwrap_or_default();
    let words: Vec<&str> = first.trim_start_matches("error: ").split_whitespace().collect();
    (words.join(" "), text.lines().find_map(|line| line.trim().strip_prefix("tip: ")))
}

/// The example of the README, compiled as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_of_the_parser_is_one_line_and_a_tip() {
        let text =
            "error: unexpected argument '--ration'\n  found\n\n  tip: use '--ratio'\n\nUsage: striata\n";
        let (message, tip) = parts_of_parser_message(text);
        assert_eq!((message.as_str(), tip), ("unexpected argument '--ration' found", Some("use '--ratio'")));
    }
}
