//! The arguments of verbs that serve models, and of the pictures that go with them.

use std::path::PathBuf;

use clap::Args;

/// Arguments of `serve`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  striata serve models\n  striata serve bunny.striata --port 0 --open")]
pub struct ServeArgs {
    /// The folder to serve, with those inside it, or one file
    #[arg(value_name = "DIR", default_value = ".")]
    pub path: PathBuf,
    /// The port to listen at; 0 takes any that is free
    #[arg(long, value_name = "N", default_value_t = 7878)]
    pub port: u16,
    /// The address or name to listen at; others than this machine get in where it is not a loopback address
    #[arg(long, value_name = "HOST", default_value = "127.0.0.1")]
    pub host: String,
    /// Connections at a time; more wait until one ends
    #[arg(long, value_name = "N", default_value_t = 512, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub max_connections: u32,
    /// Drop a connection that asks for nothing, or takes nothing of its answer, for so many seconds
    #[arg(long, value_name = "SECS", default_value_t = 60, value_parser = clap::value_parser!(u64).range(1..=86_400))]
    pub time_out: u64,
    /// Let pages of other sites read the models
    #[arg(long)]
    pub cors: bool,
    /// Open the default browser
    #[arg(long)]
    pub open: bool,
}

/// Arguments of `thumbnail`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata thumbnail bunny.stri > bunny.png\n  \
    striata thumbnail scan.ply.gz | display")]
pub struct ThumbnailArgs {
    /// A mesh, a .striata file or a stream; the picture goes to stdout as PNG
    pub input: PathBuf,
}
