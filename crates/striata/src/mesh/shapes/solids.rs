//! Closed, oriented manifolds.

use std::collections::HashMap;

use glam::DVec3;

use super::sin_cos::sin_cos_of_turn;
use crate::mesh::IndexedMesh;

/// Regular tetrahedron inscribed in the unit sphere: 4 vertices, 4 triangles.
pub fn tetrahedron() -> IndexedMesh {
    let corner = |x: f64, y: f64, z: f64| on_sphere(DVec3::new(x, y, z), 1.0);
    let positions =
        vec![corner(1., 1., 1.), corner(1., -1., -1.), corner(-1., 1., -1.), corner(-1., -1., 1.)];
    IndexedMesh::new(positions, vec![[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]])
}

/// Cube from -1 to 1 with shared corners: 8 vertices, 12 triangles.
pub fn cube() -> IndexedMesh {
    let coordinate = |v: u32, axis: u32| if v >> axis & 1 == 0 { -1.0 } else { 1.0 };
    let positions = (0..8).map(|v| [0, 1, 2].map(|axis| coordinate(v, axis))).collect();
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    IndexedMesh::new(positions, quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
}

/// The sphere used in the papers on strips: 15,314 vertices, 30,624 triangles, radius 1.
pub fn paper_sphere() -> IndexedMesh {
    // 87 * 176 + 2 = 15,314; the 88 steps from pole to pole are as long as the 176 steps around the equator.
    uv_sphere(87, 176, 1.0)
}

/// Sphere of `rings` circles of `segments` vertices each, plus two poles: `rings * segments + 2` vertices,
/// `2 * rings * segments` triangles; at least 1 ring and 3 segments.
pub fn uv_sphere(rings: u32, segments: u32, radius: f32) -> IndexedMesh {
    let (rings, segments) = (rings.max(1), segments.max(3));
    let radius = f64::from(radius);
    let mut mesh = IndexedMesh::default();
    mesh.positions.push([0.0, 0.0, radius as f32]);
    for ring in 1..=rings {
        let (sin_polar, cos_polar) = sin_cos_of_turn(ring, 2 * (rings + 1));
        for segment in 0..segments {
            let (s, c) = sin_cos_of_turn(segment, segments);
            let p = radius * DVec3::new(sin_polar * c, sin_polar * s, cos_polar);
            mesh.positions.push(p.as_vec3().to_array());
        }
    }
    mesh.positions.push([0.0, 0.0, -radius as f32]);
    let last = rings * segments + 1;
    let vertex = |ring: u32, segment: u32| 1 + ring * segments + segment % segments;
    for s in 0..segments {
        mesh.triangles.push([0, vertex(0, s), vertex(0, s + 1)]);
    }
    for ring in 1..rings {
        for s in 0..segments {
            let (a, b) = (vertex(ring - 1, s), vertex(ring - 1, s + 1));
            let (c, d) = (vertex(ring, s), vertex(ring, s + 1));
            mesh.triangles.extend([[a, c, d], [a, d, b]]);
        }
    }
    for s in 0..segments {
        mesh.triangles.push([vertex(rings - 1, s), last, vertex(rings - 1, s + 1)]);
    }
    mesh
}

/// Sphere made from an icosahedron by splitting every triangle into four, `subdivisions` times: `10 * 4^s +
/// 2` vertices and `20 * 4^s` triangles of nearly equal shape.
pub fn icosphere(subdivisions: u32, radius: f32) -> IndexedMesh {
    let radius = f64::from(radius);
    let mut points = icosahedron_corners();
    let mut triangles = ICOSAHEDRON.to_vec();
    for _ in 0..subdivisions {
        let mut midpoint_of: HashMap<(u32, u32), u32> = HashMap::new();
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(v, w)| {
                *midpoint_of.entry((v.min(w), v.max(w))).or_insert_with(|| {
                    points.push((points[v as usize] + points[w as usize]).normalize());
                    points.len() as u32 - 1
                })
            });
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    IndexedMesh::new(points.into_iter().map(|p| on_sphere(p, radius)).collect(), triangles)
}

fn icosahedron_corners() -> Vec<DVec3> {
    let g = 0.5 * (1.0 + 5f64.sqrt());
    let mut corners = Vec::with_capacity(12);
    for (y, z) in [(-1.0, -g), (1.0, -g), (-1.0, g), (1.0, g)] {
        corners.extend([[0.0, y, z], [y, z, 0.0], [z, 0.0, y]].map(|p| DVec3::from_array(p).normalize()));
    }
    corners
}

/// Twenty triangles over [`icosahedron_corners`], counterclockwise seen from outside.
const ICOSAHEDRON: [[u32; 3]; 20] = [
    [0, 1, 2],
    [0, 4, 1],
    [0, 2, 3],
    [0, 3, 8],
    [0, 8, 4],
    [1, 5, 2],
    [1, 4, 6],
    [1, 6, 5],
    [2, 7, 3],
    [2, 5, 7],
    [3, 7, 10],
    [3, 10, 8],
    [4, 11, 6],
    [4, 8, 11],
    [5, 6, 9],
    [5, 9, 7],
    [6, 11, 9],
    [7, 9, 10],
    [8, 10, 11],
    [9, 11, 10],
];

/// Torus around the z axis: `rings * segments` vertices, twice as many triangles; at least 3 rings and 3
/// segments.
///
/// `rings` counts the steps around the axis at distance `major`, `segments` those around the tube of radius
/// `minor`.
pub fn torus(rings: u32, segments: u32, major: f32, minor: f32) -> IndexedMesh {
    let (rings, segments) = (rings.max(3), segments.max(3));
    let (major, minor) = (f64::from(major), f64::from(minor));
    let mut mesh = IndexedMesh::default();
    for ring in 0..rings {
        let (s, c) = sin_cos_of_turn(ring, rings);
        for segment in 0..segments {
            let (up, out) = sin_cos_of_turn(segment, segments);
            let from_axis = major + minor * out;
            let p = DVec3::new(from_axis * c, from_axis * s, minor * up);
            mesh.positions.push(p.as_vec3().to_array());
        }
    }
    let vertex = |ring: u32, segment: u32| ring % rings * segments + segment % segments;
    for r in 0..rings {
        for s in 0..segments {
            let [a, b] = [vertex(r, s), vertex(r + 1, s)];
            let [c, d] = [vertex(r + 1, s + 1), vertex(r, s + 1)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

fn on_sphere(direction: DVec3, radius: f64) -> [f32; 3] {
    (radius * direction.normalize()).as_vec3().to_array()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Volume of a mesh; correct only if every triangle faces outward.
    fn volume(mesh: &IndexedMesh) -> f64 {
        let corner = |v: u32| DVec3::from_array(mesh.positions[v as usize].map(f64::from));
        mesh.triangles.iter().map(|t| t.map(corner)).map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
    }

    #[test]
    fn all_triangles_face_outwards() {
        let pi = std::f64::consts::PI;
        assert!((volume(&cube()) - 8.0).abs() < 1e-12);
        assert!((volume(&tetrahedron()) - 8.0 / 9.0 / 3f64.sqrt()).abs() < 1e-6);
        assert!((volume(&uv_sphere(87, 176, 2.0)) / (32.0 / 3.0 * pi) - 1.0).abs() < 2e-3);
        assert!((volume(&icosphere(4, 1.0)) / (4.0 / 3.0 * pi) - 1.0).abs() < 4e-3);
        assert!((volume(&torus(200, 100, 3.0, 1.0)) / (6.0 * pi * pi) - 1.0).abs() < 2e-3);
    }

    #[test]
    fn vertex_and_triangle_counts_match_the_documentation() {
        let counts = |mesh: IndexedMesh| (mesh.vertex_count(), mesh.triangle_count());
        assert_eq!(counts(paper_sphere()), (15_314, 30_624));
        assert_eq!(counts(uv_sphere(0, 0, 1.0)), (5, 6));
        assert_eq!(counts(icosphere(0, 1.0)), (12, 20));
        assert_eq!(counts(icosphere(3, 1.0)), (642, 1280));
        assert_eq!(counts(torus(5, 4, 2.0, 1.0)), (20, 40));
    }
}
