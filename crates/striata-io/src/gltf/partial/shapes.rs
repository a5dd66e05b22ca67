//! Shapes of accessors, for which nothing is decompressed but meshes of Draco.

use striata::mesh::Semantic;

use crate::error::Fault;
use crate::gltf::accessor::AccessorShape;
use crate::gltf::document::{GltfDocument, stride};
use crate::gltf::json::JsonNode;
use crate::gltf::primitive::Primitive;

/// Reads and checks the shape of accessor `index`. Nothing is decompressed for this.
pub(super) fn shape(
    document: &GltfDocument<'_>,
    index: u64,
    from: &JsonNode<'_>,
) -> Result<AccessorShape, Fault> {
    let at = document.item("accessors", index, from)?;
    let shape = AccessorShape::parse(document, &at)?;
    if let Some(view) = at.unsigned("bufferView")? {
        let (size, stride) = document.view_size(view, &at)?;
        shape.place(&at, size, stride)?;
    }
    Ok(shape)
}

impl GltfDocument<'_> {
    /// Returns the size in bytes that a buffer view has when it is decompressed, which this does not do, and
    /// its stride if it has one.
    fn view_size(&self, index: u64, from: &JsonNode<'_>) -> Result<(u64, Option<usize>), Fault> {
        let at = self.item("bufferViews", index, from)?;
        let stride = stride(&at)?;
        let size = match self.packed(&at) {
            Some(_) => at.required_unsigned("byteLength")?,
            None => self.range(&at)?.len() as u64,
        };
        Ok((size, stride))
    }
}

impl Primitive<'_> {
    /// Returns the shape of the positions ([`None`]) or another attribute. Only compressed meshes are decoded
    /// for this.
    pub(crate) fn shape(
        &self,
        document: &GltfDocument<'_>,
        semantic: Option<&Semantic>,
        index: u64,
    ) -> Result<AccessorShape, Fault> {
        match &self.draco {
            Some(_) => self.data(document, semantic, index).map(|accessor| accessor.shape),
            None => shape(document, index, &self.at),
        }
    }

    /// Returns the shape of the indices of a primitive that is no compressed mesh.
    pub(super) fn index_shape(&self, document: &GltfDocument<'_>) -> Result<Option<AccessorShape>, Fault> {
        self.indices.map(|index| shape(document, index, &self.at)).transpose()
    }
}
