//! PLY writer: all layers, binary little-endian or ASCII, and the images of materials (`write_textures`). PLY
//! cannot store names of groups, nor anything else of materials.

use std::borrow::{Borrow, Cow};
use std::collections::BTreeSet;

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use crate::color_space::byte_colors;
use crate::error::Refusal;
use crate::image_files::ImageFiles;
use crate::report::Warnings;
use crate::text::{push_coordinates, push_f32, push_f64, push_one_minus_f32};

use super::header::Scalar;
use super::names::{names_of_layers, plain_name};
use super::texcoords::{has_origin, one_minus_f64, with_bottom_origin};
use super::write_textures::{FaceTexcoords, WrittenTextures};

/// Encodes a mesh as a PLY file.
pub(crate) fn to_bytes(
    mesh: &IndexedMesh,
    ascii: bool,
    images: &mut ImageFiles<'_>,
    warnings: &mut Warnings,
) -> Result<Vec<u8>, Refusal> {
    let textures = WrittenTextures::of(mesh, images, warnings);
    let texcoords = FaceTexcoords::of(mesh, &textures);
    let layers: Vec<Cow<'_, AttributeLayer>> =
        mesh.layers.iter().map(|layer| byte_colors(layer, warnings)).collect();
    let face_layers: Vec<Cow<'_, AttributeLayer>> =
        mesh.triangle_layers.iter().map(|layer| byte_colors(layer, warnings)).collect();
    let mut out = header(mesh, &layers, &face_layers, &textures, ascii)?.into_bytes();
    if ascii {
        push_ascii(mesh, &layers, &face_layers, texcoords.as_ref(), &mut out);
    } else {
        let layers: Vec<_> = layers.iter().map(|layer| with_bottom_origin(layer)).collect();
        push_binary(mesh, &layers, &face_layers, texcoords.as_ref(), &mut out);
    }
    Ok(out)
}

fn scalar_of(data: &LayerData) -> Scalar {
    match data {
        LayerData::F32(_) => Scalar::F32,
        LayerData::U8(_) => Scalar::U8,
        LayerData::U16(_) => Scalar::U16,
        LayerData::U32(_) => Scalar::U32,
        LayerData::I8(_) => Scalar::I8,
        LayerData::I16(_) => Scalar::I16,
        LayerData::I32(_) => Scalar::I32,
        LayerData::F64(_) => Scalar::F64,
    }
}

fn header(
    mesh: &IndexedMesh,
    layers: &[Cow<'_, AttributeLayer>],
    face_layers: &[Cow<'_, AttributeLayer>],
    textures: &WrittenTextures,
    ascii: bool,
) -> Result<String, Refusal> {
    let encoding = if ascii { "ascii" } else { "binary_little_endian" };
    let face_names = names_of(face_layers, true);
    let mut comments = normalized_comments("normalized_face", face_layers, &face_names);
    let names: Vec<&str> = textures.names.iter().map(String::as_str).collect();
    let coordinate = if mesh.needs_doubles() { Scalar::F64 } else { Scalar::F32 };
    let vertex_count = mesh.positions.len().to_string();
    let mut out = vertex_header(coordinate, layers, &names, encoding, &vertex_count)?;
    comments += &georeference_comment(&mesh.appearance.georeference);
    out.insert_str(out.find("element").unwrap_or(out.len()), &comments);
    out += &format!("element face {}\nproperty list uchar int vertex_indices\n", mesh.triangles.len());
    if textures.numbers.is_some() {
        out += "property list uchar float texcoord\nproperty int texnumber\n";
    }
    let taken = ["vertex_indices", "vertex_index", "texcoord", "texnumber"];
    let taken = BTreeSet::from(taken.map(str::to_owned));
    push_properties(face_layers, face_names, taken, &mut out)?;
    out += "end_header\n";
    Ok(out)
}

fn names_of(layers: &[impl Borrow<AttributeLayer>], of_triangles: bool) -> Vec<Vec<String>> {
    names_of_layers(layers, |layer| scalar_of(&layer.data), of_triangles)
}

/// Comment that says where on the Earth a terrain is; empty if that is unknown.
pub(crate) fn georeference_comment(georeference: &str) -> String {
    if georeference.is_empty() {
        return String::new();
    }
    format!("comment georeference {}\n", georeference.replace(['\n', '\r'], " "))
}

/// Comments that name the generic layers whose integers stand for fractions.
fn normalized_comments(word: &str, layers: &[impl Borrow<AttributeLayer>], names: &[Vec<String>]) -> String {
    let mut out = String::new();
    for (layer, names) in layers.iter().map(Borrow::borrow).zip(names).filter(|(layer, _)| layer.normalized) {
        if let (Semantic::Generic(_), [first, ..]) = (&layer.semantic, &names[..]) {
            let stem = first.strip_suffix(".0").filter(|_| names.len() > 1).unwrap_or(first);
            out += &format!("comment {word} {}\n", plain_name(stem));
        }
    }
    out
}

/// Adds the properties of layers; `taken` are names that none of them may have.
fn push_properties(
    layers: &[impl Borrow<AttributeLayer>],
    names: Vec<Vec<String>>,
    mut taken: BTreeSet<String>,
    out: &mut String,
) -> Result<(), Refusal> {
    for (layer, names) in layers.iter().map(Borrow::borrow).zip(names) {
        let scalar = scalar_of(&layer.data).name();
        for name in names {
            *out += &format!("property {scalar} {name}\n");
            if !taken.insert(name) {
                return Err(Refusal::Unsupported(format!("two layers are called {}", layer.semantic)));
            }
        }
    }
    Ok(())
}

/// The header up to the last property of vertices, whose values the layers need not have.
pub(crate) fn vertex_header(
    coordinate: Scalar,
    layers: &[impl Borrow<AttributeLayer>],
    texture_files: &[&str],
    encoding: &str,
    vertex_count: &str,
) -> Result<String, Refusal> {
    let mut out = format!("ply\nformat {encoding} 1.0\n");
    let names = names_of(layers, false);
    out += &normalized_comments("normalized", layers, &names);
    for name in texture_files {
        out += &format!("comment TextureFile {name}\n");
    }
    out += &format!("element vertex {vertex_count}\n");
    let positions = ["x", "y", "z"];
    for name in positions {
        out += &format!("property {} {name}\n", coordinate.name());
    }
    push_properties(layers, names, BTreeSet::from(positions.map(str::to_owned)), &mut out)?;
    Ok(out)
}

fn push_binary(
    mesh: &IndexedMesh,
    layers: &[Cow<'_, AttributeLayer>],
    face_layers: &[Cow<'_, AttributeLayer>],
    texcoords: Option<&FaceTexcoords<'_>>,
    out: &mut Vec<u8>,
) {
    let bytes_of = |layers: &[Cow<'_, AttributeLayer>]| -> usize {
        layers.iter().map(|layer| layer.vertex_bytes()).sum()
    };
    let coordinate_bytes = if mesh.needs_doubles() { 24 } else { 12 };
    let (vertex_bytes, face_bytes) = (coordinate_bytes + bytes_of(layers), 13 + bytes_of(face_layers));
    out.reserve_exact(vertex_bytes * mesh.positions.len() + face_bytes * mesh.triangles.len());
    for vertex in 0..mesh.positions.len() {
        if mesh.needs_doubles() {
            out.extend_from_slice(bytemuck::cast_slice(&mesh.file_position(vertex)));
            push_values(layers, vertex, out);
        } else {
            push_row(&mesh.positions, layers, vertex, out);
        }
    }
    for (index, triangle) in mesh.triangles.iter().enumerate() {
        out.push(3);
        out.extend_from_slice(bytemuck::cast_slice(triangle));
        if let Some(texcoords) = texcoords {
            texcoords.push_binary(index, triangle, out);
        }
        push_values(face_layers, index, out);
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
    push_values(layers, vertex, out);
}

/// Appends the values of a vertex or triangle in all layers.
#[inline]
pub(crate) fn push_values(layers: &[impl Borrow<AttributeLayer>], index: usize, out: &mut Vec<u8>) {
    for layer in layers.iter().map(Borrow::borrow) {
        let length = layer.vertex_bytes();
        out.extend_from_slice(&layer.data.as_bytes()[index * length..][..length]);
    }
}

fn push_ascii(
    mesh: &IndexedMesh,
    layers: &[Cow<'_, AttributeLayer>],
    face_layers: &[Cow<'_, AttributeLayer>],
    texcoords: Option<&FaceTexcoords<'_>>,
    out: &mut Vec<u8>,
) {
    let flipped: Vec<bool> = layers.iter().map(|layer| has_origin(layer)).collect();
    for vertex in 0..mesh.positions.len() {
        push_coordinates(out, mesh, vertex);
        out.push(b' ');
        push_ascii_values(layers, vertex, Some(&flipped), out);
        out.pop();
        out.push(b'\n');
    }
    for (index, [a, b, c]) in mesh.triangles.iter().enumerate() {
        out.extend_from_slice(format!("3 {a} {b} {c} ").as_bytes());
        if let Some(texcoords) = texcoords {
            texcoords.push_ascii(index, [*a, *b, *c], out);
        }
        push_ascii_values(face_layers, index, None, out);
        out.pop();
        out.push(b'\n');
    }
}

/// Appends the values of a vertex or triangle, with a blank after each.
fn push_ascii_values(
    layers: &[Cow<'_, AttributeLayer>],
    index: usize,
    flipped: Option<&[bool]>,
    out: &mut Vec<u8>,
) {
    for (at, layer) in layers.iter().enumerate() {
        let is_flipped = flipped.is_some_and(|flipped| flipped[at]);
        let count = layer.component_count as usize;
        for value in index * count..(index + 1) * count {
            push_number(out, &layer.data, value, is_flipped && value % 2 == 1);
            out.push(b' ');
        }
    }
}

/// Appends a number; a texture coordinate with the other origin if `is_flipped` is set.
fn push_number(out: &mut Vec<u8>, data: &LayerData, index: usize, is_flipped: bool) {
    match data {
        LayerData::F32(v) if is_flipped => push_one_minus_f32(out, v[index]),
        LayerData::F32(v) => push_f32(out, v[index]),
        LayerData::F64(v) if is_flipped => push_f64(out, one_minus_f64(v[index])),
        LayerData::F64(v) => push_f64(out, v[index]),
        LayerData::U8(v) if is_flipped => push_integer(out, f64::from(u8::MAX - v[index])),
        LayerData::U16(v) if is_flipped => push_integer(out, f64::from(u16::MAX - v[index])),
        data => push_integer(out, data.number(index)),
    }
}

/// Appends an integer; a double represents all that layers contain.
fn push_integer(out: &mut Vec<u8>, value: f64) {
    out.extend_from_slice((value as i64).to_string().as_bytes());
}
