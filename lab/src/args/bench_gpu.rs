//! Arguments of `bench-gpu`.

use std::path::PathBuf;

use clap::Args;

use crate::bench_gpu::ways::way_names;
use crate::pace::Pace;
use striata_command::args::{BUILD_STRIPS, DriverArgs, Viewport};
use striata_command::strip_chain::{StripChain, StripPlan};

/// Help heading of the flags about drawing.
const DRAWN: &str = "Drawing";

/// Help heading of the flags about many instances.
const CROWD: &str = "Crowd";

/// Arguments of `bench-gpu`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata-lab bench-gpu bunny.ply cow.obj\n  \
    striata-lab bench-gpu bunny.ply --ways fans-compute --frames 2 --crowd 1000")]
pub(crate) struct BenchGpuArgs {
    /// Draw these meshes, .striata files (at full detail) or shapes such as shape:sphere
    #[arg(value_name = "INPUT", required = true)]
    pub inputs: Vec<PathBuf>,
    #[arg(long = "ways", value_name = "NAME,...", value_delimiter = ',', help = ways_help())]
    names: Option<Vec<String>>,
    /// Options of driver messages.
    #[command(flatten)]
    pub drivers: DriverArgs,
    /// Use this many frames from full to base mesh, and as many back
    #[arg(
        long,
        value_name = "N",
        default_value_t = 50,
        value_parser = clap::value_parser!(u32).range(1..=10_000)
    )]
    pub frames: u32,
    /// How the level falls: equally many steps in each frame, or a share of those that are left
    #[arg(long, value_name = "PACE", value_enum, default_value_t)]
    pub pace: Pace,
    /// Draw at this size in pixels; small images keep vertex costs visible on software adapters
    #[arg(long, value_name = "WxH", default_value = "128x128", help_heading = DRAWN)]
    pub size: Viewport,
    /// Build models from the strips of these stripifiers, as in `strip`
    #[arg(long, value_name = "SPEC", default_value_t = BUILD_STRIPS.into(), help_heading = DRAWN)]
    strips: StripChain,
    /// Also refine this many instances of a mesh on the GPU, at 1 pixel in 1920x1080
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u32).range(1..=65_535),
        help_heading = CROWD
    )]
    pub crowd: Option<u32>,
    /// Show at most this many triangles of all instances together
    #[arg(
        long,
        value_name = "N",
        default_value_t = 10_000_000,
        value_parser = clap::value_parser!(u32).range(1..=100_000_000),
        help_heading = CROWD
    )]
    pub crowd_triangles: u32,
    /// Use the graphics adapter whose name contains this [default: the fastest]
    #[arg(long, value_name = "NAME", help_heading = "Adapter")]
    pub adapter: Option<String>,
    /// Draw on the CPU
    #[arg(long, conflicts_with = "adapter", help_heading = "Adapter")]
    pub software: bool,
}

impl BenchGpuArgs {
    /// The requested ways, or all if none is given.
    pub(crate) fn way_names(&self) -> Vec<&str> {
        match &self.names {
            Some(names) => names.iter().map(|name| name.trim()).collect(),
            None => way_names().collect(),
        }
    }

    /// The stripifiers whose strips models are built from.
    pub(crate) fn strip_plan(&self) -> StripPlan {
        StripPlan { chain: self.strips.clone(), search: Default::default() }
    }
}

fn ways_help() -> String {
    format!(
        "Time these ways of drawing a level [default: all]: {}",
        way_names().collect::<Vec<_>>().join(", ")
    )
}
