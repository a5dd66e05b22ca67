//! Damaged scene streams, in pieces of any size, must give an error, or a scene after every piece.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::mesh::replay;
use striata_fuzz::{Bytes, packed};
use striata_scene::stream::{SceneStreamDecoder, SceneStreamError, SceneStreamInfo};

/// Largest number of pieces after which the scene is looked at.
const MAX_LOOKS: usize = 8;

fuzz_target!(|data: &[u8]| {
    let mut input = Bytes(data);
    let sizes = [input.byte(), input.byte(), input.byte()];
    let stream = packed(input.0);
    let _ = SceneStreamInfo::read(&stream);
    let pieces = read(&stream, sizes);
    let whole = read(&stream, [255; 3]);
    assert_eq!(pieces.is_ok(), whole.is_ok(), "pieces matter: {pieces:?}, {whole:?}");
});

/// Decodes a stream in pieces. Whatever has arrived must be a valid scene.
fn read(stream: &[u8], sizes: [u8; 3]) -> Result<(), SceneStreamError> {
    let mut decoder = SceneStreamDecoder::new();
    let (mut rest, mut looks) = (stream, 0);
    for size in sizes.iter().cycle() {
        // Sizes from 1 byte to everything, at an even ratio; a stream takes at most some 3,000 pieces.
        let size = 1 + ((stream.len() * usize::from(*size).pow(2)) >> 16).max(stream.len() / 3000);
        let (piece, after) = rest.split_at(size.min(rest.len()));
        let result = decoder.push(piece);
        rest = after;
        if looks < MAX_LOOKS || rest.is_empty() || result.is_err() {
            look(&decoder);
            looks += 1;
        }
        result?;
        if rest.is_empty() {
            break;
        }
    }
    if !decoder.is_complete() {
        let result = decoder.finish().map(drop);
        look(&decoder);
        result?;
    }
    Ok(())
}

fn look(decoder: &SceneStreamDecoder) {
    if let Ok(scene) = decoder.scene() {
        for mesh in scene.meshes().iter().flatten() {
            assert_eq!(mesh.check(), Ok(()));
        }
    }
    for level in decoder.refinable_meshes().iter().flatten() {
        let half = level.sequence.step_count() / 2;
        assert_eq!(replay(level, half).triangle_count(), level.sequence.triangle_count_at(half));
    }
    for image in 0..decoder.image_count() {
        assert!(decoder.image(image).is_some());
    }
}
