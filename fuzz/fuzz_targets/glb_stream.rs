//! GLB files with streams, damaged in their documents and in their data, must give an error, or levels that
//! can be written.
#![no_main]

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use striata::{LodOptions, Target};
use striata_fuzz::{Bytes, allow_contained_panics};
use striata_io::{Format, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_scene::{GlbStreamOptions, LodScene, read_glb_with_stream};
use striata_testing::scenes;
use striata_testing::strange::StrangeParts;

/// Files whose values and bytes are changed.
static FILES: LazyLock<Vec<StrangeParts>> = LazyLock::new(|| {
    let file = |scene: &scenes::TestScene| -> Option<StrangeParts> {
        let scene = read_scene_bytes(&scene.to_glb(), &Source::new("scene.glb")).ok()?;
        let lods = LodScene::build(&scene, &LodOptions::default()).ok()?;
        Some(StrangeParts::of_glb(&lods.to_glb_with_stream(&GlbStreamOptions::default()).ok()?))
    };
    scenes::all().iter().filter_map(file).collect()
});

fuzz_target!(|data: &[u8]| {
    allow_contained_panics();
    let mut input = Bytes(data);
    let mut parts = FILES[usize::from(input.byte()) % FILES.len()].clone();
    parts.change(input.0);
    let Ok(Some(scene)) = read_glb_with_stream(&parts.to_glb(), &Source::new("scene.glb")) else { return };
    for detail in [0.0, 0.5, 1.0] {
        let level = scene.level(Target::Detail(detail));
        let _ = scene_to_bytes(Format::Glb, &scene.level_scene(&level), &WriteOptions::default());
    }
    assert!(scene.to_striata(&Default::default()).is_ok());
});
