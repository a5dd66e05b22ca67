//! Arguments of `view` in builds without a window.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `view`, which opens a browser in this build.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  striata view bunny.striata\n  striata view scan.ply\n\n\
    This build has no window; add it with `--features full`.")]
pub struct BrowserArgs {
    /// Show this mesh, .striata file or stream in the web viewer until the command is stopped
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Use the browser, which this build always does
    #[arg(long)]
    browser: bool,
}
