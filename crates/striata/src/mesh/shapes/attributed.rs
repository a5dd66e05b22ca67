//! Shapes with attributes: seams, hard edges and materials.

use super::sin_cos::sin_cos_of_turn;
use super::{cube, uv_sphere};
use crate::mesh::{AttributeLayer, IndexedMesh, Material, Semantic, TriangleGroup};

/// Open cylinder of radius 1 around the z axis, with normals and texture coordinates.
///
/// The column of vertices at which the texture wraps around is duplicated: a seam of `rings` edges. It has
/// `(segments + 1) * (rings + 1)` vertices and `2 * segments * rings` triangles; at least 3 segments and 1
/// ring.
pub fn uv_cylinder(segments: u32, rings: u32) -> IndexedMesh {
    let (segments, rings) = (segments.max(3), rings.max(1));
    let mut mesh = IndexedMesh::default();
    let (mut normals, mut texcoords) = (Vec::new(), Vec::new());
    for ring in 0..=rings {
        let v = ring as f32 / rings as f32;
        for segment in 0..=segments {
            let (s, c) = sin_cos_of_turn(segment, segments);
            let normal = [c as f32, s as f32, 0.0];
            mesh.positions.push([normal[0], normal[1], v]);
            normals.extend(normal);
            texcoords.extend([segment as f32 / segments as f32, v]);
        }
    }
    let vertex = |segment: u32, ring: u32| ring * (segments + 1) + segment;
    for ring in 0..rings {
        for s in 0..segments {
            let [a, b] = [vertex(s, ring), vertex(s + 1, ring)];
            let [c, d] = [vertex(s + 1, ring + 1), vertex(s, ring + 1)];
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, texcoords));
    mesh
}

/// Cube from -1 to 1 with one normal per side: 24 vertices at 8 positions; every edge is hard.
pub fn hard_cube() -> IndexedMesh {
    let soft = cube();
    let mut mesh = IndexedMesh::default();
    let mut normals = Vec::new();
    // Two consecutive triangles form a side: the first has corners 0, 1, 2, and the second adds corner 3.
    for side in soft.triangles.chunks_exact(2) {
        let first = mesh.positions.len() as u32;
        let corners = [side[0][0], side[0][1], side[0][2], side[1][2]].map(|v| soft.positions[v as usize]);
        let normal: [f32; 3] =
            std::array::from_fn(|axis| 0.5 * (corners[0][axis] + corners[2][axis])).map(f32::round);
        mesh.positions.extend(corners);
        normals.extend([normal; 4].into_iter().flatten());
        mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    mesh
}

/// Sphere whose northern half has one material and whose southern half another, over shared vertices.
pub fn two_material_sphere(rings: u32, segments: u32) -> IndexedMesh {
    let mut mesh = uv_sphere(rings, segments, 1.0);
    let half = mesh.triangles.len() as u32 / 2;
    let material = |name: &str| Material { name: name.to_string(), ..Material::default() };
    let group = |name: &str, material, first, count| TriangleGroup {
        name: name.to_string(),
        material: Some(material),
        first,
        count,
    };
    mesh.appearance.materials = vec![material("north"), material("south")];
    mesh.groups =
        vec![group("north", 0, 0, half), group("south", 1, half, mesh.triangles.len() as u32 - half)];
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::weld;

    #[test]
    fn welding_keeps_seams_hard_edges_and_material_borders() {
        let counts = |mesh: IndexedMesh| {
            mesh.check().unwrap();
            let welded = weld(&mesh).unwrap();
            (welded.mesh.vertex_count(), welded.positions.position_count())
        };
        assert_eq!(counts(uv_cylinder(8, 2)), (27, 24));
        assert_eq!(counts(hard_cube()), (24, 8));
        // Three rings of 8: every vertex of the middle ring has one wedge per material.
        assert_eq!(counts(two_material_sphere(3, 8)), (34, 26));
    }
}
