//! `serve`: the viewer and a folder of models over HTTP, for a browser on this machine or, if asked, on others.
//!
//! `folder` decides what is there for the outside, `files` sends it (whole, in ranges, compressed), `listing` says what there is,
//! `pictures` shows it small, `assets` is the viewer, `guard` what holds for every request and `server` for every connection.

mod args;
mod assets;
mod files;
mod folder;
mod guard;
mod heads;
mod kinds;
mod listing;
mod pictures;
mod server;
mod thumbnail;
mod validators;

use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use axum::routing::get;
use serde::Serialize;
use tokio::net::TcpListener;

pub use self::args::{ServeArgs, ThumbnailArgs};
pub use self::thumbnail::run as thumbnail;
use assets::Assets;
use folder::Folder;
use listing::Listing;
use pictures::Pictures;
use striata_command::failure::Failure;
use striata_command::output::{Output, grouped};

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

#[derive(Serialize)]
struct Report {
    url: String,
    models: usize,
}

/// All that requests are answered from.
#[derive(Debug)]
struct Site {
    folder: Arc<Folder>,
    listing: Listing,
    pictures: Pictures,
    assets: Assets,
    /// Whether only this machine is served.
    is_local: bool,
}

/// Serves until somebody ends it.
///
/// # Errors
/// Where there is no such folder, or nothing can listen there.
pub fn run(args: &ServeArgs, output: &Output) -> Result<(), Failure> {
    serve_one(&args.path, &Options::from(args), output)
}

/// Serves one file to this machine, and opens the browser.
///
/// # Errors
/// If it cannot be served.
pub fn show_in_browser(file: &Path, output: &Output) -> Result<(), Failure> {
    striata_command::input::Input::expect_there(file)?;
    if !cfg!(feature = "window") {
        output.say(
            "this build of striata has no window (`--features full` adds it): the browser shows the model",
        );
    }
    serve_one(file, &Options::for_browser(), output)
}

/// Serves a folder or a file until somebody ends it.
///
/// # Errors
/// As [`run`].
fn serve_one(path: &Path, options: &Options, output: &Output) -> Result<(), Failure> {
    let folder = Arc::new(Folder::open(path)?);
    raise_file_limit(options.max_connections);
    let mut runtime = tokio::runtime::Builder::new_multi_thread();
    let runtime = runtime.worker_threads(4).max_blocking_threads(64).enable_all().build();
    let runtime = runtime.map_err(|error| Failure::user(format!("threads to serve with: {error}")))?;
    let outcome = runtime.block_on(serve(folder, options, output));
    // A disk that does not answer shall not keep the command from ending.
    runtime.shutdown_timeout(Duration::from_secs(1));
    outcome
}

async fn serve(folder: Arc<Folder>, options: &Options, output: &Output) -> Result<(), Failure> {
    let listener = listen(options).await?;
    let address = listener.local_addr().map_err(|error| Failure::user(format!("the port: {error}")))?;
    let site = Arc::new(Site {
        listing: Listing::new(folder.clone()),
        pictures: Pictures::new()?,
        assets: Assets::load(),
        is_local: address.ip().is_loopback(),
        folder,
    });
    let models = site.listing.current().await.model_count;
    announce(&site, address, models, output)?;
    let url = url_to_open(&site.folder, address);
    if options.opens_browser && open::that_detached(&url).is_err() {
        output.say(&format!("no browser could be opened; open {url} in one"));
    }
    server::run(listener, router(site, options), options).await;
    output.say("ended");
    Ok(())
}

fn router(site: Arc<Site>, options: &Options) -> Router {
    let viewer = get(assets::answer).with_state(site.clone());
    let router = Router::new()
        .route("/models.json", get(listing::answer))
        .route("/models/{*path}", get(files::answer))
        .route("/pictures/{*path}", get(pictures::answer))
        .fallback_service(viewer)
        .with_state(site.clone());
    guard::guarded(router, site, options.allows_other_sites)
}

/// A server needs a connection and a file at a time; where it may not have so many, connections wait.
fn raise_file_limit(max_connections: usize) {
    let _ = rlimit::increase_nofile_limit(2 * max_connections as u64 + 64);
}

async fn listen(options: &Options) -> Result<TcpListener, Failure> {
    use std::io::ErrorKind;
    let (host, port) = (&options.host, options.port);
    let bare = host.trim_start_matches('[').trim_end_matches(']');
    TcpListener::bind((bare, port)).await.map_err(|error| {
        let failure = |text: &str| Failure::user(format!("{host} port {port}: {text}"));
        match error.kind() {
            ErrorKind::AddrInUse => {
                failure("something else listens there").with_hint("--port 0 takes any port that is free")
            }
            ErrorKind::PermissionDenied => failure(&error.to_string())
                .with_hint("ports below 1024 are the system's; take another with --port"),
            _ => failure(&error.to_string())
                .with_hint("--host takes an address or name of this machine, as 127.0.0.1 or localhost"),
        }
    })
}

fn announce(site: &Site, address: SocketAddr, models: usize, output: &Output) -> Result<(), Failure> {
    if !site.is_local {
        output.say(&format!(
            "warning: everybody who reaches {address} can read the models of {}",
            site.folder.path().display()
        ));
    }
    let report = Report { url: base_url(address), models };
    let what = match site.folder.only() {
        Some(name) => name.to_owned(),
        None => format!("{} models of {}", grouped(models), site.folder.path().display()),
    };
    output.data(&report, &format!("{}\n", url_to_open(&site.folder, address)))?;
    output.say(&format!("serves {what}; Ctrl-C ends it"));
    Ok(())
}

/// Where this machine finds the server; an address that stands for all of them is none to go to.
fn base_url(mut address: SocketAddr) -> String {
    match address.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => address.set_ip(Ipv4Addr::LOCALHOST.into()),
        IpAddr::V6(ip) if ip.is_unspecified() => address.set_ip(Ipv6Addr::LOCALHOST.into()),
        _ => {}
    }
    format!("http://{address}/")
}

/// The viewer, with the model where there is only one.
fn url_to_open(folder: &Folder, address: SocketAddr) -> String {
    let base = base_url(address);
    match folder.only() {
        Some(name) => format!("{base}?model=models/{}", folder::encoded(name)),
        None => base,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn urls_are_such_that_a_browser_can_open_them() {
        for (address, url) in [
            ("127.0.0.1:7878", "http://127.0.0.1:7878/"),
            ("0.0.0.0:80", "http://127.0.0.1:80/"),
            ("[::]:1", "http://[::1]:1/"),
            ("[::1]:1", "http://[::1]:1/"),
            ("192.168.1.2:1", "http://192.168.1.2:1/"),
        ] {
            assert_eq!(base_url(address.parse().expect("an address")), url);
        }
    }

    #[test]
    fn one_person_is_served_at_this_machine_only() {
        let options = Options::for_browser();
        assert_eq!((options.host.as_str(), options.port), ("127.0.0.1", 0));
        assert!(options.opens_browser && !options.allows_other_sites);
    }
}
