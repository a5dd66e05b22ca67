//! From a mesh to a file and back: strips, LodStrips and `.striata` on sequences of the simplifier.

use striata_testing::meshes;

use meshes::{NamedMesh, all, check_each};
use proptest::prelude::*;
use striata::file::{FileModel, StriataFile, Verify, WriteOptions, to_striata};
use striata::mesh::{IndexedMesh, RefinableMesh, canonical_triangles, replay, shapes};
use striata::model::{LodModel, LodStrips, LodStripsState, StoredModel, StripBuffer, StripModel};
use striata::simplify::{SequenceOptions, build_sequence};
use striata::strip::{StripSet, restart_triangles_into, stripify};

fn build(mesh: &IndexedMesh, options: &SequenceOptions) -> RefinableMesh {
    build_sequence(mesh, options).expect("valid meshes can be simplified").refinable
}

fn strips_of(refinable: &RefinableMesh) -> StripSet {
    stripify(&refinable.mesh).expect("full meshes are valid")
}

/// Returns the triangles of each group in canonical order.
fn triangles_by_group(mesh: &IndexedMesh) -> Vec<Vec<[u32; 3]>> {
    mesh.groups_or_whole().iter().map(|g| canonical_triangles(&mesh.triangles[g.range()])).collect()
}

/// Compares the model and its buffer with the oracle, group by group.
fn check_level(
    refinable: &RefinableMesh,
    model: &LodStrips<'_>,
    state: &mut LodStripsState,
    buffer: &mut StripBuffer,
) {
    let expected = triangles_by_group(&replay(refinable, state.split_count()));
    buffer.sync(model, state);
    assert_eq!(model.group_count(), expected.len());
    for ((g, expected), range) in expected.iter().enumerate().zip(buffer.group_ranges()) {
        let mut shown = Vec::new();
        model.group_triangles_into(state, g, &mut shown);
        assert_eq!(&canonical_triangles(&shown), expected, "group {g} at {}", state.split_count());
        let mut drawn = Vec::new();
        restart_triangles_into(&buffer.indices()[range.start as usize..range.end as usize], &mut drawn);
        assert_eq!(&canonical_triangles(&drawn), expected, "buffer of group {g} at {}", state.split_count());
    }
}

#[test]
fn lod_strips_equal_the_oracle_at_every_level_both_ways() {
    check_each(all(), |_, mesh, options| {
        let refinable = build(mesh, options);
        let model = LodStrips::build(&refinable, &strips_of(&refinable)).expect("the strips are the mesh's");
        let full = model.new_state();
        let mut state = full.clone();
        let mut buffer = StripBuffer::new(&model, &mut state);
        for split_count in (0..=model.step_count()).rev().chain(1..=model.step_count()) {
            model.move_to(&mut state, split_count);
            check_level(&refinable, &model, &mut state, &mut buffer);
        }
        for strip in 0..model.strip_count() {
            assert_eq!(model.strip(&state, strip), model.strip(&full, strip), "strip {strip} is back");
        }
    });
}

/// Compares meshes up to the order of triangles within their groups.
fn assert_same(found: &IndexedMesh, expected: &IndexedMesh) {
    assert_eq!(found.positions, expected.positions);
    assert_eq!(found.groups, expected.groups);
    assert_eq!(found.appearance, expected.appearance);
    assert_eq!(found.layers.len(), expected.layers.len());
    for (found, expected) in found.layers.iter().zip(&expected.layers) {
        assert_eq!(found.semantic, expected.semantic);
        // Compared as bytes, because some attributes are NaN.
        assert_eq!(found.data.as_bytes(), expected.data.as_bytes());
    }
    assert_eq!(triangles_by_group(found), triangles_by_group(expected));
}

#[test]
fn files_hold_every_level() {
    check_each(all(), |_, mesh, options| {
        let refinable = build(mesh, options);
        let model = LodStrips::build(&refinable, &strips_of(&refinable)).expect("the strips are the mesh's");
        let bytes = to_striata(&refinable, &[FileModel::LodStrips(&model)], &WriteOptions::default())
            .expect("memory does not fail");
        let file = StriataFile::parse_with(&bytes, Verify::All).expect("written just now");
        let found = file.refinable_mesh().expect("written just now");
        assert_same(&found.mesh, &refinable.mesh);
        assert_eq!(found.sequence, refinable.sequence);
        let stored = file.lod_strips().expect("it was written").expect("it is valid");
        assert_eq!(stored, model);
        let mut state = stored.new_state();
        let step_count = stored.step_count();
        for split_count in (0..=step_count).rev().step_by(1 + step_count / 40).chain([0, step_count]) {
            stored.move_to(&mut state, split_count);
            let level = file.level_of(&stored, &state).expect("the file is valid");
            assert_same(&level, &replay(&refinable, split_count));
        }
    });
}

#[test]
fn files_without_strips_keep_the_order_of_triangles() {
    check_each(all(), |_, mesh, options| {
        let refinable = build(mesh, options);
        let bytes = to_striata(&refinable, &[], &WriteOptions::default()).expect("memory does not fail");
        let found =
            StriataFile::parse(&bytes).and_then(|file| file.refinable_mesh()).expect("written just now");
        assert_same(&found.mesh, &refinable.mesh);
        assert_eq!(found.mesh.triangles, refinable.mesh.triangles);
        assert_eq!(found.sequence, refinable.sequence);
    });
}

#[test]
fn large_surfaces_follow_the_oracle_at_a_spread_of_levels() {
    let meshes: Vec<NamedMesh> = vec![
        ("terrain".to_owned(), shapes::terrain(90, 3)),
        ("sphere of two materials".to_owned(), shapes::two_material_sphere(50, 80)),
    ];
    check_each(meshes, |_, mesh, options| {
        let refinable = build(mesh, options);
        let model = LodStrips::build(&refinable, &strips_of(&refinable)).expect("the strips are the mesh's");
        let mut state = model.new_state();
        let mut buffer = StripBuffer::new(&model, &mut state);
        let step_count = model.step_count();
        for jump in [0, 7, 1, 5, 2, 8, 3, 6, 4] {
            model.move_to(&mut state, step_count * jump / 8);
            check_level(&refinable, &model, &mut state, &mut buffer);
        }
    });
}

proptest! {
    #![proptest_config(striata_testing::cases(32))]

    #[test]
    fn random_soups_in_patches_go_all_the_way(count in 1u32..120, run in 1usize..9, seed: u64) {
        let mesh = meshes::with_patches(shapes::random_soup(count, seed), run);
        let refinable = build(&mesh, &SequenceOptions::default());
        let model = LodStrips::build(&refinable, &strips_of(&refinable)).expect("the strips are the mesh's");
        let mut state = model.new_state();
        let mut buffer = StripBuffer::new(&model, &mut state);
        for split_count in (0..=model.step_count()).rev() {
            model.move_to(&mut state, split_count);
            check_level(&refinable, &model, &mut state, &mut buffer);
        }
    }
}
