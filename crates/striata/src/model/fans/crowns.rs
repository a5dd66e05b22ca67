//! Crowns (\[Cor01\], section 3.6.1): joins the triangles around a vertex into as few connected runs as
//! possible.
//!
//! Each triangle around a pivot is an arc between its two other corners. A run of consecutive arcs is a
//! crown. A manifold vertex has a single crown, closed or open; other vertices may have several, and a
//! crown may pass a node twice. The minimum is found by an Euler tour: crowns begin at nodes with more
//! outgoing than incoming arcs, and end at nodes with fewer.

/// A triangle around a pivot, given by its other two corners and its creator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct RingArc {
    /// The corner after the pivot.
    pub from: u32,
    /// The corner after `from`.
    pub to: u32,
    /// The step that creates the triangle, or a marker for none.
    pub creator: u32,
}

/// Splits arcs into crowns, runs of consecutive arcs. The result does not depend on the order of the arcs.
pub(super) fn crowns(arcs: &mut [RingArc]) -> Vec<Vec<RingArc>> {
    arcs.sort_unstable();
    let mut tour = Tour::new(arcs);
    let mut out = Vec::new();
    for node in 0..tour.nodes.len() {
        // Open crowns must begin at a node with a surplus of outgoing arcs, or they would be cut in two.
        while tour.surplus(node) > 0 {
            out.push(tour.walk(node));
        }
    }
    for node in 0..tour.nodes.len() {
        while tour.next[node] < tour.end(node) {
            let ring = tour.walk(node);
            tour.splice(&mut out, ring);
        }
    }
    out
}

/// Arcs grouped by the node that they leave, some of them already visited.
struct Tour<'a> {
    arcs: &'a [RingArc],
    /// Nodes in ascending order, each with the index of its first outgoing arc.
    nodes: Vec<(u32, usize)>,
    /// For each node, the next outgoing arc to visit.
    next: Vec<usize>,
    /// For each node, the number of incoming arcs not yet visited.
    entering: Vec<usize>,
}

impl<'a> Tour<'a> {
    fn new(arcs: &'a [RingArc]) -> Self {
        let mut node_ids: Vec<u32> = arcs.iter().flat_map(|arc| [arc.from, arc.to]).collect();
        node_ids.sort_unstable();
        node_ids.dedup();
        let first = |id: u32| arcs.partition_point(|arc| arc.from < id);
        let nodes: Vec<(u32, usize)> = node_ids.iter().map(|&id| (id, first(id))).collect();
        let next = nodes.iter().map(|node| node.1).collect();
        let mut tour = Self { arcs, entering: vec![0; nodes.len()], nodes, next };
        for arc in arcs {
            let node = tour.node_of(arc.to);
            tour.entering[node] += 1;
        }
        tour
    }

    fn node_of(&self, id: u32) -> usize {
        self.nodes.partition_point(|node| node.0 < id)
    }

    fn end(&self, node: usize) -> usize {
        self.nodes.get(node + 1).map_or(self.arcs.len(), |node| node.1)
    }

    /// Number of unvisited arcs that leave a node in excess of those that enter it.
    fn surplus(&self, node: usize) -> usize {
        (self.end(node) - self.next[node]).saturating_sub(self.entering[node])
    }

    /// Follows unvisited arcs from a node until there is none left to follow.
    fn walk(&mut self, mut node: usize) -> Vec<RingArc> {
        let mut out = Vec::new();
        while self.next[node] < self.end(node) {
            let arc = self.arcs[self.next[node]];
            self.next[node] += 1;
            node = self.node_of(arc.to);
            self.entering[node] -= 1;
            out.push(arc);
        }
        out
    }

    /// Inserts a closed run into a crown that passes one of its nodes, or adds it as a crown if there is
    /// none.
    fn splice(&self, crowns: &mut Vec<Vec<RingArc>>, ring: Vec<RingArc>) {
        for crown in crowns.iter_mut() {
            // Any shared node will do, so the first one found is used.
            let shared = crown
                .iter()
                .enumerate()
                .find_map(|(at, arc)| ring.iter().position(|r| r.from == arc.from).map(|turn| (at, turn)));
            if let Some((at, turn)) = shared {
                let turned = ring[turn..].iter().chain(&ring[..turn]).copied();
                crown.splice(at..at, turned);
                return;
            }
        }
        crowns.push(ring);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(arcs: &[[u32; 2]]) -> Vec<Vec<u32>> {
        let mut arcs: Vec<RingArc> =
            arcs.iter().map(|&[from, to]| RingArc { from, to, creator: 0 }).collect();
        let count = arcs.len();
        let crowns = crowns(&mut arcs);
        assert_eq!(crowns.iter().map(Vec::len).sum::<usize>(), count, "each arc once");
        for crown in &crowns {
            assert!(crown.windows(2).all(|w| w[0].to == w[1].from), "{crown:?}");
        }
        crowns.iter().map(|c| c.iter().map(|a| a.from).chain(c.last().map(|a| a.to)).collect()).collect()
    }

    #[test]
    fn a_ring_and_an_open_run_are_one_crown() {
        assert_eq!(cut(&[[3, 1], [1, 2], [2, 3]]), [[1, 2, 3, 1]]);
        assert_eq!(cut(&[[7, 5], [5, 6], [9, 7]]), [[9, 7, 5, 6]]);
        assert!(cut(&[]).is_empty());
    }

    #[test]
    fn a_bow_tie_is_two_crowns() {
        assert_eq!(cut(&[[1, 2], [2, 3], [5, 6]]), [vec![1, 2, 3], vec![5, 6]]);
    }

    #[test]
    fn runs_that_meet_in_a_node_share_a_crown() {
        // A ring that touches an open run, and three triangles on an edge.
        assert_eq!(cut(&[[1, 2], [2, 3], [2, 8], [8, 9], [9, 2]]).len(), 1);
        assert_eq!(cut(&[[1, 2], [2, 3], [2, 4]]).len(), 2);
        // Two rings that touch, and the same triangle twice.
        assert_eq!(cut(&[[1, 2], [2, 3], [3, 1], [1, 5], [5, 6], [6, 1]]).len(), 1);
        assert_eq!(cut(&[[1, 2], [1, 2]]).len(), 2);
    }
}
