//! Models of what a page says of vertices.

use striata_stream::entropy::{AdaptiveBit, QuickNumber, Rate};

use crate::Metadata;

/// Adaptive models for the data of vertices.
pub(super) struct VertexModels {
    /// One context per axis and quality of the prediction.
    pub positions: QuickNumber,
    /// One context per component of each layer, for known neighbors and without.
    pub layers: QuickNumber,
    pub same_page: AdaptiveBit,
    pub page: QuickNumber,
    pub import: QuickNumber,
    pub keys: QuickNumber,
    pub errors: QuickNumber,
    /// Coordinates of positions in units of the lattice.
    pub places: Vec<[i64; 3]>,
    /// Vertex that was last imported from each page.
    pub last_imports: Vec<u32>,
    pub last_slot: usize,
    pub key_classes: Vec<i32>,
    pub error_classes: Vec<i32>,
}

impl VertexModels {
    pub(super) fn new(metadata: &Metadata) -> Self {
        let components: usize = metadata.layers.iter().map(|layer| layer.component_count as usize).sum();
        Self {
            positions: QuickNumber::new(9, Rate::Steady),
            layers: QuickNumber::new(2 * components, Rate::Steady),
            same_page: AdaptiveBit::new(Rate::Quick),
            page: QuickNumber::new(1, Rate::Quick),
            import: QuickNumber::new(3, Rate::Steady),
            keys: QuickNumber::new(2, Rate::Steady),
            errors: QuickNumber::new(2, Rate::Steady),
            places: Vec::new(),
            last_imports: Vec::new(),
            last_slot: 0,
            key_classes: Vec::new(),
            error_classes: Vec::new(),
        }
    }
}

/// Position of a vertex that is coded.
#[derive(Clone, Copy)]
pub(super) struct VertexSite {
    /// Its position; `None` for a new one.
    pub node: Option<u32>,
    /// Vertices near a new position.
    pub near: [u32; 3],
}
