//! A balanced tree of bounding boxes, for finding the boxes near a point.
//!
//! Each node is split along its longest axis at the median of the box centers. The depth is therefore
//! logarithmic for any input, even if all boxes are equal, in which case trees built by a cost heuristic
//! degenerate into chains.

use glam::Vec3A;

/// Largest number of boxes in a leaf.
const LEAF_SIZE: usize = 4;

/// An axis-aligned box.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AxisBox {
    pub min: Vec3A,
    pub max: Vec3A,
}

/// A node; its descendants follow it in the list of nodes, up to `end`.
struct BoxNode {
    bounds: AxisBox,
    /// Boxes below this node, as a range of the tree's `order`.
    first: u32,
    count: u32,
    /// Index after the last descendant. The second child of an inner node starts at the `end` of its first
    /// child.
    end: u32,
}

/// A tree over boxes, which are identified by index and not stored.
#[derive(Default)]
pub(crate) struct BoxTree {
    nodes: Vec<BoxNode>,
    order: Vec<u32>,
}

impl AxisBox {
    const EMPTY: Self = Self { min: Vec3A::INFINITY, max: Vec3A::NEG_INFINITY };

    fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Squared distance between a point and the box.
    #[inline]
    fn squared_distance(&self, point: Vec3A) -> f32 {
        (self.min - point).max(point - self.max).max(Vec3A::ZERO).length_squared()
    }
}

impl BoxTree {
    /// Builds the tree in O(n log n) time; `boxes` may be empty.
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

    /// Appends the node for the boxes in `order`, which start at position `first` of the tree's order, and
    /// all its descendants.
    fn split(&mut self, boxes: &[AxisBox], order: &mut [u32], first: usize) {
        let of = |&member: &u32| boxes[member as usize];
        // Twice the center, which gives the same order.
        let center = |member: &u32| of(member).min + of(member).max;
        let bounds = order.iter().map(of).fold(AxisBox::EMPTY, AxisBox::union);
        let (node, count) = (self.nodes.len(), order.len());
        self.nodes.push(BoxNode { bounds, first: first as u32, count: count as u32, end: 0 });
        if count > LEAF_SIZE {
            let centers =
                |start: Vec3A, pick: fn(Vec3A, Vec3A) -> Vec3A| order.iter().map(center).fold(start, pick);
            let extent = centers(Vec3A::NEG_INFINITY, Vec3A::max) - centers(Vec3A::INFINITY, Vec3A::min);
            let axis = extent.max_position();
            let half = count / 2;
            order.select_nth_unstable_by(half, |a, b| {
                center(a)[axis].total_cmp(&center(b)[axis]).then(a.cmp(b))
            });
            let (low, high) = order.split_at_mut(half);
            self.split(boxes, low, first);
            self.split(boxes, high, first + half);
        }
        self.nodes[node].end = self.nodes.len() as u32;
    }

    /// Follows boxes that have moved: the nodes keep their members and get new bounds, in O(n) time.
    pub(crate) fn refit(&mut self, boxes: &[AxisBox]) {
        for node in (0..self.nodes.len()).rev() {
            let BoxNode { first, count, .. } = self.nodes[node];
            self.nodes[node].bounds = if count as usize <= LEAF_SIZE {
                let members = &self.order[first as usize..(first + count) as usize];
                members.iter().map(|&member| boxes[member as usize]).fold(AxisBox::EMPTY, AxisBox::union)
            } else {
                let [low, high] = self.children(node).map(|child| self.nodes[child].bounds);
                low.union(high)
            };
        }
    }

    /// The children of an inner node.
    #[inline]
    fn children(&self, node: usize) -> [usize; 2] {
        [node + 1, self.nodes[node + 1].end as usize]
    }

    /// Visits the boxes nearer to a point than a limit, a squared distance in f32, roughly from near to
    /// far. `visit` returns the limit for the rest of the search, which may shrink.
    #[inline]
    pub(crate) fn visit_near(&self, point: Vec3A, limit: f32, mut visit: impl FnMut(usize) -> f32) {
        if !self.nodes.is_empty() {
            let mut limit = limit;
            self.descend(0, point, &mut limit, &mut visit);
        }
    }

    fn descend(&self, node: usize, point: Vec3A, limit: &mut f32, visit: &mut impl FnMut(usize) -> f32) {
        let BoxNode { first, count, .. } = self.nodes[node];
        if count as usize <= LEAF_SIZE {
            for &member in &self.order[first as usize..(first + count) as usize] {
                *limit = visit(member as usize);
            }
            return;
        }
        let mut costs =
            self.children(node).map(|child| (self.nodes[child].bounds.squared_distance(point), child));
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

    fn boxes_along_a_line(count: usize, spread: f32) -> Vec<AxisBox> {
        let at = |i| Vec3A::splat(spread * i as f32);
        (0..count).map(|i| AxisBox { min: at(i), max: at(i) + 0.5 }).collect()
    }

    #[test]
    fn moved_boxes_are_found_where_they_are() {
        let mut tree = BoxTree::new(&boxes_along_a_line(100, 1.0));
        tree.refit(&boxes_along_a_line(100, -2.0));
        for i in 0..100 {
            let mut seen = Vec::new();
            tree.visit_near(Vec3A::splat(-2.0 * i as f32), f32::MIN_POSITIVE, |member| {
                seen.push(member);
                f32::MIN_POSITIVE
            });
            assert!(seen.contains(&i) && seen.len() <= LEAF_SIZE, "{i}: {seen:?}");
        }
    }

    #[test]
    fn a_search_without_limit_visits_every_box_once() {
        for count in [0, 1, 4, 5, 9, 1000] {
            for spread in [0.0, 1.0] {
                let tree = BoxTree::new(&boxes_along_a_line(count, spread));
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
