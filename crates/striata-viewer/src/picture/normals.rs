//! Normals of a mesh that has none: the means of the triangles around each position.
//!
//! They are made once, of the full mesh, and serve every level, since no vertex is ever moved. Vertices that share a position
//! share a normal: seams of attributes are no creases.

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};

use super::camera::{cross, minus, unit, wide};

/// The mesh with a layer of normals: its own, or one that is made from its triangles, weighted by area.
pub fn with_normals(mut mesh: IndexedMesh) -> IndexedMesh {
    if mesh.layer(&Semantic::Normal).is_none() {
        let normals = vertex_normals(&mesh);
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals.into_flattened()));
    }
    mesh
}

fn vertex_normals(mesh: &IndexedMesh) -> Vec<[f32; 3]> {
    let place_of = places(mesh);
    let mut sums = vec![[0.0f64; 3]; mesh.vertex_count()];
    for corners in &mesh.triangles {
        let [a, b, c] = corners.map(|v| wide(mesh.positions[v as usize]));
        let normal = cross(minus(b, a), minus(c, a));
        for &v in corners {
            let sum = &mut sums[place_of[v as usize] as usize];
            *sum = [0, 1, 2].map(|k| sum[k] + normal[k]);
        }
    }
    place_of.iter().map(|&place| unit(sums[place as usize]).map(|x| x as f32)).collect()
}

/// For each vertex the first of those at its position.
fn places(mesh: &IndexedMesh) -> Vec<u32> {
    // -0 and 0 are one place.
    let key = |v: u32| mesh.positions[v as usize].map(|x| (x + 0.0).to_bits());
    let mut order: Vec<u32> = (0..mesh.vertex_count() as u32).collect();
    order.sort_by_key(|&v| (key(v), v));
    let mut places = vec![0; order.len()];
    for together in order.chunk_by(|&a, &b| key(a) == key(b)) {
        together.iter().for_each(|&v| places[v as usize] = together[0]);
    }
    places
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;

    #[test]
    fn normals_of_a_ball_point_outwards_across_its_seam() {
        let mesh = with_normals(shapes::two_material_sphere(16, 32));
        let normals = mesh.layer(&Semantic::Normal).expect("they were made");
        for (v, position) in mesh.positions.iter().enumerate() {
            let along: f32 = (0..3).map(|k| normals.get(v, k) * position[k]).sum();
            let length = position.iter().map(|x| x * x).sum::<f32>().sqrt();
            assert!(along > 0.97 * length, "vertex {v}: {along} of {length}");
        }
        assert_eq!(with_normals(mesh.clone()), mesh, "what is there stays");
    }
}
