//! Temporary lists of a step.

/// Lists that are reused between steps, so that no step allocates.
#[derive(Clone, Debug, Default)]
pub(super) struct RepairScratch {
    /// Triangles that a collapse removes or a split restores.
    pub changed: Vec<u32>,
    /// Sides whose links a split breaks.
    pub detached: Vec<u32>,
    /// Pairs of sides between which a strip should continue.
    pub bridges: Vec<[u32; 2]>,
    /// Triangles around the step.
    pub touched: Vec<u32>,
}
