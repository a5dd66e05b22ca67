//! Tracks vertices that no triangle of the current level refers to.
//!
//! If every corner has its own vertex, the corners of new triangles mostly refer to vertices that have
//! not been used yet. We count the corners that refer to each vertex, so that unused vertices are found
//! quickly. Only vertices whose index is near an expected one are examined, so positions with thousands
//! of vertices take no longer.

use std::ops::Range;

use crate::topology::surface::NONE;

/// Maximum distance of examined vertices from the expected one.
const WINDOW: u32 = 24;
/// Maximum number of hidden vertices that are returned.
const MOST: usize = 8;

/// Counts of the corners that refer to each vertex.
#[derive(Clone, Debug, Default)]
pub(crate) struct HiddenWedges {
    corner_counts: Vec<u32>,
    /// Result of the last search, nearest first.
    found: Vec<u32>,
}

impl HiddenWedges {
    /// Records that one more corner refers to a vertex.
    pub(crate) fn add_corner(&mut self, vertex: u32) {
        if vertex == NONE {
            return;
        }
        if vertex as usize >= self.corner_counts.len() {
            self.corner_counts.resize(vertex as usize + 1, 0);
        }
        self.corner_counts[vertex as usize] += 1;
    }

    /// Records that one corner fewer refers to a vertex.
    pub(crate) fn remove_corner(&mut self, vertex: u32) {
        if let Some(count) = self.corner_counts.get_mut(vertex as usize) {
            *count = count.saturating_sub(1);
        }
    }

    /// Finds the hidden vertices of a range near an expected vertex.
    pub(crate) fn find(&mut self, all: &Range<u32>, near: u32) -> &[u32] {
        self.found.clear();
        let near = if all.contains(&near) { near } else { all.start };
        for distance in 0..=WINDOW.min(all.len() as u32) {
            let above = near + distance;
            let below = near.checked_sub(distance).filter(|_| distance > 0);
            for vertex in [Some(above), below].into_iter().flatten().filter(|v| all.contains(v)) {
                let is_hidden = self.corner_counts.get(vertex as usize).is_none_or(|count| *count == 0);
                if is_hidden && self.found.len() < MOST {
                    self.found.push(vertex);
                }
            }
        }
        &self.found
    }

    /// Whether at most one corner refers to a vertex, as in meshes in which each corner has its own vertex.
    pub(crate) fn has_one_corner_at_most(&self, vertex: u32) -> bool {
        self.corner_counts.get(vertex as usize).is_none_or(|count| *count < 2)
    }

    /// Returns the result of the last [`find`](Self::find).
    pub(crate) fn found(&self) -> &[u32] {
        &self.found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hidden_vertices_come_nearest_first() {
        let mut hidden = HiddenWedges::default();
        assert_eq!(hidden.find(&(4..9), 6), [6, 7, 5, 8, 4]);
        [5, 6, 6, 8].into_iter().for_each(|vertex| hidden.add_corner(vertex));
        assert_eq!(hidden.find(&(4..9), 6), [7, 4]);
        assert!(
            hidden.has_one_corner_at_most(5)
                && !hidden.has_one_corner_at_most(6)
                && hidden.has_one_corner_at_most(99)
        );
        hidden.remove_corner(6);
        hidden.remove_corner(5);
        hidden.remove_corner(5);
        assert_eq!(hidden.find(&(4..9), 6), [7, 5, 4]);
        // An expected vertex outside the range is ignored.
        assert_eq!(hidden.find(&(4..9), 60), [4, 5, 7]);
        assert_eq!(hidden.found(), [4, 5, 7]);
        assert!(hidden.find(&(0..100_000), 50_000).len() == MOST);
    }
}
