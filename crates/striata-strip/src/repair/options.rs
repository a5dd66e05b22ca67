//! Options of strip repair, and its report.

/// Quantity that repair minimizes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum RepairGoal {
    /// The number of indices, as `swaps + 3.25 * strips`: a strip costs two indices, a restart, and a
    /// parity fix for every fourth strip.
    #[default]
    FewestIndices,
    /// The number of strips and, among equals, the number of swaps.
    FewestStrips,
}

/// Options of [`LiveStrips`](super::LiveStrips).
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct RepairOptions {
    /// Quantity to minimize; default [`RepairGoal::FewestIndices`].
    pub goal: RepairGoal,
    /// Length of the longest tunnel, in links: an odd number, or 0 for no search. Default 9.
    pub tunnel_length: u32,
    /// Number of tunnels, complete or partial, that one search examines. Default 24.
    pub search_limit: u32,
    /// Number of rings around the triangles of a step from which searches start. Default 1.
    pub reach: u32,
    /// Number of triangles of a strip that are visited to find out whether a tunnel would close a loop. In
    /// longer strips, some tunnels are skipped. Default 1,024.
    pub walk_limit: u32,
}

impl Default for RepairOptions {
    fn default() -> Self {
        Self { goal: RepairGoal::default(), tunnel_length: 9, search_limit: 24, reach: 1, walk_limit: 1_024 }
    }
}

impl RepairOptions {
    /// Sets [`RepairOptions::goal`].
    pub fn with_goal(mut self, goal: RepairGoal) -> Self {
        self.goal = goal;
        self
    }

    /// Sets [`RepairOptions::tunnel_length`].
    pub fn with_tunnel_length(mut self, length: u32) -> Self {
        self.tunnel_length = length;
        self
    }

    /// Sets [`RepairOptions::search_limit`].
    pub fn with_search_limit(mut self, limit: u32) -> Self {
        self.search_limit = limit;
        self
    }

    /// Sets [`RepairOptions::reach`].
    pub fn with_reach(mut self, rings: u32) -> Self {
        self.reach = rings;
        self
    }

    /// Sets [`RepairOptions::walk_limit`].
    pub fn with_walk_limit(mut self, limit: u32) -> Self {
        self.walk_limit = limit;
        self
    }
}

/// Counts of what a move between levels did to the strips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct RepairReport {
    /// Number of steps toward the base mesh.
    pub collapse_count: usize,
    /// Number of steps toward the full mesh.
    pub split_count: usize,
    /// Number of solid links that steps and repair cut.
    pub cut_count: usize,
    /// Number of dashed links that steps and repair joined.
    pub joined_count: usize,
    /// Number of tunnels that improved the strips; moves of ends are not counted.
    pub tunnel_count: usize,
    /// Number of triangles that steps changed, removed or restored, each counted once per step.
    pub touched_count: usize,
}
