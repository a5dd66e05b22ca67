//! A surface: vertices, indices and levels as Godot's buffers have them.
//!
//! Vertex data begin with all positions, followed by normal and tangent of each vertex as octahedral coordinates of 16 bits.
//! Attribute data have the color, four bytes, and up to two pairs of texture coordinates of each vertex. Front faces are
//! clockwise. Indices have 16 bits if there are at most 65,536 vertices.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use glam::{Vec2, Vec3};
use striata::mesh::{AttributeLayer, Bounds, IndexedMesh, LayerData, Semantic};

use crate::ordered::OrderedPrimitive;

const HAS_VERTEX: u64 = 1;
const HAS_NORMAL: u64 = 1 << 1;
const HAS_TANGENT: u64 = 1 << 2;
const HAS_COLOR: u64 = 1 << 3;
const HAS_UV: [u64; 2] = [1 << 4, 1 << 5];
const HAS_INDEX: u64 = 1 << 12;
/// Version of the format of surfaces.
const FORMAT_VERSION: u64 = 1 << 35;

/// Most vertices whose indices have 16 bits.
const MAX_SHORT_VERTICES: usize = 1 << 16;

/// Whether surfaces have a place for data of vertices.
pub(super) fn is_written(semantic: &Semantic) -> bool {
    use Semantic::{Color, Normal, Tangent, TexCoord};
    matches!(semantic, Normal | Tangent | Color(0) | TexCoord(0 | 1))
}

/// Returns the text of a primitive; [`None`] if it has no triangles.
pub(super) fn surface_text(mesh: &IndexedMesh, primitive: &OrderedPrimitive) -> Option<String> {
    let full = primitive.ranges.first().filter(|range| range.index_count > 0)?;
    // Vertices of the primitive, which keep their order.
    let mut places = vec![u32::MAX; mesh.vertex_count()];
    primitive.indices.iter().for_each(|&vertex| places[vertex as usize] = 0);
    let vertices: Vec<u32> = (0..mesh.vertex_count() as u32).filter(|&v| places[v as usize] == 0).collect();
    (0..).zip(&vertices).for_each(|(place, &vertex)| places[vertex as usize] = place);
    let buffers = VertexBuffers::new(mesh, &vertices);
    let is_short = vertices.len() <= MAX_SHORT_VERTICES;
    let indices_of = |range: &striata::lod::IndexRange| {
        let indices = &primitive.indices[range.first_index..][..range.index_count];
        let (triangles, _) = indices.as_chunks::<3>();
        let turned = triangles.iter().flat_map(|&[a, b, c]| [a, c, b]).map(|vertex| places[vertex as usize]);
        packed(&match is_short {
            true => turned.flat_map(|place| (place as u16).to_le_bytes()).collect::<Vec<u8>>(),
            false => turned.flat_map(u32::to_le_bytes).collect(),
        })
    };
    // Keys of levels are errors, of which each can have one level: the coarsest.
    let mut levels: Vec<(f32, String)> = Vec::new();
    let mut last_count = full.index_count;
    for range in &primitive.ranges[1..] {
        if range.index_count == 0 || range.index_count == last_count {
            continue;
        }
        last_count = range.index_count;
        let error = range.error.max(f32::MIN_POSITIVE);
        levels.pop_if(|(before, _)| *before >= error);
        levels.push((error, indices_of(range)));
    }
    let Bounds { min, max } = Bounds::of(&buffers.positions)?;
    let size = [0, 1, 2].map(|axis| max[axis] - min[axis]);
    let [min, size] = [min, size].map(|numbers| numbers.map(|number| number.to_string()).join(", "));
    let mut text = format!("\"aabb\": AABB({min}, {size}),\n");
    if !buffers.attributes.is_empty() {
        let _ = writeln!(text, "\"attribute_data\": {},", packed(&buffers.attributes));
    }
    let _ = writeln!(text, "\"format\": {},", buffers.format);
    let _ = writeln!(text, "\"index_count\": {},", full.index_count);
    let _ = writeln!(text, "\"index_data\": {},", indices_of(full));
    if !levels.is_empty() {
        let entries: Vec<String> =
            levels.iter().map(|(error, indices)| format!("{error}, {indices}")).collect();
        let _ = writeln!(text, "\"lods\": [{}],", entries.join(", "));
    }
    let _ = writeln!(text, "\"vertex_count\": {},", vertices.len());
    let _ = writeln!(text, "\"vertex_data\": {},", packed(&buffers.vertices));
    Some(text)
}

fn packed(bytes: &[u8]) -> String {
    format!("PackedByteArray(\"{}\")", BASE64_STANDARD.encode(bytes))
}

/// The buffers of some vertices of a mesh.
struct VertexBuffers {
    positions: Vec<[f32; 3]>,
    vertices: Vec<u8>,
    attributes: Vec<u8>,
    format: u64,
}

impl VertexBuffers {
    fn new(mesh: &IndexedMesh, vertices: &[u32]) -> Self {
        let layer = |semantic: Semantic| mesh.layer(&semantic);
        let (normals, tangents) = (layer(Semantic::Normal), layer(Semantic::Tangent));
        let colors = layer(Semantic::Color(0));
        let uvs = [0, 1].map(|set| layer(Semantic::TexCoord(set)));
        let positions: Vec<[f32; 3]> = vertices.iter().map(|&v| mesh.positions[v as usize]).collect();
        let mut data: Vec<u8> = positions.as_flattened().iter().flat_map(|x| x.to_le_bytes()).collect();
        // Tangents are relative to normals.
        let tangents = tangents.filter(|_| normals.is_some());
        let mut attributes = Vec::new();
        for &vertex in vertices {
            let v = vertex as usize;
            let vector = |layer: &AttributeLayer| Vec3::from([0, 1, 2].map(|axis| layer.get(v, axis)));
            if let Some(normals) = normals {
                data.extend(sixteen_bits(octahedral(vector(normals))));
            }
            if let Some(tangents) = tangents {
                data.extend(sixteen_bits(octahedral_tangent(vector(tangents), tangents.get(v, 3))));
            }
            if let Some(colors) = colors {
                attributes.extend((0..4).map(|component| color_byte(colors, v, component)));
            }
            for uvs in uvs.into_iter().flatten() {
                attributes.extend([0, 1].into_iter().flat_map(|axis| uvs.get(v, axis).to_le_bytes()));
            }
        }
        let flags = [
            (true, HAS_VERTEX | HAS_INDEX | FORMAT_VERSION),
            (normals.is_some(), HAS_NORMAL),
            (tangents.is_some(), HAS_TANGENT),
            (colors.is_some(), HAS_COLOR),
            (uvs[0].is_some(), HAS_UV[0]),
            (uvs[1].is_some(), HAS_UV[1]),
        ];
        let format = flags.iter().filter(|(is_set, _)| *is_set).fold(0, |all, (_, flag)| all | flag);
        Self { positions, vertices: data, attributes, format }
    }
}

/// A color from 0 to 255; colors without alpha are opaque.
fn color_byte(colors: &AttributeLayer, vertex: usize, component: usize) -> u8 {
    if component >= colors.component_count as usize {
        return u8::MAX;
    }
    let value = colors.get(vertex, component);
    let value =
        if colors.normalized || matches!(colors.data, LayerData::F32(_)) { value } else { value / 255.0 };
    (value.clamp(0.0, 1.0) * 255.0).round() as u8
}

/// Maps a direction to the unit square.
fn octahedral(direction: Vec3) -> Vec2 {
    let sum = direction.abs().element_sum();
    let n = if sum > 0.0 && sum.is_finite() { direction / sum } else { Vec3::Z };
    let folded = if n.z >= 0.0 {
        Vec2::new(n.x, n.y)
    } else {
        (Vec2::ONE - Vec2::new(n.y, n.x).abs())
            * Vec2::new(n.x, n.y).map(|x| if x >= 0.0 { 1.0 } else { -1.0 })
    };
    0.5 * folded + 0.5
}

/// Maps a tangent to the unit square; the half of y is its handedness.
fn octahedral_tangent(direction: Vec3, handedness: f32) -> Vec2 {
    let Vec2 { x, y } = octahedral(direction);
    let half = 0.5 * y.max(1.0 / 32767.0) + 0.5;
    Vec2::new(x, if handedness >= 0.0 { half } else { 1.0 - half })
}

fn sixteen_bits(point: Vec2) -> [u8; 4] {
    let [[a, b], [c, d]] = point.to_array().map(|x| ((x * 65535.0).clamp(0.0, 65535.0) as u16).to_le_bytes());
    [a, b, c, d]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_have_the_bits_of_the_engine() {
        // What Godot 4.6 writes for these normals, and for tangents with their handedness.
        let normals = [
            (Vec3::Z, [0xff, 0x7f, 0xff, 0x7f]),
            (Vec3::X, [0xff, 0xff, 0xff, 0x7f]),
            (Vec3::Y, [0xff, 0x7f, 0xff, 0xff]),
            (-Vec3::Z, [0xff, 0xff, 0xff, 0xff]),
        ];
        for (normal, expected) in normals {
            assert_eq!(sixteen_bits(octahedral(normal)), expected, "{normal}");
        }
        let tangents = [
            (Vec3::X, 1.0, [0xff, 0xff, 0xff, 0xbf]),
            (Vec3::Y, -1.0, [0xff, 0x7f, 0x00, 0x00]),
            (Vec3::Z, 1.0, [0xff, 0x7f, 0xff, 0xbf]),
            (-Vec3::X, 1.0, [0x00, 0x00, 0xff, 0xbf]),
        ];
        for (tangent, handedness, expected) in tangents {
            assert_eq!(sixteen_bits(octahedral_tangent(tangent, handedness)), expected, "{tangent}");
        }
        assert_eq!(octahedral(Vec3::ZERO), octahedral(Vec3::Z));
        assert_eq!(octahedral(Vec3::NAN), octahedral(Vec3::Z));
    }
}
