//! LodStrips against the oracle: the same triangles at every level, as strips and as a buffer, and exact
//! inverses.

use striata_testing::support;

use std::ops::Range;

use proptest::prelude::*;
use striata::mesh::{IndexedMesh, RefinableMesh, canonical_triangles, replay, shapes};
use striata::model::{
    LodModel, LodStrips, LodStripsState, ModelError, StageOptions, StoredModel, StripBuffer, StripModel,
};
use striata::simplify::build_sequence;
use striata::strip::{RESTART, StripSet, restart_triangles_into, stripify};
use support::{
    Random, RandomSequenceOptions, grid, hub_cases, nasty_cases, random_refinable, seam_cases, soups,
    surface_cases,
};

fn build(refinable: &RefinableMesh) -> LodStrips<'static> {
    let strips = stripify(&refinable.mesh).unwrap();
    LodStrips::build(refinable, &strips).unwrap()
}

/// Builds stages wherever a level would need more than this many indices per triangle.
fn build_staged(refinable: &RefinableMesh, limit: f64) -> LodStrips<'static> {
    let strips = stripify(&refinable.mesh).unwrap();
    let options = StageOptions::default().with_max_indices_per_triangle(limit);
    LodStrips::build_staged(refinable, &strips, &options, stripify_level).unwrap()
}

fn stripify_level(level: &IndexedMesh) -> Result<StripSet, ModelError> {
    Ok(stripify(level).unwrap())
}

/// A copy of the buffer as a renderer would keep it, receiving only changed ranges.
struct Uploaded {
    buffer: StripBuffer,
    copy: Vec<u32>,
}

impl Uploaded {
    fn follow(&mut self, model: &LodStrips<'_>, state: &mut LodStripsState) {
        self.buffer.sync(model, state);
        for range in self.buffer.take_changed_ranges() {
            let range = range.start as usize..range.end as usize;
            self.copy[range.clone()].copy_from_slice(&self.buffer.indices()[range]);
        }
        assert!(self.buffer.take_changed_ranges().is_empty());
    }

    fn triangles(&self, range: Range<u32>) -> Vec<[u32; 3]> {
        let mut out = Vec::new();
        restart_triangles_into(&self.copy[range.start as usize..range.end as usize], &mut out);
        canonical_triangles(&out)
    }
}

/// Compares a level with the oracle, group by group: strips, uploaded buffer, multi-draw ranges.
fn check_level(
    refinable: &RefinableMesh,
    model: &LodStrips<'_>,
    state: &mut LodStripsState,
    uploaded: &mut Uploaded,
) {
    let split_count = state.split_count();
    let level = replay(refinable, split_count);
    uploaded.follow(model, state);
    let ranges: Vec<_> = uploaded.buffer.group_ranges().collect();
    assert_eq!(model.vertex_count_at(split_count), level.vertex_count());
    for (g, group) in level.groups_or_whole().into_iter().enumerate() {
        let expected = canonical_triangles(&level.triangles[group.range()]);
        let mut found = Vec::new();
        model.group_triangles_into(state, g, &mut found);
        assert_eq!(canonical_triangles(&found), expected, "strips of group {g} at {split_count}");
        assert_eq!(uploaded.triangles(ranges[g].clone()), expected, "buffer of group {g} at {split_count}");
    }
    let (mut drawn, mut shown) = (Vec::new(), Vec::new());
    model.indices_into(state, &mut drawn);
    assert_eq!(drawn.len(), model.draw_counts(state).index_count);
    model.triangles_into(state, &mut shown);
    assert_eq!(canonical_triangles(&shown), canonical_triangles(&level.triangles));
    let mut all = Vec::new();
    for range in uploaded.buffer.strip_ranges() {
        let strip = &uploaded.copy[range.start as usize..range.end as usize];
        assert!(!strip.contains(&RESTART));
        restart_triangles_into(strip, &mut all);
    }
    assert_eq!(canonical_triangles(&all), canonical_triangles(&level.triangles));
}

/// Checks models with one stage, with few, and with many.
fn check_all_levels(refinable: &RefinableMesh, stride: usize) {
    check_model(refinable, &build(refinable), stride);
    check_model(refinable, &build_staged(refinable, 1.5), stride);
    check_model(refinable, &build_staged(refinable, 0.0), stride);
}

/// Moves down and up by `stride`, checks each level, and checks that moving up restores the original state.
fn check_model(refinable: &RefinableMesh, model: &LodStrips<'_>, stride: usize) {
    let full = model.new_state();
    let mut state = full.clone();
    let buffer = StripBuffer::new(model, &mut state);
    let mut uploaded = Uploaded { copy: buffer.indices().to_vec(), buffer };
    uploaded.buffer.take_changed_ranges();
    let step_count = model.step_count();
    let mut seen = Vec::new();
    for split_count in (0..=step_count).rev().step_by(stride) {
        model.move_to(&mut state, split_count);
        check_level(refinable, model, &mut state, &mut uploaded);
        seen.push(state.clone());
    }
    for expected in seen.into_iter().rev() {
        model.move_to(&mut state, expected.split_count());
        check_level(refinable, model, &mut state, &mut uploaded);
        for strip in 0..model.strip_count() {
            assert_eq!(model.strip(&state, strip), model.strip(&expected, strip));
        }
        assert_eq!(state, expected, "up and down again is the same state, byte by byte");
    }
    assert_eq!(state, full);
}

#[test]
fn nasty_meshes_follow_the_oracle_at_every_level() {
    nasty_cases().for_each(|case| check_all_levels(&case.refinable, case.stride));
}

#[test]
fn surfaces_follow_the_oracle() {
    surface_cases().for_each(|case| check_all_levels(&case.refinable, case.stride));
}

#[test]
fn seams_and_groups_follow_the_oracle() {
    seam_cases().for_each(|case| check_all_levels(&case.refinable, case.stride));
}

#[test]
fn a_vertex_in_many_strips_makes_a_long_record() {
    hub_cases().for_each(|case| check_all_levels(&case.refinable, case.stride));
}

#[test]
fn every_level_of_stages_stays_within_the_limit() {
    let refinable = build_sequence(&shapes::torus(60, 40, 1.0, 0.4), &Default::default()).unwrap().refinable;
    let step_count = refinable.sequence.step_count();
    let model = build_staged(&refinable, 1.45);
    let starts: Vec<usize> = model.stage_split_counts().collect();
    assert!(starts.len() > 4 && starts[0] == step_count && starts.is_sorted_by(|a, b| a > b), "{starts:?}");
    let single = build(&refinable);
    assert_eq!(single.stage_split_counts().collect::<Vec<_>>(), [step_count]);
    let (mut state, mut single_state) = (model.new_state(), single.new_state());
    assert_eq!(state.bytes(), single_state.bytes(), "later stages take no memory at full detail");
    for split_count in (0..=step_count).rev() {
        let triangle_count = refinable.sequence.triangle_count_at(split_count);
        model.move_to(&mut state, split_count);
        single.move_to(&mut single_state, split_count);
        let [staged, single] = [model.draw_counts(&state), single.draw_counts(&single_state)];
        assert!(staged.index_count <= single.index_count, "at {split_count}");
        // A handful of triangles need more in any case.
        if triangle_count >= 60 {
            let limit = 1.45 * triangle_count as f64;
            assert!(staged.index_count as f64 <= limit, "{} of {triangle_count}", staged.index_count);
        }
        let stage = starts.partition_point(|&start| start >= split_count) - 1;
        assert_eq!(state.stage(), stage, "at {split_count}");
    }
}

#[test]
fn errors_of_stripifiers_are_passed_on() {
    let refinable = build_sequence(&shapes::torus(20, 20, 1.0, 0.4), &Default::default()).unwrap().refinable;
    let strips = stripify(&refinable.mesh).unwrap();
    let build = |stages: fn(&IndexedMesh) -> Result<StripSet, ModelError>| {
        LodStrips::build_staged(&refinable, &strips, &StageOptions::default(), stages).unwrap_err()
    };
    let failure = ModelError::Strip { strip: 7, reason: "failed" };
    assert_eq!(build(|_| Err(ModelError::Strip { strip: 7, reason: "failed" })), failure);
    let error = build(|_| Ok(StripSet::new()));
    assert_eq!(error, ModelError::GroupCount { found: 0, expected: 1 });
    let error = build(|level| {
        let mut strips = stripify(level).unwrap();
        strips.push(&[0, 1, 2]);
        strips.end_group();
        Ok(strips)
    });
    assert_eq!(error, ModelError::GroupCount { found: 2, expected: 1 });
    let error = build(|_| {
        let mut strips = StripSet::new();
        strips.push(&[0, 1, 2]);
        strips.end_group();
        Ok(strips)
    });
    assert!(matches!(error, ModelError::TriangleCount { group: 0, found: 1, .. }), "{error:?}");
}

#[test]
fn strips_of_another_mesh_are_rejected() {
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let refinable = random_refinable(&grid(4, false), sequence_options, &mut Random::new(1));
    let mut strips = StripSet::new();
    strips.push(&[0, 1, 2, 99]);
    let error = LodStrips::build(&refinable, &strips).unwrap_err();
    assert_eq!(error, ModelError::GroupCount { found: 0, expected: 1 });
    strips.end_group();
    let error = LodStrips::build(&refinable, &strips).unwrap_err();
    assert_eq!(error, ModelError::Vertex { strip: 0, vertex: 99, vertex_count: 25 });
    let mut strips = StripSet::new();
    strips.push(&[0, 1, 2]);
    strips.end_group();
    let error = LodStrips::build(&refinable, &strips).unwrap_err();
    assert_eq!(error, ModelError::TriangleCount { group: 0, found: 1, expected: 32 });
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(96) })]

    #[test]
    fn random_meshes_follow_the_oracle_at_every_level(case in soups()) {
        check_all_levels(&case.refinable, case.stride);
    }

    #[test]
    fn any_walk_between_levels_shows_the_oracle(
        seed in any::<u64>(),
        jumps in prop::collection::vec(0.0f64..=1.0, 1..20),
    ) {
        let sequence_options = RandomSequenceOptions { far_percent: 3, base_position_count: 4 };
        let refinable = random_refinable(&grid(16, true), sequence_options, &mut Random::new(seed));
        let model = if seed % 2 == 0 { build(&refinable) } else { build_staged(&refinable, 1.4) };
        let mut state = model.new_state();
        let buffer = StripBuffer::new(&model, &mut state);
        let mut uploaded = Uploaded { copy: buffer.indices().to_vec(), buffer };
        for jump in jumps {
            model.move_to(&mut state, (jump * model.step_count() as f64) as usize);
            check_level(&refinable, &model, &mut state, &mut uploaded);
        }
    }
}
