//! GLB container: a header of 12 bytes, a JSON chunk, and optionally a binary chunk.

use std::ops::Range;

use crate::error::{Fault, Place};

const HEADER_BYTES: usize = 12;
const JSON_CHUNK: &[u8; 4] = b"JSON";
const BINARY_CHUNK: &[u8; 4] = b"BIN\0";

fn word_at(bytes: &[u8], at: usize) -> Option<u32> {
    bytes.get(at..).and_then(|b| b.first_chunk()).map(|word| u32::from_le_bytes(*word))
}

/// Returns the JSON and the binary data.
pub(super) fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), Fault> {
    let (json, binary) = chunk_ranges(bytes)?;
    Ok((&bytes[json], binary.map(|range| &bytes[range])))
}

/// Returns where the JSON and the binary data are; chunks of other kinds are skipped, as the specification
/// demands.
pub(crate) fn chunk_ranges(bytes: &[u8]) -> Result<(Range<usize>, Option<Range<usize>>), Fault> {
    let cut = || Fault::at_byte(bytes.len(), format!("a GLB header takes {HEADER_BYTES} bytes"));
    let (version, length) = (word_at(bytes, 4).ok_or_else(cut)?, word_at(bytes, 8).ok_or_else(cut)?);
    if version != 2 {
        return Err(Fault::Unsupported(Place::Byte(4), format!("GLB version {version}")));
    }
    let length = length as usize;
    if length > bytes.len() || length < HEADER_BYTES {
        let reason = format!("the header declares {length} bytes, found {}", bytes.len());
        return Err(Fault::at_byte(8, reason));
    }
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
            json = Some(start..end);
        } else if kind == BINARY_CHUNK && binary.is_none() {
            binary = Some(start..end);
        }
        at = start + (size as usize).next_multiple_of(4);
    }
    match json {
        Some(json) => Ok((json, binary)),
        None => Err(Fault::at_byte(HEADER_BYTES, "the first chunk must be JSON, but there is none")),
    }
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
