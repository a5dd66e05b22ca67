//! Arguments of `show`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// Arguments of `show`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata-lab show mts shape:sphere -o mts.svg\n  \
    striata-lab show tunnel bunny.ply -o tunnel.svg\n  \
    striata-lab show pattern bunny.ply -o pattern.svg --triangles 60")]
pub(crate) struct ShowArgs {
    /// Draw one of: mts (the graph of a strip over all levels), tunnel (the dual graph before and after),
    /// fan (a fan and its entry in the table), pattern (a fragment, its anchors and an overlap)
    #[arg(value_name = "WHAT", hide_possible_values = true)]
    pub what: Structure,
    /// Draw it for a small part of this mesh
    #[arg(value_name = "INPUT")]
    pub input: PathBuf,
    /// Write the picture to this SVG file
    #[arg(short, long, value_name = "FILE")]
    pub output: PathBuf,
    /// Size of the part, in triangles [default: 14 for mts, 60 otherwise]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(8..=1000))]
    pub triangles: Option<u32>,
}

/// A structure of one of the papers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Structure {
    /// The graph of a strip with all its levels \[BRR02\].
    Mts,
    /// The dual graph with a tunnel, before and after its links are complemented \[PS03\].
    Tunnel,
    /// A fan with its entry in the table \[Cor01\].
    Fan,
    /// A fragment with its anchors, and one that overlaps it \[KG98\].
    Pattern,
}

impl Structure {
    /// The structure's name on the command line.
    pub(crate) const fn as_str(self) -> &'static str {
        match self {
            Self::Mts => "mts",
            Self::Tunnel => "tunnel",
            Self::Fan => "fan",
            Self::Pattern => "pattern",
        }
    }
}
