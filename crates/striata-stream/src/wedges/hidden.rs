//! Which vertices no triangle of the level shows yet.
//!
//! Where every corner has a vertex of its own, the corners of new triangles mostly show vertices that nothing has shown so
//! far. Corners are counted by the vertex that they show, so that such vertices are found at once; only those whose numbers
//! are near an expected one are looked at, so positions of thousands of vertices take no longer.

use std::ops::Range;

use crate::topology::surface::NONE;

/// Vertices that are looked at.
const WINDOW: u32 = 24;
/// Hidden ones that are of use.
const MOST: usize = 8;

/// Corners that show each vertex.
#[derive(Clone, Debug, Default)]
pub(crate) struct HiddenWedges {
    corner_counts: Vec<u32>,
    /// Those found last, nearest first.
    found: Vec<u32>,
}

impl HiddenWedges {
    /// One more corner shows a vertex.
    pub(crate) fn show(&mut self, vertex: u32) {
        if vertex == NONE {
            return;
        }
        if vertex as usize >= self.corner_counts.len() {
            self.corner_counts.resize(vertex as usize + 1, 0);
        }
        self.corner_counts[vertex as usize] += 1;
    }

    /// One corner less shows a vertex.
    pub(crate) fn hide(&mut self, vertex: u32) {
        if let Some(count) = self.corner_counts.get_mut(vertex as usize) {
            *count = count.saturating_sub(1);
        }
    }

    /// Finds the hidden vertices of a range that are near one of it.
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

    /// True if one corner at most shows a vertex, as where each corner has one of its own.
    pub(crate) fn is_lone(&self, vertex: u32) -> bool {
        self.corner_counts.get(vertex as usize).is_none_or(|count| *count < 2)
    }

    /// What [`find`](Self::find) found last.
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
        [5, 6, 6, 8].into_iter().for_each(|vertex| hidden.show(vertex));
        assert_eq!(hidden.find(&(4..9), 6), [7, 4]);
        assert!(hidden.is_lone(5) && !hidden.is_lone(6) && hidden.is_lone(99));
        hidden.hide(6);
        hidden.hide(5);
        hidden.hide(5);
        assert_eq!(hidden.find(&(4..9), 6), [7, 5, 4]);
        // What is expected elsewhere says nothing.
        assert_eq!(hidden.find(&(4..9), 60), [4, 5, 7]);
        assert_eq!(hidden.found(), [4, 5, 7]);
        assert!(hidden.find(&(0..100_000), 50_000).len() == MOST);
    }
}
