//! Damaged `.striata` files: an error, or levels that are sound meshes.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::codec::{DecodeError, StriataFile, Verify};
use striata::mesh::{RefinableMesh, replay};
use striata::model::{FanBounds, FanFront, FanScene, Fans, LodModel, StripModel};
use striata::view::{Camera, ScreenError};
use striata_fuzz::with_checksums_set_right;

fuzz_target!(|data: &[u8]| {
    let _ = read_all(data, Verify::WhenRead);
    let _ = read_all(&with_checksums_set_right(data), Verify::All);
});

fn read_all(bytes: &[u8], verify: Verify) -> Result<(), DecodeError> {
    let file = StriataFile::parse_with(bytes, verify)?;
    let _ = file.metadata();
    let _ = file.layers();
    let refinable = file.refinable_mesh();
    if let Ok(refinable) = &refinable {
        let step_count = refinable.sequence.step_count();
        for split_count in [0, step_count / 2, step_count] {
            assert_eq!(replay(refinable, split_count).check(), Ok(()));
        }
    }
    if let Some(model) = file.lod_strips() {
        walk_through(&file, &model?);
    }
    if let Some(model) = file.mts() {
        walk_through(&file, &model?);
    }
    if let Some(model) = file.fans() {
        let (fans, bounds) = model?;
        look_at_levels(&file, &fans);
        if let Ok(refinable) = &refinable {
            look_around(refinable, &fans, &bounds);
        }
    }
    Ok(())
}

fn look_at_levels(file: &StriataFile<'_>, fans: &Fans) {
    let mut state = fans.new_state();
    let step_count = fans.step_count();
    for split_count in [step_count, step_count / 2, 0] {
        fans.move_to(&mut state, split_count);
        if let Ok(level) = file.level_of(fans, &state) {
            assert_eq!(level.check(), Ok(()));
        }
    }
}

/// A front over a few views: no triangle has a corner that is not there, and all of them are counted.
fn look_around(refinable: &RefinableMesh, fans: &Fans, bounds: &FanBounds) {
    let scene = FanScene::new(fans, bounds, refinable);
    let sphere = scene.sphere();
    let [x, y, z] = sphere.center;
    let far = sphere.radius.max(1e-3);
    let mut front = FanFront::new(&scene);
    for (eye, limit) in [
        ([x, y, z + 3.0 * far], usize::MAX),
        ([x + 2.0 * far, y, z + far], 3),
        ([x, y + 0.5 * far, z + 0.1 * far], usize::MAX),
        ([x, y, z - 300.0 * far], usize::MAX),
    ] {
        let Ok(camera) = Camera::new(eye, sphere.center, [0.1, 1.0, 0.2], 0.5, [640, 480]) else { continue };
        let criterion = ScreenError::new(camera, 0.2).with_silhouettes(0.01).of_model(sphere);
        front.update(&scene, &criterion, limit);
        check_corners(refinable, fans, &front);
        front.update_to_budget(&scene, &criterion, refinable.mesh.triangle_count() / 2);
        check_corners(refinable, fans, &front);
    }
}

fn check_corners(refinable: &RefinableMesh, fans: &Fans, front: &FanFront<ScreenError>) {
    let instance = front.instance();
    let mut indices = Vec::new();
    instance.indices_into(fans, &mut indices);
    assert_eq!(front.triangle_count(), indices.len() / 3);
    let positions = refinable.sequence.positions();
    let base = refinable.sequence.base_position_count() as u32;
    for &vertex in &indices {
        let step = positions.position_of(vertex).checked_sub(base);
        assert!(step.is_none_or(|step| !instance.is_taken(step)), "vertex {vertex} is not there");
    }
    assert_eq!(instance.level(fans, refinable).check(), Ok(()));
}

fn walk_through<M: StripModel>(file: &StriataFile<'_>, model: &M) {
    let full = model.new_state();
    let mut state = model.new_state();
    let step_count = model.step_count();
    for split_count in [step_count / 2, 0, step_count / 3, step_count] {
        model.move_to(&mut state, split_count);
        if let Ok(level) = file.level_of(model, &state) {
            assert_eq!(level.check(), Ok(()));
        }
    }
    for strip in 0..model.strip_count() {
        assert_eq!(model.strip(&state, strip), model.strip(&full, strip), "down and up is not the same");
    }
}
