//! An incrementally updated triangle list has the same indices as one that is written anew.

use striata_testing::support;

use striata::mesh::{FragmentedMesh, shapes};
use striata::model::{FanForm, FanIndices, FanInstance, FanTriangles, Fans, LodModel};
use support::{
    Case, Random, fragment_cases, grid, hub_cases, nasty_cases, random_removals, seam_cases, soups,
    surface_cases,
};

fn check(fans: &Fans, live: &FanTriangles, instance: &FanInstance) {
    assert_eq!(live.shown(), instance);
    let mut expected = FanIndices::default();
    instance.emit_into(fans, FanForm::Triangles, &mut expected);
    assert!(live.indices() == expected.indices);
    assert_eq!(live.group_ranges(), expected.group_ranges);
    for (group, range) in expected.group_ranges.iter().enumerate() {
        let range = range.start as usize..range.end as usize;
        assert_eq!(live.triangles(group).as_flattened(), &live.indices()[range]);
    }
}

fn follow(fans: &Fans, seed: u64) {
    let mut random = Random::new(seed);
    let mut instance = FanInstance::uniform(fans, 0);
    let mut live = FanTriangles::new(fans, &instance);
    check(fans, &live, &instance);
    for round in 0..if fans.step_count() == 0 { 0 } else { 60 } {
        // Some rounds change a single step and what it needs, others change many.
        for _ in 0..[1, 1, 5, 40][round % 4] {
            let step = random.below(fans.step_count()) as u32;
            if random.below(100) < [30, 70][round / 8 % 2] {
                instance.collapse(fans, step);
            } else {
                instance.split(fans, step);
            }
        }
        let before = live.shown().clone();
        let changed =
            (0..fans.step_count() as u32).filter(|&s| before.is_refined(s) != instance.is_refined(s)).count();
        assert_eq!(live.follow(fans, &instance), changed);
        check(fans, &live, &instance);
    }
    let full = FanInstance::full(fans);
    live.follow(fans, &full);
    check(fans, &live, &full);
}

fn follow_collapses(case: &Case) {
    follow(&Fans::build_without_bounds(&case.refinable), case.seed);
}

#[test]
fn triangles_follow_an_instance() {
    let cases = nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases());
    cases.for_each(|case| follow_collapses(&case));
}

#[test]
fn triangles_follow_removals() {
    let large = random_removals(&shapes::terrain(24, 3), usize::MAX, &mut Random::new(4));
    for (seed, mesh) in fragment_cases().chain([(1, large)]) {
        follow(&Fans::build_without_bounds(&mesh), seed);
    }
    for case in nasty_cases().chain(seam_cases()) {
        follow(&Fans::build_without_bounds(&FragmentedMesh::from_collapses(&case.refinable)), case.seed);
    }
}

/// With single steps, nearly all of a large list stays as it is, whatever its length becomes.
#[test]
fn single_steps_of_a_large_list_are_followed() {
    let options = support::RandomSequenceOptions { far_percent: 1, base_position_count: 40 };
    let mesh = support::with_seams_and_groups(grid(40, false));
    let plain = support::random_refinable(&grid(60, true), options, &mut Random::new(2));
    let grouped = support::random_refinable(&mesh, options, &mut Random::new(3));
    for refinable in [plain, grouped] {
        let fans = Fans::build_without_bounds(&refinable);
        let mut random = Random::new(8);
        let mut instance = FanInstance::uniform(&fans, fans.step_count() / 3);
        let mut live = FanTriangles::new(&fans, &instance);
        for _ in 0..300 {
            let step = random.below(fans.step_count()) as u32;
            if instance.is_refined(step) {
                instance.collapse(&fans, step);
            } else {
                instance.split(&fans, step);
            }
            live.follow(&fans, &instance);
            check(&fans, &live, &instance);
        }
    }
}

#[test]
fn memory_is_reused() {
    let case = surface_cases().last().unwrap();
    let fans = Fans::build(&case.refinable);
    let [base, full] = [0, fans.step_count()].map(|count| FanInstance::uniform(&fans, count));
    let mut live = FanTriangles::new(&fans, &full);
    let mut bytes = 0;
    for round in 0..20 {
        live.follow(&fans, &base);
        live.follow(&fans, &full);
        assert!(round == 0 || live.bytes() == bytes);
        bytes = live.bytes();
    }
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig { failure_persistence: None, ..striata_testing::cases(64) })]

    #[test]
    fn random_meshes_are_followed(case in soups()) {
        follow_collapses(&case);
    }
}
