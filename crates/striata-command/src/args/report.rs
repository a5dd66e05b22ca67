//! How every verb reports.

use clap::{ArgAction, Args};

/// How every verb reports.
#[derive(Clone, Copy, Debug, Args)]
pub struct ReportArgs {
    /// Print one JSON object to stdout instead of text
    #[arg(long, global = true)]
    pub json: bool,
    /// No progress, no summary; errors only
    #[arg(short, long, global = true)]
    pub quiet: bool,
    /// Print help
    #[arg(short, long, global = true, action = ArgAction::HelpShort)]
    help: Option<bool>,
}

/// How verbs that draw on a GPU report.
#[cfg(feature = "gpu")]
#[derive(Clone, Copy, Debug, Args)]
pub struct DriverArgs {
    /// Also show the messages of graphics drivers and libraries
    #[arg(short, long, conflicts_with = "quiet")]
    pub verbose: bool,
}
