//! Search for one tunnel: breadth first from the end of a strip, so that the shortest is found first.
//!
//! A tunnel alternates dashed and solid links from one strip's end to another's; swapping them leaves one
//! strip fewer \[PS03, 3.1\]. The search takes two links per step: the moving end takes a triangle across a
//! dashed link, and that triangle releases a neighbor, which becomes the next moving end. No loop can close
//! if a triangle of the same strip releases the neighbor on the moving end's side, and if the last triangle
//! belongs to another strip.

use striata::mesh::{NO_TWIN, Random};
use striata::strip::{StripLinks, next_side, prev_side};

use super::trace::{Relation, StripLocations, StripTrace, TunnelStep};

/// Number of moving ends after which a search visits no triangle twice.
///
/// Until then a tunnel only must not cross itself, because different paths to one triangle leave different
/// strips behind: on the bunny, tunnels of 17 links then leave a fifth fewer strips. The limit keeps long
/// tunnels affordable: with 60 links, 14 strips in 2.0 s without it, 16 in 0.3 s with it.
const REVISIT_NODE_LIMIT: usize = 1000;

/// Reusable state of searches.
#[derive(Debug)]
pub(crate) struct TunnelPathSearch {
    /// Number of steps that a tunnel may have before its last link.
    max_steps: usize,
    /// Index of the search that last visited each triangle.
    visits: Vec<u32>,
    search: u32,
    nodes: Vec<ReachedEnd>,
    steps: Vec<TunnelStep>,
    trace: StripTrace,
}

/// Moving end that the search has reached.
#[derive(Clone, Copy, Debug)]
struct ReachedEnd {
    step: TunnelStep,
    /// Node before this one; the root is its own parent.
    parent: u32,
    depth: u32,
}

impl TunnelPathSearch {
    /// Creates a search for tunnels of at most `max_length` links in a mesh of `triangle_count` triangles.
    pub(crate) fn new(triangle_count: usize, max_length: u32) -> Self {
        Self {
            max_steps: max_length.saturating_sub(1) as usize / 2,
            visits: vec![0; triangle_count],
            search: 0,
            nodes: Vec::new(),
            steps: Vec::new(),
            trace: StripTrace::default(),
        }
    }

    /// Returns the steps of the last tunnel found, in order.
    pub(crate) fn steps(&self) -> &[TunnelStep] {
        &self.steps
    }

    /// Finds the shortest tunnel from the end of a strip. Returns its last dashed link, which follows
    /// [`TunnelPathSearch::steps`].
    ///
    /// The links stay as they are; `random` decides between tunnels of equal length.
    pub(crate) fn find(
        &mut self,
        start: u32,
        links: &StripLinks<'_>,
        locations: &impl StripLocations,
        random: &mut Random,
    ) -> Option<u32> {
        debug_assert!(links.solid_degree(start) < 2, "triangle {start} is inside a strip");
        self.search += 1;
        self.nodes.clear();
        self.visits[start as usize] = self.search;
        let step = TunnelStep { crossed: NO_TWIN, taken: start, cut: NO_TWIN, end: start };
        self.nodes.push(ReachedEnd { step, parent: 0, depth: 0 });
        let mut head = 0;
        while let Some(&node) = self.nodes.get(head) {
            self.collect_steps(head);
            self.trace.follow(start, &self.steps, links, locations);
            let mut side = 3 * node.step.end + random.below(3);
            for _ in 0..3 {
                if self.cross(side, head, links, locations) {
                    return Some(side);
                }
                side = next_side(side);
            }
            head += 1;
        }
        self.steps.clear();
        None
    }

    /// After a search without success, sets [`TunnelPathSearch::steps`] to the path to one of the deepest moving ends
    /// that it reached, chosen at random. Returns that end, or [`None`] if the start cannot move.
    ///
    /// Near ends search what the failed search has searched already: on the dragon, ends chosen from all
    /// depths leave 1,600 strips at 13 links, the deepest 1,300.
    pub(crate) fn pick_move(&mut self, random: &mut Random) -> Option<u32> {
        let deepest = self.nodes.last().map_or(0, |node| node.depth);
        if deepest == 0 {
            return None;
        }
        // Breadth first: depths never fall.
        let first = self.nodes.partition_point(|node| node.depth < deepest);
        let chosen = first + random.below((self.nodes.len() - first) as u32) as usize;
        self.collect_steps(chosen);
        Some(self.nodes[chosen].step.end)
    }

    /// Collects the steps from the start to a node.
    fn collect_steps(&mut self, node: usize) {
        self.steps.clear();
        let mut at = node;
        while self.nodes[at].depth > 0 {
            self.steps.push(self.nodes[at].step);
            at = self.nodes[at].parent as usize;
        }
        self.steps.reverse();
    }

    /// Crosses a link from a node's moving end. Returns true if that completes a tunnel; otherwise queues
    /// the next ends.
    fn cross(
        &mut self,
        crossed: u32,
        from: usize,
        links: &StripLinks<'_>,
        locations: &impl StripLocations,
    ) -> bool {
        let entered = links.twins()[crossed as usize];
        if entered == NO_TWIN || links.is_solid(crossed) || self.is_visited(entered / 3) {
            return false;
        }
        let taken = entered / 3;
        let relation = self.trace.relation(taken, locations);
        let end_above = match relation {
            Relation::Untouched | Relation::Other if links.solid_degree(taken) < 2 => return true,
            Relation::Untouched | Relation::Other => None,
            Relation::Same { is_end_above } | Relation::SameMoved { is_end_above } => Some(is_end_above),
        };
        let depth = self.nodes[from].depth + 1;
        if depth as usize > self.max_steps {
            return false;
        }
        let mut is_taken = false;
        for cut in [next_side(entered), prev_side(entered)].into_iter().filter(|&side| links.is_solid(side)) {
            let end = links.twins()[cut as usize] / 3;
            let is_right =
                end_above.is_none_or(|above| above == (locations.index(end) > locations.index(taken)));
            if is_right && !self.is_visited(end) {
                self.visits[end as usize] = self.search;
                is_taken = true;
                let step = TunnelStep { crossed, taken, cut, end };
                self.nodes.push(ReachedEnd { step, parent: from as u32, depth });
            }
        }
        if is_taken {
            self.visits[taken as usize] = self.search;
        }
        false
    }

    /// Whether a triangle is part of the current tunnel or, once a search is large, of any tunnel tried.
    fn is_visited(&self, triangle: u32) -> bool {
        if self.nodes.len() > REVISIT_NODE_LIMIT {
            return self.visits[triangle as usize] == self.search;
        }
        triangle == self.nodes[0].step.end
            || self.steps.iter().any(|step| step.taken == triangle || step.end == triangle)
    }
}
