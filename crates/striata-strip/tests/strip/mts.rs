//! MTS against the oracle.

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::RefinableMesh;
use striata::model::{LodModel, ModelError, Mts, StoredModel, StripModel};
use striata::strip::StripSet;
use striata_strip::{StripOptions, Stripifier, stripify};
use support::{
    Random, RandomSequenceOptions, follows_the_oracle, grid, hub_cases, nasty_cases, random_refinable,
    seam_cases, soups, surface_cases,
};

/// Greedy strips, or strips joined where their ends meet at a vertex.
fn strips_of(refinable: &RefinableMesh, has_joints: bool) -> StripSet {
    let stripifier = if has_joints { Stripifier::Cheapest } else { Stripifier::Greedy };
    stripify(&refinable.mesh, &StripOptions::default().with_stripifier(stripifier)).unwrap()
}

/// The model must match the oracle at every level, and incremental updates must equal a full rebuild.
fn check(refinable: &RefinableMesh, has_joints: bool, stride: usize) {
    let mts = Mts::build(refinable, &strips_of(refinable, has_joints)).unwrap();
    follows_the_oracle(refinable, &mts, stride);
    let mut state = mts.new_state();
    for split_count in (0..=refinable.sequence.step_count()).rev().step_by(stride) {
        mts.move_to(&mut state, split_count);
        let mut recovered = state.clone();
        mts.recover(&mut recovered);
        assert_eq!(recovered, state, "walking what changed is walking all, at {split_count}");
    }
}

#[test]
fn nasty_meshes_follow_the_oracle_at_every_level() {
    nasty_cases().for_each(|case| check(&case.refinable, case.seed % 2 == 0, case.stride));
}

#[test]
fn surfaces_follow_the_oracle() {
    surface_cases().for_each(|case| check(&case.refinable, case.seed % 2 == 0, case.stride));
}

#[test]
fn seams_and_groups_follow_the_oracle() {
    for case in seam_cases() {
        check(&case.refinable, case.seed < 2, case.stride);
        let model = Mts::build(&case.refinable, &strips_of(&case.refinable, true)).unwrap();
        assert_eq!(model.group_count(), 3);
        assert!(model.group_strips(1).is_empty());
    }
}

#[test]
fn a_vertex_in_many_strips_makes_a_long_record() {
    hub_cases().for_each(|case| check(&case.refinable, false, case.stride));
}

#[test]
fn strips_of_another_mesh_are_rejected() {
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let refinable = random_refinable(&grid(4, false), sequence_options, &mut Random::new(1));
    let mut strips = StripSet::new();
    strips.push(&[0, 1, 2, 99]);
    let expected = ModelError::GroupCount { found: 0, expected: 1 };
    assert_eq!(Mts::build(&refinable, &strips).unwrap_err(), expected);
    strips.end_group();
    let expected = ModelError::Vertex { strip: 0, vertex: 99, vertex_count: 25 };
    assert_eq!(Mts::build(&refinable, &strips).unwrap_err(), expected);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(96) })]

    #[test]
    fn random_meshes_follow_the_oracle_at_every_level(case in soups(), has_joints in any::<bool>()) {
        check(&case.refinable, has_joints, case.stride);
    }
}
