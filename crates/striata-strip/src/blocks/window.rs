//! Window: a block and the strips that it takes over, stripified together as one small mesh.

use striata::mesh::{IndexedMesh, MeshError};
use striata::strip::{StripSet, strip_triangles};

use super::chain::sides_of;
use super::integer_map::IntegerMap;
use super::pending::OpenSides;
use super::source::BlockTriangle;
use crate::entry::stripify;
use crate::options::StripOptions;

/// Small mesh whose vertices are numbered from 0 in order of arrival.
#[derive(Debug, Default)]
pub(super) struct Window {
    mesh: IndexedMesh,
    /// Local index of each vertex, by its index in the whole mesh.
    local_indices: IntegerMap<u32, u32>,
    /// Index in the whole mesh of each local vertex.
    vertices: Vec<u32>,
    /// For each local vertex, the last block that uses it.
    last_blocks: Vec<u32>,
    /// Sorted directed sides between vertices that later blocks use.
    rim: Vec<(u32, u32)>,
}

impl Window {
    /// Removes all triangles.
    pub(super) fn clear(&mut self) {
        self.mesh.triangles.clear();
        self.local_indices.clear();
        self.vertices.clear();
        self.last_blocks.clear();
    }

    /// Number of triangles.
    pub(super) fn triangle_count(&self) -> usize {
        self.mesh.triangle_count()
    }

    /// Adds a triangle.
    pub(super) fn push(&mut self, triangle: &BlockTriangle) {
        let [a, b, c] = [0, 1, 2].map(|k| self.local_index(triangle.corners[k], triangle.last_blocks[k]));
        self.mesh.triangles.push([a, b, c]);
    }

    /// Adds the end triangle of a chain and, if given, the triangle before it.
    ///
    /// They are linked only with each other and, at the side opposite `spare`, with the triangles ahead. A
    /// strip that passes them therefore begins with them, and turns as the chain did.
    pub(super) fn push_end(&mut self, triangle: &BlockTriangle, spare: u32, before: Option<[u32; 3]>) {
        let BlockTriangle { corners, last_blocks } = *triangle;
        let spare_duplicate = self.duplicate_vertex(spare);
        let mut numbers = [0; 3];
        for k in 0..3 {
            numbers[k] = if corners[k] == spare {
                spare_duplicate
            } else {
                self.local_index(corners[k], last_blocks[k])
            };
        }
        self.mesh.triangles.push(numbers);
        let Some(before) = before else { return };
        let shared = |vertex: u32| corners.iter().position(|&corner| corner == vertex);
        let numbers = before.map(|vertex| match shared(vertex) {
            Some(k) => numbers[k],
            None => self.duplicate_vertex(vertex),
        });
        self.mesh.triangles.push(numbers);
    }

    /// Adds a second local vertex for a vertex; its sides match no other side.
    fn duplicate_vertex(&mut self, vertex: u32) -> u32 {
        self.vertices.push(vertex);
        self.last_blocks.push(0);
        self.vertices.len() as u32 - 1
    }

    /// Returns the local index of a vertex, after adding it if it is new.
    fn local_index(&mut self, vertex: u32, last_block: u32) -> u32 {
        let next = self.vertices.len() as u32;
        let index = *self.local_indices.entry(vertex).or_insert(next);
        if index == next {
            self.vertices.push(vertex);
            self.last_blocks.push(last_block);
        } else {
            let known = &mut self.last_blocks[index as usize];
            *known = last_block.max(*known);
        }
        index
    }

    /// Covers the triangles by strips of local vertex indices.
    pub(super) fn stripify(&mut self, options: &StripOptions) -> Result<StripSet, MeshError> {
        // Strips depend on adjacency alone; the positions of vertices do not matter.
        self.mesh.positions.resize(self.vertices.len(), [0.0; 3]);
        stripify(&self.mesh, options)
    }

    /// Finds the sides between vertices that blocks after this one use. Those in `taken` (with vertex
    /// indices of the whole mesh) have a neighbor outside the window, so they are not open.
    pub(super) fn find_rim<'a>(&mut self, block: u32, taken: impl Iterator<Item = &'a (u32, u32)>) {
        self.rim.clear();
        let is_shared = |v: u32| self.last_blocks[v as usize] > block;
        let in_mesh = |v: u32| self.local_indices.get(&self.vertices[v as usize]).copied().unwrap_or(v);
        for (a, b) in self.mesh.triangles.iter().flat_map(|&t| sides_of(t)) {
            if is_shared(a) && is_shared(b) {
                self.rim.push((in_mesh(a), in_mesh(b)));
            }
        }
        self.rim.extend(
            taken.filter_map(|(a, b)| Some((*self.local_indices.get(b)?, *self.local_indices.get(a)?))),
        );
        self.rim.sort_unstable();
    }

    /// Iterates over the open sides of a triangle, in local vertex indices.
    fn open_sides_of(&self, triangle: [u32; 3]) -> impl Iterator<Item = (u32, u32)> {
        let is_rim = |side: &(u32, u32)| self.rim.binary_search(side).is_ok();
        let sides = if self.rim.is_empty() { None } else { Some(sides_of(triangle)) };
        sides.into_iter().flatten().filter(move |&(a, b)| is_rim(&(a, b)) && !is_rim(&(b, a)))
    }

    /// Returns the open sides of all triangles of a strip of local vertex indices.
    pub(super) fn open_sides(&self, strip: &[u32]) -> OpenSides {
        self.collected(strip_triangles(strip).flat_map(|t| self.open_sides_of(t)))
    }

    /// Number of open sides of a strip.
    pub(super) fn open_side_count(&self, strip: &[u32]) -> usize {
        strip_triangles(strip).map(|t| self.open_sides_of(t).count()).sum()
    }

    /// Converts local sides to open sides of the whole mesh.
    fn collected(&self, sides: impl Iterator<Item = (u32, u32)>) -> OpenSides {
        let mut open = OpenSides::default();
        for (a, b) in sides {
            open.expiry = open.expiry.max(self.last_blocks[a as usize].min(self.last_blocks[b as usize]));
            open.sides.push((self.vertices[a as usize], self.vertices[b as usize]));
        }
        open
    }

    /// Converts a triangle of this window to vertex indices of the whole mesh.
    pub(super) fn to_mesh_triangle(&self, triangle: [u32; 3]) -> BlockTriangle {
        let [corners, last_blocks] =
            [&self.vertices, &self.last_blocks].map(|values| triangle.map(|v| values[v as usize]));
        BlockTriangle { corners, last_blocks }
    }

    /// Returns the open sides of one triangle, whose corners are vertex indices of the whole mesh.
    pub(super) fn open_sides_in_mesh(&self, corners: [u32; 3]) -> Option<(BlockTriangle, OpenSides)> {
        let [Some(&a), Some(&b), Some(&c)] = corners.map(|v| self.local_indices.get(&v)) else { return None };
        let open = self.collected(self.open_sides_of([a, b, c]));
        (!open.sides.is_empty()).then(|| (self.to_mesh_triangle([a, b, c]), open))
    }

    /// Converts a strip of this window to vertex indices of the whole mesh.
    pub(super) fn strip_in_mesh(&self, strip: &[u32]) -> Vec<u32> {
        strip.iter().map(|&v| self.vertices[v as usize]).collect()
    }
}
