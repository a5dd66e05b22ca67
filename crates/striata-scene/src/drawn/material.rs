//! Materials of a document as numbers.

use serde_json::Value;
use striata_io::Scene;

use super::json::{extension, number, numbers};
use super::specular_glossiness::{Reflection, read_specular_glossiness};
use super::texture_use::{TextureReader, TextureUse};
use crate::document::entries;

/// How a surface covers what is behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum AlphaMode {
    /// Alpha is ignored.
    #[default]
    Opaque,
    /// The surface is visible where alpha is at least this cutoff.
    Mask(f32),
    /// Alpha is opacity.
    Blend,
}

/// A material as glTF defines it: metallic-roughness, or a plain color.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name; may be empty.
    pub name: String,
    /// Factor of the base color, linear light, and of alpha.
    pub base_color: [f32; 4],
    /// Image of the base color in sRGB, and of alpha.
    pub base_color_texture: Option<TextureUse>,
    /// Factor of metalness, 0 to 1.
    pub metallic: f32,
    /// Factor of roughness, 0 to 1.
    pub roughness: f32,
    /// Image of roughness (green) and metalness (blue).
    pub metallic_roughness_texture: Option<TextureUse>,
    /// Image of normals in tangent space.
    pub normal_texture: Option<TextureUse>,
    /// Factor of the x and y components of these normals.
    pub normal_scale: f32,
    /// Image of ambient occlusion (red).
    pub occlusion_texture: Option<TextureUse>,
    /// Strength of the occlusion, 0 to 1.
    pub occlusion_strength: f32,
    /// Emitted light, linear, including `KHR_materials_emissive_strength`.
    pub emissive: [f32; 3],
    /// Image of the emitted light in sRGB, a factor.
    pub emissive_texture: Option<TextureUse>,
    /// How the surface covers what is behind it.
    pub alpha_mode: AlphaMode,
    /// Whether the back of the surface is visible.
    pub is_double_sided: bool,
    /// Whether the base color is shown without any lighting.
    pub is_unlit: bool,
}

impl Default for Material {
    /// The material of primitives that have none: white, metallic and rough, as glTF defines it.
    fn default() -> Self {
        Self {
            name: String::new(),
            base_color: [1.0; 4],
            base_color_texture: None,
            metallic: 1.0,
            roughness: 1.0,
            metallic_roughness_texture: None,
            normal_texture: None,
            normal_scale: 1.0,
            occlusion_texture: None,
            occlusion_strength: 1.0,
            emissive: [0.0; 3],
            emissive_texture: None,
            alpha_mode: AlphaMode::Opaque,
            is_double_sided: false,
            is_unlit: false,
        }
    }
}

impl Material {
    /// Returns all references to images.
    pub fn textures(&self) -> impl Iterator<Item = &TextureUse> {
        let colors = [&self.base_color_texture, &self.emissive_texture];
        let numbers = [&self.metallic_roughness_texture, &self.normal_texture, &self.occlusion_texture];
        colors.into_iter().chain(numbers).flatten()
    }

    /// Removes references to images for which `is_known` is false. The material then looks as it does with
    /// a neutral image: white, flat, not metallic, and without emission.
    pub fn without_unknown_images(&mut self, is_known: impl Fn(usize) -> bool) {
        let is_missing = |texture: &mut TextureUse| !is_known(texture.image);
        self.base_color_texture.take_if(is_missing);
        self.normal_texture.take_if(is_missing);
        self.occlusion_texture.take_if(is_missing);
        if self.metallic_roughness_texture.take_if(is_missing).is_some() {
            (self.metallic, self.roughness) = (0.0, 1.0);
        }
        if self.emissive_texture.take_if(is_missing).is_some() {
            self.emissive = [0.0; 3];
        }
    }
}

/// Reads the materials of a scene; images are numbered as in [`Scene::images`].
pub fn materials(scene: &Scene) -> Vec<Material> {
    let textures = TextureReader { document: scene.document(), images: scene.images() };
    entries(scene.document(), "materials").iter().map(|material| read(material, &textures)).collect()
}

fn read(material: &Value, textures: &TextureReader<'_>) -> Material {
    let unit = |value: Option<f32>, default: f32| value.unwrap_or(default).clamp(0.0, 1.0);
    let empty = Value::Null;
    let pbr = material.get("pbrMetallicRoughness").unwrap_or(&empty);
    let of = |key: &str| material.get(key).unwrap_or(&empty);
    let strength = extension(material, "KHR_materials_emissive_strength");
    let strength = strength.and_then(|strength| number(strength, "emissiveStrength")).unwrap_or(1.0).max(0.0);
    let emissive: [f32; 3] = numbers(material, "emissiveFactor").unwrap_or([0.0; 3]);
    let found = Material {
        name: of("name").as_str().unwrap_or_default().to_owned(),
        base_color: numbers(pbr, "baseColorFactor").unwrap_or([1.0; 4]).map(|x: f32| x.clamp(0.0, 1.0)),
        base_color_texture: textures.read(pbr, "baseColorTexture"),
        metallic: unit(number(pbr, "metallicFactor"), 1.0),
        roughness: unit(number(pbr, "roughnessFactor"), 1.0),
        metallic_roughness_texture: textures.read(pbr, "metallicRoughnessTexture"),
        normal_texture: textures.read(material, "normalTexture"),
        normal_scale: number(of("normalTexture"), "scale").unwrap_or(1.0),
        occlusion_texture: textures.read(material, "occlusionTexture"),
        occlusion_strength: unit(number(of("occlusionTexture"), "strength"), 1.0),
        emissive: emissive.map(|x| (x.clamp(0.0, 1.0) * strength).min(f32::MAX)),
        emissive_texture: textures.read(material, "emissiveTexture"),
        alpha_mode: match of("alphaMode").as_str() {
            Some("MASK") => AlphaMode::Mask(number(material, "alphaCutoff").unwrap_or(0.5)),
            Some("BLEND") => AlphaMode::Blend,
            _ => AlphaMode::Opaque,
        },
        is_double_sided: of("doubleSided").as_bool().unwrap_or(false),
        is_unlit: extension(material, "KHR_materials_unlit").is_some(),
    };
    if let Some(other) = extension(material, "KHR_materials_pbrSpecularGlossiness") {
        let Reflection { base_color, base_color_texture, metallic, roughness } =
            read_specular_glossiness(other, textures);
        let metallic_roughness_texture = None;
        return Material {
            base_color,
            base_color_texture,
            metallic,
            roughness,
            metallic_roughness_texture,
            ..found
        };
    }
    found
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use striata_io::{Scene, SceneParts};

    use super::*;

    fn read_all(materials_json: Value) -> Vec<Material> {
        let document = json!({
            "asset": { "version": "2.0" },
            "images": [{}],
            "textures": [{ "source": 0 }],
            "materials": materials_json,
        });
        let images = vec![striata::mesh::Image::default()];
        let parts = SceneParts { document, images, ..SceneParts::default() };
        materials(&Scene::from_parts(parts).expect("a scene"))
    }

    #[test]
    fn an_empty_material_is_the_default_of_gltf() {
        assert_eq!(read_all(json!([{}])), vec![Material::default()]);
    }

    #[test]
    fn factors_modes_and_extensions_are_read() {
        let found = read_all(json!([{
            "name": "paint",
            "alphaMode": "MASK",
            "alphaCutoff": 0.25,
            "doubleSided": true,
            "emissiveFactor": [1, 0.5, 0],
            "normalTexture": { "index": 0, "scale": 0.5 },
            "occlusionTexture": { "index": 0, "strength": 0.75, "texCoord": 1 },
            "pbrMetallicRoughness": { "baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 7 },
            "extensions": {
                "KHR_materials_unlit": {},
                "KHR_materials_emissive_strength": { "emissiveStrength": 4 },
            },
        }]));
        let [paint] = &found[..] else { panic!("{found:?}") };
        assert_eq!(paint.alpha_mode, AlphaMode::Mask(0.25));
        assert_eq!((paint.emissive, paint.metallic), ([4.0, 2.0, 0.0], 1.0));
        assert_eq!((paint.normal_scale, paint.occlusion_strength), (0.5, 0.75));
        assert_eq!(paint.base_color, [0.1, 0.2, 0.3, 0.4]);
        assert!(paint.is_double_sided && paint.is_unlit);
        assert_eq!(paint.textures().map(|texture| texture.uv_set).collect::<Vec<_>>(), [0, 1]);
    }

    #[test]
    fn values_of_wrong_types_count_as_absent() {
        let found = read_all(json!([{
            "name": 3,
            "alphaMode": [],
            "emissiveFactor": [1, 2],
            "normalTexture": 7,
            "pbrMetallicRoughness": { "baseColorFactor": ["a", 1, 1, 1], "roughnessFactor": {} },
            "extensions": 5,
        }]));
        assert_eq!(found, vec![Material::default()]);
    }

    #[test]
    fn images_that_are_missing_leave_a_neutral_material() {
        let mut found = read_all(json!([{
            "emissiveFactor": [1, 1, 1],
            "emissiveTexture": { "index": 0 },
            "pbrMetallicRoughness": { "metallicRoughnessTexture": { "index": 0 } },
        }]));
        found[0].without_unknown_images(|_| true);
        assert_eq!(found[0].textures().count(), 2);
        found[0].without_unknown_images(|_| false);
        assert_eq!(found[0], Material { metallic: 0.0, ..Material::default() });
    }
}
