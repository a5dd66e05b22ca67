//! The arguments of the lab's command: one type per verb.

#[cfg(feature = "gpu")]
mod bench_gpu;
mod compare;

use clap::{Parser, Subcommand};
use striata_command::args::ReportArgs;

#[cfg(feature = "gpu")]
pub(crate) use self::bench_gpu::BenchGpuArgs;
pub(crate) use self::compare::{
    AssetArgs, AssetContender, CompareArgs, ModelArgs, Part, RateArgs, StripifierArgs,
};

/// Everything on the command line.
#[derive(Debug, Parser)]
#[command(
    name = "striata-lab",
    version,
    about = "Measures striata's models, stripifiers and streams, and what others make of the same meshes",
    subcommand_value_name = "VERB",
    subcommand_help_heading = "Verbs",
    disable_help_subcommand = true,
    disable_help_flag = true,
    max_term_width = 100
)]
pub(crate) struct Cli {
    /// What to measure.
    #[command(subcommand)]
    pub(crate) verb: Verb,
    /// How to report.
    #[command(flatten)]
    pub(crate) report: ReportArgs,
}

/// The verbs.
#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Compare models and stripifiers on the same meshes
    Compare(Box<CompareArgs>),
    /// Time the ways to draw a level while it changes
    #[cfg(feature = "gpu")]
    BenchGpu(BenchGpuArgs),
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn the_tree_of_arguments_is_consistent() {
        Cli::command().debug_assert();
    }
}
