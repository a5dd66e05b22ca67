//! The arguments of verbs that make strips.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use striata_strip::{StripOptions, Stripifier};

use super::{FormatArg, FormatArgs};
use crate::failure::Failure;
use crate::strip_chain::{StripChain, StripPlan};

/// The strips that `strip` makes where nothing else is said.
const STRIP_STRIPS: Stripifier = Stripifier::Cheapest;

/// The strips that `build` makes where nothing else is said.
pub(super) const BUILD_STRIPS: Stripifier = Stripifier::Cheapest;

/// Entries of the vertex cache that misses are counted for where nothing else is said.
const USUAL_CACHE_SIZE: u32 = 16;

/// Heading of the flags about strips.
pub(super) const STRIPS: &str = "Strips";

pub(super) fn strips_help() -> String {
    format!(
        "Stripifiers, joined by +, each beginning with the strips of the one before: {}",
        Stripifier::SPELLINGS
    )
}

/// Arguments of `strip`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata strip bunny.ply\n  \
    striata strip bunny.ply -o bunny.glb --strips cheapest --budget 10 --json")]
pub(crate) struct StripArgs {
    /// A mesh, a .striata file (its full level), or - for stdin
    pub(crate) input: PathBuf,
    /// The .glb or .gltf to write with these strips, or - for stdout [default: only report]
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
    /// Format of the output; ply takes --block-triangles, gltf does not [default: by its extension; glb on stdout]
    #[arg(long, value_name = "FORMAT")]
    to: Option<StripFormatArg>,
    /// Merge equal vertices first, as `build` does: strips cross only edges whose vertices are shared
    #[arg(long)]
    pub(crate) weld: bool,
    /// Work in blocks of at most so many triangles, without the mesh in memory; binary PLY to .ply or .glb
    #[arg(long, value_name = "N", value_parser = parse_block_triangles)]
    pub(crate) block_triangles: Option<usize>,
    /// How strips are made.
    #[arg(long, value_name = "SPEC", default_value_t = STRIP_STRIPS.into(), help = strips_help(), help_heading = STRIPS)]
    pub(crate) strips: StripChain,
    /// How long, and with which chances.
    #[command(flatten)]
    pub(crate) search: StripSearchArgs,
}

/// Formats that strips are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum StripFormatArg {
    /// glTF as one binary file
    Glb,
    /// glTF as JSON, all embedded
    Gltf,
    /// Stanford PLY, in blocks
    Ply,
}

/// How those stripifiers that search do it.
#[derive(Clone, Copy, Debug, Args)]
#[command(next_help_heading = STRIPS)]
pub(crate) struct StripSearchArgs {
    /// Seconds for each stripifier that searches; results then differ between runs [default: a fixed number of moves]
    #[arg(long, value_name = "SECS", allow_negative_numbers = true, value_parser = parse_at_least_zero)]
    pub(crate) budget: Option<f64>,
    /// Seed of what is chosen at random; equal seeds give equal strips
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub(crate) seed: u64,
    /// How many indices one miss of the vertex cache is worth, to the last stripifier
    #[arg(long, value_name = "W", default_value_t = 0.0, allow_negative_numbers = true, value_parser = parse_at_least_zero)]
    pub(crate) cache_weight: f64,
    /// Entries of that first-in first-out cache, and of the caches that misses are reported for
    #[arg(long, value_name = "N", default_value_t = USUAL_CACHE_SIZE, allow_negative_numbers = true, value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub(crate) cache_size: u32,
}

impl StripArgs {
    /// How the output is written.
    pub(crate) fn format(&self) -> FormatArgs {
        let is_stdout = self.output.as_deref() == Some(Path::new("-"));
        let to = match self.to {
            Some(StripFormatArg::Glb) => Some(FormatArg::Glb),
            Some(StripFormatArg::Gltf) => Some(FormatArg::Gltf),
            Some(StripFormatArg::Ply) => Some(FormatArg::Ply),
            // What holds strips, and not what is usual for meshes.
            None => is_stdout.then_some(FormatArg::Glb),
        };
        FormatArgs { to, ascii: false }
    }

    /// The stripifier asked for and how it searches, where it is one and not told how long.
    ///
    /// # Errors
    /// Where blocks cannot have what was asked for.
    pub(crate) fn only_stripifier(&self) -> Result<StripOptions, Failure> {
        if self.search.budget.is_some() {
            return Err(Failure::user("--budget is for a mesh as a whole, not for blocks")
                .with_hint("leave --budget out: each block gets the usual number of moves"));
        }
        let stripifier = self.strips.only().ok_or_else(|| {
            Failure::user(format!("{}: blocks take one stripifier", self.strips))
                .with_hint("name the last one of the chain alone")
        })?;
        Ok(self.search.options(stripifier))
    }

    /// The strips asked for.
    pub(crate) fn plan(&self) -> StripPlan {
        StripPlan { chain: self.strips.clone(), search: self.search }
    }
}

impl Default for StripSearchArgs {
    fn default() -> Self {
        let StripOptions { seed, cache_weight, .. } = StripOptions::default();
        Self { budget: None, seed, cache_weight, cache_size: USUAL_CACHE_SIZE }
    }
}

fn parse_block_triangles(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        // Smaller blocks are nothing but borders, larger ones cannot be numbered.
        Ok(count) if (100..=1 << 28).contains(&count) => Ok(count),
        _ => Err(format!("must be a number from 100 to {}", 1 << 28)),
    }
}

pub(super) fn parse_at_least_zero(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() && number >= 0.0 => Ok(number),
        _ => Err("must be a number, 0 or more".to_owned()),
    }
}
