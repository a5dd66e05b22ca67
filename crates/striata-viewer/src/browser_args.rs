//! The arguments of `view` in a build of the command without a window.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `view`, which opens a browser.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  striata view bunny.striata\n  striata view scan.ply\n\n\
    This build has no window of its own; `--features full` adds one.")]
pub struct BrowserArgs {
    /// The mesh, .striata file or stream to show in the web viewer, until the command is ended
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Show it in the browser, as this build always does
    #[arg(long)]
    browser: bool,
}
