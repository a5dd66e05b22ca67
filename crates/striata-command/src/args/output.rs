//! Flags for the file that a mesh is written to, and for its format.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::GltfArgs;

/// The output file of a verb that writes meshes, and its format.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Output")]
pub struct OutputArgs {
    /// File to write, or - for stdout
    #[arg(value_name = "OUT", required_unless_present = "output_flag", help_heading = None)]
    positional_output: Option<PathBuf>,
    /// File to write, as an alternative to OUT
    #[arg(
        id = "output_flag",
        short,
        long = "output",
        value_name = "OUT",
        conflicts_with = "positional_output"
    )]
    output_flag: Option<PathBuf>,
    /// The format of the file.
    #[command(flatten)]
    pub format: FormatArgs,
}

impl OutputArgs {
    /// Returns the file to write.
    pub fn path(&self) -> &Path {
        // The parser requires one of them.
        self.output_flag.as_deref().or(self.positional_output.as_deref()).unwrap_or(Path::new("-"))
    }
}

/// The format that a mesh is written in.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "Output")]
pub struct FormatArgs {
    /// Output format [default: from the file extension; ply on stdout]
    #[arg(long, value_name = "FORMAT")]
    pub to: Option<FormatArg>,
    /// Write PLY as text
    #[arg(long)]
    pub ascii: bool,
    /// Let the output replace the input
    #[arg(long)]
    pub force: bool,
    /// How glTF is quantized and compressed.
    #[command(flatten)]
    pub gltf: GltfArgs,
}

/// A format that meshes can be written in.
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
    /// glTF as JSON with embedded buffers
    Gltf,
    /// Binary glTF
    Glb,
}
