//! Progressive fans against the oracle: uniform levels, and any set of steps reached by collapses and splits.

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::{IndexedMesh, RefinableMesh, canonical_triangles};
use striata::model::{FanInstance, Fans, LodModel};
use support::{
    Case, Random, RandomSequenceOptions, follows_the_oracle, grid, hub_cases, nasty_cases, random_refinable,
    seam_cases, selective_triangles, soups, surface_cases,
};

fn check_instance(refinable: &RefinableMesh, fans: &Fans, instance: &FanInstance) {
    for (g, group) in refinable.mesh.groups_or_whole().into_iter().enumerate() {
        let mut found = Vec::new();
        instance.group_indices_into(fans, g, &mut found);
        let triangles = &refinable.mesh.triangles[group.range()];
        let expected = selective_triangles(refinable, triangles, |step| !instance.is_refined(step));
        assert_eq!(
            canonical_triangles(found.as_chunks().0),
            canonical_triangles(&expected),
            "group {g} with {} of {} steps collapsed",
            instance.collapse_count(),
            fans.step_count()
        );
    }
}

/// The mesh of an instance must have the same triangles at the same positions, group by group, and no
/// unused vertex.
fn check_level(refinable: &RefinableMesh, fans: &Fans, instance: &FanInstance) {
    let level = instance.level(fans, refinable);
    level.check().unwrap();
    let mut is_used = vec![false; level.vertex_count()];
    level.triangles.iter().flatten().for_each(|&v| is_used[v as usize] = true);
    assert!(is_used.iter().all(|&used| used));
    let mut indices = Vec::new();
    instance.indices_into(fans, &mut indices);
    let places = |mesh: &IndexedMesh, triangles: &[[u32; 3]]| -> Vec<[[f32; 3]; 3]> {
        triangles.iter().map(|t| t.map(|v| mesh.positions[v as usize])).collect()
    };
    assert_eq!(places(&level, &level.triangles), places(&refinable.mesh, indices.as_chunks().0));
    assert_eq!(level.groups.len(), refinable.mesh.groups.len());
    assert_eq!(level.layers.len(), refinable.mesh.layers.len());
}

/// Applies random collapses and splits, drifting toward coarse and fine in turn; every set is checked
/// against the oracle.
fn random_walk(refinable: &RefinableMesh, fans: &Fans, change_count: usize, random: &mut Random) {
    let step_count = fans.step_count();
    let mut instance = FanInstance::full(fans);
    check_instance(refinable, fans, &instance);
    for change in 0..if step_count == 0 { 0 } else { change_count } {
        let step = random.below(step_count) as u32;
        let before = instance.collapse_count();
        let drift = if change / 8 % 2 == 0 { 75 } else { 25 };
        if random.below(100) < drift {
            let count = instance.collapse(fans, step);
            assert!(!instance.is_refined(step));
            assert_eq!(instance.collapse_count(), before + count);
        } else {
            let count = instance.split(fans, step);
            assert!(instance.is_refined(step));
            assert_eq!(instance.collapse_count(), before - count);
        }
        check_instance(refinable, fans, &instance);
    }
}

fn check(case: &Case) {
    let (refinable, stride) = (&case.refinable, case.stride);
    let fans = Fans::build(refinable);
    follows_the_oracle(refinable, &fans, stride);
    for split_count in (0..=fans.step_count()).step_by(stride) {
        check_instance(refinable, &fans, &FanInstance::uniform(&fans, split_count));
    }
    random_walk(refinable, &fans, 48, &mut Random::new(case.seed));
}

#[test]
fn nasty_meshes_follow_the_oracle() {
    nasty_cases().for_each(|case| check(&case));
}

#[test]
fn surfaces_follow_the_oracle() {
    surface_cases().for_each(|case| check(&case));
}

#[test]
fn seams_and_groups_follow_the_oracle() {
    seam_cases().for_each(|case| check(&case));
}

#[test]
fn a_vertex_with_many_triangles_has_several_fans() {
    hub_cases().for_each(|case| check(&case));
}

#[test]
fn refining_splits_wanted_steps_and_only_what_they_need() {
    for case in nasty_cases().chain(seam_cases()) {
        let fans = Fans::build(&case.refinable);
        let mut random = Random::new(case.seed);
        let wanted: Vec<bool> = (0..fans.step_count()).map(|_| random.below(100) < 7).collect();
        let instance = FanInstance::refined(&fans, |step| wanted[step as usize]);
        check_instance(&case.refinable, &fans, &instance);
        check_level(&case.refinable, &fans, &instance);
        for step in 0..fans.step_count() as u32 {
            assert!(!wanted[step as usize] || instance.is_refined(step), "step {step} was wanted");
            if !instance.is_refined(step) {
                continue;
            }
            // Collapsing any refined step again must also collapse a wanted one, so none has been refined
            // needlessly.
            let mut less = instance.clone();
            less.collapse(&fans, step);
            let lost = (0..fans.step_count()).any(|s| wanted[s] && !less.is_refined(s as u32));
            assert!(lost, "step {step} was split needlessly");
        }
    }
}

#[test]
fn an_instance_is_one_bit_a_step() {
    let sequence_options = RandomSequenceOptions { far_percent: 0, base_position_count: 4 };
    let refinable = random_refinable(&grid(40, true), sequence_options, &mut Random::new(3));
    let fans = Fans::build(&refinable);
    assert_eq!(FanInstance::full(&fans).bytes(), 8 * fans.step_count().div_ceil(64));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(192) })]

    #[test]
    fn random_meshes_follow_the_oracle(case in soups()) {
        check(&case);
    }
}
