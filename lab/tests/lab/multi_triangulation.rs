//! The explicit Multi-Triangulation against the oracle: uniform levels, closed sets, and the smallest set
//! for any condition.

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::{FragmentSequence, FragmentedMesh, canonical_triangles};
use striata::model::{LodModel, PatternChange, Patterns, StoredModel};
use striata_lab::baseline::{MtQuery, MultiTriangulation, MultiTriangulationState};
use striata_lab::{Accounting, PaperBytes};
use support::{
    Case, Random, assert_shows_set, closed_sets, follows_the_fragments, fragment_cases, grid, hub_cases,
    nasty_cases, random_closed_set, random_removals, seam_cases, smallest_set, soup, soups, surface_cases,
};

fn fragmented(case: &Case) -> FragmentedMesh {
    FragmentedMesh::from_collapses(&case.refinable)
}

fn has_the_patterns_of(mesh: &FragmentedMesh, model: &MultiTriangulation) {
    assert_eq!(model.to_patterns().unwrap(), Patterns::build_without_bounds(mesh).unwrap());
}

#[test]
fn all_kinds_of_collapses_follow_the_oracle() {
    let cases = nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases());
    for case in cases {
        let mesh = fragmented(&case);
        let model = MultiTriangulation::build(&mesh);
        follows_the_fragments(&mesh, &model, case.stride);
        has_the_patterns_of(&mesh, &model);
    }
}

#[test]
fn removals_with_any_triangulation_follow_the_oracle() {
    for (_, mesh) in fragment_cases() {
        let model = MultiTriangulation::build(&mesh);
        follows_the_fragments(&mesh, &model, 1);
        has_the_patterns_of(&mesh, &model);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 160, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn soups_have_the_patterns_of_their_fragments(case in soups()) {
        let mesh = fragmented(&case);
        has_the_patterns_of(&mesh, &MultiTriangulation::build(&mesh));
    }
}

#[test]
fn groups_and_vertex_counts_of_levels_are_right() {
    for case in seam_cases() {
        let mesh = fragmented(&case);
        let model = MultiTriangulation::build(&mesh);
        assert_eq!((model.group_count(), model.vertex_count()), (3, mesh.mesh.vertex_count()));
        let mut state = model.new_state();
        for split_count in (0..=model.step_count()).step_by(7) {
            model.move_to(&mut state, split_count);
            let level = striata::mesh::replay_fragments(&mesh, split_count);
            assert_eq!(model.vertex_count_at(split_count), level.vertex_count());
            for (group, range) in level.groups.iter().enumerate() {
                let mut found = vec![[9; 3]];
                model.group_triangles_into(&state, group, &mut found);
                let expected = canonical_triangles(&level.triangles[range.range()]);
                assert_eq!(canonical_triangles(&found[1..]), expected);
            }
        }
    }
}

/// A pseudorandom number that depends only on a query and a seed.
fn chance(query: MtQuery, seed: u64) -> u64 {
    let triangle = query.triangle.map_or(1 << 40, u64::from);
    let mixed = (triangle << 20 ^ u64::from(query.upper) ^ seed << 45).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (mixed ^ mixed >> 29).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 40
}

/// A condition that considers some percentage of all triangles too coarse, independently of their position.
fn scattered(percent: u64, seed: u64) -> impl Fn(MtQuery) -> bool {
    move |query| chance(query, seed) % 100 < percent
}

/// A condition under which a closed set of steps is required: no triangle is too coarse unless those below
/// it are.
fn monotone(is_required: &[bool]) -> impl Fn(MtQuery) -> bool {
    |query| is_required[query.upper as usize]
}

fn set_of(model: &MultiTriangulation, state: &MultiTriangulationState) -> u32 {
    let inserted = (0..model.step_count() as u32).filter(|&step| state.is_refined(step));
    inserted.fold(0, |set, step| set | 1 << step)
}

/// Small sets of fragments: surfaces with free triangulations, and triangle soups with random collapses.
fn small_cases() -> impl Iterator<Item = FragmentedMesh> {
    let surfaces = (0..40).map(|seed| {
        let mesh = grid(3 + seed as usize % 2, seed % 3 == 0);
        random_removals(&mesh, 12, &mut Random::new(seed + 1))
    });
    let soups = (0..20).map(|seed| {
        let mesh = soup(13, 8 + seed as usize * 2, &mut Random::new(seed + 1));
        let sequence_options = support::RandomSequenceOptions { far_percent: 20, base_position_count: 3 };
        let refinable = support::random_refinable(&mesh, sequence_options, &mut Random::new(seed + 3));
        FragmentedMesh::from_collapses(&refinable)
    });
    surfaces.chain(soups).filter(|mesh| mesh.fragments.step_count() <= 12)
}

#[test]
fn any_condition_leads_to_the_smallest_set_from_anywhere() {
    let mut sizes = [0; 13];
    for (seed, mesh) in small_cases().enumerate() {
        let model = MultiTriangulation::build(&mesh);
        let sets = closed_sets(&mesh.fragments);
        let mut state = model.new_state();
        for round in 0..60 {
            let condition = scattered([5, 20, 50, 80][round % 4], (seed * 100 + round) as u64);
            let evaluate = |triangle, upper| condition(MtQuery { triangle, upper });
            let expected = smallest_set(&mesh.fragments, &sets, evaluate);
            model.adapt(&mut state, &condition);
            assert_eq!(set_of(&model, &state), expected, "mesh {seed}, round {round}");
            assert_shows_set(&mesh.fragments, state.triangles(), |step| expected >> step & 1 == 1);
            assert_eq!(model.adapt(&mut state, &condition), PatternChange::default());
            sizes[expected.count_ones() as usize] += 1;
        }
    }
    assert!(sizes[1..11].iter().all(|&count| count > 10), "sets of each size {sizes:?}");
}

#[test]
fn coarsening_and_refining_reach_the_same_set_for_monotone_conditions() {
    for (seed, mesh) in fragment_cases() {
        let fragments = &mesh.fragments;
        let model = MultiTriangulation::build(&mesh);
        let mut random = Random::new(seed + 9);
        let (mut adapted, mut walked) = (model.base_state(), model.new_state());
        for percent in [2, 30, 8, 70, 0, 15, 100, 4] {
            let set = random_closed_set(fragments, percent, &mut random);
            let condition = monotone(&set);
            let before = walked.split_count();
            let removed = model.coarsen(&mut walked, &condition);
            let added = model.refine(&mut walked, &condition);
            assert_eq!(before + added - removed, walked.split_count());
            model.adapt(&mut adapted, &condition);
            assert!(adapted == walked, "another set, seed {seed}, {percent} percent");
            assert_shows_set(fragments, adapted.triangles(), |step| set[step as usize]);
            assert!((0..set.len()).all(|step| adapted.is_refined(step as u32) == set[step]));
        }
    }
}

#[test]
fn refining_leaves_nothing_too_coarse_for_any_condition() {
    for (seed, mesh) in fragment_cases() {
        let model = MultiTriangulation::build(&mesh);
        let (mut state, mut smallest) = (model.base_state(), model.base_state());
        for round in 0..6 {
            let condition = scattered([3, 40, 10][round % 3], seed * 10 + round as u64);
            model.coarsen(&mut state, &condition);
            model.refine(&mut state, &condition);
            model.adapt(&mut smallest, &condition);
            assert_shows_set(&mesh.fragments, state.triangles(), |step| state.is_refined(step));
            for shown in [&state, &smallest] {
                for &index in shown.triangle_indices() {
                    let upper = model.triangles()[index as usize].upper;
                    let query = MtQuery { triangle: Some(index), upper };
                    assert!(upper == FragmentSequence::NO_STEP || !condition(query));
                }
            }
            let steps = 0..model.step_count() as u32;
            assert!(steps.clone().all(|step| !smallest.is_refined(step) || state.is_refined(step)));
        }
        model.move_to(&mut state, model.step_count() / 2);
        assert_eq!(model.split_count(&state), model.step_count() / 2);
        assert_shows_set(&mesh.fragments, state.triangles(), |step| (step as usize) < model.step_count() / 2);
    }
}

#[test]
fn inserting_a_fragment_inserts_its_prerequisites() {
    for (_, mesh) in fragment_cases().step_by(3) {
        let model = MultiTriangulation::build(&mesh);
        for step in (0..model.step_count() as u32).step_by(5) {
            let mut state = model.base_state();
            let count = model.insert(&mut state, step);
            assert_eq!((count, model.insert(&mut state, step)), (state.split_count(), 0));
            let top = (0..model.step_count() as u32).rev().find(|&step| state.is_refined(step));
            assert_eq!(top, Some(step), "nothing finer is needed");
            assert_shows_set(&mesh.fragments, state.triangles(), |step| state.is_refined(step));
        }
    }
}

#[test]
fn bytes_match_the_arrays_and_the_paper() {
    let mesh = random_removals(&grid(12, true), usize::MAX, &mut Random::new(5));
    let model = MultiTriangulation::build(&mesh);
    let (steps, triangles) = (model.step_count(), model.triangles().len());
    let count = |list: fn(&MultiTriangulation, u32) -> usize| {
        (0..steps as u32).map(|step| list(&model, step)).sum::<usize>()
    };
    let [ceilings, floors] = [count(|m, s| m.ceiling(s).len()), count(|m, s| m.floor(s).len())];
    // All rings are closed.
    assert_eq!(floors + 2 * steps, ceilings);
    let bytes: Vec<usize> = model.bytes().iter().map(|part| part.bytes).collect();
    let lists = [ceilings, floors].map(|entries| 4 * (entries + steps + 1));
    assert_eq!(bytes, [20 * triangles, lists[0], lists[1], 4 * steps, 0, 0]);
    for accounting in [Accounting::Words, Accounting::ShortIntegers] {
        assert_eq!(model.paper_bytes(accounting), 20 * triangles + 4 * (ceilings + floors));
    }
    let per_vertex = model.paper_bytes(Accounting::Words) as f64 / mesh.mesh.vertex_count() as f64;
    assert!((145.0..=160.0).contains(&per_vertex), "{per_vertex} bytes per vertex");
    let state = model.base_state();
    let own = 16 * model.base_triangle_count() + 4 * (triangles + steps) + 5 * steps;
    assert_eq!(model.state_bytes(&state), own);
}
