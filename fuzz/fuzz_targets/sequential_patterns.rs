//! Decodes arbitrary bytes as sequential patterns: the result is an error, or fragments that follow each
//! other.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata_lab::baseline::{SequentialDecoder, decode_sequential};

fuzz_target!(|data: &[u8]| {
    let Ok(mut decoder) = SequentialDecoder::new(data) else { return };
    let mut triangle_count = decoder.triangles().len();
    let is_whole = loop {
        match decoder.next_fragment() {
            Ok(Some(fragment)) => triangle_count += fragment.ceiling.len() - fragment.floor.len(),
            Ok(None) => break true,
            Err(_) => break false,
        }
        assert_eq!(decoder.triangles().len(), triangle_count, "triangles must not be lost");
    };
    // A step may add a triangle that duplicates another one, which a surface allows and a sequence does not.
    assert!(
        is_whole || decode_sequential(data).is_err(),
        "a whole that decodes must consist of parts that decode"
    );
});
