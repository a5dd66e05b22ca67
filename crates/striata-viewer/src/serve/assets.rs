//! Serves the viewer's own files, compressed once when the server starts.
//!
//! The page loads its other files under names that contain a hash of their contents, so browsers may keep
//! these without asking again. The page itself must be validated each time.

use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

use async_compression::Level;
use async_compression::tokio::write::{BrotliEncoder, GzipEncoder};
use axum::body::Bytes;
use axum::extract::State;
use axum::http::header::{CONTENT_ENCODING, CONTENT_TYPE};
use axum::http::{HeaderMap, HeaderValue, Uri};
use axum::response::{IntoResponse, Response};
use tokio::io::{AsyncWrite, AsyncWriteExt};

use super::files::not_found;
use super::kinds::page_type;
use super::validators::{Coding, Validators};
use crate::viewer_page::ViewerFiles;

/// Smaller files are sent uncompressed.
const MIN_COMPRESSED_BYTES: usize = 1024;
/// Bytes compressed before yielding to other tasks.
const CHUNK_BYTES: usize = 32 * 1024;

/// The viewer's files by name.
#[derive(Debug)]
pub(super) struct Assets(BTreeMap<String, Arc<Asset>>);

/// A file in up to three encodings.
#[derive(Debug)]
struct Asset {
    bytes: Bytes,
    tag: String,
    content_type: &'static str,
    /// Whether the name contains a hash of the contents.
    is_immutable: bool,
    gzip: OnceLock<Bytes>,
    brotli: OnceLock<Bytes>,
}

impl Assets {
    /// Loads the embedded files and starts compressing them; until that is done, they are sent uncompressed.
    pub(super) fn load() -> Self {
        let files = ViewerFiles::iter().filter_map(|name| Some((name.to_string(), ViewerFiles::get(&name)?)));
        let assets = files.map(|(name, file)| {
            let hash = file.metadata.sha256_hash();
            let asset = Arc::new(Asset {
                tag: hash[..12].iter().map(|byte| format!("{byte:02x}")).collect(),
                bytes: Bytes::from(file.data.into_owned()),
                content_type: page_type(&name),
                is_immutable: has_hash(&name),
                gzip: OnceLock::new(),
                brotli: OnceLock::new(),
            });
            if asset.bytes.len() >= MIN_COMPRESSED_BYTES && !asset.content_type.starts_with("image/png") {
                tokio::spawn(compress(asset.clone()));
            }
            (name, asset)
        });
        Self(assets.collect())
    }
}

impl Asset {
    /// Sets the headers for caches.
    fn apply(&self, validators: &Validators, response: &mut Response) {
        match self.is_immutable {
            true => validators.apply_immutable(response),
            false => validators.apply(response),
        }
    }
}

/// Whether a name ends in a hash of the file's contents, as the build of the page writes it: a hyphen and 16
/// hexadecimal digits before the extension.
fn has_hash(name: &str) -> bool {
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let hash = stem.rsplit_once('-').map_or("", |(_, hash)| hash);
    hash.len() == 16 && hash.bytes().all(|byte| byte.is_ascii_hexdigit())
}

/// Handles every request that is not for a model.
pub(super) async fn handle(State(assets): State<Arc<Assets>>, uri: Uri, request: HeaderMap) -> Response {
    let name = uri.path().trim_start_matches('/');
    let name = if name.is_empty() { "index.html" } else { name };
    let Some(asset) = assets.0.get(name) else { return not_found() };
    let ready = [(Coding::Brotli, asset.brotli.get()), (Coding::Gzip, asset.gzip.get())];
    let offers: Vec<Coding> = ready.iter().filter(|(_, b)| b.is_some()).map(|&(coding, _)| coding).collect();
    let coding = Coding::chosen(&request, &offers);
    let validators = Validators::new(&asset.tag, coding, None);
    if let Some(mut response) = validators.answered(&request) {
        asset.apply(&validators, &mut response);
        return response;
    }
    let compressed = ready.into_iter().find(|&(known, _)| known == coding).and_then(|(_, bytes)| bytes);
    let mut response = compressed.unwrap_or(&asset.bytes).clone().into_response();
    asset.apply(&validators, &mut response);
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static(asset.content_type));
    if let Some(coding) = coding.name() {
        headers.insert(CONTENT_ENCODING, HeaderValue::from_static(coding));
    }
    response
}

/// Compresses a file with gzip and Brotli. If one fails, clients get another encoding.
async fn compress(asset: Arc<Asset>) {
    let mut gzip = GzipEncoder::with_quality(Vec::new(), Level::Precise(9));
    if write_all(&mut gzip, &asset.bytes).await.is_ok() {
        let _ = asset.gzip.set(gzip.into_inner().into());
    }
    // From level 8 on, the search takes tens of megabytes of memory and saves only about 1% of the size.
    let mut brotli = BrotliEncoder::with_quality(Vec::new(), Level::Precise(7));
    if write_all(&mut brotli, &asset.bytes).await.is_ok() {
        let _ = asset.brotli.set(brotli.into_inner().into());
    }
}

async fn write_all(encoder: &mut (impl AsyncWrite + Unpin), bytes: &[u8]) -> std::io::Result<()> {
    for chunk in bytes.chunks(CHUNK_BYTES) {
        encoder.write_all(chunk).await?;
        tokio::task::yield_now().await;
    }
    encoder.shutdown().await
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_with_a_hash_are_recognized() {
        for good in ["viewer-0123456789abcdef.js", "a-b-0123456789abcdef.wasm"] {
            assert!(has_hash(good), "{good}");
        }
        for bad in [
            "index.html",
            "viewer.js",
            "viewer-0123.js",
            "viewer-0123456789abcdeg.js",
            "0123456789abcdef.js",
            "",
        ] {
            assert!(!has_hash(bad), "{bad}");
        }
    }

    #[test]
    fn all_embedded_files_but_the_page_have_a_hash() {
        for name in ViewerFiles::iter() {
            assert_eq!(has_hash(&name), name != "index.html", "{name}");
        }
    }
}
