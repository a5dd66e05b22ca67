//! Encoding of attribute layers, groups, appearance and metadata.

use super::byte_reader::{SectionReader, put_block, put_texts, put_u32};
use super::error::{DecodeError, EncodeError};
use super::section_kind::SectionKind;
use crate::mesh::{
    Appearance, AttributeLayer, ColorSpace, Image, LayerData, Material, Semantic, TriangleGroup,
};

/// Value that means "no material" in a group.
const NO_MATERIAL: u32 = u32::MAX;

/// Size of a layer's header before its name: four bytes and three `u32`.
const LAYER_HEADER_BYTES: usize = 16;

/// Meaning of an attribute layer, as encoded in files and streams.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SemanticCode<'a> {
    /// Code of the meaning.
    pub kind: u8,
    /// Number of the set or morph target.
    pub set: u32,
    /// Name of a generic layer; empty for all others.
    pub name: &'a str,
}

/// Encodes the meaning of a layer for files and streams; [`semantic_of`] is the inverse.
pub fn semantic_code(semantic: &Semantic) -> SemanticCode<'_> {
    let numbered = |kind, set: u32| SemanticCode { kind, set, name: "" };
    match semantic {
        Semantic::Normal => numbered(0, 0),
        Semantic::Tangent => numbered(1, 0),
        Semantic::TexCoord(set) => numbered(2, u32::from(*set)),
        Semantic::Color(set) => numbered(3, u32::from(*set)),
        Semantic::Joints(set) => numbered(4, u32::from(*set)),
        Semantic::Weights(set) => numbered(5, u32::from(*set)),
        Semantic::MorphPosition(target) => numbered(6, u32::from(*target)),
        Semantic::MorphNormal(target) => numbered(7, u32::from(*target)),
        Semantic::MorphTangent(target) => numbered(8, u32::from(*target)),
        Semantic::Generic(name) => SemanticCode { kind: 9, set: 0, name },
    }
}

/// Decodes the meaning of a layer, the inverse of [`semantic_code`]; `None` if the code is unknown.
pub fn semantic_of(code: u8, set: u32, name: &str) -> Option<Semantic> {
    let (small, wide) = (u8::try_from(set).ok(), u16::try_from(set).ok());
    Some(match code {
        0 => Semantic::Normal,
        1 => Semantic::Tangent,
        2 => Semantic::TexCoord(small?),
        3 => Semantic::Color(small?),
        4 => Semantic::Joints(small?),
        5 => Semantic::Weights(small?),
        6 => Semantic::MorphPosition(wide?),
        7 => Semantic::MorphNormal(wide?),
        8 => Semantic::MorphTangent(wide?),
        9 => Semantic::Generic(name.to_owned()),
        _ => return None,
    })
}

/// Encodes a layer; [`layer_from_bytes`] is the inverse.
pub(super) fn layer_to_bytes(layer: &AttributeLayer) -> Result<Vec<u8>, EncodeError> {
    let SemanticCode { kind, set, name } = semantic_code(&layer.semantic);
    let number_type = layer.data.type_code() as u8;
    let mut out = vec![kind, number_type, layer.component_count, u8::from(layer.normalized)];
    put_u32(set, &mut out);
    let data_offset = (LAYER_HEADER_BYTES + name.len()).next_multiple_of(64);
    let what = "a layer's name";
    put_u32(
        u32::try_from(data_offset).map_err(|_| EncodeError::TooLong { what, length: name.len() })?,
        &mut out,
    );
    put_block(what, name.as_bytes(), &mut out)?;
    out.resize(data_offset, 0);
    out.extend_from_slice(layer.data.as_bytes());
    Ok(out)
}

/// Reads a layer: its header and the values of the first `vertex_count` of `full_vertex_count` vertices, or
/// triangles if `kind` is that of their layers.
pub(super) fn layer_from_bytes(
    kind: SectionKind,
    bytes: &[u8],
    vertex_count: usize,
    full_vertex_count: usize,
) -> Result<AttributeLayer, DecodeError> {
    let mut reader = SectionReader::new(kind, bytes);
    let [code, number_type, component_count, normalized] =
        [reader.u8()?, reader.u8()?, reader.u8()?, reader.u8()?];
    let (set, data_offset) = (reader.u32()?, reader.u32()? as usize);
    let name = reader.text()?;
    let Some(semantic) = semantic_of(code, set, &name) else {
        return Err(reader.malformed("unknown semantic of a layer"));
    };
    if component_count == 0 || normalized > 1 {
        return Err(reader.malformed("the component count is 0 or the normalized flag is over 1"));
    }
    let data = bytes.get(data_offset..).filter(|_| data_offset >= LAYER_HEADER_BYTES + name.len());
    let data = data.ok_or_else(|| reader.malformed("the values begin outside the section"))?;
    let Some(data_type) = LayerData::empty_of(number_type.into()) else {
        return Err(reader.malformed("unknown type of values"));
    };
    let number_bytes = data_type.component_bytes();
    let vertex_bytes = component_count as usize * number_bytes;
    let expected = full_vertex_count as u64 * vertex_bytes as u64;
    if data.len() as u64 != expected {
        return Err(DecodeError::Count { kind, what: "bytes of values", found: data.len() as u64, expected });
    }
    let data = &data[..vertex_count * vertex_bytes];
    let data = data_type.from_bytes_like(data);
    Ok(AttributeLayer { semantic, component_count, normalized: normalized == 1, data })
}

pub(super) fn groups_to_bytes(groups: &[TriangleGroup]) -> Result<Vec<u8>, EncodeError> {
    let mut out = Vec::new();
    put_u32(groups.len() as u32, &mut out);
    for group in groups {
        put_u32(group.count, &mut out);
        put_u32(group.material.unwrap_or(NO_MATERIAL), &mut out);
        put_block("a group's name", group.name.as_bytes(), &mut out)?;
    }
    Ok(out)
}

pub(super) fn groups_from_bytes(bytes: &[u8]) -> Result<Vec<TriangleGroup>, DecodeError> {
    let mut reader = SectionReader::new(SectionKind::GROUPS, bytes);
    let count = reader.count(12)?;
    let mut groups = Vec::with_capacity(count);
    let mut first = 0u32;
    for _ in 0..count {
        let (count, material, name) = (reader.u32()?, reader.u32()?, reader.text()?);
        let material = (material != NO_MATERIAL).then_some(material);
        groups.push(TriangleGroup { name, material, first, count });
        let next = first.checked_add(count);
        first =
            next.ok_or_else(|| reader.malformed("the groups have more triangles than 32 bits can count"))?;
    }
    reader.end()?;
    Ok(groups)
}

/// Last number of an appearance whose vertex colors are linear; sRGB has none.
const LINEAR: u32 = 1;
/// Tag of the place of a terrain, which is not there if unknown.
const GEOREFERENCE: u32 = 2;

/// Encodes materials, images and the rest of the appearance, as used in files and in the heads of streams.
///
/// # Errors
/// [`EncodeError::TooLong`] if a text or an image is too large for the format.
pub fn appearance_to_bytes(appearance: &Appearance) -> Result<Vec<u8>, EncodeError> {
    let mut out = Vec::new();
    put_u32(appearance.materials.len() as u32, &mut out);
    for material in &appearance.materials {
        put_block("a material's name", material.name.as_bytes(), &mut out)?;
        put_block("a material", material.gltf_json.as_bytes(), &mut out)?;
    }
    put_u32(appearance.images.len() as u32, &mut out);
    for image in &appearance.images {
        put_block("an image's name", image.name.as_bytes(), &mut out)?;
        put_block("an image's URI", image.uri.as_bytes(), &mut out)?;
        put_block("an image's type", image.mime_type.as_bytes(), &mut out)?;
        put_block("an image", &image.bytes, &mut out)?;
    }
    put_texts("a texture", &appearance.textures_json, &mut out)?;
    put_texts("a sampler", &appearance.samplers_json, &mut out)?;
    put_texts("an extension's name", &appearance.extensions_used, &mut out)?;
    put_texts("a material library's name", &appearance.material_libraries, &mut out)?;
    if appearance.color_space == ColorSpace::Linear {
        put_u32(LINEAR, &mut out);
    }
    if !appearance.georeference.is_empty() {
        put_u32(GEOREFERENCE, &mut out);
        put_block("the georeference", appearance.georeference.as_bytes(), &mut out)?;
    }
    Ok(out)
}

/// Decodes an appearance, the inverse of [`appearance_to_bytes`].
///
/// # Errors
/// [`DecodeError::Malformed`] if the bytes are invalid.
pub fn appearance_from_bytes(bytes: &[u8]) -> Result<Appearance, DecodeError> {
    let mut reader = SectionReader::new(SectionKind::APPEARANCE, bytes);
    let mut appearance = Appearance::default();
    for _ in 0..reader.count(8)? {
        appearance.materials.push(Material { name: reader.text()?, gltf_json: reader.text()? });
    }
    for _ in 0..reader.count(16)? {
        appearance.images.push(Image {
            name: reader.text()?,
            uri: reader.text()?,
            mime_type: reader.text()?,
            bytes: reader.block()?.to_vec(),
        });
    }
    appearance.textures_json = reader.texts()?;
    appearance.samplers_json = reader.texts()?;
    appearance.extensions_used = reader.texts()?;
    appearance.material_libraries = reader.texts()?;
    while !reader.is_at_end() {
        match reader.u32()? {
            LINEAR => appearance.color_space = ColorSpace::Linear,
            GEOREFERENCE => appearance.georeference = reader.text()?,
            _ => return Err(reader.malformed("a property of the appearance is unknown")),
        }
    }
    reader.end()?;
    Ok(appearance)
}

/// Encodes key-value texts as the contents of a `META` section; [`Container::metadata`](super::Container)
/// reads them.
///
/// # Errors
/// [`EncodeError::TooLong`] if a text is too large for the format.
pub fn metadata_to_bytes(metadata: &[(String, String)]) -> Result<Vec<u8>, EncodeError> {
    let mut out = Vec::new();
    put_u32(metadata.len() as u32, &mut out);
    for (key, value) in metadata {
        put_block("a metadata key", key.as_bytes(), &mut out)?;
        put_block("a metadata value", value.as_bytes(), &mut out)?;
    }
    Ok(out)
}

pub(super) fn metadata_from_bytes(bytes: &[u8]) -> Result<Vec<(String, String)>, DecodeError> {
    let mut reader = SectionReader::new(SectionKind::METADATA, bytes);
    let count = reader.count(8)?;
    let pairs =
        (0..count).map(|_| Ok((reader.text()?, reader.text()?))).collect::<Result<_, DecodeError>>()?;
    reader.end()?;
    Ok(pairs)
}
