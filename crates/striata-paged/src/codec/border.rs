//! Open edges of the region that has been coded so far.

const NONE: u32 = u32::MAX;

/// An open edge of a triangle that has been coded: the triangle beyond it has its ends in reverse order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gate {
    /// Nodes of the edge.
    pub nodes: [u32; 2],
    /// Vertices at them, and at the third corner of the triangle.
    pub vertices: [u32; 3],
    /// Group of the triangle.
    pub group: u32,
    /// The gate that began before at the same node and is still open, or [`NONE`].
    next: u32,
    is_open: bool,
}

/// Open edges at a node, and the vertex that was last used there.
#[derive(Clone, Copy)]
struct BorderNode {
    /// Gate that began last at the node, or [`NONE`].
    gate: u32,
    /// Other ends of the last two open edges that end here and that begin here.
    ending: [u32; 2],
    beginning: [u32; 2],
    /// Vertex that was last used here.
    last_vertex: u32,
}

const NEW_NODE: BorderNode =
    BorderNode { gate: NONE, ending: [NONE; 2], beginning: [NONE; 2], last_vertex: NONE };

/// The open edges.
#[derive(Default)]
pub(super) struct Border {
    /// All gates so far, in the order in which they are passed.
    gates: Vec<Gate>,
    /// The gates before this one have been passed.
    passed: usize,
    nodes: Vec<BorderNode>,
}

impl Border {
    /// Creates an empty border for a number of nodes and an estimated number of triangles.
    pub(super) fn new(node_count: usize, triangle_count: usize) -> Self {
        let gates = Vec::with_capacity(triangle_count + triangle_count / 2);
        Self { gates, passed: 0, nodes: vec![NEW_NODE; node_count] }
    }

    /// Adds a coded triangle. `attached` is whether its first edge belonged to a gate.
    pub(super) fn add(&mut self, nodes: [u32; 3], vertices: [u32; 3], group: u32, attached: bool) {
        for (&node, &v) in nodes.iter().zip(&vertices) {
            self.nodes[node as usize].last_vertex = v;
        }
        for i in 0..3 {
            let (from, to) = (nodes[i], nodes[(i + 1) % 3]);
            // The other side of an open edge closes it.
            if self.close([to, from]) || (i == 0 && attached) {
                continue;
            }
            let gate = self.gates.len() as u32;
            let next = std::mem::replace(&mut self.nodes[from as usize].gate, gate);
            remember(&mut self.nodes[from as usize].beginning, to);
            remember(&mut self.nodes[to as usize].ending, from);
            let vertices = [vertices[i], vertices[(i + 1) % 3], vertices[(i + 2) % 3]];
            self.gates.push(Gate { nodes: [from, to], vertices, group, next, is_open: true });
        }
    }

    /// Takes the next gate that is still open.
    pub(super) fn pop(&mut self) -> Option<Gate> {
        while let Some(gate) = self.gates.get(self.passed) {
            self.passed += 1;
            if gate.is_open {
                return Some(*gate);
            }
        }
        None
    }

    /// Closes the gate that was opened last on an edge; returns whether there was one.
    pub(super) fn close(&mut self, [from, to]: [u32; 2]) -> bool {
        let mut before = NONE;
        let mut at = self.nodes[from as usize].gate;
        while let Some(gate) = self.gates.get_mut(at as usize) {
            if gate.nodes[1] != to {
                (before, at) = (at, gate.next);
                continue;
            }
            gate.is_open = false;
            let next = gate.next;
            match self.gates.get_mut(before as usize) {
                Some(before) => before.next = next,
                None => self.nodes[from as usize].gate = next,
            }
            forget(&mut self.nodes[from as usize].beginning, to);
            forget(&mut self.nodes[to as usize].ending, from);
            return true;
        }
        false
    }

    /// Nodes that may be the third corner beyond a gate: the other ends of open edges at its ends.
    pub(super) fn candidates(&self, gate: &Gate) -> [u32; 4] {
        let [a, b] = gate.nodes;
        let [y, w] = self.nodes[a as usize].ending;
        let [x, z] = self.nodes[b as usize].beginning;
        let mut candidates = [y, x, w, z];
        for i in 0..4 {
            let c = candidates[i];
            if c == a || c == b || candidates[..i].contains(&c) {
                candidates[i] = NONE;
            }
        }
        candidates
    }

    /// Vertex that was last used at a node.
    pub(super) fn last_vertex(&self, node: u32) -> u32 {
        self.nodes[node as usize].last_vertex
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn edges_are_closed_by_their_other_side() {
        let mut border = Border::new(5, 4);
        border.add([0, 1, 2], [0, 1, 2], 0, false);
        border.add([1, 0, 3], [1, 0, 3], 0, false);
        // The edge between 0 and 1 is closed, so the gates from 1 to 2 and from 2 to 0 are next.
        assert_eq!(border.pop().map(|gate| gate.nodes), Some([1, 2]));
        let gate = border.pop().unwrap();
        assert_eq!(gate.nodes, [2, 0]);
        assert_eq!(border.candidates(&gate)[..2], [1, 3]);
        assert!(border.close(gate.nodes) && !border.close(gate.nodes));
    }

    #[test]
    fn equal_edges_are_closed_one_by_one() {
        let mut border = Border::new(5, 4);
        border.add([0, 1, 2], [0, 1, 2], 0, false);
        border.add([0, 1, 3], [0, 1, 3], 0, false);
        border.add([1, 0, 4], [1, 0, 4], 0, false);
        let open: Vec<[u32; 2]> = std::iter::from_fn(|| border.pop()).map(|gate| gate.nodes).collect();
        assert_eq!(open.iter().filter(|&&nodes| nodes == [0, 1]).count(), 1);
    }
}
