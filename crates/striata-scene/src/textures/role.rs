//! Meaning of the pixels of an image to the materials that use it.

use serde_json::{Map, Value};

#[cfg(feature = "textures")]
use super::srgb::{linear_of_bytes, srgb_byte};
use crate::document::entries;

/// Weight of a pixel that is invisible: it decides the color only if no visible pixel does.
#[cfg(feature = "textures")]
const INVISIBLE: f32 = 1e-3;

/// How the numbers of an image map to the quantity they stand for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum TextureTransfer {
    /// Colors in sRGB, which are averaged in linear light.
    #[default]
    Srgb,
    /// Plain numbers, such as roughness.
    Linear,
    /// Directions, which are averaged as vectors and have unit length afterward.
    Normal,
}

/// Meaning of the alpha channel of an image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum AlphaUse {
    /// No material looks at it.
    Unused,
    /// It is the opacity of the color: invisible pixels have no say in averages.
    Coverage,
    /// It is a number of its own, or its use is unknown.
    #[default]
    Data,
}

/// Meaning of the channels of an image: color and alpha.
///
/// The default, for images that no material uses, keeps all channels and treats them as colors.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct TextureRole {
    /// Meaning of the color channels.
    pub transfer: TextureTransfer,
    /// Meaning of the alpha channel.
    pub alpha: AlphaUse,
}

impl TextureRole {
    /// Color of a placeholder if the image cannot be decoded: a flat normal or white.
    pub fn neutral(self) -> [u8; 4] {
        match self.transfer {
            TextureTransfer::Normal => [128, 128, 255, 255],
            _ => [255; 4],
        }
    }

    /// Returns the numbers of a pixel that are averaged; colors with opacity are multiplied by it.
    #[cfg(feature = "textures")]
    pub fn numbers(self, [r, g, b, a]: [u8; 4]) -> [f32; 4] {
        let alpha = f32::from(a) / 255.0;
        let color = match self.transfer {
            TextureTransfer::Srgb => [r, g, b].map(|x| linear_of_bytes()[x as usize]),
            TextureTransfer::Linear => [r, g, b].map(|x| f32::from(x) / 255.0),
            TextureTransfer::Normal => [r, g, b].map(|x| f32::from(x) / 127.5 - 1.0),
        };
        match self.alpha {
            AlphaUse::Coverage => {
                let weight = alpha + INVISIBLE;
                [color[0] * weight, color[1] * weight, color[2] * weight, alpha]
            }
            AlphaUse::Unused => [color[0], color[1], color[2], 1.0],
            AlphaUse::Data => [color[0], color[1], color[2], alpha],
        }
    }

    /// Returns the pixel of such numbers, or of their average.
    #[cfg(feature = "textures")]
    pub fn pixel(self, [r, g, b, alpha]: [f32; 4]) -> [u8; 4] {
        let mut color = [r, g, b];
        if self.alpha == AlphaUse::Coverage {
            color = color.map(|x| x / (alpha + INVISIBLE));
        }
        let byte = |x: f32| (x * 255.0 + 0.5).clamp(0.0, 255.0) as u8;
        let [r, g, b] = match self.transfer {
            TextureTransfer::Srgb => color.map(srgb_byte),
            TextureTransfer::Linear => color.map(byte),
            TextureTransfer::Normal => {
                let length = color.iter().map(|x| x * x).sum::<f32>().sqrt();
                // Opposite directions may cancel out.
                let unit = if length > 1e-6 { color.map(|x| x / length) } else { [0.0, 0.0, 1.0] };
                unit.map(|x| byte((x + 1.0) * 0.5))
            }
        };
        [r, g, b, byte(alpha)]
    }

    /// Returns the role of an image that is used in both ways.
    fn and(self, other: Self) -> Self {
        let transfer = match (self.transfer, other.transfer) {
            (a, b) if a == b => a,
            // A color is what people see first.
            (TextureTransfer::Srgb, _) | (_, TextureTransfer::Srgb) => TextureTransfer::Srgb,
            _ => TextureTransfer::Linear,
        };
        let alpha = match (self.alpha, other.alpha) {
            (AlphaUse::Unused, other) => other,
            (own, AlphaUse::Unused) => own,
            (own, other) if own == other => own,
            _ => AlphaUse::Data,
        };
        Self { transfer, alpha }
    }
}

/// Returns the role of each image of a document, by the materials that refer to it.
///
/// The name of a reference says what it means, in extensions too: `normalTexture` and `...NormalTexture` are
/// directions; `baseColorTexture`, `emissiveTexture`, `diffuseTexture`, `specularGlossinessTexture` and
/// `...ColorTexture` are colors; all others are numbers.
pub fn image_roles(document: &Value) -> Vec<TextureRole> {
    let count = document.get("images").and_then(Value::as_array).map_or(0, Vec::len);
    let mut roles: Vec<Option<TextureRole>> = vec![None; count];
    for material in entries(document, "materials") {
        let has_coverage =
            matches!(material.get("alphaMode").and_then(Value::as_str), Some("MASK" | "BLEND"));
        for_each_texture(material, &mut |name, texture| {
            let role = role_of_reference(name, has_coverage);
            for image in images_of_texture(document, texture) {
                let Some(slot) = roles.get_mut(image) else { continue };
                *slot = Some(slot.map_or(role, |known| known.and(role)));
            }
        });
    }
    roles.into_iter().map(Option::unwrap_or_default).collect()
}

/// Returns the images that a material refers to, with the role of each reference.
pub(crate) fn images_of_material(document: &Value, material: usize) -> Vec<(usize, TextureRole)> {
    let mut found = Vec::new();
    let Some(material) = entries(document, "materials").get(material) else { return found };
    for_each_texture(material, &mut |name, texture| {
        let role = role_of_reference(name, false);
        found.extend(images_of_texture(document, texture).map(|image| (image, role)));
    });
    found
}

fn role_of_reference(name: &str, has_coverage: bool) -> TextureRole {
    let color = |alpha| TextureRole { transfer: TextureTransfer::Srgb, alpha };
    let coverage = if has_coverage { AlphaUse::Coverage } else { AlphaUse::Unused };
    match name {
        "baseColorTexture" | "diffuseTexture" => color(coverage),
        "specularGlossinessTexture" => color(AlphaUse::Data),
        "emissiveTexture" => color(AlphaUse::Unused),
        _ if name.ends_with("ColorTexture") => color(AlphaUse::Unused),
        _ if name == "normalTexture" || name.ends_with("NormalTexture") => {
            TextureRole { transfer: TextureTransfer::Normal, alpha: AlphaUse::Unused }
        }
        "metallicRoughnessTexture" | "occlusionTexture" => {
            TextureRole { transfer: TextureTransfer::Linear, alpha: AlphaUse::Unused }
        }
        // Extensions keep numbers in alpha, such as `specularTexture` and `sheenRoughnessTexture`.
        _ => TextureRole { transfer: TextureTransfer::Linear, alpha: AlphaUse::Data },
    }
}

/// Calls `visit` with the name of each texture reference and the texture's index, at any depth.
fn for_each_texture(value: &Value, visit: &mut dyn FnMut(&str, usize)) {
    let visit_members = |map: &Map<String, Value>, visit: &mut dyn FnMut(&str, usize)| {
        for (name, member) in map {
            let index = member.get("index").and_then(Value::as_u64).filter(|_| name.ends_with("Texture"));
            if let Some(index) = index.and_then(|index| usize::try_from(index).ok()) {
                visit(name, index);
            }
            for_each_texture(member, visit);
        }
    };
    match value {
        Value::Object(map) => visit_members(map, visit),
        Value::Array(entries) => entries.iter().for_each(|entry| for_each_texture(entry, visit)),
        _ => {}
    }
}

/// Returns the images of a texture: its own source and those of extensions.
fn images_of_texture(document: &Value, texture: usize) -> impl Iterator<Item = usize> {
    let texture = entries(document, "textures").get(texture);
    let extensions = texture.and_then(|texture| texture.get("extensions")?.as_object());
    let others = extensions.into_iter().flat_map(Map::values).filter_map(|extension| extension.get("source"));
    let own = texture.and_then(|texture| texture.get("source"));
    own.into_iter().chain(others).filter_map(|source| usize::try_from(source.as_u64()?).ok())
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn roles_follow_the_names_of_references() {
        let texture = |source: usize| json!({ "source": source });
        let document = json!({
            "images": [{}, {}, {}, {}, {}, {}, {}],
            "textures": [texture(0), texture(1), texture(2), texture(3), texture(4),
                { "extensions": { "EXT_texture_webp": { "source": 5 } } }],
            "materials": [
                {
                    "alphaMode": "BLEND",
                    "pbrMetallicRoughness": {
                        "baseColorTexture": { "index": 0 },
                        "metallicRoughnessTexture": { "index": 2 },
                    },
                    "normalTexture": { "index": 1 },
                    "occlusionTexture": { "index": 2 },
                    "extensions": {
                        "KHR_materials_clearcoat": { "clearcoatNormalTexture": { "index": 3 } },
                        "KHR_materials_sheen": { "sheenColorTexture": { "index": 5 } },
                        "KHR_materials_specular": { "specularTexture": { "index": 4 } },
                    },
                },
                { "emissiveTexture": { "index": 0 }, "normalTexture": { "index": 99 } },
            ],
        });
        let roles = image_roles(&document);
        let transfers: Vec<TextureTransfer> = roles.iter().map(|role| role.transfer).collect();
        use TextureTransfer::{Linear, Normal, Srgb};
        assert_eq!(transfers, [Srgb, Normal, Linear, Normal, Linear, Srgb, Srgb]);
        let alphas: Vec<AlphaUse> = roles.iter().map(|role| role.alpha).collect();
        use AlphaUse::{Coverage, Data, Unused};
        assert_eq!(alphas, [Coverage, Unused, Unused, Unused, Data, Unused, Data]);
        assert_eq!(images_of_material(&document, 1), vec![(0, roles[5])]);
        assert_eq!(roles[1].neutral(), [128, 128, 255, 255]);
    }
}
