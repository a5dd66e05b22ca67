//! Thumbnails of models, each drawn once by a separate process and cached in memory.
//!
//! Files may be huge, damaged or malicious. So `striata thumbnail` draws them in another process, one at a
//! time, with limits on memory and time: whatever happens to that process, the server continues, and its
//! own memory does not grow. If it reports that the file is broken, the response is a placeholder with the
//! reason in a header.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use axum::body::Bytes;
use axum::extract::State;
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Uri};
use axum::response::{IntoResponse, Response};
use lru::LruCache;
use percent_encoding::{NON_ALPHANUMERIC, utf8_percent_encode};
use tokio::process::Command;
use tokio::sync::Semaphore;
use tokio::time::timeout;

use super::files::{find, not_found};
use super::folder::{Folder, Stamp};
use super::kinds::is_model;
use super::thumbnail::{HEIGHT, WIDTH};
use super::validators::{Coding, Validators};
use striata_command::failure::Failure;
use striata_render::placeholder;

/// Number of cached thumbnails, about 30 MB.
const MAX_THUMBNAILS: NonZeroUsize = NonZeroUsize::new(512).expect("not 0");
/// Maximum size of a thumbnail; larger output is rejected.
const MAX_BYTES: usize = 1 << 20;
/// Time limit for drawing.
const DRAWING_TIMEOUT: Duration = Duration::from_secs(20);
/// How long a request waits for its turn.
const QUEUE_TIMEOUT: Duration = Duration::from_secs(60);
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// The cache of thumbnails.
#[derive(Debug)]
pub(super) struct Thumbnails {
    folder: Arc<Folder>,
    cache: Mutex<LruCache<String, (Stamp, Thumbnail)>>,
    turn: Semaphore,
    /// The program that draws them: this command.
    program: PathBuf,
    placeholder: Bytes,
}

/// Outcome of drawing a model.
#[derive(Clone, Debug)]
pub(super) enum Thumbnail {
    /// A PNG file.
    Picture(Bytes),
    /// The file is broken, for a reason.
    Broken(String),
    /// The model cannot be drawn within the limits.
    TooLarge,
}

/// Header with the reason why a file is broken, percent-encoded.
const FAULT: HeaderName = HeaderName::from_static("striata-fault");
/// Maximum length of a reason, characters.
const MAX_REASON: usize = 300;

impl Thumbnails {
    /// Creates an empty cache and draws the placeholder for models that cannot be drawn.
    ///
    /// # Errors
    /// If the path of this command is unknown.
    pub(super) fn new(folder: Arc<Folder>) -> Result<Self, Failure> {
        let program = std::env::current_exe()
            .map_err(|error| Failure::user(format!("cannot determine the path get this command: {error}")))?;
        let placeholder = placeholder([WIDTH, HEIGHT]).to_png();
        let placeholder =
            placeholder.map_err(|error| Failure::internal(format!("cannot encode a thumbnail: {error}")))?;
        let cache = Mutex::new(LruCache::new(MAX_THUMBNAILS));
        Ok(Self { folder, cache, turn: Semaphore::new(1), program, placeholder: placeholder.into() })
    }

    fn cached(&self, name: &str, stamp: Stamp) -> Option<Thumbnail> {
        let mut cache = self.cache.lock().unwrap_or_else(PoisonError::into_inner);
        cache.get(name).filter(|(state, _)| *state == stamp).map(|(_, picture)| picture.clone())
    }

    /// Returns the thumbnail of a file in this state, drawing it if needed; none if the queue times out.
    pub(super) async fn get(&self, name: &str, stamp: Stamp, path: &Path) -> Option<Thumbnail> {
        if let Some(picture) = self.cached(name, stamp) {
            return Some(picture);
        }
        let _turn = timeout(QUEUE_TIMEOUT, self.turn.acquire()).await.ok()?.ok()?;
        // Another request may have drawn it meanwhile.
        if let Some(picture) = self.cached(name, stamp) {
            return Some(picture);
        }
        let picture = self.draw(path).await.unwrap_or(Thumbnail::TooLarge);
        let mut cache = self.cache.lock().unwrap_or_else(PoisonError::into_inner);
        cache.put(name.to_owned(), (stamp, picture.clone()));
        Some(picture)
    }

    async fn draw(&self, path: &Path) -> Option<Thumbnail> {
        let (folder, name) = (path.parent()?, path.file_name()?);
        let mut command = Command::new(&self.program);
        // The name is relative so that messages do not contain the path of the folder.
        command.arg("thumbnail").arg(Path::new(".").join(name)).current_dir(folder);
        command.stdin(Stdio::null()).kill_on_drop(true);
        let output = timeout(DRAWING_TIMEOUT, command.output()).await.ok()?.ok()?;
        if output.status.code() == Some(1) {
            return reason_of(&String::from_utf8_lossy(&output.stderr)).map(Thumbnail::Broken);
        }
        let png = output.stdout;
        let is_picture = output.status.success() && png.starts_with(PNG) && png.len() <= MAX_BYTES;
        is_picture.then(|| Thumbnail::Picture(png.into_boxed_slice().into()))
    }
}

/// Reason in the message of the process that draws: its first line, without the name of the file.
fn reason_of(message: &str) -> Option<String> {
    let line = message.lines().find_map(|line| line.strip_prefix("error: "))?;
    let reason =
        line.strip_prefix("./").map_or(line, |named| named.split_once(": ").map_or(named, |(_, it)| it));
    Some(reason.chars().take(MAX_REASON).collect())
}

/// Handles requests for `pictures/PATH.png`.
pub(super) async fn handle(
    State(thumbnails): State<Arc<Thumbnails>>,
    uri: Uri,
    request: HeaderMap,
) -> Response {
    let found = find(&thumbnails.folder, uri.path(), "/pictures/", ".png").await;
    let Some(found) = found.filter(|found| is_model(&found.name)) else { return not_found() };
    let path = thumbnails.folder.path().join(&found.name);
    let picture = thumbnails.get(&found.name, found.stamp, &path).await;
    let is_final = picture.is_some();
    let (png, state, reason) = match picture {
        Some(Thumbnail::Picture(png)) => (png, "picture", None),
        Some(Thumbnail::Broken(reason)) => (thumbnails.placeholder.clone(), "broken", Some(reason)),
        Some(Thumbnail::TooLarge) | None => (thumbnails.placeholder.clone(), "placeholder", None),
    };
    let tag = format!("{}-{state}", found.stamp.tag());
    let validators = Validators::new(&tag, Coding::Plain, None);
    if let Some(response) = validators.answered(&request) {
        return response;
    }
    let mut response = png.into_response();
    validators.apply(&mut response);
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static("image/png"));
    if let Some(reason) = reason {
        let encoded = utf8_percent_encode(&reason, NON_ALPHANUMERIC).to_string();
        headers.extend(HeaderValue::try_from(encoded).ok().map(|reason| (FAULT, reason)));
    }
    if !is_final {
        headers.insert(CACHE_CONTROL, HeaderValue::from_static("no-store"));
    }
    response
}

#[cfg(test)]
mod tests {
    use super::reason_of;

    #[test]
    fn reasons_do_not_repeat_the_name() {
        let message = "warning: x\nerror: ./a b.obj: line 106: expected a number\n  --> ./a b.obj:106\nhint: correct it\n";
        assert_eq!(reason_of(message).as_deref(), Some("line 106: expected a number"));
        assert_eq!(reason_of("error: out of memory").as_deref(), Some("out of memory"));
        assert_eq!(reason_of("thread panicked"), None);
    }
}
