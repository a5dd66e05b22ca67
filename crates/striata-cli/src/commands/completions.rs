//! `completions`: prints a script that completes verbs and flags in the user's shell.

use clap::CommandFactory;

use crate::args::{Cli, CompletionsArgs};
use striata_command::failure::Failure;
use striata_command::output::to_stdout;

/// Prints the script.
///
/// # Errors
/// If stdout cannot be written to.
pub(crate) fn run(args: &CompletionsArgs) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "striata", &mut script);
    to_stdout(&script)
}
