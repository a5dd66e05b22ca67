//! Progressive fans against the oracle: uniform levels, and any set of steps that collapses and splits in any order lead to.

mod support;

use proptest::prelude::*;
use striata::mesh::{RefinableMesh, canonical_triangles};
use striata::model::{FanInstance, Fans, LodModel};
use support::{
    Random, Wildness, follows_the_oracle, grid, nasty, random_refinable, soup, with_seams_and_groups,
};

/// The oracle of a selective level: every corner follows its targets to the first vertex that is there.
fn selective(refinable: &RefinableMesh, instance: &FanInstance, triangles: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let sequence = &refinable.sequence;
    let base = sequence.base_position_count();
    let shown = |mut v: u32| {
        loop {
            let position = sequence.positions().position_of(v) as usize;
            match position.checked_sub(base) {
                Some(step) if instance.is_taken(step as u32) => v = sequence.target(v),
                _ => return v,
            }
        }
    };
    let proper = |t: &[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    triangles.iter().map(|t| t.map(shown)).filter(proper).collect()
}

fn check_instance(refinable: &RefinableMesh, fans: &Fans, instance: &FanInstance) {
    for (g, group) in refinable.mesh.groups_or_whole().into_iter().enumerate() {
        let mut found = Vec::new();
        instance.group_indices_into(fans, g, &mut found);
        let expected = selective(refinable, instance, &refinable.mesh.triangles[group.range()]);
        assert_eq!(
            canonical_triangles(found.as_chunks().0),
            canonical_triangles(&expected),
            "group {g} with {} of {} steps taken",
            instance.taken_count(),
            fans.step_count()
        );
    }
}

/// Random collapses and splits, by drifts towards coarse and towards fine; every set on the way shows its oracle.
fn wander(refinable: &RefinableMesh, fans: &Fans, change_count: usize, random: &mut Random) {
    let step_count = fans.step_count();
    let mut instance = FanInstance::full(fans);
    check_instance(refinable, fans, &instance);
    for change in 0..if step_count == 0 { 0 } else { change_count } {
        let step = random.below(step_count) as u32;
        let before = instance.taken_count();
        let drift = if change / 8 % 2 == 0 { 75 } else { 25 };
        if random.below(100) < drift {
            let count = instance.collapse(fans, step);
            assert!(instance.is_taken(step));
            assert_eq!(instance.taken_count(), before + count);
        } else {
            let count = instance.split(fans, step);
            assert!(!instance.is_taken(step));
            assert_eq!(instance.taken_count(), before - count);
        }
        check_instance(refinable, fans, &instance);
    }
}

fn check(refinable: &RefinableMesh, stride: usize, random: &mut Random) {
    let fans = Fans::build(refinable);
    follows_the_oracle(refinable, &fans, stride);
    for split_count in (0..=fans.step_count()).step_by(stride) {
        check_instance(refinable, &fans, &FanInstance::uniform(&fans, split_count));
    }
    wander(refinable, &fans, 48, random);
}

#[test]
fn nasty_meshes_follow_the_oracle() {
    for (name, mesh) in nasty() {
        for seed in 0..8 {
            let mut random = Random::new(seed);
            let wildness = Wildness { far_percent: (seed as usize % 3) * 30, base_position_count: 1 };
            eprintln!("{name}, seed {seed}");
            check(&random_refinable(&mesh, wildness, &mut random), 1, &mut random);
        }
    }
}

#[test]
fn surfaces_follow_the_oracle() {
    for (mesh, stride) in [(grid(12, false), 1), (grid(14, true), 1), (grid(60, true), 97)] {
        for seed in 0..3 {
            let mut random = Random::new(seed);
            let wildness = Wildness { far_percent: seed as usize * 4, base_position_count: 4 };
            check(&random_refinable(&mesh, wildness, &mut random), stride, &mut random);
        }
    }
}

#[test]
fn seams_and_groups_follow_the_oracle() {
    for seed in 0..6 {
        let mut random = Random::new(seed);
        let mesh = with_seams_and_groups(grid(9, seed % 2 == 0));
        let wildness = Wildness { far_percent: 5, base_position_count: 3 };
        check(&random_refinable(&mesh, wildness, &mut random), 1, &mut random);
    }
}

#[test]
fn a_vertex_with_many_triangles_has_several_fans() {
    let n = 300u32;
    let positions = (0..=n).map(|i| [i as f32, (i * i % 17) as f32, 0.0]).collect();
    let triangles = (0..n).map(|i| [n, i, (i + 1) % n]).collect();
    let mesh = striata::mesh::IndexedMesh::new(positions, triangles);
    for seed in 0..4 {
        let mut random = Random::new(seed);
        let wildness = Wildness { far_percent: 50, base_position_count: 100 };
        check(&random_refinable(&mesh, wildness, &mut random), 7, &mut random);
    }
}

#[test]
fn an_instance_is_one_bit_a_step() {
    let wildness = Wildness { far_percent: 0, base_position_count: 4 };
    let refinable = random_refinable(&grid(40, true), wildness, &mut Random::new(3));
    let fans = Fans::build(&refinable);
    assert_eq!(FanInstance::full(&fans).bytes(), 8 * fans.step_count().div_ceil(64));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 192, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_meshes_follow_the_oracle(
        seed in any::<u64>(),
        vertex_count in 3usize..30,
        triangle_count in 0usize..60,
        far_percent in 0usize..60,
        has_seams in any::<bool>(),
    ) {
        let mut random = Random::new(seed);
        let mut mesh = soup(vertex_count, triangle_count, &mut random);
        if has_seams {
            mesh = with_seams_and_groups(mesh);
        }
        let wildness = Wildness { far_percent, base_position_count: 1 };
        check(&random_refinable(&mesh, wildness, &mut random), 1, &mut random);
    }
}
