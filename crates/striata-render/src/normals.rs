//! Computes normals for meshes without normals, from the triangles around each position.
//!
//! They are computed once for the full mesh and serve every level, since vertices never move. Vertices that
//! share a position share a normal, so attribute seams are not creases.

use std::borrow::Cow;

use glam::DVec3;
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};

use super::camera::to_f64;

/// Adds a layer of area-weighted vertex normals, unless the mesh has normals.
pub fn with_normals(mut mesh: IndexedMesh) -> IndexedMesh {
    if mesh.layer(&Semantic::Normal).is_none() {
        let normals = vertex_normals(&mesh);
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals.into_flattened()));
    }
    mesh
}

/// Returns a mesh in which every vertex has a normal: the normals of the mesh, and computed ones instead of
/// those that are zero.
pub fn with_all_normals(mesh: &IndexedMesh) -> Cow<'_, IndexedMesh> {
    let is_zero = |layer: &AttributeLayer, v: usize| {
        (0..usize::from(layer.component_count)).all(|k| layer.get(v, k) == 0.0)
    };
    let Some(at) = mesh.layers.iter().position(|layer| layer.semantic == Semantic::Normal) else {
        return Cow::Owned(with_normals(mesh.clone()));
    };
    let layer = &mesh.layers[at];
    if layer.component_count != 3 || !(0..mesh.vertex_count()).any(|v| is_zero(layer, v)) {
        return Cow::Borrowed(mesh);
    }
    let mut normals = vertex_normals(mesh);
    for (v, normal) in normals.iter_mut().enumerate().filter(|(v, _)| !is_zero(layer, *v)) {
        *normal = [0, 1, 2].map(|k| layer.get(v, k));
    }
    let mut mesh = mesh.clone();
    mesh.layers[at] = AttributeLayer::from_f32(Semantic::Normal, 3, normals.into_flattened());
    Cow::Owned(mesh)
}

/// Area-weighted normals of all vertices; zero for vertices without triangles.
fn vertex_normals(mesh: &IndexedMesh) -> Vec<[f32; 3]> {
    let first_at_position = first_vertices(mesh);
    let mut sums = vec![DVec3::ZERO; mesh.vertex_count()];
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|v| to_f64(mesh.positions[v as usize]));
        let normal = (b - a).cross(c - a);
        for &v in corners {
            sums[first_at_position[v as usize] as usize] += normal;
        }
    }
    first_at_position
        .iter()
        .map(|&first| sums[first as usize].normalize_or_zero().as_vec3().to_array())
        .collect()
}

/// First vertex at the position of each vertex.
fn first_vertices(mesh: &IndexedMesh) -> Vec<u32> {
    // -0 and 0 are the same position.
    let key = |v: u32| mesh.positions[v as usize].map(|x| (x + 0.0).to_bits());
    let mut order: Vec<u32> = (0..mesh.vertex_count() as u32).collect();
    order.sort_by_key(|&v| (key(v), v));
    let mut first_vertices = vec![0; order.len()];
    for equal in order.chunk_by(|&a, &b| key(a) == key(b)) {
        equal.iter().for_each(|&v| first_vertices[v as usize] = equal[0]);
    }
    first_vertices
}

#[cfg(test)]
mod tests {
    use striata::mesh::{LayerData, shapes};

    use super::*;

    #[test]
    fn normals_of_a_ball_point_outwards_across_its_seam() {
        let mesh = with_normals(shapes::two_material_sphere(16, 32));
        let normals = mesh.layer(&Semantic::Normal).expect("the layer was added");
        for (v, position) in mesh.positions.iter().enumerate() {
            let along: f32 = (0..3).map(|k| normals.get(v, k) * position[k]).sum();
            let length = position.iter().map(|x| x * x).sum::<f32>().sqrt();
            assert!(along > 0.97 * length, "vertex {v}: {along} of {length}");
        }
        assert_eq!(with_normals(mesh.clone()), mesh, "existing normals are kept");
    }

    #[test]
    fn normals_that_are_zero_are_computed() {
        let mesh = with_normals(shapes::icosphere(2, 1.0));
        assert!(matches!(with_all_normals(&mesh), Cow::Borrowed(_)));
        let mut partial = mesh.clone();
        if let LayerData::F32(numbers) = &mut partial.layers[0].data {
            numbers[..30].fill(0.0);
        }
        assert_ne!(partial, mesh);
        assert_eq!(*with_all_normals(&partial), mesh);
    }
}
