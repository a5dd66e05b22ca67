//! The published MTS against the oracle, and against the library's form, which shows the same strips.

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::RefinableMesh;
use striata::model::mts::MAX_STRIP_INDICES;
use striata::model::{LodModel, ModelError, Mts};
use striata::strip::{RESTART, StripSet};
use striata_lab::MtsGraph;
use striata_strip::{StripOptions, Stripifier, stripify};
use support::{
    Random, RandomSequenceOptions, follows_the_oracle, grid, hub_cases, nasty_cases, random_refinable,
    seam_cases, soups, surface_cases,
};

/// Greedy strips, or strips that are joined where ends meet at a vertex.
fn strips_of(refinable: &RefinableMesh, has_joints: bool) -> StripSet {
    let stripifier = if has_joints { Stripifier::Cheapest } else { Stripifier::Greedy };
    stripify(&refinable.mesh, &StripOptions::default().with_stripifier(stripifier)).unwrap()
}

/// Checks that the graph follows the oracle at every level, and that both forms show the same indices,
/// strip by strip.
fn check_both(refinable: &RefinableMesh, has_joints: bool, stride: usize) {
    let strips = strips_of(refinable, has_joints);
    let mts = Mts::build(refinable, &strips).unwrap();
    follows_the_oracle(refinable, &MtsGraph::build(refinable, &strips).unwrap(), stride);
    let graph = MtsGraph::build(refinable, &strips.cut(MAX_STRIP_INDICES)).unwrap();
    let (mut state, mut graph_state) = (mts.new_state(), graph.new_state());
    for split_count in (0..=refinable.sequence.step_count()).rev().step_by(stride) {
        mts.move_to(&mut state, split_count);
        graph.move_to(&mut graph_state, split_count);
        let shown = |indices: &[u32]| {
            let mut strips: Vec<Vec<u32>> = indices.split(|&i| i == RESTART).map(<[u32]>::to_vec).collect();
            strips.sort_unstable();
            strips
        };
        let mut indices = Vec::new();
        mts.indices_into(&state, &mut indices);
        // The order of strips differs.
        assert_eq!(shown(&indices), shown(graph_state.indices()), "strips at {split_count}");
    }
}

#[test]
fn nasty_meshes_follow_the_oracle_at_every_level() {
    nasty_cases().for_each(|case| check_both(&case.refinable, case.seed % 2 == 0, case.stride));
}

#[test]
fn surfaces_follow_the_oracle() {
    surface_cases().for_each(|case| check_both(&case.refinable, case.seed % 2 == 0, case.stride));
}

#[test]
fn seams_and_groups_follow_the_oracle() {
    seam_cases().for_each(|case| check_both(&case.refinable, case.seed < 2, case.stride));
}

#[test]
fn hub_vertices_follow_the_oracle() {
    hub_cases().for_each(|case| check_both(&case.refinable, false, case.stride));
}

#[test]
fn strips_of_another_mesh_are_rejected() {
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let refinable = random_refinable(&grid(4, false), sequence_options, &mut Random::new(1));
    let mut strips = StripSet::new();
    strips.push(&[0, 1, 2, 99]);
    let expected = ModelError::GroupCount { found: 0, expected: 1 };
    assert_eq!(MtsGraph::build(&refinable, &strips).unwrap_err(), expected);
    strips.end_group();
    let expected = ModelError::Vertex { strip: 0, vertex: 99, vertex_count: 25 };
    assert_eq!(MtsGraph::build(&refinable, &strips).unwrap_err(), expected);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_meshes_follow_the_oracle_at_every_level(case in soups(), has_joints in any::<bool>()) {
        check_both(&case.refinable, has_joints, case.stride);
    }
}
