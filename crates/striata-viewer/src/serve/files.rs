//! Serves models and the files they refer to: whole, in ranges, or compressed if they are text.
//!
//! A file is opened once; its stamp, its first bytes and the data sent all come from that handle, so a file
//! that is replaced meanwhile is never mixed with its successor. It is sent in small chunks, and each is
//! read only after the previous one is gone, so a slow client takes the memory of a chunk or two and delays
//! nobody.

use std::io::SeekFrom;
use std::ops::RangeInclusive;
use std::sync::Arc;

use async_compression::Level;
use async_compression::tokio::bufread::GzipEncoder;
use axum::body::Body;
use axum::extract::State;
use axum::http::header::{ACCEPT_RANGES, CONTENT_ENCODING, CONTENT_LENGTH, CONTENT_TYPE, RANGE};
use axum::http::{HeaderMap, HeaderValue, Method, StatusCode, Uri};
use axum::response::{IntoResponse, Response};
use headers::{ContentRange, HeaderMapExt};
use http_range_header::{EndPosition, RangeUnsatisfiableError, StartPosition, parse_range_header};
use tokio::fs::File;
use tokio::io::{AsyncReadExt, AsyncSeekExt, BufReader};
use tokio_util::io::ReaderStream;

use super::folder::{Folder, OpenedFile, Stamp};
use super::kinds::{content_type, is_text};
use super::validators::{Coding, Validators};

/// Bytes read and sent at a time.
const CHUNK_BYTES: usize = 64 * 1024;
/// Bytes inspected to detect text.
const HEAD_BYTES: u64 = 256;
/// Compression level: fast, and nearly as small as higher levels.
const LEVEL: Level = Level::Precise(5);

/// Handles requests for `models/PATH`.
pub(super) async fn handle(
    State(folder): State<Arc<Folder>>,
    method: Method,
    uri: Uri,
    request: HeaderMap,
) -> Response {
    let Some(found) = find(&folder, uri.path(), "/models/", "").await else { return not_found() };
    let mut file = File::from_std(found.file);
    file.set_max_buf_size(CHUNK_BYTES);
    match send(file, &found.name, &found.stamp, &method, &request).await {
        Ok(response) => response,
        // The file was opened but could not be read.
        Err(error) => (StatusCode::INTERNAL_SERVER_ERROR, format!("{error}\n")).into_response(),
    }
}

/// Response for files that do not exist.
pub(super) fn not_found() -> Response {
    (StatusCode::NOT_FOUND, "file not found\n").into_response()
}

/// Opens the file that a path names between a prefix and a suffix, on a thread that may block.
pub(super) async fn find(folder: &Arc<Folder>, path: &str, prefix: &str, suffix: &str) -> Option<OpenedFile> {
    let name = path.strip_prefix(prefix)?.strip_suffix(suffix)?.to_owned();
    let folder = folder.clone();
    tokio::task::spawn_blocking(move || folder.find(&name)).await.ok()?
}

async fn send(
    mut file: File,
    name: &str,
    stamp: &Stamp,
    method: &Method,
    request: &HeaderMap,
) -> std::io::Result<Response> {
    let mut head = Vec::new();
    (&mut file).take(HEAD_BYTES).read_to_end(&mut head).await?;
    let is_text = is_text(name, &head);
    let has_range = request.contains_key(RANGE);
    let offers: &[Coding] = if is_text && !has_range { &[Coding::Gzip] } else { &[] };
    let coding = Coding::chosen(request, offers);
    let validators = Validators::new(&stamp.tag(), coding, Some(stamp.modified));
    if let Some(response) = validators.answered(request) {
        return Ok(response);
    }
    let part = match method {
        // Ranges apply only to GET.
        &Method::GET if has_range && validators.may_send_part(request) => Part::of(request, stamp.bytes),
        _ => Part::Whole,
    };
    let mut response = match (part, coding) {
        (Part::None, _) => {
            let mut response = StatusCode::RANGE_NOT_SATISFIABLE.into_response();
            response.headers_mut().typed_insert(ContentRange::unsatisfied_bytes(stamp.bytes));
            return Ok(response);
        }
        (Part::Whole, Coding::Plain) => plain(file, 0, stamp.bytes, method).await?,
        (Part::Whole, _) => compressed(file, method).await?,
        (Part::Range(range), _) => {
            let bytes = range.end() - range.start() + 1;
            let mut response = plain(file, *range.start(), bytes, method).await?;
            *response.status_mut() = StatusCode::PARTIAL_CONTENT;
            if let Ok(range) = ContentRange::bytes(range, stamp.bytes) {
                response.headers_mut().typed_insert(range);
            }
            response
        }
    };
    validators.apply(&mut response);
    let headers = response.headers_mut();
    headers.insert(CONTENT_TYPE, HeaderValue::from_static(content_type(name)));
    headers.insert(ACCEPT_RANGES, HeaderValue::from_static("bytes"));
    Ok(response)
}

/// Sends `bytes` bytes from offset `start` uncompressed.
async fn plain(mut file: File, start: u64, bytes: u64, method: &Method) -> std::io::Result<Response> {
    let body = match method {
        &Method::HEAD => Body::empty(),
        _ => {
            file.seek(SeekFrom::Start(start)).await?;
            Body::from_stream(ReaderStream::with_capacity(file.take(bytes), CHUNK_BYTES))
        }
    };
    let mut response = body.into_response();
    response.headers_mut().insert(CONTENT_LENGTH, HeaderValue::from(bytes));
    Ok(response)
}

/// Sends the whole file, compressed on the fly; its final length is unknown.
async fn compressed(mut file: File, method: &Method) -> std::io::Result<Response> {
    let body = match method {
        &Method::HEAD => Body::empty(),
        _ => {
            file.seek(SeekFrom::Start(0)).await?;
            let reader = BufReader::with_capacity(CHUNK_BYTES, file);
            let encoder = GzipEncoder::with_quality(reader, LEVEL);
            Body::from_stream(ReaderStream::with_capacity(encoder, CHUNK_BYTES))
        }
    };
    let mut response = body.into_response();
    response.headers_mut().insert(CONTENT_ENCODING, HeaderValue::from_static("gzip"));
    Ok(response)
}

/// The requested part of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Part {
    /// The whole file; also for invalid or multiple ranges, which servers may ignore.
    Whole,
    /// A range of bytes.
    Range(RangeInclusive<u64>),
    /// A range outside the file.
    None,
}

impl Part {
    fn of(request: &HeaderMap, length: u64) -> Self {
        let Some(range) = request.get(RANGE).and_then(|value| value.to_str().ok()) else {
            return Self::Whole;
        };
        let parsed = match parse_range_header(range) {
            Ok(parsed) => parsed,
            Err(RangeUnsatisfiableError::ZeroSuffix) => return Self::None,
            Err(_) => return Self::Whole,
        };
        let [range] = parsed.ranges.as_slice() else { return Self::Whole };
        let (start, last) = match (range.start, range.end) {
            (StartPosition::FromLast(count), _) => (length.saturating_sub(count), length),
            (StartPosition::Index(start), EndPosition::LastByte) => (start, length),
            (StartPosition::Index(start), EndPosition::Index(last)) if last < start => return Self::Whole,
            (StartPosition::Index(start), EndPosition::Index(last)) => (start, last),
        };
        if start >= length { Self::None } else { Self::Range(start..=last.min(length - 1)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_follow_the_standard() {
        for (range, expected) in [
            ("bytes=0-0", Part::Range(0..=0)),
            ("bytes=2-5", Part::Range(2..=5)),
            ("bytes=2-", Part::Range(2..=9)),
            ("bytes=-3", Part::Range(7..=9)),
            ("bytes=-30", Part::Range(0..=9)),
            ("bytes=5-99", Part::Range(5..=9)),
            ("bytes=9-9", Part::Range(9..=9)),
            ("bytes=10-", Part::None),
            ("bytes=-0", Part::None),
            ("bytes=5-2", Part::Whole),
            ("bytes=0-1, 4-5", Part::Whole),
            ("bytes=a-b", Part::Whole),
            ("lines=1-2", Part::Whole),
            ("bytes=0-99999999999999999999999", Part::Whole),
        ] {
            let mut request = HeaderMap::new();
            request.insert(RANGE, HeaderValue::from_static(range));
            assert_eq!(Part::of(&request, 10), expected, "{range}");
        }
        let mut request = HeaderMap::new();
        request.insert(RANGE, HeaderValue::from_static("bytes=0-"));
        assert_eq!(Part::of(&request, 0), Part::None);
    }
}
