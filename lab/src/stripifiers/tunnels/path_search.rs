//! The tree of a breadth-first search for a tunnel, and which triangles it has visited.

use striata::mesh::NO_TWIN;

use super::options::{TunnelOptions, Visits};

/// Number of moving ends after which [`Visits::OncePerPath`] visits no triangle twice.
const PATH_NODE_LIMIT: usize = 1000;

/// Two links of a tunnel: the moving end takes a triangle, which releases a neighbor, the next moving end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PathStep {
    /// The dashed link, as the side of the moving end.
    pub crossed: u32,
    /// The triangle taken.
    pub taken: u32,
    /// The solid link that is released, as the side of the triangle taken.
    pub cut: u32,
    /// The next moving end.
    pub end: u32,
}

/// Moving end that the search has reached.
#[derive(Clone, Copy, Debug)]
struct PathNode {
    step: PathStep,
    /// Node before this one; the root is its own parent.
    parent: u32,
    depth: u32,
}

/// Tree of moving ends, in the order in which they were reached.
pub(super) struct PathSearch {
    visits: Visits,
    /// Number of steps that a tunnel may have before its last link.
    max_steps: u32,
    nodes: Vec<PathNode>,
    /// Index of the search that last visited each triangle.
    last_visits: Vec<u32>,
    search: u32,
    /// Steps from the root to the current node.
    path: Vec<PathStep>,
}

impl PathSearch {
    pub(super) fn new(triangle_count: usize, options: &TunnelOptions) -> Self {
        Self {
            visits: options.visits,
            max_steps: 0,
            nodes: Vec::new(),
            last_visits: vec![0; triangle_count],
            search: 0,
            path: Vec::new(),
        }
    }

    /// Sets the length of the longest tunnel, in links.
    pub(super) fn set_max_length(&mut self, max_length: u32) {
        self.max_steps = max_length.saturating_sub(1) / 2;
    }

    /// Begins a search at the end of a strip.
    pub(super) fn begin(&mut self, start: u32) {
        self.search += 1;
        self.nodes.clear();
        self.path.clear();
        self.last_visits[start as usize] = self.search;
        let step = PathStep { crossed: NO_TWIN, taken: start, cut: NO_TWIN, end: start };
        self.nodes.push(PathNode { step, parent: 0, depth: 0 });
    }

    /// Makes a node the current one. Returns its moving end, or [`None`] if there is no such node.
    pub(super) fn enter(&mut self, node: usize) -> Option<u32> {
        let end = self.nodes.get(node)?.step.end;
        self.path.clear();
        let mut at = node;
        while self.nodes[at].depth > 0 {
            self.path.push(self.nodes[at].step);
            at = self.nodes[at].parent as usize;
        }
        self.path.reverse();
        Some(end)
    }

    /// Returns the steps that lead to the current node.
    pub(super) fn path(&self) -> &[PathStep] {
        &self.path
    }

    /// Whether the current path may have another step, and still a last link after it.
    pub(super) fn may_go_on(&self) -> bool {
        (self.path.len() as u32) < self.max_steps
    }

    /// Whether the tunnel may not visit a triangle (again).
    pub(super) fn is_visited(&self, triangle: u32) -> bool {
        if self.visits == Visits::OncePerSearch || self.nodes.len() > PATH_NODE_LIMIT {
            return self.last_visits[triangle as usize] == self.search;
        }
        triangle == self.nodes[0].step.end
            || self.path.iter().any(|step| step.taken == triangle || step.end == triangle)
    }

    /// Adds a node after `parent`, the current node.
    pub(super) fn push(&mut self, parent: usize, step: PathStep) {
        self.last_visits[step.taken as usize] = self.search;
        self.last_visits[step.end as usize] = self.search;
        self.nodes.push(PathNode { step, parent: parent as u32, depth: self.path.len() as u32 + 1 });
    }
}
