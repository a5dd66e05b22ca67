//! A balanced tree of bounding boxes, for finding the boxes near a point.
//!
//! A node has up to four children, whose boxes are compared with a point at once. It is split at medians of the box
//! centers, each time along the longest axis. The depth is therefore logarithmic for any input, even if all boxes
//! are equal, in which case trees built by a cost heuristic degenerate into chains.

use glam::Vec3A;
use wide::{f32x4, f32x8};

use super::axis_box::AxisBox;
use super::lanes::lane_max;
use super::point_packet::PointPacket;

/// Largest number of children of a node.
const WIDTH: usize = 4;
/// Bit of a child that is a box instead of a node.
const IS_MEMBER: u32 = 1 << 31;
/// A child that does not exist; the first child of a node that has not been split.
const NONE: u32 = u32::MAX;
/// More nodes than are ever left to visit: three for each level of a tree of 2^31 boxes.
const MAX_OPEN: usize = 64;

/// The boxes of a node's children by axis and child, and the children: nodes, or members.
struct BoxNode {
    min: [[f32; WIDTH]; 3],
    max: [[f32; WIDTH]; 3],
    children: [u32; WIDTH],
}

/// A box of the tree that has no place yet.
#[derive(Clone, Copy)]
struct BoxEntry {
    center: [f32; 3],
    member: u32,
}

/// A tree over boxes, which are identified by index and not stored.
#[derive(Default)]
pub(crate) struct BoxTree {
    nodes: Vec<BoxNode>,
    /// The boxes of each node that has not been split, as a range of `entries`; empty if all have been.
    ranges: Vec<[u32; 2]>,
    entries: Vec<BoxEntry>,
}

impl BoxNode {
    const UNSPLIT: Self = Self {
        min: [[f32::INFINITY; WIDTH]; 3],
        max: [[f32::NEG_INFINITY; WIDTH]; 3],
        children: [NONE; WIDTH],
    };

    fn is_split(&self) -> bool {
        self.children[0] != NONE
    }

    fn set_bounds(&mut self, child: usize, bounds: AxisBox) {
        let (min, max) = (bounds.min.to_array(), bounds.max.to_array());
        for axis in 0..3 {
            (self.min[axis][child], self.max[axis][child]) = (min[axis], max[axis]);
        }
    }

    /// The box around all children.
    fn bounds(&self) -> AxisBox {
        let least = |lanes: [f32; WIDTH]| lanes.into_iter().fold(f32::INFINITY, f32::min);
        let greatest = |lanes: [f32; WIDTH]| lanes.into_iter().fold(f32::NEG_INFINITY, f32::max);
        AxisBox {
            min: Vec3A::from_array(self.min.map(least)),
            max: Vec3A::from_array(self.max.map(greatest)),
        }
    }

    /// Squared distances between a box and those of the children; infinite for those that do not exist.
    #[inline]
    fn squared_distances(&self, from: AxisBox) -> [f32; WIDTH] {
        let along = |axis: usize| {
            let (from_min, from_max) = (f32x4::splat(from.min[axis]), f32x4::splat(from.max[axis]));
            let (min, max) = (f32x4::new(self.min[axis]), f32x4::new(self.max[axis]));
            let away = (min - from_max).fast_max(from_min - max).fast_max(f32x4::ZERO);
            away * away
        };
        (along(0) + along(1) + along(2)).to_array()
    }

    /// The children nearer to a point than a limit.
    #[inline]
    fn near_children(&self, point: Vec3A, limit: f32) -> NearChildren {
        let mut near = NearChildren::NONE;
        for (cost, child) in
            self.squared_distances(AxisBox { min: point, max: point }).into_iter().zip(self.children)
        {
            if cost < limit {
                near.insert(cost, child);
            }
        }
        near
    }

    /// The children nearer to some point of a packet than its limit.
    #[inline]
    fn near_children_of_any(&self, points: PointPacket, limits: PacketLimit) -> NearChildren {
        let mut near = NearChildren::NONE;
        let costs = self.squared_distances(points.bounds);
        for (lane, child) in
            self.children.into_iter().enumerate().filter(|&(lane, _)| limits.exceeds(costs[lane]))
        {
            let corner = |of: &[[f32; WIDTH]; 3]| Vec3A::new(of[0][lane], of[1][lane], of[2][lane]);
            let bounds = AxisBox { min: corner(&self.min), max: corner(&self.max) };
            let costs = points.squared_distances_from_box(bounds);
            let is_near = costs.simd_lt(limits.each);
            if is_near.any() {
                near.insert(-lane_max(is_near.bitselect(-costs, f32x8::splat(f32::NEG_INFINITY))), child);
            }
        }
        near
    }
}

/// Children of a node with their squared distances; near ones first, and in their order if several are equally near.
struct NearChildren {
    children: [(f32, u32); WIDTH],
    count: usize,
}

impl NearChildren {
    const NONE: Self = Self { children: [(0.0, NONE); WIDTH], count: 0 };

    #[inline]
    fn insert(&mut self, cost: f32, child: u32) {
        let mut at = self.count;
        while at > 0 && cost < self.children[at - 1].0 {
            self.children[at] = self.children[at - 1];
            at -= 1;
        }
        self.children[at] = (cost, child);
        self.count += 1;
    }
}

/// Distance within which boxes are visited.
trait SearchLimit: Copy {
    fn exceeds(self, cost: f32) -> bool;
}

impl SearchLimit for f32 {
    #[inline]
    fn exceeds(self, cost: f32) -> bool {
        cost < self
    }
}

/// A limit for each point of a packet, and the largest of them.
#[derive(Clone, Copy)]
struct PacketLimit {
    each: f32x8,
    largest: f32,
}

impl PacketLimit {
    #[inline]
    fn new(each: f32x8) -> Self {
        Self { each, largest: lane_max(each) }
    }
}

impl SearchLimit for PacketLimit {
    #[inline]
    fn exceeds(self, cost: f32) -> bool {
        cost < self.largest
    }
}

/// Divides entries at medians, each time along the longest axis, into groups of about the same size, which are returned.
fn divide(entries: &mut [BoxEntry], sizes: &mut [usize]) {
    let (count, low) = (sizes.len(), sizes.len() / 2);
    if count <= 1 {
        sizes.fill(entries.len());
        return;
    }
    let (mut min, mut max) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
    for entry in &*entries {
        let center = Vec3A::from_array(entry.center);
        (min, max) = (min.min(center), max.max(center));
    }
    let axis = (max - min).max_position();
    let middle = entries.len() * low / count;
    entries.select_nth_unstable_by(middle, |a, b| {
        a.center[axis].total_cmp(&b.center[axis]).then(a.member.cmp(&b.member))
    });
    let (lower, upper) = entries.split_at_mut(middle);
    let (lower_sizes, upper_sizes) = sizes.split_at_mut(low);
    divide(lower, lower_sizes);
    divide(upper, upper_sizes);
}

impl BoxTree {
    /// Builds the tree of `count` boxes, less than 2^31, in O(n log n) time.
    pub(crate) fn new(count: usize, boxes: impl Fn(u32) -> AxisBox) -> Self {
        let mut tree = Self::unsplit(count, &boxes);
        tree.nodes.reserve(count / 2);
        let mut open: Vec<u32> = (0..tree.nodes.len() as u32).collect();
        while let Some(node) = open.pop() {
            let first = tree.nodes.len() as u32;
            tree.divide_node(node);
            // The first child comes next, so that the nodes below it are near.
            open.extend((first..tree.nodes.len() as u32).rev());
        }
        (tree.entries, tree.ranges) = (Vec::new(), Vec::new());
        tree.refit(boxes);
        tree
    }

    /// Returns a tree of `count` boxes, less than 2^31, that is split where [`Self::visit_near_and_split`] searches.
    pub(crate) fn unsplit(count: usize, boxes: impl Fn(u32) -> AxisBox) -> Self {
        assert!(count < IS_MEMBER as usize, "too many boxes: {count}");
        let entry = |member| BoxEntry { center: boxes(member).doubled_center(), member };
        let entries = (0..count as u32).map(entry).collect();
        let (mut nodes, mut ranges) = (Vec::new(), Vec::new());
        if count > 0 {
            nodes.push(BoxNode::UNSPLIT);
            ranges.push([0, count as u32]);
        }
        Self { nodes, ranges, entries }
    }

    /// Gives a node its children, which get no boxes yet.
    fn divide_node(&mut self, node: u32) {
        let [first, end] = self.ranges[node as usize];
        let entries = &mut self.entries[first as usize..end as usize];
        let children = &mut self.nodes[node as usize].children;
        if entries.len() <= WIDTH {
            children.iter_mut().zip(entries).for_each(|(child, entry)| *child = IS_MEMBER | entry.member);
            return;
        }
        let mut sizes = [0; WIDTH];
        let group_count = entries.len().div_ceil(WIDTH).min(WIDTH);
        divide(entries, &mut sizes[..group_count]);
        let mut start = first;
        for (child, size) in children.iter_mut().zip(&sizes[..group_count]) {
            *child = self.ranges.len() as u32;
            let end = start + *size as u32;
            self.ranges.push([start, end]);
            start = end;
        }
        self.nodes.resize_with(self.ranges.len(), || BoxNode::UNSPLIT);
    }

    /// Splits a node unless it has been split.
    fn split(&mut self, node: u32, boxes: impl Fn(u32) -> AxisBox) {
        if self.nodes[node as usize].is_split() {
            return;
        }
        self.divide_node(node);
        for (child, at) in self.nodes[node as usize].children.into_iter().enumerate() {
            let bounds = match at {
                NONE => continue,
                member if member & IS_MEMBER != 0 => boxes(member & !IS_MEMBER),
                inner => {
                    let [first, end] = self.ranges[inner as usize];
                    let entries = &self.entries[first as usize..end as usize];
                    entries.iter().map(|entry| boxes(entry.member)).fold(AxisBox::EMPTY, AxisBox::union)
                }
            };
            self.nodes[node as usize].set_bounds(child, bounds);
        }
    }

    /// Follows boxes that have moved: the nodes keep their members and get new bounds, in O(n) time.
    pub(crate) fn refit(&mut self, boxes: impl Fn(u32) -> AxisBox) {
        // Children come after their parents.
        for node in (0..self.nodes.len()).rev() {
            for (child, at) in self.nodes[node].children.into_iter().enumerate() {
                let bounds = match at {
                    NONE => continue,
                    member if member & IS_MEMBER != 0 => boxes(member & !IS_MEMBER),
                    inner => self.nodes[inner as usize].bounds(),
                };
                self.nodes[node].set_bounds(child, bounds);
            }
        }
    }

    /// Visits the boxes nearer to a point than a limit, a squared distance in f32, roughly from near to
    /// far. `visit` returns the limit for the rest of the search, which may shrink.
    #[inline]
    pub(crate) fn visit_near(&self, point: Vec3A, limit: f32, visit: impl FnMut(usize) -> f32) {
        if !self.nodes.is_empty() {
            search(limit, visit, |node, limit| self.nodes[node as usize].near_children(point, limit));
        }
    }

    /// Visits boxes like [`Self::visit_near`] in a tree made by [`Self::unsplit`], given the same boxes.
    #[inline]
    pub(crate) fn visit_near_and_split(
        &mut self,
        boxes: &impl Fn(u32) -> AxisBox,
        point: Vec3A,
        limit: f32,
        visit: impl FnMut(usize) -> f32,
    ) {
        if !self.nodes.is_empty() {
            search(limit, visit, |node, limit| {
                self.split(node, boxes);
                self.nodes[node as usize].near_children(point, limit)
            });
        }
    }

    /// Visits the boxes nearer to some point of a packet than its limit; otherwise like [`Self::visit_near_and_split`].
    #[inline]
    pub(crate) fn visit_near_any_and_split(
        &mut self,
        boxes: &impl Fn(u32) -> AxisBox,
        points: PointPacket,
        limits: f32x8,
        mut visit: impl FnMut(usize) -> f32x8,
    ) {
        if !self.nodes.is_empty() {
            search(
                PacketLimit::new(limits),
                |member| PacketLimit::new(visit(member)),
                |node, limit| {
                    self.split(node, boxes);
                    self.nodes[node as usize].near_children_of_any(points, limit)
                },
            );
        }
    }
}

/// Visits the members below the first node that are nearer than a limit; `near_children` returns the children of a node.
#[inline]
fn search<L: SearchLimit>(
    mut limit: L,
    mut visit: impl FnMut(usize) -> L,
    mut near_children: impl FnMut(u32, L) -> NearChildren,
) {
    let mut open = [(0.0f32, 0u32); MAX_OPEN];
    let mut open_count = 1;
    while open_count > 0 {
        open_count -= 1;
        let (cost, node) = open[open_count];
        if !limit.exceeds(cost) {
            continue;
        }
        let near = near_children(node, limit);
        let near = &near.children[..near.count];
        // The children of a node are all members or all nodes.
        if near.first().is_some_and(|(_, child)| child & IS_MEMBER != 0) {
            for &(cost, member) in near {
                if limit.exceeds(cost) {
                    limit = visit((member & !IS_MEMBER) as usize);
                }
            }
        } else {
            for &child in near.iter().rev() {
                open[open_count] = child;
                open_count += 1;
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

    fn tree_of(boxes: &[AxisBox]) -> BoxTree {
        BoxTree::new(boxes.len(), |member| boxes[member as usize])
    }

    #[test]
    fn moved_boxes_are_found_where_they_are() {
        let mut tree = tree_of(&boxes_along_a_line(100, 1.0));
        let moved = boxes_along_a_line(100, -2.0);
        tree.refit(|member| moved[member as usize]);
        for i in 0..100 {
            let mut seen = Vec::new();
            tree.visit_near(Vec3A::splat(-2.0 * i as f32), f32::MIN_POSITIVE, |member| {
                seen.push(member);
                f32::MIN_POSITIVE
            });
            assert!(seen.contains(&i) && seen.len() == 1, "{i}: {seen:?}");
        }
    }

    #[test]
    fn a_tree_split_on_demand_visits_the_same_boxes_in_the_same_order() {
        let at = |i: u32| Vec3A::new((i * 37 % 101) as f32, (i * 53 % 89) as f32, (i * 7 % 13) as f32);
        let of = |i: u32| AxisBox { min: at(i), max: at(i) + 1.5 };
        let boxes: Vec<AxisBox> = (0..500).map(of).collect();
        let (whole, mut part) = (tree_of(&boxes), BoxTree::unsplit(boxes.len(), of));
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
        for count in [0, 1, 4, 5, 9, 16, 17, 1000] {
            for spread in [0.0, 1.0] {
                let tree = tree_of(&boxes_along_a_line(count, spread));
                let mut seen = Vec::new();
                tree.visit_near(Vec3A::ZERO, f32::INFINITY, |member| {
                    seen.push(member);
                    f32::INFINITY
                });
                seen.sort_unstable();
                assert_eq!(seen, (0..count).collect::<Vec<_>>());
                assert!(
                    tree.nodes.len() <= count.div_ceil(2),
                    "{} nodes for {count} boxes",
                    tree.nodes.len()
                );
            }
        }
    }
}
