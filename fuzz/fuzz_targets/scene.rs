//! Documents with strange values must give an error, or a scene that survives writing, flattening, all
//! levels, poses, streams and files.
#![no_main]

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use striata::{LodOptions, Target};
use striata_fuzz::{Bytes, allow_contained_panics};
use striata_io::{Format, Scene, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_scene::stream::{SceneStreamDecoder, SceneStreamOptions, encode_scene};
use striata_scene::{LodScene, Poser};
use striata_testing::scenes;
use striata_testing::strange::{StrangeParts, glb_of_chunks};

/// Scenes whose values are changed.
static SCENES: LazyLock<Vec<StrangeParts>> = LazyLock::new(|| {
    let parts = |scene: &scenes::TestScene| StrangeParts::of_glb(&scene.to_glb());
    scenes::all().iter().map(parts).collect()
});

/// Largest number of triangles that levels are built for.
const MAX_TRIANGLES: usize = 600;

fuzz_target!(|data: &[u8]| {
    allow_contained_panics();
    let mut input = Bytes(data);
    let (kind, checks) = (usize::from(input.byte()), input.byte());
    let glb = match SCENES.get(kind % (SCENES.len() + 1)) {
        Some(parts) => {
            let mut parts = parts.clone();
            parts.change(input.0);
            parts.to_glb()
        }
        None => {
            let mut chunks = input.0.splitn(2, |&byte| byte == 0);
            glb_of_chunks(chunks.next().unwrap_or_default(), chunks.next().unwrap_or_default())
        }
    };
    let Ok(scene) = read(&glb) else { return };
    let is_writable = write_and_read(&scene);
    let triangle_count: usize = scene.meshes().iter().flatten().map(|mesh| mesh.triangle_count()).sum();
    if checks & 1 != 0 && scene.triangle_count() < 100_000 {
        flatten(&scene);
    }
    if checks & 2 != 0 {
        pose(&scene);
    }
    if checks & 4 != 0 && triangle_count < MAX_TRIANGLES {
        build(&scene, is_writable);
    }
    if checks & 8 != 0 && triangle_count < MAX_TRIANGLES {
        stream(&scene);
    }
});

fn read(glb: &[u8]) -> Result<Scene, striata_io::ReadError> {
    read_scene_bytes(glb, &Source::new("scene.glb"))
}

/// A scene that was written and read again must not change any more. Returns whether glTF can store it.
fn write_and_read(scene: &Scene) -> bool {
    let Ok(first) = scene_to_bytes(Format::Glb, scene, &WriteOptions::default()) else { return false };
    let again = match read(&first) {
        Ok(again) => again,
        Err(error) => panic!("what was written cannot be read: {error}"),
    };
    let count =
        |scene: &Scene| -> usize { scene.meshes().iter().flatten().map(|m| m.triangle_count()).sum() };
    assert_eq!(count(&again), count(scene), "triangles are lost");
    assert_eq!(again.instances().len(), scene.instances().len(), "instances are lost");
    let second = scene_to_bytes(Format::Glb, &again, &WriteOptions::default());
    let second = second.expect("what was written once can be written again");
    let third = read(&second).expect("what was read once can be read again");
    assert_eq!(third.document(), again.document());
    assert_eq!(third.buffer(), again.buffer());
    true
}

fn flatten(scene: &Scene) {
    if let Ok(mesh) = scene.flattened() {
        assert_eq!(mesh.check().is_ok(), mesh.positions.as_flattened().iter().all(|x| x.is_finite()));
    }
}

fn pose(scene: &Scene) {
    let Ok(poser) = Poser::new(scene) else { return };
    let mut poses = vec![poser.rest_pose()];
    for animation in 0..poser.animation_count().min(4) {
        let end = poser.duration(animation);
        poses.extend([0.0, end * 0.4, end, f32::NAN].map(|time| poser.pose(animation, time)));
    }
    for instance in scene.instances().iter().take(20) {
        let Some(mesh) = &scene.meshes()[instance.mesh] else { continue };
        for pose in &poses {
            assert_eq!(poser.positions(pose, instance, mesh).len(), mesh.vertex_count());
        }
    }
}

fn build(scene: &Scene, is_writable: bool) {
    let Ok(lods) = LodScene::build(scene, &LodOptions::default()) else { return };
    for detail in [0.0, 0.4, 1.0] {
        let level = lods.level(Target::Detail(detail));
        let written = scene_to_bytes(Format::Glb, &lods.level_scene(&level), &WriteOptions::default());
        assert!(written.is_ok() || !is_writable, "a level cannot be written");
    }
    assert!(lods.to_striata(&Default::default()).is_ok());
}

fn stream(scene: &Scene) {
    let Ok(stream) = encode_scene(scene, &SceneStreamOptions::default()) else { return };
    let mut decoder = SceneStreamDecoder::new();
    for piece in stream.bytes.chunks(stream.bytes.len() / 3 + 1) {
        if let Err(error) = decoder.push(piece) {
            panic!("our own stream is refused: {error}");
        }
    }
    assert!(decoder.is_complete());
    assert!(decoder.scene().is_ok(), "the streamed scene is not drawable");
}
