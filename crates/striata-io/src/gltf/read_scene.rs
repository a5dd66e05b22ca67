//! Reads a document as a [`Scene`]: triangles and images apart, everything else unchanged.

use serde_json::{Map, Value};
use striata::mesh::IndexedMesh;

use super::appearance::images;
use super::assemble::mesh_of_primitives;
use super::carry::carry;
use super::compression;
use super::document::GltfDocument;
use super::extensions::are_all_carried;
use super::importance;
use super::json::JsonNode;
use super::numbering::settle;
use super::primitive::Primitive;
use super::references::{entries, has_triangles};
use crate::error::{Fault, Place};
use crate::repair::repair;
use crate::report::Warnings;
use crate::scene::{Scene, SceneParts, number_materials};

/// Refinement streams of meshes, which do not belong to the triangles of a scene once it is changed.
const STREAM_EXTENSION: &str = "STRIATA_lod";

/// Extensions that only concern the storage of geometry, which a scene does not keep.
const STORAGE_EXTENSIONS: [&str; 5] = [
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_mesh_quantization",
    STREAM_EXTENSION,
];

/// Reads the scene of a document.
pub(super) fn scene_of(document: &GltfDocument<'_>, warnings: &mut Warnings) -> Result<Scene, Fault> {
    let Value::Object(mut root) = document.root.value.clone() else {
        return Err(document.root.fault("the document is not an object"));
    };
    importance::check(&document.root, warnings)?;
    let numbers = settle(&mut root, warnings);
    let mut used_bytes = 0;
    let meshes = document.root.entries("meshes")?;
    let meshes: Vec<Option<IndexedMesh>> = meshes
        .iter()
        .zip(&numbers)
        .map(|(mesh, numbers)| triangles_of(document, mesh, numbers.as_deref(), &mut used_bytes, warnings))
        .collect::<Result<_, _>>()?;
    let is_geometry: Vec<bool> = meshes.iter().map(Option::is_some).collect();
    // An unknown extension may refer to accessors or buffer views by their numbers.
    let value = Value::Object(root);
    let keeps_numbers = !are_all_carried(&value);
    let Value::Object(mut root) = value else {
        return Err(document.root.fault("the document is not an object"));
    };
    let buffer = carry(document, &mut root, &is_geometry, keeps_numbers)?;
    clear_triangles(&mut root, &is_geometry);
    let images = images(document, warnings)?;
    let entries = root.get_mut("images").and_then(Value::as_array_mut).into_iter().flatten();
    for (entry, image) in entries.zip(&images) {
        let Some(entry) = entry.as_object_mut() else { continue };
        entry.remove("uri");
        entry.remove("bufferView");
        if !image.bytes.is_empty() && !image.mime_type.is_empty() {
            entry.insert("mimeType".to_owned(), Value::String(image.mime_type.clone()));
        }
    }
    drop_streams(&mut root);
    drop_storage_extensions(&mut root);
    let scene = Scene::from_parts(SceneParts { document: Value::Object(root), buffer, images, meshes });
    scene.map_err(|error| Fault::Malformed(error.place, error.reason))
}

/// Returns the mesh of all triangle primitives of a glTF mesh; [`None`] if they show nothing.
fn triangles_of(
    document: &GltfDocument<'_>,
    mesh: &JsonNode<'_>,
    numbers: Option<&str>,
    used_bytes: &mut u64,
    warnings: &mut Warnings,
) -> Result<Option<IndexedMesh>, Fault> {
    let mut primitives = Vec::new();
    for at in mesh.entries("primitives")? {
        if has_triangles(at.value) {
            primitives.extend(Primitive::parse(document, at)?);
        }
    }
    if primitives.is_empty() {
        return Ok(None);
    }
    // Files may store the vertices of all meshes together, so that each mesh uses a part of them.
    let mut whole = mesh_of_primitives(document, primitives, used_bytes, numbers)?;
    let mut found = Warnings::of_file(warnings.file());
    repair(&mut whole, &mut found);
    found.set_place(&Place::Json(mesh.path.clone()));
    warnings.append(found);
    let mut mesh = whole.without_unused_vertices();
    let shows_something = mesh.triangles.iter().any(|triangle| {
        let [a, b, c] = triangle.map(|vertex| mesh.positions[vertex as usize]);
        a != b && b != c && c != a
    });
    number_materials(&mut mesh);
    Ok(shows_something.then_some(mesh))
}

/// Replaces the accessors of triangle primitives by null, keeping the names of their attributes.
fn clear_triangles(root: &mut Map<String, Value>, is_geometry: &[bool]) {
    let meshes = root.get_mut("meshes").and_then(Value::as_array_mut).into_iter().flatten();
    for (mesh, _) in meshes.zip(is_geometry).filter(|&(_, &is_geometry)| is_geometry) {
        for primitive in entries(mesh, "primitives").filter(|primitive| has_triangles(primitive)) {
            let Some(primitive) = primitive.as_object_mut() else { continue };
            if primitive.get("mode").and_then(Value::as_u64) != Some(4) {
                primitive.remove("mode");
            }
            primitive.remove("indices");
            compression::remove_from(primitive);
            let targets = primitive.get_mut("targets").and_then(Value::as_array_mut);
            for target in targets.into_iter().flatten() {
                clear(target);
            }
            primitive.get_mut("attributes").map(clear);
        }
    }
}

fn clear(members: &mut Value) {
    members.as_object_mut().into_iter().flat_map(Map::values_mut).for_each(|value| *value = Value::Null);
}

/// Removes the references of meshes to their streams.
fn drop_streams(root: &mut Map<String, Value>) {
    let meshes = root.get_mut("meshes").and_then(Value::as_array_mut).into_iter().flatten();
    for mesh in meshes.filter_map(Value::as_object_mut) {
        let Some(Value::Object(extensions)) = mesh.get_mut("extensions") else { continue };
        if extensions.remove(STREAM_EXTENSION).is_some() && extensions.is_empty() {
            mesh.remove("extensions");
        }
    }
}

/// Removes extensions that no longer apply from the lists of the document.
fn drop_storage_extensions(root: &mut Map<String, Value>) {
    let has_other_primitives = root.get("accessors").is_some();
    for list in ["extensionsUsed", "extensionsRequired"] {
        let Some(Value::Array(names)) = root.get_mut(list) else { continue };
        names.retain(|name| {
            let name = name.as_str().unwrap_or("");
            // Points and lines that are carried may be quantized.
            !STORAGE_EXTENSIONS.contains(&name) || (name == "KHR_mesh_quantization" && has_other_primitives)
        });
        if names.is_empty() {
            root.remove(list);
        }
    }
}
