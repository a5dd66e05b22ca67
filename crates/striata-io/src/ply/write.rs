//! PLY writer: all layers, binary little-endian or ASCII. PLY cannot store groups and materials.

use std::collections::BTreeSet;

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use crate::error::Refusal;
use crate::text::push_f32;

use super::header::Scalar;
use super::names::{generic_stem, property_names};

/// Encodes a mesh as a PLY file.
pub(crate) fn to_bytes(mesh: &IndexedMesh, ascii: bool) -> Result<Vec<u8>, Refusal> {
    let mut out = header(mesh, ascii)?.into_bytes();
    if ascii {
        push_ascii(mesh, &mut out);
    } else {
        push_binary(mesh, &mut out);
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

fn header(mesh: &IndexedMesh, ascii: bool) -> Result<String, Refusal> {
    let encoding = if ascii { "ascii" } else { "binary_little_endian" };
    let mut out = vertex_header(&mesh.layers, encoding, &mesh.positions.len().to_string())?;
    out += &format!("element face {}\nproperty list uchar int vertex_indices\n", mesh.triangles.len());
    out += "end_header\n";
    Ok(out)
}

/// The header up to the last property of vertices, whose values the layers need not have.
pub(crate) fn vertex_header(
    layers: &[AttributeLayer],
    encoding: &str,
    vertex_count: &str,
) -> Result<String, Refusal> {
    let mut out = format!("ply\nformat {encoding} 1.0\n");
    for layer in layers.iter().filter(|layer| layer.normalized) {
        if let Semantic::Generic(name) = &layer.semantic {
            let stem = generic_stem(name);
            out += &format!("comment normalized {}\n", stem.strip_prefix("generic_").unwrap_or(&stem));
        }
    }
    out += &format!("element vertex {vertex_count}\n");
    let mut names = BTreeSet::from(["x", "y", "z"].map(str::to_owned));
    for name in &names {
        out += &format!("property float {name}\n");
    }
    for layer in layers {
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

fn push_binary(mesh: &IndexedMesh, out: &mut Vec<u8>) {
    let row_bytes: usize = 12 + mesh.layers.iter().map(AttributeLayer::vertex_bytes).sum::<usize>();
    out.reserve_exact(row_bytes * mesh.positions.len() + 13 * mesh.triangles.len());
    for vertex in 0..mesh.positions.len() {
        push_row(&mesh.positions, &mesh.layers, vertex, out);
    }
    for triangle in &mesh.triangles {
        out.push(3);
        out.extend_from_slice(bytemuck::cast_slice(triangle));
    }
}

/// Appends the position of a vertex and its values in all layers.
#[inline]
pub(crate) fn push_row(positions: &[[f32; 3]], layers: &[AttributeLayer], vertex: usize, out: &mut Vec<u8>) {
    out.extend_from_slice(bytemuck::cast_slice(&positions[vertex]));
    for layer in layers {
        let length = layer.vertex_bytes();
        out.extend_from_slice(&layer.data.as_bytes()[vertex * length..][..length]);
    }
}

fn push_ascii(mesh: &IndexedMesh, out: &mut Vec<u8>) {
    for (vertex, position) in mesh.positions.iter().enumerate() {
        for &x in position {
            push_f32(out, x);
            out.push(b' ');
        }
        for layer in &mesh.layers {
            let count = layer.component_count as usize;
            for index in vertex * count..(vertex + 1) * count {
                push_number(out, &layer.data, index);
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

fn push_number(out: &mut Vec<u8>, data: &LayerData, index: usize) {
    let whole = match data {
        LayerData::F32(v) => return push_f32(out, v[index]),
        LayerData::U8(v) => u32::from(v[index]),
        LayerData::U16(v) => u32::from(v[index]),
        LayerData::U32(v) => v[index],
    };
    out.extend_from_slice(whole.to_string().as_bytes());
}
