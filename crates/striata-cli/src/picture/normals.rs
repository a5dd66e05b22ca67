//! Normals for smooth shading, one a vertex.

use striata::mesh::IndexedMesh;

/// Normals of a mesh, weighted by area; those of a full mesh serve every level, since no vertex is ever moved.
pub(crate) fn vertex_normals(mesh: &IndexedMesh) -> Vec<[f32; 3]> {
    let mut normals = vec![[0.0f32; 3]; mesh.vertex_count()];
    for &corners in &mesh.triangles {
        let [a, b, c] = corners.map(|v| mesh.positions[v as usize]);
        let (e, f): ([f32; 3], [f32; 3]) =
            (std::array::from_fn(|k| b[k] - a[k]), std::array::from_fn(|k| c[k] - a[k]));
        let normal = [e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]];
        for v in corners {
            for (sum, part) in normals[v as usize].iter_mut().zip(normal) {
                *sum += part;
            }
        }
    }
    for normal in &mut normals {
        let length = normal.iter().map(|x| x * x).sum::<f32>().sqrt();
        if length > 0.0 {
            *normal = normal.map(|x| x / length);
        }
    }
    normals
}
