//! Surfaces with a boundary, and one-sided surfaces.

use glam::DVec3;

use super::sin_cos::sin_cos_of_turn;
use crate::mesh::{IndexedMesh, Random};

/// Flat grid of `columns * rows` unit squares in the plane z = 0, two triangles each; at least 1 column and
/// 1 row.
pub fn grid(columns: u32, rows: u32) -> IndexedMesh {
    height_field(columns, rows, |_, _| 0.0)
}

/// Grid whose vertex in column `x` and row `y` has the height `height(x, y)`.
pub fn height_field(columns: u32, rows: u32, mut height: impl FnMut(u32, u32) -> f32) -> IndexedMesh {
    let (columns, rows) = (columns.max(1), rows.max(1));
    let mut mesh = IndexedMesh::default();
    for y in 0..=rows {
        mesh.positions.extend((0..=columns).map(|x| [x as f32, y as f32, height(x, y)]));
    }
    let vertex = |x: u32, y: u32| y * (columns + 1) + x;
    for y in 0..rows {
        for x in 0..columns {
            let [a, b] = [vertex(x, y), vertex(x + 1, y)];
            let [c, d] = [vertex(x + 1, y + 1), vertex(x, y + 1)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// Hilly grid of `size * size` squares: several octaves of value noise, with heights of about a tenth of
/// the width.
pub fn terrain(size: u32, seed: u64) -> IndexedMesh {
    let size = size.max(1);
    height_field(size, size, |x, y| {
        let (mut height, mut share) = (0.0, 0.1 * f64::from(size));
        let mut cell = size.div_ceil(4).max(1);
        for octave in 0..8 {
            height += share * (value_noise(seed ^ octave, [x, y], cell) - 0.5);
            share *= 0.5;
            cell = cell.div_ceil(2);
        }
        height as f32
    })
}

/// Value noise in 0..1: random values on a square lattice of width `cell`, smoothly interpolated.
fn value_noise(seed: u64, point: [u32; 2], cell: u32) -> f64 {
    let [x, y] = point.map(|p| p / cell);
    let [u, v] = point.map(|p| {
        let t = f64::from(p % cell) / f64::from(cell);
        t * t * (3.0 - 2.0 * t)
    });
    let value = |x: u32, y: u32| {
        let mut random = Random::new(seed ^ u64::from(x) << 34 ^ u64::from(y) << 4);
        random.next_u64();
        random.unit()
    };
    let row = |y: u32| value(x, y) * (1.0 - u) + value(x + 1, y) * u;
    row(y) * (1.0 - v) + row(y + 1) * v
}

/// Open fan of `count` triangles around vertex 0, over a quarter circle.
pub fn triangle_fan(count: u32) -> IndexedMesh {
    let count = count.max(1);
    let mut mesh = IndexedMesh::new(vec![[0.0; 3]], (1..=count).map(|v| [0, v, v + 1]).collect());
    for v in 0..=count {
        let (s, c) = sin_cos_of_turn(v, 4 * count);
        mesh.positions.push([c as f32, s as f32, 0.0]);
    }
    mesh
}

/// Closed fan of `count` triangles around vertex 0, which is slightly raised; at least 3 triangles.
pub fn closed_fan(count: u32) -> IndexedMesh {
    let count = count.max(3);
    let triangles = (0..count).map(|v| [0, 1 + v, 1 + (v + 1) % count]).collect();
    let mut mesh = IndexedMesh::new(vec![[0.0, 0.0, 0.25]], triangles);
    for v in 0..count {
        let (s, c) = sin_cos_of_turn(v, count);
        mesh.positions.push([c as f32, s as f32, 0.0]);
    }
    mesh
}

/// Moebius strip of `segments` squares: one side, one boundary loop; at least 3 squares.
///
/// Its orientation has to break somewhere; it does so at the end of the last square.
pub fn moebius_strip(segments: u32) -> IndexedMesh {
    let segments = segments.max(3);
    let mut mesh = IndexedMesh::default();
    for i in 0..segments {
        let (s, c) = sin_cos_of_turn(i, segments);
        let (half_sin, half_cos) = sin_cos_of_turn(i, 2 * segments);
        for side in [-0.3, 0.3] {
            let from_axis = 1.0 + side * half_cos;
            mesh.positions.push([(from_axis * c) as f32, (from_axis * s) as f32, (side * half_sin) as f32]);
        }
        let next = if i + 1 < segments { [2 * i + 2, 2 * i + 3] } else { [1, 0] };
        mesh.triangles.extend([[2 * i, next[0], next[1]], [2 * i, next[1], 2 * i + 1]]);
    }
    mesh
}

/// Klein bottle in figure-eight form, closed and one-sided: `rings * segments` vertices, twice as many
/// triangles; at least 3 rings and 3 segments. Its orientation breaks along the last ring.
pub fn klein_bottle(rings: u32, segments: u32) -> IndexedMesh {
    let (rings, segments) = (rings.max(3), segments.max(3));
    let mut mesh = IndexedMesh::default();
    for ring in 0..rings {
        let (s, c) = sin_cos_of_turn(ring, rings);
        let (half_sin, half_cos) = sin_cos_of_turn(ring, 2 * rings);
        for segment in 0..segments {
            let (sin, _) = sin_cos_of_turn(segment, segments);
            let (sin_twice, _) = sin_cos_of_turn(2 * segment, segments);
            let from_axis = 3.0 + half_cos * sin - half_sin * sin_twice;
            let p = DVec3::new(from_axis * c, from_axis * s, half_sin * sin + half_cos * sin_twice);
            mesh.positions.push(p.as_vec3().to_array());
        }
    }
    let vertex = |ring: u32, segment: u32| {
        let segment = segment % segments;
        if ring < rings { ring * segments + segment } else { (segments - segment) % segments }
    };
    for r in 0..rings {
        for s in 0..segments {
            let [a, b] = [vertex(r, s), vertex(r + 1, s)];
            let [c, d] = [vertex(r + 1, s + 1), vertex(r, s + 1)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terrain_is_hilly_smooth_and_repeatable() {
        let mesh = terrain(64, 5);
        assert_eq!(mesh, terrain(64, 5));
        assert_ne!(mesh, terrain(64, 6));
        let heights = mesh.positions.iter().map(|p| p[2]);
        let (low, high) = heights.fold((f32::MAX, f32::MIN), |(l, h), z| (l.min(z), h.max(z)));
        assert!(high - low > 2.0 && high - low < 13.0, "{low}..{high}");
        for row in mesh.positions.chunks(65) {
            assert!(row.windows(2).all(|w| (w[0][2] - w[1][2]).abs() < 1.5));
        }
    }

    #[test]
    fn vertex_and_triangle_counts_match_the_documentation() {
        let counts = |mesh: IndexedMesh| (mesh.vertex_count(), mesh.triangle_count());
        assert_eq!(counts(grid(3, 2)), (12, 12));
        assert_eq!(counts(grid(0, 0)), (4, 2));
        assert_eq!(counts(triangle_fan(5)), (7, 5));
        assert_eq!(counts(closed_fan(5)), (6, 5));
        assert_eq!(counts(moebius_strip(7)), (14, 14));
        assert_eq!(counts(klein_bottle(4, 5)), (20, 40));
    }
}
