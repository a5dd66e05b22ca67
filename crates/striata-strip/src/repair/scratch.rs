//! Lists that steps need for a moment.

/// Lists kept between steps so that none allocates.
#[derive(Clone, Debug, Default)]
pub(super) struct Scratch {
    /// Triangles that a collapse kills or a split brings back.
    pub(super) changed: Vec<u32>,
    /// Sides whose link a split breaks.
    pub(super) parted: Vec<u32>,
    /// Sides of two triangles between which a strip is to go on.
    pub(super) bridges: Vec<[u32; 2]>,
    /// Triangles around the step.
    pub(super) touched: Vec<u32>,
}
