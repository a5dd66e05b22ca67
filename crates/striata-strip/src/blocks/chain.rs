//! Strip that can grow at both ends.
//!
//! Two strips whose end triangles share an edge become one. Each is first turned so that its outermost two
//! indices are that edge, which takes a swap if its last step runs along another edge. Then the indices
//! after the edge in one strip are appended to the other.
//!
//! ```text
//!     a b c d  +  c d e f   ->   a b c d e f        same order of the edge
//!     a b c d  +  d c e f   ->   a b c d c e f      opposite order: one more swap
//! ```
//!
//! A join saves the restart and the edge (three indices) and costs at most three swaps.

use std::collections::VecDeque;

use striata::mesh::is_proper;

/// One end of a strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ChainEnd {
    Front = 0,
    Back = 1,
}

impl ChainEnd {
    pub(super) const BOTH: [Self; 2] = [Self::Front, Self::Back];

    /// Returns the opposite end.
    pub(super) fn other(self) -> Self {
        match self {
            Self::Front => Self::Back,
            Self::Back => Self::Front,
        }
    }
}

/// Returns the three directed sides of a triangle.
pub(super) fn sides_of([a, b, c]: [u32; 3]) -> [(u32, u32); 3] {
    [(a, b), (b, c), (c, a)]
}

/// Strip of at least one triangle; its first and last triangles are not degenerate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct BlockChain {
    indices: VecDeque<u32>,
    /// Whether the first triangle has the winding of an odd position.
    is_odd: bool,
}

impl BlockChain {
    /// Creates a chain from the indices of a strip.
    pub(super) fn new(strip: &[u32]) -> Self {
        debug_assert!(strip.len() >= 3, "a strip of {} indices has no triangle", strip.len());
        Self { indices: strip.iter().copied().collect(), is_odd: false }
    }

    /// Number of indices.
    pub(super) fn len(&self) -> usize {
        self.indices.len()
    }

    /// Returns the index at a distance from an end.
    fn at(&self, end: ChainEnd, distance: usize) -> u32 {
        match end {
            ChainEnd::Front => self.indices[distance],
            ChainEnd::Back => self.indices[self.indices.len() - 1 - distance],
        }
    }

    /// Adds an index at an end.
    fn push(&mut self, end: ChainEnd, vertex: u32) {
        match end {
            ChainEnd::Front => {
                self.indices.push_front(vertex);
                self.is_odd = !self.is_odd;
            }
            ChainEnd::Back => self.indices.push_back(vertex),
        }
    }

    /// Removes the index at an end.
    fn pop(&mut self, end: ChainEnd) {
        match end {
            ChainEnd::Front => {
                self.indices.pop_front();
                self.is_odd = !self.is_odd;
            }
            ChainEnd::Back => {
                self.indices.pop_back();
            }
        }
    }

    /// Returns the triangle at an end, with its winding.
    pub(super) fn end_triangle(&self, end: ChainEnd) -> [u32; 3] {
        let first = match end {
            ChainEnd::Front => 0,
            ChainEnd::Back => self.indices.len() - 3,
        };
        let [a, b, c] = [0, 1, 2].map(|i| self.indices[first + i]);
        if self.is_odd != (first % 2 == 1) { [b, a, c] } else { [a, b, c] }
    }

    /// Returns the corner of an end triangle that the next triangle will not share.
    ///
    /// If a triangle lies next to the edge of the outermost two indices, it is the third one, which needs
    /// no swap.
    pub(super) fn spare_corner(&self, end: ChainEnd, has_neighbor_at: impl Fn([u32; 2]) -> bool) -> u32 {
        let [outermost, middle, inner] = [0, 1, 2].map(|distance| self.at(end, distance));
        if has_neighbor_at([outermost, middle]) { inner } else { middle }
    }

    /// Returns the edge across which the strip entered its end triangle. [`None`] if it entered at a vertex
    /// only, or if there is no other triangle.
    ///
    /// Two triangles that contain an edge in the same direction were joined at a vertex, whatever else they
    /// share.
    pub(super) fn last_edge(&self, end: ChainEnd) -> Option<[u32; 2]> {
        let edge = [self.at(end, 1), self.at(end, 2)];
        let before = (1..self.len() - 2).map(|first| [0, 1, 2].map(|i| self.at(end, first + i)));
        let (distance, previous) = (1..).zip(before).find(|(_, corners)| is_proper(corners))?;
        // Seen from an end, every other triangle is reversed.
        let turned = |[a, b, c]: [u32; 3], is_turned: bool| if is_turned { [b, a, c] } else { [a, b, c] };
        let runs_along = |corners| sides_of(corners).contains(&(edge[0], edge[1]));
        let last = [0, 1, 2].map(|i| self.at(end, i));
        let is_edge = edge.iter().all(|corner| previous.contains(corner))
            && runs_along(last) != runs_along(turned(previous, distance % 2 == 1));
        is_edge.then_some(edge)
    }

    /// Removes the triangle at an end if the strip entered it across an edge, and returns that edge.
    pub(super) fn take_end(&mut self, end: ChainEnd) -> Option<[u32; 2]> {
        let edge = self.last_edge(end)?;
        self.pop(end);
        while !is_proper(&[0, 1, 2].map(|distance| self.at(end, distance))) {
            self.pop(end);
        }
        Some(edge)
    }

    /// Whether the strip can continue from an end across this edge of its end triangle.
    fn can_leave_by(&self, end: ChainEnd, [u, v]: [u32; 2]) -> bool {
        let corners = [0, 1, 2].map(|distance| self.at(end, distance));
        let is_free = |corner: u32| corner == corners[0] || self.len() == 3;
        is_proper(&corners) && corners.contains(&u) && corners.contains(&v) && (is_free(u) || is_free(v))
    }

    /// Makes this edge the outermost two indices.
    fn turn_to(&mut self, end: ChainEnd, edge: [u32; 2]) {
        if self.len() == 3 {
            while edge.contains(&self.at(end, 2)) {
                self.indices.rotate_left(1);
            }
        } else if !edge.contains(&self.at(end, 1)) {
            let (outermost, third) = (self.at(end, 0), self.at(end, 2));
            self.pop(end);
            self.push(end, third);
            self.push(end, outermost);
        }
    }

    /// Continues from an end with another strip, across the edge that both end triangles share.
    ///
    /// Returns the other strip unchanged if either strip already continues across that edge.
    pub(super) fn join(
        &mut self,
        end: ChainEnd,
        mut other: Self,
        other_end: ChainEnd,
        edge: [u32; 2],
    ) -> Option<Self> {
        if !self.can_leave_by(end, edge) || !other.can_leave_by(other_end, edge) {
            return Some(other);
        }
        self.turn_to(end, edge);
        other.turn_to(other_end, edge);
        if self.at(end, 0) == other.at(other_end, 0) {
            self.push(end, self.at(end, 1));
        }
        for distance in 2..other.len() {
            self.push(end, other.at(other_end, distance));
        }
        None
    }

    /// Writes the indices of the strip, from an end that needs no parity fix if there is one.
    pub(super) fn write(&self, out: &mut Vec<u32>) {
        out.clear();
        if !self.is_odd {
            out.extend(&self.indices);
        } else if !self.len().is_multiple_of(2) {
            out.extend(self.indices.iter().rev());
        } else {
            out.extend(self.indices.front());
            out.extend(&self.indices);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::canonical_triangles;
    use striata::strip::strip_triangles;

    fn written(chain: &BlockChain) -> Vec<u32> {
        let mut out = Vec::new();
        chain.write(&mut out);
        out
    }

    fn triangles(chain: &BlockChain) -> Vec<[u32; 3]> {
        canonical_triangles(&strip_triangles(&written(chain)).collect::<Vec<_>>())
    }

    #[test]
    fn ends_know_their_winding() {
        let chain = BlockChain::new(&[0, 1, 2, 3, 2, 4]);
        assert_eq!(chain.end_triangle(ChainEnd::Front), [0, 1, 2]);
        assert_eq!(chain.end_triangle(ChainEnd::Back), [2, 3, 4]);
    }

    #[test]
    fn an_end_that_is_taken_and_joined_again_changes_no_triangle() {
        for strip in
            [&[0, 1, 2, 3, 4][..], &[0, 1, 2, 3, 2, 4], &[0, 1, 2, 1, 3, 4, 5], &[0, 1, 2, 1, 3, 1, 4]]
        {
            for end in ChainEnd::BOTH {
                let whole = BlockChain::new(strip);
                let mut rest = whole.clone();
                let corners = whole.end_triangle(end);
                let edge = rest.take_end(end).unwrap();
                assert!(triangles(&rest).len() + 1 == triangles(&whole).len(), "{strip:?} {end:?}");
                for turn in 0..3 {
                    let mut single = corners;
                    single.rotate_left(turn);
                    for other_end in ChainEnd::BOTH {
                        let mut joined = rest.clone();
                        assert_eq!(joined.join(end, BlockChain::new(&single), other_end, edge), None);
                        assert_eq!(triangles(&joined), triangles(&whole), "{strip:?} {end:?} {other_end:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn an_end_that_was_reached_by_a_vertex_alone_stays() {
        // Two strips joined at vertex 3 by degenerate triangles; then a strip of one triangle.
        for strip in [&[0, 1, 2, 3, 3, 4, 5][..], &[0, 1, 2]] {
            let mut chain = BlockChain::new(strip);
            let whole = chain.clone();
            assert_eq!(
                (chain.last_edge(ChainEnd::Back), chain.take_end(ChainEnd::Back)),
                (None, None),
                "{strip:?}"
            );
            assert_eq!(chain, whole);
        }
    }

    #[test]
    fn strips_join_over_any_edge_of_their_ends() {
        // Two strips of a fan of quads: the end of one has two free sides.
        let first = BlockChain::new(&[0, 1, 2, 3]);
        for (edge, strip, length) in [
            ([2, 3], [2, 3, 4, 5], 6),
            ([2, 3], [5, 4, 3, 2], 6),
            ([1, 3], [3, 1, 6, 7], 8),
            ([1, 3], [1, 6, 3, 7], 8),
        ] {
            let second = BlockChain::new(&strip);
            let other_end = if strip[..3].contains(&edge[0]) && strip[..3].contains(&edge[1]) {
                ChainEnd::Front
            } else {
                ChainEnd::Back
            };
            let mut joined = first.clone();
            assert_eq!(joined.join(ChainEnd::Back, second.clone(), other_end, edge), None);
            assert_eq!(written(&joined).len(), length, "{edge:?} {strip:?}: {:?}", written(&joined));
            assert_eq!(triangles(&joined).len(), 4);
        }
        let mut inner = first.clone();
        let second = BlockChain::new(&[1, 2, 8, 9]);
        assert_eq!(inner.join(ChainEnd::Back, second.clone(), ChainEnd::Front, [1, 2]), Some(second));
        assert_eq!(inner, first);
    }
}
