//! Types that describe the link of a position.

/// How the link of a position is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(in crate::simplify) enum LinkKind {
    /// No triangle.
    Empty,
    /// A cycle: entry `i` and its successor, cyclically, span a triangle.
    Closed,
    /// A path: like a cycle, but the last entry has no successor.
    Open,
    /// Pairs of entries, one per triangle.
    Edges,
}

/// One edge of a link: the triangle `(v, a, b)`, with its index if triangles are followed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::simplify) struct LinkEdge {
    pub a: u32,
    pub b: u32,
    pub triangle: u32,
}
