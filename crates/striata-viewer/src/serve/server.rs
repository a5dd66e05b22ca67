//! Accepts connections: limits their number, drops idle ones, and shuts down gracefully.

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

/// Buffer size per connection, which also limits the size of request headers.
const BUFFER_BYTES: usize = 64 * 1024;
/// How long responses may continue after shutdown begins.
const GRACE: Duration = Duration::from_secs(3);
/// Pause after a failed accept, when the system has no resources for another connection.
const ACCEPT_RETRY_DELAY: Duration = Duration::from_millis(50);

/// Serves until the process receives a termination signal.
pub(super) async fn run(listener: TcpListener, router: Router, options: &Options) {
    let permits = Arc::new(Semaphore::new(options.max_connections));
    let graceful = GracefulShutdown::new();
    let mut shutdown = pin!(termination_signal());
    loop {
        let stream = tokio::select! {
            next = next_connection(&listener, &permits) => next,
            () = &mut shutdown => break,
        };
        let Some((stream, permit)) = stream else { continue };
        tokio::spawn(serve_connection(stream, router.clone(), options.time_out, graceful.watcher(), permit));
    }
    drop(listener);
    tokio::select! {
        _ = timeout(GRACE, graceful.shutdown()) => {}
        () = termination_signal() => {}
    }
}

/// Waits for a permit and accepts the next connection; further clients wait in the system's queue.
async fn next_connection(
    listener: &TcpListener,
    permits: &Arc<Semaphore>,
) -> Option<(TcpStream, OwnedSemaphorePermit)> {
    let permit = permits.clone().acquire_owned().await.ok()?;
    match listener.accept().await {
        Ok((stream, _)) => Some((stream, permit)),
        Err(_) => {
            sleep(ACCEPT_RETRY_DELAY).await;
            None
        }
    }
}

/// Handles the requests of one connection until either side closes it. Errors concern only this connection.
async fn serve_connection(
    stream: TcpStream,
    router: Router,
    time_out: Duration,
    watcher: Watcher,
    _permit: OwnedSemaphorePermit,
) {
    // If this fails, short responses are slightly delayed.
    let _ = stream.set_nodelay(true);
    let mut stream = TimeoutStream::new(stream);
    // Reading has its own limit below, since nothing needs to arrive while a response is being sent.
    stream.set_write_timeout(Some(time_out));
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(time_out)
        .max_buf_size(BUFFER_BYTES)
        .serve_connection(TokioIo::new(Box::pin(stream)), TowerToHyperService::new(router));
    let _ = watcher.watch(connection).await;
}

/// Completes on Ctrl-C or a termination signal.
async fn termination_signal() {
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
