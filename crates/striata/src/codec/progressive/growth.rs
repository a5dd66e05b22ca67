//! What a stream has given so far: triangles of a level and the sequence that leads to it.

use super::base::Base;
use super::surface::{NONE, Surface, triangle_of};

/// Triangles and steps, growing with each split. Vertices are numbered as in the mesh: base first, then step by step.
#[derive(Clone, Debug, Default)]
pub(super) struct Growth {
    /// Where the vertices are, mesh units.
    pub(super) positions: Vec<[f32; 3]>,
    /// Corners of each triangle of the level, in the order in which they came.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The vertex that each one beyond the base collapses to.
    pub(super) targets: Vec<u32>,
    /// Triangles that each step brings.
    pub(super) added: Vec<u8>,
    /// Triangles whose corners were changed by the last steps, with repetitions.
    pub(super) changed: Vec<u32>,
    /// Mesh vertex of each vertex of the surface; virtual ones have none.
    pub(super) mesh_vertex: Vec<u32>,
    vertex_count: u32,
}

impl Growth {
    /// Begins with the triangles of a base. `mesh_vertex` names the vertex of the mesh for each of the surface.
    fn new(surface: &mut Surface, mesh_vertex: Vec<u32>, vertex_count: u32) -> Self {
        let mut growth = Self { mesh_vertex, vertex_count, ..Self::default() };
        for t in 0..surface.triangle_count() as u32 {
            growth.push(surface, t);
        }
        growth
    }

    /// Begins with a base.
    pub(super) fn of_base(base: &Base, surface: &mut Surface) -> Self {
        let virtual_vertices = std::iter::repeat_n(NONE, base.virtual_count as usize);
        let mesh_vertex = virtual_vertices.chain(base.position_of_copy.iter().copied()).collect();
        Self::new(surface, mesh_vertex, base.places.len() as u32)
    }

    fn push(&mut self, surface: &mut Surface, triangle: u32) -> u8 {
        let corners = surface.triangle(triangle);
        if corners.iter().any(|&v| surface.is_virtual(v)) {
            surface.set_label(triangle, NONE);
            return 0;
        }
        surface.set_label(triangle, self.triangles.len() as u32);
        self.triangles.push(corners.map(|v| self.mesh_vertex[v as usize]));
        1
    }

    /// Adds a vertex whose corners are those of the surface around `vertex`, A's first and B's last.
    pub(super) fn add(&mut self, surface: &mut Surface, corners: &[u32], vertex: u32, kept: u32) {
        debug_assert_eq!(self.mesh_vertex.len(), vertex as usize);
        let new = self.vertex_count;
        self.vertex_count += 1;
        self.mesh_vertex.push(new);
        self.targets.push(self.mesh_vertex[kept as usize]);
        let [a, patch @ .., b] = corners else { return };
        for &corner in patch {
            let label = surface.label(triangle_of(corner));
            if label != NONE {
                self.triangles[label as usize][(corner & 3) as usize] = new;
                self.changed.push(label);
            }
        }
        let added = self.push(surface, triangle_of(*a)) + self.push(surface, triangle_of(*b));
        self.added.push(added);
    }
}
