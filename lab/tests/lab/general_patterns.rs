//! The published pattern model with rules for any ceiling, against the oracle: uniform levels, closed sets and
//! conditions, for removals, half-edge collapses, and edges and triangles collapsed to new vertices.

use striata_testing::support;

use std::collections::BTreeSet;

use striata::mesh::{FragmentSequence, FragmentedMesh, shapes};
use striata::model::{LodModel, ModelError, Overlap, PatternInstance, Patterns, StoredModel};
use striata::simplify::{
    PlacedCollapse, PlacedOptions, SequenceOptions, TopologyRule, build_placed_fragments,
};
use striata_lab::baseline::{GeneralPatterns, LoopPatterns};
use striata_lab::{Accounting, PaperBytes};
use support::{Random, assert_shows_set, follows_the_fragments, fragment_cases, grid, random_closed_set};

/// Surfaces whose edges or triangles are collapsed to new vertices, down to a few triangles.
fn placed_cases() -> impl Iterator<Item = FragmentedMesh> {
    let meshes =
        [shapes::icosphere(3, 1.0), shapes::torus(13, 11, 2.0, 0.8), shapes::terrain(12, 4), grid(8, false)];
    meshes.into_iter().flat_map(|mesh| {
        [PlacedCollapse::Edge, PlacedCollapse::Triangle].map(|collapse| {
            let sequence = SequenceOptions::default()
                .with_topology(TopologyRule::Keep)
                .with_base_triangle_count(mesh.triangle_count() / 12);
            let options = PlacedOptions::default().with_collapse(collapse).with_sequence(sequence);
            build_placed_fragments(&mesh, &options).unwrap().fragmented
        })
    })
}

/// Removals with any triangulation.
fn removed_cases() -> impl Iterator<Item = FragmentedMesh> {
    fragment_cases().map(|case| case.1).filter(|mesh| GeneralPatterns::build(mesh).is_ok())
}

#[test]
fn every_level_follows_the_oracle() {
    assert!(removed_cases().count() > 3);
    for mesh in placed_cases().chain(removed_cases().take(6)) {
        let model = GeneralPatterns::build(&mesh).unwrap();
        assert!(model.rule_count() > 1 && model.step_count() > 4);
        follows_the_fragments(&mesh, &model, 3);
    }
}

#[test]
fn closed_sets_are_shown_from_any_previous_set() {
    for mesh in placed_cases().chain(removed_cases().take(6)) {
        let model = GeneralPatterns::build(&mesh).unwrap();
        let patterns = Patterns::build_without_bounds(&mesh).unwrap();
        let mut random = Random::new(3);
        let mut state = model.new_state();
        let mut ours = PatternInstance::base(&patterns);
        for percent in [2, 30, 8, 70, 0, 15, 100, 4, 1, 50] {
            let set = random_closed_set(&mesh.fragments, percent, &mut random);
            let before = state.split_count();
            let condition = |overlap: Overlap| set[overlap.upper as usize];
            let change = model.adapt(&mut state, &condition);
            assert_eq!(before + change.inserted - change.removed, state.split_count());
            assert!((0..set.len()).all(|step| state.is_refined(step as u32) == set[step]));
            let mut shown = Vec::new();
            model.group_triangles_into(&state, 0, &mut shown);
            assert_eq!(shown.len(), state.triangle_count());
            assert_shows_set(&mesh.fragments, &shown, |step| set[step as usize]);
            // Both models need the same fragments for the same condition.
            let salt = percent as u32;
            let scattered = |overlap: Overlap| {
                let name = overlap.upper << 9 ^ overlap.lower.unwrap_or(1 << 8) ^ salt << 20;
                name.wrapping_mul(2_654_435_761) >> 24 < 40
            };
            model.adapt(&mut state, &scattered);
            ours.adapt(&patterns, &scattered);
            assert!((0..set.len() as u32).all(|step| state.is_refined(step) == ours.is_refined(step)));
        }
    }
}

#[test]
fn loops_contain_the_overlapping_fragments() {
    for mesh in placed_cases() {
        let fragments = &mesh.fragments;
        let model = GeneralPatterns::build(&mesh).unwrap();
        let replaced_by = fragments.replacing_steps();
        let mut count = 0;
        for step in 0..fragments.step_count() as u32 {
            let below: BTreeSet<u32> = model.covered(step).collect();
            let makers = fragments.floor(step).iter().filter_map(|&face| fragments.creating_step(face));
            assert_eq!(below, makers.collect());
            let above: BTreeSet<u32> = model.covering(step).collect();
            let covers = fragments.ceiling(step).map(|face| replaced_by[face as usize]);
            assert_eq!(above, covers.filter(|&cover| cover != FragmentSequence::NO_STEP).collect());
            count += above.len();
        }
        assert_eq!(model.overlap_count(), count);
    }
}

/// With fans as ceilings, both published forms have the same overlaps, apart from triangles that are attached by
/// one edge, and similar sizes.
#[test]
fn the_general_form_agrees_with_that_of_removals() {
    for mesh in removed_cases() {
        let (general, of_fans) =
            (GeneralPatterns::build(&mesh).unwrap(), LoopPatterns::build(&mesh).unwrap());
        assert!(general.overlap_count() <= of_fans.overlap_count());
        assert!(general.paper_bytes(Accounting::Words) >= of_fans.paper_bytes(Accounting::Words));
        let bytes =
            |parts: Vec<striata::model::PartBytes>| parts.iter().map(|part| part.bytes).sum::<usize>();
        assert!(bytes(general.bytes()) < 2 * bytes(of_fans.bytes()));
    }
}

#[test]
fn groups_are_refused() {
    let mesh = support::with_seams_and_groups(grid(6, false));
    let built = build_placed_fragments(&mesh, &PlacedOptions::default()).unwrap().fragmented;
    assert!(matches!(GeneralPatterns::build(&built), Err(ModelError::Form { .. })));
}
