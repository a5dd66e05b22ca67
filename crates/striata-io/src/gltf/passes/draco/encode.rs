//! Encoding of a primitive.

use draco_core::{
    AttributeValueIndex, DataType, DracoError, EncoderBuffer, EncoderOptions, GeometryAttributeType, Mesh,
    MeshEncoder, PointAttribute, PointIndex,
};
use serde_json::{Map, Value, json};

use crate::QuantizeOptions;
use crate::error::WriteError;
use crate::gltf::accessor::accessor;
use crate::gltf::component_type::GltfComponentType;
use crate::gltf::compression::contained;
use crate::gltf::document::GltfDocument;
use crate::gltf::draco_mesh;
use crate::gltf::passes::additions::{Additions, ViewKind, remove};
use crate::gltf::passes::elements::Elements;
use crate::gltf::passes::primitives::{PassPrimitive, TRIANGLES};

/// Compression level, from 0 to 10; the default of Draco's own command.
const LEVEL: i32 = 7;

/// Estimated size of the JSON that a compressed primitive needs in addition, in bytes.
const JSON_BYTES: usize = 160;

/// Compressed primitive.
pub(super) struct CodedPrimitive {
    bytes: Vec<u8>,
    attributes: Vec<CodedAttribute>,
    index_count: usize,
    point_count: usize,
}

struct CodedAttribute {
    name: String,
    /// Identifier in the compressed mesh.
    id: u32,
    /// Accessor of the decoded data.
    accessor: Value,
}

/// JSON of a compressed primitive.
pub(super) struct CodedJson {
    pub attributes: Value,
    pub indices: usize,
    pub extension: Value,
}

impl CodedPrimitive {
    /// Adds the compressed data and the accessors to the document.
    pub(super) fn added_to(self, additions: &mut Additions) -> CodedJson {
        let bytes = Elements::integers(self.bytes.into_iter().map(i64::from), 1, GltfComponentType::U8);
        let role = format!("draco {}", additions.shelves.len());
        let mut extension = json!({});
        additions.store(ViewKind::of_others(&role, &bytes), &bytes, &mut extension);
        let component =
            if self.point_count < 0xffff { GltfComponentType::U16 } else { GltfComponentType::U32 };
        let indices = additions.push_accessor(json!({
            "componentType": component.number(),
            "count": self.index_count,
            "type": "SCALAR",
        }));
        let (mut attributes, mut ids) = (Map::new(), Map::new());
        for CodedAttribute { name, id, accessor } in self.attributes {
            attributes.insert(name.clone(), json!(additions.push_accessor(accessor)));
            ids.insert(name, json!(id));
        }
        extension["attributes"] = Value::Object(ids);
        CodedJson { attributes: Value::Object(attributes), indices, extension }
    }
}

/// Attribute of the vertices that a primitive uses.
struct VertexAttribute<'a> {
    name: &'a str,
    accessor: &'a Value,
    elements: Elements,
}

/// Precision of the attributes: [`None`] to keep them exactly. The second part has corners and bits of the cube in
/// which positions are quantized, instead of their bounding box.
type Precision<'a> = (Option<&'a QuantizeOptions>, Option<([[f32; 3]; 2], u32)>);

/// Encodes a primitive; [`None`] if it must or should stay uncompressed.
pub(super) fn coded(
    document: &GltfDocument<'_>,
    primitive: &PassPrimitive,
    precision: Precision<'_>,
) -> Option<CodedPrimitive> {
    let mut sources = Vec::new();
    for (name, index) in &primitive.attributes {
        let elements = Elements::read(&accessor(document, *index, &document.root).ok()?);
        let accessor = document.item("accessors", *index, &document.root).ok()?.value;
        sources.push(VertexAttribute { name, accessor, elements });
    }
    let position = sources.iter().find(|source| source.name == "POSITION")?;
    let vertex_count = position.elements.count;
    if position.elements.width != 3 || sources.iter().any(|source| source.elements.count != vertex_count) {
        return None;
    }
    let triangles = used_vertices(triangles(document, primitive, vertex_count)?, &mut sources)?;
    let plain_bytes = triangles.len() * 6 + sources.iter().map(|s| s.elements.bytes.len()).sum::<usize>();
    let coded = contained(|| encode(&triangles, &sources, precision)).ok()?;
    (coded.bytes.len() + JSON_BYTES < plain_bytes).then_some(coded)
}

/// Returns the triangles of a primitive; [`None`] if its indices are damaged or there are no triangles.
fn triangles(
    document: &GltfDocument<'_>,
    primitive: &PassPrimitive,
    vertex_count: usize,
) -> Option<Vec<[u32; 3]>> {
    let list: Vec<u32> = match primitive.indices {
        Some(indices) => accessor(document, indices, &document.root).ok()?.integers()?,
        None => (0..u32::try_from(vertex_count).ok()?).collect(),
    };
    if list.iter().any(|&vertex| vertex as usize >= vertex_count) {
        return None;
    }
    let triangles: Vec<[u32; 3]> = match primitive.mode {
        TRIANGLES => list.as_chunks::<3>().0.to_vec(),
        5 => {
            let turned = |(i, window): (usize, &[u32; 3])| {
                let [a, b, c] = *window;
                if i % 2 == 0 { [a, b, c] } else { [b, a, c] }
            };
            list.array_windows().enumerate().map(turned).collect()
        }
        _ => list.get(1..)?.windows(2).map(|pair| [list[0], pair[0], pair[1]]).collect(),
    };
    let is_degenerate = |[a, b, c]: &[u32; 3]| a == b || b == c || c == a;
    let triangles: Vec<_> = triangles.into_iter().filter(|triangle| !is_degenerate(triangle)).collect();
    (!triangles.is_empty()).then_some(triangles)
}

/// Drops the vertices that no triangle uses.
fn used_vertices(mut triangles: Vec<[u32; 3]>, sources: &mut [VertexAttribute<'_>]) -> Option<Vec<[u32; 3]>> {
    let mut new_numbers = vec![None; sources.first()?.elements.count];
    let mut used = Vec::new();
    for vertex in triangles.as_flattened_mut() {
        let number = new_numbers[*vertex as usize].get_or_insert_with(|| {
            used.push(*vertex);
            used.len() as u32 - 1
        });
        *vertex = *number;
    }
    for source in sources {
        source.elements = source.elements.reordered(&used);
    }
    Some(triangles)
}

/// Encodes triangles, decodes them again, and describes the result.
fn encode(
    triangles: &[[u32; 3]],
    sources: &[VertexAttribute<'_>],
    (quantization, cube): Precision<'_>,
) -> Result<CodedPrimitive, String> {
    let mut mesh = Mesh::new();
    mesh.set_num_points(sources.first().map_or(0, |source| source.elements.count));
    let mut options = EncoderOptions::new();
    options.set_compression_level(LEVEL);
    let (mut ids, mut quantized_positions) = (Vec::new(), None);
    for source in sources {
        let id = mesh.add_attribute(attribute(source)?);
        if let Some(mut bits) = quantization.and_then(|quantization| bits(source, quantization)) {
            if let Some((corners, bits_in_cube)) = cube.filter(|_| source.name == "POSITION") {
                quantized_positions = Some((id, corners));
                bits = bits_in_cube;
            }
            options.set_attribute_quantization(id, bits as i32);
        }
        ids.push(mesh.attribute(id).unique_id());
    }
    for triangle in triangles {
        mesh.add_face(triangle.map(PointIndex));
    }
    mesh.finalize().map_err(|error| error.to_string())?;
    if let Some((id, corners)) = quantized_positions {
        let point_count = mesh.num_points();
        extend_range(mesh.attribute_mut(id), point_count, corners).map_err(|error| error.to_string())?;
    }
    described(bytes_of(mesh, &options)?, triangles, sources, &ids)
}

fn bytes_of(mesh: Mesh, options: &EncoderOptions) -> Result<Vec<u8>, String> {
    let (mut encoder, mut out) = (MeshEncoder::new(), EncoderBuffer::new());
    encoder.set_mesh(mesh);
    encoder.encode(options, &mut out).map_err(|error| error.to_string())?;
    Ok(out.data().to_vec())
}

/// Encodes integer positions and triangles as a Draco mesh by itself, without a container. Positions are kept exactly.
/// The decoded vertices have another order, and a vertex where parts of the surface only touch may be repeated.
///
/// # Errors
/// [`WriteError::BadMesh`] if a triangle has two equal corners or one that does not exist, or if Draco cannot encode
/// the mesh.
pub fn encode_draco(positions: &[[i32; 3]], triangles: &[[u32; 3]]) -> Result<Vec<u8>, WriteError> {
    contained(|| encode_integers(positions, triangles))
        .map_err(|reason| WriteError::BadMesh { file: "Draco".to_owned(), reason })
}

fn encode_integers(positions: &[[i32; 3]], triangles: &[[u32; 3]]) -> Result<Vec<u8>, String> {
    let position = |v: u32| positions.get(v as usize).ok_or_else(|| format!("vertex {v} does not exist"));
    for (number, corners) in triangles.iter().enumerate() {
        let [a, b, c] = [position(corners[0])?, position(corners[1])?, position(corners[2])?];
        if a == b || b == c || c == a {
            return Err(format!("triangle {number} has two corners at the same place"));
        }
    }
    let mut attribute = PointAttribute::new();
    attribute
        .try_init(GeometryAttributeType::Position, 3, DataType::Int32, false, positions.len())
        .map_err(|error| error.to_string())?;
    let bytes: Vec<u8> = positions.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
    attribute.buffer_mut().write(0, &bytes);
    let mut mesh = Mesh::new();
    mesh.set_num_points(positions.len());
    mesh.add_attribute(attribute);
    for triangle in triangles {
        mesh.add_face(triangle.map(PointIndex));
    }
    mesh.finalize().map_err(|error| error.to_string())?;
    let mut options = EncoderOptions::new();
    options.set_compression_level(LEVEL);
    let bytes = bytes_of(mesh, &options)?;
    let triangle_count = draco_mesh::decode(&bytes, u64::MAX)?.num_faces();
    match triangle_count == triangles.len() {
        true => Ok(bytes),
        false => Err(format!("{triangle_count} of {} triangles are left", triangles.len())),
    }
}

/// Adds values that no point has. Draco quantizes values in the range of all of them, and takes no other one.
fn extend_range(
    attribute: &mut PointAttribute,
    point_count: usize,
    corners: [[f32; 3]; 2],
) -> Result<(), DracoError> {
    if attribute.is_mapping_identity() {
        let entries: Vec<_> = (0..point_count as u32).map(AttributeValueIndex).collect();
        attribute.set_explicit_mapping_from(&entries);
    }
    let (count, stride) = (attribute.size(), 3 * size_of::<f32>());
    attribute.resize_unique_entries(count + corners.len())?;
    let numbers = corners.as_flattened().iter();
    let bytes: Vec<u8> = numbers.flat_map(|number| number.to_le_bytes()).collect();
    attribute.buffer_mut().write(count * stride, &bytes);
    Ok(())
}

/// Decodes what was encoded, checks it, and describes it.
fn described(
    bytes: Vec<u8>,
    triangles: &[[u32; 3]],
    sources: &[VertexAttribute<'_>],
    ids: &[u32],
) -> Result<CodedPrimitive, String> {
    let decoded = draco_mesh::decode(&bytes, u64::MAX)?;
    let (point_count, triangle_count) = (decoded.num_points(), decoded.num_faces());
    if triangle_count > triangles.len()
        || triangle_count + collapsed_count(triangles, sources) < triangles.len()
    {
        return Err(format!("{triangle_count} of {} triangles are left", triangles.len()));
    }
    let mut attributes = Vec::new();
    for (source, &id) in sources.iter().zip(ids) {
        let found = decoded.attribute_by_unique_id(id).ok_or("an attribute is missing")?;
        let values = draco_mesh::values_of_points(found, point_count, source.elements.element_bytes())?;
        let elements = Elements { count: point_count, bytes: values, ..source.elements };
        let mut accessor = source.accessor.clone();
        for key in ["bufferView", "byteOffset", "sparse", "min", "max"] {
            remove(&mut accessor, key);
        }
        accessor["count"] = json!(point_count);
        if source.name == "POSITION" {
            elements.declare_bounds(&mut accessor);
        }
        attributes.push(CodedAttribute { name: source.name.to_owned(), id, accessor });
    }
    Ok(CodedPrimitive { bytes, attributes, index_count: triangle_count * 3, point_count })
}

/// Returns the number of triangles of which two corners have the same position; Draco drops them.
fn collapsed_count(triangles: &[[u32; 3]], sources: &[VertexAttribute<'_>]) -> usize {
    let Some(positions) = sources.iter().find(|source| source.name == "POSITION") else { return 0 };
    let size = positions.elements.element_bytes();
    let position = |vertex: u32| &positions.elements.bytes[vertex as usize * size..][..size];
    let is_collapsed = |triangle: &&[u32; 3]| {
        let [a, b, c] = triangle.map(position);
        a == b || b == c || c == a
    };
    triangles.iter().filter(is_collapsed).count()
}

fn attribute(source: &VertexAttribute<'_>) -> Result<PointAttribute, String> {
    let Elements { component, width, normalized, count, ref bytes } = source.elements;
    let data_type = match component {
        GltfComponentType::I8 => DataType::Int8,
        GltfComponentType::U8 => DataType::Uint8,
        GltfComponentType::I16 => DataType::Int16,
        GltfComponentType::U16 => DataType::Uint16,
        GltfComponentType::U32 => DataType::Uint32,
        GltfComponentType::F32 => DataType::Float32,
    };
    let mut attribute = PointAttribute::new();
    let width = u8::try_from(width).map_err(|error| error.to_string())?;
    attribute
        .try_init(kind(source), width, data_type, normalized, count)
        .map_err(|error| error.to_string())?;
    attribute.buffer_mut().write(0, bytes);
    Ok(attribute)
}

fn kind(source: &VertexAttribute<'_>) -> GeometryAttributeType {
    match source.name {
        "POSITION" => GeometryAttributeType::Position,
        "NORMAL" => GeometryAttributeType::Normal,
        name if name.starts_with("TEXCOORD_") => GeometryAttributeType::TexCoord,
        name if name.starts_with("COLOR_") => GeometryAttributeType::Color,
        _ => GeometryAttributeType::Generic,
    }
}

/// Returns the bits that an attribute of floats is quantized to; [`None`] if it is kept exactly.
fn bits(source: &VertexAttribute<'_>, quantization: &QuantizeOptions) -> Option<u32> {
    let bits = match (source.name, kind(source)) {
        (_, GeometryAttributeType::Position) => quantization.position_bits,
        (_, GeometryAttributeType::Normal) | ("TANGENT", _) => quantization.normal_bits.max(2),
        (_, GeometryAttributeType::TexCoord) => quantization.texcoord_bits,
        (_, GeometryAttributeType::Color) => quantization.color_bits,
        _ => return None,
    };
    (source.elements.component == GltfComponentType::F32).then_some(bits.clamp(1, 30))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_are_kept_exactly() {
        let points = [[0, 0, 65_535], [7, -1, 0], [1 << 30, 2, 2], [0, 9, 0]];
        let triangles = [[0, 1, 2], [2, 1, 3]];
        let mesh = draco_mesh::decode(&encode_draco(&points, &triangles).expect("a mesh"), u64::MAX);
        let mesh = mesh.expect("what was encoded can be decoded");
        let values =
            draco_mesh::values_of_points(mesh.attribute(0), mesh.num_points(), 12).expect("positions");
        let number = |bytes: &[u8; 4]| i32::from_le_bytes(*bytes);
        let mut decoded: Vec<i32> = values.as_chunks::<4>().0.iter().map(number).collect();
        let mut expected = points.as_flattened().to_vec();
        decoded.sort_unstable();
        expected.sort_unstable();
        assert_eq!(decoded, expected);
    }

    #[test]
    fn triangles_without_an_area_are_refused() {
        for (triangle, reason) in
            [([0, 1, 5], "vertex 5 does not exist"), ([0, 1, 2], "two corners at the same place")]
        {
            let refused = encode_draco(&[[0; 3], [1; 3], [0; 3]], &[triangle]).expect_err("a bad triangle");
            assert!(refused.to_string().contains(reason), "{refused}");
        }
    }
}
