//! Extensions that the passes know.

use serde_json::{Value, json};

use super::entries;

/// Extensions that refer to no accessors and buffer views, or only from places that `references` knows.
const KNOWN: [&str; 29] = [
    "AGI_articulations",
    "AGI_stk_metadata",
    "CESIUM_primitive_outline",
    "EXT_lights_ies",
    "EXT_lights_image_based",
    "EXT_mesh_features",
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "EXT_structural_metadata",
    "EXT_texture_avif",
    "EXT_texture_webp",
    "KHR_animation_pointer",
    "KHR_audio",
    "KHR_audio_emitter",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_mesh_quantization",
    "KHR_meshopt_compression",
    "KHR_node_hoverability",
    "KHR_node_selectability",
    "KHR_node_visibility",
    "KHR_texture_basisu",
    "KHR_texture_procedurals",
    "KHR_texture_transform",
    "KHR_xmp_json_ld",
    "MSFT_audio_emitter",
    "MSFT_lod",
    "MSFT_texture_dds",
    "STRIATA_lod",
];

/// Extensions of primitives that do not depend on the values of attributes.
const FREE_OF_VALUES: [&str; 3] = ["KHR_materials_variants", "EXT_mesh_features", "EXT_structural_metadata"];

/// Extensions of primitives that do not depend on the order of vertices and triangles either. Features may
/// be numbered by vertex.
const FREE_OF_ORDER: [&str; 1] = ["KHR_materials_variants"];

fn is_known(extension: &str) -> bool {
    KNOWN.contains(&extension)
        || extension.starts_with("KHR_materials_")
        || extension.starts_with("EXT_materials_")
}

/// Whether all extensions that a document uses are known.
pub(super) fn are_all_known(root: &Value) -> bool {
    let declared = entries(root, "extensionsUsed").iter().filter_map(Value::as_str);
    declared.into_iter().all(is_known) && objects_are_known(root)
}

fn objects_are_known(value: &Value) -> bool {
    match value {
        Value::Array(entries) => entries.iter().all(objects_are_known),
        Value::Object(members) => members.iter().all(|(key, member)| match key.as_str() {
            // Anything may be called an extension there.
            "extras" => true,
            "extensions" => match member.as_object() {
                Some(extensions) => {
                    extensions.iter().all(|(name, value)| is_known(name) && objects_are_known(value))
                }
                None => true,
            },
            _ => objects_are_known(member),
        }),
        _ => true,
    }
}

/// Whether the attributes of a primitive may change their values.
pub(super) fn are_free_of_values(extensions: &[String]) -> bool {
    extensions.iter().all(|name| FREE_OF_VALUES.contains(&name.as_str()))
}

/// Whether the vertices and triangles of a primitive may change their order.
pub(super) fn are_free_of_order(extensions: &[String]) -> bool {
    extensions.iter().all(|name| FREE_OF_ORDER.contains(&name.as_str()))
}

/// Declares that a document uses an extension, and cannot be read without it.
pub(super) fn require(root: &mut Value, extension: &str) {
    for key in ["extensionsUsed", "extensionsRequired"] {
        if !entries(root, key).iter().any(|name| name == extension) {
            super::push_entries(root, key, vec![json!(extension)]);
        }
    }
}
