//! Places where a document refers to accessors and buffer views.

use serde_json::Value;

use super::entries_mut;

/// What a reference refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Referent {
    Accessor,
    View,
}

/// Visits all references but those of accessors to their views.
pub(super) fn visit(root: &mut Value, found: &mut impl FnMut(Referent, &mut Value)) {
    for mesh in entries_mut(root, "meshes") {
        if let Some(extension) = mesh.pointer_mut("/extensions/STRIATA_lod") {
            visit_member(extension, "bufferView", Referent::View, found);
        }
        for primitive in entries_mut(mesh, "primitives") {
            visit_primitive(primitive, found);
        }
    }
    for skin in entries_mut(root, "skins") {
        visit_member(skin, "inverseBindMatrices", Referent::Accessor, found);
    }
    for sampler in entries_mut(root, "animations").iter_mut().flat_map(|a| entries_mut(a, "samplers")) {
        visit_member(sampler, "input", Referent::Accessor, found);
        visit_member(sampler, "output", Referent::Accessor, found);
    }
    for image in entries_mut(root, "images") {
        visit_member(image, "bufferView", Referent::View, found);
    }
    for node in entries_mut(root, "nodes") {
        if let Some(attributes) = node.pointer_mut("/extensions/EXT_mesh_gpu_instancing/attributes") {
            visit_members(attributes, Referent::Accessor, found);
        }
    }
    for (extension, array) in
        [("KHR_audio", "audio"), ("KHR_audio_emitter", "audio"), ("MSFT_audio_emitter", "clips")]
    {
        let Some(extension) = root.pointer_mut(&format!("/extensions/{extension}")) else { continue };
        for clip in entries_mut(extension, array) {
            visit_member(clip, "bufferView", Referent::View, found);
        }
    }
    if let Some(extension) = root.pointer_mut("/extensions/EXT_structural_metadata") {
        for table in entries_mut(extension, "propertyTables") {
            let Some(Value::Object(properties)) = table.get_mut("properties") else { continue };
            for property in properties.values_mut() {
                for key in ["values", "arrayOffsets", "stringOffsets"] {
                    visit_member(property, key, Referent::View, found);
                }
            }
        }
    }
}

fn visit_primitive(primitive: &mut Value, found: &mut impl FnMut(Referent, &mut Value)) {
    if let Some(attributes) = primitive.get_mut("attributes") {
        visit_members(attributes, Referent::Accessor, found);
    }
    visit_member(primitive, "indices", Referent::Accessor, found);
    for target in entries_mut(primitive, "targets") {
        visit_members(target, Referent::Accessor, found);
    }
    for (extension, key, referent) in [
        ("KHR_draco_mesh_compression", "bufferView", Referent::View),
        ("CESIUM_primitive_outline", "indices", Referent::Accessor),
    ] {
        if let Some(extension) = primitive.pointer_mut(&format!("/extensions/{extension}")) {
            visit_member(extension, key, referent, found);
        }
    }
}

/// Visits the references of an accessor to its views.
pub(super) fn visit_views(accessor: &mut Value, found: &mut impl FnMut(&mut Value)) {
    let mut visit = |_: Referent, value: &mut Value| found(value);
    visit_member(accessor, "bufferView", Referent::View, &mut visit);
    for part in ["/sparse/indices", "/sparse/values"] {
        if let Some(part) = accessor.pointer_mut(part) {
            visit_member(part, "bufferView", Referent::View, &mut visit);
        }
    }
}

fn visit_member(
    object: &mut Value,
    key: &str,
    referent: Referent,
    found: &mut impl FnMut(Referent, &mut Value),
) {
    if let Some(value) = object.get_mut(key) {
        found(referent, value);
    }
}

fn visit_members(object: &mut Value, referent: Referent, found: &mut impl FnMut(Referent, &mut Value)) {
    for value in object.as_object_mut().into_iter().flat_map(|members| members.values_mut()) {
        found(referent, value);
    }
}
