//! Writer: each mesh becomes an object, and each of its instances a build item with a transform.

use std::collections::BTreeMap;
use std::io::{Cursor, Write as _};

use serde_json::Value;
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use crate::color_space::linear_to_srgb;
use crate::error::{Place, Refusal};
use crate::losses;
use crate::report::Warnings;
use crate::text::push_f32;
use crate::{Format, Scene, SceneError};

const TYPES: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
    <Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\
    <Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\
    <Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";

const RELATIONS: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
    <Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
    <Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" \
    Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

/// Identifier of the base materials; objects and color groups have the ones after it.
const MATERIALS_ID: u32 = 1;

/// Encodes one mesh, whose unit is taken for millimeters, as slicers do.
pub(crate) fn mesh_to_bytes(mesh: &IndexedMesh, warnings: &mut Warnings) -> Result<Vec<u8>, Refusal> {
    losses::of_group_names(mesh, Format::ThreeMf, warnings);
    let scene = Scene::from_mesh(mesh.clone()).map_err(refusal)?;
    to_bytes(&scene, "millimeter", warnings)
}

/// Encodes a scene, in the unit of the 3MF file that it comes from, or in the meters of glTF.
pub(crate) fn scene_to_bytes(scene: &Scene, warnings: &mut Warnings) -> Result<Vec<u8>, Refusal> {
    let unit = scene.document().pointer("/asset/extras/unit").and_then(Value::as_str);
    const UNITS: [&str; 6] = ["micron", "millimeter", "centimeter", "inch", "foot", "meter"];
    to_bytes(scene, unit.filter(|unit| UNITS.contains(unit)).unwrap_or("meter"), warnings)
}

fn refusal(error: SceneError) -> Refusal {
    Refusal::BadMesh(error.to_string())
}

fn to_bytes(scene: &Scene, unit: &str, warnings: &mut Warnings) -> Result<Vec<u8>, Refusal> {
    report_losses(scene, warnings);
    let model = model(scene, unit)?;
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    let written = (|| -> Result<Vec<u8>, zip::result::ZipError> {
        for (name, bytes) in [
            ("[Content_Types].xml", TYPES.as_bytes()),
            ("_rels/.rels", RELATIONS.as_bytes()),
            ("3D/3dmodel.model", &model),
        ] {
            archive.start_file(name, options)?;
            archive.write_all(bytes)?;
        }
        Ok(archive.finish()?.into_inner())
    })();
    written.map_err(|error| Refusal::Unsupported(error.to_string()))
}

/// Warns about everything that is not written.
fn report_losses(scene: &Scene, warnings: &mut Warnings) {
    let is_kept = |layer: &AttributeLayer| layer.semantic == Semantic::Color(0);
    for mesh in scene.meshes().iter().flatten() {
        losses::of_layers(mesh, Format::ThreeMf, is_kept, warnings);
    }
    let has =
        |key: &str| scene.document().get(key).and_then(Value::as_array).is_some_and(|list| !list.is_empty());
    for (key, what) in [("textures", "textures"), ("skins", "skins"), ("animations", "animations")] {
        if has(key) {
            warnings.push(Place::File, format!("3MF files are written without {what}"));
        }
    }
    let is_colored = |mesh: &IndexedMesh| mesh.layer(&Semantic::Color(0)).is_some();
    if has("materials") && scene.meshes().iter().flatten().any(is_colored) {
        warnings.push(Place::File, "meshes with colors of vertices are written without their materials");
    }
}

/// Returns the part with the model.
fn model(scene: &Scene, unit: &str) -> Result<Vec<u8>, Refusal> {
    let mut out = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"{unit}\" xml:lang=\"en-US\" \
         xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" \
         xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n"
    )
    .into_bytes();
    let document = scene.document();
    if let Some(Value::Object(metadata)) = document.pointer("/asset/extras/metadata") {
        for (name, value) in metadata {
            let value = value.as_str().unwrap_or("");
            push(&mut out, &format!("<metadata name=\"{}\">{}</metadata>\n", escaped(name), escaped(value)));
        }
    }
    push(&mut out, "<resources>\n");
    let has_materials = push_materials(&mut out, document);
    let mut next_id = MATERIALS_ID + 1;
    let mut object_of: BTreeMap<usize, u32> = BTreeMap::new();
    for instance in scene.instances() {
        let Some(mesh) = &scene.meshes()[instance.mesh] else { continue };
        if object_of.contains_key(&instance.mesh) || mesh.triangles.is_empty() {
            continue;
        }
        check_finite(mesh)?;
        let materials = if has_materials { scene.primitive_materials(instance.mesh) } else { Vec::new() };
        let colors = push_colors(&mut out, mesh, &mut next_id);
        push_object(
            &mut out,
            mesh,
            NamedObject { id: next_id, name: scene.mesh_name(instance.mesh) },
            &materials,
            colors.as_ref(),
        );
        object_of.insert(instance.mesh, next_id);
        next_id += 1;
    }
    push(&mut out, "</resources>\n<build>\n");
    for instance in scene.instances() {
        let Some(object) = object_of.get(&instance.mesh) else { continue };
        let matrix: Vec<String> =
            (0..16).filter(|i| i % 4 != 3).map(|i| instance.transform[i].to_string()).collect();
        let is_identity = instance.transform == super::model::IDENTITY;
        let transform =
            if is_identity { String::new() } else { format!(" transform=\"{}\"", matrix.join(" ")) };
        push(&mut out, &format!("<item objectid=\"{object}\"{transform}/>\n"));
    }
    push(&mut out, "</build>\n</model>\n");
    Ok(out)
}

fn push(out: &mut Vec<u8>, text: &str) {
    out.extend_from_slice(text.as_bytes());
}

fn check_finite(mesh: &IndexedMesh) -> Result<(), Refusal> {
    match mesh.positions.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
        Some(vertex) => {
            Err(Refusal::Unsupported(format!("vertex {vertex} has a coordinate that is not finite")))
        }
        None => Ok(()),
    }
}

/// Writes the materials of a document as base materials; false if there are none.
fn push_materials(out: &mut Vec<u8>, document: &Value) -> bool {
    let materials = document.get("materials").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    if materials.is_empty() {
        return false;
    }
    push(out, &format!("<basematerials id=\"{MATERIALS_ID}\">\n"));
    for (index, material) in materials.iter().enumerate() {
        let factor = material.pointer("/pbrMetallicRoughness/baseColorFactor").and_then(Value::as_array);
        let channel = |i: usize| factor.and_then(|factor| factor.get(i)?.as_f64()).unwrap_or(1.0) as f32;
        let color = hex([0, 1, 2, 3].map(|i| if i < 3 { linear_to_srgb(channel(i)) } else { channel(i) }));
        let name = material.get("name").and_then(Value::as_str).unwrap_or("");
        let name = if name.is_empty() { format!("material {index}") } else { escaped(name) };
        push(out, &format!("<base name=\"{name}\" displaycolor=\"{color}\"/>\n"));
    }
    push(out, "</basematerials>\n");
    true
}

/// Colors of a mesh: the group, and the entry of each vertex.
struct MeshColors {
    group: u32,
    entries: Vec<u32>,
}

/// Writes the distinct colors of the vertices as a group.
fn push_colors(out: &mut Vec<u8>, mesh: &IndexedMesh, next_id: &mut u32) -> Option<MeshColors> {
    let layer = mesh.layer(&Semantic::Color(0)).filter(|layer| matches!(layer.component_count, 3 | 4))?;
    let group = *next_id;
    *next_id += 1;
    push(out, &format!("<m:colorgroup id=\"{group}\">\n"));
    let mut entry_of: BTreeMap<String, u32> = BTreeMap::new();
    let entries = (0..mesh.positions.len()).map(|vertex| {
        let color = hex(color_at(layer, vertex));
        let count = entry_of.len() as u32;
        *entry_of.entry(color).or_insert_with_key(|color| {
            push(out, &format!("<m:color color=\"{color}\"/>\n"));
            count
        })
    });
    let entries = entries.collect();
    push(out, "</m:colorgroup>\n");
    Some(MeshColors { group, entries })
}

/// Returns an sRGB color with alpha.
fn color_at(layer: &AttributeLayer, vertex: usize) -> [f32; 4] {
    let has_alpha = layer.component_count == 4;
    [0, 1, 2, 3].map(|i| match i {
        3 if !has_alpha => 1.0,
        3 => layer.get(vertex, 3),
        _ => linear_to_srgb(layer.get(vertex, i)),
    })
}

fn hex(color: [f32; 4]) -> String {
    let [r, g, b, a] = color.map(|x| (x.clamp(0.0, 1.0) * 255.0).round() as u8);
    if a == 255 { format!("#{r:02X}{g:02X}{b:02X}") } else { format!("#{r:02X}{g:02X}{b:02X}{a:02X}") }
}

/// The number and the name of an object.
struct NamedObject<'a> {
    /// Number in the file.
    pub id: u32,
    /// Name for people.
    pub name: &'a str,
}

/// Writes a mesh as an object. Colors of vertices are written rather than materials, as they are more detailed.
fn push_object(
    out: &mut Vec<u8>,
    mesh: &IndexedMesh,
    NamedObject { id, name }: NamedObject<'_>,
    materials: &[Option<usize>],
    colors: Option<&MeshColors>,
) {
    let name = if name.is_empty() { String::new() } else { format!(" name=\"{}\"", escaped(name)) };
    push(out, &format!("<object id=\"{id}\" type=\"model\"{name}>\n<mesh>\n<vertices>\n"));
    for (vertex, position) in mesh.positions.iter().enumerate() {
        let file_position = mesh.needs_doubles().then(|| mesh.file_position(vertex));
        for (axis, text) in ["<vertex x=\"", "\" y=\"", "\" z=\""].into_iter().enumerate() {
            push(out, text);
            match file_position {
                Some(doubles) => push(out, &doubles[axis].to_string()),
                None => push_f32(out, position[axis]),
            }
        }
        push(out, "\"/>\n");
    }
    push(out, "</vertices>\n<triangles>\n");
    for (group, triangles) in mesh.groups_or_whole().iter().enumerate() {
        let material = materials.get(group).copied().flatten();
        for &[a, b, c] in &mesh.triangles[triangles.range()] {
            let property = match (colors, material) {
                (Some(MeshColors { group, entries }), _) => {
                    let [a, b, c] = [a, b, c].map(|vertex| entries[vertex as usize]);
                    if a == b && b == c {
                        format!(" pid=\"{group}\" p1=\"{a}\"")
                    } else {
                        format!(" pid=\"{group}\" p1=\"{a}\" p2=\"{b}\" p3=\"{c}\"")
                    }
                }
                (None, Some(material)) => format!(" pid=\"{MATERIALS_ID}\" p1=\"{material}\""),
                (None, None) => String::new(),
            };
            push(out, &format!("<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\"{property}/>\n"));
        }
    }
    push(out, "</triangles>\n</mesh>\n</object>\n");
}

/// Replaces what XML reserves; control characters, which it forbids, become blanks.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
