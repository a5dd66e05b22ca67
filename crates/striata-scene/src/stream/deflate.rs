//! Deflate with limits on what is unpacked.

use std::io::{Read, Write};

use flate2::Compression;
use flate2::read::DeflateDecoder;
use flate2::write::DeflateEncoder;

/// Compresses bytes; stores them if compression would exceed the expansion that a reader allows.
pub(super) fn deflate(bytes: &[u8], limit_of: impl Fn(usize) -> usize) -> Vec<u8> {
    let packed = at_level(bytes, Compression::best());
    if bytes.len() <= limit_of(packed.len()) { packed } else { at_level(bytes, Compression::none()) }
}

fn at_level(bytes: &[u8], level: Compression) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), level);
    // Writing to memory does not fail.
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    written.unwrap_or_default()
}

/// Unpacks bytes; [`None`] if they are malformed, unpack to more than `limit` bytes, or are followed by
/// others.
pub(super) fn inflate(packed: &[u8], limit: usize) -> Option<Vec<u8>> {
    let mut decoder = DeflateDecoder::new(packed);
    let mut bytes = Vec::new();
    let most = (limit as u64).saturating_add(1);
    decoder.by_ref().take(most).read_to_end(&mut bytes).ok()?;
    (bytes.len() <= limit && decoder.total_in() == packed.len() as u64).then_some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_round_trip_within_the_limit() {
        for bytes in [Vec::new(), vec![7; 100_000], (0..5000u32).flat_map(u32::to_le_bytes).collect()] {
            let packed = deflate(&bytes, |packed| 64 * packed);
            assert!(bytes.len() <= 64 * packed.len());
            assert_eq!(inflate(&packed, bytes.len()), Some(bytes.clone()));
            assert!(bytes.is_empty() || inflate(&packed, bytes.len() - 1).is_none());
            assert_eq!(inflate(&[packed, vec![0]].concat(), bytes.len()), None);
        }
        assert_eq!(inflate(b"hello", 100), None);
    }
}
