//! Extensions that number the vertices or triangles of a primitive, which are others in a level.
//!
//! Features that are numbered by vertex (`EXT_mesh_features` without an attribute or a texture) get an
//! attribute, which follows the vertices. Outlines, polygons and edges of manifolds are left out with a
//! warning, and so is a doubt about unknown extensions.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Map, Value, json};

use super::extensions::{ExtensionUse, extension_use};
use super::references::{entries, has_triangles};
use crate::error::Place;
use crate::gltf_json::extensions_in;
use crate::report::{Warnings, shortened};

/// Makes the extensions of all triangle primitives independent of numbers; returns for each mesh the attribute
/// that must contain the numbers of its vertices in their accessors, if one must.
pub(super) fn settle(root: &mut Map<String, Value>, warnings: &mut Warnings) -> Vec<Option<String>> {
    let mut remarks: BTreeMap<String, (usize, Place)> = BTreeMap::new();
    let mut numbers = Vec::new();
    let mut has_removed = false;
    let meshes = root.get_mut("meshes").and_then(Value::as_array_mut).into_iter().flatten();
    for (index, mesh) in meshes.enumerate() {
        let place = format!("meshes[{index}]");
        has_removed |= drop_numbering(mesh, &place, &mut remarks);
        let mut attribute = None;
        if entries(mesh, "primitives").any(|primitive| implicit_features(primitive).next().is_some()) {
            attribute = Some(free_feature_attribute(mesh));
        }
        for (number, primitive) in entries(mesh, "primitives").enumerate() {
            if !has_triangles(primitive) {
                continue;
            }
            has_removed |= drop_numbering(primitive, &format!("{place}.primitives[{number}]"), &mut remarks);
            if let Some(set) = attribute {
                let mut has_implicit = false;
                for feature in implicit_features(primitive) {
                    feature["attribute"] = json!(set);
                    has_implicit = true;
                }
                if has_implicit {
                    primitive["attributes"][format!("_FEATURE_ID_{set}")] = Value::Null;
                }
            }
        }
        numbers.push(attribute.map(|set| format!("FEATURE_ID_{set}")));
    }
    for (what, (count, place)) in remarks {
        let objects = if count == 1 { String::new() } else { format!(", and {} more", count - 1) };
        warnings.push(place, format!("{what}{objects}"));
    }
    if has_removed {
        drop_unused_names(root);
    }
    numbers
}

/// Removes extensions of a mesh or primitive that number its parts; true if there was one.
fn drop_numbering(object: &mut Value, place: &str, remarks: &mut BTreeMap<String, (usize, Place)>) -> bool {
    let Some(Value::Object(extensions)) = object.get_mut("extensions") else { return false };
    let mut remark = |text: String| {
        remarks.entry(text).or_insert_with(|| (0, Place::Json(place.to_owned()))).0 += 1;
    };
    let count = extensions.len();
    extensions.retain(|name, value| match extension_use(name) {
        Some(ExtensionUse::Removed) => {
            remark(format!("{name} numbers vertices or triangles; it is left out"));
            false
        }
        None if has_numbers(value) => {
            let name = shortened(name);
            remark(format!(
                "{name} is unknown; it is kept, and may refer to vertices that a level does not have"
            ));
            true
        }
        _ => true,
    });
    let has_removed = extensions.len() < count;
    if extensions.is_empty()
        && let Some(object) = object.as_object_mut()
    {
        object.remove("extensions");
    }
    has_removed
}

/// Whether a value contains whole numbers, as references do.
fn has_numbers(value: &Value) -> bool {
    match value {
        Value::Number(number) => number.is_u64(),
        Value::Array(entries) => entries.iter().any(has_numbers),
        Value::Object(members) => members.iter().any(|(key, member)| key != "extras" && has_numbers(member)),
        _ => false,
    }
}

/// Sets of features that are numbered by vertex.
fn implicit_features(primitive: &mut Value) -> impl Iterator<Item = &mut Value> {
    let sets =
        primitive.pointer_mut("/extensions/EXT_mesh_features/featureIds").and_then(Value::as_array_mut);
    let is_implicit =
        |set: &&mut Value| set.is_object() && set.get("attribute").is_none() && set.get("texture").is_none();
    sets.into_iter().flatten().filter(is_implicit)
}

/// Number of the first attribute of features that no primitive of the mesh has.
fn free_feature_attribute(mesh: &mut Value) -> u64 {
    let mut taken = BTreeSet::new();
    for primitive in entries(mesh, "primitives") {
        let attributes = primitive.get("attributes").and_then(Value::as_object).into_iter().flatten();
        taken.extend(
            attributes.filter_map(|(name, _)| name.strip_prefix("_FEATURE_ID_")?.parse::<u64>().ok()),
        );
    }
    (0..).find(|number| !taken.contains(number)).unwrap_or(0)
}

/// Removes the names of extensions that were left out and that nothing else uses.
fn drop_unused_names(root: &mut Map<String, Value>) {
    let mut used = BTreeSet::new();
    for value in root.values() {
        extensions_in(value, &mut used);
    }
    for list in ["extensionsUsed", "extensionsRequired"] {
        let Some(Value::Array(names)) = root.get_mut(list) else { continue };
        names.retain(|name| {
            let name = name.as_str().unwrap_or("");
            extension_use(name) != Some(ExtensionUse::Removed) || used.contains(name)
        });
        if names.is_empty() {
            root.remove(list);
        }
    }
}
