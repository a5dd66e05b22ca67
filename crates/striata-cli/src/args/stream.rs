//! The arguments of `encode` and `decode`.

use std::path::PathBuf;

use clap::Args;
use striata_command::args::{OptionalLevel, OutputArgs, StreamArgs};

/// Arguments of `encode`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata encode [OPTIONS] <INPUT> [-o <OUT.stri>]",
    after_help = "Examples:\n  \
    striata encode bunny.ply -o bunny.stri\n  \
    striata encode scan.obj -o scan.striata --bits 16 --effort small"
)]
pub(crate) struct EncodeArgs {
    /// The mesh, or - for stdin
    pub(crate) input: PathBuf,
    /// The file to write, or - for stdout: a stream (.stri), or a .striata file with nothing else [default: the name of the
    /// input with .stri, in the same folder]
    #[arg(short, long, value_name = "OUT")]
    pub(crate) output: Option<PathBuf>,
    /// How it is coded.
    #[command(flatten)]
    pub(crate) stream: StreamArgs,
}

/// Arguments of `decode`.
#[derive(Debug, Args)]
#[command(
    override_usage = "striata decode [OPTIONS] <INPUT> -o <OUT>",
    after_help = "Examples:\n  \
    striata decode bunny.stri -o preview.ply --triangles 5000\n  \
    striata decode - -o so-far.glb < unfinished-download.stri"
)]
pub(crate) struct DecodeArgs {
    /// A stream, or a .striata file that has one, whole or cut off anywhere; or - for stdin
    pub(crate) input: PathBuf,
    /// Which level; no more of the stream is read than it needs.
    #[command(flatten)]
    pub(crate) level: OptionalLevel,
    /// Where the mesh goes.
    #[command(flatten)]
    pub(crate) output: OutputArgs,
}
