//! Arguments of the commands that serve models and draw thumbnails.

use std::path::PathBuf;

use clap::Args;

use super::guard::HostName;

/// Arguments of `serve`.
#[derive(Debug, Args)]
#[command(
    after_help = "Examples:\n  striata serve bunny.striata --port 0 --open\n  striata serve models --write-to site"
)]
pub struct ServeArgs {
    /// Serve this folder, including subfolders, or a single file
    #[arg(value_name = "DIR", default_value = ".")]
    pub path: PathBuf,
    /// Listen on this port; 0 picks any free port
    #[arg(long, value_name = "N", default_value_t = 7878)]
    pub port: u16,
    /// Listen on this address or name; other machines can connect unless it is a loopback address
    #[arg(long, value_name = "HOST", default_value = "127.0.0.1")]
    pub host: String,
    /// Also answer requests for this host name, as a proxy in front of a loopback address sends them;
    /// can be repeated
    #[arg(long, value_name = "HOST")]
    pub allow_host: Vec<HostName>,
    /// Limit the number of simultaneous connections; others wait
    #[arg(
        long, value_name = "N", default_value_t = 512,
        value_parser = clap::value_parser!(u32).range(1..=100_000)
    )]
    pub max_connections: u32,
    /// Close a connection after this many seconds without progress on a response; without a request, after 10
    /// seconds at most
    #[arg(
        long, value_name = "SECS", default_value_t = 60,
        value_parser = clap::value_parser!(u64).range(1..=86_400)
    )]
    pub time_out: u64,
    /// Allow pages of other sites to read the models (CORS)
    #[arg(long)]
    pub cors: bool,
    /// Open the default browser
    #[arg(long)]
    pub open: bool,
    /// Write the page, its gallery and the models to this new folder, for any web server, and serve nothing
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["port", "host", "allow_host", "cors", "open"])]
    pub write_to: Option<PathBuf>,
}

/// Arguments of `thumbnail`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:\n  \
    striata thumbnail bunny.stri > bunny.png\n  \
    striata thumbnail scan.ply.gz | display")]
pub struct ThumbnailArgs {
    /// Mesh, .striata file or stream; the PNG is written to stdout
    pub input: PathBuf,
}
