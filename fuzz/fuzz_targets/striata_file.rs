//! Damaged `.striata` files must give an error, or levels that are valid meshes and patterns that follow
//! the oracle.
#![no_main]

use libfuzzer_sys::fuzz_target;
use striata::file::{DecodeError, StriataFile, Verify};
use striata::mesh::{FragmentSequence, RefinableMesh, canonical_triangles, fragment_faces, replay};
use striata::model::{
    CriterionCondition, FanFront, FanScene, Fans, Overlap, PatternInstance, PatternScene, Patterns,
    StoredModel, StripModel,
};
use striata::view::{Camera, DetailBox, ScreenError};
use striata_fuzz::with_correct_checksums;

fuzz_target!(|data: &[u8]| {
    let _ = read_all(data, Verify::WhenRead);
    let _ = read_all(&with_correct_checksums(data), Verify::All);
    // A truncated file contains only the beginning of its stream.
    if let Ok(mesh) = striata_stream::open_truncated(&data[..data.len() * 7 / 8]).and_then(|file| file.mesh())
    {
        assert_eq!(mesh.check(), Ok(()));
    }
});

fn read_all(bytes: &[u8], verify: Verify) -> Result<(), DecodeError> {
    let file = striata_stream::open_with(bytes, verify)?;
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
        check_strip_levels(&file, &model?);
    }
    if let Some(model) = file.mts() {
        check_strip_levels(&file, &model?);
    }
    if let Some(model) = file.fans() {
        let fans = model?;
        check_levels(&file, &fans);
        if let Ok(refinable) = &refinable {
            check_front(refinable, &fans);
        }
    }
    if let Some(model) = file.patterns() {
        let patterns = model?;
        check_levels(&file, &patterns);
        if let Ok(fragments) = patterns.unpack(vec![0.0; patterns.fragment_count()]) {
            check_random_steps(&fragments, &patterns);
        }
        if let Ok(positions) = file.positions() {
            check_detail_boxes(PatternScene::new(&patterns, &positions));
        }
        if let Ok(fragmented) = file.fragmented_mesh() {
            assert_eq!(fragmented.mesh.check(), Ok(()));
        }
    }
    Ok(())
}

/// Checks that all readable levels are valid meshes.
fn check_levels<M: StoredModel>(file: &StriataFile<'_>, model: &M) {
    let mut state = model.new_state();
    let step_count = model.step_count();
    for split_count in [step_count, step_count / 2, 0] {
        model.move_to(&mut state, split_count);
        if let Ok(level) = file.level_of(model, &state) {
            assert_eq!(level.check(), Ok(()));
        }
    }
}

/// Checks that an instance shows the same triangles as the oracle after any insertions and removals.
fn check_random_steps(fragments: &FragmentSequence, patterns: &Patterns) {
    let step_count = patterns.fragment_count() as u32;
    let mut instance = PatternInstance::base(patterns);
    for round in 0..6u32 {
        let random_condition = |overlap: Overlap| {
            let name = overlap.upper ^ overlap.lower.map_or(77, |lower| lower.wrapping_mul(31));
            name.wrapping_mul(2_654_435_761).wrapping_add(round * 7919) >> 8 & 7 < round % 5
        };
        instance.adapt(patterns, &random_condition);
        if step_count > 0 {
            instance.remove(patterns, round * 31 % step_count);
            instance.insert(patterns, round * 17 % step_count);
        }
        let faces = fragment_faces(fragments, |step| instance.is_refined(step));
        let expected: Vec<_> = faces.iter().map(|&face| fragments.faces()[face as usize].corners).collect();
        let mut found = Vec::new();
        instance.triangles_into(&mut found);
        assert_eq!(canonical_triangles(&found), canonical_triangles(&expected));
    }
}

/// Checks that adapting to a box gives the same result from the full mesh as from the base.
fn check_detail_boxes(scene: PatternScene<'_>) {
    let patterns = scene.patterns();
    let mut instance = PatternInstance::full(patterns);
    for detail in [
        DetailBox { min: [-1.0; 3], max: [0.5; 3], error_outside: f32::INFINITY },
        DetailBox { min: [9e9; 3], max: [9e9; 3], error_outside: 0.1 },
    ] {
        let condition = CriterionCondition::new(scene, &detail);
        instance.adapt(patterns, &condition);
        let mut fresh = PatternInstance::base(patterns);
        fresh.adapt(patterns, &condition);
        assert_eq!(instance, fresh);
    }
}

/// Moves a front through a few views: every corner must be active, and every triangle counted.
fn check_front(refinable: &RefinableMesh, fans: &Fans) {
    let scene = FanScene::new(fans, &refinable.mesh.positions);
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
        let criterion = ScreenError::new(camera, 0.2).with_silhouettes(0.01).with_model_bounds(sphere);
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
        assert!(step.is_none_or(|step| instance.is_refined(step)), "vertex {vertex} is not active");
    }
    assert_eq!(instance.level(fans, refinable).check(), Ok(()));
}

fn check_strip_levels<M: StripModel>(file: &StriataFile<'_>, model: &M) {
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
        assert_eq!(
            model.strip(&state, strip),
            model.strip(&full, strip),
            "coarsening and refining must restore the strip"
        );
    }
}
