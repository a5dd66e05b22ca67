//! Fragments made from collapses show the same triangles as the collapses, at every level.

use striata_testing::support;

use proptest::prelude::*;
use striata::mesh::{
    Face, Fragment, FragmentError, FragmentSequence, FragmentedMesh, PositionIndex, canonical_triangles,
    fragment_faces, replay, replay_fragments,
};
use support::{
    Case, Random, fragment_cases, hub_cases, nasty_cases, random_closed_set, seam_cases, soups, surface_cases,
};

fn shows_the_levels_of_collapses(case: &Case) {
    let refinable = &case.refinable;
    let fragmented = FragmentedMesh::from_collapses(refinable);
    let fragments = &fragmented.fragments;
    for split_count in (0..=refinable.sequence.step_count()).step_by(case.stride) {
        let (found, expected) = (replay_fragments(&fragmented, split_count), replay(refinable, split_count));
        assert_eq!(found.positions, expected.positions);
        assert_eq!(found.triangle_count(), fragments.levels().triangle_count_at(split_count));
        assert_eq!(fragments.levels().error_at(split_count), refinable.sequence.error_at(split_count));
        for (found_group, group) in found.groups_or_whole().into_iter().zip(expected.groups_or_whole()) {
            let found = canonical_triangles(&found.triangles[found_group.range()]);
            let expected = canonical_triangles(&expected.triangles[group.range()]);
            assert_eq!(found, expected, "level {split_count}");
        }
    }
}

#[test]
fn all_kinds_of_meshes_keep_their_levels() {
    let cases = nasty_cases().chain(surface_cases()).chain(seam_cases()).chain(hub_cases());
    cases.for_each(|case| shows_the_levels_of_collapses(&case));
}

proptest! {
    #![proptest_config(striata_testing::cases(200))]

    #[test]
    fn soups_keep_their_levels(case in soups()) {
        shows_the_levels_of_collapses(&case);
    }
}

#[test]
fn faces_know_their_creator_and_replacement() {
    for case in surface_cases().take(3) {
        let fragments = FragmentedMesh::from_collapses(&case.refinable).fragments;
        let replaced_by = fragments.replacing_steps();
        for step in 0..fragments.step_count() as u32 {
            assert!(fragments.ceiling(step).all(|face| fragments.creating_step(face) == Some(step)));
            assert!(fragments.floor(step).iter().all(|&face| replaced_by[face as usize] == step));
        }
        let full = fragment_faces(&fragments, |_| true);
        let kept = (0..fragments.faces().len() as u32)
            .filter(|&face| replaced_by[face as usize] == FragmentSequence::NO_STEP);
        assert_eq!(full, kept.collect::<Vec<_>>());
    }
}

fn face(corners: [u32; 3]) -> Face {
    Face { corners, group: 0 }
}

#[test]
fn inconsistent_fragments_are_rejected() {
    let split = |error| Fragment {
        ceiling: vec![face([0, 1, 3]), face([1, 2, 3]), face([2, 0, 3])],
        floor: vec![face([1, 2, 0])],
        error,
    };
    let build = |base: Vec<Face>, fragment| {
        FragmentSequence::from_fragments(PositionIndex::identity(4), base, [fragment].into_iter())
    };
    let good = build(vec![face([0, 1, 2])], split(0.5)).unwrap();
    assert_eq!((good.levels().triangle_count_at(0), good.levels().triangle_count_at(1)), (1, 3));
    assert_eq!(good.levels().error_at(0), 0.5);
    let missing = FragmentError::Floor { step: 0, corners: [1, 2, 0] };
    assert_eq!(build(vec![face([0, 2, 1])], split(0.5)), Err(missing), "opposite orientation");
    let early = FragmentError::Ceiling { step: None, corners: [0, 1, 3] };
    assert_eq!(build(vec![face([0, 1, 3])], split(0.5)), Err(early));
    assert!(matches!(build(vec![face([0, 1, 2])], split(f32::NAN)), Err(FragmentError::Sequence(_))));
    let old = Fragment { ceiling: vec![face([0, 1, 2])], ..split(0.0) };
    let not_its_own = FragmentError::Ceiling { step: Some(0), corners: [0, 1, 2] };
    assert_eq!(build(vec![face([0, 1, 2])], old), Err(not_its_own));
    let twice = Fragment { floor: vec![face([0, 1, 2]), face([0, 1, 2])], ..split(0.0) };
    assert!(build(vec![face([0, 1, 2])], twice).is_err());
    let again = FragmentError::Floor { step: 0, corners: [1, 2, 0] };
    let turned = Fragment { floor: vec![face([0, 1, 2]), face([2, 0, 1]), face([1, 2, 0])], ..split(0.0) };
    assert_eq!(build(vec![face([0, 1, 2]); 2], turned.clone()), Err(again), "there are two");
    assert_eq!(build(vec![face([0, 1, 2]); 3], turned).unwrap().floor(0), [0, 1, 2]);
    let flat = FragmentError::Degenerate { step: Some(0), corners: [3, 1, 3] };
    let folded = Fragment { ceiling: vec![face([3, 1, 3])], ..split(0.0) };
    assert_eq!(build(vec![face([0, 1, 2])], folded), Err(flat));
    let flat = FragmentError::Degenerate { step: None, corners: [1, 1, 2] };
    assert_eq!(build(vec![face([0, 1, 2]), face([1, 1, 2])], split(0.0)), Err(flat));
}

/// A level with fewer triangles than a coarser one.
#[test]
fn levels_are_found_even_if_triangle_counts_are_not_monotonic() {
    let faces = |corners: &[[u32; 3]]| corners.iter().copied().map(face).collect::<Vec<_>>();
    let base = faces(&[[0, 1, 2], [0, 2, 1]]);
    let steps = [
        Fragment { floor: base.clone(), ..Fragment::default() },
        Fragment { ceiling: faces(&[[0, 1, 4], [1, 2, 4], [2, 0, 4]]), ..Fragment::default() },
        Fragment { ceiling: faces(&[[0, 1, 5]]), floor: faces(&[[0, 1, 4], [1, 2, 4]]), error: 0.0 },
        Fragment { ceiling: faces(&[[0, 1, 6], [0, 5, 6]]), ..Fragment::default() },
    ];
    let positions = PositionIndex::identity(7);
    let fragments = FragmentSequence::from_fragments(positions, base, steps.into_iter()).unwrap();
    let levels = fragments.levels();
    assert_eq!([0, 1, 2, 3, 4].map(|s| levels.triangle_count_at(s)), [2, 0, 3, 2, 4]);
    assert_eq!([0, 1, 2, 3, 4].map(|n| levels.split_count_for_triangles(n)), [1, 1, 3, 3, 4]);
}

#[test]
fn degenerate_triangles_are_left_out() {
    let case = surface_cases().next().unwrap();
    let mut refinable = case.refinable.clone();
    refinable.mesh.triangles.extend([[0, 0, 1], [7, 8, 7]]);
    assert_eq!(
        FragmentedMesh::from_collapses(&refinable).fragments,
        FragmentedMesh::from_collapses(&case.refinable).fragments
    );
}

#[test]
fn sets_of_steps_are_closed_under_dependencies() {
    let mut random = Random::new(3);
    for (seed, mesh) in fragment_cases() {
        let fragments = &mesh.fragments;
        assert!(fragments.step_count() > 20, "seed {seed}: only {} steps", fragments.step_count());
        let full = fragment_faces(fragments, |_| true);
        let full: Vec<_> = full.iter().map(|&face| fragments.faces()[face as usize].corners).collect();
        assert_eq!(canonical_triangles(&full), canonical_triangles(&mesh.mesh.triangles));
        for percent in [1, 10, 60] {
            let set = random_closed_set(fragments, percent, &mut random);
            // Fails if a face of a floor is missing.
            assert!(!fragment_faces(fragments, |step| set[step as usize]).is_empty());
        }
    }
}
