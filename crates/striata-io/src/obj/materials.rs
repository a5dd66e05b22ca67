//! Material libraries as glTF materials.
//!
//! | MTL | glTF | remark |
//! | --- | --- | --- |
//! | `Kd` | `baseColorFactor` | sRGB to linear as in three.js; linear already if Blender wrote the file |
//! | `map_Kd` | `baseColorTexture` | replaces `Kd` as in Blender and obj2gltf; it is often a default |
//! | `d`, `Tr` | alpha, `BLEND` | `d` wins; 0 counts as 1 as in obj2gltf: usually `Tr` is wrong |
//! | `map_d` | `MASK` at 0.5 | alpha of the base color image; `BLEND` if most of it is translucent |
//! | `Ke`, `map_Ke` | `emissiveFactor`, `emissiveTexture` | above 1: `KHR_materials_emissive_strength` |
//! | `norm`, `map_Bump` | `normalTexture` | see below; `-bm` is the scale |
//! | `Pr`, `Pm` | roughness, metallic | metallic is 0 without `Pm` |
//! | `map_Pr` | `metallicRoughnessTexture` | also with `map_Pm` if both are the same file |
//! | `Ns` | roughness | fourth root of `2 / (Ns + 2)`; 1 without highlight (`Ks` 0 or `illum` 0 or 1) |
//! | `illum 0` | `KHR_materials_unlit` | only with `map_Kd`: plain colors without light are outlines |
//! | `-s`, `-o` | `KHR_texture_transform` | with `v` flipped |
//! | `-clamp on` | sampler with `CLAMP_TO_EDGE` | |
//!
//! Blender, obj2gltf and many files use `map_Bump` for normal maps, three.js for height maps. glTF has no
//! height maps. So the image is a normal map unless it is gray; a gray one is left out with a warning.
//!
//! Blender writes linear colors and `Ns = 1000 (1 - roughness)^2`, which is inverted for its files. For other
//! files the exponent of the Blinn-Phong model is matched to that of a Beckmann distribution of the same
//! width, `alpha^2 = 2 / (Ns + 2)`, and glTF defines `alpha = roughness^2`.
//!
//! A base color and its `map_d` in another file are combined to one image. Metalness and roughness in different
//! files are left out with a warning.

use serde_json::{Value, json};

use super::mtl::{Definition, MapKind};
use super::texture_statement::TextureStatement;
use crate::color_space::srgb_to_linear;
use crate::error::Place;
use crate::gltf_json::number;
use crate::images::{has_alpha, is_gray};
use crate::report::Warnings;
use crate::texture_set::{TextureName, TextureSet, shortened};

/// Statement of a texture and the number of its file, if there is one.
type Map<'m> = Option<(&'m TextureStatement, usize)>;

/// Origin of a definition.
#[derive(Clone, Copy)]
pub(super) struct DefinitionOrigin<'l> {
    /// Name of the library in messages.
    pub file: &'l str,
    /// Folder of the library, relative to that of the source.
    pub folder: &'l str,
    pub is_from_blender: bool,
}

/// Converts definitions to glTF materials.
pub(super) struct Converter<'c, 'a> {
    pub textures: &'c mut TextureSet<'a>,
    pub warnings: &'c mut Warnings,
    /// Whether the mesh has texture coordinates; glTF forbids textures without them.
    pub has_texcoords: bool,
}

impl Converter<'_, '_> {
    /// Returns a definition as a glTF material.
    pub(super) fn material(&mut self, definition: &Definition, origin: DefinitionOrigin<'_>) -> Value {
        let mut material = MaterialDraft { definition, origin, converter: self, out: serde_json::Map::new() };
        material.out.insert("name".to_owned(), json!(definition.name));
        let base_color = material.base_color();
        let (base_color, alpha) = material.alpha(base_color);
        material.reflection(base_color, alpha);
        material.normals();
        material.emission();
        if definition.illumination == Some(0) && base_color.is_some() {
            material.extend("KHR_materials_unlit", json!({}));
        }
        Value::Object(material.out)
    }
}

/// A material under construction.
struct MaterialDraft<'m, 'c, 'a> {
    definition: &'m Definition,
    origin: DefinitionOrigin<'m>,
    converter: &'m mut Converter<'c, 'a>,
    out: serde_json::Map<String, Value>,
}

impl<'m> MaterialDraft<'m, '_, '_> {
    fn warn(&mut self, line: u64, reason: String) {
        self.converter.warnings.push_for(self.origin.file, Place::Line(line), reason);
    }

    /// Warns that a texture is left out.
    fn leave_out(&mut self, statement: &TextureStatement, reason: &str) {
        let reason = format!("texture `{}`: {reason}; it is left out", shortened(&statement.name));
        self.warn(statement.line, reason);
    }

    /// Returns a map and the number of its file, if the material has it.
    fn file_of(&mut self, kind: MapKind) -> Option<(&'m TextureStatement, usize)> {
        let statement = self.definition.maps.get(&kind)?;
        if !self.converter.has_texcoords {
            self.leave_out(statement, "the mesh has no texture coordinates");
            return None;
        }
        let (name, DefinitionOrigin { file, folder, .. }) = (&statement.name, self.origin);
        let texture = TextureName { name, folder, file, place: Place::Line(statement.line) };
        let file = self.converter.textures.file(&texture, self.converter.warnings)?;
        Some((statement, file))
    }

    /// Returns a reference to the texture of a file, with the options of its statement.
    fn texture_info(&mut self, statement: &TextureStatement, file: usize) -> Value {
        let mut info = json!({ "index": self.converter.textures.texture(file, statement.clamps) });
        if statement.has_transform() {
            let ([scale_u, scale_v], [offset_u, offset_v]) = (statement.scale, statement.offset);
            // MTL maps `v` to `scale * v + offset`, and glTF's `v` is one minus that of MTL.
            let offset = [offset_u, 1.0 - scale_v - offset_v].map(number);
            let transform = json!({ "scale": [number(scale_u), number(scale_v)], "offset": offset });
            info["extensions"] = json!({ "KHR_texture_transform": transform });
        }
        info
    }

    fn extend(&mut self, extension: &str, value: Value) {
        let extensions = self.out.entry("extensions").or_insert_with(|| json!({}));
        extensions[extension] = value;
    }

    /// Converts a color of the library to linear light.
    fn linear(&self, color: [f32; 3]) -> [f32; 3] {
        if self.origin.is_from_blender { color } else { color.map(srgb_to_linear) }
    }

    /// Returns the map of the base color.
    fn base_color(&mut self) -> Map<'m> {
        self.file_of(MapKind::Diffuse)
    }

    /// Sets the alpha mode, and returns the map of the base color with its opacity and the alpha of the base
    /// color factor.
    fn alpha(&mut self, base_color: Map<'m>) -> (Map<'m>, f32) {
        let Definition { opacity, transparency, line, .. } = *self.definition;
        let alpha = opacity.or(transparency.map(|t| 1.0 - t)).unwrap_or(1.0).clamp(0.0, 1.0);
        if let Some((mask, file)) = self.file_of(MapKind::Opacity)
            && let Some((base_color, mode)) = self.with_mask(base_color, mask, file)
        {
            self.out.insert("alphaMode".to_owned(), json!(mode));
            return (Some(base_color), 1.0);
        }
        if alpha == 0.0 {
            let name = shortened(&self.definition.name);
            self.warn(line, format!("material `{name}` would be invisible; its opacity 0 is taken as 1"));
            return (base_color, 1.0);
        }
        if alpha < 1.0 {
            self.out.insert("alphaMode".to_owned(), json!("BLEND"));
        }
        (base_color, alpha)
    }

    /// Returns the base color with the opacity of a mask, and its alpha mode; [`None`] with a warning if they
    /// cannot be combined.
    fn with_mask(
        &mut self,
        base_color: Map<'m>,
        mask: &'m TextureStatement,
        mask_file: usize,
    ) -> Option<((&'m TextureStatement, usize), &'static str)> {
        let textures = &mut self.converter.textures;
        if let Some((diffuse, file)) = base_color
            && (file == mask_file || has_alpha(textures.bytes(file)))
        {
            return Some(((diffuse, file), "MASK"));
        }
        if textures.bytes(mask_file).is_empty() {
            // The file is missing, for which there is a warning already.
            return None;
        }
        if base_color.is_some_and(|(diffuse, _)| (diffuse.scale, diffuse.offset) != (mask.scale, mask.offset))
        {
            self.leave_out(mask, "its coordinates are not those of the base color");
            return None;
        }
        match textures.masked(base_color.map(|(_, file)| file), mask_file, mask.channel) {
            Ok((file, is_translucent)) => {
                let statement = base_color.map_or(mask, |(diffuse, _)| diffuse);
                Some(((statement, file), if is_translucent { "BLEND" } else { "MASK" }))
            }
            Err(reason) => {
                self.leave_out(mask, &reason);
                None
            }
        }
    }

    /// Adds base color, metalness and roughness.
    fn reflection(&mut self, base_color: Map<'m>, alpha: f32) {
        let mut pbr = serde_json::Map::new();
        // An image that is only the mask is white.
        let has_color_image = base_color.is_some() && self.definition.maps.contains_key(&MapKind::Diffuse);
        let white = [1.0; 3];
        let [red, green, blue] = match self.definition.diffuse {
            Some(color) if !has_color_image => self.linear(color).map(|c| c.clamp(0.0, 1.0)),
            _ => white,
        };
        if [red, green, blue, alpha] != [1.0; 4] {
            let factor = [red, green, blue, alpha].map(number);
            pbr.insert("baseColorFactor".to_owned(), json!(factor));
        }
        if let Some((map, file)) = base_color {
            pbr.insert("baseColorTexture".to_owned(), self.texture_info(map, file));
        }
        let texture = self.metallic_roughness();
        let roughness = match self.definition.roughness {
            Some(roughness) => roughness.clamp(0.0, 1.0),
            None if texture.is_some() => 1.0,
            None => self.roughness_of_highlight(),
        };
        let is_textured_metal = texture.is_some() && self.definition.maps.contains_key(&MapKind::Metallic);
        let metallic = self.definition.metallic.unwrap_or(if is_textured_metal { 1.0 } else { 0.0 });
        pbr.insert("metallicFactor".to_owned(), number(metallic.clamp(0.0, 1.0)));
        pbr.insert("roughnessFactor".to_owned(), number(roughness));
        if let Some((map, file)) = texture {
            pbr.insert("metallicRoughnessTexture".to_owned(), self.texture_info(map, file));
        }
        self.out.insert("pbrMetallicRoughness".to_owned(), Value::Object(pbr));
    }

    /// Returns the texture of metalness and roughness, if no images have to be combined for it.
    fn metallic_roughness(&mut self) -> Option<(&'m TextureStatement, usize)> {
        let roughness = self.file_of(MapKind::Roughness);
        let metallic = self.file_of(MapKind::Metallic);
        let combined = "glTF combines metalness and roughness in one image";
        match (roughness, metallic) {
            (Some(roughness), Some(metallic)) if roughness.1 == metallic.1 => Some(roughness),
            // A gray map is right for roughness, and a metallic factor of 0 switches off its other channel.
            (Some(roughness), None) if self.definition.metallic.unwrap_or(0.0) <= 0.0 => Some(roughness),
            (roughness, metallic) => {
                for (statement, _) in roughness.into_iter().chain(metallic) {
                    self.leave_out(statement, combined);
                }
                None
            }
        }
    }

    /// Converts the exponent of the highlight to a roughness.
    fn roughness_of_highlight(&self) -> f32 {
        let Definition { exponent, specular, illumination, .. } = *self.definition;
        let exponent = exponent.unwrap_or(0.0).max(0.0);
        if self.origin.is_from_blender {
            return 1.0 - (exponent.min(1000.0) / 1000.0).sqrt();
        }
        if specular == Some([0.0; 3]) || matches!(illumination, Some(0 | 1)) {
            return 1.0;
        }
        (2.0 / (exponent + 2.0)).sqrt().sqrt()
    }

    fn normals(&mut self) {
        let kind = match self.definition.maps.contains_key(&MapKind::Normal) {
            true => MapKind::Normal,
            false => MapKind::Bump,
        };
        let Some((statement, file)) = self.file_of(kind) else { return };
        if is_gray(self.converter.textures.bytes(file)) {
            self.leave_out(statement, "glTF has no height maps");
            return;
        }
        let mut info = self.texture_info(statement, file);
        if statement.bump_scale != 1.0 {
            info["scale"] = number(statement.bump_scale);
        }
        self.out.insert("normalTexture".to_owned(), info);
    }

    fn emission(&mut self) {
        let map = self.file_of(MapKind::Emission);
        let color = self.definition.emission.unwrap_or_default().map(|c| c.max(0.0));
        let is_black = color == [0.0; 3];
        if let Some((map, file)) = map {
            let info = self.texture_info(map, file);
            self.out.insert("emissiveTexture".to_owned(), info);
        } else if is_black {
            return;
        }
        // The factor of a map is often left at its default, black.
        let color = if is_black { [1.0; 3] } else { color };
        let strength = color.into_iter().fold(1.0, f32::max);
        let factor = self.linear(color.map(|c| c / strength));
        self.out.insert("emissiveFactor".to_owned(), json!(factor.map(number)));
        if strength > 1.0 {
            let value = json!({ "emissiveStrength": number(strength) });
            self.extend("KHR_materials_emissive_strength", value);
        }
    }
}
