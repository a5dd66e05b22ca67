//! Mesh adjacency for the cache search: corners, links, and the triangles around each vertex.

use striata::mesh::NO_TWIN;
use striata::strip::{StripLinks, prev_side};

use crate::task::StripTask;

/// Triangles, their links, and the proper triangles around each vertex. Takes 12 bytes per triangle and 4
/// per vertex.
pub(super) struct TriangleAdjacency<'a> {
    pub triangles: &'a [[u32; 3]],
    twins: &'a [u32],
    /// Start of each vertex's range in `around`, followed by the total.
    offsets: Vec<u32>,
    around: Vec<u32>,
}

impl<'a> TriangleAdjacency<'a> {
    /// Collects the adjacency of a mesh.
    pub(super) fn new(task: &StripTask<'a>, links: &StripLinks<'a>) -> Self {
        let triangles = task.triangles;
        let vertex_limit = triangles.iter().flatten().max().map_or(0, |&v| v as usize + 1);
        let proper = || (0..triangles.len() as u32).filter(|&t| task.is_proper(t));
        // Counts are stored two entries later, so that filling turns each entry into the end of its
        // vertex's range.
        let mut offsets = vec![0u32; vertex_limit + 2];
        for v in proper().flat_map(|t| triangles[t as usize]) {
            offsets[v as usize + 2] += 1;
        }
        for v in 2..offsets.len() {
            offsets[v] += offsets[v - 1];
        }
        let mut around = vec![0; offsets[vertex_limit + 1] as usize];
        for t in proper() {
            for v in triangles[t as usize] {
                let next = &mut offsets[v as usize + 1];
                around[*next as usize] = t;
                *next += 1;
            }
        }
        offsets.pop();
        Self { triangles, twins: links.twins(), offsets, around }
    }

    /// Returns one more than the largest vertex index.
    pub(super) fn vertex_limit(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Whether a triangle has three distinct corners.
    #[inline]
    pub(super) fn is_proper(&self, triangle: u32) -> bool {
        let [a, b, c] = self.triangles[triangle as usize];
        a != b && b != c && c != a
    }

    /// Returns the proper triangles around a vertex.
    #[inline]
    pub(super) fn around(&self, v: u32) -> &[u32] {
        &self.around[self.offsets[v as usize] as usize..self.offsets[v as usize + 1] as usize]
    }

    /// Returns the same edge as a side of the neighboring triangle, if there is one.
    #[inline]
    pub(super) fn twin(&self, side: u32) -> Option<u32> {
        let twin = self.twins[side as usize];
        (twin != NO_TWIN).then_some(twin)
    }

    /// Returns the vertex from which a side runs.
    #[inline]
    pub(super) fn corner(&self, side: u32) -> u32 {
        self.triangles[side as usize / 3][side as usize % 3]
    }

    /// Returns the corner opposite a side.
    #[inline]
    pub(super) fn apex(&self, side: u32) -> u32 {
        self.corner(prev_side(side))
    }
}
