//! HTTP validation: entity tags and dates of responses, and whether a client's copy is current.

use std::time::SystemTime;

use axum::http::header::{ACCEPT_ENCODING, CACHE_CONTROL, ETAG, LAST_MODIFIED, VARY};
use axum::http::{HeaderMap, HeaderValue, StatusCode};
use axum::response::{IntoResponse, Response};
use headers::{
    ETag, HeaderMapExt, IfMatch, IfModifiedSince, IfNoneMatch, IfRange, IfUnmodifiedSince, LastModified,
};

/// Content coding of a response.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coding {
    /// Uncompressed.
    Plain,
    /// gzip.
    Gzip,
    /// Brotli.
    Brotli,
}

impl Coding {
    /// Name in headers; none if uncompressed.
    pub(super) fn name(self) -> Option<&'static str> {
        match self {
            Self::Plain => None,
            Self::Gzip => Some("gzip"),
            Self::Brotli => Some("br"),
        }
    }

    /// The first offer that the client accepts.
    pub(super) fn chosen(request: &HeaderMap, offers: &[Self]) -> Self {
        let takes = |coding: &&Self| coding.name().is_some_and(|name| accepts(request, name));
        offers.iter().find(takes).copied().unwrap_or(Self::Plain)
    }
}

/// Whether the client accepts a coding by name with a weight above 0.
fn accepts(request: &HeaderMap, coding: &str) -> bool {
    let values = request.get_all(ACCEPT_ENCODING).iter().filter_map(|value| value.to_str().ok());
    values.flat_map(|value| value.split(',')).any(|offer| {
        let mut parts = offer.split(';').map(str::trim);
        let is_named = parts.next().is_some_and(|name| name.eq_ignore_ascii_case(coding));
        let weight = parts.find_map(|part| part.strip_prefix("q=")).map_or(Ok(1.0), str::parse::<f32>);
        is_named && weight.is_ok_and(|weight| weight > 0.0)
    })
}

/// Validators of a response: a strong entity tag, and a modification date if there is one.
#[derive(Clone, Debug)]
pub(super) struct Validators {
    tag: String,
    modified: Option<SystemTime>,
}

impl Validators {
    /// Creates validators from text that differs for different contents.
    pub(super) fn new(tag: &str, coding: Coding, modified: Option<SystemTime>) -> Self {
        let tag = match coding.name() {
            None => format!("\"{tag}\""),
            Some(coding) => format!("\"{tag}-{coding}\""),
        };
        Self { tag, modified }
    }

    /// The response to a request whose conditions answer it: 412 if it is for another version, 304 if the
    /// client's copy is current.
    pub(super) fn answered(&self, request: &HeaderMap) -> Option<Response> {
        let is_wanted = match request.typed_get::<IfMatch>() {
            Some(condition) => condition.precondition_passes(&self.etag()?),
            None => match (request.typed_get::<IfUnmodifiedSince>(), self.modified) {
                (Some(condition), Some(modified)) => condition.precondition_passes(modified),
                _ => true,
            },
        };
        if is_wanted {
            self.not_modified(request)
        } else {
            Some(StatusCode::PRECONDITION_FAILED.into_response())
        }
    }

    fn not_modified(&self, request: &HeaderMap) -> Option<Response> {
        let is_current = match request.typed_get::<IfNoneMatch>() {
            Some(condition) => !condition.precondition_passes(&self.etag()?),
            // Dates are used only if no tags are given.
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

    /// Whether a partial response matches the client's copy.
    pub(super) fn may_send_part(&self, request: &HeaderMap) -> bool {
        let modified = self.modified.map(LastModified::from);
        let condition = request.typed_get::<IfRange>();
        condition.is_none_or(|condition| !condition.is_modified(self.etag().as_ref(), modified.as_ref()))
    }

    /// Sets the headers of a response that clients may keep without asking again, since its URL changes with
    /// its contents.
    pub(super) fn apply_immutable(&self, response: &mut Response) {
        self.apply(response);
        let headers = response.headers_mut();
        headers.insert(CACHE_CONTROL, HeaderValue::from_static("public, max-age=31536000, immutable"));
    }

    /// Sets the headers of a response, which clients must revalidate each time.
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
    fn codings_are_chosen_by_name_and_weight() {
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
