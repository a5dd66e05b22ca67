//! Data URIs: bytes embedded in the document.

use std::borrow::Cow;

use base64::Engine as _;
use base64::alphabet;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig, STANDARD};
use percent_encoding::percent_decode_str;

/// Accepts what is written in the wild: without padding, or with bits left over.
const TOLERANT: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_allow_trailing_bits(true)
        .with_decode_padding_mode(DecodePaddingMode::Indifferent),
);

/// Decodes a `data:` URI to its bytes and media type; [`None`] if it is another kind of URI, an error if it
/// is malformed.
pub(super) fn data(uri: &str) -> Option<Result<(Vec<u8>, String), String>> {
    let rest = uri.get(5..).filter(|_| uri[..5].eq_ignore_ascii_case("data:"))?;
    let Some((kind, content)) = rest.split_once(',') else {
        return Some(Err("a data URI without a comma".to_owned()));
    };
    let is_base64 = |(_, last): &(&str, &str)| last.trim().eq_ignore_ascii_case("base64");
    Some(match kind.rsplit_once(';').filter(is_base64) {
        Some((kind, _)) => from_base64(content).map(|bytes| (bytes, media_type(kind))),
        None => Ok((percent_decode_str(content).collect(), media_type(kind))),
    })
}

fn media_type(kind: &str) -> String {
    kind.split(';').next().unwrap_or("").to_owned()
}

/// Decodes base64 of either alphabet, in one line or in several.
fn from_base64(text: &str) -> Result<Vec<u8>, String> {
    let is_unusual = |byte: &u8| byte.is_ascii_whitespace() || matches!(byte, b'-' | b'_' | b'%');
    let content = match text.bytes().any(|byte| is_unusual(&byte)) {
        false => Cow::Borrowed(text.as_bytes()),
        true => {
            percent_decode_str(text).filter(|byte| !byte.is_ascii_whitespace()).map(usual_digit).collect()
        }
    };
    TOLERANT.decode(&content).map_err(|error| format!("the base64 data are malformed: {error}"))
}

/// Returns the digit of the usual alphabet for one of the alphabet of URLs.
fn usual_digit(byte: u8) -> u8 {
    match byte {
        b'-' => b'+',
        b'_' => b'/',
        byte => byte,
    }
}

/// Encodes bytes as base64.
pub(super) fn to_base64(bytes: &[u8]) -> String {
    STANDARD.encode(bytes)
}

/// Shortens a URI for a message.
pub(super) fn shortened(uri: &str) -> String {
    uri.chars().take(60).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_there_and_back() {
        for length in 0..20u8 {
            let bytes: Vec<u8> = (0..length).map(|i| i.wrapping_mul(97)).collect();
            let uri = format!("data:application/octet-stream;base64,{}", to_base64(&bytes));
            let expected = (bytes, "application/octet-stream".to_owned());
            for uri in [uri.trim_end_matches('=').to_owned(), uri.replace("A", "\r\n A\t"), uri] {
                assert_eq!(data(&uri.replace("datA", "data")).unwrap().unwrap(), expected, "{uri}");
            }
        }
        assert_eq!(data("data:;base64,-_-_").unwrap(), data("data:;base64,+/+/").unwrap());
        assert_eq!(data("data:text/plain;charset=x,a%20b").unwrap().unwrap().0, b"a b");
        let escaped = data("data:;base64,YW55IGNh%0Acm5hbCBwbGVhcw%3D%3D").unwrap().unwrap();
        assert_eq!(escaped.0, b"any carnal pleas");
        assert_eq!(data("DATA:;Base64,+/+/").unwrap(), data("data:;base64,+/+/").unwrap());
        assert_eq!(data("dat"), None);
        assert_eq!(data("däta:"), None);
        for broken in ["data:;base64,A", "data:;base64,AB*D", "data:nothing"] {
            assert!(data(broken).unwrap().is_err(), "{broken}");
        }
    }
}
