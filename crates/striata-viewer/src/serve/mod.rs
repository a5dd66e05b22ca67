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
mod options;
mod pictures;
mod server;
mod site;
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
use options::Options;
use pictures::Pictures;
use site::Site;
use striata_command::failure::Failure;
use striata_command::output::{Output, format_count};

#[derive(Serialize)]
struct Report {
    url: String,
    models: usize,
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
    striata_command::input::Input::check_exists(file)?;
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
    let is_local = address.ip().is_loopback();
    let site = Site {
        listing: Arc::new(Listing::new(folder.clone())),
        pictures: Arc::new(Pictures::new()?),
        assets: Arc::new(Assets::load()),
        folder,
    };
    let models = site.listing.current().await.model_count;
    announce(&site.folder, address, models, output)?;
    let url = url_to_open(&site.folder, address);
    if options.opens_browser && open::that_detached(&url).is_err() {
        output.say(&format!("no browser could be opened; open {url} in one"));
    }
    server::run(listener, router(site, is_local, options), options).await;
    output.say("ended");
    Ok(())
}

fn router(site: Site, is_local: bool, options: &Options) -> Router {
    let viewer = get(assets::answer).with_state(site.clone());
    let router = Router::new()
        .route("/models.json", get(listing::answer))
        .route("/models/{*path}", get(files::answer))
        .route("/pictures/{*path}", get(pictures::answer))
        .fallback_service(viewer)
        .with_state(site);
    guard::guarded(router, is_local, options.allows_other_sites)
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

fn announce(folder: &Folder, address: SocketAddr, models: usize, output: &Output) -> Result<(), Failure> {
    if !address.ip().is_loopback() {
        output.say(&format!(
            "warning: everybody who reaches {address} can read the models of {}",
            folder.path().display()
        ));
    }
    let report = Report { url: base_url(address), models };
    let what = match folder.only() {
        Some(name) => name.to_owned(),
        None => format!("{} models of {}", format_count(models), folder.path().display()),
    };
    output.data(&report, &format!("{}\n", url_to_open(folder, address)))?;
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
