//! What is stripified at once: a block, and the strips that waited for it, as a mesh of their own.

use striata::mesh::{IndexedMesh, MeshError};
use striata::strip::{StripSet, strip_triangles};

use super::chain::sides_of;
use super::hash::NumberMap;
use super::held::OpenSides;
use super::source::BlockTriangle;
use crate::entry::stripify;
use crate::options::StripOptions;

/// A small mesh whose vertices are numbered from 0 in the order in which they come.
#[derive(Debug, Default)]
pub(super) struct Window {
    mesh: IndexedMesh,
    /// The number of a vertex here, by its number in the whole mesh.
    numbers: NumberMap<u32, u32>,
    /// The other way round.
    vertices: Vec<u32>,
    /// For each vertex the last block that uses it.
    last_blocks: Vec<u32>,
    /// Sides between vertices that later blocks use, as they run, rising.
    rim: Vec<(u32, u32)>,
}

impl Window {
    /// Forgets all triangles.
    pub(super) fn clear(&mut self) {
        self.mesh.triangles.clear();
        self.numbers.clear();
        self.vertices.clear();
        self.last_blocks.clear();
    }

    /// Triangles.
    pub(super) fn triangle_count(&self) -> usize {
        self.mesh.triangle_count()
    }

    /// Adds a triangle.
    pub(super) fn push(&mut self, triangle: &BlockTriangle) {
        let [a, b, c] = [0, 1, 2].map(|k| self.number(triangle.corners[k], triangle.last_blocks[k]));
        self.mesh.triangles.push([a, b, c]);
    }

    /// Adds the end triangle of a chain and, where there is one, the triangle before it: linked with each other and
    /// on at the side without this corner, nowhere else. Whatever passes them begins with them, and turns as the
    /// chain did.
    pub(super) fn push_end(&mut self, triangle: &BlockTriangle, spare: u32, before: Option<[u32; 3]>) {
        let BlockTriangle { corners, last_blocks } = *triangle;
        let spare_twin = self.twin_vertex(spare);
        let mut numbers = [0; 3];
        for k in 0..3 {
            numbers[k] =
                if corners[k] == spare { spare_twin } else { self.number(corners[k], last_blocks[k]) };
        }
        self.mesh.triangles.push(numbers);
        let Some(before) = before else { return };
        let shared = |vertex: u32| corners.iter().position(|&corner| corner == vertex);
        let numbers = before.map(|vertex| match shared(vertex) {
            Some(k) => numbers[k],
            None => self.twin_vertex(vertex),
        });
        self.mesh.triangles.push(numbers);
    }

    /// A number beside that of the vertex, for one place: no side there meets another.
    fn twin_vertex(&mut self, vertex: u32) -> u32 {
        self.vertices.push(vertex);
        self.last_blocks.push(0);
        self.vertices.len() as u32 - 1
    }

    fn number(&mut self, vertex: u32, last_block: u32) -> u32 {
        let next = self.vertices.len() as u32;
        let number = *self.numbers.entry(vertex).or_insert(next);
        if number == next {
            self.vertices.push(vertex);
            self.last_blocks.push(last_block);
        } else {
            let known = &mut self.last_blocks[number as usize];
            *known = last_block.max(*known);
        }
        number
    }

    /// Covers the triangles by strips over the numbers of this window.
    pub(super) fn stripify(&mut self, options: &StripOptions) -> Result<StripSet, MeshError> {
        // Strips are about who is next to whom: the places of vertices do not matter.
        self.mesh.positions.resize(self.vertices.len(), [0.0; 3]);
        stripify(&self.mesh, options)
    }

    /// Finds the sides between vertices that blocks after this one use; beside those of `taken`, sides over
    /// the vertices of the whole mesh, lies a triangle that is not in the window.
    pub(super) fn find_rim<'a>(&mut self, block: u32, taken: impl Iterator<Item = &'a (u32, u32)>) {
        self.rim.clear();
        let is_shared = |v: u32| self.last_blocks[v as usize] > block;
        let real = |v: u32| self.numbers.get(&self.vertices[v as usize]).copied().unwrap_or(v);
        for (a, b) in self.mesh.triangles.iter().flat_map(|&t| sides_of(t)) {
            if is_shared(a) && is_shared(b) {
                self.rim.push((real(a), real(b)));
            }
        }
        self.rim.extend(taken.filter_map(|(a, b)| Some((*self.numbers.get(b)?, *self.numbers.get(a)?))));
        self.rim.sort_unstable();
    }

    /// Open sides of a triangle over this window's numbers.
    fn open_sides_of(&self, triangle: [u32; 3]) -> impl Iterator<Item = (u32, u32)> {
        let is_rim = |side: &(u32, u32)| self.rim.binary_search(side).is_ok();
        let sides = if self.rim.is_empty() { None } else { Some(sides_of(triangle)) };
        sides.into_iter().flatten().filter(move |&(a, b)| is_rim(&(a, b)) && !is_rim(&(b, a)))
    }

    /// Open sides of all triangles of a strip over this window's numbers.
    pub(super) fn open_sides(&self, strip: &[u32]) -> OpenSides {
        self.collected(strip_triangles(strip).flat_map(|t| self.open_sides_of(t)))
    }

    /// How many open sides a strip has.
    pub(super) fn open_side_count(&self, strip: &[u32]) -> usize {
        strip_triangles(strip).map(|t| self.open_sides_of(t).count()).sum()
    }

    fn collected(&self, sides: impl Iterator<Item = (u32, u32)>) -> OpenSides {
        let mut open = OpenSides::default();
        for (a, b) in sides {
            open.expiry = open.expiry.max(self.last_blocks[a as usize].min(self.last_blocks[b as usize]));
            open.sides.push((self.vertices[a as usize], self.vertices[b as usize]));
        }
        open
    }

    /// A triangle of this window in the whole mesh.
    pub(super) fn in_mesh(&self, triangle: [u32; 3]) -> BlockTriangle {
        let [corners, last_blocks] =
            [&self.vertices, &self.last_blocks].map(|numbers| triangle.map(|v| numbers[v as usize]));
        BlockTriangle { corners, last_blocks }
    }

    /// The open sides of one triangle, its corners numbered as in the whole mesh.
    pub(super) fn open_sides_in_mesh(&self, corners: [u32; 3]) -> Option<(BlockTriangle, OpenSides)> {
        let [Some(&a), Some(&b), Some(&c)] = corners.map(|v| self.numbers.get(&v)) else { return None };
        let open = self.collected(self.open_sides_of([a, b, c]));
        (!open.sides.is_empty()).then(|| (self.in_mesh([a, b, c]), open))
    }

    /// A strip of this window over the vertices of the whole mesh.
    pub(super) fn strip_in_mesh(&self, strip: &[u32]) -> Vec<u32> {
        strip.iter().map(|&v| self.vertices[v as usize]).collect()
    }
}
