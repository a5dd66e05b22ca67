//! Arguments of `encode` and `decode`.

use std::path::{Path, PathBuf};

use clap::Args;
use striata_command::args::{
    EditArgs, FlatArgs, OptionalLevel, OutputArgs, RasterArgs, SequenceArgs, StreamArgs, TextureArgs,
};

use super::threads::ThreadArgs;

/// Arguments of `encode`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata encode [OPTIONS] <INPUT> [OUT]",
    after_help = "Examples:\n  \
    striata encode shape:torus -o torus.stri\n  \
    striata encode robot.glb -o robot-stream.glb --texture-max 1024"
)]
pub(crate) struct EncodeArgs {
    /// Mesh or scene to read, - for stdin, or a built-in shape: shape:torus
    pub input: PathBuf,
    /// File to write, or - for stdout: a stream (.stri), a GLB file that other programs show at a coarse
    /// level (.glb), or a .striata file that contains only the stream [default: the input with extension
    /// .stri]
    #[arg(value_name = "OUT")]
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
    /// Let the output replace the input
    #[arg(long)]
    pub force: bool,
    /// How the stream is encoded.
    #[command(flatten)]
    pub stream: StreamArgs,
    /// How the mesh is simplified.
    #[command(flatten)]
    pub sequence: SequenceArgs,
    /// Longest side of the previews of color textures in the stream of a scene; 0 for none
    #[arg(
        long,
        value_name = "PIXELS",
        allow_negative_numbers = true,
        default_value_t = 128,
        value_parser = clap::value_parser!(u32).range(0..=4096),
        help_heading = "Textures",
    )]
    pub preview: u32,
    /// Whether a scene becomes one mesh.
    #[command(flatten)]
    pub scene: FlatArgs,
    /// Parts of a scene that are left out.
    #[command(flatten)]
    pub edits: EditArgs,
    /// How textures are re-encoded.
    #[command(flatten)]
    pub textures: TextureArgs,
    /// How a raster is read.
    #[command(flatten)]
    pub raster: RasterArgs,
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
}

impl EncodeArgs {
    /// Returns the file to write, if it was named.
    pub(crate) fn output(&self) -> Option<&Path> {
        self.output_flag.as_deref().or(self.positional_output.as_deref())
    }
}

/// Arguments of `decode`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata decode [OPTIONS] <INPUT> <OUT>",
    after_help = "Examples:\n  \
    striata decode torus.stri -o preview.ply --triangles 5000\n  \
    striata decode - -o partial.glb < torus.stri"
)]
pub(crate) struct DecodeArgs {
    /// Stream or .striata file with a stream, possibly cut off, or - for stdin
    pub input: PathBuf,
    /// The level to decode; no more of the stream is read than it needs.
    #[command(flatten)]
    pub level: OptionalLevel,
    /// The output file.
    #[command(flatten)]
    pub output: OutputArgs,
    /// Number of threads.
    #[command(flatten)]
    pub threads: ThreadArgs,
}
