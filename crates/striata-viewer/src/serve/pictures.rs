//! Small pictures of models, each drawn once by a process of its own and kept in memory.
//!
//! A file from anywhere may be huge, damaged, or made to do harm. So the drawing is done by `striata thumbnail` in another process,
//! one at a time, with limits on its memory and time: whatever happens to it, the server goes on, and its memory is what it was.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use axum::body::Bytes;
use axum::extract::State;
use axum::http::header::{CACHE_CONTROL, CONTENT_TYPE};
use axum::http::{HeaderMap, HeaderValue, Uri};
use axum::response::{IntoResponse, Response};
use lru::LruCache;
use tokio::process::Command;
use tokio::sync::Semaphore;
use tokio::time::timeout;

use super::files::{find, not_found};
use super::folder::{Folder, Stamp};
use super::kinds::is_model;
use super::thumbnail::{HEIGHT, WIDTH};
use super::validators::{Coding, Validators};
use crate::picture::nobody;
use striata_command::failure::Failure;

/// Pictures that are kept: some 30 MB.
const MAX_PICTURES: NonZeroUsize = NonZeroUsize::new(512).expect("not 0");
/// A larger picture is none of ours.
const MAX_BYTES: usize = 1 << 20;
/// How long a drawing may take.
const DRAWING: Duration = Duration::from_secs(20);
/// How long a request waits for its turn.
const WAITING: Duration = Duration::from_secs(60);
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

/// The pictures that are there.
#[derive(Debug)]
pub(super) struct Pictures {
    kept: Mutex<LruCache<String, (Stamp, Picture)>>,
    turn: Semaphore,
    /// What draws them: this command.
    program: PathBuf,
    nobody: Bytes,
}

/// A picture, or that there is none of its model.
#[derive(Clone, Debug)]
struct Picture(Option<Bytes>);

impl Pictures {
    /// No pictures yet but the one for models that have none.
    ///
    /// # Errors
    /// Where the system does not tell where this command lies.
    pub(super) fn new() -> Result<Self, Failure> {
        let program = std::env::current_exe()
            .map_err(|error| Failure::user(format!("where this command lies: {error}")))?;
        let nobody = nobody([WIDTH, HEIGHT]).to_png();
        let nobody = nobody.map_err(|error| Failure::internal(format!("a picture: {error}")))?;
        let kept = Mutex::new(LruCache::new(MAX_PICTURES));
        Ok(Self { kept, turn: Semaphore::new(1), program, nobody: nobody.into() })
    }

    fn known(&self, name: &str, stamp: Stamp) -> Option<Picture> {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.get(name).filter(|(state, _)| *state == stamp).map(|(_, picture)| picture.clone())
    }

    /// The picture of a file in this state; none where its turn does not come.
    async fn of(&self, name: &str, stamp: Stamp, path: &Path) -> Option<Picture> {
        if let Some(picture) = self.known(name, stamp) {
            return Some(picture);
        }
        let _turn = timeout(WAITING, self.turn.acquire()).await.ok()?.ok()?;
        // Somebody else may have asked for the same.
        if let Some(picture) = self.known(name, stamp) {
            return Some(picture);
        }
        let picture = Picture(self.drawn(path).await);
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept.put(name.to_owned(), (stamp, picture.clone()));
        Some(picture)
    }

    async fn drawn(&self, path: &Path) -> Option<Bytes> {
        let mut command = Command::new(&self.program);
        command.arg("thumbnail").arg(path).stdin(Stdio::null()).stderr(Stdio::null()).kill_on_drop(true);
        let output = timeout(DRAWING, command.output()).await.ok()?.ok()?;
        let png = output.stdout;
        let is_picture = output.status.success() && png.starts_with(PNG) && png.len() <= MAX_BYTES;
        is_picture.then(|| png.into_boxed_slice().into())
    }
}

/// Answers for `pictures/PATH.png`.
pub(super) async fn answer(
    State(folder): State<Arc<Folder>>,
    State(pictures): State<Arc<Pictures>>,
    uri: Uri,
    request: HeaderMap,
) -> Response {
    let found = find(&folder, uri.path(), "/pictures/", ".png").await;
    let Some(found) = found.filter(|found| is_model(&found.name)) else { return not_found() };
    let path = folder.path().join(&found.name);
    let picture = pictures.of(&found.name, found.stamp, &path).await;
    let is_final = picture.is_some();
    let (png, state) = match picture {
        Some(Picture(Some(png))) => (png, "picture"),
        _ => (pictures.nobody.clone(), "nobody"),
    };
    let tag = format!("{}-{state}", found.stamp.tag());
    let validators = Validators::new(&tag, Coding::Plain, None);
    if let Some(response) = validators.not_modified(&request) {
        return response;
    }
    let mut response = png.into_response();
    validators.apply(&mut response);
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static("image/png"));
    if !is_final {
        headers.insert(CACHE_CONTROL, HeaderValue::from_static("no-store"));
    }
    response
}
