//! Arguments of `poses`.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `poses`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata-lab poses fox.glb\n  \
    striata-lab poses fox.glb --shares 25 --times 100 --json")]
pub(crate) struct PosesArgs {
    /// Measure the skinned or morphing meshes of these glTF scenes
    #[arg(value_name = "SCENE", required = true)]
    pub inputs: Vec<PathBuf>,
    /// Measure levels with these shares of each mesh's triangles, in percent
    #[arg(long, value_name = "PERCENT,...", value_delimiter = ',', default_value = "50,25,10")]
    pub shares: Vec<f64>,
    /// Measure at this many scattered times of each animation
    #[arg(
        long,
        value_name = "N",
        default_value_t = 25,
        value_parser = clap::value_parser!(u32).range(1..=10_000)
    )]
    pub times: u32,
}
