//! Temporary lists of a step.

/// Lists that are reused between steps, so that no step allocates.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    /// Triangles that a collapse removes or a split restores.
    pub(super) changed: Vec<u32>,
    /// Sides whose links a split breaks.
    pub(super) detached: Vec<u32>,
    /// Pairs of sides between which a strip should continue.
    pub(super) bridges: Vec<[u32; 2]>,
    /// Triangles around the step.
    pub(super) touched: Vec<u32>,
}
