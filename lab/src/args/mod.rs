//! Command-line arguments of `striata-lab`: one type per verb.

#[cfg(feature = "gpu")]
mod bench_gpu;
mod caches;
mod compare;
mod poses;
mod show;

use clap::{Parser, Subcommand};
use striata_command::args::ReportArgs;

#[cfg(feature = "gpu")]
pub(crate) use self::bench_gpu::BenchGpuArgs;
pub(crate) use self::caches::CachesArgs;
pub(crate) use self::compare::{AssetArgs, AssetContender, CompareArgs, ComparisonPart, ModelArgs, RateArgs};
pub(crate) use self::poses::PosesArgs;
pub(crate) use self::show::{ShowArgs, Structure};

/// The whole command line.
#[derive(Debug, Parser)]
#[command(
    name = "striata-lab",
    version,
    about = "Measure striata's models, stripifiers and streams, and those of others on the same meshes",
    subcommand_value_name = "VERB",
    subcommand_help_heading = "Verbs",
    disable_help_subcommand = true,
    disable_help_flag = true,
    max_term_width = 100
)]
pub(crate) struct LabCli {
    /// The verb to run.
    #[command(subcommand)]
    pub verb: LabVerb,
    /// Options of the report.
    #[command(flatten)]
    pub report: ReportArgs,
}

/// The verbs.
#[derive(Debug, Subcommand)]
pub(crate) enum LabVerb {
    /// Compare models, stripifiers and streams on the same meshes
    Compare(Box<CompareArgs>),
    /// Measure levels of skinned and morphing meshes in the poses of their animations
    Poses(PosesArgs),
    /// Count vertex cache misses of the triangle lists of files
    Caches(CachesArgs),
    /// Draw a structure of one of the papers for a small part of a mesh
    Show(ShowArgs),
    /// Time different ways of drawing a changing level on the GPU
    #[cfg(feature = "gpu")]
    BenchGpu(BenchGpuArgs),
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn command_line_definition_is_consistent() {
        LabCli::command().debug_assert();
    }
}
