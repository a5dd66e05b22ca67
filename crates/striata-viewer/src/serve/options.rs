//! Options of the server.

use std::path::PathBuf;
use std::time::Duration;

use super::args::ServeArgs;
use super::guard::HostName;
use super::show_args::PageArgs;

/// Options of the server.
#[derive(Clone, Debug)]
pub(crate) struct Options {
    /// Address or host name to listen on.
    pub host: String,
    /// Port to listen on; 0 picks any free port.
    pub port: u16,
    /// Names of proxies that a server on a loopback address also answers for.
    pub proxies: Vec<HostName>,
    /// Maximum number of simultaneous connections.
    pub max_connections: usize,
    /// How long a connection may be idle.
    pub time_out: Duration,
    /// Whether pages of other sites may read the models.
    pub allows_other_sites: bool,
    /// Whether the default browser is opened.
    pub opens_browser: bool,
    /// Whether the server stops when its page is closed.
    pub ends_with_page: bool,
    /// Parameters of the address that is opened, behind the model.
    pub parameters: String,
    /// Folder to which everything is written, instead of being served.
    pub writes_to: Option<PathBuf>,
}

impl From<&PageArgs> for Options {
    /// Options for a single user on this machine: any free port.
    fn from(args: &PageArgs) -> Self {
        Self {
            host: "127.0.0.1".to_owned(),
            port: 0,
            proxies: Vec::new(),
            max_connections: 64,
            time_out: Duration::from_secs(60),
            allows_other_sites: false,
            opens_browser: !args.no_open,
            ends_with_page: true,
            parameters: args.first.parameters(),
            writes_to: None,
        }
    }
}

impl From<&ServeArgs> for Options {
    fn from(args: &ServeArgs) -> Self {
        Self {
            host: args.host.clone(),
            port: args.port,
            proxies: args.allow_host.clone(),
            max_connections: args.max_connections as usize,
            time_out: Duration::from_secs(args.time_out),
            allows_other_sites: args.cors,
            opens_browser: args.open,
            ends_with_page: false,
            parameters: String::new(),
            writes_to: args.write_to.clone(),
        }
    }
}
