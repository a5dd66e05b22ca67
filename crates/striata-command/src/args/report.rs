//! Flags for what a verb prints.

use clap::{ArgAction, Args};

// These flags end the list of every verb, always in this order.
const STRICT_ORDER: usize = 899;
const JSON_ORDER: usize = 900;
#[cfg(feature = "gpu")]
const VERBOSE_ORDER: usize = 901;
const QUIET_ORDER: usize = 902;
const HELP_ORDER: usize = 903;

/// Flags of every verb for what it prints.
#[derive(Clone, Copy, Debug, Args)]
pub struct ReportArgs {
    /// Treat warnings about inputs as errors
    // Without this, the heading of whatever flags come before would apply here too.
    #[arg(long, global = true, help_heading = None, display_order = STRICT_ORDER)]
    pub strict_input: bool,
    /// Print the report as JSON to stdout
    #[arg(long, global = true, display_order = JSON_ORDER)]
    pub json: bool,
    /// Print errors only: no progress, no summary
    #[arg(short, long, global = true, display_order = QUIET_ORDER)]
    pub quiet: bool,
    /// Print help
    #[arg(short, long, global = true, display_order = HELP_ORDER, action = ArgAction::HelpShort)]
    help: Option<bool>,
}

/// Flags of verbs that draw on a GPU for what they print.
#[cfg(feature = "gpu")]
#[derive(Clone, Copy, Debug, Args)]
pub struct DriverArgs {
    /// Show messages from graphics drivers and libraries
    // Without this, the heading of whatever flags come before would apply here too.
    #[arg(short, long, conflicts_with = "quiet", help_heading = None, display_order = VERBOSE_ORDER)]
    pub verbose: bool,
}
