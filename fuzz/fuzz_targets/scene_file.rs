//! Damaged files of scenes, and damaged GLB files with streams, must give an error, or a scene whose levels
//! can be written.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::Target;
use striata_fuzz::with_correct_checksums;
use striata_io::{Format, Source, WriteOptions, scene_to_bytes};
use striata_scene::file::SceneFile;
use striata_scene::{LodChainOptions, LodScene, lod_chain, read_glb_with_stream};

fuzz_target!(|data: &[u8]| {
    for bytes in [data, &with_correct_checksums(data)] {
        if let Ok(scene) = SceneFile::parse(bytes).and_then(|file| file.lod_scene()) {
            check(&scene);
        }
    }
    if let Ok(Some(scene)) = read_glb_with_stream(data, &Source::new("scene.glb")) {
        check(&scene);
    }
});

/// Writes levels in all ways; what glTF cannot store is refused.
fn check(scene: &LodScene) {
    let levels = [0.0, 0.5, 1.0].map(|detail| scene.level(Target::Detail(detail)));
    for level in &levels {
        let _ = scene_to_bytes(Format::Glb, &scene.level_scene(level), &WriteOptions::default());
    }
    let _ = lod_chain(scene, &levels, &LodChainOptions::default(), None);
    assert!(scene.to_striata(&Default::default()).is_ok());
}
