//! Arguments of `encode` and `decode`.

use std::path::PathBuf;

use clap::Args;
use striata_command::args::{OptionalLevel, OutputArgs, StreamArgs};

/// Arguments of `encode`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata encode [OPTIONS] <INPUT> [-o <OUT.stri>]",
    after_help = "Examples:\n  \
    striata encode shape:torus -o torus.stri\n  \
    striata encode scan.obj --bits 16 --effort small"
)]
pub(crate) struct EncodeArgs {
    /// Mesh to read, - for stdin, or a built-in shape: shape:torus
    pub(crate) input: PathBuf,
    /// File to write, or - for stdout: a stream (.stri), or a .striata file that contains only the stream
    /// [default: the input with extension .stri]
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
    /// How the stream is encoded.
    #[command(flatten)]
    pub(crate) stream: StreamArgs,
}

/// Arguments of `decode`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata decode [OPTIONS] <INPUT> -o <OUT>",
    after_help = "Examples:\n  \
    striata decode torus.stri -o preview.ply --triangles 5000\n  \
    striata decode - -o partial.glb < torus.stri"
)]
pub(crate) struct DecodeArgs {
    /// Stream or .striata file with a stream, possibly cut off, or - for stdin
    pub(crate) input: PathBuf,
    /// The level to decode; no more of the stream is read than it needs.
    #[command(flatten)]
    pub(crate) level: OptionalLevel,
    /// The output file.
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}
