//! The strip baselines against the oracle: both published LodStrips, and skip strips.

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::{IndexedMesh, RefinableMesh, canonical_triangles, replay};
use striata::model::{LodModel, LodStrips, ModelError, Mts};
use striata::strip::{RESTART, StripSet, restart_triangles_into};
use striata_lab::baseline::{EfficientLodStrips, OriginalLodStrips, SkipStrips, Winding};
use striata_lab::{Accounting, PaperBytes};
use striata_strip::{StripOptions, Stripifier, stripify};
use support::{
    Random, RandomSequenceOptions, follows_the_oracle, grid, nasty_cases, random_refinable, seam_cases,
    soups, surface_cases, with_seams_and_groups,
};

/// Greedy strips contain repeated vertices, cheapest ones also joints, and fewest ones are long.
const STRIPIFIERS: [Stripifier; 3] = [Stripifier::Greedy, Stripifier::Cheapest, Stripifier::Fewest];

fn strips_of(refinable: &RefinableMesh, stripifier: Stripifier) -> StripSet {
    stripify(&refinable.mesh, &StripOptions::default().with_stripifier(stripifier)).unwrap()
}

fn models_follow(refinable: &RefinableMesh, strips: &StripSet, stride: usize) {
    follows_the_oracle(refinable, &OriginalLodStrips::build(refinable, strips).unwrap(), stride);
    let skip = SkipStrips::build(refinable, strips).unwrap();
    follows_the_oracle(refinable, &skip, stride);
    nothing_repeats(&skip);
    let published = EfficientLodStrips::build(refinable, strips, Winding::Kept).unwrap();
    follows_the_oracle(refinable, &published, stride);
    let literal = EfficientLodStrips::build(refinable, strips, Winding::Lost).unwrap();
    shows_the_triangles_of_the_oracle(refinable, &literal, stride);
}

/// To the letter of the paper, repetitions are removed without regard to winding: the triangles are those of
/// the oracle, but may face the other way.
fn shows_the_triangles_of_the_oracle(refinable: &RefinableMesh, model: &EfficientLodStrips, stride: usize) {
    let unoriented = |triangles: &[[u32; 3]]| {
        let mut triangles = triangles.to_vec();
        triangles.iter_mut().for_each(|triangle| triangle.sort_unstable());
        triangles.sort_unstable();
        triangles
    };
    let mut state = model.new_state();
    let down = (0..=model.step_count()).rev().step_by(stride);
    for split_count in down.chain((0..=model.step_count()).step_by(stride)) {
        model.move_to(&mut state, split_count);
        let mut found = Vec::new();
        model.triangles_into(&state, &mut found);
        let expected = replay(refinable, split_count).triangles;
        assert_eq!(unoriented(&found), unoriented(&expected), "at {split_count}");
    }
}

fn all_follow(refinable: &RefinableMesh, stride: usize) {
    for stripifier in STRIPIFIERS {
        models_follow(refinable, &strips_of(refinable, stripifier), stride);
    }
}

/// Checks that display strips at several levels contain no repeated pairs.
fn nothing_repeats(model: &SkipStrips) {
    let mut state = model.new_state();
    for percent in [100, 70, 40, 15, 3, 0] {
        model.move_to(&mut state, model.step_count() * percent / 100);
        for strip in 0..model.strip_count() {
            let shown = model.strip(&state, strip);
            assert!(shown.windows(4).all(|w| w[..2] != w[2..]), "strip {strip} at {percent} %: {shown:?}");
        }
    }
}

#[test]
fn nasty_meshes_follow_the_oracle_at_every_level() {
    nasty_cases().for_each(|case| all_follow(&case.refinable, case.stride));
}

#[test]
fn surfaces_follow_the_oracle() {
    surface_cases().for_each(|case| all_follow(&case.refinable, case.stride));
}

#[test]
fn seams_and_groups_follow_the_oracle() {
    seam_cases().for_each(|case| all_follow(&case.refinable, case.stride));
}

#[test]
fn base_of_one_position_follows_the_oracle() {
    // Every strip loses its last triangle before the base.
    let sequence_options = RandomSequenceOptions { far_percent: 20, base_position_count: 1 };
    for seed in 0..4 {
        all_follow(
            &random_refinable(
                &with_seams_and_groups(grid(6, false)),
                sequence_options,
                &mut Random::new(seed),
            ),
            1,
        );
    }
}

#[test]
fn strips_with_joints_and_degenerate_ends_are_used_unchanged() {
    // One strip over a square of four triangles: it turns, joins, and has degenerate triangles at both ends.
    let positions = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]];
    let positions = positions.map(|[x, y]| [x, y, x * y]).to_vec();
    let mesh = IndexedMesh::new(positions, vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]]);
    for seed in 0..40 {
        let sequence_options = RandomSequenceOptions { far_percent: 30, base_position_count: 1 };
        let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(seed));
        let mut strips = StripSet::new();
        let triangles = &refinable.mesh.triangles;
        let mut strip = vec![triangles[0][0]; 4];
        for &[a, b, c] in triangles {
            // Each triangle begins at an even index: its first corner is repeated before it, its last one
            // after it.
            strip.extend([a, a, a, b, c, c]);
        }
        strips.push(&[]);
        strips.push(&strip);
        strips.push(&[0, 1]);
        strips.end_group();
        models_follow(&refinable, &strips, 1);
    }
}

#[test]
fn groups_are_drawn_one_by_one() {
    let mesh = with_seams_and_groups(grid(8, false));
    let sequence_options = RandomSequenceOptions { far_percent: 5, base_position_count: 3 };
    let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(7));
    let strips = strips_of(&refinable, Stripifier::Cheapest);
    let original = OriginalLodStrips::build(&refinable, &strips).unwrap();
    let skip = SkipStrips::build(&refinable, &strips).unwrap();
    let (mut original_state, mut skip_state) = (original.new_state(), skip.new_state());
    assert_eq!([original.group_count(), skip.group_count()], [3; 2]);
    for split_count in (0..=original.step_count()).rev().step_by(5) {
        original.move_to(&mut original_state, split_count);
        skip.move_to(&mut skip_state, split_count);
        let level = replay(&refinable, split_count);
        for (g, group) in level.groups_or_whole().into_iter().enumerate() {
            let (mut from_original, mut from_skip) = (Vec::new(), Vec::new());
            original.group_indices_into(&original_state, g, &mut from_original);
            skip.group_indices_into(&skip_state, g, &mut from_skip);
            assert_eq!(from_original, from_skip, "both remove the same repetitions");
            assert!(from_skip.first() != Some(&RESTART) && from_skip.last() != Some(&RESTART));
            let mut found = Vec::new();
            restart_triangles_into(&from_skip, &mut found);
            let expected = canonical_triangles(&level.triangles[group.range()]);
            assert_eq!(canonical_triangles(&found), expected, "group {g} at {split_count}");
        }
    }
}

#[test]
fn jumps_agree_with_single_steps() {
    let sequence_options = RandomSequenceOptions { far_percent: 3, base_position_count: 4 };
    let refinable = random_refinable(&grid(20, true), sequence_options, &mut Random::new(3));
    let strips = strips_of(&refinable, Stripifier::Cheapest);
    let model = SkipStrips::build(&refinable, &strips).unwrap();
    let (mut jumping, mut stepping) = (model.new_state(), model.new_state());
    for split_count in [0, 90, 17, model.step_count(), 200, 201] {
        model.move_to(&mut jumping, split_count);
        while stepping != jumping {
            let at = model.split_count(&stepping);
            assert_ne!(at, split_count, "at the same level, both show the same");
            model.move_to(&mut stepping, if at < split_count { at + 1 } else { at - 1 });
        }
    }
}

#[test]
fn strips_of_another_mesh_are_rejected() {
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let refinable = random_refinable(&grid(4, false), sequence_options, &mut Random::new(1));
    let assert_rejected = |strips: &StripSet, expected: ModelError| {
        assert_eq!(OriginalLodStrips::build(&refinable, strips).unwrap_err(), expected);
        assert_eq!(SkipStrips::build(&refinable, strips).unwrap_err(), expected);
        let published = EfficientLodStrips::build(&refinable, strips, Winding::Kept);
        assert_eq!(published.unwrap_err(), expected);
    };
    let mut strips = StripSet::new();
    strips.push(&[0, 1, 2, 99]);
    assert_rejected(&strips, ModelError::GroupCount { found: 0, expected: 1 });
    strips.end_group();
    assert_rejected(&strips, ModelError::Vertex { strip: 0, vertex: 99, vertex_count: 25 });
    let mut strips = StripSet::new();
    strips.push(&[0, 1, 2]);
    strips.end_group();
    assert_rejected(&strips, ModelError::TriangleCount { group: 0, found: 1, expected: 32 });
}

#[test]
fn paper_bytes_of_a_small_model_match_manual_counts() {
    // A strip 0 1 2 3 whose vertex 3 collapses to 0: one step, one strip, one slot.
    let positions = (0..4).map(|i| [i as f32, (i * i) as f32, 0.0]).collect();
    let mesh = IndexedMesh::new(positions, vec![[0, 1, 2], [2, 1, 3]]);
    let mut random = Random::new(1);
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 3 };
    let refinable = random_refinable(&mesh, sequence_options, &mut random);
    let strips = strips_of(&refinable, Stripifier::Greedy);
    assert_eq!((strips.strip_count(), strips.indices().len()), (1, 4));
    let slot_count = strips.indices().iter().filter(|&&v| v == 3).count();
    assert_eq!(slot_count, 1);
    let original = OriginalLodStrips::build(&refinable, &strips).unwrap();
    // Four Collapses, a strip of four, a Change, a RecordChange, a slot.
    assert_eq!(original.paper_bytes(Accounting::Words), 4 * (4 + (1 + 4) + 2 + 3 + 1));
    let skip = SkipStrips::build(&refinable, &strips).unwrap();
    // A strip of four slots, four nodes of which one is a child, four vertices, one of which affects a strip.
    assert_eq!(skip.paper_bytes(Accounting::Words), 4 * ((1 + 4) + (4 * 4 + 1) + (3 * 4 + 1)));
    let both =
        |model: &dyn Fn(Accounting) -> usize| [Accounting::Words, Accounting::ShortIntegers].map(model);
    let published = EfficientLodStrips::build(&refinable, &strips, Winding::Kept).unwrap();
    // Four Collapses, four indices, a number of strips, three integers and a slot of a RecordChange; three
    // pointers.
    assert_eq!(published.edit_counts(), [1, 0], "one index repeats nothing, so there is no resize");
    let integers = 4 + 4 + 1 + 3 + 1;
    assert_eq!(both(&|a| published.paper_bytes(a)), [4 * (integers + 3), 2 * integers + 4 * 3]);
    let lod_strips = LodStrips::build(&refinable, &strips).unwrap();
    // Four indices, a target, two counts, a slot; pointers to a strip and a record.
    assert_eq!(strips.indices()[0], 3, "dropping the first index would flip the rest");
    assert_eq!(both(&|a| lod_strips.paper_bytes(a)), [4 * (8 + 2), 2 * 8 + 4 * 2]);
    let mts = Mts::build(&refinable, &strips).unwrap();
    // Four columns of two, a strip of two, a target; one change of a strip.
    let longs = 4 * 2 + 2 + 1;
    assert_eq!(both(&|a| mts.paper_bytes(a)), [4 * (longs + 1), 4 * longs + 2]);
}

#[test]
fn strip_without_triangles_is_not_changed() {
    // One triangle and a base of one position: the first step removes the triangle, the second has nothing
    // to change.
    let mesh = IndexedMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]]);
    for seed in 0..8 {
        let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 1 };
        let refinable = random_refinable(&mesh, sequence_options, &mut Random::new(seed));
        assert_eq!(refinable.sequence.step_count(), 2);
        let strips = strips_of(&refinable, Stripifier::Greedy);
        let original = OriginalLodStrips::build(&refinable, &strips).unwrap();
        // Three Collapses, a strip of three, two Changes, one RecordChange with one slot.
        assert_eq!(original.paper_bytes(Accounting::Words), 4 * (3 + (1 + 3) + 2 * 2 + (3 + 1)));
        let skip = SkipStrips::build(&refinable, &strips).unwrap();
        // A strip of three slots, three nodes of which one is a child, three vertices, one of which
        // affects a strip.
        assert_eq!(skip.paper_bytes(Accounting::Words), 4 * ((1 + 3) + (4 * 3 + 1) + (3 * 3 + 1)));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_meshes_follow_the_oracle_at_every_level(case in soups()) {
        all_follow(&case.refinable, case.stride);
    }
}
