//! Builds the nodes of one strip: its vertices, and those that they collapse to while the strip is drawn.
//!
//! The vertices of a strip collapse in descending order, as in the sequence. Each finds its target among
//! the nodes or adds it; building stops when the last triangle vanishes. Takes `n log n` time for a strip
//! with `n` nodes and slots.

use std::collections::BinaryHeap;

use striata::mesh::CollapseSequence;

use super::slot_groups::SlotGroups;
use super::{NO_NODE, SkipStrip};

/// Builds the nodes of one strip after another; see the [module](self).
pub(super) struct NodeBuilder<'s> {
    sequence: &'s CollapseSequence,
    /// The node of each vertex in this strip, in order of creation; `NO_NODE` for most.
    node_of: Vec<u32>,
    nodes: Vec<PartialNode>,
    /// Vertices that have not collapsed yet, with their nodes.
    active: BinaryHeap<(u32, u32)>,
    groups: SlotGroups,
    /// Nodes by descending vertex.
    order: Vec<u32>,
    rank_of: Vec<u32>,
    slots: Vec<u32>,
    /// Steps that change what the strip shows, last one first.
    pub steps: Vec<u32>,
}

struct PartialNode {
    vertex: u32,
    parent: u32,
    /// The slots that show this vertex when it collapses.
    group: u32,
}

/// Flat arrays of the nodes of all strips.
#[derive(Default)]
pub(super) struct NodeArrays {
    pub slots: Vec<u32>,
    pub node_vertices: Vec<u32>,
    pub node_parents: Vec<u32>,
}

impl<'s> NodeBuilder<'s> {
    pub(super) fn new(sequence: &'s CollapseSequence) -> Self {
        Self {
            sequence,
            node_of: vec![NO_NODE; sequence.positions().vertex_count()],
            nodes: Vec::new(),
            active: BinaryHeap::new(),
            groups: SlotGroups::default(),
            order: Vec::new(),
            rank_of: Vec::new(),
            slots: Vec::new(),
            steps: Vec::new(),
        }
    }

    /// Builds a strip's nodes and appends them to the arrays; [`steps`](Self::steps) then lists the steps
    /// that change it.
    pub(super) fn build(&mut self, strip: &[u32], arrays: &mut NodeArrays) -> SkipStrip {
        self.begin(strip);
        let drawn_from = self.collapse_all();
        let entry = SkipStrip {
            first_slot: arrays.slots.len() as u32,
            first_node: arrays.node_vertices.len() as u32,
            drawn_from,
        };
        self.append_to(arrays);
        entry
    }

    fn begin(&mut self, strip: &[u32]) {
        self.nodes.clear();
        self.slots.clear();
        self.active.clear();
        self.order.clear();
        self.steps.clear();
        for &vertex in strip {
            let node = match self.node_of[vertex as usize] {
                NO_NODE => {
                    let group = self.nodes.len() as u32;
                    self.add(vertex, group)
                }
                node => node,
            };
            self.slots.push(node);
        }
        self.groups.begin(&self.slots, self.nodes.len());
    }

    fn add(&mut self, vertex: u32, group: u32) -> u32 {
        let node = self.nodes.len() as u32;
        self.nodes.push(PartialNode { vertex, parent: NO_NODE, group });
        self.node_of[vertex as usize] = node;
        self.active.push((vertex, node));
        node
    }

    /// Collapses the strip's vertices and returns the coarsest level at which it is drawn.
    fn collapse_all(&mut self) -> u32 {
        let base_position_count = self.sequence.base_position_count() as u32;
        let base_vertex_count = self.sequence.base_vertex_count() as u32;
        let mut drawn_from =
            if self.groups.has_triangles() { 0 } else { self.sequence.step_count() as u32 + 1 };
        while let Some((vertex, node)) = self.active.pop() {
            self.order.push(node);
            if vertex < base_vertex_count || !self.groups.has_triangles() {
                continue;
            }
            let step = self.sequence.positions().position_of(vertex) - base_position_count;
            if self.steps.last() != Some(&step) {
                self.steps.push(step);
            }
            self.collapse(node);
            if !self.groups.has_triangles() {
                drawn_from = step + 1;
            }
        }
        drawn_from
    }

    fn collapse(&mut self, node: u32) {
        let PartialNode { vertex, group, .. } = self.nodes[node as usize];
        let target = self.sequence.target(vertex);
        let parent = match self.node_of[target as usize] {
            NO_NODE => self.add(target, group),
            parent => {
                let merged = self.groups.merge(group, self.nodes[parent as usize].group);
                self.nodes[parent as usize].group = merged;
                parent
            }
        };
        self.nodes[node as usize].parent = parent;
    }

    /// Appends the nodes by ascending vertex, so that a parent precedes its children.
    fn append_to(&mut self, arrays: &mut NodeArrays) {
        self.rank_of.clear();
        self.rank_of.resize(self.nodes.len(), NO_NODE);
        for (rank, &node) in (0..).zip(self.order.iter().rev()) {
            self.rank_of[node as usize] = rank;
        }
        for &node in self.order.iter().rev() {
            let PartialNode { vertex, parent, .. } = self.nodes[node as usize];
            arrays.node_vertices.push(vertex);
            arrays.node_parents.push(self.rank_of.get(parent as usize).copied().unwrap_or(NO_NODE));
            self.node_of[vertex as usize] = NO_NODE;
        }
        arrays.slots.extend(self.slots.iter().map(|&node| self.rank_of[node as usize]));
    }
}
