//! Arguments of `caches`.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `caches`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata-lab caches bunny-10.glb\n  \
    striata-lab caches helmet-10.glb saw-10.glb --json")]
pub(crate) struct CachesArgs {
    /// Measure the triangle lists of these files
    #[arg(value_name = "INPUT", required = true)]
    pub inputs: Vec<PathBuf>,
}
