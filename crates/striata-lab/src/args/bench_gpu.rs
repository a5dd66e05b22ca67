//! The arguments of `bench-gpu`.

use std::path::PathBuf;

use clap::Args;

use crate::bench_gpu::ways::way_names;
use striata_command::args::{BUILD_STRIPS, DriverArgs, Viewport};
use striata_command::strip_chain::{StripChain, StripPlan};

/// The heading of what is drawn.
const DRAWN: &str = "Drawing";

/// Arguments of `bench-gpu`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata-lab bench-gpu bunny.ply cow.obj\n  \
    striata-lab bench-gpu bunny.ply --ways fans,fans-compute --json")]
pub(crate) struct BenchGpuArgs {
    /// Meshes, .striata files (their full level), or shapes such as shape:sphere
    #[arg(value_name = "INPUT", required = true)]
    pub(crate) inputs: Vec<PathBuf>,
    #[arg(long = "ways", value_name = "NAMES", value_delimiter = ',', help = ways_help())]
    names: Option<Vec<String>>,
    /// How graphics drivers report.
    #[command(flatten)]
    pub(crate) drivers: DriverArgs,
    /// Frames from the full mesh to the base mesh, and again on the way back
    #[arg(long, value_name = "N", default_value_t = 50, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) frames: u32,
    /// Pixels of the picture that is drawn; small, so that vertices count also where the processor draws
    #[arg(long, value_name = "WxH", default_value = "128x128", help_heading = DRAWN)]
    pub(crate) size: Viewport,
    /// The stripifiers whose strips models are built from, as in `strip`
    #[arg(long, value_name = "SPEC", default_value_t = BUILD_STRIPS.into(), help_heading = DRAWN)]
    strips: StripChain,
    /// The graphics adapter whose name holds this [default: the quickest]
    #[arg(long, value_name = "NAME", help_heading = "Adapter")]
    pub(crate) adapter: Option<String>,
    /// Draw on the processor
    #[arg(long, conflicts_with = "adapter", help_heading = "Adapter")]
    pub(crate) software: bool,
}

impl BenchGpuArgs {
    /// The ways asked for; all where none is named.
    pub(crate) fn way_names(&self) -> Vec<&str> {
        match &self.names {
            Some(names) => names.iter().map(|name| name.trim()).collect(),
            None => way_names().collect(),
        }
    }

    /// The strips that models are built from.
    pub(crate) fn strip_plan(&self) -> StripPlan {
        StripPlan { chain: self.strips.clone(), search: Default::default() }
    }
}

fn ways_help() -> String {
    format!(
        "Ways to draw a level, separated by commas [default: all]: {}",
        way_names().collect::<Vec<_>>().join(", ")
    )
}
