//! Flags for what a verb prints.

use clap::{ArgAction, Args};

/// Flags of every verb for what it prints.
#[derive(Clone, Copy, Debug, Args)]
pub struct ReportArgs {
    /// Print the report as JSON to stdout
    #[arg(long, global = true)]
    pub json: bool,
    /// Print errors only: no progress, no summary
    #[arg(short, long, global = true)]
    pub quiet: bool,
    /// Print help
    #[arg(short, long, global = true, action = ArgAction::HelpShort)]
    help: Option<bool>,
}

/// Flags of verbs that draw on a GPU for what they print.
#[cfg(feature = "gpu")]
#[derive(Clone, Copy, Debug, Args)]
pub struct DriverArgs {
    /// Show messages from graphics drivers and libraries
    // Without this, the heading of whatever flags come before would apply here too.
    #[arg(short, long, conflicts_with = "quiet", help_heading = None)]
    pub verbose: bool,
}
