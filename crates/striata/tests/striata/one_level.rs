//! Simplification to a single level in one call, and contraction of separate parts.

use striata_testing::meshes;

use meshes::{all, check_each};
use striata::mesh::{IndexedMesh, canonical_triangles, replay, shapes};
use striata::simplify::{
    SequenceOptions, Simplified, SimplifyOptions, StopReason, Target, TopologyRule, build_sequence, simplify,
};

fn level(mesh: &IndexedMesh, options: &SimplifyOptions) -> Simplified {
    simplify(mesh, options).expect("valid meshes can be simplified")
}

fn options_for(target: Target, options: &SequenceOptions) -> SimplifyOptions {
    SimplifyOptions::default().with_target(target).with_sequence(options.clone())
}

#[test]
fn a_level_is_that_of_the_sequence() {
    check_each(all(), |_, mesh, options| {
        let refinable = build_sequence(mesh, options).expect("valid meshes can be simplified").refinable;
        let sequence = &refinable.sequence;
        let step_count = sequence.step_count();
        for split_count in [0, step_count / 3, step_count] {
            let expected = replay(&refinable, split_count);
            let targets = [
                Target::Triangles(expected.triangle_count()),
                Target::Vertices(expected.vertex_count()),
                Target::SplitCount(split_count),
            ];
            for target in targets {
                // Steps that remove no triangle produce several levels with the same count.
                let expected = replay(&refinable, target.resolve(sequence).0);
                let out = level(mesh, &options_for(target, options));
                assert_eq!(out.mesh.check(), Ok(()), "{target:?}");
                assert_eq!(out.mesh.triangle_count(), expected.triangle_count(), "{target:?}");
                assert_eq!(out.mesh.groups.len(), expected.groups.len(), "{target:?}");
                assert_eq!(triangles_by_position(&out.mesh), triangles_by_position(&expected), "{target:?}");
            }
        }
    });
}

/// Triangles by the bits of their positions.
fn triangles_by_position(mesh: &IndexedMesh) -> Vec<[u32; 3]> {
    let mut known: Vec<[u32; 3]> = mesh.positions.iter().map(|p| p.map(f32::to_bits)).collect();
    let positions = known.clone();
    known.sort_unstable();
    known.dedup();
    let number = |v: u32| known.binary_search(&positions[v as usize]).unwrap_or(usize::MAX) as u32;
    let used: Vec<[u32; 3]> = mesh.triangles.iter().map(|t| t.map(number)).collect();
    // Indices of unused positions must not matter, so rank the used ones.
    let mut ranks: Vec<u32> = used.iter().flatten().copied().collect();
    ranks.sort_unstable();
    ranks.dedup();
    let rank = |n: u32| ranks.binary_search(&n).unwrap_or(usize::MAX) as u32;
    canonical_triangles(&used.iter().map(|t| t.map(rank)).collect::<Vec<_>>())
}

#[test]
fn a_tolerance_is_never_exceeded() {
    check_each(all(), |_, mesh, options| {
        let diagonal = mesh.diagonal();
        for tolerance in [0.0, 0.002 * diagonal, 0.05 * diagonal] {
            let out = level(mesh, &options_for(Target::Triangles(0), options).with_tolerance(tolerance));
            assert!(out.error <= tolerance, "error {} of {tolerance}", out.error);
            if out.mesh.triangle_count() > 0 {
                assert!(matches!(out.stop_reason, StopReason::ErrorLimit | StopReason::BaseReached));
            }
            let by_error = level(mesh, &options_for(Target::Error(tolerance), options));
            assert!(by_error.error <= tolerance, "error {} of {tolerance}", by_error.error);
            assert_eq!(by_error.mesh.triangle_count(), out.mesh.triangle_count());
        }
    });
}

#[test]
fn an_error_that_is_the_target_is_met_and_a_lower_tolerance_is_a_limit() {
    let mesh = shapes::torus(40, 20, 2.0, 1.0);
    let sequence = SequenceOptions::default();
    let built = build_sequence(&mesh, &sequence).expect("valid meshes can be simplified").refinable.sequence;
    let error = f64::from(built.error_at(built.step_count() / 2));
    let count = |error: f64| built.triangle_count_at(built.split_count_for_error(error));
    let options = options_for(Target::Error(error), &sequence);
    let out = level(&mesh, &options);
    assert_eq!((out.stop_reason, out.mesh.triangle_count()), (StopReason::TargetReached, count(error)));
    let out = level(&mesh, &options.with_tolerance(0.5 * error));
    assert_eq!((out.stop_reason, out.mesh.triangle_count()), (StopReason::ErrorLimit, count(0.5 * error)));
}

#[test]
fn targets_beyond_the_mesh_are_reported() {
    let mesh = shapes::torus(12, 9, 2.0, 1.0);
    let out = level(&mesh, &options_for(Target::Triangles(1_000_000), &SequenceOptions::default()));
    assert_eq!((out.stop_reason, out.mesh.triangle_count()), (StopReason::FullMesh, mesh.triangle_count()));
    assert_eq!(out.error, 0.0);
    let out = level(&mesh, &options_for(Target::Triangles(0), &SequenceOptions::default()));
    assert_eq!(out.stop_reason, StopReason::BaseReached);
    assert!(out.mesh.triangle_count() > 0);
}

#[test]
fn near_parts_contract_if_requested() {
    let gap = 0.1;
    let mut mesh = shapes::many_components(400);
    // Parts are about 0.2 wide and 1 apart, a hundred to a row. Move them closer together.
    for (i, part) in mesh.positions.chunks_exact_mut(4).enumerate() {
        let [by, up] = [i % 100, i / 100].map(|n| (0.8 - gap) * n as f32);
        part.iter_mut().for_each(|p| *p = [p[0] - by, p[1] - up, p[2]]);
    }
    let left = |options: &SequenceOptions| {
        let built = build_sequence(&mesh, options).expect("valid meshes can be simplified");
        built.refinable.sequence.triangle_count_at(0)
    };
    let apart = SequenceOptions::default().with_topology(TopologyRule::Keep);
    assert_eq!(left(&apart), mesh.triangle_count(), "closed tetrahedra cannot lose a vertex");
    let left = left(&apart.with_pair_distance(0.5));
    assert!(left <= mesh.triangle_count() / 20, "{left} triangles left");
}

#[test]
fn contraction_keeps_the_counts_of_every_level() {
    check_each(all(), |_, mesh, options| {
        for share in [0.01, 0.2] {
            let distance = share * mesh.diagonal();
            let options = options.clone().with_pair_distance(distance);
            let built = build_sequence(mesh, &options).expect("valid meshes can be simplified");
            let sequence = &built.refinable.sequence;
            for split_count in (0..=sequence.step_count()).rev() {
                let level = replay(&built.refinable, split_count);
                assert_eq!(level.check(), Ok(()));
                assert_eq!(
                    level.triangle_count(),
                    sequence.triangle_count_at(split_count),
                    "at {split_count}"
                );
            }
        }
    });
}
