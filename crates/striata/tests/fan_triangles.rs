//! An incrementally updated triangle list matches the triangles of its instance, group by group.

use striata_testing::support;

use striata::mesh::canonical_triangles;
use striata::model::{FanInstance, FanTriangles, Fans, LodModel};
use support::{Case, Random, hub_cases, nasty_cases, seam_cases, soups, surface_cases};

fn check(fans: &Fans, live: &FanTriangles, instance: &FanInstance) {
    assert_eq!(live.shown(), instance);
    for group in 0..fans.group_count() {
        let mut expected = Vec::new();
        instance.group_indices_into(fans, group, &mut expected);
        assert_eq!(canonical_triangles(live.triangles(group)), canonical_triangles(expected.as_chunks().0));
    }
}

fn follow(case: &Case) {
    let fans = Fans::build(&case.refinable);
    let sequence = &case.refinable.sequence;
    let mut random = Random::new(case.seed);
    let mut instance = FanInstance::uniform(&fans, 0);
    let mut live = FanTriangles::new(&fans, &instance);
    check(&fans, &live, &instance);
    for round in 0..if fans.step_count() == 0 { 0 } else { 60 } {
        // Some rounds change a single step and what it needs, others change many.
        for _ in 0..[1, 1, 5, 40][round % 4] {
            let step = random.below(fans.step_count()) as u32;
            if random.below(100) < [30, 70][round / 8 % 2] {
                instance.collapse(&fans, step);
            } else {
                instance.split(&fans, step);
            }
        }
        let before = live.shown().clone();
        let changed =
            (0..fans.step_count() as u32).filter(|&s| before.is_refined(s) != instance.is_refined(s)).count();
        assert_eq!(live.follow(&fans, sequence, &instance), changed);
        check(&fans, &live, &instance);
    }
    let full = FanInstance::full(&fans);
    live.follow(&fans, sequence, &full);
    check(&fans, &live, &full);
}

#[test]
fn triangles_follow_an_instance() {
    nasty_cases()
        .chain(surface_cases())
        .chain(seam_cases())
        .chain(hub_cases())
        .for_each(|case| follow(&case));
}

#[test]
fn memory_is_reused() {
    let case = surface_cases().last().unwrap();
    let fans = Fans::build(&case.refinable);
    let [base, full] = [0, fans.step_count()].map(|count| FanInstance::uniform(&fans, count));
    let mut live = FanTriangles::new(&fans, &full);
    let mut bytes = 0;
    for round in 0..20 {
        live.follow(&fans, &case.refinable.sequence, &base);
        live.follow(&fans, &case.refinable.sequence, &full);
        assert!(round == 0 || live.bytes() == bytes);
        bytes = live.bytes();
    }
}

proptest::proptest! {
    #![proptest_config(proptest::prelude::ProptestConfig {
        cases: 64, failure_persistence: None, ..Default::default()
    })]

    #[test]
    fn random_meshes_are_followed(case in soups()) {
        follow(&case);
    }
}
