//! A mesh at the level that has arrived so far, together with the steps that lead to it.

use std::ops::Range;

/// Borrowed arrays of a mesh that grows step by step: a stream whose bytes are still arriving, for example.
///
/// Vertices are numbered in refinement order, as in a
/// [`CollapseSequence`](striata::mesh::CollapseSequence). Triangles are listed in the order in which
/// steps add them, so every level uses a prefix of the triangles as well as of the vertices.
#[derive(Clone, Copy, Debug, Default)]
pub struct PrefixMesh<'a> {
    /// Position of each vertex, in mesh units.
    pub positions: &'a [[f32; 3]],
    /// First vertex of each position, followed by the vertex count.
    pub first_vertices: &'a [u32],
    /// The vertex that each vertex beyond the base collapses to; it belongs to an earlier position.
    pub targets: &'a [u32],
    /// Corners of each triangle at the finest level that has arrived: first those of the base, then those
    /// of each step.
    pub triangles: &'a [[u32; 3]],
    /// Number of triangles that each step adds.
    pub added_triangle_counts: &'a [u8],
}

impl<'a> PrefixMesh<'a> {
    /// Number of steps that have arrived.
    pub fn step_count(&self) -> usize {
        self.added_triangle_counts.len()
    }

    /// Number of positions in the base mesh.
    pub fn base_position_count(&self) -> usize {
        self.first_vertices.len().saturating_sub(1 + self.step_count())
    }

    /// Number of vertices in the base mesh.
    pub fn base_vertex_count(&self) -> usize {
        self.vertex_count_at(0)
    }

    /// Number of vertices that a level uses, counted from the first.
    ///
    /// # Panics
    /// If `split_count` exceeds the number of steps.
    pub fn vertex_count_at(&self, split_count: usize) -> usize {
        assert!(split_count <= self.step_count(), "split count {split_count} of {}", self.step_count());
        self.first_vertices.get(self.base_position_count() + split_count).map_or(0, |&count| count as usize)
    }

    /// Number of triangles that a level uses, counted from the first.
    ///
    /// # Panics
    /// If `split_count` exceeds the number of steps.
    pub fn triangle_count_at(&self, split_count: usize) -> usize {
        let missing = &self.added_triangle_counts[split_count..];
        self.triangles.len() - missing.iter().map(|&count| usize::from(count)).sum::<usize>()
    }

    /// Returns the split count of the most detailed level with at most `triangle_count` triangles, or 0
    /// if even the base has more.
    pub fn split_count_for_triangles(&self, triangle_count: usize) -> usize {
        let (mut split_count, mut count) = (self.step_count(), self.triangles.len());
        while count > triangle_count && split_count > 0 {
            split_count -= 1;
            count -= usize::from(self.added_triangle_counts[split_count]);
        }
        split_count
    }

    /// Range of the vertices that a step adds.
    ///
    /// # Panics
    /// If the step has not arrived.
    #[inline]
    pub fn step_vertices(&self, step: usize) -> Range<u32> {
        let position = self.base_position_count() + step;
        self.first_vertices[position]..self.first_vertices[position + 1]
    }

    /// Appends the triangles of a uniform level, each with its index in [`triangles`](Self::triangles).
    ///
    /// Takes one pass over all vertices, even for coarse levels, and one over the level's triangles.
    ///
    /// # Panics
    /// If `split_count` exceeds the number of steps.
    pub fn triangles_at_into(&self, split_count: usize, out: &mut Vec<(u32, [u32; 3])>) {
        let vertex_count = self.vertex_count_at(split_count) as u32;
        let shown = self.shown_vertices(|vertex| vertex < vertex_count);
        self.append_shown(0..self.triangle_count_at(split_count), &shown, out);
    }

    /// For each vertex, returns the vertex that represents it: the vertex itself if it is active,
    /// otherwise the one that represents its target.
    pub(crate) fn shown_vertices(&self, is_active: impl Fn(u32) -> bool) -> Vec<u32> {
        let base_count = self.base_vertex_count() as u32;
        // Targets come earlier, so one pass in ascending order resolves chains of any length.
        let mut shown: Vec<u32> = (0..base_count).collect();
        shown.reserve(self.targets.len());
        for (vertex, &target) in (base_count..).zip(self.targets) {
            shown.push(if is_active(vertex) { vertex } else { shown[target as usize] });
        }
        shown
    }

    /// Appends triangles with each corner replaced by its representative, skipping those that become
    /// degenerate.
    pub(crate) fn append_shown(&self, range: Range<usize>, shown: &[u32], out: &mut Vec<(u32, [u32; 3])>) {
        for (number, corners) in range.clone().zip(&self.triangles[range]) {
            let corners = corners.map(|v| shown[v as usize]);
            if is_proper(&corners) {
                out.push((number as u32, corners));
            }
        }
    }
}

/// Whether a triangle has three different corners.
pub(crate) fn is_proper(&[a, b, c]: &[u32; 3]) -> bool {
    a != b && b != c && c != a
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A square whose corner 3 collapses to 0, and whose center 4 collapses to 3.
    const SQUARE: PrefixMesh<'static> = PrefixMesh {
        positions: &[[0.0; 3]; 5],
        first_vertices: &[0, 1, 2, 3, 4, 5],
        targets: &[0, 3],
        triangles: &[[1, 2, 4], [0, 1, 4], [2, 3, 4], [3, 0, 4]],
        added_triangle_counts: &[1, 2],
    };

    #[test]
    fn a_level_is_a_prefix_of_vertices_and_triangles() {
        let level = |split_count| {
            let mut triangles = Vec::new();
            SQUARE.triangles_at_into(split_count, &mut triangles);
            triangles
        };
        assert_eq!(SQUARE.base_vertex_count(), 3);
        assert_eq!((0..3).map(|s| SQUARE.triangle_count_at(s)).collect::<Vec<_>>(), [1, 2, 4]);
        assert_eq!(SQUARE.step_vertices(1), 4..5);
        assert_eq!(level(0), [(0, [1, 2, 0])]);
        assert_eq!(level(1), [(0, [1, 2, 3]), (1, [0, 1, 3])]);
        assert_eq!(level(2), (0..4).map(|t| (t, SQUARE.triangles[t as usize])).collect::<Vec<_>>());
    }

    #[test]
    fn finds_the_finest_level_within_a_budget() {
        let counts = [0, 1, 2, 3, 4, 9].map(|count| SQUARE.split_count_for_triangles(count));
        assert_eq!(counts, [0, 0, 1, 1, 2, 2]);
        assert_eq!(PrefixMesh::default().split_count_for_triangles(5), 0);
    }
}
