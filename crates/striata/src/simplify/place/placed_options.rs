//! Options and result of sequences whose steps create vertices.

use crate::mesh::FragmentedMesh;
use crate::setters::setters;
use crate::simplify::options::{SequenceOptions, StopReason};

/// Part of a mesh that a step collapses to one new vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum PlacedCollapse {
    /// An edge: two vertices become one.
    #[default]
    Edge,
    /// A triangle: three vertices become one. If the third vertex cannot follow, or costs far more than other
    /// collapses, only an edge is collapsed.
    Triangle,
}

/// Options of [`build_placed_fragments`](crate::simplify::build_placed_fragments).
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct PlacedOptions {
    /// Part that a step collapses; default [`PlacedCollapse::Edge`].
    pub collapse: PlacedCollapse,
    /// Rules and limits. The cost is always memoryless, and `pair_distance` must be `None`. The error limit
    /// is one on certified errors: coarser levels are left out.
    pub sequence: SequenceOptions,
}

impl PlacedOptions {
    setters! {
        with_collapse, collapse: PlacedCollapse;
        with_sequence, sequence: SequenceOptions;
    }
}

/// Result of [`build_placed_fragments`](crate::simplify::build_placed_fragments).
#[derive(Clone, Debug)]
pub struct BuiltPlaced {
    /// The mesh in refinement order, with its steps. Vertices that a collapse creates come before those that
    /// it removes; the full mesh does not use them.
    pub fragmented: FragmentedMesh,
    /// For each vertex, the vertex of the input that it came from; `None` if a collapse created it.
    pub source_vertex: Vec<Option<u32>>,
    /// Why the sequence stops at its base mesh.
    pub stop_reason: StopReason,
    /// Number of input triangles that were dropped because two of their corners share a position.
    pub degenerate_triangle_count: usize,
    /// Number of input vertices that were merged into equal ones.
    pub merged_vertex_count: usize,
}
