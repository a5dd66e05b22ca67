//! Which image a texture shows: its own source, or that of an extension for a format beyond core glTF.

use std::collections::BTreeSet;

use serde_json::{Map, Value, json};

/// Extension for WebP images.
#[cfg(feature = "textures")]
const WEBP: &str = "EXT_texture_webp";

/// Extensions in which a texture names an image of another format.
const SOURCE_EXTENSIONS: [&str; 4] =
    ["EXT_texture_avif", "EXT_texture_webp", "KHR_texture_basisu", "MSFT_texture_dds"];

/// Removes extensions of textures whose image is among `images`, which became an image of core glTF; the
/// texture then shows its own source, or that image if it has none.
pub(crate) fn without_sources(document: &mut Value, images: &BTreeSet<usize>) {
    let textures = document.get_mut("textures").and_then(Value::as_array_mut).into_iter().flatten();
    for texture in textures.filter_map(Value::as_object_mut) {
        for name in SOURCE_EXTENSIONS {
            remove_source(texture, name, images);
        }
    }
    for name in SOURCE_EXTENSIONS {
        declare(document, name, false);
    }
}

fn remove_source(texture: &mut Map<String, Value>, name: &str, images: &BTreeSet<usize>) {
    let Some(Value::Object(extensions)) = texture.get_mut("extensions") else { return };
    let source = extensions.get(name).and_then(|extension| extension.get("source")).cloned();
    let is_core = |source: &Value| source.as_u64().is_some_and(|image| images.contains(&(image as usize)));
    let Some(source) = source.filter(is_core) else { return };
    extensions.remove(name);
    if extensions.is_empty() {
        texture.remove("extensions");
    }
    texture.entry("source").or_insert(source);
}

/// Moves sources into the extension for WebP if their image is among `images`, which became WebP.
#[cfg(feature = "textures")]
pub(super) fn with_webp_sources(document: &mut Value, images: &BTreeSet<usize>) {
    let textures = document.get_mut("textures").and_then(Value::as_array_mut).into_iter().flatten();
    for texture in textures.filter_map(Value::as_object_mut) {
        let source = texture.get("source").and_then(Value::as_u64).map(|source| source as usize);
        let Some(source) = source.filter(|source| images.contains(source)) else { continue };
        texture.remove("source");
        let extensions = texture.entry("extensions").or_insert_with(|| json!({}));
        if let Some(extensions) = extensions.as_object_mut() {
            extensions.entry(WEBP).or_insert_with(|| json!({ "source": source }));
        }
    }
    declare(document, WEBP, true);
}

/// Adds an extension of textures to the lists of the document if a texture uses it, and to the required
/// ones if a texture has no other source; removes it if no texture uses it and `only_adds` is false.
fn declare(document: &mut Value, name: &str, only_adds: bool) {
    let textures = document.get("textures").and_then(Value::as_array).into_iter().flatten();
    let (mut is_used, mut is_required) = (false, false);
    for texture in textures.filter(|texture| texture.pointer(&format!("/extensions/{name}")).is_some()) {
        is_used = true;
        is_required |= texture.get("source").is_none();
    }
    let Some(root) = document.as_object_mut() else { return };
    for (key, is_listed) in [("extensionsUsed", is_used), ("extensionsRequired", is_required)] {
        let mut names = match root.remove(key) {
            Some(Value::Array(names)) => names,
            Some(other) => {
                root.insert(key.to_owned(), other);
                continue;
            }
            None => Vec::new(),
        };
        let has_name = names.iter().any(|other| other.as_str() == Some(name));
        if is_listed && !has_name {
            names.push(json!(name));
        } else if !is_used && !only_adds {
            names.retain(|other| other.as_str() != Some(name));
        }
        if !names.is_empty() {
            root.insert(key.to_owned(), Value::Array(names));
        }
    }
}

#[cfg(all(test, feature = "textures"))]
mod tests {
    use super::*;

    #[test]
    fn sources_move_into_the_extension_and_back() {
        let before = json!({
            "asset": { "version": "2.0" },
            "extensionsUsed": ["KHR_materials_sheen"],
            "textures": [{ "source": 0 }, { "source": 1, "sampler": 0 }],
        });
        let mut document = before.clone();
        let images = BTreeSet::from([1]);
        with_webp_sources(&mut document, &images);
        assert_eq!(document["textures"][0], json!({ "source": 0 }));
        let texture = json!({ "sampler": 0, "extensions": { "EXT_texture_webp": { "source": 1 } } });
        assert_eq!(document["textures"][1], texture);
        assert_eq!(document["extensionsUsed"], json!(["KHR_materials_sheen", "EXT_texture_webp"]));
        assert_eq!(document["extensionsRequired"], json!(["EXT_texture_webp"]));
        without_sources(&mut document, &images);
        assert_eq!(document, before);
    }

    #[test]
    fn a_texture_with_a_fallback_shows_it() {
        let mut document = json!({
            "extensionsUsed": ["KHR_texture_basisu"],
            "textures": [{ "source": 0, "extensions": { "KHR_texture_basisu": { "source": 1 } } }],
        });
        without_sources(&mut document, &BTreeSet::from([1]));
        assert_eq!(document, json!({ "textures": [{ "source": 0 }] }));
    }
}
