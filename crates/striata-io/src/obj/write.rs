//! OBJ writer: positions with colors, texture coordinates, normals, groups, and materials in a library of
//! their own (`mtl_write`). OBJ cannot store other layers.

use std::collections::BTreeSet;
use std::io::Write as _;
use std::path::Path;

use striata::mesh::{AttributeLayer, IndexedMesh, Material, Semantic};

use super::mtl_write;
use super::remarks::GEOREFERENCE;
use crate::error::Place;
use crate::image_files::ImageFiles;
use crate::report::{Warnings, shortened};
use crate::text::{push_coordinates, push_f32, push_one_minus_f32};
use crate::{Format, losses};

/// Encodes a mesh as an OBJ file, with the library and the images that belong next to it at `path`.
pub(crate) fn to_bytes(
    mesh: &IndexedMesh,
    path: Option<&Path>,
    images: &mut ImageFiles<'_>,
    warnings: &mut Warnings,
) -> Vec<u8> {
    let fitting = |semantic: &Semantic, counts: &[u8]| {
        mesh.layer(semantic).filter(|layer| counts.contains(&layer.component_count))
    };
    let color = fitting(&Semantic::Color(0), &[3, 4]);
    let texcoord = fitting(&Semantic::TexCoord(0), &[2]);
    let normal = fitting(&Semantic::Normal, &[3]);
    let mut out = Vec::with_capacity(mesh.positions.len() * 40 + mesh.triangles.len() * 24);
    let names = material_names(mesh);
    if !mesh.appearance.georeference.is_empty() {
        push_line(&mut out, GEOREFERENCE, &mesh.appearance.georeference);
    }
    for library in libraries(mesh, path, &names, images, warnings) {
        push_line(&mut out, "mtllib", &library);
    }
    warn_of_layers(mesh, [color, texcoord, normal], warnings);
    for vertex in 0..mesh.positions.len() {
        out.extend_from_slice(b"v ");
        push_coordinates(&mut out, mesh, vertex);
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
    push_groups(&mut out, mesh, &names, texcoord.is_some(), normal.is_some());
    if out.is_empty() {
        // A file without bytes is taken for one that was not written to its end.
        out.extend_from_slice(b"# no vertices\n");
    }
    out
}

/// Returns the names of the libraries: a new one if a material has a definition, otherwise those that the
/// mesh came with.
fn libraries(
    mesh: &IndexedMesh,
    path: Option<&Path>,
    names: &[String],
    images: &mut ImageFiles<'_>,
    warnings: &mut Warnings,
) -> Vec<String> {
    let known = mesh.appearance.material_libraries.clone();
    let Some(path) = path else { return known };
    let Some(text) = mtl_write::library(mesh, names, images, warnings) else {
        let folder = path.parent().unwrap_or(Path::new(""));
        for library in known.iter().filter(|library| !folder.join(library).exists()) {
            let reason = format!("the material library `{}` is not next to the file", shortened(library));
            warnings.push(Place::File, reason);
        }
        return known;
    };
    let file = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let lower = file.to_lowercase();
    let stem = match lower.find(".obj") {
        Some(end) if end > 0 && file.is_char_boundary(end) => &file[..end],
        _ => file.rsplit_once('.').map_or(file.as_str(), |(stem, _)| stem),
    };
    let wanted = format!("{}.mtl", stem.replace(|c: char| c.is_control(), "_"));
    vec![images.add(&wanted, text.into_bytes(), mtl_write::is_own, warnings)]
}

/// Warns about the layers that OBJ cannot store.
fn warn_of_layers(mesh: &IndexedMesh, kept: [Option<&AttributeLayer>; 3], warnings: &mut Warnings) {
    let is_kept = |layer: &AttributeLayer| kept.into_iter().flatten().any(|k| std::ptr::eq(k, layer));
    losses::of_layers(mesh, Format::Obj, is_kept, warnings);
    if kept[0].is_some_and(|color| color.component_count == 4) {
        warnings.push(Place::File, "OBJ cannot store the alpha of vertex colors; it is left out");
    }
}

/// Returns a name of its own for each material, in one line.
fn material_names(mesh: &IndexedMesh) -> Vec<String> {
    let mut taken = BTreeSet::new();
    let materials = mesh.appearance.materials.iter().enumerate();
    let name_of = |(index, material): (usize, &Material)| {
        let name = one_line(material.name.trim());
        let name = if name.is_empty() { format!("material_{index}") } else { name };
        let numbered = (2u32..).map(|number| format!("{name}_{number}"));
        let free = std::iter::once(name.clone()).chain(numbered).find(|name| !taken.contains(name));
        let free = free.unwrap_or(name);
        taken.insert(free.clone());
        free
    };
    materials.map(name_of).collect()
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

fn push_groups(
    out: &mut Vec<u8>,
    mesh: &IndexedMesh,
    names: &[String],
    has_texcoord: bool,
    has_normal: bool,
) {
    let groups = mesh.groups_or_whole();
    let (mut name, mut material) = ("", None);
    for group in groups.iter().filter(|group| group.count > 0) {
        if group.name != name {
            push_line(out, "g", &group.name);
        }
        if group.material != material {
            // A material without a definition is called by its index, because the statement needs a name.
            let name = |m: u32| names.get(m as usize).cloned().unwrap_or_else(|| format!("material_{m}"));
            push_line(out, "usemtl", &group.material.map(name).unwrap_or_default());
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

/// Writes one statement with a name; control characters in the name become blanks.
fn push_line(out: &mut Vec<u8>, keyword: &str, name: &str) {
    out.extend_from_slice(keyword.as_bytes());
    out.push(b' ');
    out.extend_from_slice(one_line(name).as_bytes());
    out.push(b'\n');
}

/// Returns a name without control characters, and without a backslash at its end, which would join the next
/// line.
fn one_line(name: &str) -> String {
    name.replace(|c: char| c.is_control(), " ").trim_end_matches('\\').to_owned()
}
