//! The arguments of `strip`.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use striata_command::args::{FormatArg, FormatArgs, STRIPS, StripSearchArgs, strips_help};
use striata_command::failure::Failure;
use striata_command::strip_chain::{StripChain, StripPlan};
use striata_strip::{StripOptions, Stripifier};

/// The strips that `strip` makes where nothing else is said.
const STRIP_STRIPS: Stripifier = Stripifier::Cheapest;

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

fn parse_block_triangles(text: &str) -> Result<usize, String> {
    match text.parse::<usize>() {
        // Smaller blocks are nothing but borders, larger ones cannot be numbered.
        Ok(count) if (100..=1 << 28).contains(&count) => Ok(count),
        _ => Err(format!("must be a number from 100 to {}", 1 << 28)),
    }
}
