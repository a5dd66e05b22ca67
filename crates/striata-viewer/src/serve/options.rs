//! How models are served.

use std::time::Duration;

use super::args::ServeArgs;

/// How models are served.
#[derive(Clone, Debug)]
pub(crate) struct Options {
    /// Address or name to listen at.
    pub(crate) host: String,
    /// Port to listen at; 0 takes any that is free.
    pub(crate) port: u16,
    /// Connections at a time.
    pub(crate) max_connections: usize,
    /// How long a connection may do nothing.
    pub(crate) time_out: Duration,
    /// Whether pages of other sites may read the models.
    pub(crate) allows_other_sites: bool,
    /// Whether the default browser is opened.
    pub(crate) opens_browser: bool,
}

impl Options {
    /// For one person at this machine: any free port, and the browser opened.
    pub(crate) fn for_browser() -> Self {
        Self {
            host: "127.0.0.1".to_owned(),
            port: 0,
            max_connections: 64,
            time_out: Duration::from_secs(60),
            allows_other_sites: false,
            opens_browser: true,
        }
    }
}

impl From<&ServeArgs> for Options {
    fn from(args: &ServeArgs) -> Self {
        Self {
            host: args.host.clone(),
            port: args.port,
            max_connections: args.max_connections as usize,
            time_out: Duration::from_secs(args.time_out),
            allows_other_sites: args.cors,
            opens_browser: args.open,
        }
    }
}
