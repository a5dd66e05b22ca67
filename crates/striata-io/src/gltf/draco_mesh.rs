//! Meshes that Draco has compressed, decoded to plain arrays.
//!
//! Draco stores each distinct attribute value once, with a map from points to values. glTF has no such
//! maps, so the values are repeated for every point.

use std::collections::BTreeMap;

use super::component_type::GltfComponentType;
use super::json::JsonNode;
use crate::error::Fault;

/// Decoded mesh.
#[derive(Debug, Default)]
pub(crate) struct DracoMesh {
    pub point_count: usize,
    pub index_count: usize,
    /// Indices in 32 bits, three for each triangle.
    pub indices: Vec<u8>,
    /// Attributes by their unique identifiers.
    pub attributes: BTreeMap<u32, DracoAttribute>,
}

/// Attribute of every point.
#[derive(Debug)]
pub(crate) struct DracoAttribute {
    pub component: GltfComponentType,
    pub component_count: usize,
    pub bytes: Vec<u8>,
}

impl DracoMesh {
    /// Returns the size of the decoded arrays in bytes.
    pub(super) fn bytes(&self) -> u64 {
        let attributes = self.attributes.values().map(|attribute| attribute.bytes.len());
        (self.indices.len() + attributes.sum::<usize>()) as u64
    }
}

/// Decodes a mesh; `at` is the value that refers to it.
#[cfg(not(feature = "draco"))]
pub(super) fn decoded(
    _: &[u8],
    _: &JsonNode<'_>,
    _: u64,
    _: impl Fn(u64) -> Result<(), Fault>,
) -> Result<DracoMesh, Fault> {
    Err(super::compression::GeometryCompression::Draco.feature_off())
}

/// Decodes a mesh of at most `bytes_left` bytes; `at` is the value that refers to it, and `claim_bytes` accounts for
/// memory.
#[cfg(feature = "draco")]
pub(super) fn decoded(
    source: &[u8],
    at: &JsonNode<'_>,
    bytes_left: u64,
    claim_bytes: impl Fn(u64) -> Result<(), Fault>,
) -> Result<DracoMesh, Fault> {
    let damaged = |reason: String| at.fault(format!("the compressed data are damaged: {reason}"));
    let mesh = decode(source, bytes_left).map_err(damaged)?;
    let (point_count, index_count) = (mesh.num_points(), mesh.num_faces() * 3);
    let claim = |elements: usize, size: usize| claim_bytes((elements as u64).saturating_mul(size as u64));
    claim(index_count, 4)?;
    let indices = mesh.faces().iter().flatten().flat_map(|point| point.0.to_le_bytes()).collect();
    let mut attributes = BTreeMap::new();
    for place in 0..mesh.num_attributes() {
        let attribute = mesh.attribute(place);
        // Attributes of types that glTF lacks cannot belong to an accessor.
        let Some(component) = component_type(attribute.data_type()) else { continue };
        let component_count = attribute.num_components() as usize;
        claim(point_count, component_count * component.bytes())?;
        let bytes = values_of_points(attribute, point_count, component_count * component.bytes());
        let bytes = bytes.map_err(damaged)?;
        attributes.insert(attribute.unique_id(), DracoAttribute { component, component_count, bytes });
    }
    Ok(DracoMesh { point_count, index_count, indices, attributes })
}

/// Decodes a mesh of at most `bytes_left` bytes.
#[cfg(feature = "draco")]
pub(super) fn decode(source: &[u8], bytes_left: u64) -> Result<draco_core::Mesh, String> {
    use draco_core::{DecodeLimits, DecoderBuffer, Mesh, MeshDecoder};

    let limits = DecodeLimits::default()
        .with_max_points(bytes_left / 4)
        .with_max_faces(bytes_left / 12)
        .with_max_decoded_bytes(bytes_left);
    super::compression::contained(|| {
        let mut mesh = Mesh::new();
        let mut buffer = DecoderBuffer::new(source).with_limits(limits);
        MeshDecoder::new().decode(&mut buffer, &mut mesh).map_err(|error| error.to_string())?;
        Ok(mesh)
    })
}

#[cfg(feature = "draco")]
fn component_type(data_type: draco_core::DataType) -> Option<GltfComponentType> {
    use draco_core::DataType;

    Some(match data_type {
        DataType::Int8 => GltfComponentType::I8,
        DataType::Uint8 | DataType::Bool => GltfComponentType::U8,
        DataType::Int16 => GltfComponentType::I16,
        DataType::Uint16 => GltfComponentType::U16,
        DataType::Uint32 => GltfComponentType::U32,
        DataType::Float32 => GltfComponentType::F32,
        _ => return None,
    })
}

/// Returns the values of all points, tightly packed.
#[cfg(feature = "draco")]
pub(super) fn values_of_points(
    attribute: &draco_core::PointAttribute,
    point_count: usize,
    element_bytes: usize,
) -> Result<Vec<u8>, String> {
    let data = attribute.buffer().data();
    let stride = usize::try_from(attribute.byte_stride()).unwrap_or(0);
    let mut bytes = Vec::with_capacity(point_count * element_bytes);
    for point in 0..point_count as u32 {
        let value = attribute.mapped_index(draco_core::PointIndex(point)).0 as usize;
        let start = value.checked_mul(stride).filter(|_| value < attribute.size());
        let element = start.and_then(|start| data.get(start..)?.get(..element_bytes));
        let Some(element) = element else {
            return Err(format!("point {point} has value {value}, but there are {}", attribute.size()));
        };
        bytes.extend_from_slice(element);
    }
    Ok(bytes)
}
