//! The removal of vertices against what its fragments promise, on every mesh of the test set.

mod meshes;

mod support;

use std::collections::BTreeSet;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};

use meshes::{Named, all, closed, odd, open, with_patches};
use proptest::prelude::*;
use striata::mesh::{
    Adjacency, DistanceOptions, FragmentedMesh, IndexedMesh, canonical_triangles, replay, replay_fragments,
    shapes, surface_distance, weld,
};
use striata::simplify::{
    BoundaryRule, BuiltFragments, HoleCriterion, RemovalOptions, Retriangulation, SeamRule, SequenceOptions,
    SimplifyError, StopReason, TopologyRule, build_fragments, build_fragments_with_progress, build_sequence,
    certify_collapses,
};
use support::Topology;

fn build(mesh: &IndexedMesh, options: &RemovalOptions) -> BuiltFragments {
    build_fragments(mesh, options).expect("sound meshes are simplified")
}

/// All ways to fill holes.
fn ways() -> [(&'static str, RemovalOptions); 4] {
    let free = RemovalOptions::default;
    [
        ("distance", free()),
        ("flatness", free().with_criterion(HoleCriterion::Flatness)),
        ("shape", free().with_criterion(HoleCriterion::Shape)),
        ("collapse", free().with_retriangulation(Retriangulation::Collapse)),
    ]
}

/// Neither seams nor the topology may change.
fn keeping(options: &RemovalOptions) -> RemovalOptions {
    options.clone().with_seams(SeamRule::Keep).with_topology(TopologyRule::Keep)
}

/// Runs a check on each mesh in each way and fails with the list of all that failed it.
fn check_each(meshes: Vec<Named>, check: impl Fn(&str, &IndexedMesh, &RemovalOptions)) {
    let mut failed = Vec::new();
    for (name, mesh) in meshes {
        for (way, options) in ways() {
            let name = format!("{name}, {way}");
            if catch_unwind(AssertUnwindSafe(|| check(&name, &mesh, &options))).is_err() {
                failed.push(name);
            }
        }
    }
    assert!(failed.is_empty(), "failed: {failed:#?}");
}

/// Triangles of a mesh with corners named by their vertices of the input.
fn by_source(triangles: &[[u32; 3]], source: &[u32]) -> Vec<[u32; 3]> {
    canonical_triangles(&triangles.iter().map(|t| t.map(|v| source[v as usize])).collect::<Vec<_>>())
}

/// What holds for the fragments of any sound mesh.
fn check_fragments(name: &str, input: &IndexedMesh, options: &RemovalOptions, built: &BuiltFragments) {
    let FragmentedMesh { mesh, fragments } = &built.fragmented;
    let welded = weld(input).expect("sound");
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
            assert!(ceiling <= options.degree_limit, "{name}: step {step} fills a hole of {ceiling}");
            assert!(floor > 0, "{name}: step {step} fills {ceiling} by nothing");
        }
        // Positions that have lost all triangles take steps of their own.
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
            // Otherwise errors of levels alone differ from those of any state.
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
fn every_mesh_keeps_the_promises() {
    check_each(all(), |name, mesh, options| {
        check_fragments(name, mesh, options, &build(mesh, options));
        let keeping = keeping(options);
        check_fragments(name, mesh, &keeping, &build(mesh, &keeping));
    });
}

#[test]
fn every_mesh_ends_at_a_handful() {
    check_each(all(), |_, mesh, options| {
        let built = build(mesh, options);
        let levels = built.fragmented.fragments.levels();
        let left = levels.triangle_count_at(0);
        // Three positions have triangles that only go all together.
        assert!(left <= 8 || levels.base_position_count() <= 3, "{left} triangles left");
        assert_eq!(left == 0, built.fragmented.mesh.triangle_count() == 0, "the last triangles stay");
        let base = replay_fragments(&built.fragmented, 0).without_unused_vertices();
        let used: BTreeSet<_> = base.positions.iter().map(|&p| key(p)).collect();
        assert_eq!(used.len(), levels.base_position_count(), "every position of the base is used");
    });
}

#[test]
fn manifolds_keep_their_topology_at_every_level() {
    check_each([closed(), open()].concat(), |_, mesh, options| {
        let expected = Topology::of(mesh);
        assert!(expected.genus.is_some() && expected.duplicate_triangle_count == 0);
        let options = options.clone().with_topology(TopologyRule::Keep);
        let fragmented = build(mesh, &options).fragmented;
        for split_count in (0..=fragmented.fragments.step_count()).rev() {
            assert_eq!(
                Topology::of(&replay_fragments(&fragmented, split_count)),
                expected,
                "at {split_count}"
            );
        }
    });
}

#[test]
fn surfaces_without_seams_run_down_to_a_handful() {
    let limits = [
        ("icosphere", 4),
        ("uv sphere", 8),
        ("torus", 24),
        ("rough torus", 24),
        ("two bodies", 30),
        ("flat grid", 4),
        ("terrain", 12),
    ];
    let meshes = [closed(), open()].concat();
    let plain = meshes.into_iter().filter(|(name, _)| limits.iter().any(|(n, _)| n == name)).collect();
    check_each(plain, |name, mesh, options| {
        let built = build(mesh, options);
        let (_, limit) = limits.iter().find(|(n, _)| name.starts_with(&format!("{n},"))).expect("filtered");
        let count = built.fragmented.fragments.levels().triangle_count_at(0);
        assert!(count <= *limit, "{count} triangles left");
        assert_eq!(built.stop_reason, StopReason::BaseReached);
    });
}

#[test]
fn seams_cut_every_level_into_the_same_pieces() {
    let pieces = |mesh: &IndexedMesh| {
        let adjacency = Adjacency::of_vertices(&mesh.without_unused_vertices());
        (adjacency.component_count(), adjacency.boundary_loop_count(), adjacency.bow_ties().len())
    };
    let seamed = [
        ("cylinder", shapes::uv_cylinder(20, 9)),
        ("two materials", shapes::two_material_sphere(9, 12)),
        ("hard cube", shapes::hard_cube()),
    ];
    check_each(seamed.map(|(name, mesh)| (name.to_owned(), mesh)).to_vec(), |name, mesh, options| {
        let welded = weld(mesh).expect("shapes are sound").mesh;
        let fragmented = build(mesh, &keeping(options)).fragmented;
        let step_count = fragmented.fragments.step_count();
        assert!(
            name.starts_with("hard cube") || step_count > welded.vertex_count() / 2,
            "{step_count} steps"
        );
        for split_count in (0..=step_count).rev() {
            let level = replay_fragments(&fragmented, split_count);
            assert_eq!(pieces(&level), pieces(&welded), "at {split_count}");
        }
    });
}

/// A position as its bits, 0 and -0 being one.
fn key(p: [f32; 3]) -> [u32; 3] {
    p.map(|x| (x + 0.0).to_bits())
}

fn base_places(built: &BuiltFragments) -> BTreeSet<[u32; 3]> {
    let FragmentedMesh { mesh, fragments } = &built.fragmented;
    mesh.positions[..fragments.levels().base_vertex_count()].iter().map(|&p| key(p)).collect()
}

#[test]
fn locked_vertices_are_in_the_base() {
    check_each(all(), |_, mesh, options| {
        let locked: Vec<u32> = mesh.triangles.iter().flatten().copied().step_by(7).take(12).collect();
        let built = build(mesh, &options.clone().with_locked_vertices(locked.clone()));
        let base = base_places(&built);
        let welded = weld(mesh).expect("sound");
        for &v in &locked {
            let is_shown = welded.position_of_source[v as usize] != u32::MAX;
            assert!(base.contains(&key(mesh.positions[v as usize])) || !is_shown, "vertex {v} was locked");
        }
    });
}

/// Places on the boundary.
fn boundary_of(mesh: &IndexedMesh) -> BTreeSet<[u32; 3]> {
    let welded = weld(mesh).expect("test meshes are sound");
    let adjacency = Adjacency::of_positions(&welded.mesh, &welded.positions);
    let place = |p: u32| key(welded.mesh.positions[welded.positions.first_vertex(p) as usize]);
    adjacency.edges().filter(|e| e.is_boundary()).flat_map(|e| e.ends).map(place).collect()
}

#[test]
fn locked_boundaries_keep_every_vertex() {
    check_each([open(), closed()].concat(), |_, mesh, options| {
        let boundary = boundary_of(mesh);
        let built = build(mesh, &options.clone().with_boundary(BoundaryRule::Locked));
        assert!(boundary.is_subset(&base_places(&built)), "a boundary vertex went");
    });
}

#[test]
fn locked_group_borders_keep_every_vertex() {
    let sphere = shapes::two_material_sphere(13, 24);
    let on_border = |p: &[f32; 3]| p[2].abs() < 1e-6;
    let border: BTreeSet<[u32; 3]> = sphere.positions.iter().copied().filter(on_border).map(key).collect();
    assert_eq!(border.len(), 24, "the equator");
    let base = |rule| base_places(&build(&sphere, &RemovalOptions::default().with_group_borders(rule)));
    assert!(!border.is_subset(&base(BoundaryRule::Kept)), "borders that are not locked are simplified");
    let base = base(BoundaryRule::Locked);
    assert!(border.is_subset(&base), "a vertex of the border went");
    assert!(base.len() < 2 * border.len(), "{} positions: the rest is simplified", base.len());
}

#[test]
fn inner_vertices_stay_off_the_boundary() {
    check_each(open(), |_, mesh, options| {
        let boundary = boundary_of(mesh);
        let fragmented = build(mesh, options).fragmented;
        for split_count in 0..=fragmented.fragments.step_count() {
            let level = replay_fragments(&fragmented, split_count);
            assert!(boundary_of(&level).is_subset(&boundary), "at {split_count}");
        }
    });
}

#[test]
fn degree_limits_hold() {
    let meshes = vec![
        ("fan".to_owned(), shapes::closed_fan(30)),
        ("sphere".to_owned(), shapes::uv_sphere(9, 14, 3.0)),
    ];
    check_each(meshes, |name, mesh, options| {
        for limit in [3, 5, 8, 16] {
            let options = options.clone().with_degree_limit(limit).with_topology(TopologyRule::Keep);
            check_fragments(name, mesh, &options, &build(mesh, &options));
        }
    });
}

#[test]
fn no_error_exceeds_the_limit_and_others_go_on() {
    check_each([closed(), open()].concat(), |_, mesh, options| {
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

/// How far the welded mesh is from a level at most, as far as samples see it.
fn measured(built: &BuiltFragments, split_count: usize) -> f64 {
    let level = replay_fragments(&built.fragmented, split_count);
    let options = DistanceOptions::default().with_sample_count(20_000);
    surface_distance(&built.fragmented.mesh, &level, &options).expect("both have triangles").a_to_b.max
}

#[test]
fn errors_are_never_exceeded_and_seldom_large() {
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
    // A sphere of radius 1 within 0.02 takes about this many triangles at least: a cap of that height has a radius of
    // sqrt(2 * 0.02), and an equilateral triangle in it covers 3 sqrt(3) / 4 of its square.
    let needed = 4.0 * std::f64::consts::PI / (1.299 * 0.04);
    let sphere = shapes::icosphere(4, 1.0);
    let built = build(&sphere, &RemovalOptions::default().with_max_error(0.02));
    let count = built.fragmented.fragments.levels().triangle_count_at(0);
    assert_eq!(built.stop_reason, StopReason::ErrorLimit);
    assert!((count as f64) < 1.8 * needed, "{count} triangles, {needed:.0} needed");
    let collapsed = build_sequence(&sphere, &SequenceOptions::default()).expect("sound");
    let certified = certify_collapses(&collapsed.refinable);
    let levels = certified.sequence.levels();
    let by_collapses = levels.triangle_count_at(levels.split_count_for_error(0.02));
    assert!(count < by_collapses, "{count} triangles, {by_collapses} by collapses");
}

#[test]
fn features_stay() {
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

/// The middle of a mesh along an axis.
fn mid(mesh: &IndexedMesh, axis: usize) -> f32 {
    let bounds = mesh.bounds().expect("vertices");
    0.5 * (bounds.min[axis] + bounds.max[axis])
}

#[test]
fn flat_places_go_without_error() {
    let grid = build(&shapes::grid(20, 20), &RemovalOptions::default().with_max_error(1e-6));
    let count = grid.fragmented.fragments.levels().triangle_count_at(0);
    assert!(count <= 12, "{count} triangles left of a flat grid");
}

#[test]
fn the_base_triangle_count_is_undercut_by_less_than_a_step() {
    check_each(all(), |_, mesh, options| {
        let free = build(mesh, options).fragmented.fragments;
        let levels = free.levels();
        let goal =
            usize::midpoint(levels.triangle_count_at(0), levels.triangle_count_at(levels.step_count()));
        let built = build(mesh, &options.clone().with_base_triangle_count(goal));
        let found = built.fragmented.fragments.levels();
        assert!(found.triangle_count_at(0) <= goal);
        // The first steps may bring back positions that have no triangle yet.
        let mut counts = (0..=found.step_count()).map(|s| found.triangle_count_at(s));
        let more = counts.find(|&n| n > found.triangle_count_at(0));
        assert!(more.is_none_or(|n| n > goal), "went too far");
        if goal > levels.triangle_count_at(0) {
            assert_eq!(built.stop_reason, StopReason::TargetReached);
        }
    });
}

#[test]
fn options_out_of_range_are_refused() {
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
    for (name, options) in cases {
        match build_fragments(&mesh, &options) {
            Err(SimplifyError::Option { option, .. }) => assert_eq!(option, name),
            other => panic!("{name} in {options:?}: {:?}", other.map(|built| built.stop_reason)),
        }
    }
}

#[test]
fn unsound_meshes_are_refused_with_their_place() {
    let mut count = 0;
    for (name, mesh) in shapes::nasty() {
        let Err(expected) = mesh.check() else { continue };
        let error = build_fragments(&mesh, &RemovalOptions::default()).unwrap_err();
        // Compared as text, since NaN is not equal to itself.
        assert_eq!(error.to_string(), expected.to_string(), "{name}");
        count += 1;
    }
    assert!(count > 5);
}

#[test]
fn the_callback_sees_progress_and_can_cancel() {
    let mesh = shapes::torus(110, 80, 2.0, 1.0);
    let mut seen = Vec::new();
    let mut watch = |progress: striata::Progress| {
        seen.push((progress.phase, progress.done, progress.total));
        ControlFlow::Continue(())
    };
    build_fragments_with_progress(&mesh, &RemovalOptions::default(), &mut watch).expect("nobody cancels");
    assert!(!seen.is_empty());
    assert!(seen.iter().all(|(_, done, total)| done <= total), "{seen:?}");
    let mut calls = 0;
    let mut cancel = |_| {
        calls += 1;
        ControlFlow::Break(())
    };
    let error = build_fragments_with_progress(&mesh, &RemovalOptions::default(), &mut cancel).unwrap_err();
    assert_eq!(error, SimplifyError::Cancelled(striata::Cancelled));
    assert_eq!(calls, 1, "nothing is asked again after a cancellation");
}

#[test]
fn the_same_input_gives_the_same_fragments() {
    check_each(all(), |_, mesh, options| {
        let (one, other) = (build(mesh, options), build(mesh, options));
        assert_eq!(one.fragmented.fragments, other.fragmented.fragments);
        assert_eq!(one.source_vertex, other.source_vertex);
    });
}

#[test]
fn no_triangle_of_a_sphere_turns_inward() {
    let mesh = shapes::icosphere(3, 1.0);
    for (way, options) in ways() {
        let fragmented = build(&mesh, &options).fragmented;
        let levels = fragmented.fragments.levels();
        let from = levels.split_count_for_triangles(60);
        for split_count in (from..=levels.step_count()).step_by(7) {
            let level = replay_fragments(&fragmented, split_count);
            for t in &level.triangles {
                let [a, b, c] = t.map(|v| glam::Vec3::from(level.positions[v as usize]));
                assert!((b - a).cross(c - a).dot(a + b + c) > 0.0, "{way} at {split_count}: triangle {t:?}");
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn random_soups_keep_the_promises(count in 1u32..160, seed: u64, way in 0usize..4) {
        let mesh = shapes::random_soup(count, seed);
        let options = &ways()[way].1;
        check_fragments("soup", &mesh, options, &build(&mesh, options));
    }

    #[test]
    fn random_patches_keep_the_promises(
        (rings, segments) in (3u32..12, 3u32..12),
        run in 1usize..40,
        seed: u64,
        way in 0usize..4,
    ) {
        let rough = meshes::rough(shapes::torus(rings, segments, 2.0, 1.0), 0.2, seed);
        let mesh = with_patches(rough, run);
        let options = &ways()[way].1.clone().with_topology(TopologyRule::Keep);
        let built = build(&mesh, options);
        check_fragments("patches", &mesh, options, &built);
        for split_count in 0..=built.fragmented.fragments.step_count() {
            let level = replay_fragments(&built.fragmented, split_count);
            prop_assert_eq!(Topology::of(&level).genus, Some(1));
        }
    }

    #[test]
    fn random_assets_keep_the_promises(pieces in 1usize..5, seed: u64, way in 0usize..4, locks: bool) {
        let mesh = meshes::asset(pieces, seed);
        let mut options = ways()[way].1.clone();
        if locks {
            options = options
                .with_locked_vertices((0..mesh.vertex_count() as u32).step_by(29).collect())
                .with_group_borders(BoundaryRule::Locked);
        }
        let built = build(&mesh, &options);
        check_fragments("asset", &mesh, &options, &built);
        let base = base_places(&built);
        let welded = weld(&mesh).expect("assets are sound");
        let locked = options.locked_vertices.iter().filter(|&&v| welded.position_of_source[v as usize] != u32::MAX);
        for &v in locked {
            prop_assert!(base.contains(&key(mesh.positions[v as usize])), "vertex {} was locked", v);
        }
        let left = built.fragmented.fragments.levels().triangle_count_at(0);
        prop_assert!(locks || left <= 24, "{} left", left);
    }
}
