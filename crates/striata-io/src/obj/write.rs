//! OBJ writer: positions with colors, texture coordinates, normals, groups, and names of materials and
//! libraries. OBJ cannot store other layers.

use std::io::Write as _;

use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};

use crate::text::{push_f32, push_one_minus_f32};

/// Encodes a mesh as an OBJ file.
pub(crate) fn to_bytes(mesh: &IndexedMesh) -> Vec<u8> {
    let fitting = |semantic: &Semantic, counts: &[u8]| {
        mesh.layer(semantic).filter(|layer| counts.contains(&layer.component_count))
    };
    let color = fitting(&Semantic::Color(0), &[3, 4]);
    let texcoord = fitting(&Semantic::TexCoord(0), &[2]);
    let normal = fitting(&Semantic::Normal, &[3]);
    let mut out = Vec::with_capacity(mesh.positions.len() * 40 + mesh.triangles.len() * 24);
    for library in &mesh.appearance.material_libraries {
        push_line(&mut out, "mtllib", library);
    }
    for (vertex, &[x, y, z]) in mesh.positions.iter().enumerate() {
        out.push(b'v');
        push_words(&mut out, [x, y, z]);
        if let Some(layer) = color {
            push_words(&mut out, [0, 1, 2].map(|c| layer.get(vertex, c)));
        }
        out.push(b'\n');
    }
    for vertex in 0..texcoord.map_or(0, |_| mesh.positions.len()) {
        push_texcoord(&mut out, texcoord, vertex);
    }
    if let Some(layer) = normal {
        for vertex in 0..mesh.positions.len() {
            out.extend_from_slice(b"vn");
            push_words(&mut out, [0, 1, 2].map(|c| layer.get(vertex, c)));
            out.push(b'\n');
        }
    }
    push_groups(&mut out, mesh, texcoord.is_some(), normal.is_some());
    if out.is_empty() {
        // A file without bytes is taken for one that was not written to its end.
        out.extend_from_slice(b"# no vertices\n");
    }
    out
}

fn push_words(out: &mut Vec<u8>, numbers: [f32; 3]) {
    for number in numbers {
        out.push(b' ');
        push_f32(out, number);
    }
}

fn push_texcoord(out: &mut Vec<u8>, layer: Option<&AttributeLayer>, vertex: usize) {
    let Some(layer) = layer else { return };
    out.extend_from_slice(b"vt ");
    push_f32(out, layer.get(vertex, 0));
    out.push(b' ');
    push_one_minus_f32(out, layer.get(vertex, 1));
    out.push(b'\n');
}

fn push_groups(out: &mut Vec<u8>, mesh: &IndexedMesh, has_texcoord: bool, has_normal: bool) {
    let groups = mesh.groups_or_whole();
    let (mut name, mut material) = ("", None);
    for group in groups.iter().filter(|group| group.count > 0) {
        if group.name != name {
            push_line(out, "g", &group.name);
        }
        if group.material != material {
            let material_name = group.material.map(|m| material_name(mesh, m)).unwrap_or_default();
            push_line(out, "usemtl", &material_name);
        }
        for triangle in &mesh.triangles[group.range()] {
            out.push(b'f');
            for number in triangle.map(|v| u64::from(v) + 1) {
                let written = match (has_texcoord, has_normal) {
                    (false, false) => write!(out, " {number}"),
                    (true, false) => write!(out, " {number}/{number}"),
                    (false, true) => write!(out, " {number}//{number}"),
                    (true, true) => write!(out, " {number}/{number}/{number}"),
                };
                debug_assert!(written.is_ok(), "writing to memory does not fail");
            }
            out.push(b'\n');
        }
        material = group.material;
        name = &group.name;
    }
}

/// Returns a material's name; a material without one is named by its index, because the statement needs a
/// name.
fn material_name(mesh: &IndexedMesh, material: u32) -> String {
    match mesh.appearance.materials.get(material as usize) {
        Some(known) if !known.name.trim().is_empty() => known.name.clone(),
        _ => format!("material_{material}"),
    }
}

/// Writes one statement with a name; control characters in the name become blanks.
fn push_line(out: &mut Vec<u8>, keyword: &str, name: &str) {
    out.extend_from_slice(keyword.as_bytes());
    out.push(b' ');
    let one_line = name.replace(|c: char| c.is_control(), " ");
    // A backslash at the end would join the next line.
    out.extend_from_slice(one_line.trim_end_matches('\\').as_bytes());
    out.push(b'\n');
}
