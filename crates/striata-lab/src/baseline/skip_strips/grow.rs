//! Growing the nodes of one strip: its vertices, and what they collapse to as long as the strip is drawn.
//!
//! The vertices of a strip collapse from the highest number down, as in the sequence. Each finds its target among the
//! nodes or adds it; where the last triangle goes, growing ends. Time `n log n` for a strip of `n` nodes and places.

use std::collections::BinaryHeap;

use striata::mesh::CollapseSequence;

use super::place_groups::PlaceGroups;
use super::{NO_NODE, SkipStrip};

/// Grows one strip after another; see the [module](self).
pub(super) struct StripGrower<'s> {
    sequence: &'s CollapseSequence,
    /// The node of each vertex in this strip, by order of making; `NO_NODE` for most.
    node_of: Vec<u32>,
    nodes: Vec<GrowingNode>,
    /// Vertices that have not collapsed yet, each with its node.
    standing: BinaryHeap<(u32, u32)>,
    groups: PlaceGroups,
    /// Nodes from the highest vertex down.
    order: Vec<u32>,
    rank_of: Vec<u32>,
    places: Vec<u32>,
    /// Steps that change what the strip shows, from the last one down.
    pub(super) steps: Vec<u32>,
}

struct GrowingNode {
    vertex: u32,
    parent: u32,
    /// The places that show this vertex when it collapses.
    group: u32,
}

/// The flat arrays that hold the nodes of all strips.
#[derive(Default)]
pub(super) struct NodeArrays {
    pub(super) places: Vec<u32>,
    pub(super) node_vertices: Vec<u32>,
    pub(super) node_parents: Vec<u32>,
}

impl<'s> StripGrower<'s> {
    pub(super) fn new(sequence: &'s CollapseSequence) -> Self {
        Self {
            sequence,
            node_of: vec![NO_NODE; sequence.positions().vertex_count()],
            nodes: Vec::new(),
            standing: BinaryHeap::new(),
            groups: PlaceGroups::default(),
            order: Vec::new(),
            rank_of: Vec::new(),
            places: Vec::new(),
            steps: Vec::new(),
        }
    }

    /// Grows a strip and appends its nodes; [`steps`](Self::steps) then says which steps change it.
    pub(super) fn grow(&mut self, strip: &[u32], arrays: &mut NodeArrays) -> SkipStrip {
        self.begin(strip);
        let drawn_from = self.collapse_all();
        let entry = SkipStrip {
            first_place: arrays.places.len() as u32,
            first_node: arrays.node_vertices.len() as u32,
            drawn_from,
        };
        self.append_to(arrays);
        entry
    }

    fn begin(&mut self, strip: &[u32]) {
        self.nodes.clear();
        self.places.clear();
        self.standing.clear();
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
            self.places.push(node);
        }
        self.groups.begin(&self.places, self.nodes.len());
    }

    fn add(&mut self, vertex: u32, group: u32) -> u32 {
        let node = self.nodes.len() as u32;
        self.nodes.push(GrowingNode { vertex, parent: NO_NODE, group });
        self.node_of[vertex as usize] = node;
        self.standing.push((vertex, node));
        node
    }

    /// Collapses the strip's vertices; returns the coarsest level that draws it.
    fn collapse_all(&mut self) -> u32 {
        let base_position_count = self.sequence.base_position_count() as u32;
        let base_vertex_count = self.sequence.base_vertex_count() as u32;
        let mut drawn_from =
            if self.groups.has_triangles() { 0 } else { self.sequence.step_count() as u32 + 1 };
        while let Some((vertex, node)) = self.standing.pop() {
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
        let GrowingNode { vertex, group, .. } = self.nodes[node as usize];
        let target = self.sequence.target(vertex);
        let parent = match self.node_of[target as usize] {
            NO_NODE => self.add(target, group),
            parent => {
                let united = self.groups.unite(group, self.nodes[parent as usize].group);
                self.nodes[parent as usize].group = united;
                parent
            }
        };
        self.nodes[node as usize].parent = parent;
    }

    /// Appends the nodes by rising vertex, so that a parent stands before its children.
    fn append_to(&mut self, arrays: &mut NodeArrays) {
        self.rank_of.clear();
        self.rank_of.resize(self.nodes.len(), NO_NODE);
        for (rank, &node) in (0..).zip(self.order.iter().rev()) {
            self.rank_of[node as usize] = rank;
        }
        for &node in self.order.iter().rev() {
            let GrowingNode { vertex, parent, .. } = self.nodes[node as usize];
            arrays.node_vertices.push(vertex);
            arrays.node_parents.push(self.rank_of.get(parent as usize).copied().unwrap_or(NO_NODE));
            self.node_of[vertex as usize] = NO_NODE;
        }
        arrays.places.extend(self.places.iter().map(|&node| self.rank_of[node as usize]));
    }
}
