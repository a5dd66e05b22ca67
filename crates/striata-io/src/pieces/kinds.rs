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
            LayerData::I8(_) => ComponentType::I8,
            LayerData::I16(_) => ComponentType::I16,
            LayerData::I32(_) => ComponentType::I32,
            LayerData::F64(_) => ComponentType::F64,
        };
        let AttributeLayer { component_count, normalized, .. } = *layer;
        Self { semantic: layer.semantic.clone(), component_count, normalized, component_type }
    }

    /// A layer of this kind without values.
    pub fn empty_layer(&self) -> AttributeLayer {
        let data = match self.component_type {
            ComponentType::F32 => LayerData::F32(Vec::new()),
            ComponentType::U8 => LayerData::U8(Vec::new()),
            ComponentType::U16 => LayerData::U16(Vec::new()),
            ComponentType::U32 => LayerData::U32(Vec::new()),
            ComponentType::I8 => LayerData::I8(Vec::new()),
            ComponentType::I16 => LayerData::I16(Vec::new()),
            ComponentType::I32 => LayerData::I32(Vec::new()),
            ComponentType::F64 => LayerData::F64(Vec::new()),
        };
        let (semantic, component_count) = (self.semantic.clone(), self.component_count);
        AttributeLayer { semantic, component_count, normalized: self.normalized, data }
    }
}
