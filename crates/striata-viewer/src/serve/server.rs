//! Accepts connections: limits their number, drops idle and silent ones, and shuts down gracefully.

use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use axum::Router;
use hyper::server::conn::http1;
use hyper::service::{Service as _, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::{GracefulShutdown, Watcher};
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio::time::{sleep, timeout};
use tokio_io_timeout::TimeoutStream;

use super::connections::{Client, Connections};
use super::options::Options;
use super::session::Session;

/// Buffer size per connection, which also limits the size of request headers.
const BUFFER_BYTES: usize = 64 * 1024;
/// How long a client may take for the headers of a request, and stay idle between requests.
const HEADER_TIME_OUT: Duration = Duration::from_secs(10);
/// How long responses may continue after shutdown begins.
const GRACE: Duration = Duration::from_secs(3);
/// Pause between attempts to find a place for a connection.
const PLACE_RETRY_DELAY: Duration = Duration::from_millis(100);
/// Pause after a failed accept, when the system has no resources for another connection.
const ACCEPT_RETRY_DELAY: Duration = Duration::from_millis(50);

/// Serves until the process receives a termination signal, or the session ends.
pub(super) async fn run(
    listener: TcpListener,
    router: Router,
    options: &Options,
    session: Option<Arc<Session>>,
) {
    let permits = Arc::new(Semaphore::new(options.max_connections));
    // Others find a place even if one address takes all it can.
    let connections = Arc::new(Connections::new(options.max_connections.div_ceil(2)));
    let graceful = GracefulShutdown::new();
    let mut shutdown = pin!(async {
        match session {
            Some(session) => tokio::select! {
                () = session.ended.notified() => {}
                () = termination_signal() => {}
            },
            None => termination_signal().await,
        }
    });
    loop {
        let stream = tokio::select! {
            next = next_connection(&listener, &permits, &connections) => next,
            () = &mut shutdown => break,
        };
        let Some(accepted) = stream else { continue };
        let (router, watcher) = (router.clone(), graceful.watcher());
        tokio::spawn(serve_connection(accepted, router, options.time_out, watcher));
    }
    drop(listener);
    tokio::select! {
        _ = timeout(GRACE, graceful.shutdown()) => {}
        () = termination_signal() => {}
    }
}

/// An accepted connection, which is forgotten when this is dropped.
struct Accepted {
    stream: Option<TcpStream>,
    client: Arc<Client>,
    connections: Arc<Connections>,
    _permit: OwnedSemaphorePermit,
}

impl Drop for Accepted {
    fn drop(&mut self) {
        self.connections.remove(&self.client);
    }
}

/// Accepts the next connection and waits for a permit, which a silent connection gives up; further clients wait
/// in the system's queue. [`None`] if the connection is refused.
async fn next_connection(
    listener: &TcpListener,
    permits: &Arc<Semaphore>,
    connections: &Arc<Connections>,
) -> Option<Accepted> {
    let (stream, peer) = match listener.accept().await {
        Ok(accepted) => accepted,
        Err(_) => {
            sleep(ACCEPT_RETRY_DELAY).await;
            return None;
        }
    };
    let permit = loop {
        if permits.available_permits() == 0 {
            connections.make_place();
        }
        // Connections become old enough to give way while this one waits.
        if let Ok(permit) = timeout(PLACE_RETRY_DELAY, permits.clone().acquire_owned()).await {
            break permit.ok()?;
        }
    };
    let client = connections.add(peer.ip())?;
    Some(Accepted { stream: Some(stream), client, connections: Arc::clone(connections), _permit: permit })
}

/// Handles the requests of one connection until either side closes it. Errors concern only this connection.
async fn serve_connection(mut accepted: Accepted, router: Router, time_out: Duration, watcher: Watcher) {
    let Some(stream) = accepted.stream.take() else { return };
    let client = Arc::clone(&accepted.client);
    let asked = Arc::clone(&accepted.client);
    let service = TowerToHyperService::new(router);
    let service = service_fn(move |request| {
        asked.has_asked();
        service.call(request)
    });
    // If this fails, short responses are slightly delayed.
    let _ = stream.set_nodelay(true);
    let mut stream = TimeoutStream::new(stream);
    // Reading has its own limit below, since nothing needs to arrive while a response is being sent.
    stream.set_write_timeout(Some(time_out));
    let connection = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(time_out.min(HEADER_TIME_OUT))
        .max_buf_size(BUFFER_BYTES)
        .serve_connection(TokioIo::new(Box::pin(stream)), service);
    tokio::select! {
        _ = watcher.watch(connection) => {}
        () = client.end.notified() => {}
    }
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
