//! Primitives that Draco has compressed: which attribute of the compressed mesh belongs to which semantic.

use striata::mesh::Semantic;

use super::accessor::Accessor;
use super::component_type::GltfComponentType;
use super::compression::{self, GeometryCompression};
use super::document::GltfDocument;
use super::draco_mesh::{self, DracoAttribute, DracoMesh};
use super::json::JsonNode;
use super::semantics::semantic;
use crate::error::Fault;

/// Attribute identifiers in a compressed mesh, sorted; [`None`] for the positions.
type Ids = Vec<(Option<Semantic>, u32)>;

/// Identity of the vertices of a compressed mesh: its buffer view, and the attributes that are used.
pub(crate) type DracoKey = (u64, Ids);

/// Compressed mesh of a primitive.
pub(crate) struct DracoLink<'a> {
    at: JsonNode<'a>,
    view: u64,
    ids: Ids,
}

impl<'a> DracoLink<'a> {
    /// Reads the extension of a primitive; [`None`] if its accessors have plain data that must do.
    pub(super) fn parse(
        document: &GltfDocument<'_>,
        primitive: &JsonNode<'a>,
        position: u64,
    ) -> Result<Option<Self>, Fault> {
        let Some(at) = compression::draco(primitive) else { return Ok(None) };
        if !GeometryCompression::Draco.is_on() {
            let positions = document.item("accessors", position, primitive)?;
            let is_plain = positions.get("bufferView").is_some();
            return if is_plain { Ok(None) } else { Err(GeometryCompression::Draco.feature_off()) };
        }
        let view = at.required_unsigned("bufferView")?;
        let mut ids = Ids::new();
        for (name, entry) in at.members("attributes")? {
            let id = entry.as_unsigned()?;
            let Ok(id) = u32::try_from(id) else {
                return Err(entry.fault(format!("attribute {id} does not exist in the compressed mesh")));
            };
            ids.push(((name != "POSITION").then(|| semantic(name)), id));
        }
        ids.sort();
        Ok(Some(Self { at, view, ids }))
    }

    /// Returns the key of the vertices of the compressed mesh: its view and the numbers of its attributes.
    pub(crate) fn key(&self) -> DracoKey {
        (self.view, self.ids.clone())
    }

    /// Returns the decoded indices.
    pub(super) fn indices<'d>(&self, document: &'d GltfDocument<'_>) -> Result<Accessor<'d>, Fault> {
        Ok(self.mesh(document)?.indices(&self.at.path))
    }

    /// Returns decoded positions ([`None`]) or another attribute, for accessor `index`; [`None`] if the
    /// attribute is not part of the compressed mesh.
    pub(super) fn attribute<'d>(
        &self,
        document: &'d GltfDocument<'_>,
        semantic: Option<&Semantic>,
        index: u64,
    ) -> Result<Option<Accessor<'d>>, Fault> {
        let Some(&(_, id)) = self.ids.iter().find(|(own, _)| own.as_ref() == semantic) else {
            return Ok(None);
        };
        let declared = document.item("accessors", index, &self.at)?;
        let mesh = self.mesh(document)?;
        let Some(mut accessor) = mesh.attribute(id, &declared.path) else {
            let reason = format!("the compressed mesh has no attribute {id} of a type that glTF knows");
            return Err(self.at.fault(reason));
        };
        accessor.shape.normalized = declared.flag("normalized");
        Ok(Some(accessor))
    }

    fn mesh<'d>(&self, document: &'d GltfDocument<'_>) -> Result<&'d DracoMesh, Fault> {
        let (source, _) = document.view(self.view, &self.at)?;
        let unpacked = &document.unpacked;
        let bytes_left = unpacked.bytes_left(document.input_bytes);
        let claim = |bytes| unpacked.claim(bytes, document.input_bytes, &self.at);
        unpacked.draco_mesh(self.view, || draco_mesh::decoded(source, &self.at, bytes_left, claim))
    }
}

impl DracoMesh {
    /// Returns the indices of all triangles.
    pub(super) fn indices(&self, path: &str) -> Accessor<'_> {
        Accessor::packed(self.index_count, [1, 4], GltfComponentType::U32, &self.indices, path)
    }

    /// Returns an attribute, if there is one of this identifier.
    pub(super) fn attribute(&self, id: u32, path: &str) -> Option<Accessor<'_>> {
        let DracoAttribute { component, component_count, bytes } = self.attributes.get(&id)?;
        let shape = [*component_count, component_count * component.bytes()];
        Some(Accessor::packed(self.point_count, shape, *component, bytes, path))
    }
}
