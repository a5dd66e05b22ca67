//! Checks vertex removal against the guarantees of its fragments, on every mesh of the test set.

use striata_testing::{meshes, simplifier, support, test_guarantees};

use meshes::{all, closed, odd, open, with_patches};
use proptest::prelude::*;
use simplifier::{Simplifier, boundary_of, check_each, hole_fillings, key, open_edges_of, positions_of};
use striata::mesh::{
    DistanceOptions, FragmentedMesh, IndexedMesh, Welded, canonical_triangles, replay, replay_fragments,
    shapes, surface_distance, weld,
};
use striata::simplify::{
    BoundaryRule, BuiltFragments, HoleCriterion, RemovalOptions, RemovalOrder, Retriangulation,
    SequenceOptions, StopReason, TopologyRule, build_fragments, build_sequence, certify_collapses,
};
use support::Topology;

test_guarantees! {
    RemovalOptions:
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

fn build(mesh: &IndexedMesh, options: &RemovalOptions) -> BuiltFragments {
    build_fragments(mesh, options).expect("valid meshes can be simplified")
}

/// Returns triangles with their corners mapped to the vertices of the input.
fn by_source(triangles: &[[u32; 3]], source: &[u32]) -> Vec<[u32; 3]> {
    canonical_triangles(&triangles.iter().map(|t| t.map(|v| source[v as usize])).collect::<Vec<_>>())
}

/// 2 if some triangles have the same corners as others: the two sides of a sheet count once in a hole.
fn side_count(welded: &Welded) -> usize {
    let corners = |t: &[u32; 3]| {
        let mut corners = t.map(|v| welded.positions.position_of(v));
        corners.sort_unstable();
        corners
    };
    let places: std::collections::BTreeSet<_> = welded.mesh.triangles.iter().map(corners).collect();
    1 + usize::from(places.len() < welded.mesh.triangle_count())
}

/// Guarantees for the fragments of any valid mesh.
fn check_fragments(name: &str, input: &IndexedMesh, options: &RemovalOptions, built: &BuiltFragments) {
    let FragmentedMesh { mesh, fragments } = &built.fragmented;
    let welded = weld(input).expect("valid");
    let expected = by_source(&welded.mesh.triangles, &welded.source_vertex);
    assert_eq!(by_source(&mesh.triangles, &built.source_vertex), expected, "{name}: the full mesh");
    assert_eq!(built.merged_vertex_count, welded.merged_vertex_count, "{name}");
    assert_eq!(built.degenerate_triangle_count, welded.degenerate_triangle_count, "{name}");
    let levels = fragments.levels();
    let full = replay_fragments(&built.fragmented, fragments.step_count());
    assert_eq!(
        canonical_triangles(&full.triangles),
        canonical_triangles(&mesh.triangles),
        "{name}: replayed"
    );
    assert_eq!(full.groups, mesh.groups, "{name}");
    for (found, expected) in full.layers.iter().zip(&mesh.layers) {
        assert_eq!(found.data.as_bytes(), expected.data.as_bytes(), "{name}");
    }
    for step in 0..fragments.step_count() as u32 {
        let (ceiling, floor) = (fragments.ceiling(step).len(), fragments.floor(step).len());
        if options.topology == TopologyRule::Keep {
            let most = options.degree_limit * side_count(&welded);
            assert!(ceiling <= most, "{name}: step {step} fills a hole of {ceiling}");
            assert!(floor > 0, "{name}: step {step} fills {ceiling} by nothing");
        }
        // Positions that have lost all their triangles are removed by separate steps.
        assert!(floor < ceiling || floor + ceiling == 0, "{name}: step {step} fills {ceiling} by {floor}");
        assert!(fragments.floor_error(step).is_finite(), "{name}");
    }
    for split_count in 0..=fragments.step_count() {
        let level = replay_fragments(&built.fragmented, split_count);
        let at = || format!("{name} at {split_count} of {}", fragments.step_count());
        assert_eq!(level.check(), Ok(()), "{}", at());
        assert_eq!(level.triangle_count(), levels.triangle_count_at(split_count), "{}", at());
        let positions = |t: &[u32; 3]| t.map(|v| levels.positions().position_of(v));
        for t in &level.triangles {
            let [a, b, c] = positions(t);
            assert!(a != b && b != c && c != a, "{}: {t:?} has no area", at());
        }
    }
    assert_eq!(built.refinable.is_some(), options.retriangulation == Retriangulation::Collapse, "{name}");
    if let Some(refinable) = &built.refinable {
        assert_eq!(refinable.mesh.triangles, mesh.triangles, "{name}");
        let vanishes = |step| fragments.floor(step).is_empty() && !fragments.ceiling(step).is_empty();
        if !(0..fragments.step_count() as u32).any(vanishes) {
            // Otherwise the errors of uniform levels differ from those of other sets.
            assert_eq!(refinable.sequence.errors(), levels.errors(), "{name}");
        }
        for split_count in 0..=fragments.step_count() {
            let collapsed = canonical_triangles(&replay(refinable, split_count).triangles);
            let level = canonical_triangles(&replay_fragments(&built.fragmented, split_count).triangles);
            assert_eq!(collapsed, level, "{name} at {split_count}");
        }
    }
}

#[test]
fn every_mesh_satisfies_the_guarantees() {
    check_each(all(), |name, mesh, options: &RemovalOptions| {
        check_fragments(name, mesh, options, &build(mesh, options));
        let preserving_all = options.preserving_all();
        check_fragments(name, mesh, &preserving_all, &build(mesh, &preserving_all));
    });
}

#[test]
fn surfaces_without_seams_simplify_to_a_few_triangles() {
    let limits = [
        ("icosphere", 4),
        ("uv sphere", 8),
        ("torus", 24),
        ("rough torus", 24),
        ("two bodies", 30),
        ("flat grid", 4),
        ("terrain", 12),
    ];
    simplifier::simplifies_to(&limits, RemovalOptions::clone);
}

#[test]
fn inner_vertices_stay_off_the_boundary() {
    check_each(open(), |_, mesh, options: &RemovalOptions| {
        let boundary = boundary_of(mesh);
        let fragmented = build(mesh, options).fragmented;
        for split_count in 0..=fragmented.fragments.step_count() {
            let level = replay_fragments(&fragmented, split_count);
            assert!(open_edges_of(&level).is_subset(&boundary), "at {split_count}");
        }
    });
}

#[test]
fn degree_limits_hold() {
    let meshes = vec![
        ("fan".to_owned(), shapes::closed_fan(30)),
        ("sphere".to_owned(), shapes::uv_sphere(9, 14, 3.0)),
    ];
    check_each(meshes, |name, mesh, options: &RemovalOptions| {
        for limit in [3, 5, 8, 16] {
            let options = options.clone().with_degree_limit(limit).with_topology(TopologyRule::Keep);
            check_fragments(name, mesh, &options, &build(mesh, &options));
        }
    });
}

#[test]
fn errors_stay_within_the_limit_while_others_continue() {
    check_each([closed(), open()].concat(), |_, mesh, options: &RemovalOptions| {
        let free = build(mesh, options);
        let levels = free.fragmented.fragments.levels();
        let Some(&middle) = levels.errors().get(levels.step_count() / 2) else { return };
        for limit in
            [0.0, f64::from(middle) * (1.0 - 1e-9), f64::from(middle), f64::from(levels.error_at(0)) * 2.0]
        {
            let built = build(mesh, &options.clone().with_max_error(limit));
            let found = built.fragmented.fragments.levels();
            assert!(f64::from(found.error_at(0)) <= limit, "{} of {limit}", found.error_at(0));
            let within = levels.triangle_count_at(levels.split_count_for_error(limit));
            let count = found.triangle_count_at(0);
            assert!(count as f64 <= 1.1 * within as f64 + 4.0, "{count} left, {within} in order");
        }
    });
}

/// Maximum sampled distance of the welded mesh from a level.
fn measured(built: &BuiltFragments, split_count: usize) -> f64 {
    let level = replay_fragments(&built.fragmented, split_count);
    let options = DistanceOptions::default().with_sample_count(20_000);
    surface_distance(&built.fragmented.mesh, &level, &options).expect("both have triangles").a_to_b.max
}

#[test]
fn errors_are_tight_bounds() {
    let mut ratios = Vec::new();
    for (name, mesh) in [closed(), open(), odd()].concat() {
        let built = build(&mesh, &RemovalOptions::default());
        let fragments = &built.fragmented.fragments;
        let step_count = fragments.step_count();
        let extent = f64::from(mesh.bounds().map_or(0.0, |bounds| bounds.diagonal() as f32));
        if step_count == 0 || !(1e-30..1e30).contains(&extent) {
            continue;
        }
        for split_count in [0, step_count / 4, step_count / 2, step_count - 1] {
            let error = f64::from(fragments.levels().error_at(split_count));
            let found = measured(&built, split_count);
            assert!(found <= error + 1e-6 * extent, "{name} at {split_count}: {found}, promised {error}");
            if found > 1e-4 * extent {
                ratios.push(error / found);
            }
        }
    }
    ratios.sort_unstable_by(f64::total_cmp);
    let (median, count) = (ratios[ratios.len() / 2], ratios.len());
    assert!(count > 60 && median < 1.2, "median {median} of {count}");
}

/// By the largest distance alone, as published: errors hold, and the largest distances of levels are smaller
/// than in the default order.
#[test]
fn the_strict_order_has_smaller_maxima() {
    let strict =
        RemovalOptions::default().with_order(RemovalOrder::Hausdorff).with_criterion(HoleCriterion::Maximum);
    let meshes = [shapes::terrain(40, 3), shapes::terrain(32, 8), shapes::torus(40, 28, 2.0, 0.8)];
    let mut logs = Vec::new();
    for mesh in meshes {
        let built = [&strict, &RemovalOptions::default()].map(|options| build(&mesh, options));
        check_fragments("strict", &mesh, &strict, &built[0]);
        for share in [0.5, 0.25, 0.1] {
            let [found, expected] = [0, 1].map(|i| {
                let levels = built[i].fragmented.fragments.levels();
                let at = levels.split_count_for_triangles((share * mesh.triangle_count() as f64) as usize);
                let found = measured(&built[i], at);
                assert!(found <= f64::from(levels.error_at(at)) + 1e-6 * mesh.diagonal());
                found
            });
            logs.push((found / expected).ln());
        }
    }
    let mean = (logs.iter().sum::<f64>() / logs.len() as f64).exp();
    assert!(mean < 0.97, "{mean} of the maxima of the default order");
}

#[test]
fn limits_hold_for_the_whole_surface() {
    for (name, mesh) in [closed(), open()].concat() {
        let extent = mesh.bounds().expect("vertices").diagonal();
        for share in [0.002, 0.02, 0.1] {
            let limit = share * extent;
            let built = build(&mesh, &RemovalOptions::default().with_max_error(limit));
            let found = measured(&built, 0);
            assert!(found <= limit + 1e-6 * extent, "{name}: {found} of {limit}");
        }
    }
}

#[test]
fn limits_leave_little_to_remove() {
    // Lower bound on the triangle count of a unit sphere approximated within 0.02: a cap of that height has a
    // radius of sqrt(2 * 0.02), and an equilateral triangle in it covers 3 sqrt(3) / 4 of its square.
    let needed = 4.0 * std::f64::consts::PI / (1.299 * 0.04);
    let sphere = shapes::icosphere(4, 1.0);
    let built = build(&sphere, &RemovalOptions::default().with_max_error(0.02));
    let count = built.fragmented.fragments.levels().triangle_count_at(0);
    assert_eq!(built.stop_reason, StopReason::ErrorLimit);
    assert!((count as f64) < 1.8 * needed, "{count} triangles, {needed:.0} needed");
    let collapsed = build_sequence(&sphere, &SequenceOptions::default()).expect("valid");
    let certified = certify_collapses(&collapsed.refinable);
    let levels = certified.sequence.levels();
    let by_collapses = levels.triangle_count_at(levels.split_count_for_error(0.02));
    assert!(count < by_collapses, "{count} triangles, {by_collapses} by collapses");
}

#[test]
fn features_are_kept() {
    // A roof.
    let mut mesh = shapes::grid(12, 12);
    for p in &mut mesh.positions {
        p[2] = (p[0] - mid(&shapes::grid(12, 12), 0)).abs();
    }
    let ridge = mid(&mesh, 0);
    let options = RemovalOptions::default().with_feature_angle(0.5);
    let fragmented = build(&mesh, &options).fragmented;
    for split_count in 0..=fragmented.fragments.step_count() {
        let level = replay_fragments(&fragmented, split_count);
        for t in &level.triangles {
            let sides = t.map(|v| level.positions[v as usize][0] - ridge);
            let is_split = sides.iter().any(|&x| x < 0.0) && sides.iter().any(|&x| x > 0.0);
            assert!(!is_split, "{t:?} crosses the ridge at {split_count}");
        }
    }
    assert!(fragmented.fragments.levels().triangle_count_at(0) < 40);
}

/// Midpoint of a mesh along an axis.
fn mid(mesh: &IndexedMesh, axis: usize) -> f32 {
    let bounds = mesh.bounds().expect("vertices");
    0.5 * (bounds.min[axis] + bounds.max[axis])
}

#[test]
fn flat_regions_are_removed_without_error() {
    let grid = build(&shapes::grid(20, 20), &RemovalOptions::default().with_max_error(1e-6));
    let count = grid.fragmented.fragments.levels().triangle_count_at(0);
    assert!(count <= 12, "{count} triangles left of a flat grid");
}

#[test]
fn options_out_of_range_are_rejected() {
    let mesh = shapes::cube();
    let options = RemovalOptions::default;
    let cases = [
        ("max_error", options().with_max_error(f64::NAN)),
        ("max_error", options().with_max_error(-1.0)),
        ("feature_angle", options().with_feature_angle(f64::INFINITY)),
        ("degree_limit", options().with_degree_limit(2)),
        ("degree_limit", options().with_degree_limit(17)),
        ("locked_vertices", options().with_locked_vertices(vec![3, 8])),
    ];
    simplifier::rejects(&mesh, &cases);
}

#[test]
fn the_same_input_gives_the_same_fragments() {
    check_each(all(), |_, mesh, options: &RemovalOptions| {
        let (one, other) = (build(mesh, options), build(mesh, options));
        assert_eq!(one.fragmented.fragments, other.fragmented.fragments);
        assert_eq!(one.source_vertex, other.source_vertex);
    });
}

proptest! {
    #![proptest_config(striata_testing::cases(48))]

    #[test]
    fn random_soups_satisfy_the_guarantees(count in 1u32..160, seed: u64, filling in 0usize..4) {
        let mesh = shapes::random_soup(count, seed);
        let options = &hole_fillings()[filling].1;
        check_fragments("soup", &mesh, options, &build(&mesh, options));
    }

    #[test]
    fn random_patches_satisfy_the_guarantees(
        (rings, segments) in (3u32..12, 3u32..12),
        run in 1usize..40,
        seed: u64,
        filling in 0usize..4,
    ) {
        let rough = meshes::rough(shapes::torus(rings, segments, 2.0, 1.0), 0.2, seed);
        let mesh = with_patches(rough, run);
        let options = &hole_fillings()[filling].1.clone().with_topology(TopologyRule::Keep);
        let built = build(&mesh, options);
        check_fragments("patches", &mesh, options, &built);
        for split_count in 0..=built.fragmented.fragments.step_count() {
            let level = replay_fragments(&built.fragmented, split_count);
            prop_assert_eq!(Topology::of(&level).genus, Some(1));
        }
    }

    #[test]
    fn random_assets_satisfy_the_guarantees(pieces in 1usize..5, seed: u64, filling in 0usize..4, locks: bool) {
        let mesh = meshes::asset(pieces, seed);
        let mut options = hole_fillings()[filling].1.clone();
        if locks {
            options = options
                .with_locked_vertices((0..mesh.vertex_count() as u32).step_by(29).collect())
                .with_group_borders(BoundaryRule::Locked);
        }
        let built = build(&mesh, &options);
        check_fragments("asset", &mesh, &options, &built);
        let fragments = &built.fragmented.fragments;
        let base = positions_of(&built.fragmented.mesh, fragments.levels().base_vertex_count());
        let welded = weld(&mesh).expect("assets are valid");
        let has_position = |v: &&u32| welded.position_of_source[**v as usize] != u32::MAX;
        let locked = options.locked_vertices.iter().filter(has_position);
        for &v in locked {
            prop_assert!(base.contains(&key(mesh.positions[v as usize])), "vertex {} was locked", v);
        }
        let left = built.fragmented.fragments.levels().triangle_count_at(0);
        prop_assert!(locks || left <= 24, "{} left", left);
    }
}
