//! Open edges of the region that has been coded so far.

use std::collections::{HashMap, VecDeque};

use crate::hash::IndexHash;

/// An open edge of a triangle that has been coded: the triangle beyond it has its ends in reverse order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gate {
    /// Nodes of the edge.
    pub(super) nodes: [u32; 2],
    /// Vertices at them, and at the third corner of the triangle.
    pub(super) vertices: [u32; 3],
    /// Group of the triangle.
    pub(super) group: u32,
}

/// Open edges at one node: the last two that end there and the last two that begin there.
#[derive(Clone, Copy, Default)]
struct Ends {
    ending: [u32; 2],
    beginning: [u32; 2],
}

/// The open edges.
#[derive(Default)]
pub(super) struct Border {
    gates: VecDeque<Gate>,
    /// Number of open gates of each directed edge.
    open: HashMap<(u32, u32), u32, IndexHash>,
    ends: Vec<Ends>,
    /// Vertex that was last seen at each node.
    last_vertex: Vec<u32>,
}

const NONE: u32 = u32::MAX;
const NO_ENDS: Ends = Ends { ending: [NONE; 2], beginning: [NONE; 2] };

impl Border {
    pub(super) fn new(node_count: usize) -> Self {
        Self { ends: vec![NO_ENDS; node_count], last_vertex: vec![NONE; node_count], ..Self::default() }
    }

    /// Adds a coded triangle. `attached` is whether its first edge belonged to a gate.
    pub(super) fn add(&mut self, nodes: [u32; 3], vertices: [u32; 3], group: u32, attached: bool) {
        for (&node, &v) in nodes.iter().zip(&vertices) {
            self.last_vertex[node as usize] = v;
        }
        for i in 0..3 {
            let (from, to) = (nodes[i], nodes[(i + 1) % 3]);
            // The other side of an open edge closes it.
            if let Some(count) = self.open.get_mut(&(to, from))
                && *count > 0
            {
                *count -= 1;
                forget(&mut self.ends[to as usize].beginning, from);
                forget(&mut self.ends[from as usize].ending, to);
                continue;
            }
            if i == 0 && attached {
                continue;
            }
            *self.open.entry((from, to)).or_default() += 1;
            remember(&mut self.ends[from as usize].beginning, to);
            remember(&mut self.ends[to as usize].ending, from);
            let turned = [vertices[i], vertices[(i + 1) % 3], vertices[(i + 2) % 3]];
            self.gates.push_back(Gate { nodes: [from, to], vertices: turned, group });
        }
    }

    /// Takes the next gate that is still open.
    pub(super) fn pop(&mut self) -> Option<Gate> {
        loop {
            let gate = self.gates.pop_front()?;
            let [a, b] = gate.nodes;
            match self.open.get(&(a, b)) {
                Some(&count) if count > 0 => return Some(gate),
                _ => {}
            }
        }
    }

    /// Closes a gate behind which there is nothing.
    pub(super) fn close(&mut self, gate: &Gate) {
        let [a, b] = gate.nodes;
        if let Some(count) = self.open.get_mut(&(a, b)) {
            *count = count.saturating_sub(1);
        }
        forget(&mut self.ends[a as usize].beginning, b);
        forget(&mut self.ends[b as usize].ending, a);
    }

    /// Nodes that may be the third corner beyond a gate: the other ends of open edges at its ends.
    pub(super) fn candidates(&self, gate: &Gate) -> [u32; 4] {
        let [a, b] = gate.nodes;
        let [y, w] = self.ends[a as usize].ending;
        let [x, z] = self.ends[b as usize].beginning;
        let mut candidates = [y, x, w, z];
        for i in 0..4 {
            let c = candidates[i];
            if c == a || c == b || candidates[..i].contains(&c) {
                candidates[i] = NONE;
            }
        }
        candidates
    }

    /// Vertex that was last seen at a node.
    pub(super) fn last_vertex(&self, node: u32) -> u32 {
        self.last_vertex[node as usize]
    }
}

fn remember(ends: &mut [u32; 2], node: u32) {
    *ends = [node, ends[0]];
}

fn forget(ends: &mut [u32; 2], node: u32) {
    if ends[0] == node {
        *ends = [ends[1], NONE];
    } else if ends[1] == node {
        ends[1] = NONE;
    }
}
