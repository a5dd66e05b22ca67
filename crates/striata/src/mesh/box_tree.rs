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

struct BoxNode {
    bounds: AxisBox,
    /// Boxes below this node, as a range of the tree's `order`.
    first: u32,
    count: u32,
    /// Index of the first child, which the second one follows; 0 if the node has not been split.
    children: u32,
}

/// A tree over boxes, which are identified by index and not stored.
#[derive(Default)]
pub(crate) struct BoxTree {
    nodes: Vec<BoxNode>,
    order: Vec<u32>,
    /// Scratch: nodes that are still to be visited, the last one first.
    open: Vec<(f32, usize)>,
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
        let of = |member: u32| boxes[member as usize];
        let mut tree = Self::unsplit(boxes.len(), of);
        tree.nodes.reserve(boxes.len());
        let mut node = 0;
        while node < tree.nodes.len() {
            tree.split(node, of);
            node += 1;
        }
        tree
    }

    /// Returns a tree of `count` boxes that is split where [`Self::visit_near_and_split`] searches.
    pub(crate) fn unsplit(count: usize, boxes: impl Fn(u32) -> AxisBox) -> Self {
        let mut tree = Self { nodes: Vec::new(), order: (0..count as u32).collect(), open: Vec::new() };
        if count > 0 {
            let bounds = tree.order.iter().map(|&member| boxes(member)).fold(AxisBox::EMPTY, AxisBox::union);
            tree.nodes.push(BoxNode { bounds, first: 0, count: count as u32, children: 0 });
        }
        tree
    }

    /// Splits a node that is too large for a leaf, unless it has been split.
    fn split(&mut self, node: usize, boxes: impl Fn(u32) -> AxisBox) {
        let BoxNode { first, count, children, .. } = self.nodes[node];
        if count as usize <= LEAF_SIZE || children != 0 {
            return;
        }
        let mut entries: Vec<(AxisBox, u32)> = Vec::with_capacity(count as usize);
        let order = &mut self.order[first as usize..(first + count) as usize];
        entries.extend(order.iter().map(|&member| (boxes(member), member)));
        // Twice the center, which gives the same order.
        let center = |entry: &(AxisBox, u32)| entry.0.min + entry.0.max;
        let centers =
            |start: Vec3A, pick: fn(Vec3A, Vec3A) -> Vec3A| entries.iter().map(center).fold(start, pick);
        let extent = centers(Vec3A::NEG_INFINITY, Vec3A::max) - centers(Vec3A::INFINITY, Vec3A::min);
        let axis = extent.max_position();
        let half = count as usize / 2;
        entries.select_nth_unstable_by(half, |a, b| {
            center(a)[axis].total_cmp(&center(b)[axis]).then(a.1.cmp(&b.1))
        });
        order.iter_mut().zip(&entries).for_each(|(member, entry)| *member = entry.1);
        self.nodes[node].children = self.nodes.len() as u32;
        let (low, high) = entries.split_at(half);
        for (first, entries) in [(first, low), (first + half as u32, high)] {
            let bounds = entries.iter().map(|entry| entry.0).fold(AxisBox::EMPTY, AxisBox::union);
            self.nodes.push(BoxNode { bounds, first, count: entries.len() as u32, children: 0 });
        }
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
        let first = self.nodes[node].children as usize;
        [first, first + 1]
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
        if let Some(members) = self.leaf(node) {
            members.iter().for_each(|&member| *limit = visit(member as usize));
            return;
        }
        for (cost, child) in self.nearer_first(node, point) {
            if cost < *limit {
                self.descend(child, point, limit, visit);
            }
        }
    }

    /// Visits boxes like [`Self::visit_near`] in a tree made by [`Self::unsplit`], given the same boxes.
    pub(crate) fn visit_near_and_split(
        &mut self,
        boxes: &impl Fn(u32) -> AxisBox,
        point: Vec3A,
        limit: f32,
        mut visit: impl FnMut(usize) -> f32,
    ) {
        let mut limit = limit;
        let mut open = std::mem::take(&mut self.open);
        if !self.nodes.is_empty() {
            open.push((f32::NEG_INFINITY, 0));
        }
        while let Some((cost, node)) = open.pop() {
            if let Some(members) = self.leaf(node) {
                if cost < limit {
                    members.iter().for_each(|&member| limit = visit(member as usize));
                }
            } else if cost < limit {
                self.split(node, boxes);
                let [near, far] = self.nearer_first(node, point);
                open.extend([far, near]);
            }
        }
        self.open = open;
    }

    /// The members of a leaf.
    #[inline]
    fn leaf(&self, node: usize) -> Option<&[u32]> {
        let BoxNode { first, count, .. } = self.nodes[node];
        (count as usize <= LEAF_SIZE).then(|| &self.order[first as usize..(first + count) as usize])
    }

    /// The children of an inner node with their squared distances from a point.
    #[inline]
    fn nearer_first(&self, node: usize, point: Vec3A) -> [(f32, usize); 2] {
        let mut costs =
            self.children(node).map(|child| (self.nodes[child].bounds.squared_distance(point), child));
        if costs[1].0 < costs[0].0 {
            costs.swap(0, 1);
        }
        costs
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
    fn a_tree_split_on_demand_visits_the_same_boxes_in_the_same_order() {
        let at = |i: u32| Vec3A::new((i * 37 % 101) as f32, (i * 53 % 89) as f32, (i * 7 % 13) as f32);
        let of = |i: u32| AxisBox { min: at(i), max: at(i) + 1.5 };
        let boxes: Vec<AxisBox> = (0..500).map(of).collect();
        let (whole, mut part) = (BoxTree::new(&boxes), BoxTree::unsplit(boxes.len(), of));
        for i in 0..40 {
            let (point, limit) = (at(i * 11) + 0.25, (i * i) as f32);
            let [mut expected, mut found] = [Vec::new(), Vec::new()];
            let shrink = |seen: &mut Vec<usize>, member: usize| {
                seen.push(member);
                limit / seen.len() as f32
            };
            whole.visit_near(point, limit, |member| shrink(&mut expected, member));
            part.visit_near_and_split(&of, point, limit, |member| shrink(&mut found, member));
            assert_eq!(found, expected);
            assert!(i > 0 || part.nodes.len() < whole.nodes.len() / 4, "most of the tree is not needed yet");
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
