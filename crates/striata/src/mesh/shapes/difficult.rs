//! Meshes that break algorithms: shared edges, single shared vertices, needles, soups, many pieces.

use super::tetrahedron;
use crate::mesh::{IndexedMesh, Random};

/// `count` triangles that share the edge from vertex 0 to vertex 1, like the pages of a book.
pub fn book(count: u32) -> IndexedMesh {
    let mut mesh = IndexedMesh::new(vec![[0., 0., 0.], [0., 0., 1.]], Vec::new());
    for page in 0..count {
        let lean = page as f32 + 1.0;
        mesh.positions.push([1.0, lean, 0.5]);
        mesh.triangles.push([0, 1, page + 2]);
    }
    mesh
}

/// Two triangles that share a single vertex.
pub fn bow_tie() -> IndexedMesh {
    let positions = vec![[0., 0., 0.], [1., 1., 0.], [1., -1., 0.], [-1., 1., 0.], [-1., -1., 0.]];
    IndexedMesh::new(positions, vec![[0, 2, 1], [0, 3, 4]])
}

/// Two needle-shaped triangles, 1 long and 1e-6 wide.
pub fn needle() -> IndexedMesh {
    let positions = vec![[0., 0., 0.], [1., 0., 0.], [0.5, 1e-6, 0.], [0.5, -1e-6, 0.]];
    IndexedMesh::new(positions, vec![[0, 1, 2], [1, 0, 3]])
}

/// `triangle_count` triangles over half as many random vertices: edges of any valence, duplicates,
/// degenerates.
pub fn random_soup(triangle_count: u32, seed: u64) -> IndexedMesh {
    let mut random = Random::new(seed);
    let vertex_count = triangle_count.max(3) / 2 + 2;
    let positions = (0..vertex_count).map(|_| [(); 3].map(|()| random.between(-1.0, 1.0))).collect();
    let triangles = (0..triangle_count).map(|_| [(); 3].map(|()| random.below(vertex_count))).collect();
    IndexedMesh::new(positions, triangles)
}

/// `count` small tetrahedra in rows of 100, each a separate component.
pub fn many_components(count: u32) -> IndexedMesh {
    let one = tetrahedron();
    let mut mesh = IndexedMesh::default();
    for i in 0..count {
        let offset = [(i % 100) as f32, (i / 100) as f32, 0.0];
        let move_to = |p: &[f32; 3]| std::array::from_fn(|axis| 0.1 * p[axis] + offset[axis]);
        mesh.positions.extend(one.positions.iter().map(move_to));
        mesh.triangles.extend(one.triangles.iter().map(|t| t.map(|v| v + 4 * i)));
    }
    mesh
}
