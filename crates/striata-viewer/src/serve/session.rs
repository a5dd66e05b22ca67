//! Ends the server of `view` when its page is closed.
//!
//! A page asks for `session` and keeps the response open as long as it lives. When the last one has gone for a
//! while, so that loading the page again does not count, the server stops.

use std::io;
use std::pin::Pin;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::task::{Context, Poll, ready};
use std::time::Duration;

use axum::body::Body;
use axum::extract::State;
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE};
use axum::http::{HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use tokio::io::{AsyncRead, ReadBuf};
use tokio::sync::Notify;
use tokio::time::{Interval, MissedTickBehavior, interval, sleep};
use tokio_util::io::ReaderStream;

/// How long the server waits for a page that loads again.
const GRACE: Duration = Duration::from_secs(3);

/// Time between two bytes of an open response, which show when its page has gone without a word.
const BEAT: Duration = Duration::from_secs(20);

/// The open pages.
#[derive(Debug, Default)]
pub(super) struct Session {
    open: AtomicUsize,
    /// Number of pages so far.
    total: AtomicUsize,
    /// Notified when no page has been open for a while.
    pub ended: Notify,
}

/// Handles requests for `session`: a response that never ends.
pub(super) async fn handle(State(session): State<Option<Arc<Session>>>) -> Response {
    let Some(session) = session else { return StatusCode::NOT_FOUND.into_response() };
    let mut response = Response::new(Body::from_stream(ReaderStream::with_capacity(session.enter(), 1)));
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static("text/plain"));
    response.headers_mut().insert(CACHE_CONTROL, HeaderValue::from_static("no-store"));
    response
}

/// An open page: a line now and then, without end. It is dropped when the page closes its connection.
#[derive(Debug)]
struct OpenPage {
    session: Arc<Session>,
    beat: Interval,
}

impl Session {
    fn enter(self: &Arc<Self>) -> OpenPage {
        self.open.fetch_add(1, Ordering::SeqCst);
        self.total.fetch_add(1, Ordering::SeqCst);
        let mut beat = interval(BEAT);
        beat.set_missed_tick_behavior(MissedTickBehavior::Delay);
        OpenPage { session: Arc::clone(self), beat }
    }

    /// Ends the session if no page comes back in time.
    fn leave(self: Arc<Self>) {
        if self.open.fetch_sub(1, Ordering::SeqCst) > 1 {
            return;
        }
        let total = self.total.load(Ordering::SeqCst);
        tokio::spawn(async move {
            sleep(GRACE).await;
            let is_last = self.open.load(Ordering::SeqCst) == 0 && self.total.load(Ordering::SeqCst) == total;
            if is_last {
                self.ended.notify_one();
            }
        });
    }
}

impl AsyncRead for OpenPage {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        ready!(self.beat.poll_tick(context));
        buffer.put_slice(b"\n");
        Poll::Ready(Ok(()))
    }
}

impl Drop for OpenPage {
    fn drop(&mut self) {
        Arc::clone(&self.session).leave();
    }
}

#[cfg(test)]
mod tests {
    use tokio::time::timeout;

    use super::*;

    #[tokio::test(start_paused = true)]
    async fn a_session_ends_with_its_last_page() {
        let session = Arc::new(Session::default());
        let is_over =
            async |secs: u64| timeout(Duration::from_secs(secs), session.ended.notified()).await.is_ok();
        assert!(!is_over(60).await, "no page has come yet");
        let (first, second) = (session.enter(), session.enter());
        drop(first);
        assert!(!is_over(60).await, "one is open");
        drop(second);
        assert!(!is_over(2).await, "it may load again");
        let third = session.enter();
        assert!(!is_over(60).await, "it has");
        drop(third);
        assert!(is_over(4).await);
    }
}
