//! What repair aims at, how hard it tries, and what it reports.

/// What repaired strips have few of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum RepairGoal {
    /// Indices: `swaps + 3.25 * strips`, since a strip costs two indices, its restart and every fourth time a
    /// parity fix.
    #[default]
    FewestIndices,
    /// Strips, and among as many strips swaps.
    FewestStrips,
}

/// Options of [`LiveStrips`](super::LiveStrips).
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct RepairOptions {
    /// What is made little; default [`RepairGoal::FewestIndices`].
    pub goal: RepairGoal,
    /// Links of the longest tunnel, an odd number; 0 searches for none. Default 9.
    pub tunnel_length: u32,
    /// Tunnels, whole or begun, that one search looks at; default 24.
    pub search_limit: u32,
    /// Searches begin at the triangles of a step and at so many rings of neighbors around them; default 1.
    pub reach: u32,
    /// Triangles of a strip that are walked to learn whether a tunnel would close it to a loop; in longer
    /// strips some tunnels are passed over. Default 1,024.
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

/// What a move between levels did to the strips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct RepairReport {
    /// Steps towards the base.
    pub collapse_count: usize,
    /// Steps towards the full mesh.
    pub split_count: usize,
    /// Solid links that steps and repair cut.
    pub cut_count: usize,
    /// Dashed links that steps and repair joined.
    pub joined_count: usize,
    /// Tunnels that made the strips better; ends that only moved are not counted.
    pub tunnel_count: usize,
    /// Triangles that steps changed, killed or brought back, each counted once a step.
    pub touched_count: usize,
}
