//! All models against the oracle, over sequences that collapse across seams, fold parts flat and make
//! parts vanish.

use striata_testing::meshes;

use striata_testing::support;

use meshes::{asset, random_options};
use proptest::prelude::*;
use striata::mesh::{
    DistanceOptions, FragmentedMesh, RefinableMesh, canonical_triangles, replay, surface_distance,
};
use striata::model::{Fans, LodModel, LodStrips, Mts, Patterns};
use striata::simplify::{
    CostFunction, RemovalOptions, SequenceOptions, build_fragments, build_sequence, certify_collapses,
};
use striata::strip::stripify;
use support::{follows_the_fragments, follows_the_oracle};

fn refinable_asset(piece_count: usize, seed: u64, cost: usize) -> RefinableMesh {
    let mesh = asset(piece_count, seed);
    let options = match seed % 2 {
        0 => SequenceOptions::default().with_cost(CostFunction::ALL[cost]),
        _ => random_options(&mesh, seed, cost),
    };
    build_sequence(&mesh, &options).expect("assets are sound").refinable
}

proptest! {
    #![proptest_config(striata_testing::cases(24))]

    #[test]
    fn strip_models_follow_the_oracle(pieces in 1usize..7, seed: u64, cost in 0..CostFunction::ALL.len()) {
        let refinable = refinable_asset(pieces, seed, cost);
        let strips = stripify(&refinable.mesh).expect("full meshes are sound");
        let lod_strips = LodStrips::build(&refinable, &strips).expect("the strips are the mesh's");
        // Its states also record pending buffer updates, so they cannot be compared for equality.
        let mut state = lod_strips.new_state();
        for split_count in (0..=lod_strips.step_count()).rev().chain(0..=lod_strips.step_count()) {
            lod_strips.move_to(&mut state, split_count);
            let mut found = Vec::new();
            lod_strips.triangles_into(&state, &mut found);
            let expected = replay(&refinable, split_count).triangles;
            prop_assert_eq!(canonical_triangles(&found), canonical_triangles(&expected), "at {}", split_count);
        }
        let mts = Mts::build(&refinable, &strips).expect("the strips are the mesh's");
        follows_the_oracle(&refinable, &mts, 3);
    }

    #[test]
    fn fans_follow_the_oracle(pieces in 1usize..7, seed: u64, cost in 0..CostFunction::ALL.len()) {
        let refinable = refinable_asset(pieces, seed, cost);
        follows_the_oracle(&refinable, &Fans::build(&refinable), 3);
    }

    #[test]
    fn patterns_follow_the_oracle(pieces in 1usize..5, seed: u64, cost in 0..CostFunction::ALL.len()) {
        let refinable = refinable_asset(pieces, seed, cost);
        let fragmented = FragmentedMesh::from_collapses(&refinable);
        follows_the_oracle(&refinable, &Patterns::build(&fragmented).expect("fragments are sound"), 3);
    }

    #[test]
    fn patterns_follow_removals(pieces in 1usize..4, seed: u64) {
        let mesh = asset(pieces, seed);
        let removals = RemovalOptions::default();
        let fragmented = build_fragments(&mesh, &removals).expect("assets are sound").fragmented;
        follows_the_fragments(&fragmented, &Patterns::build(&fragmented).expect("fragments are sound"), 3);
    }

    #[test]
    fn certified_errors_hold(pieces in 1usize..5, seed: u64) {
        let refinable = refinable_asset(pieces, seed, 0);
        let certain = certify_collapses(&refinable);
        let options = DistanceOptions::default().with_sample_count(2000);
        for split_count in (0..refinable.sequence.step_count()).step_by(5) {
            let level = replay(&refinable, split_count);
            if level.triangles.is_empty() { continue; }
            let found = surface_distance(&refinable.mesh, &level, &options).expect("both have triangles");
            let limit = f64::from(certain.sequence.error_at(split_count)) + 1e-14 * refinable.mesh.diagonal();
            prop_assert!(found.a_to_b.max <= limit, "{} of at most {} at {}", found.a_to_b.max, limit, split_count);
        }
    }
}
