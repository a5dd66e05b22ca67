//! Where a mesh is written, and in which format.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

/// Where a mesh goes, and how it is written.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Output")]
pub struct OutputArgs {
    /// The mesh to write, or - for stdout
    #[arg(short, long, value_name = "OUT")]
    pub output: PathBuf,
    /// How it is written.
    #[command(flatten)]
    pub format: FormatArgs,
}

/// How a mesh is written.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Output")]
pub struct FormatArgs {
    /// Format of the output [default: by its extension; ply on stdout]
    #[arg(long, value_name = "FORMAT")]
    pub to: Option<FormatArg>,
    /// Write PLY as text
    #[arg(long)]
    pub ascii: bool,
}

/// Formats that meshes are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FormatArg {
    /// Stanford PLY
    Ply,
    /// Wavefront OBJ
    Obj,
    /// STL, binary
    Stl,
    /// Object file format
    Off,
    /// glTF as JSON, all embedded
    Gltf,
    /// glTF as one binary file
    Glb,
}
