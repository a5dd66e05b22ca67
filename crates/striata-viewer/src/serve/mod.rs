//! `serve`: serves the viewer and a folder of models over HTTP, to this machine or, if requested, to others.
//!
//! `folder` decides which files are accessible, `files` sends them (whole, in ranges, compressed),
//! `listing` lists them, `thumbnails` draws small pictures of them, `assets` is the viewer, `guard` checks
//! every request, `server` manages connections, and `session` ends the server of `view` with its page.
//!
//! Names are resolved through `cap-std`, so that symbolic links cannot leave the folder. On a loopback
//! address only loopback host names and those of allowed proxies are accepted, which prevents DNS rebinding.
//! A slow reader costs its own memory only: a piece of 64 KiB is read when the previous one has been sent. A
//! file is opened once per request, so its tag, its type and its bytes belong to the same version of it.

mod args;
mod assets;
mod connections;
mod files;
mod folder;
mod guard;
mod header_facts;
mod kinds;
mod listing;
mod options;
mod server;
mod session;
mod show_args;
mod static_site;
mod thumbnail;
mod thumbnails;
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
pub use self::guard::HostName;
pub use self::show_args::{FirstArgs, InspectedModel, PageArgs, PageColors};
pub use self::thumbnail::run as thumbnail;
use assets::Assets;
use folder::Folder;
use guard::Hosts;
use listing::Listing;
use options::Options;
use striata_command::failure::Failure;
use striata_command::output::{Output, format_count};
use thumbnails::Thumbnails;

#[derive(Serialize)]
struct ServeReport {
    url: String,
    models: usize,
}

/// Serves a folder or file until the process is stopped.
///
/// # Errors
/// If the folder does not exist, or the port cannot be opened.
pub fn run(args: &ServeArgs, output: &Output) -> Result<(), Failure> {
    serve_one(&args.path, &Options::from(args), output)
}

/// Shows a file or a folder in the browser, until the page is closed or the process is stopped.
///
/// # Errors
/// If it does not exist, or cannot be served.
pub fn show(args: &PageArgs, output: &Output) -> Result<(), Failure> {
    if !args.path.is_dir() {
        striata_command::input::Input::check_exists(&args.path)?;
    }
    let options = Options::from(args);
    if args.path.is_dir() && !options.parameters.is_empty() {
        let message =
            format!("{}: the settings are for one model, and this is a folder", args.path.display());
        return Err(Failure::usage(message).with_hint("name a file of the folder, or leave the settings out"));
    }
    serve_one(&args.path, &options, output)
}

/// Serves a folder or a file until the process is stopped, or the session ends.
///
/// # Errors
/// Fails like [`run`].
fn serve_one(path: &Path, options: &Options, output: &Output) -> Result<(), Failure> {
    let folder = Arc::new(Folder::open(path)?);
    raise_file_limit(options.max_connections);
    let mut runtime = tokio::runtime::Builder::new_multi_thread();
    let runtime = runtime.worker_threads(4).max_blocking_threads(64).enable_all().build();
    let runtime =
        runtime.map_err(|error| Failure::user(format!("cannot start the server threads: {error}")))?;
    let outcome = runtime.block_on(serve(folder, options, output));
    // A disk that does not respond must not keep the command from exiting.
    runtime.shutdown_timeout(Duration::from_secs(1));
    outcome
}

async fn serve(folder: Arc<Folder>, options: &Options, output: &Output) -> Result<(), Failure> {
    if let Some(to) = &options.writes_to {
        return static_site::write(folder, to, output).await;
    }
    let listener = listen(options).await?;
    let address =
        listener.local_addr().map_err(|error| Failure::user(format!("cannot read the port: {error}")))?;
    let is_local = address.ip().is_loopback();
    let session = options.ends_with_page.then(Arc::default);
    let listing = Arc::new(Listing::new(folder.clone(), options.ends_with_page));
    let models = listing.current().await.model_count;
    // Each handler has the part of the state that it needs.
    let thumbnails = Arc::new(Thumbnails::new(folder.clone())?);
    let router = Router::new()
        .route("/models.json", get(listing::handle).with_state(listing))
        .route("/models/{*path}", get(files::handle).with_state(folder.clone()))
        .route("/pictures/{*path}", get(thumbnails::handle).with_state(thumbnails))
        .route("/session", get(session::handle).with_state(session.clone()))
        .fallback_service(get(assets::handle).with_state(Arc::new(Assets::load())));
    let hosts = if is_local { Hosts::Loopback(options.proxies.as_slice().into()) } else { Hosts::Any };
    let router = guard::guarded(router, hosts, options.allows_other_sites);
    let url = url_to_open(&folder, address, &options.parameters);
    let way_to_stop = if options.ends_with_page {
        "close the page, or press Ctrl-C, to stop"
    } else {
        "press Ctrl-C to stop"
    };
    warn_of_others(&folder, address, output);
    output.data(&ServeReport { url: base_url(address), models }, &format!("{url}\n"))?;
    output.say(&format!("serving {}; {way_to_stop}", described(&folder, models)));
    if options.opens_browser && open::that_detached(&url).is_err() {
        output.say(&format!("cannot open a browser; open {url} yourself"));
    }
    server::run(listener, router, options, session).await;
    output.say("stopped");
    Ok(())
}

/// Raises the limit on open files: each connection may need a socket and a file. If that fails,
/// connections wait.
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
                failure("the port is already in use").with_hint("use --port 0 to pick any free port")
            }
            ErrorKind::PermissionDenied => failure(&error.to_string())
                .with_hint("ports below 1024 are reserved; choose another with --port"),
            _ => failure(&error.to_string()).with_hint(
                "--host must be an address or name of this machine, such as 127.0.0.1 or localhost",
            ),
        }
    })
}

fn warn_of_others(folder: &Folder, address: SocketAddr, output: &Output) {
    if !address.ip().is_loopback() {
        output.say(&format!(
            "warning: everyone who can reach {address} can read the models in {}",
            folder.path().display()
        ));
    }
}

fn described(folder: &Folder, models: usize) -> String {
    match folder.only() {
        Some(name) => name.to_owned(),
        None => format!("{} models in {}", format_count(models), folder.path().display()),
    }
}

/// URL of the server on this machine; an unspecified address is replaced by localhost.
fn base_url(mut address: SocketAddr) -> String {
    match address.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => address.set_ip(Ipv4Addr::LOCALHOST.into()),
        IpAddr::V6(ip) if ip.is_unspecified() => address.set_ip(Ipv6Addr::LOCALHOST.into()),
        _ => {}
    }
    format!("http://{address}/")
}

/// URL of the viewer, with the model and its settings if there is only one.
fn url_to_open(folder: &Folder, address: SocketAddr, parameters: &str) -> String {
    let base = base_url(address);
    match folder.only() {
        Some(name) => format!("{base}?model=models/{}{parameters}", folder::encoded(name)),
        None => base,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn urls_can_be_opened_in_a_browser() {
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
}
