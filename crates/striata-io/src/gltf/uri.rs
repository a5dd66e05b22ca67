//! URIs: embedded data, or files next to the document.

use std::borrow::Cow;
use std::path::{Component, Path, PathBuf};

use crate::Source;

/// Decodes a `data:` URI to its bytes and media type; [`None`] if it is another kind of URI, an error if it
/// is malformed.
pub(super) fn data(uri: &str) -> Option<Result<(Vec<u8>, String), String>> {
    let rest = uri.strip_prefix("data:")?;
    let Some((kind, content)) = rest.split_once(',') else {
        return Some(Err("a data URI without a comma".to_owned()));
    };
    Some(match kind.strip_suffix(";base64") {
        Some(kind) => from_base64(content.as_bytes()).map(|bytes| (bytes, media_type(kind))),
        None => match percent_decoded(content) {
            Some(bytes) => Ok((bytes.into_owned(), media_type(kind))),
            None => Err("a data URI with a broken percent escape".to_owned()),
        },
    })
}

fn media_type(kind: &str) -> String {
    kind.split(';').next().unwrap_or("").to_owned()
}

fn sextet(byte: u8) -> Option<u32> {
    Some(u32::from(match byte {
        b'A'..=b'Z' => byte - b'A',
        b'a'..=b'z' => byte - b'a' + 26,
        b'0'..=b'9' => byte - b'0' + 52,
        b'+' | b'-' => 62,
        b'/' | b'_' => 63,
        _ => return None,
    }))
}

fn from_base64(text: &[u8]) -> Result<Vec<u8>, String> {
    let content = text.trim_ascii();
    let content = content.strip_suffix(b"==").or(content.strip_suffix(b"=")).unwrap_or(content);
    let mut out = Vec::with_capacity(content.len() / 4 * 3 + 2);
    for (index, group) in content.chunks(4).enumerate() {
        let mut word = 0;
        for (i, &byte) in group.iter().enumerate() {
            let Some(bits) = sextet(byte) else {
                return Err(format!("byte {} of the base64 data is {byte:#04x}", index * 4 + i));
            };
            word |= bits << (18 - 6 * i);
        }
        match group.len() {
            1 => return Err(format!("the base64 data are cut off after {} characters", content.len())),
            length => out.extend_from_slice(&word.to_be_bytes()[1..length]),
        }
    }
    Ok(out)
}

/// Encodes bytes as base64.
pub(super) fn to_base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut out = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let mut word = [0u8; 4];
        word[1..=group.len()].copy_from_slice(group);
        let word = u32::from_be_bytes(word);
        for i in 0..4 {
            let digit = DIGITS[(word >> (18 - 6 * i) & 63) as usize];
            out.push(if i <= group.len() { char::from(digit) } else { '=' });
        }
    }
    out
}

fn percent_decoded(text: &str) -> Option<Cow<'_, [u8]>> {
    if !text.contains('%') {
        return Some(Cow::Borrowed(text.as_bytes()));
    }
    let mut out = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((&byte, after)) = rest.split_first() {
        rest = after;
        if byte == b'%' {
            let hex = std::str::from_utf8(rest.get(..2)?).ok()?;
            out.push(u8::from_str_radix(hex, 16).ok()?);
            rest = &rest[2..];
        } else {
            out.push(byte);
        }
    }
    Some(Cow::Owned(out))
}

/// Returns the file that a relative URI names, or an error that says why it is not followed.
pub(super) fn path(uri: &str, source: &Source<'_>) -> Result<PathBuf, String> {
    let Some(folder) = source.folder else {
        return Err(format!("`{}` lies outside the file, whose folder is not known", shortened(uri)));
    };
    let decoded = percent_decoded(uri).and_then(|bytes| String::from_utf8(bytes.into_owned()).ok());
    let Some(relative) = decoded else {
        return Err(format!("`{}` is not a well-formed URI", shortened(uri)));
    };
    let has_scheme = relative
        .split_once(':')
        .is_some_and(|(scheme, _)| scheme.bytes().all(|b| b.is_ascii_alphanumeric() || b"+-.".contains(&b)));
    let leaves = Path::new(&relative)
        .components()
        .any(|part| !matches!(part, Component::Normal(_) | Component::CurDir))
        || relative.contains('\\');
    if has_scheme || Path::new(&relative).is_absolute() || (leaves && !source.outside_allowed) {
        return Err(format!("`{}` leaves the folder of the file", shortened(uri)));
    }
    Ok(folder.join(relative))
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
            let (back, kind) = data(&uri).unwrap().unwrap();
            assert_eq!((back, kind.as_str()), (bytes, "application/octet-stream"));
        }
        assert_eq!(to_base64(b"any carnal pleas"), "YW55IGNhcm5hbCBwbGVhcw==");
        for broken in ["data:;base64,A", "data:;base64,AB*D", "data:nothing", "data:,%4"] {
            assert!(data(broken).unwrap().is_err(), "{broken}");
        }
    }

    #[test]
    fn references_stay_in_the_folder() {
        let source = Source::new("x.gltf").with_folder(Path::new("models"));
        assert_eq!(path("a%20b/c.bin", &source), Ok(PathBuf::from("models/a b/c.bin")));
        for leading_out in
            ["../x", "a/../../x", "%2e%2e/x", "/etc/passwd", "file:///x", "http://x/y", "C:\\x"]
        {
            assert!(path(leading_out, &source).is_err(), "{leading_out}");
        }
        assert!(path("../x", &Source { outside_allowed: true, ..source }).is_ok());
        assert!(path("/x", &Source { outside_allowed: true, ..source }).is_err());
        assert!(path("c.bin", &Source::new("x.gltf")).is_err());
    }
}
