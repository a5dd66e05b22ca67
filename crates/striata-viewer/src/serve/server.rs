//! Connections: so many at a time, none that does nothing for long, and an end that lets answers finish.

use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::{GracefulShutdown, Watcher};
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{sleep, timeout};
use tokio_io_timeout::TimeoutStream;

use super::options::Options;

/// Bytes of a connection that wait in memory, a request's head among them.
const BUFFER_BYTES: usize = 64 * 1024;
/// How long answers may go on once the server is to end.
const GRACE: Duration = Duration::from_secs(3);
/// How long the server waits where the system has no connection left to give.
const PAUSE: Duration = Duration::from_millis(50);

/// Serves until the process is asked to end.
pub(super) async fn run(listener: TcpListener, router: Router, options: &Options) {
    let places = Arc::new(Semaphore::new(options.max_connections));
    let graceful = GracefulShutdown::new();
    let mut end = pin!(asked_to_end());
    loop {
        let stream = tokio::select! {
            next = next_connection(&listener, &places) => next,
            () = &mut end => break,
        };
        let Some((stream, place)) = stream else { continue };
        tokio::spawn(answer(stream, router.clone(), options.time_out, graceful.watcher(), place));
    }
    drop(listener);
    tokio::select! {
        _ = timeout(GRACE, graceful.shutdown()) => {}
        () = asked_to_end() => {}
    }
}

/// Further clients wait in the system's queue until there is a place.
async fn next_connection(
    listener: &TcpListener,
    places: &Arc<Semaphore>,
) -> Option<(TcpStream, OwnedSemaphorePermit)> {
    let place = places.clone().acquire_owned().await.ok()?;
    match listener.accept().await {
        Ok((stream, _)) => Some((stream, place)),
        Err(_) => {
            sleep(PAUSE).await;
            None
        }
    }
}

/// Answers one connection's requests until either side ends it, which is nobody else's concern.
async fn answer(
    stream: TcpStream,
    router: Router,
    time_out: Duration,
    watcher: Watcher,
    _place: OwnedSemaphorePermit,
) {
    // Without it only short answers are a little later.
    let _ = stream.set_nodelay(true);
    let mut stream = TimeoutStream::new(stream);
    // Reading has a limit of its own, below: while an answer goes out nothing has to come in.
    stream.set_write_timeout(Some(time_out));
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(time_out)
        .max_buf_size(BUFFER_BYTES)
        .serve_connection(TokioIo::new(Box::pin(stream)), TowerToHyperService::new(router));
    let _ = watcher.watch(connection).await;
}

/// Ends when somebody presses Ctrl-C, or the system asks the process to end.
async fn asked_to_end() {
    let interrupted = tokio::signal::ctrl_c();
    #[cfg(unix)]
    {
        use tokio::signal::unix::{SignalKind, signal};
        if let Ok(mut terminated) = signal(SignalKind::terminate()) {
            tokio::select! {
                _ = interrupted => {}
                _ = terminated.recv() => {}
            }
            return;
        }
    }
    let _ = interrupted.await;
}
