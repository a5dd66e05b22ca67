//! Checks the simplifier against the guarantees of its sequence, on every mesh of the test set and with
//! every cost.

use striata_testing::{meshes, simplifier, support, test_guarantees};

use std::collections::BTreeSet;

use meshes::{all, check_each, closed, open, with_patches};
use proptest::prelude::*;
use simplifier::{Simplifier, boundary_of, group_border_of, key, positions_of};
use striata::file::{WriteOptions, to_striata};
use striata::mesh::{
    Adjacency, CollapseSequence, IndexedMesh, RefinableMesh, SequenceParts, canonical_triangles, replay,
    shapes, weld,
};
use striata::simplify::{
    BoundaryRule, BuiltSequence, CostFunction, SeamRule, SequenceOptions, StopReason, TopologyRule,
    build_sequence,
};
use support::Topology;

test_guarantees! {
    SequenceOptions:
    every_mesh_simplifies_to_a_few_triangles,
    manifolds_keep_their_topology_at_every_level,
    seams_cut_every_level_into_the_same_pieces,
    locked_vertices_are_in_the_base,
    locked_boundaries_keep_every_vertex,
    locked_group_borders_keep_every_vertex,
    the_base_triangle_count_is_missed_by_less_than_a_step,
    invalid_meshes_are_rejected_with_the_location,
    the_callback_sees_progress_and_can_cancel,
    no_triangle_of_a_sphere_turns_inward,
}

fn build(mesh: &IndexedMesh, options: &SequenceOptions) -> BuiltSequence {
    build_sequence(mesh, options).expect("valid meshes can be simplified")
}

/// Triangles as positions, smallest corner first, sorted; those with two corners at one position are dropped.
fn triangles_in_space(mesh: &IndexedMesh) -> Vec<[[u32; 3]; 3]> {
    let mut out: Vec<[[u32; 3]; 3]> = mesh
        .triangles
        .iter()
        .map(|t| t.map(|v| key(mesh.positions[v as usize])))
        .filter(|[a, b, c]| a != b && b != c && c != a)
        .collect();
    for t in &mut out {
        let least = (0..3).min_by_key(|&k| t[k]).expect("three corners");
        t.rotate_left(least);
    }
    out.sort_unstable();
    out
}

/// Guarantees for every sequence of any valid mesh.
fn check_sequence(name: &str, input: &IndexedMesh, built: &BuiltSequence) {
    let RefinableMesh { mesh, sequence } = &built.refinable;
    assert_eq!(triangles_in_space(mesh), triangles_in_space(input), "{name}: the full mesh");
    check_parts(name, &built.refinable);
    check_attributes(name, input, built);
    let mut last_error = f32::INFINITY;
    for split_count in 0..=sequence.step_count() {
        let level = replay(&built.refinable, split_count);
        let at = || format!("{name} at {split_count} of {}", sequence.step_count());
        assert_eq!(level.check(), Ok(()), "{}", at());
        assert_eq!(level.triangle_count(), sequence.triangle_count_at(split_count), "{}", at());
        assert_eq!(level.vertex_count(), sequence.vertex_count_at(split_count), "{}", at());
        let error = sequence.error_at(split_count);
        assert!((0.0..=last_error).contains(&error), "{}: error {error} after {last_error}", at());
        last_error = error;
    }
}

/// Checks that the sequence is accepted when assembled from stored arrays.
fn check_parts(name: &str, refinable: &RefinableMesh) {
    let RefinableMesh { mesh, sequence } = refinable;
    let again = CollapseSequence::from_parts(SequenceParts {
        positions: sequence.positions().clone(),
        base_position_count: sequence.base_position_count(),
        targets: sequence.targets().to_vec(),
        errors: sequence.errors().to_vec(),
        removed_triangle_counts: sequence.removed_triangle_counts().to_vec(),
        triangle_count: mesh.triangle_count(),
    });
    assert_eq!(again.as_ref(), Ok(sequence), "{name}");
    for position in 0..sequence.positions().position_count() as u32 {
        let keys: BTreeSet<_> =
            sequence.positions().wedges(position).map(|v| key(mesh.positions[v as usize])).collect();
        assert_eq!(keys.len(), 1, "{name}: wedges of position {position} lie apart");
    }
    let position_count = positions_of(mesh, mesh.vertex_count()).len();
    assert_eq!(sequence.positions().position_count(), position_count, "{name}: positions are numbered once");
}

/// Every vertex must have the attributes of its source vertex in the input; each level uses a prefix of
/// the vertices.
fn check_attributes(name: &str, input: &IndexedMesh, built: &BuiltSequence) {
    let mesh = &built.refinable.mesh;
    assert_eq!(built.source_vertex.len(), mesh.vertex_count(), "{name}");
    assert_eq!(mesh.layers.len(), input.layers.len(), "{name}");
    for (v, &source) in built.source_vertex.iter().enumerate() {
        assert_eq!(key(mesh.positions[v]), key(input.positions[source as usize]), "{name}: vertex {v}");
        for (found, expected) in mesh.layers.iter().zip(&input.layers) {
            assert_eq!(found.semantic, expected.semantic, "{name}");
            let n = expected.vertex_bytes();
            assert_eq!(
                found.data.as_bytes()[v * n..][..n],
                expected.data.as_bytes()[source as usize * n..][..n],
                "{name}: {} of vertex {v}",
                found.semantic
            );
        }
    }
}

/// Locked vertices must be used in the base mesh; other vertices remain only if a rule requires it.
fn check_locks(input: &IndexedMesh, options: &SequenceOptions, built: &BuiltSequence) {
    let base = replay(&built.refinable, 0);
    let used = base.clone().without_unused_vertices();
    let used = positions_of(&used, used.vertex_count());
    assert_eq!(
        used.len(),
        built.refinable.sequence.base_position_count(),
        "positions without triangles stay"
    );
    let shown: BTreeSet<[u32; 3]> = triangles_in_space(input).into_iter().flatten().collect();
    let mut locked: BTreeSet<[u32; 3]> =
        options.locked_vertices.iter().map(|&v| key(input.positions[v as usize])).collect();
    if options.boundary == BoundaryRule::Locked {
        locked.extend(boundary_of(input));
    }
    if options.group_borders == BoundaryRule::Locked {
        locked.extend(group_border_of(&weld(input).expect("assets are valid").mesh));
    }
    locked.retain(|place| shown.contains(place));
    assert!(locked.is_subset(&used), "something locked went");
    let keeps_something = options.topology != TopologyRule::Change || options.seams != SeamRule::Cross;
    // A locked position needs two more for its triangle; multi-layer parts may stop before their last
    // triangle.
    let limit = 10 + 3 * locked.len();
    assert!(keeps_something || used.len() <= limit, "{} positions of {limit} left", used.len());
}

/// Checks that no vertex is shared by two materials while seams are kept: a triangle must not adopt a vertex
/// from across the border.
fn check_materials(at: &str, level: &IndexedMesh) {
    let mut material_of = vec![None; level.vertex_count()];
    for group in level.groups_or_whole() {
        for &v in level.triangles[group.range()].iter().flatten() {
            let expected = *material_of[v as usize].get_or_insert(group.material);
            assert_eq!(group.material, expected, "{at}: vertex {v} serves two materials");
        }
    }
}

#[test]
fn every_sequence_satisfies_its_guarantees() {
    check_each(all(), |name, mesh, options| {
        check_sequence(name, mesh, &build(mesh, options));
        check_sequence(name, mesh, &build(mesh, &options.clone().with_topology(TopologyRule::KeepParts)));
        let built = build(mesh, &options.preserving_all());
        check_sequence(name, mesh, &built);
        for split_count in 0..=built.refinable.sequence.step_count() {
            let at = format!("{name} at {split_count}");
            check_materials(&at, &replay(&built.refinable, split_count));
        }
    });
}

#[test]
fn closed_surfaces_keep_their_topology_down_to_the_minimum() {
    let bumpy = meshes::rough(shapes::icosphere(4, 1.0), 0.01, 7);
    // If there are several parts, small ones may vanish before others are done.
    let is_plain = |mesh: &IndexedMesh| {
        mesh.layers.is_empty() && mesh.groups.is_empty() && Topology::of(mesh).component_count == 1
    };
    let plain = closed().into_iter().filter(|(_, mesh)| is_plain(mesh));
    let large = [("bumpy ball", bumpy), ("large torus", shapes::torus(60, 40, 2.0, 1.0))];
    let large = large.map(|(name, mesh)| (name.to_owned(), mesh));
    check_each(plain.chain(large).collect(), |_, mesh, options| {
        let (free, kept) = (build(mesh, options).refinable, build(mesh, &options.preserving_all()).refinable);
        let (free_count, kept_count) = (free.sequence.step_count(), kept.sequence.step_count());
        let more = free_count - kept_count;
        for split_count in 0..=kept_count {
            let (found, expected) = (replay(&free, more + split_count), replay(&kept, split_count));
            assert_eq!(triangles_in_space(&found), triangles_in_space(&expected), "at {split_count}");
            let errors = [free.sequence.error_at(more + split_count), kept.sequence.error_at(split_count)];
            assert_eq!(errors[0], errors[1], "at {split_count}");
        }
    });
}

#[test]
fn parts_are_kept_if_requested() {
    check_each(vec![("parts".to_owned(), shapes::many_components(30))], |_, mesh, options| {
        let parts = Topology::of(mesh).component_count;
        let refinable = build(mesh, &options.clone().with_topology(TopologyRule::KeepParts)).refinable;
        let base = replay(&refinable, 0);
        assert_eq!(Topology::of(&base).component_count, parts);
        assert!(build(mesh, options).refinable.sequence.triangle_count_at(0) < parts);
    });
}

#[test]
fn surfaces_without_seams_simplify_to_a_few_triangles() {
    let limits = [
        ("icosphere", 4),
        ("uv sphere", 4),
        ("sphere with sharp poles", 4),
        ("torus", 20),
        ("two bodies", 24),
        ("flat grid", 2),
        ("terrain", 6),
    ];
    simplifier::simplifies_to(&limits, SequenceOptions::preserving_all);
}

#[test]
fn boundary_vertices_only_move_along_the_boundary() {
    check_each(open(), |_, mesh, options| {
        let refinable = build(mesh, &options.clone().with_topology(TopologyRule::Keep)).refinable;
        let sequence = &refinable.sequence;
        let positions = sequence.positions();
        for step in (0..sequence.step_count()).rev() {
            let before = replay(&refinable, step + 1);
            let by_position = before.triangles.iter().map(|t| t.map(|v| positions.position_of(v))).collect();
            let adjacency = Adjacency::of_triangles(by_position, positions.position_count());
            let removed = (sequence.base_position_count() + step) as u32;
            let target = positions.position_of(sequence.target(positions.first_vertex(removed)));
            if adjacency.edges().any(|e| e.is_boundary() && e.ends.contains(&removed)) {
                let edge = adjacency.edge_between(removed, target);
                assert!(edge.is_some_and(|e| e.is_boundary()), "step {step} leaves the boundary");
            }
        }
    });
}

#[test]
fn the_error_limit_is_the_last_step_that_fits() {
    check_each(all(), |_, mesh, options| {
        let free = build(mesh, options).refinable.sequence;
        let Some(&middle) = free.errors().get(free.step_count() / 2) else { return };
        // Just below a reported error, where rounding would show.
        let below = f64::from(middle) * (1.0 - 1e-9);
        for limit in [0.0, below, f64::from(middle), f64::from(free.error_at(0)) * 2.0] {
            let built = build(mesh, &options.clone().with_max_error(limit));
            let sequence = &built.refinable.sequence;
            let error = f64::from(sequence.error_at(0));
            assert!(error <= limit, "limit {limit}, error {error}");
            let fitting = free.errors().iter().filter(|&&e| f64::from(e) <= limit).count();
            assert_eq!(sequence.errors(), &free.errors()[free.step_count() - fitting..], "limit {limit}");
            let has_stopped = built.stop_reason == StopReason::ErrorLimit;
            assert_eq!(has_stopped, fitting < free.step_count(), "limit {limit}");
        }
    });
}

#[test]
fn options_out_of_range_are_rejected() {
    let mesh = shapes::cube();
    let options = SequenceOptions::default;
    let cases = [
        ("max_error", options().with_max_error(f64::NAN)),
        ("max_error", options().with_max_error(-1.0)),
        ("pair_distance", options().with_pair_distance(f64::NAN)),
        ("pair_distance", options().with_pair_distance(-0.5)),
        ("locked_vertices", options().with_locked_vertices(vec![3, 8])),
    ];
    simplifier::rejects(&mesh, &cases);
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    check_each(all(), |_, mesh, options| {
        let bytes = || {
            let refinable = build(mesh, options).refinable;
            to_striata(&refinable, &[], &WriteOptions::default()).expect("memory does not fail")
        };
        assert!(bytes() == bytes());
    });
}

proptest! {
    #![proptest_config(striata_testing::cases(48))]

    #[test]
    fn random_soups_satisfy_the_guarantees(count in 1u32..160, seed: u64, cost in 0..CostFunction::ALL.len()) {
        let mesh = shapes::random_soup(count, seed);
        let options = SequenceOptions::default().with_cost(CostFunction::ALL[cost]);
        check_sequence("soup", &mesh, &build(&mesh, &options));
    }

    #[test]
    fn random_assets_satisfy_the_guarantees(pieces in 1usize..9, seed: u64, cost in 0..CostFunction::ALL.len(), locks: bool) {
        let mesh = meshes::asset(pieces, seed);
        let mut options = SequenceOptions::default().with_cost(CostFunction::ALL[cost]);
        if locks {
            options = options.with_locked_vertices((0..mesh.vertex_count() as u32).step_by(29).collect());
        }
        let built = build(&mesh, &options);
        check_sequence("asset", &mesh, &built);
        let sequence = &built.refinable.sequence;
        let limit = if locks { 16 + 3 * mesh.vertex_count().div_ceil(29) } else { 16 };
        prop_assert!(sequence.triangle_count_at(0) <= limit, "{} left", sequence.triangle_count_at(0));
        let base = positions_of(&built.refinable.mesh, sequence.base_vertex_count());
        let shown: BTreeSet<[u32; 3]> = triangles_in_space(&mesh).into_iter().flatten().collect();
        for &v in &options.locked_vertices {
            let place = key(mesh.positions[v as usize]);
            prop_assert!(base.contains(&place) || !shown.contains(&place), "vertex {} was locked", v);
        }
    }

    #[test]
    fn random_options_satisfy_the_guarantees(pieces in 1usize..7, seed: u64, cost in 0..CostFunction::ALL.len()) {
        let mesh = meshes::asset(pieces, seed);
        let options = meshes::random_options(&mesh, seed, cost);
        let built = build(&mesh, &options);
        prop_assume!(!built.refinable.mesh.triangles.is_empty());
        check_sequence("asset", &mesh, &built);
        check_locks(&mesh, &options, &built);
        prop_assert_eq!(built.stop_reason, StopReason::BaseReached);
        // A target within reach must be met with the same steps.
        let sequence = &built.refinable.sequence;
        let goal = (sequence.triangle_count_at(0) + sequence.triangle_count_at(sequence.step_count())) / 2;
        let some = build(&mesh, &options.clone().with_base_triangle_count(goal));
        prop_assert!(some.refinable.sequence.triangle_count_at(0) <= goal);
        prop_assert_eq!(some.stop_reason, StopReason::TargetReached);
        let below = build(&mesh, &options.with_base_triangle_count(sequence.triangle_count_at(0) - 1));
        prop_assert_eq!(below.stop_reason, StopReason::BaseReached);
    }

    #[test]
    fn random_patches_satisfy_the_guarantees(
        (rings, segments) in (3u32..12, 3u32..12),
        run in 1usize..40,
        seed: u64,
        cost in 0..CostFunction::ALL.len(),
    ) {
        let rough = meshes::rough(shapes::torus(rings, segments, 2.0, 1.0), 0.2, seed);
        let mesh = with_patches(rough, run);
        let options = SequenceOptions::default().with_cost(CostFunction::ALL[cost]).with_topology(TopologyRule::Keep);
        let built = build(&mesh, &options);
        check_sequence("patches", &mesh, &built);
        for split_count in 0..=built.refinable.sequence.step_count() {
            let level = replay(&built.refinable, split_count);
            prop_assert_eq!(Topology::of(&level).genus, Some(1));
        }
    }

    #[test]
    fn the_full_mesh_is_the_welded_mesh(count in 1u32..200, seed: u64) {
        let mesh = with_patches(shapes::random_soup(count, seed), 3);
        let built = build(&mesh, &SequenceOptions::default());
        let welded = weld(&mesh).expect("soups are valid");
        let by_source = |triangles: &[[u32; 3]], source: &[u32]| {
            let named: Vec<_> = triangles.iter().map(|t| t.map(|v| source[v as usize])).collect();
            canonical_triangles(&named)
        };
        prop_assert_eq!(
            by_source(&built.refinable.mesh.triangles, &built.source_vertex),
            by_source(&welded.mesh.triangles, &welded.source_vertex)
        );
        prop_assert_eq!(built.degenerate_triangle_count, welded.degenerate_triangle_count);
        prop_assert_eq!(built.merged_vertex_count, welded.merged_vertex_count);
    }
}

#[test]
fn dropping_coarse_levels_keeps_the_others() {
    check_each(all(), |name, mesh, options| {
        let whole = build(mesh, options).refinable;
        let step_count = whole.sequence.step_count();
        for first in [0, step_count / 3, step_count] {
            let cut = whole.clone().without_levels_below(first);
            assert_eq!(cut.sequence.step_count(), step_count - first, "{name}");
            check_parts(name, &cut);
            for split_count in [0, (step_count - first) / 2, step_count - first] {
                let (found, expected) = (replay(&cut, split_count), replay(&whole, first + split_count));
                let place = format!("{name}: {split_count} above {first} of {step_count}");
                assert_eq!(found.positions, expected.positions, "{place}");
                assert_eq!(found.triangles, expected.triangles, "{place}");
                let error_at = |of: &RefinableMesh, at| of.sequence.error_at(at);
                assert_eq!(error_at(&cut, split_count), error_at(&whole, first + split_count), "{name}");
            }
        }
    });
}
