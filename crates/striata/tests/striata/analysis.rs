//! Adjacency, dual graph, statistics, validation and distance on every problematic mesh and on random soups.

use striata_testing::meshes;

use std::collections::BTreeMap;

use proptest::prelude::*;
use striata::mesh::{
    Adjacency, DefectKind, DualGraph, Edge, IndexedMesh, Statistics, shapes, validate, weld,
};

/// Finds edges by brute force: every side of every triangle with three different corners, by its end points.
fn sides_by_ends(mesh: &IndexedMesh) -> BTreeMap<[u32; 2], [Vec<u32>; 2]> {
    let mut sides: BTreeMap<[u32; 2], [Vec<u32>; 2]> = BTreeMap::new();
    for (t, &[a, b, c]) in mesh.triangles.iter().enumerate() {
        if a == b || b == c || c == a {
            continue;
        }
        for (k, (from, to)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            let ends = [from.min(to), from.max(to)];
            sides.entry(ends).or_default()[usize::from(from > to)].push((3 * t + k) as u32);
        }
    }
    sides
}

/// Counts pieces around a vertex by brute force: flood fill across the edges that contain it.
fn piece_count(mesh: &IndexedMesh, vertex: u32) -> usize {
    let is_proper = |t: &&[u32; 3]| t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
    let mut left: Vec<&[u32; 3]> =
        mesh.triangles.iter().filter(is_proper).filter(|t| t.contains(&vertex)).collect();
    let mut pieces = 0;
    while let Some(seed) = left.pop() {
        pieces += 1;
        let mut reached = vec![seed];
        while let Some(from) = reached.pop() {
            let touches = |t: &&[u32; 3]| t.iter().any(|v| *v != vertex && from.contains(v));
            let (near, far) = left.into_iter().partition::<Vec<_>, _>(|t| touches(t));
            reached.extend(near);
            left = far;
        }
    }
    pieces
}

fn check_adjacency(name: &str, mesh: &IndexedMesh) {
    let adjacency = Adjacency::of_vertices(mesh);
    let expected = sides_by_ends(mesh);
    assert_eq!(adjacency.edge_count(), expected.len(), "{name}");
    for (edge, (ends, [forward, backward])) in adjacency.edges().zip(&expected) {
        assert_eq!((edge.ends, edge.forward, edge.backward), (*ends, &forward[..], &backward[..]), "{name}");
        assert_eq!(adjacency.edge_between(ends[1], ends[0]), Some(edge), "{name}");
    }
    let expected: Vec<u32> = (0..mesh.vertex_count() as u32).filter(|&v| piece_count(mesh, v) > 1).collect();
    assert_eq!(adjacency.bow_ties(), expected, "{name}");
}

fn check_dual_graph(name: &str, mesh: &IndexedMesh) {
    let graph = DualGraph::of_vertices(mesh);
    let ends = |side: u32| {
        let t = mesh.triangles[side as usize / 3];
        (t[side as usize % 3], t[(side as usize + 1) % 3])
    };
    let group_of = |t: u32| mesh.groups.iter().position(|g| g.range().contains(&(t as usize)));
    for side in 0..3 * mesh.triangle_count() as u32 {
        let Some(twin) = graph.twin(side) else { continue };
        assert_eq!(graph.twin(twin), Some(side), "{name}");
        assert_eq!(ends(twin), (ends(side).1, ends(side).0), "{name}");
        assert_eq!(group_of(side / 3), group_of(twin / 3), "{name}");
    }
    // In a single group, each edge has as many links as its less frequent direction.
    if mesh.groups.is_empty() {
        let links: usize = sides_by_ends(mesh).values().map(|[f, b]| f.len().min(b.len())).sum();
        assert_eq!(graph.link_count(), links, "{name}");
    }
}

fn check_everything(name: &str, mesh: &IndexedMesh) {
    let report = validate(mesh);
    if mesh.check().is_err() {
        assert!(report.count(DefectKind::Inconsistent) > 0, "{name}");
        assert!(Statistics::of(mesh).is_err() && weld(mesh).is_err(), "{name}");
        return;
    }
    check_adjacency(name, mesh);
    check_dual_graph(name, mesh);
    let statistics = Statistics::of(mesh).unwrap();
    let counts = [
        (DefectKind::Inconsistent, 0),
        (DefectKind::DuplicateTriangle, statistics.duplicate_triangle_count),
        (DefectKind::NonManifoldEdge, statistics.non_manifold_edge_count),
        (DefectKind::InconsistentEdge, statistics.inconsistent_edge_count),
        (DefectKind::BowTie, statistics.non_manifold_vertex_count),
        (DefectKind::UnusedVertex, statistics.unused_vertex_count),
    ];
    for (kind, count) in counts {
        assert_eq!(report.count(kind), count, "{name}: {}", kind.as_str());
    }
    let degenerate = [DefectKind::RepeatedVertex, DefectKind::RepeatedPosition, DefectKind::NoArea];
    let degenerate_count: usize = degenerate.map(|kind| report.count(kind)).iter().sum();
    assert_eq!(degenerate_count, statistics.degenerate_triangle_count, "{name}");
    check_weld_keeps_topology(name, mesh, &statistics);
}

/// Welding drops exactly those triangles that the adjacency leaves out.
fn check_weld_keeps_topology(name: &str, mesh: &IndexedMesh, statistics: &Statistics) {
    let welded = weld(mesh).unwrap();
    let after = Statistics::of(&welded.mesh).unwrap();
    let topology = |s: &Statistics| {
        let edges =
            [s.edge_count, s.boundary_edge_count, s.non_manifold_edge_count, s.inconsistent_edge_count];
        (edges, s.non_manifold_vertex_count, s.component_count, s.euler_characteristic, s.genus)
    };
    assert_eq!(topology(&after), topology(statistics), "{name}");
    assert_eq!(after.position_count, welded.positions.position_count(), "{name}");
    let by_position = Adjacency::of_positions(&welded.mesh, &welded.positions);
    assert_eq!(by_position.edges().filter(Edge::is_boundary).count(), after.boundary_edge_count, "{name}");
}

#[test]
fn nasty_meshes_are_described() {
    for (name, mesh) in meshes::nasty() {
        check_everything(name, &mesh);
    }
}

#[test]
fn component_count_agrees_with_statistics() {
    let mut compared = 0;
    for (name, mesh) in meshes::nasty() {
        // An error may contain a NaN, which is not equal to itself, so compare only successes.
        let whole = Statistics::of(&mesh).ok().map(|statistics| statistics.component_count);
        assert_eq!(mesh.component_count().ok(), whole, "{name}");
        compared += usize::from(whole.is_some_and(|count| count > 1));
    }
    assert!(compared > 0, "no mesh of several pieces was among them");
}

#[test]
fn euler_characteristics_of_known_surfaces() {
    let numbers = |mesh: IndexedMesh| {
        let s = Statistics::of(&mesh).unwrap();
        (s.euler_characteristic, s.genus, s.boundary_loop_count, s.component_count)
    };
    assert_eq!(numbers(shapes::paper_sphere()), (2, Some(0), 0, 1));
    assert_eq!(numbers(shapes::torus(40, 30, 3.0, 1.0)), (0, Some(1), 0, 1));
    assert_eq!(numbers(shapes::moebius_strip(50)), (0, None, 1, 1));
    assert_eq!(numbers(shapes::klein_bottle(20, 30)), (0, None, 0, 1));
    assert_eq!(numbers(shapes::grid(30, 20)), (1, Some(0), 1, 1));
    assert_eq!(numbers(shapes::many_components(10_000)), (20_000, Some(0), 0, 10_000));
}

#[test]
fn each_defect_is_reported_on_its_own_line() {
    for (name, mesh) in meshes::nasty() {
        let report = validate(&mesh);
        let lines = report.to_string();
        assert!(lines.lines().count() >= report.defects().len(), "{name}");
        assert!(lines.lines().all(|line| line.len() > 10), "{name}");
        assert_eq!(report.is_clean(), lines.is_empty(), "{name}");
    }
}

proptest! {
    #![proptest_config(striata_testing::cases(64))]

    #[test]
    fn soups_are_described(triangle_count in 0u32..120, seed: u64) {
        check_everything("soup", &shapes::random_soup(triangle_count, seed));
    }
}

mod distance {
    use super::*;
    use striata::mesh::{DistanceOptions, Random, SurfaceDistance, TriangleTree, surface_distance};

    fn measure(a: &IndexedMesh, b: &IndexedMesh) -> SurfaceDistance {
        surface_distance(a, b, &DistanceOptions::default().with_sample_count(20_000)).unwrap()
    }

    #[test]
    fn a_mesh_is_no_distance_from_itself() {
        for (name, mesh) in meshes::nasty() {
            let options = DistanceOptions::default().with_sample_count(2_000);
            match surface_distance(&mesh, &mesh, &options) {
                Ok(d) => {
                    let largest = mesh.positions.iter().flatten().fold(0f32, |m, x| m.max(x.abs()));
                    // Samples are rounded to f64, relative to the coordinates.
                    assert!(d.max <= 1e-14 * f64::from(largest), "{name}: {d:?}");
                    assert!(d.rms <= d.max && d.mean <= d.rms, "{name}: {d:?}");
                }
                Err(_) => assert!(mesh.check().is_err() || mesh.triangles.is_empty(), "{name}"),
            }
        }
    }

    #[test]
    fn shifted_planes() {
        let plane = shapes::grid(20, 30);
        let mut shifted = plane.clone();
        shifted.positions.iter_mut().for_each(|p| p[2] += 0.25);
        let d = measure(&plane, &shifted);
        assert_eq!((d.max, d.a_to_b.max, d.b_to_a.max), (0.25, 0.25, 0.25));
        assert!((d.rms - 0.25).abs() < 1e-15 && (d.mean - 0.25).abs() < 1e-15);
        assert_eq!(d.diagonal, 1300f64.sqrt());
        // Sliding sideways uncovers a strip of width 2 on either mesh, farther out by up to 2.
        let mut slid = plane.clone();
        slid.positions.iter_mut().for_each(|p| p[0] += 2.0);
        let d = measure(&plane, &slid);
        assert_eq!(d.max, 2.0);
        assert!((d.mean - 0.1).abs() < 1e-3, "{d:?}");
        assert!((d.rms - (4.0f64 / 30.0).sqrt()).abs() < 1e-3, "{d:?}");
    }

    #[test]
    fn concentric_spheres() {
        let (small, large) = (shapes::icosphere(5, 1.0), shapes::icosphere(5, 1.5));
        let d = measure(&small, &large);
        for value in [d.max, d.rms, d.mean, d.a_to_b.mean, d.b_to_a.mean] {
            assert!((value - 0.5).abs() < 2e-3, "{d:?}");
        }
        assert!(d.mean <= d.rms && d.rms <= d.max);
    }

    #[test]
    fn swapping_the_meshes_swaps_the_directions() {
        let (a, b) = (shapes::torus(30, 20, 2.0, 0.5), shapes::icosphere(3, 2.2));
        let (there, back) = (measure(&a, &b), measure(&b, &a));
        assert_eq!((there.a_to_b, there.b_to_a), (back.b_to_a, back.a_to_b));
        assert_eq!((there.max, there.rms, there.mean), (back.max, back.rms, back.mean));
        assert_eq!(there.sample_count, back.sample_count);
        assert!(there.a_to_b.max != there.b_to_a.max);
    }

    #[test]
    fn unused_vertices_do_not_count() {
        let plain = shapes::grid(4, 4);
        let mut cluttered = plain.clone();
        cluttered.positions.push([100.0, 0.0, 0.0]);
        let d = measure(&plain, &cluttered);
        assert_eq!(d.max, 0.0);
    }

    /// Fails if threads, sines or vector units affect the result.
    #[test]
    fn the_same_bits_on_every_machine() {
        let (a, b) = (shapes::torus(30, 20, 2.0, 0.5), shapes::icosphere(3, 2.2));
        let d = measure(&a, &b);
        let bits = [d.a_to_b.rms, d.a_to_b.mean, d.b_to_a.rms, d.b_to_a.mean, d.max].map(f64::to_bits);
        let expected = [
            4_600_088_528_948_866_543,
            4_599_014_162_903_027_347,
            4_607_100_895_424_476_056,
            4_605_097_206_121_034_248,
            4_612_745_224_958_428_003,
        ];
        assert_eq!(bits, expected, "{d:?}");
    }

    #[test]
    fn more_samples_agree_with_fewer() {
        let (a, b) = (shapes::icosphere(4, 1.0), shapes::icosphere(2, 1.0));
        let at = |sample_count| {
            let options = DistanceOptions::default().with_sample_count(sample_count).with_seed(9);
            surface_distance(&a, &b, &options).unwrap()
        };
        let (few, many) = (at(10_000), at(300_000));
        assert!((few.rms / many.rms - 1.0).abs() < 3e-3, "{} {}", few.rms, many.rms);
        assert!((few.mean / many.mean - 1.0).abs() < 3e-3);
        assert!(few.max <= many.max + 1e-9 && few.max > 0.97 * many.max);
    }

    proptest! {
        #![proptest_config(striata_testing::cases(64))]

        #[test]
        fn the_tree_finds_the_nearest_triangle(triangle_count in 1u32..200, seed: u64) {
            let mesh = shapes::random_soup(triangle_count, seed);
            let tree = TriangleTree::new(&mesh).unwrap();
            let mut random = Random::new(seed ^ 1);
            for _ in 0..20 {
                let p = [(); 3].map(|()| f64::from(random.between(-2.0, 2.0)));
                let nearest = tree.nearest(p).unwrap();
                for t in 0..triangle_count as usize {
                    let one = IndexedMesh::new(mesh.positions.clone(), vec![mesh.triangles[t]]);
                    let alone = TriangleTree::new(&one).unwrap().distance_to(p);
                    prop_assert!(nearest.distance <= alone);
                    if t == nearest.triangle as usize {
                        prop_assert_eq!(nearest.distance, alone);
                    }
                }
            }
        }
    }
}
