//! PLY writer: all layers, binary little-endian or ASCII. PLY cannot store groups and materials.

use std::borrow::{Borrow, Cow};
use std::collections::BTreeSet;

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use crate::color_space::byte_colors;
use crate::error::Refusal;
use crate::report::Warnings;
use crate::text::{push_f32, push_one_minus_f32};

use super::header::Scalar;
use super::names::{generic_stem, property_names};
use super::texcoords::{has_origin, with_bottom_origin};

/// Encodes a mesh as a PLY file.
pub(crate) fn to_bytes(mesh: &IndexedMesh, ascii: bool, warnings: &mut Warnings) -> Result<Vec<u8>, Refusal> {
    let layers: Vec<Cow<'_, AttributeLayer>> =
        mesh.layers.iter().map(|layer| byte_colors(layer, warnings)).collect();
    let mut out = header(mesh, &layers, ascii)?.into_bytes();
    if ascii {
        push_ascii(mesh, &layers, &mut out);
    } else {
        let layers: Vec<_> = layers.iter().map(|layer| with_bottom_origin(layer)).collect();
        push_binary(mesh, &layers, &mut out);
    }
    Ok(out)
}

fn scalar_of(data: &LayerData) -> Scalar {
    match data {
        LayerData::F32(_) => Scalar::F32,
        LayerData::U8(_) => Scalar::U8,
        LayerData::U16(_) => Scalar::U16,
        LayerData::U32(_) => Scalar::U32,
    }
}

fn header(mesh: &IndexedMesh, layers: &[Cow<'_, AttributeLayer>], ascii: bool) -> Result<String, Refusal> {
    let encoding = if ascii { "ascii" } else { "binary_little_endian" };
    let mut out = vertex_header(layers, &[], encoding, &mesh.positions.len().to_string())?;
    out += &format!("element face {}\nproperty list uchar int vertex_indices\n", mesh.triangles.len());
    out += "end_header\n";
    Ok(out)
}

/// The header up to the last property of vertices, whose values the layers need not have.
pub(crate) fn vertex_header(
    layers: &[impl Borrow<AttributeLayer>],
    texture_files: &[&str],
    encoding: &str,
    vertex_count: &str,
) -> Result<String, Refusal> {
    let mut out = format!("ply\nformat {encoding} 1.0\n");
    for layer in layers.iter().map(Borrow::borrow).filter(|layer| layer.normalized) {
        if let Semantic::Generic(name) = &layer.semantic {
            let stem = generic_stem(name);
            out += &format!("comment normalized {}\n", stem.strip_prefix("generic_").unwrap_or(&stem));
        }
    }
    for name in texture_files {
        out += &format!("comment TextureFile {name}\n");
    }
    out += &format!("element vertex {vertex_count}\n");
    let mut names = BTreeSet::from(["x", "y", "z"].map(str::to_owned));
    for name in &names {
        out += &format!("property float {name}\n");
    }
    for layer in layers.iter().map(Borrow::borrow) {
        let scalar = scalar_of(&layer.data).name();
        for name in property_names(layer) {
            out += &format!("property {scalar} {name}\n");
            if !names.insert(name) {
                return Err(Refusal::Unsupported(format!("two layers are called {}", layer.semantic)));
            }
        }
    }
    Ok(out)
}

fn push_binary(mesh: &IndexedMesh, layers: &[Cow<'_, AttributeLayer>], out: &mut Vec<u8>) {
    let row_bytes: usize = 12 + layers.iter().map(|layer| layer.vertex_bytes()).sum::<usize>();
    out.reserve_exact(row_bytes * mesh.positions.len() + 13 * mesh.triangles.len());
    for vertex in 0..mesh.positions.len() {
        push_row(&mesh.positions, layers, vertex, out);
    }
    for triangle in &mesh.triangles {
        out.push(3);
        out.extend_from_slice(bytemuck::cast_slice(triangle));
    }
}

/// Appends the position of a vertex and its values in all layers.
#[inline]
pub(crate) fn push_row(
    positions: &[[f32; 3]],
    layers: &[impl Borrow<AttributeLayer>],
    vertex: usize,
    out: &mut Vec<u8>,
) {
    out.extend_from_slice(bytemuck::cast_slice(&positions[vertex]));
    for layer in layers.iter().map(Borrow::borrow) {
        let length = layer.vertex_bytes();
        out.extend_from_slice(&layer.data.as_bytes()[vertex * length..][..length]);
    }
}

fn push_ascii(mesh: &IndexedMesh, layers: &[Cow<'_, AttributeLayer>], out: &mut Vec<u8>) {
    let flipped: Vec<bool> = layers.iter().map(|layer| has_origin(layer)).collect();
    for (vertex, position) in mesh.positions.iter().enumerate() {
        for &x in position {
            push_f32(out, x);
            out.push(b' ');
        }
        for (layer, &is_flipped) in layers.iter().zip(&flipped) {
            let count = layer.component_count as usize;
            for index in vertex * count..(vertex + 1) * count {
                push_number(out, &layer.data, index, is_flipped && index % 2 == 1);
                out.push(b' ');
            }
        }
        out.pop();
        out.push(b'\n');
    }
    for [a, b, c] in &mesh.triangles {
        out.extend_from_slice(format!("3 {a} {b} {c}\n").as_bytes());
    }
}

/// Appends a number; a texture coordinate with the other origin if `is_flipped` is set.
fn push_number(out: &mut Vec<u8>, data: &LayerData, index: usize, is_flipped: bool) {
    let whole = match data {
        LayerData::F32(v) if is_flipped => return push_one_minus_f32(out, v[index]),
        LayerData::F32(v) => return push_f32(out, v[index]),
        LayerData::U8(v) if is_flipped => u32::from(u8::MAX - v[index]),
        LayerData::U16(v) if is_flipped => u32::from(u16::MAX - v[index]),
        LayerData::U8(v) => u32::from(v[index]),
        LayerData::U16(v) => u32::from(v[index]),
        LayerData::U32(v) => v[index],
    };
    out.extend_from_slice(whole.to_string().as_bytes());
}
