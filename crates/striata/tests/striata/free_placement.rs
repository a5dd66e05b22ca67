//! Free placement: one level whose vertices can lie anywhere.

use striata_testing::meshes;

use std::collections::BTreeSet;
use std::ops::ControlFlow;

use proptest::prelude::*;
use striata::mesh::{Adjacency, AttributeLayer, IndexedMesh, Semantic, Statistics, shapes, weld};
use striata::simplify::{
    BoundaryRule, Placement, SeamRule, SequenceOptions, Simplified, SimplifyError, SimplifyOptions,
    StopReason, Target, TopologyRule, simplify, simplify_with_progress,
};

fn options(target: Target) -> SimplifyOptions {
    SimplifyOptions::default().with_placement(Placement::Optimal).with_target(target)
}

fn run(mesh: &IndexedMesh, options: &SimplifyOptions) -> Simplified {
    let out = simplify(mesh, options).unwrap();
    out.mesh.check().unwrap();
    out
}

fn to_triangles(mesh: &IndexedMesh, count: usize) -> IndexedMesh {
    let out = run(mesh, &options(Target::Triangles(count)));
    assert_eq!(out.stop_reason, StopReason::TargetReached);
    assert!((count - 1..=count).contains(&out.mesh.triangle_count()), "{}", out.mesh.triangle_count());
    out.mesh
}

/// Volume inside a closed mesh.
fn volume(mesh: &IndexedMesh) -> f64 {
    let at = |v: u32| mesh.positions[v as usize].map(f64::from);
    let six_fold = |t: &[u32; 3]| {
        let [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = t.map(at);
        ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    };
    mesh.triangles.iter().map(six_fold).sum::<f64>() / 6.0
}

#[test]
fn nothing_panics_on_nasty_meshes() {
    for (name, mesh) in meshes::nasty() {
        let targets = [
            Target::Triangles(0),
            Target::Vertices(3),
            Target::Detail(0.5),
            Target::Error(mesh.diagonal() * 0.1),
            Target::SplitCount(2),
        ];
        for target in targets {
            let valid = options(target).check().is_ok();
            match simplify(&mesh, &options(target)) {
                Ok(out) => {
                    out.mesh.check().unwrap_or_else(|e| panic!("{name}, {target:?}: {e}"));
                    assert!(out.mesh.triangle_count() <= mesh.triangle_count(), "{name}, {target:?}");
                    assert!(out.error >= 0.0, "{name}, {target:?}: {}", out.error);
                }
                Err(e) => assert!(!valid || mesh.check().is_err(), "{name}, {target:?}: {e}"),
            }
        }
    }
}

#[test]
fn sphere_stays_a_sphere() {
    let sphere = shapes::icosphere(5, 1.0);
    let full = volume(&sphere);
    for count in [5_000, 1_000, 200] {
        let mesh = to_triangles(&sphere, count);
        let statistics = Statistics::of(&mesh).unwrap();
        assert!(statistics.is_closed);
        assert_eq!((statistics.genus, statistics.component_count), (Some(0), 1));
        let ratio = volume(&mesh) / full;
        assert!((ratio - 1.0).abs() < 1e-3, "{count} triangles: {ratio} of the volume");
    }
}

#[test]
fn torus_keeps_its_handle_down_to_the_base() {
    let torus = shapes::torus(60, 30, 2.0, 0.7);
    let statistics = Statistics::of(&to_triangles(&torus, 300)).unwrap();
    assert_eq!((statistics.genus, statistics.is_closed), (Some(1), true));
    let keep = SequenceOptions::default().with_topology(TopologyRule::Keep);
    let base = run(&torus, &options(Target::Detail(0.0)).with_sequence(keep));
    assert_eq!(base.stop_reason, StopReason::TargetReached);
    assert!(base.mesh.triangle_count() < 60, "{}", base.mesh.triangle_count());
    assert_eq!(Statistics::of(&base.mesh).unwrap().genus, Some(1));
}

#[test]
fn flat_boundary_stays() {
    let mesh = to_triangles(&shapes::grid(40, 40), 50);
    let statistics = Statistics::of(&mesh).unwrap();
    assert!((statistics.area - 1_600.0).abs() < 1e-2, "{}", statistics.area);
    assert_eq!((statistics.boundary_loop_count, statistics.non_manifold_edge_count), (1, 0));
    assert!(mesh.positions.iter().all(|p| p[2] == 0.0));
    let bounds = statistics.bounds.unwrap();
    for axis in 0..2 {
        assert!(bounds.min[axis].abs() < 1e-3 && (bounds.max[axis] - 40.0).abs() < 1e-3, "{bounds:?}");
    }
}

#[test]
fn curved_boundary_keeps_its_course() {
    // The rims of a cylinder are circles: their vertices stay close to them, at constant height.
    let mesh = to_triangles(&shapes::uv_cylinder(96, 24), 600);
    let statistics = Statistics::of(&mesh).unwrap();
    assert_eq!(statistics.boundary_loop_count, 2);
    let bounds = statistics.bounds.unwrap();
    assert!(bounds.min[2].abs() < 1e-3 && (bounds.max[2] - 1.0).abs() < 1e-3, "{bounds:?}");
    for p in &mesh.positions {
        let radius = p[0].hypot(p[1]);
        assert!((radius - 1.0).abs() < 0.02, "{radius}");
    }
}

#[test]
fn locked_boundary_and_vertices_stay_bit_for_bit() {
    let terrain = shapes::terrain(24, 7);
    let bits = |p: &[f32; 3]| p.map(f32::to_bits);
    let boundary = |mesh: &IndexedMesh| -> BTreeSet<[u32; 3]> {
        let bounds = shapes::terrain(24, 7).bounds().unwrap();
        let is_rim = |p: &&[f32; 3]| (0..2).any(|a| p[a] == bounds.min[a] || p[a] == bounds.max[a]);
        mesh.positions.iter().filter(is_rim).map(bits).collect()
    };
    let inner: Vec<u32> = vec![200, 201, 333];
    let sequence =
        SequenceOptions::default().with_boundary(BoundaryRule::Locked).with_locked_vertices(inner.clone());
    let out = run(&terrain, &options(Target::Triangles(0)).with_sequence(sequence));
    assert_eq!(out.stop_reason, StopReason::BaseReached);
    assert!(out.mesh.triangle_count() * 4 < terrain.triangle_count(), "{}", out.mesh.triangle_count());
    assert!(boundary(&out.mesh).is_superset(&boundary(&terrain)));
    let left: BTreeSet<[u32; 3]> = out.mesh.positions.iter().map(bits).collect();
    assert!(inner.iter().all(|&v| left.contains(&bits(&terrain.positions[v as usize]))));
}

#[test]
fn locked_group_borders_stay_bit_for_bit() {
    let sphere = shapes::two_material_sphere(21, 40);
    let border = |mesh: &IndexedMesh| -> BTreeSet<[u32; 3]> {
        let on_border = mesh.positions.iter().filter(|p| p[2].abs() < 1e-6);
        on_border.map(|p| p.map(|x| (x + 0.0).to_bits())).collect()
    };
    let run = |rule| {
        let sequence = SequenceOptions::default().with_group_borders(rule);
        run(&sphere, &options(Target::Triangles(0)).with_sequence(sequence)).mesh
    };
    assert_eq!(border(&sphere).len(), 40, "the equator");
    assert!(border(&run(BoundaryRule::Kept)).len() < 40);
    let locked = run(BoundaryRule::Locked);
    assert!(border(&locked).is_superset(&border(&sphere)));
    assert!(locked.triangle_count() * 4 < sphere.triangle_count(), "{}", locked.triangle_count());
}

#[test]
fn a_locked_vertex_that_is_merged_into_an_equal_one_stays() {
    let mut terrain = shapes::terrain(24, 7);
    // The last triangle of an inner vertex uses a copy of it.
    let (inner, copy) = (333, terrain.vertex_count() as u32);
    terrain.positions.push(terrain.positions[inner as usize]);
    terrain.layers.clear();
    let last = terrain.triangles.iter_mut().rfind(|t| t.contains(&inner)).unwrap();
    last.iter_mut().filter(|v| **v == inner).for_each(|v| *v = copy);
    let place = terrain.positions[inner as usize].map(f32::to_bits);
    let sequence = SequenceOptions::default().with_locked_vertices(vec![copy]);
    let out = run(&terrain, &options(Target::Triangles(0)).with_sequence(sequence));
    assert!(out.mesh.positions.iter().any(|p| p.map(f32::to_bits) == place), "the locked vertex went");
}

#[test]
fn seam_of_a_cylinder_stays_a_seam() {
    let mesh = to_triangles(&shapes::uv_cylinder(64, 32), 500);
    let texcoords = mesh.layer(&Semantic::TexCoord(0)).unwrap();
    let normals = mesh.layer(&Semantic::Normal).unwrap();
    for t in &mesh.triangles {
        let u = t.map(|v| texcoords.get(v as usize, 0));
        let spread = u.iter().fold(0.0f32, |m, x| m.max(*x)) - u.iter().fold(1.0f32, |m, x| m.min(*x));
        assert!(spread < 0.5, "triangle {t:?} crosses the seam: {u:?}");
    }
    let mut on_seam = 0;
    for (v, p) in mesh.positions.iter().enumerate() {
        let length = (0..3).map(|c| normals.get(v, c).powi(2)).sum::<f32>();
        assert!((length - 1.0).abs() < 1e-4, "normal {v} has the squared length {length}");
        let [u, height] = [0, 1].map(|c| texcoords.get(v, c));
        // The texture wraps around once and extends once from bottom to top, so it determines where a
        // vertex must be.
        let turn = (p[1].atan2(p[0]) / std::f32::consts::TAU).rem_euclid(1.0);
        let off = (turn - u).abs();
        assert!(off.min(1.0 - off) < 0.03 && (height - p[2]).abs() < 0.06, "{p:?} has {u} {height}");
        on_seam += usize::from(u == 0.0 || u == 1.0);
    }
    assert!(on_seam >= 4, "{on_seam} vertices on the seam");
    let statistics = Statistics::of(&mesh).unwrap();
    assert_eq!((statistics.boundary_loop_count, statistics.component_count), (2, 1));
}

#[test]
fn groups_and_materials_stay() {
    let sphere = shapes::two_material_sphere(31, 48);
    let mesh = to_triangles(&sphere, 400);
    assert_eq!(mesh.groups.len(), 2);
    assert_eq!(mesh.appearance, sphere.appearance);
    // The boundary between the materials is the equator; each side stays in its half.
    let height = |g: usize| {
        let triangles = &mesh.triangles[mesh.groups[g].range()];
        assert!(!triangles.is_empty());
        triangles.iter().flatten().map(|&v| mesh.positions[v as usize][2]).sum::<f32>()
    };
    assert!(height(0) * height(1) < 0.0);
    let statistics = Statistics::of(&mesh).unwrap();
    assert_eq!((statistics.genus, statistics.is_closed), (Some(0), true));
}

#[test]
fn same_input_same_bytes() {
    let mesh = shapes::terrain(48, 3);
    let first = run(&mesh, &options(Target::Triangles(300)));
    let second = run(&mesh, &options(Target::Triangles(300)));
    assert_eq!(first.mesh, second.mesh);
    assert_eq!(first.error.to_bits(), second.error.to_bits());
}

#[test]
fn identifiers_are_not_interpolated() {
    let mut mesh = shapes::icosphere(3, 1.0);
    let id = |v: usize| (v * 197 % 300_001) as f32 - 1000.0;
    let ids: Vec<f32> = (0..mesh.vertex_count()).map(id).collect();
    let semantic = Semantic::Generic("FEATURE_ID_0".to_owned());
    mesh.layers.push(AttributeLayer::from_f32(semantic, 1, ids.clone()));
    let level = to_triangles(&mesh, 200);
    assert!(level.positions.iter().any(|position| !mesh.positions.contains(position)));
    assert!((0..level.vertex_count()).all(|v| ids.contains(&level.layers[0].get(v, 0))));
}

#[test]
fn levels_are_those_of_a_subset() {
    let mesh = shapes::icosphere(4, 1.0);
    let sequence = SequenceOptions::default().with_base_triangle_count(1_000);
    let targets = [
        (Target::Triangles(10), SequenceOptions::default()),
        (Target::Triangles(10), sequence),
        (Target::Vertices(500), SequenceOptions::default()),
        (Target::Detail(0.5), SequenceOptions::default()),
        (Target::Detail(1.0), SequenceOptions::default()),
        (Target::SplitCount(300), SequenceOptions::default()),
        (Target::Triangles(1 << 20), SequenceOptions::default()),
        (Target::Error(0.01), SequenceOptions::default()),
    ];
    for (target, sequence) in targets {
        let free = options(target).with_sequence(sequence);
        let [subset, free] = [free.clone().with_placement(Placement::Subset), free].map(|o| run(&mesh, &o));
        assert_eq!(free.mesh.triangles, subset.mesh.triangles, "{target:?}");
        assert_eq!(free.stop_reason, subset.stop_reason, "{target:?}");
        let is_full = free.mesh.triangle_count() == mesh.triangle_count();
        assert_eq!(free.mesh.positions == subset.mesh.positions, is_full, "{target:?}");
    }
}

#[test]
fn error_limits_hold() {
    let mesh = shapes::icosphere(5, 1.0);
    let out = run(&mesh, &options(Target::Error(0.01)));
    assert_eq!(out.stop_reason, StopReason::TargetReached);
    assert!(out.error <= 0.01 && out.error > 0.005, "{}", out.error);
    // Close to the limit: a sphere with this few triangles deviates by about this much.
    assert!(out.mesh.triangle_count() < 1_000, "{}", out.mesh.triangle_count());
    let limited = run(&mesh, &options(Target::Triangles(4)).with_tolerance(0.01));
    let counts = |level: &Simplified| level.mesh.triangle_count();
    assert_eq!((limited.stop_reason, counts(&limited)), (StopReason::ErrorLimit, counts(&out)));
}

#[test]
fn reported_error_is_near_the_measured_one() {
    use striata::mesh::{DistanceOptions, surface_distance};
    let terrain = shapes::terrain(64, 11);
    let out = run(&terrain, &options(Target::Triangles(800)));
    let sampling = DistanceOptions::default().with_sample_count(50_000);
    let measured = surface_distance(&terrain, &out.mesh, &sampling).unwrap().a_to_b.max;
    let ratio = out.error / measured;
    assert!((0.5..1.5).contains(&ratio), "reported {} measured {measured}", out.error);
}

#[test]
fn free_vertices_lie_nearer_than_a_subset() {
    use striata::mesh::{DistanceOptions, surface_distance};
    let torus = shapes::torus(80, 40, 2.0, 0.7);
    let sampling = DistanceOptions::default().with_sample_count(50_000);
    let rms = |options: &SimplifyOptions| {
        surface_distance(&torus, &run(&torus, options).mesh, &sampling).unwrap().rms
    };
    let subset = rms(&options(Target::Triangles(640)).with_placement(Placement::Subset));
    let free = rms(&options(Target::Triangles(640)));
    assert!(free < 0.75 * subset, "{free} against {subset}");
}

#[test]
fn cancellation_is_an_error() {
    let mesh = shapes::icosphere(5, 1.0);
    for cancelled in ["simplify", "fit"] {
        let mut progress = |progress: striata::Progress| match progress.phase == cancelled {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        };
        let out = simplify_with_progress(&mesh, &options(Target::Triangles(100)), &mut progress);
        assert_eq!(out.unwrap_err(), SimplifyError::Cancelled(striata::Cancelled), "{cancelled}");
    }
}

/// Maximum distance between the samples of two meshes and the respective other mesh.
fn sampled(a: &IndexedMesh, b: &IndexedMesh) -> f64 {
    use striata::mesh::{DistanceOptions, surface_distance};
    let sampling = DistanceOptions::default().with_sample_count(3_000);
    let found = surface_distance(a, b, &sampling).unwrap();
    found.a_to_b.max.max(found.b_to_a.max)
}

/// Simplifies to several targets, which must be missed by less than one step; errors must be bounds.
fn reaches_all_targets(name: &str, mesh: &IndexedMesh, sequence: &SequenceOptions) {
    // Welding drops degenerate triangles.
    let welded = weld(mesh).unwrap().mesh;
    let full = welded.triangle_count();
    for target in [full * 3 / 4, full / 2, full / 4, full / 10, 16, 2].into_iter().filter(|&n| n < full) {
        let out = run(mesh, &options(Target::Triangles(target)).with_sequence(sequence.clone()));
        let left = out.mesh.triangle_count();
        let at = format!("{name}: {left} of {full} triangles left for {target}");
        // With three positions left, all remaining triangles can only disappear together.
        let places: BTreeSet<_> = out.mesh.positions.iter().map(|p| p.map(|x| (x + 0.0).to_bits())).collect();
        assert!(left > 0 && (left <= target.max(8) || places.len() <= 3), "{at}");
        assert!(left <= target || out.stop_reason == StopReason::BaseReached, "{at}");
        assert_eq!(
            out.mesh.clone().without_unused_vertices().vertex_count(),
            out.mesh.vertex_count(),
            "{at}"
        );
        let found = sampled(&welded, &out.mesh);
        assert!(out.error >= 0.77 * found - 1e-6 * mesh.diagonal(), "{at}: {} but {found}", out.error);
        // Samples miss the peaks of small parts.
        assert!(out.error <= 2.0 * found + 1e-6 * mesh.diagonal(), "{at}: {} but {found}", out.error);
    }
}

#[test]
fn every_target_is_reached_on_odd_meshes() {
    for (name, mesh) in meshes::all() {
        if mesh.triangles.is_empty() || weld(&mesh).unwrap().mesh.triangles.is_empty() {
            continue;
        }
        reaches_all_targets(&name, &mesh, &SequenceOptions::default());
    }
}

#[test]
fn parts_are_kept_if_requested() {
    let mesh = shapes::many_components(30);
    let left = |rule| {
        let sequence = SequenceOptions::default().with_topology(rule);
        run(&mesh, &options(Target::Triangles(0)).with_sequence(sequence)).mesh
    };
    let parts = |mesh: &IndexedMesh| Statistics::of(mesh).unwrap().component_count;
    assert_eq!(parts(&left(TopologyRule::KeepParts)), parts(&mesh));
    // A tetrahedron folds into two triangles.
    assert!(left(TopologyRule::Change).triangle_count() <= 2);
}

proptest! {
    #![proptest_config(striata_testing::cases(24))]

    #[test]
    fn every_target_is_reached_on_assets(pieces in 1usize..9, seed: u64) {
        reaches_all_targets("asset", &meshes::asset(pieces, seed), &SequenceOptions::default());
    }

    #[test]
    fn locks_hold_on_assets(pieces in 1usize..7, seed: u64) {
        let mesh = meshes::asset(pieces, seed);
        let welded = weld(&mesh).unwrap();
        let mut sequence = meshes::random_options(&mesh, seed, 0);
        sequence.pair_distance = None;
        let out = run(&mesh, &options(Target::Triangles(0)).with_sequence(sequence.clone()));
        let bits = |p: &[f32; 3]| p.map(|x| (x + 0.0).to_bits());
        let left: BTreeSet<_> = out.mesh.positions.iter().map(bits).collect();
        let locked = sequence.locked_vertices.iter();
        for &v in locked.filter(|&&v| welded.position_of_source[v as usize] != u32::MAX) {
            prop_assert!(left.contains(&bits(&mesh.positions[v as usize])), "vertex {} was locked", v);
        }
        if sequence.boundary == BoundaryRule::Locked {
            let adjacency = Adjacency::of_positions(&welded.mesh, &welded.positions);
            for p in adjacency.edges().filter(|e| e.is_boundary()).flat_map(|e| e.ends) {
                let place = welded.mesh.positions[welded.positions.first_vertex(p) as usize];
                prop_assert!(left.contains(&bits(&place)), "a boundary vertex went");
            }
        }
    }

    #[test]
    fn limits_hold_on_assets(pieces in 1usize..7, seed: u64, share in 0.001f64..0.3) {
        let mesh = meshes::asset(pieces, seed);
        prop_assume!(!weld(&mesh).unwrap().mesh.triangles.is_empty());
        let limit = share * mesh.diagonal();
        let out = run(&mesh, &options(Target::Error(limit)));
        prop_assert!(out.error <= limit);
        let found = sampled(&weld(&mesh).unwrap().mesh, &out.mesh);
        prop_assert!(found <= 1.1 * limit, "{found} for {limit}");
    }

    #[test]
    fn seams_and_topology_are_kept_if_requested(pieces in 1usize..5, seed: u64) {
        let mesh = meshes::asset(pieces, seed);
        prop_assume!(!weld(&mesh).unwrap().mesh.triangles.is_empty());
        let keep = SequenceOptions::default().with_seams(SeamRule::Keep).with_topology(TopologyRule::Keep);
        let kept = run(&mesh, &options(Target::Triangles(0)).with_sequence(keep.clone()));
        prop_assert_eq!(kept.stop_reason, StopReason::BaseReached);
        let parts = |mesh: &IndexedMesh| {
            let welded = weld(mesh).unwrap();
            Adjacency::of_positions(&welded.mesh, &welded.positions).component_count()
        };
        // Parts that are connected only by a vertex may come apart there.
        prop_assert!(parts(&kept.mesh) >= parts(&mesh));
    }
}
