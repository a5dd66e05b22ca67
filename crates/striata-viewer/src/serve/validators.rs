//! What a client already has: tags and dates of answers, and whether they still hold.

use std::time::SystemTime;

use axum::http::header::{ACCEPT_ENCODING, CACHE_CONTROL, ETAG, LAST_MODIFIED, VARY};
use axum::http::{HeaderMap, HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use headers::{ETag, HeaderMapExt, IfModifiedSince, IfNoneMatch, IfRange, LastModified};

/// How bytes are packed on their way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coding {
    /// As they are.
    Plain,
    /// gzip.
    Gzip,
    /// Brotli.
    Brotli,
}

impl Coding {
    /// The name in headers; none of plain bytes.
    pub(super) fn name(self) -> Option<&'static str> {
        match self {
            Self::Plain => None,
            Self::Gzip => Some("gzip"),
            Self::Brotli => Some("br"),
        }
    }

    /// The first of the offers that the client takes.
    pub(super) fn chosen(request: &HeaderMap, offers: &[Self]) -> Self {
        let takes = |coding: &&Self| coding.name().is_some_and(|name| accepts(request, name));
        offers.iter().find(takes).copied().unwrap_or(Self::Plain)
    }
}

/// Whether the client asks for a coding by name, and does not rule it out by a weight of 0.
fn accepts(request: &HeaderMap, coding: &str) -> bool {
    let values = request.get_all(ACCEPT_ENCODING).iter().filter_map(|value| value.to_str().ok());
    values.flat_map(|value| value.split(',')).any(|offer| {
        let mut parts = offer.split(';').map(str::trim);
        let is_named = parts.next().is_some_and(|name| name.eq_ignore_ascii_case(coding));
        let weight = parts.find_map(|part| part.strip_prefix("q=")).map_or(Ok(1.0), str::parse::<f32>);
        is_named && weight.is_ok_and(|weight| weight > 0.0)
    })
}

/// What tells one state of an answer from another: a strong tag, and a date where there is one.
#[derive(Clone, Debug)]
pub(super) struct Validators {
    tag: String,
    modified: Option<SystemTime>,
}

impl Validators {
    /// From letters that are others for other bytes.
    pub(super) fn new(tag: &str, coding: Coding, modified: Option<SystemTime>) -> Self {
        let tag = match coding.name() {
            None => format!("\"{tag}\""),
            Some(coding) => format!("\"{tag}-{coding}\""),
        };
        Self { tag, modified }
    }

    /// The answer that the client's own copy still holds, where it does.
    pub(super) fn not_modified(&self, request: &HeaderMap) -> Option<Response> {
        let is_current = match request.typed_get::<IfNoneMatch>() {
            Some(condition) => !condition.precondition_passes(&self.etag()?),
            // Dates count only where there are no tags.
            None => {
                let condition = request.typed_get::<IfModifiedSince>()?;
                !condition.is_modified(self.modified?)
            }
        };
        is_current.then(|| {
            let mut response = StatusCode::NOT_MODIFIED.into_response();
            self.apply(&mut response);
            response
        })
    }

    /// Whether a part would go with what the client has.
    pub(super) fn may_send_part(&self, request: &HeaderMap) -> bool {
        let modified = self.modified.map(LastModified::from);
        let condition = request.typed_get::<IfRange>();
        condition.is_none_or(|condition| !condition.is_modified(self.etag().as_ref(), modified.as_ref()))
    }

    /// Writes them into an answer, which is to be asked for again each time.
    pub(super) fn apply(&self, response: &mut Response) {
        let headers = response.headers_mut();
        if let Ok(tag) = HeaderValue::from_str(&self.tag) {
            headers.insert(ETAG, tag);
        }
        if let Some(modified) = self.modified {
            headers.typed_insert(LastModified::from(modified));
            debug_assert!(headers.contains_key(LAST_MODIFIED));
        }
        headers.insert(CACHE_CONTROL, HeaderValue::from_static("no-cache"));
        headers.insert(VARY, HeaderValue::from_static("accept-encoding"));
    }

    fn etag(&self) -> Option<ETag> {
        self.tag.parse().ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codings_are_taken_by_name_and_weight() {
        use Coding::{Brotli, Gzip, Plain};
        for (value, expected) in [
            ("gzip, deflate, br, zstd", Brotli),
            ("gzip", Gzip),
            ("GZIP;q=0.5", Gzip),
            ("br;q=0, gzip", Gzip),
            ("br;q=0.0, gzip;q=0", Plain),
            ("br;q=x", Plain),
            ("xbr, gzipped", Plain),
            ("*", Plain),
            ("", Plain),
        ] {
            let mut request = HeaderMap::new();
            request.insert(ACCEPT_ENCODING, HeaderValue::from_static(value));
            assert_eq!(Coding::chosen(&request, &[Brotli, Gzip]), expected, "{value}");
        }
        assert_eq!(Coding::chosen(&HeaderMap::new(), &[Gzip]), Plain);
    }
}
