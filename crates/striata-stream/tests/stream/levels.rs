//! A stream as a source of levels, whole and cut off.

use striata::Target;
use striata::levels::Levels as _;
use striata::mesh::shapes;
use striata::simplify::{BatchOptions, RemovalOptions, StopReason, build_batches, build_fragments};
use striata_stream::{StreamLevels, StreamOptions, encode_fragments, encode_stream};
use striata_testing::levels::{check_levels, check_views};

fn streams() -> [Vec<u8>; 2] {
    let mesh = shapes::terrain(40, 3);
    let batches = build_batches(&mesh, &BatchOptions::default()).expect("a sound mesh");
    let options = StreamOptions::default();
    let collapses = encode_stream(&batches.built.refinable, &batches.batches, &options).expect("sound");
    let fragments = build_fragments(&mesh, &RemovalOptions::default()).expect("a sound mesh");
    let fragments = encode_fragments(&fragments.fragmented, &options).expect("sound");
    [collapses.bytes, fragments.bytes]
}

#[test]
fn a_stream_is_a_source() {
    for bytes in streams() {
        let steps = StreamLevels::decoded(&bytes).expect("sound").into_steps().expect("sound");
        let mut levels = StreamLevels::new(&bytes).expect("sound");
        check_levels(&mut levels, &|split_count| steps.level(split_count));
        check_views(&mut levels);
    }
}

#[test]
fn a_level_needs_no_more_than_its_part_of_the_stream() {
    for bytes in streams() {
        let mut levels = StreamLevels::new(&bytes).expect("sound");
        let level = levels.find(Target::Triangles(300)).expect("a level");
        assert_eq!(level.stop_reason, StopReason::TargetReached);
        assert!(levels.read_bytes() < bytes.len(), "{} of {}", levels.read_bytes(), bytes.len());
        let beginning = &bytes[..levels.read_bytes()];
        let again =
            StreamLevels::new(beginning).expect("sound").find(Target::Triangles(300)).expect("a level");
        assert_eq!(again.shape, level.shape);
    }
}

#[test]
fn a_stream_that_is_cut_off_says_so() {
    for bytes in streams() {
        let mut whole = StreamLevels::new(&bytes).expect("sound");
        let mut levels = StreamLevels::new(&bytes[..bytes.len() / 2]).expect("a part");
        let level = levels.find(Target::Detail(1.0)).expect("the finest level");
        assert_eq!(level.stop_reason, StopReason::InputEnded);
        assert!(levels.is_cut_off() && level.error > Some(0.0));
        let same = whole.find(Target::SplitCount(level.split_count)).expect("a level");
        assert_eq!((same.shape, same.error), (level.shape, level.error));
        let coarse = levels.find(Target::Triangles(300)).expect("a level");
        assert_eq!(coarse.stop_reason, StopReason::TargetReached);
        assert_eq!(levels.facts().triangle_count, whole.facts().triangle_count);
    }
}
