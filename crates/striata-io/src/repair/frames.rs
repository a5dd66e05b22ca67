//! Normals and tangents of vertices, from the triangles around them.

use striata::mesh::{IndexedMesh, LayerData, Semantic};

use crate::normals;

/// Replaces the normals of some vertices by those of their triangles; zero becomes +z.
pub(super) fn set_normals(mesh: &mut IndexedMesh, layer: usize, vertices: &[usize]) {
    let computed = normals::of_vertices(&mesh.positions, &mesh.triangles, 0..mesh.positions.len());
    set(mesh, layer, vertices, |vertex| computed[vertex].to_vec());
}

/// Replaces the tangents of some vertices by the direction in which the first texture coordinates of their
/// triangles grow, or any direction in the surface if there is none.
pub(super) fn set_tangents(mesh: &mut IndexedMesh, layer: usize, vertices: &[usize]) {
    let directions = texture_directions(mesh);
    let computed = normals::of_vertices(&mesh.positions, &mesh.triangles, 0..mesh.positions.len());
    let normal = |vertex: usize| match mesh.layer(&Semantic::Normal).filter(|l| l.component_count == 3) {
        Some(layer) => [0, 1, 2].map(|axis| layer.get(vertex, axis)),
        None => computed[vertex],
    };
    let rows: Vec<Vec<f32>> =
        vertices.iter().map(|&v| tangent(normal(v).map(f64::from), directions[v]).to_vec()).collect();
    let row = |vertex| vertices.binary_search(&vertex).map_or(Vec::new(), |place| rows[place].clone());
    set(mesh, layer, vertices, row);
}

/// Copies a row of numbers to each of some vertices, as far as the layer has components.
fn set(mesh: &mut IndexedMesh, layer: usize, vertices: &[usize], row: impl Fn(usize) -> Vec<f32>) {
    let layer = &mut mesh.layers[layer];
    let width = usize::from(layer.component_count);
    let LayerData::F32(values) = &mut layer.data else { return };
    for &vertex in vertices {
        for (value, new) in values[vertex * width..][..width].iter_mut().zip(row(vertex)) {
            *value = new;
        }
    }
}

/// Sums of the directions in which `u` and `v` grow in the triangles around each vertex; zero without texture
/// coordinates.
fn texture_directions(mesh: &IndexedMesh) -> Vec<[[f64; 3]; 2]> {
    let mut sums = vec![[[0.0; 3]; 2]; mesh.positions.len()];
    let Some(layer) = mesh.layer(&Semantic::TexCoord(0)).filter(|l| l.component_count >= 2) else {
        return sums;
    };
    for triangle in &mesh.triangles {
        let [a, b, c] = triangle.map(|v| mesh.positions[v as usize].map(f64::from));
        let [p, q, r] = triangle.map(|v| [0, 1].map(|axis| f64::from(layer.get(v as usize, axis))));
        let (first, second) = (difference(b, a), difference(c, a));
        let [u1, v1, u2, v2] = [q[0] - p[0], q[1] - p[1], r[0] - p[0], r[1] - p[1]];
        let area = u1 * v2 - u2 * v1;
        if area == 0.0 {
            continue;
        }
        let along_u = [0, 1, 2].map(|i| (first[i] * v2 - second[i] * v1) / area);
        let along_v = [0, 1, 2].map(|i| (second[i] * u1 - first[i] * u2) / area);
        for &vertex in triangle {
            let sum = &mut sums[vertex as usize];
            *sum = [[0, 1, 2].map(|i| sum[0][i] + along_u[i]), [0, 1, 2].map(|i| sum[1][i] + along_v[i])];
        }
    }
    sums
}

/// The unit tangent at right angles to a normal, with the handedness of the texture.
fn tangent(normal: [f64; 3], [along_u, along_v]: [[f64; 3]; 2]) -> [f32; 4] {
    let in_surface = |vector: [f64; 3]| {
        let height = dot(vector, normal);
        normals::unit([0, 1, 2].map(|i| vector[i] - height * normal[i]))
    };
    let is_usable = |tangent: &[f32; 3]| dot(tangent.map(f64::from), normal).abs() < 1e-3;
    let found = in_surface(along_u).filter(is_usable);
    // Any axis that is not near the normal.
    let smallest = (0..3).min_by(|&a, &b| normal[a].abs().total_cmp(&normal[b].abs())).unwrap_or(0);
    let axis = [0, 1, 2].map(|i| if i == smallest { 1.0 } else { 0.0 });
    let [x, y, z] = found.or_else(|| in_surface(axis)).unwrap_or([1.0, 0.0, 0.0]);
    let is_mirrored = dot(cross(normal, [x, y, z].map(f64::from)), along_v) < 0.0;
    [x, y, z, if is_mirrored { -1.0 } else { 1.0 }]
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
