//! Simplified clouds of leaves keep their visible area.

use striata::mesh::{IndexedMesh, replay};
use striata::simplify::{SequenceOptions, TopologyRule, build_sequence};

/// Width and height of a silhouette, in cells.
const SIZE: usize = 256;

/// Pseudorandom numbers in [-1, 1).
fn noise(seed: &mut u64) -> f32 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    ((*seed >> 40) as f32 / 8_388_608.0) - 1.0
}

fn in_ball(seed: &mut u64) -> [f32; 3] {
    loop {
        let at = [0; 3].map(|_| noise(seed));
        let squared: f32 = at.iter().map(|x| x * x).sum();
        if (0.05..1.0).contains(&squared) {
            return at;
        }
    }
}

fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(v: [f32; 3]) -> [f32; 3] {
    let length = v.iter().map(|x| x * x).sum::<f32>().sqrt();
    v.map(|x| x / length)
}

/// Clusters of randomly oriented square cards, distributed in a ball like the crown of a tree.
fn crown(cluster_count: usize, seed: u64) -> IndexedMesh {
    let mut seed = seed;
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for _ in 0..cluster_count {
        let center = in_ball(&mut seed);
        for _ in 0..8 {
            let offset = in_ball(&mut seed).map(|x| 0.1 * x);
            let normal = unit(in_ball(&mut seed));
            let along = unit(cross(normal, unit(in_ball(&mut seed))));
            let across = cross(normal, along);
            let size = 0.06 * (1.0 + 0.3 * noise(&mut seed));
            let first = positions.len() as u32;
            for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
                positions
                    .push([0, 1, 2].map(|a| center[a] + offset[a] + size * (x * along[a] + y * across[a])));
            }
            triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
        }
    }
    IndexedMesh::new(positions, triangles)
}

/// Number of covered cells, summed over the silhouettes along the three axes.
fn silhouette(mesh: &IndexedMesh) -> usize {
    let mut sum = 0;
    for axis in 0..3 {
        let mut covered = vec![false; SIZE * SIZE];
        for t in &mesh.triangles {
            let corners = t.map(|v| {
                let at = mesh.positions[v as usize];
                [at[(axis + 1) % 3], at[(axis + 2) % 3]].map(|x| (x + 1.3) / 2.6 * SIZE as f32 - 0.5)
            });
            paint(corners, &mut covered);
        }
        sum += covered.iter().filter(|&&is_covered| is_covered).count();
    }
    sum
}

fn paint(corners: [[f32; 2]; 3], covered: &mut [bool]) {
    let range = |axis: usize| {
        let values = corners.map(|c| c[axis]);
        let low = values.into_iter().fold(f32::INFINITY, f32::min).max(0.0) as usize;
        let high = values.into_iter().fold(0.0, f32::max) as usize;
        low..(high + 1).min(SIZE)
    };
    let side =
        |p: [f32; 2], q: [f32; 2], x: f32, y: f32| (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
    let [a, b, c] = corners;
    for row in range(1) {
        for column in range(0) {
            let (x, y) = (column as f32, row as f32);
            let sides = [side(a, b, x, y), side(b, c, x, y), side(c, a, x, y)];
            if sides.iter().all(|&s| s >= 0.0) || sides.iter().all(|&s| s <= 0.0) {
                covered[row * SIZE + column] = true;
            }
        }
    }
}

/// Silhouette areas of the levels at several shares of the triangles, relative to that of the full mesh.
fn silhouettes(mesh: &IndexedMesh, options: &SequenceOptions, shares: &[f64]) -> Vec<f64> {
    let refinable = build_sequence(mesh, options).expect("cards are sound").refinable;
    let whole = silhouette(mesh) as f64;
    let at = |&share: &f64| {
        let target = (share * mesh.triangle_count() as f64) as usize;
        let level = replay(&refinable, refinable.sequence.split_count_for_triangles(target));
        assert!(level.triangle_count() <= target);
        silhouette(&level) as f64 / whole
    };
    shares.iter().map(at).collect()
}

#[test]
fn crowns_keep_their_silhouette() {
    for seed in 1..4 {
        let found = silhouettes(&crown(600, seed), &SequenceOptions::default(), &[0.5, 0.1, 0.05]);
        let minimums = [0.95, 0.8, 0.7];
        assert!(
            found.iter().zip(minimums).all(|(found, minimum)| *found >= minimum),
            "seed {seed}: {found:?}"
        );
    }
}

#[test]
fn parts_that_must_stay_do_not_grow() {
    // Parts that must stay cannot grow to compensate for others: every card keeps one of its two triangles.
    let mesh = crown(40, 5);
    let options = SequenceOptions::default().with_topology(TopologyRule::KeepParts);
    let refinable = build_sequence(&mesh, &options).expect("cards are sound").refinable;
    assert_eq!(refinable.sequence.triangle_count_at(0), 40 * 8);
}
