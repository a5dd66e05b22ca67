//! GLB container: a header of 12 bytes, a JSON chunk, and optionally a binary chunk.

use std::ops::Range;

use crate::error::{Fault, Place};
use crate::report::Warnings;

const HEADER_BYTES: usize = 12;
const JSON_CHUNK: &[u8; 4] = b"JSON";
const BINARY_CHUNK: &[u8; 4] = b"BIN\0";

fn word_at(bytes: &[u8], at: usize) -> Option<u32> {
    bytes.get(at..).and_then(|b| b.first_chunk()).map(|word| u32::from_le_bytes(*word))
}

/// Returns the JSON and the binary data.
pub(super) fn chunks<'b>(
    bytes: &'b [u8],
    warnings: &mut Warnings,
) -> Result<(&'b [u8], Option<&'b [u8]>), Fault> {
    let (json, binary) = chunk_ranges(bytes, warnings)?;
    Ok((&bytes[json], binary.map(|range| &bytes[range])))
}

/// Returns the ranges of the JSON and the binary data; chunks of other kinds are skipped, as the specification
/// demands.
///
/// Lengths should be multiples of 4, but some writers do not pad, and others do not count what they pad.
pub(crate) fn chunk_ranges(
    bytes: &[u8],
    warnings: &mut Warnings,
) -> Result<(Range<usize>, Option<Range<usize>>), Fault> {
    let cut = || Fault::at_byte(bytes.len(), format!("a GLB header takes {HEADER_BYTES} bytes"));
    let (version, length) = (word_at(bytes, 4).ok_or_else(cut)?, word_at(bytes, 8).ok_or_else(cut)?);
    if version != 2 {
        return Err(Fault::Unsupported(Place::Byte(4), format!("GLB version {version}")));
    }
    let length = match length as usize {
        declared if has_chunks(bytes, declared) => declared,
        declared if has_chunks(bytes, bytes.len()) => {
            let reason = format!("the header declares {declared} bytes, found {}", bytes.len());
            warnings.push(Place::Byte(8), reason);
            bytes.len()
        }
        declared if declared > bytes.len() || declared < HEADER_BYTES => {
            let reason = format!("the header declares {declared} bytes, found {}", bytes.len());
            return Err(Fault::at_byte(8, reason));
        }
        declared => declared,
    };
    let bytes = &bytes[..length];
    let (mut json, mut binary) = (None, None);
    let mut at = HEADER_BYTES;
    while at < length {
        let Some((size, kind)) = word_at(bytes, at).zip(bytes.get(at + 4..at + 8)) else {
            return Err(Fault::at_byte(at, "the file ends within a chunk's header"));
        };
        let start = at + 8;
        let end = start.saturating_add(size as usize);
        if end > length {
            let reason = format!("a chunk declares {size} bytes, found {}", length - start);
            return Err(Fault::at_byte(at, reason));
        }
        if kind == JSON_CHUNK && json.is_none() {
            json = Some(without_zeros(bytes, start..end));
        } else if kind == BINARY_CHUNK && binary.is_none() {
            binary = Some(start..end);
        }
        if !size.is_multiple_of(4) {
            let reason = format!("chunks are not aligned: one has {size} bytes, which is no multiple of 4");
            warnings.push(Place::Byte(at as u64), reason);
        }
        at = next_chunk(bytes, end);
    }
    match json {
        Some(json) => Ok((json, binary)),
        None => Err(Fault::at_byte(HEADER_BYTES, "the first chunk must be JSON, but there is none")),
    }
}

/// Whether a file of this length consists of whole chunks; the declared length is wrong in some files.
fn has_chunks(bytes: &[u8], length: usize) -> bool {
    let Some(bytes) = bytes.get(..length) else { return false };
    let mut at = HEADER_BYTES;
    while at < length {
        let Some(size) = word_at(bytes, at).filter(|_| at + 8 <= length) else { return false };
        let end = (at + 8).saturating_add(size as usize);
        if end > length {
            return false;
        }
        at = next_chunk(bytes, end);
    }
    length > HEADER_BYTES
}

/// Returns the range of a JSON chunk without the zeros that some writers pad it with instead of blanks.
fn without_zeros(bytes: &[u8], range: Range<usize>) -> Range<usize> {
    let zeros = bytes[range.clone()].iter().rev().take_while(|&&byte| byte == 0).count();
    range.start..range.end - zeros
}

/// Returns the start of the chunk after one that ends at `end`: there, or at the next multiple of 4.
fn next_chunk(bytes: &[u8], end: usize) -> usize {
    let aligned = end.next_multiple_of(4);
    let is_chunk = |at: usize| {
        let size = word_at(bytes, at).zip(bytes.get(at + 4..at + 8));
        size.is_some_and(|(size, kind)| {
            let is_known = kind == JSON_CHUNK || kind == BINARY_CHUNK;
            is_known && size as usize <= bytes.len() - (at + 8)
        })
    };
    let is_padding = bytes.get(end..aligned).is_none_or(|rest| rest.iter().all(|b| matches!(b, 0 | b' ')));
    let begins_at_once = end != aligned && (is_chunk(end) || (!is_padding && !is_chunk(aligned)));
    if begins_at_once { end } else { aligned }
}

/// Joins JSON and binary data into a file; [`None`] if the file would exceed 4 GiB.
pub(super) fn joined(mut json: Vec<u8>, mut binary: Vec<u8>) -> Option<Vec<u8>> {
    json.resize(json.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let binary_bytes = if binary.is_empty() { 0 } else { 8 + binary.len() };
    let length = HEADER_BYTES + 8 + json.len() + binary_bytes;
    let length_word = u32::try_from(length).ok()?;
    let mut out = Vec::with_capacity(length);
    out.extend_from_slice(b"glTF");
    out.extend_from_slice(&2u32.to_le_bytes());
    out.extend_from_slice(&length_word.to_le_bytes());
    for (kind, data) in [(JSON_CHUNK, json), (BINARY_CHUNK, binary)] {
        if !data.is_empty() {
            out.extend_from_slice(&(data.len() as u32).to_le_bytes());
            out.extend_from_slice(kind);
            out.extend_from_slice(&data);
        }
    }
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of some chunks: their kinds, their data, and bytes after each that it does not count.
    fn file(chunks: &[(&[u8; 4], &[u8], usize)]) -> Vec<u8> {
        let mut out = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
        for (kind, data, padding) in chunks {
            out.extend_from_slice(&(data.len() as u32).to_le_bytes());
            out.extend_from_slice(*kind);
            out.extend_from_slice(data);
            out.extend_from_slice(&[b' '; 3][..*padding]);
        }
        let length = out.len() as u32;
        out[8..12].copy_from_slice(&length.to_le_bytes());
        out
    }

    #[test]
    fn json_may_end_in_zeros_and_the_length_may_be_wrong() {
        let bytes = file(&[(JSON_CHUNK, b"{\"a\":1}\0\0\0\0\0", 0), (BINARY_CHUNK, &[7; 4], 0)]);
        for (length, warning_count) in [(bytes.len(), 0), (0, 1), (20, 1), (1000, 1)] {
            let mut bytes = bytes.clone();
            bytes[8..12].copy_from_slice(&(length as u32).to_le_bytes());
            let mut warnings = Warnings::default();
            let found = chunks(&bytes, &mut warnings).unwrap();
            assert_eq!(found, (&b"{\"a\":1}"[..], Some(&[7; 4][..])), "{length}");
            assert_eq!(warnings.into_list().len(), warning_count, "{length}");
            bytes.truncate(bytes.len() - 1);
            assert!(chunks(&bytes, &mut Warnings::default()).is_err(), "{length}");
        }
        let mut more = bytes.clone();
        more.extend(b"more");
        assert_eq!(
            chunks(&more, &mut Warnings::default()).unwrap(),
            chunks(&bytes, &mut Warnings::default()).unwrap()
        );
    }

    #[test]
    fn chunks_may_lack_padding_or_not_count_it() {
        let json = b"{\"a\":1}   ";
        for length in 7..=10 {
            let missing = (4 - length % 4) % 4;
            for padding in [0, missing] {
                for more in [&b"\x01\x02\x03\x04"[..], b"\x01\x02\x03"] {
                    let bytes = file(&[
                        (JSON_CHUNK, &json[..length], padding),
                        (b"MORE", &[0; 4], 0),
                        (BINARY_CHUNK, more, 0),
                    ]);
                    // A chunk of an unknown kind is only found at a multiple of 4.
                    if padding != missing {
                        continue;
                    }
                    let mut warnings = Warnings::default();
                    let (found, binary) = chunks(&bytes, &mut warnings).unwrap();
                    assert_eq!((found, binary), (&json[..length], Some(more)), "{length} {padding}");
                }
                let bytes = file(&[(JSON_CHUNK, &json[..length], padding), (BINARY_CHUNK, &[7; 5], 0)]);
                let mut warnings = Warnings::default();
                let (found, binary) = chunks(&bytes, &mut warnings).unwrap();
                assert_eq!((found, binary), (&json[..length], Some(&[7; 5][..])), "{length} {padding}");
                let count = 1 + usize::from(missing > 0);
                assert_eq!(warnings.into_list().len(), count, "{length} {padding}");
            }
        }
    }
}
