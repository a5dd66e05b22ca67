//! A balanced tree of boxes, for finding the few that are near a point.
//!
//! Each box is split at the median of its members' middles along the longest side, so the depth is logarithmic for any input,
//! equal boxes included, where trees that follow a cost degenerate into chains.

use glam::Vec3A;

/// Members of a leaf, at most.
const LEAF_SIZE: usize = 4;

/// A box that is aligned with the axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisBox {
    pub(crate) min: Vec3A,
    pub(crate) max: Vec3A,
}

/// A node and all below it: those follow it in the list of nodes, up to `end`.
struct Node {
    bounds: AxisBox,
    /// The members below it, as a range of the tree's order.
    first: u32,
    count: u32,
    /// The node after the last one below it; the second child of an inner node begins where that of its first child ends.
    end: u32,
}

/// A tree over boxes that it does not keep.
#[derive(Default)]
pub(crate) struct BoxTree {
    nodes: Vec<Node>,
    order: Vec<u32>,
}

impl AxisBox {
    const NOTHING: Self = Self { min: Vec3A::INFINITY, max: Vec3A::NEG_INFINITY };

    fn with(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Squared distance of a point to the box.
    #[inline]
    fn squared_distance(&self, point: Vec3A) -> f32 {
        (self.min - point).max(point - self.max).max(Vec3A::ZERO).length_squared()
    }
}

impl BoxTree {
    /// Builds the tree in O(n log n) time; there may be no boxes.
    pub(crate) fn new(boxes: &[AxisBox]) -> Self {
        let mut tree = Self { nodes: Vec::new(), order: (0..boxes.len() as u32).collect() };
        if !boxes.is_empty() {
            tree.nodes.reserve(boxes.len());
            let mut order = std::mem::take(&mut tree.order);
            tree.split(boxes, &mut order, 0);
            tree.order = order;
        }
        tree
    }

    /// Adds the node of some boxes, which begin at `first` of the order, and all below it.
    fn split(&mut self, boxes: &[AxisBox], order: &mut [u32], first: usize) {
        let of = |&member: &u32| boxes[member as usize];
        let middle = |member: &u32| of(member).min + of(member).max;
        let bounds = order.iter().map(of).fold(AxisBox::NOTHING, AxisBox::with);
        let (node, count) = (self.nodes.len(), order.len());
        self.nodes.push(Node { bounds, first: first as u32, count: count as u32, end: 0 });
        if count > LEAF_SIZE {
            let middles =
                |start: Vec3A, pick: fn(Vec3A, Vec3A) -> Vec3A| order.iter().map(middle).fold(start, pick);
            let extent = middles(Vec3A::NEG_INFINITY, Vec3A::max) - middles(Vec3A::INFINITY, Vec3A::min);
            let axis = extent.max_position();
            let half = count / 2;
            order.select_nth_unstable_by(half, |a, b| {
                middle(a)[axis].total_cmp(&middle(b)[axis]).then(a.cmp(b))
            });
            let (low, high) = order.split_at_mut(half);
            self.split(boxes, low, first);
            self.split(boxes, high, first + half);
        }
        self.nodes[node].end = self.nodes.len() as u32;
    }

    /// Hands over the members of boxes that are nearer to a point than a limit, in f32 and squared, near ones first. `visit`
    /// returns the limit from then on, which may fall.
    #[inline]
    pub(crate) fn visit_near(&self, point: Vec3A, limit: f32, mut visit: impl FnMut(usize) -> f32) {
        if !self.nodes.is_empty() {
            let mut limit = limit;
            self.descend(0, point, &mut limit, &mut visit);
        }
    }

    fn descend(&self, node: usize, point: Vec3A, limit: &mut f32, visit: &mut impl FnMut(usize) -> f32) {
        let Node { first, count, .. } = self.nodes[node];
        if count as usize <= LEAF_SIZE {
            for &member in &self.order[first as usize..(first + count) as usize] {
                *limit = visit(member as usize);
            }
            return;
        }
        let children = [node + 1, self.nodes[node + 1].end as usize];
        let mut costs = children.map(|child| (self.nodes[child].bounds.squared_distance(point), child));
        if costs[1].0 < costs[0].0 {
            costs.swap(0, 1);
        }
        for (cost, child) in costs {
            if cost < *limit {
                self.descend(child, point, limit, visit);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_boxes_make_a_shallow_tree_that_reaches_all() {
        for count in [0, 1, 4, 5, 9, 1000] {
            for spread in [0.0, 1.0] {
                let boxes: Vec<AxisBox> = (0..count)
                    .map(|i| {
                        let min = Vec3A::splat(spread * i as f32);
                        AxisBox { min, max: min + 0.5 }
                    })
                    .collect();
                let tree = BoxTree::new(&boxes);
                let mut seen = Vec::new();
                tree.visit_near(Vec3A::ZERO, f32::INFINITY, |member| {
                    seen.push(member);
                    f32::INFINITY
                });
                seen.sort_unstable();
                assert_eq!(seen, (0..count).collect::<Vec<_>>());
                assert!(tree.nodes.len() <= count.max(1), "{} nodes for {count} boxes", tree.nodes.len());
            }
        }
    }
}
