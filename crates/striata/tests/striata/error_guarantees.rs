//! Errors of sequences against brute-force distances: every sample against every triangle.

use striata_testing::meshes;

use glam::DVec3;
use meshes::{asset, folded, inside_out, random_options};
use proptest::prelude::*;
use striata::mesh::{IndexedMesh, Random, RefinableMesh, replay, replay_fragments, shapes, weld};
use striata::simplify::{
    CostFunction, RemovalOptions, Retriangulation, SequenceOptions, build_fragments, build_sequence,
    certify_collapses, certify_collapses_in_any_state,
};

fn position(mesh: &IndexedMesh, v: u32) -> DVec3 {
    DVec3::from_array(mesh.positions[v as usize].map(f64::from))
}

fn nearest_on_segment(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let along = b - a;
    let t = (point - a).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
    point.distance(a + along * t.clamp(0.0, 1.0))
}

fn distance_to_triangle(point: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let rim = nearest_on_segment(point, a, b).min(nearest_on_segment(point, b, c));
    let rim = rim.min(nearest_on_segment(point, c, a));
    let normal = (b - a).cross(c - a);
    let is_inside = |from: DVec3, to: DVec3| (to - from).cross(point - from).dot(normal) >= 0.0;
    if normal.length_squared() == 0.0 || !(is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) {
        return rim;
    }
    rim.min((point - a).dot(normal).abs() / normal.length())
}

/// The largest distance from samples of one mesh to all triangles of another.
fn brute_distance(from: &IndexedMesh, to: &IndexedMesh, samples: usize) -> f64 {
    let triangles: Vec<[DVec3; 3]> = to.triangles.iter().map(|t| t.map(|v| position(to, v))).collect();
    let mut random = Random::new(11);
    let mut worst: f64 = 0.0;
    let mut visit = |point: DVec3| {
        let distances = triangles.iter().map(|&t| distance_to_triangle(point, t));
        worst = worst.max(distances.fold(f64::INFINITY, f64::min));
    };
    for t in &from.triangles {
        let [a, b, c] = t.map(|v| position(from, v));
        [a, b, c].into_iter().for_each(&mut visit);
        for _ in 0..samples.div_ceil(from.triangle_count()) {
            let [mut x, mut y] = [(); 2].map(|()| f64::from(random.between(0.0, 1.0)));
            if x + y > 1.0 {
                (x, y) = (1.0 - x, 1.0 - y);
            }
            visit(a + (b - a) * x + (c - a) * y);
        }
    }
    worst
}

/// About `count` evenly spaced levels.
fn some_levels(step_count: usize, count: usize) -> impl Iterator<Item = usize> {
    (0..step_count).step_by(step_count.div_ceil(count).max(1))
}

/// Checks that certified errors are never exceeded. Returns the ratios of reported to measured errors.
fn errors_hold(name: &str, refinable: &RefinableMesh, levels: usize) -> Vec<f64> {
    let (full, sequence) = (&refinable.mesh, &refinable.sequence);
    let at_levels = certify_collapses(refinable);
    let in_any_state = certify_collapses_in_any_state(refinable);
    let mut shares = Vec::new();
    for split_count in some_levels(sequence.step_count(), levels) {
        let level = replay(refinable, split_count);
        let found = brute_distance(full, &level, 300);
        for certified in [&at_levels, &in_any_state] {
            let limit = f64::from(certified.sequence.error_at(split_count)) + 1e-12 * full.diagonal();
            assert!(found <= limit, "{name} at {split_count}: {found}, certified {limit}");
        }
        if found > 1e-6 * full.diagonal() {
            shares.push(f64::from(sequence.error_at(split_count)) / found);
        }
    }
    shares
}

/// Estimates track only some vertices, so a few may be too low.
fn are_accurate(mut shares: Vec<f64>, name: &str) {
    shares.sort_by(f64::total_cmp);
    let quantile = |percent: usize| shares[shares.len() * percent / 100];
    assert!(quantile(15) >= 0.77 && quantile(50) >= 0.95, "{name}: {} {}", quantile(15), quantile(50));
}

fn joined(meshes: &[IndexedMesh]) -> IndexedMesh {
    let mut out = IndexedMesh::default();
    for mesh in meshes {
        let first = out.positions.len() as u32;
        out.positions.extend(&mesh.positions);
        out.triangles.extend(mesh.triangles.iter().map(|t| t.map(|v| v + first)));
    }
    out
}

fn moved(mut mesh: IndexedMesh, scale: f32, by: [f32; 3]) -> IndexedMesh {
    mesh.positions.iter_mut().for_each(|p| *p = std::array::from_fn(|i| p[i] * scale + by[i]));
    mesh
}

/// Meshes for relaxed collapses: vanishing parts, decals, fins and folds.
fn special() -> Vec<(&'static str, IndexedMesh)> {
    let terrain = shapes::terrain(9, 4);
    let decals = (0..6).map(|i| moved(shapes::grid(2, 2), 0.3, [i as f32, 2.0, 0.01 * i as f32]));
    let far = (0..12).map(|i| moved(shapes::tetrahedron(), 0.02 * (i + 1) as f32, [i as f32, -2.0, 1.5]));
    let mut fins = shapes::icosphere(2, 1.0);
    for v in (0..60).step_by(5) {
        let [x, y, z] = fins.positions[v];
        let n = fins.positions.len() as u32;
        fins.positions.push([1.5 * x, 1.5 * y, 1.2 * z]);
        let neighbor = fins.triangles.iter().find_map(|t| t.contains(&(v as u32)).then_some(t[0]));
        let neighbor = neighbor.filter(|&u| u != v as u32).unwrap_or(v as u32 + 1);
        fins.triangles.push([v as u32, neighbor, n]);
    }
    vec![
        ("decals", joined(&[vec![terrain.clone()], decals.collect()].concat())),
        ("parts far away", joined(&[vec![terrain], far.collect()].concat())),
        ("fins", fins),
        ("folds", folded(20)),
        ("two bodies in one", inside_out(shapes::icosphere(2, 1.0))),
        (
            "tori in a row",
            joined(&[0.0, 2.2, 4.4].map(|x| moved(shapes::torus(9, 6, 1.0, 0.2), 1.0, [x, 0.0, 0.0]))),
        ),
        (
            "cards",
            joined(
                &(0..40)
                    .map(|i| moved(shapes::grid(1, 1), 0.2, [(i % 7) as f32, (i / 7) as f32, (i % 3) as f32]))
                    .collect::<Vec<_>>(),
            ),
        ),
    ]
}

#[test]
fn errors_hold_when_parts_vanish_and_fold() {
    let mut shares = Vec::new();
    for (name, mesh) in special() {
        for &cost in CostFunction::ALL {
            let options = SequenceOptions::default().with_cost(cost);
            let built = build_sequence(&mesh, &options).expect("they are sound");
            shares.extend(errors_hold(name, &built.refinable, 12));
        }
    }
    are_accurate(shares, "special meshes");
}

#[test]
fn estimates_on_assets_are_accurate() {
    let mut shares = Vec::new();
    for seed in 0..60 {
        let mesh = asset(1 + seed as usize % 6, seed);
        let options = random_options(&mesh, seed, seed as usize % 3);
        let built = build_sequence(&mesh, &options).expect("assets are sound");
        shares.extend(errors_hold("asset", &built.refinable, 6));
    }
    are_accurate(shares, "assets");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..striata_testing::cases(48) })]

    #[test]
    fn certified_errors_hold_on_assets(pieces in 1usize..6, seed: u64, cost in 0..CostFunction::ALL.len()) {
        let mesh = asset(pieces, seed);
        let options = random_options(&mesh, seed, cost);
        let built = build_sequence(&mesh, &options).expect("assets are sound");
        errors_hold("asset", &built.refinable, 6);
    }

    #[test]
    fn certified_limits_hold_on_assets(pieces in 1usize..6, seed: u64, share in 0.001f64..0.1) {
        let mesh = asset(pieces, seed);
        let limit = share * mesh.diagonal();
        let options = random_options(&mesh, seed, 0);
        let built = build_sequence(&mesh, &options).expect("assets are sound");
        prop_assume!(!built.refinable.mesh.triangles.is_empty());
        let certified_sequence = certify_collapses(&built.refinable);
        let within = certified_sequence.sequence.split_count_for_error(limit);
        let cut = certified_sequence.without_levels_below(within);
        prop_assert!(f64::from(cut.sequence.error_at(0)) <= limit);
        let found = brute_distance(&cut.mesh, &replay(&cut, 0), 1000);
        prop_assert!(found <= limit * (1.0 + 1e-9), "{found} for {limit}");
    }

    #[test]
    fn removals_hold_on_assets(pieces in 1usize..5, seed: u64, is_free: bool) {
        let mesh = asset(pieces, seed);
        let way = if is_free { Retriangulation::Free } else { Retriangulation::Collapse };
        let options = RemovalOptions::default().with_retriangulation(way);
        let built = build_fragments(&mesh, &options).expect("assets are sound");
        let welded = weld(&mesh).expect("assets are sound").mesh;
        let levels = built.fragmented.fragments.levels();
        for split_count in some_levels(levels.step_count(), 6) {
            let found = brute_distance(&welded, &replay_fragments(&built.fragmented, split_count), 300);
            let limit = f64::from(levels.error_at(split_count)) + 1e-12 * mesh.diagonal();
            prop_assert!(found <= limit, "{found}, certified {limit} at {split_count}");
        }
    }
}
