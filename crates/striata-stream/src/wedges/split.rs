//! What the corners around a new position show, as both sides have it.

/// What the corners around a new position show.
#[derive(Clone, Debug, Default)]
pub(crate) struct SplitWedges {
    /// The vertex that each wedge of the new position collapses to.
    pub(crate) targets: Vec<u32>,
    /// The wedge of each corner at the new position, in the order of the corners; none in virtual triangles.
    pub(crate) wedges: Vec<u32>,
    /// What A's and B's corners at the kept position show.
    pub(crate) kept: [u32; 2],
    /// What their corners at the ends of the ring show.
    pub(crate) ends: [u32; 2],
    /// Groups of A and B.
    pub(crate) groups: [u32; 2],
    /// What a writer calls the wedges.
    pub(crate) named: Vec<u32>,
}
