//! Parameters of a stream that both sides know before the first bit.

use crate::base::coder::BaseLimits;
use crate::format::effort::Effort;
use crate::format::grid::PositionGrid;
use crate::layers::form::LayerForm;

/// Parameters of a stream that both sides know before the first bit: a writer chooses them, a reader
/// finds them in the header.
#[derive(Clone, Debug)]
pub(crate) struct StreamParameters {
    /// Whether the stream has general batches.
    pub has_general: bool,
    /// Trade-off between speed and size.
    pub effort: Effort,
    /// The grid that positions are quantized to.
    pub grid: PositionGrid,
    /// Whether the stream also stores exact positions.
    pub is_exact: bool,
    /// Maximum number of triangles that move to a new vertex.
    pub max_patch: u32,
    /// Number of positions in the full mesh.
    pub position_count: u32,
    /// Limits on the size of the base mesh.
    pub base: BaseLimits,
    /// Number of vertices in the full mesh.
    pub vertex_count: u32,
    /// Number of groups in the full mesh.
    pub group_count: u32,
    /// How attribute layers are stored.
    pub layers: Vec<LayerForm>,
}

impl StreamParameters {
    /// Whether the stream has to code which vertex each corner refers to.
    pub(crate) fn has_wedges(&self) -> bool {
        self.vertex_count != self.position_count || self.group_count > 1
    }

    /// Maximum number of vertex visits in a stream: many times more than real batches need, and a bound
    /// for hostile streams.
    pub(crate) fn most_visits(&self) -> u64 {
        256 * u64::from(self.position_count) + 65_536
    }
}
