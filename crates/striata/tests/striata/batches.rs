//! Checks batches of collapses against what a progressive coder relies on, on every mesh of the test set.
//! The checker is independent of how the batches were found.

use striata_testing::{meshes, simplifier, support, test_guarantees};

use std::collections::BTreeSet;

use meshes::{NamedMesh, all, asset, by_cost, check_each_variant, closed, open, rough, with_patches};
use proptest::prelude::*;
use striata::mesh::{IndexedMesh, RefinableMesh, Statistics, canonical_triangles, replay, shapes, weld};
use striata::simplify::{
    BatchOptions, BoundaryRule, BuiltBatches, SequenceOptions, StopReason, TopologyRule, build_batches,
    build_welded_batches,
};
use support::{ClosedSurface, nasty};

test_guarantees! {
    BatchOptions:
    locked_vertices_are_in_the_base,
    locked_boundaries_keep_every_vertex,
    invalid_meshes_are_rejected_with_the_location,
    the_callback_sees_progress_and_can_cancel,
}

fn build(mesh: &IndexedMesh, options: &BatchOptions) -> BuiltBatches {
    build_batches(mesh, options).expect("valid meshes can be simplified")
}

/// Batches that are limited to splits of a surface.
fn surface_only() -> BatchOptions {
    BatchOptions::default().with_general(false)
}

/// Options without limits.
fn unlimited() -> BatchOptions {
    surface_only().with_min_batch_size(1)
}

fn position_triangles(refinable: &RefinableMesh, mesh: &IndexedMesh) -> Vec<[u32; 3]> {
    let positions = refinable.sequence.positions();
    mesh.triangles.iter().map(|t| t.map(|v| positions.position_of(v))).collect()
}

/// The position that a removed position collapses to.
fn target_of(refinable: &RefinableMesh, position: u32) -> u32 {
    let positions = refinable.sequence.positions();
    positions.position_of(refinable.sequence.target(positions.first_vertex(position)))
}

/// Checks `v -> target` on a surface, whether or not the rest of the batch has been applied; returns both
/// copies.
fn check_collapse(surface: &ClosedSurface, v: u32, target: u32, max_valence: usize) -> (u32, u32) {
    let copies = surface.copies(v);
    assert_eq!(copies.len(), 1, "position {v} is one copy");
    let v = *copies.first().expect("one copy");
    let ring = surface.ring(v);
    assert!((3..=max_valence).contains(&ring.vertices.len()), "{v} has valence {}", ring.vertices.len());
    let u = surface.neighbor(v, target);
    let other = surface.unordered_ring(u);
    let shared = ring.vertices.intersection(&other.vertices).count();
    assert_eq!(shared, 2, "{v} -> {u}: neighbors in common");
    assert_eq!(ring.edges.intersection(&other.edges).count(), 0, "{v} -> {u}: ring edges in common");
    let hole = |vertices: &BTreeSet<u32>| vertices.iter().copied().find(|&w| !surface.is_real(w));
    if let Some(hole) = hole(&ring.vertices) {
        assert!(other.vertices.contains(&hole), "{v} -> {u}: leaves the boundary");
        assert!(ring.edges.contains(&[u.min(hole), u.max(hole)]), "{v} -> {u}: not along the boundary");
    }
    (v, u)
}

/// Each wedge of `v` on the collapsed edge must go to the wedge that shares the edge with it; others may
/// cross a seam.
fn check_wedges(refinable: &RefinableMesh, level: &IndexedMesh, v: u32, target: u32) {
    let positions = refinable.sequence.positions();
    let at = |t: &[u32; 3], p: u32| t.iter().copied().find(|&w| positions.position_of(w) == p);
    let (mut shown, mut paired) = (BTreeSet::new(), BTreeSet::new());
    for t in &level.triangles {
        let Some(from) = at(t, v) else { continue };
        shown.insert(from);
        if let Some(to) = at(t, target) {
            paired.insert(from);
            assert_eq!(refinable.sequence.target(from), to, "wedge {from} of position {v}");
        }
    }
    assert!(!paired.is_empty() && paired.is_subset(&shown), "wedges on the edge from {v} to {target}");
}

/// Checks everything that a coder relies on.
fn check_batches(name: &str, options: &BatchOptions, built: &BuiltBatches) {
    eprintln!("{name}");
    let refinable = &built.built.refinable;
    let sequence = &refinable.sequence;
    let batches = &built.batches;
    assert_eq!((batches[0], batches[batches.len() - 1]), (0, sequence.step_count() as u32));
    assert!(batches.windows(2).all(|w| w[0] < w[1]), "batches rise: {batches:?}");
    let base = sequence.base_position_count() as u32;
    let position_count = sequence.positions().position_count();
    let mut surface = ClosedSurface::new(position_count, &position_triangles(refinable, &refinable.mesh));
    let parts = surface.parts();
    for window in batches.windows(2).rev() {
        let steps = window[0]..window[1];
        let errors = &sequence.errors()[steps.start as usize..steps.end as usize];
        assert!(errors.iter().all(|e| *e == errors[0]), "a batch has one error");
        let level = replay(refinable, steps.end as usize);
        let removed: Vec<[u32; 2]> = steps.map(|s| [base + s, target_of(refinable, base + s)]).collect();
        let gone: BTreeSet<u32> = removed.iter().map(|r| r[0]).collect();
        let targets: BTreeSet<u32> = removed.iter().map(|r| r[1]).collect();
        assert_eq!(targets.len(), removed.len(), "a target has one position of a batch");
        assert!(gone.is_disjoint(&targets), "targets stay");
        for t in surface.real_triangles() {
            assert!(t.iter().filter(|p| gone.contains(p)).count() <= 1, "removed neighbors in {t:?}");
        }
        for &[v, target] in &removed {
            assert!(surface.is_manifold(v), "position {v} is manifold in the full mesh");
            check_collapse(&surface, v, target, options.max_valence);
            check_wedges(refinable, &level, v, target);
        }
        surface = collapse_in_both_orders(&surface, &removed, options.max_valence);
        check_surface(&surface, refinable, window[0] as usize);
    }
    for (part, (triangle_count, is_closed)) in parts {
        let left = surface.parts().get(&part).map_or(0, |p| p.0);
        assert!(
            left >= if is_closed { 4.min(triangle_count) } else { 1 },
            "part {part} has {left} triangles"
        );
    }
}

fn collapse_in_both_orders(
    surface: &ClosedSurface,
    removed: &[[u32; 2]],
    max_valence: usize,
) -> ClosedSurface {
    let collapsed = |order: &mut dyn Iterator<Item = &[u32; 2]>| {
        let mut surface = surface.clone();
        for &[v, target] in order {
            let (v, u) = check_collapse(&surface, v, target, max_valence);
            surface.collapse(v, u);
        }
        surface
    };
    let (one, other) = (collapsed(&mut removed.iter().rev()), collapsed(&mut removed.iter()));
    assert_eq!(canonical_triangles(&one.triangles), canonical_triangles(&other.triangles), "order counts");
    one
}

/// Checks that the surface matches the oracle and is as manifold as the full mesh was.
fn check_surface(surface: &ClosedSurface, refinable: &RefinableMesh, split_count: usize) {
    let level = replay(refinable, split_count);
    let expected = canonical_triangles(&position_triangles(refinable, &level));
    assert_eq!(canonical_triangles(&surface.real_triangles()), expected, "split count {split_count}");
    let present = refinable.sequence.base_position_count() + split_count;
    for p in (0..present as u32).filter(|&p| surface.is_manifold(p)) {
        let copies = surface.copies(p);
        assert_eq!(copies.len(), 1, "position {p} is one copy");
        surface.ring(*copies.first().expect("one copy"));
        // Two copies of one position must not become adjacent either.
        let around = expected.iter().filter(|t| t.contains(&p)).flatten().filter(|&&q| q != p);
        let mut around: Vec<u32> = around.copied().collect();
        around.sort_unstable();
        assert!(around.chunk_by(|a, b| a == b).all(|run| run.len() <= 2), "position {p} is not manifold");
    }
}

fn check_all(meshes: Vec<NamedMesh>, variants: &[(&str, BatchOptions)]) {
    check_each_variant(meshes, variants, |name, mesh, options| {
        check_batches(name, options, &build(mesh, options))
    });
}

#[test]
fn batches_satisfy_the_guarantees_on_all_meshes() {
    let variants = [
        ("default", surface_only()),
        ("to the end", unlimited()),
        ("one batch", unlimited().with_share(1.0).with_max_valence(12)),
        ("shape", unlimited().with_shape_step(Some(0.05)).with_max_valence(6)),
    ];
    let nasty = nasty().into_iter().map(|(name, mesh)| (name.to_owned(), mesh));
    check_all(all().into_iter().chain(nasty).collect(), &variants);
}

#[test]
fn batches_satisfy_the_guarantees_with_every_cost() {
    let variants: Vec<_> =
        by_cost().into_iter().map(|(_, options)| ("", unlimited().with_sequence(options))).collect();
    check_all([closed(), open()].concat(), &variants);
}

proptest! {
    #![proptest_config(striata_testing::cases(150))]

    #[test]
    fn batches_satisfy_the_guarantees_on_soups(
        seed: u64, triangle_count in 1u32..120, has_patches: bool, share in 0.05f64..1.0
    ) {
        let mut mesh = shapes::random_soup(triangle_count, seed);
        if has_patches {
            mesh = with_patches(mesh, 3);
        }
        let options = unlimited().with_share(share);
        check_batches("soup", &options, &build(&mesh, &options));
    }

    #[test]
    fn batches_satisfy_the_guarantees_on_surfaces_with_holes(
        seed: u64, holes in proptest::collection::vec(0usize..400, 0..40), has_patches: bool
    ) {
        let mut mesh = rough(shapes::torus(20, 10, 2.0, 0.8), 0.1, seed);
        for hole in holes {
            mesh.triangles.swap_remove(hole % mesh.triangles.len());
        }
        if has_patches {
            mesh = with_patches(mesh, 7);
        }
        check_batches("holes", &unlimited(), &build(&mesh, &unlimited()));
    }
}

#[test]
fn surfaces_shrink_to_small_bases() {
    let cases = [
        (shapes::icosphere(4, 1.0), 40),
        (shapes::torus(60, 40, 2.0, 0.7), 60),
        (shapes::terrain(49, 3), 60),
        (with_patches(shapes::torus(60, 40, 2.0, 0.7), 600), 700),
    ];
    for (mesh, most) in cases {
        let built = build(&mesh, &surface_only());
        let sequence = &built.built.refinable.sequence;
        let left = sequence.base_position_count();
        assert!(left <= most, "{left} positions are left of {}", sequence.positions().position_count());
        assert_eq!(built.built.stop_reason, StopReason::BaseReached);
        // Each batch removes about a tenth of the positions.
        assert!(built.batches.len() < 80, "{} batches", built.batches.len());
    }
}

#[test]
fn coincident_copies_shrink_to_small_bases() {
    let ball = shapes::icosphere(3, 1.0);
    let sheet = rough(shapes::grid(24, 24), 0.01, 3);
    // The last number is that of the copies if all of them must have the same triangles after each batch.
    // Those of opposite orientation differ by rounding, and decals by their borders.
    let cases = [
        ("twice", meshes::copies(&ball, 2), 40, Some(2)),
        ("on joints", meshes::on_joints(&ball, 8), 160, Some(8)),
        ("inside out", meshes::inside_out(ball), 40, None),
        ("two-sided", meshes::two_sided(sheet.clone()), 60, None),
        ("decal", meshes::decal(sheet), 60, None),
    ];
    for (name, mesh, most, alike) in cases {
        let built = build(&mesh, &surface_only());
        check_batches(name, &surface_only(), &built);
        let RefinableMesh { mesh: refined, sequence } = &built.built.refinable;
        let left = sequence.base_position_count();
        assert!(left <= most, "{name}: {left} positions of {}", sequence.positions().position_count());
        assert_eq!(refined.triangle_count(), mesh.triangle_count(), "{name}");
        for &start in built.batches.iter().filter(|_| alike.is_some()) {
            let level = replay(&built.built.refinable, start as usize);
            let place = |t: &[u32; 3]| {
                let mut corners = t.map(|v| level.positions[v as usize].map(f32::to_bits));
                corners.sort_unstable();
                corners
            };
            let mut places: Vec<_> = level.triangles.iter().map(place).collect();
            places.sort_unstable();
            let mut counts = places.chunk_by(|a, b| a == b).map(<[_]>::len);
            assert!(counts.all(|count| Some(count) == alike), "{name}: split count {start}");
        }
    }
}

/// Pages at a spine, and parts on different joints that share only a boundary, are no copies.
#[test]
fn surfaces_without_copies_stay_together() {
    let mut halves = rough(shapes::icosphere(2, 1.0), 0.01, 1);
    let upper = |p: &[f32; 3]| u16::from(p[2] > 0.0);
    let joints = halves.positions.iter().flat_map(|p| [upper(p), 0, 0, 0]).collect();
    let weights = [1.0, 0.0, 0.0, 0.0].repeat(halves.vertex_count());
    halves.layers = meshes::skin(joints, weights);
    for mesh in [shapes::book(30), halves] {
        let welded = weld(&mesh).expect("a valid mesh");
        let built = build(&mesh, &surface_only());
        let positions = built.built.refinable.sequence.positions();
        assert_eq!(positions.position_count(), welded.positions.position_count());
        assert_eq!(built.built.merged_vertex_count, welded.merged_vertex_count);
    }
}

/// Locked vertices stay with all their copies.
#[test]
fn locked_copies_stay() {
    let mesh = meshes::copies(&shapes::icosphere(2, 1.0), 2);
    let locked = SequenceOptions::default().with_locked_vertices(vec![5]);
    let built = build(&mesh, &surface_only().with_sequence(locked)).built.refinable;
    let base = &built.mesh.positions[..built.sequence.base_vertex_count()];
    assert!(base.contains(&mesh.positions[5]), "the locked vertex is in the base");
    let used = replay(&built, 0)
        .triangles
        .iter()
        .flatten()
        .filter(|&&v| base[v as usize] == mesh.positions[5])
        .count();
    assert!(used >= 6, "both copies have triangles at the locked vertex");
}

#[test]
fn general_batches_simplify_assets() {
    for seed in 0..8 {
        let mesh = asset(30, seed);
        let [surface, general] = [surface_only(), BatchOptions::default().with_general_floor(40)]
            .map(|options| build(&mesh, &options));
        let left = |built: &BuiltBatches| built.built.refinable.sequence.triangle_count_at(0);
        assert!(left(&general) <= 40 && left(&surface) > 100, "{} and {}", left(&general), left(&surface));
        let RefinableMesh { sequence, .. } = &general.built.refinable;
        for split_count in 0..=sequence.step_count() {
            let level = replay(&general.built.refinable, split_count);
            assert_eq!(
                level.triangle_count(),
                sequence.triangle_count_at(split_count),
                "level {split_count}"
            );
        }
        let sequence = SequenceOptions::default().with_topology(TopologyRule::Keep);
        let kept = build(&mesh, &BatchOptions::default().with_general_floor(0).with_sequence(sequence));
        assert!(left(&kept) > left(&general), "the topology stays");
    }
}

#[test]
fn closed_scans_have_no_general_batches_above_the_floor() {
    for mesh in [shapes::icosphere(4, 1.0), rough(shapes::torus(60, 40, 2.0, 0.7), 0.01, 3)] {
        let general = BatchOptions::default().with_general_floor(300);
        let [with, without] = [general, surface_only()].map(|options| build(&mesh, &options));
        assert_eq!((with.built.refinable, with.batches), (without.built.refinable, without.batches));
    }
}

#[test]
fn limits_are_respected() {
    let mesh = rough(shapes::torus(40, 30, 2.0, 0.7), 0.01, 5);
    let sequence = || SequenceOptions::default();
    let limited = |sequence| build(&mesh, &surface_only().with_sequence(sequence)).built;
    let base = limited(sequence().with_base_triangle_count(500));
    assert_eq!(base.stop_reason, StopReason::TargetReached);
    assert!((498..=500).contains(&base.refinable.sequence.triangle_count_at(0)));
    let error = limited(sequence().with_max_error(0.05));
    assert_eq!(error.stop_reason, StopReason::ErrorLimit);
    assert!(error.refinable.sequence.error_at(0) <= 0.05 && error.refinable.sequence.step_count() > 100);
    let locked: Vec<u32> = (0..1200).step_by(5).collect();
    let built = limited(sequence().with_locked_vertices(locked.clone()));
    let base = built.refinable.sequence.base_vertex_count();
    assert!(locked.iter().all(|v| built.source_vertex[..base].contains(v)), "locked vertices stay");
    let terrain = shapes::terrain(17, 5);
    let options = BatchOptions::default().with_sequence(sequence().with_boundary(BoundaryRule::Locked));
    let built = build(&terrain, &options).built;
    let boundary = |mesh: &IndexedMesh| Statistics::of(mesh).expect("valid").boundary_edge_count;
    assert_eq!(boundary(&replay(&built.refinable, 0)), boundary(&terrain), "a locked boundary stays");
    assert!(built.refinable.sequence.step_count() > 100);
    let sphere = shapes::two_material_sphere(21, 40);
    let options = BatchOptions::default().with_sequence(sequence().with_group_borders(BoundaryRule::Locked));
    let RefinableMesh { mesh, sequence } = build(&sphere, &options).built.refinable;
    let base = mesh.positions[..sequence.base_vertex_count()].iter();
    let border: BTreeSet<_> =
        base.filter(|p| p[2].abs() < 1e-6).map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
    assert_eq!(border.len(), 40, "a locked border between groups stays");
}

#[test]
fn options_out_of_range_are_rejected() {
    let mesh = shapes::icosphere(1, 1.0);
    let cases = [
        ("share", BatchOptions::default().with_share(0.0)),
        ("share", BatchOptions::default().with_share(1.5)),
        ("share", BatchOptions::default().with_share(f64::NAN)),
        ("shape_step", BatchOptions::default().with_shape_step(Some(-1.0))),
        ("valence_weight", BatchOptions::default().with_valence_weight(f64::INFINITY)),
        ("max_valence", BatchOptions::default().with_max_valence(2)),
        (
            "pair_distance",
            BatchOptions::default().with_sequence(SequenceOptions::default().with_pair_distance(0.1)),
        ),
        (
            "locked_vertices",
            BatchOptions::default()
                .with_sequence(SequenceOptions::default().with_locked_vertices(vec![9999])),
        ),
    ];
    simplifier::rejects(&mesh, &cases);
}

#[test]
fn same_input_gives_same_batches() {
    let mesh = with_patches(rough(shapes::torus(40, 30, 2.0, 0.7), 0.05, 9), 50);
    let [one, other] = [(); 2].map(|()| {
        let welded = weld(&mesh).expect("a valid mesh");
        build_welded_batches(welded, &surface_only()).expect("a valid mesh")
    });
    assert_eq!(one.built.refinable, other.built.refinable);
    assert_eq!(one.batches, other.batches);
}
