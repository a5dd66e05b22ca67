//! What is stripified at once: a block, and the strips that waited for it, as a mesh of their own.

use super::BlockTriangle;
use super::hash::NumberMap;
use super::held::{HeldStrip, sides_of};
use crate::mesh::{IndexedMesh, MeshError};
use crate::strip::{StripOptions, StripSet, strip_triangles, stripify};

/// A small mesh whose vertices are numbered from 0 in the order in which they come.
#[derive(Debug, Default)]
pub(super) struct Window {
    mesh: IndexedMesh,
    /// The number of a vertex here, by its number in the whole mesh.
    numbers: NumberMap<u32>,
    /// The other way round.
    vertices: Vec<u32>,
    /// For each vertex the last block that uses it.
    last_blocks: Vec<u32>,
    /// Sides between vertices that later blocks use, as they run, rising.
    rim: Vec<(u32, u32)>,
}

/// Where a strip may be gone on from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct OpenSides {
    pub(super) count: usize,
    /// The last block that can have a triangle at one of them.
    pub(super) expiry: u32,
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

    /// Adds a triangle of the block.
    pub(super) fn push(&mut self, triangle: &BlockTriangle) {
        let [a, b, c] = [0, 1, 2].map(|k| self.number(triangle.corners[k], triangle.last_blocks[k]));
        self.mesh.triangles.push([a, b, c]);
    }

    /// Adds the triangles of a strip that waited.
    pub(super) fn push_strip(&mut self, strip: &HeldStrip) {
        let corners = strip.indices.iter().zip(&strip.last_blocks);
        let indices: Vec<u32> = corners.map(|(&v, &last)| self.number(v, last)).collect();
        self.mesh.triangles.extend(strip_triangles(&indices));
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

    /// Finds the sides between vertices that blocks after this one use.
    pub(super) fn find_rim(&mut self, block: u32) {
        self.rim.clear();
        let is_shared = |v: u32| self.last_blocks[v as usize] > block;
        for (a, b) in self.mesh.triangles.iter().flat_map(|&t| sides_of(t)) {
            if is_shared(a) && is_shared(b) {
                self.rim.push((a, b));
            }
        }
        self.rim.sort_unstable();
    }

    /// Sides of a strip that have no triangle beside them yet, but may get one.
    pub(super) fn open_sides<'a>(&'a self, strip: &'a [u32]) -> impl Iterator<Item = (u32, u32)> + 'a {
        let is_rim = |side: &(u32, u32)| self.rim.binary_search(side).is_ok();
        let sides = strip_triangles(strip)
            .flat_map(sides_of)
            .filter(move |side| !self.rim.is_empty() && is_rim(side));
        sides.filter(move |&(a, b)| !is_rim(&(b, a)))
    }

    /// How many these are, and until when they are open.
    pub(super) fn count_open_sides(&self, strip: &[u32]) -> OpenSides {
        let mut open = OpenSides::default();
        for (a, b) in self.open_sides(strip) {
            let until = self.last_blocks[a as usize].min(self.last_blocks[b as usize]);
            open = OpenSides { count: open.count + 1, expiry: open.expiry.max(until) };
        }
        open
    }

    /// The strip over the vertices of the whole mesh.
    pub(super) fn strip_in_mesh(&self, strip: &[u32], out: &mut Vec<u32>) {
        out.clear();
        out.extend(strip.iter().map(|&v| self.vertices[v as usize]));
    }

    /// The strip as one that waits, and its open sides in the whole mesh.
    pub(super) fn to_held(&self, strip: &[u32], expiry: u32) -> (HeldStrip, Vec<(u32, u32)>) {
        let in_mesh = |v: u32| self.vertices[v as usize];
        let held = HeldStrip {
            indices: strip.iter().map(|&v| in_mesh(v)).collect(),
            last_blocks: strip.iter().map(|&v| self.last_blocks[v as usize]).collect(),
            expiry,
            triangle_count: strip_triangles(strip).count(),
        };
        (held, self.open_sides(strip).map(|(a, b)| (in_mesh(a), in_mesh(b))).collect())
    }
}
