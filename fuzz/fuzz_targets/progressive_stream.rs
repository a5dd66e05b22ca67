//! Damaged progressive streams: an error, or a sound mesh after every piece.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata_stream::{DecodeError, StreamDecoder, StreamDefect};
use striata::mesh::replay;

/// Chunks whose checksums are set right.
const MOST_CHUNKS: usize = 6;

fuzz_target!(|data: &[u8]| {
    let _ = read(data);
    let mut bytes = data.to_vec();
    for _ in 0..MOST_CHUNKS {
        let Err(error) = read(&bytes) else { break };
        if !set_right(&mut bytes, &error) {
            break;
        }
    }
});

/// Reads the bytes in pieces; what is there after each must be a mesh.
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
    let Some(level) = decoder.refinable_mesh() else { return };
    assert_eq!(level.mesh.check(), Ok(()));
    let step_count = level.sequence.step_count();
    assert_eq!(replay(&level, step_count).triangle_count(), level.mesh.triangle_count());
    for split_count in [0, step_count / 2] {
        assert_eq!(
            replay(&level, split_count).triangle_count(),
            level.sequence.triangle_count_at(split_count)
        );
    }
}

/// Writes the checksum that was found where another one was expected; false where the error is another.
fn set_right(bytes: &mut [u8], error: &DecodeError) -> bool {
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
