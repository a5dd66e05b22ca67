//! What a search for strips knows of a mesh: corners, links, and the triangles around each vertex.

use striata::mesh::NO_TWIN;
use striata::strip::{StripLinks, prev_side};

use crate::task::Task;

/// Triangles, their links, and the proper triangles around each vertex: 12 bytes a triangle and 4 a vertex.
pub(super) struct Surface<'a> {
    pub(super) triangles: &'a [[u32; 3]],
    twins: &'a [u32],
    /// First entry of each vertex in `around`, closed by the end.
    offsets: Vec<u32>,
    around: Vec<u32>,
}

impl<'a> Surface<'a> {
    pub(super) fn new(task: &Task<'a>, links: &StripLinks<'a>) -> Self {
        let triangles = task.triangles;
        let vertex_limit = triangles.iter().flatten().max().map_or(0, |&v| v as usize + 1);
        let proper = || (0..triangles.len() as u32).filter(|&t| task.is_proper(t));
        // Counted two places on, so that filling turns each place into the end of its vertex.
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
                let place = &mut offsets[v as usize + 1];
                around[*place as usize] = t;
                *place += 1;
            }
        }
        offsets.pop();
        Self { triangles, twins: links.twins(), offsets, around }
    }

    pub(super) fn vertex_limit(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Whether a triangle has three corners.
    #[inline]
    pub(super) fn is_proper(&self, triangle: u32) -> bool {
        let [a, b, c] = self.triangles[triangle as usize];
        a != b && b != c && c != a
    }

    /// The proper triangles around a vertex.
    #[inline]
    pub(super) fn around(&self, v: u32) -> &[u32] {
        &self.around[self.offsets[v as usize] as usize..self.offsets[v as usize + 1] as usize]
    }

    /// The side beyond this one.
    #[inline]
    pub(super) fn twin(&self, side: u32) -> Option<u32> {
        let twin = self.twins[side as usize];
        (twin != NO_TWIN).then_some(twin)
    }

    /// The corner that a side runs from.
    #[inline]
    pub(super) fn corner(&self, side: u32) -> u32 {
        self.triangles[side as usize / 3][side as usize % 3]
    }

    /// The corner opposite a side.
    #[inline]
    pub(super) fn apex(&self, side: u32) -> u32 {
        self.corner(prev_side(side))
    }
}
