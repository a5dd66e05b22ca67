//! Damaged progressive streams must give an error, or a valid mesh after every piece.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata_stream::{DecodeError, StreamDecoder, StreamDefect};

/// Maximum number of checksums that are corrected.
const MOST_CHUNKS: usize = 6;

fuzz_target!(|data: &[u8]| {
    let _ = read(data);
    let mut bytes = data.to_vec();
    for _ in 0..MOST_CHUNKS {
        let Err(error) = read(&bytes) else { break };
        if !correct_checksum(&mut bytes, &error) {
            break;
        }
    }
});

/// Decodes the bytes in pieces. After each piece, the decoded part must be a valid mesh.
fn read(bytes: &[u8]) -> Result<(), DecodeError> {
    let mut decoder = StreamDecoder::new();
    let piece = 1 + bytes.len() / 3;
    for piece in bytes.chunks(piece) {
        let result = decoder.push(piece);
        check(&decoder);
        result?;
    }
    if !decoder.is_complete() {
        decoder.finish()?;
        check(&decoder);
    }
    Ok(())
}

fn check(decoder: &StreamDecoder) {
    let Some(steps) = decoder.steps() else { return };
    assert_eq!(steps.mesh().check(), Ok(()));
    let step_count = steps.levels().step_count();
    for split_count in [0, step_count / 2, step_count] {
        let level = steps.level(split_count);
        assert_eq!(level.triangle_count(), steps.levels().triangle_count_at(split_count));
    }
}

/// Overwrites the expected checksum with the actual one. Returns false if the error is not about a checksum.
fn correct_checksum(bytes: &mut [u8], error: &DecodeError) -> bool {
    let (found, expected) = match *error {
        DecodeError::HeaderChecksum { found, expected }
        | DecodeError::Stream(StreamDefect::Checksum { found, expected, .. }) => (found, expected),
        _ => return false,
    };
    let place = bytes.windows(4).rposition(|b| b == expected.to_le_bytes());
    let Some(at) = place else { return false };
    bytes[at..at + 4].copy_from_slice(&found.to_le_bytes());
    true
}
