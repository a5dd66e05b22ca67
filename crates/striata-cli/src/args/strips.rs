//! Arguments of `strip`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use striata_command::args::{FormatArg, FormatArgs, GltfArgs, Level, STRIPS, StripSearchArgs, strips_help};
use striata_command::failure::Failure;
use striata_command::strip_chain::{StripChain, StripPlan};
use striata_strip::{RepairGoal, RepairOptions, StripOptions, Stripifier};

use super::threads::ThreadArgs;

/// Default stripifier of `strip`.
const DEFAULT_STRIPS: Stripifier = Stripifier::Cheapest;

/// Arguments of `strip`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata strip scan.ply -o scan.glb --strips greedy+cheapest --budget 10\n  \
    striata strip scan.striata --levels 100%,25%,5%,100%")]
pub(crate) struct StripArgs {
    /// Mesh or .striata file (its full mesh) to read, - for stdin, or a built-in shape: shape:torus
    pub input: PathBuf,
    /// .glb or .gltf file to write, or - for stdout [default: only report]
    #[arg(short, long, value_name = "OUT")]
    pub output: Option<PathBuf>,
    /// Let the output replace the input
    #[arg(long)]
    pub force: bool,
    /// Output format; ply requires --block-triangles, gltf excludes it [default: from the file extension; glb
    /// on stdout]
    #[arg(long, value_name = "FORMAT")]
    to: Option<StripFormatArg>,
    /// Merge equal vertices first, as `build` does; strips cross only edges whose vertices are shared
    #[arg(long)]
    pub weld: bool,
    /// Process a mesh that does not fit into memory, in blocks of at most N triangles: .ply, .stl, .obj and
    /// terrains to .ply or .glb
    #[arg(long, value_name = "N", value_parser = parse_block_triangles)]
    pub block_triangles: Option<usize>,
    /// Strips that follow the level of detail.
    #[command(flatten)]
    pub levels: StripLevelArgs,
    /// Stripifiers to run.
    #[arg(
        long,
        value_name = "SPEC",
        default_value_t = DEFAULT_STRIPS.into(),
        help = strips_help(),
        help_heading = STRIPS,
    )]
    pub strips: StripChain,
    /// Options of stripifiers that search.
    #[command(flatten)]
    pub search: StripSearchArgs,
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
}

/// Strips that are made once and repaired while the level of detail changes.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Levels")]
pub(crate) struct StripLevelArgs {
    /// Make strips for the first of these levels, then move to the others in this order and repair the strips:
    /// 100%,25%,100%; {} in the output name becomes the level
    #[arg(
        long,
        value_name = "N|P%,...",
        value_delimiter = ',',
        allow_hyphen_values = true,
        conflicts_with = "block_triangles"
    )]
    pub levels: Option<Vec<Level>>,
    /// Reach each level in N moves, after each of which only the changed ranges of the index buffer are uploaded
    #[arg(
        long,
        value_name = "N",
        default_value_t = 60,
        requires = "levels",
        value_parser = clap::value_parser!(u32).range(1..=100_000)
    )]
    pub frames: u32,
    /// Goal of repair: fewest indices or strips
    #[arg(
        long,
        value_name = "GOAL",
        default_value = "indices",
        requires = "levels",
        hide_possible_values = true
    )]
    pub repair: RepairArg,
}

/// Number that the repair of strips minimizes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum RepairArg {
    /// The number of indices
    Indices,
    /// The number of strips
    Strips,
}

impl RepairArg {
    /// Returns the name on the command line.
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Indices => "indices",
            Self::Strips => "strips",
        }
    }
}

impl StripLevelArgs {
    /// Returns the options of repair.
    pub(crate) fn repair_options(&self) -> RepairOptions {
        RepairOptions::default().with_goal(match self.repair {
            RepairArg::Indices => RepairGoal::FewestIndices,
            RepairArg::Strips => RepairGoal::FewestStrips,
        })
    }
}

/// A format that strips can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum StripFormatArg {
    /// Binary glTF
    Glb,
    /// glTF as JSON with embedded buffers
    Gltf,
    /// Stanford PLY, in blocks
    Ply,
}

impl StripArgs {
    /// Returns the format of the output.
    pub(crate) fn format(&self) -> FormatArgs {
        let is_stdout = self.output.as_deref() == Some(Path::new("-"));
        let to = match self.to {
            Some(StripFormatArg::Glb) => Some(FormatArg::Glb),
            Some(StripFormatArg::Gltf) => Some(FormatArg::Gltf),
            Some(StripFormatArg::Ply) => Some(FormatArg::Ply),
            // Other verbs write PLY to stdout, but PLY written here could not contain strips.
            None => is_stdout.then_some(FormatArg::Glb),
        };
        FormatArgs { to, ascii: false, force: self.force, gltf: GltfArgs::default() }
    }

    /// Returns the options of the only stripifier, for stripifying in blocks.
    ///
    /// # Errors
    /// If there is more than one stripifier or a time budget, neither of which works with blocks.
    pub(crate) fn only_stripifier(&self) -> Result<StripOptions, Failure> {
        if self.search.budget.is_some() {
            return Err(Failure::usage("--budget cannot be used with --block-triangles")
                .with_hint("remove --budget: each block gets a fixed number of moves"));
        }
        let stripifier = self.strips.only().ok_or_else(|| {
            Failure::usage(format!("--strips {}: --block-triangles takes a single stripifier", self.strips))
                .with_hint("name only the last stripifier of the chain")
        })?;
        Ok(self.search.options(stripifier))
    }

    /// Returns the plan for the strips.
    pub(crate) fn plan(&self) -> StripPlan {
        StripPlan { chain: self.strips.clone(), search: self.search }
    }
}

fn parse_block_triangles(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        // Smaller blocks would be mostly borders; triangles of larger ones could not be indexed.
        Ok(count) if (100..=1 << 28).contains(&count) => Ok(count),
        _ => Err(format!("must be a number from 100 to {}", 1 << 28)),
    }
}
