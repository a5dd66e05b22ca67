//! Layers without values: what they have in common over all pieces of an input.

use striata::mesh::{AttributeLayer, LayerData};

use super::{ComponentType, LayerKind};

impl LayerKind {
    /// Describes a layer.
    pub fn of(layer: &AttributeLayer) -> Self {
        let component_type = match &layer.data {
            LayerData::F32(_) => ComponentType::F32,
            LayerData::U8(_) => ComponentType::U8,
            LayerData::U16(_) => ComponentType::U16,
            LayerData::U32(_) => ComponentType::U32,
        };
        let AttributeLayer { component_count, normalized, .. } = *layer;
        Self { semantic: layer.semantic.clone(), component_count, normalized, component_type }
    }

    /// A layer of this kind without values.
    #[cfg(feature = "blocks")]
    pub(crate) fn empty_layer(&self) -> AttributeLayer {
        let data = match self.component_type {
            ComponentType::F32 => LayerData::F32(Vec::new()),
            ComponentType::U8 => LayerData::U8(Vec::new()),
            ComponentType::U16 => LayerData::U16(Vec::new()),
            ComponentType::U32 => LayerData::U32(Vec::new()),
        };
        let (semantic, component_count) = (self.semantic.clone(), self.component_count);
        AttributeLayer { semantic, component_count, normalized: self.normalized, data }
    }
}

/// Turns integers into floats where the whole input has floats: the integers of PLY files are kept as such
/// only if none is negative, which a single piece does not tell.
pub(super) fn conform(layers: &mut [AttributeLayer], kinds: &[LayerKind]) {
    for (layer, kind) in layers.iter_mut().zip(kinds) {
        if kind.component_type == ComponentType::F32
            && let LayerData::U32(values) = &layer.data
        {
            layer.data = LayerData::F32(values.iter().map(|&value| value as f32).collect());
        }
    }
}
