//! Extensions whose references to accessors and buffer views are known.

use serde_json::Value;

/// Which references an extension contains.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Contents {
    /// References to accessors, or none: a scene carries those accessors along under new numbers.
    Accessors,
    /// References that are visited, but that a scene carries along only under their old numbers.
    Views,
}

/// Extensions that refer to no accessors and buffer views, or only from places that `references` visits;
/// besides those of materials.
const KNOWN: [(&str, Contents); 29] = [
    ("AGI_articulations", Contents::Accessors),
    ("AGI_stk_metadata", Contents::Accessors),
    ("CESIUM_primitive_outline", Contents::Views),
    ("EXT_lights_ies", Contents::Views),
    ("EXT_lights_image_based", Contents::Accessors),
    ("EXT_mesh_features", Contents::Accessors),
    ("EXT_mesh_gpu_instancing", Contents::Accessors),
    ("EXT_meshopt_compression", Contents::Accessors),
    ("EXT_structural_metadata", Contents::Views),
    ("EXT_texture_avif", Contents::Accessors),
    ("EXT_texture_webp", Contents::Accessors),
    ("KHR_animation_pointer", Contents::Accessors),
    ("KHR_audio", Contents::Views),
    ("KHR_audio_emitter", Contents::Views),
    ("KHR_draco_mesh_compression", Contents::Accessors),
    ("KHR_lights_punctual", Contents::Accessors),
    ("KHR_mesh_quantization", Contents::Accessors),
    ("KHR_meshopt_compression", Contents::Accessors),
    ("KHR_node_hoverability", Contents::Accessors),
    ("KHR_node_selectability", Contents::Accessors),
    ("KHR_node_visibility", Contents::Accessors),
    ("KHR_texture_basisu", Contents::Accessors),
    ("KHR_texture_procedurals", Contents::Accessors),
    ("KHR_texture_transform", Contents::Accessors),
    ("KHR_xmp_json_ld", Contents::Accessors),
    ("MSFT_audio_emitter", Contents::Views),
    ("MSFT_lod", Contents::Accessors),
    ("MSFT_texture_dds", Contents::Accessors),
    ("STRIATA_lod", Contents::Accessors),
];

fn contents(extension: &str) -> Option<Contents> {
    let is_of_materials = extension.starts_with("KHR_materials_") || extension.starts_with("EXT_materials_");
    let listed = KNOWN.iter().find(|(name, _)| *name == extension).map(|&(_, contents)| contents);
    listed.or(is_of_materials.then_some(Contents::Accessors))
}

fn is_known(extension: &str) -> bool {
    contents(extension).is_some()
}

/// Whether all extensions that a document declares or uses are known.
pub(super) fn are_all_known(root: &Value) -> bool {
    let declared = root.get("extensionsUsed").and_then(Value::as_array).into_iter().flatten();
    declared.filter_map(Value::as_str).all(is_known) && used_within(root, is_known)
}

/// Whether a scene can renumber everything that the extensions of a document refer to.
pub(super) fn are_all_carried(root: &Value) -> bool {
    used_within(root, |extension| contents(extension) == Some(Contents::Accessors))
}

fn used_within(value: &Value, is_fine: fn(&str) -> bool) -> bool {
    match value {
        Value::Array(entries) => entries.iter().all(|entry| used_within(entry, is_fine)),
        Value::Object(members) => members.iter().all(|(key, member)| match key.as_str() {
            // Anything may be called an extension there.
            "extras" => true,
            "extensions" => {
                let extensions = member.as_object().into_iter().flatten();
                extensions.into_iter().all(|(name, value)| is_fine(name) && used_within(value, is_fine))
            }
            _ => used_within(member, is_fine),
        }),
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn unknown_extensions_are_found_anywhere_but_in_extras() {
        let with = |root: Value| (are_all_known(&root), are_all_carried(&root));
        assert_eq!(with(json!({})), (true, true));
        assert_eq!(with(json!({ "extensionsUsed": ["KHR_materials_sheen", "MSFT_lod"] })), (true, true));
        assert_eq!(with(json!({ "extensions": { "KHR_audio": {} } })), (true, false));
        assert_eq!(with(json!({ "extensionsUsed": ["VENDOR_x"] })), (false, true));
        assert_eq!(with(json!({ "nodes": [{ "extensions": { "VENDOR_x": {} } }] })), (false, false));
        let nested = json!({ "a": { "extensions": { "MSFT_lod": { "extensions": { "VENDOR_x": 1 } } } } });
        assert_eq!(with(nested), (false, false));
        assert_eq!(with(json!({ "extras": { "extensions": { "VENDOR_x": {} } } })), (true, true));
    }
}
