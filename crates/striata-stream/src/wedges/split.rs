//! The vertices that the corners around a new position refer to, as both sides of a stream know them.

/// The vertices that the corners around a new position refer to.
#[derive(Clone, Debug, Default)]
pub(crate) struct SplitWedges {
    /// The vertex that each wedge of the new position collapses to.
    pub targets: Vec<u32>,
    /// Wedge of each corner at the new position, in the order of the corners;
    /// [`NONE`](crate::topology::surface::NONE) in virtual triangles.
    pub wedges: Vec<u32>,
    /// Vertices of the corners of A and B at the kept position.
    pub kept: [u32; 2],
    /// Vertices of the corners of A and B at the ends of the ring.
    pub ends: [u32; 2],
    /// Groups of A and B.
    pub groups: [u32; 2],
    /// The source mesh's vertex of each wedge; only meaningful in a writer.
    pub source_vertices: Vec<u32>,
}
