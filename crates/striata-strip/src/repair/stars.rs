//! Corners at each vertex, kept up to date through collapses and splits.
//!
//! Each vertex has a doubly linked ring of its corners, which also contains one node for the vertex itself.
//! A collapse moves the corners of one ring into another. The node that lost them still points at the first
//! and last of them, so undoing is exact as long as it runs in reverse order. The same is true of a corner
//! that is removed from its ring.
//!
//! ```text
//!     (u) - a - b -            collapse v -> u         (u) - c - d - e - a - b -
//!     (v) - c - d - e -                                (v) still points at c and e
//! ```
//!
//! 8 bytes per corner and per vertex; a collapse or split changes two links, whatever the valence.

use striata::mesh::is_proper;

/// Rings of corners; a corner is `3 * triangle + k`.
#[derive(Clone, Debug)]
pub(super) struct CornerStars {
    /// Next and previous node of each node; the nodes of vertices follow those of corners.
    around: Vec<[u32; 2]>,
    corner_count: u32,
}

const NEXT: usize = 0;
const PREV: usize = 1;

impl CornerStars {
    /// Puts every corner of these triangles into the ring of its vertex; corners of degenerate triangles
    /// are in none.
    pub(super) fn new(triangles: &[[u32; 3]], vertex_count: usize) -> Self {
        let corner_count = 3 * triangles.len() as u32;
        let node_count = corner_count + vertex_count as u32;
        let mut stars = Self { around: (0..node_count).map(|node| [node, node]).collect(), corner_count };
        for (corners, first) in triangles.iter().zip((0..).step_by(3)) {
            if is_proper(corners) {
                for (&vertex, corner) in corners.iter().zip(first..) {
                    let node = stars.node_of(vertex);
                    stars.put(stars.around[node as usize][PREV], corner, node);
                }
            }
        }
        stars
    }

    /// Returns the node of a vertex.
    fn node_of(&self, vertex: u32) -> u32 {
        self.corner_count + vertex
    }

    /// Links three nodes in a row.
    fn put(&mut self, before: u32, node: u32, after: u32) {
        self.around[node as usize] = [after, before];
        self.around[before as usize][NEXT] = node;
        self.around[after as usize][PREV] = node;
    }

    /// Iterates over the corners at an active vertex.
    pub(super) fn corners(&self, vertex: u32) -> impl Iterator<Item = u32> {
        let node = self.node_of(vertex);
        let mut next = self.around[node as usize][NEXT];
        std::iter::from_fn(move || {
            let corner = next;
            (corner != node).then(|| {
                next = self.around[corner as usize][NEXT];
                corner
            })
        })
    }

    /// Removes a corner from its ring.
    pub(super) fn remove(&mut self, corner: u32) {
        let [next, prev] = self.around[corner as usize];
        self.around[prev as usize][NEXT] = next;
        self.around[next as usize][PREV] = prev;
    }

    /// Puts back the corner that was removed last.
    pub(super) fn restore(&mut self, corner: u32) {
        let [next, prev] = self.around[corner as usize];
        self.around[prev as usize][NEXT] = corner;
        self.around[next as usize][PREV] = corner;
    }

    /// Moves all corners of `vertex` to the front of the ring of `target`.
    pub(super) fn collapse(&mut self, vertex: u32, target: u32) {
        let (vertex, target) = (self.node_of(vertex), self.node_of(target));
        let [first, last] = self.around[vertex as usize];
        if first != vertex {
            let after = self.around[target as usize][NEXT];
            self.link(target, first);
            self.link(last, after);
        }
    }

    /// Undoes the last collapse.
    pub(super) fn split(&mut self, vertex: u32, target: u32) {
        let (vertex, target) = (self.node_of(vertex), self.node_of(target));
        let [first, last] = self.around[vertex as usize];
        if first != vertex {
            let after = self.around[last as usize][NEXT];
            self.link(target, after);
            self.around[first as usize][PREV] = vertex;
            self.around[last as usize][NEXT] = vertex;
        }
    }

    /// Links two nodes in a row.
    fn link(&mut self, before: u32, after: u32) {
        self.around[before as usize][NEXT] = after;
        self.around[after as usize][PREV] = before;
    }

    /// Returns the size of the rings in bytes.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.around[..])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(stars: &CornerStars, vertex_count: u32) -> Vec<Vec<u32>> {
        (0..vertex_count).map(|v| stars.corners(v).collect()).collect()
    }

    #[test]
    fn a_walk_back_restores_every_ring() {
        let mut stars = CornerStars::new(&[[0, 1, 2], [0, 2, 3], [3, 3, 1], [3, 2, 4]], 6);
        let before = all(&stars, 6);
        assert_eq!(before[0], vec![0, 3]);
        assert_eq!(before[3], vec![5, 9]);
        for corner in [9, 10, 11] {
            stars.remove(corner);
        }
        stars.collapse(5, 4);
        stars.collapse(4, 2);
        stars.collapse(3, 0);
        assert_eq!(stars.corners(0).collect::<Vec<_>>(), vec![5, 0, 3]);
        stars.collapse(2, 1);
        stars.split(2, 1);
        stars.split(3, 0);
        stars.split(4, 2);
        stars.split(5, 4);
        for corner in [11, 10, 9] {
            stars.restore(corner);
        }
        assert_eq!(all(&stars, 6), before);
    }
}
