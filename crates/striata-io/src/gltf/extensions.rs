//! The extensions that are known: what happens to each, and which references it contains.
//!
//! A file may require any of them. The guide has the same table (`docs/guide/scenes.md`).

use serde_json::Value;

/// Treatment of an extension when a scene is read, drawn and written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExtensionUse {
    /// Understood by readers, pictures and the page, and written again.
    Drawn,
    /// Written as it was read.
    Carried,
    /// Written for the vertices and triangles of the level.
    Rewritten,
    /// Left out with a warning, because it numbers vertices or triangles, which levels do not have.
    Removed,
}

impl ExtensionUse {
    /// Name of the use, as the guide has it.
    pub const fn as_str(self) -> &'static str {
        match self {
            Self::Drawn => "drawn",
            Self::Carried => "carried",
            Self::Rewritten => "rewritten",
            Self::Removed => "removed",
        }
    }
}

/// Which references an extension contains.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Contents {
    /// References to accessors, or none: a scene carries those accessors along under new numbers.
    Accessors,
    /// References that are visited, but that a scene carries along only under their old numbers.
    Views,
}

use Contents::{Accessors, Views};
use ExtensionUse::{Carried, Drawn, Removed, Rewritten};

/// Extensions that refer to no accessors and buffer views, or only from places that `references` visits.
const KNOWN: [(&str, ExtensionUse, Contents); 51] = [
    ("AGI_articulations", Carried, Accessors),
    ("AGI_stk_metadata", Carried, Accessors),
    ("CESIUM_primitive_outline", Removed, Views),
    ("EXT_instance_features", Carried, Accessors),
    ("EXT_lights_ies", Carried, Views),
    ("EXT_lights_image_based", Carried, Accessors),
    ("EXT_mesh_features", Rewritten, Accessors),
    ("EXT_mesh_gpu_instancing", Drawn, Accessors),
    ("EXT_mesh_manifold", Removed, Views),
    ("EXT_meshopt_compression", Rewritten, Accessors),
    ("EXT_structural_metadata", Carried, Views),
    ("EXT_texture_avif", Carried, Accessors),
    ("EXT_texture_webp", Drawn, Accessors),
    ("FB_ngon_encoding", Removed, Accessors),
    ("KHR_animation_pointer", Carried, Accessors),
    ("KHR_audio", Carried, Views),
    ("KHR_audio_emitter", Carried, Views),
    ("KHR_draco_mesh_compression", Rewritten, Accessors),
    ("KHR_lights_punctual", Drawn, Accessors),
    ("KHR_materials_anisotropy", Carried, Accessors),
    ("KHR_materials_clearcoat", Carried, Accessors),
    ("KHR_materials_diffuse_transmission", Carried, Accessors),
    ("KHR_materials_dispersion", Carried, Accessors),
    ("KHR_materials_emissive_strength", Drawn, Accessors),
    ("KHR_materials_ior", Carried, Accessors),
    ("KHR_materials_iridescence", Carried, Accessors),
    ("KHR_materials_pbrSpecularGlossiness", Drawn, Accessors),
    ("KHR_materials_sheen", Carried, Accessors),
    ("KHR_materials_specular", Carried, Accessors),
    ("KHR_materials_transmission", Carried, Accessors),
    ("KHR_materials_unlit", Drawn, Accessors),
    ("KHR_materials_variants", Carried, Accessors),
    ("KHR_materials_volume", Carried, Accessors),
    ("KHR_mesh_quantization", Rewritten, Accessors),
    ("KHR_meshopt_compression", Rewritten, Accessors),
    ("KHR_node_hoverability", Carried, Accessors),
    ("KHR_node_selectability", Carried, Accessors),
    ("KHR_node_visibility", Carried, Accessors),
    ("KHR_texture_basisu", Carried, Accessors),
    ("KHR_texture_procedurals", Carried, Accessors),
    ("KHR_texture_transform", Drawn, Accessors),
    ("KHR_xmp", Carried, Accessors),
    ("KHR_xmp_json_ld", Carried, Accessors),
    ("MSFT_audio_emitter", Carried, Views),
    ("MSFT_lod", Carried, Accessors),
    ("MSFT_packing_normalRoughnessMetallic", Carried, Accessors),
    ("MSFT_packing_occlusionRoughnessMetallic", Carried, Accessors),
    ("MSFT_texture_dds", Carried, Accessors),
    ("STRIATA_clusters", Removed, Accessors),
    ("STRIATA_lod", Rewritten, Accessors),
    ("STRIATA_order", Removed, Accessors),
];

fn entry(extension: &str) -> Option<(ExtensionUse, Contents)> {
    // Materials refer to textures at most.
    let is_of_materials = extension.starts_with("KHR_materials_") || extension.starts_with("EXT_materials_");
    let listed =
        KNOWN.iter().find(|(name, ..)| *name == extension).map(|&(_, usage, contents)| (usage, contents));
    listed.or(is_of_materials.then_some((Carried, Accessors)))
}

/// Returns the treatment of an extension; [`None`] if it is unknown: it is kept as it is if the file does not
/// require it, and such a file is refused.
pub fn extension_use(extension: &str) -> Option<ExtensionUse> {
    entry(extension).map(|(usage, _)| usage)
}

/// Names of all extensions that are known, except others of materials, in order.
pub fn known_extensions() -> impl Iterator<Item = &'static str> {
    KNOWN.iter().map(|&(name, ..)| name)
}

fn contents(extension: &str) -> Option<Contents> {
    entry(extension).map(|(_, contents)| contents)
}

/// Whether a file may require an extension.
pub(super) fn is_known(extension: &str) -> bool {
    entry(extension).is_some()
}

/// Whether all extensions that a document declares or uses are known.
pub(crate) fn are_all_known(root: &Value) -> bool {
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
