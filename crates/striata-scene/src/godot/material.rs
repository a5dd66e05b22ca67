//! Materials as the text of `StandardMaterial3D`.

use std::collections::BTreeSet;
use std::fmt;

use striata::mesh::ColorSpace;
use striata_io::linear_to_srgb;

use super::text::quoted;
use crate::drawn::{AlphaMode, Material, TextureUse, Wrap};

/// A material: names of properties and their values.
pub(super) struct MaterialText {
    properties: Vec<(&'static str, String)>,
    images: BTreeSet<usize>,
    /// Properties of the material that Godot has no place for.
    pub remarks: Vec<String>,
}

impl MaterialText {
    /// Writes a material without the images that are not known.
    pub(super) fn new(material: &Material, is_known: impl Fn(usize) -> bool) -> Self {
        let mut text = Self { properties: Vec::new(), images: BTreeSet::new(), remarks: Vec::new() };
        let name = &material.name;
        if !name.is_empty() {
            text.put("resource_name", quoted(name));
        }
        text.surface(material);
        let known = |texture: Option<TextureUse>| texture.filter(|texture| is_known(texture.image));
        let base = known(material.base_color_texture);
        let rough = known(material.metallic_roughness_texture);
        let normal = known(material.normal_texture);
        let (occlusion, emissive) = (known(material.occlusion_texture), known(material.emissive_texture));
        text.put("albedo_color", color(material.base_color));
        text.texture("albedo_texture", base);
        text.put("metallic", material.metallic.to_string());
        text.put("roughness", material.roughness.to_string());
        if rough.is_some() {
            text.texture("metallic_texture", rough);
            text.put("metallic_texture_channel", "2".into());
            text.texture("roughness_texture", rough);
            text.put("roughness_texture_channel", "1".into());
        }
        if normal.is_some() {
            text.put("normal_enabled", "true".into());
            text.texture("normal_texture", normal);
            text.put("normal_scale", material.normal_scale.to_string());
        }
        if occlusion.is_some() {
            text.put("ao_enabled", "true".into());
            text.texture("ao_texture", occlusion);
            text.put("ao_texture_channel", "0".into());
            if occlusion.is_some_and(|texture| texture.uv_set == 1) {
                text.put("ao_on_uv2", "true".into());
            }
            if material.occlusion_strength != 1.0 {
                text.remarks.push(format!("the strength of the occlusion of material {name:?} is left out"));
            }
        }
        text.emission(material, emissive);
        text.coordinates([base, rough, normal, occlusion, emissive], name);
        text
    }

    fn put(&mut self, property: &'static str, value: String) {
        self.properties.push((property, value));
    }

    fn texture(&mut self, property: &'static str, texture: Option<TextureUse>) {
        if let Some(texture) = texture {
            self.images.insert(texture.image);
            self.put(property, format!("ExtResource(\"image_{}\")", texture.image));
        }
    }

    /// Transparency, back faces, and whether there is light.
    fn surface(&mut self, material: &Material) {
        match material.alpha_mode {
            AlphaMode::Opaque => {}
            AlphaMode::Mask(cutoff) => {
                self.put("transparency", "2".into());
                self.put("alpha_scissor_threshold", cutoff.to_string());
            }
            AlphaMode::Blend => self.put("transparency", "1".into()),
        }
        if material.is_double_sided {
            self.put("cull_mode", "2".into());
        }
        if material.is_unlit {
            self.put("shading_mode", "0".into());
        }
    }

    fn emission(&mut self, material: &Material, texture: Option<TextureUse>) {
        let strength = material.emissive.iter().copied().fold(0.0, f32::max);
        if strength <= 0.0 {
            return;
        }
        self.put("emission_enabled", "true".into());
        // Colors end at 1; the rest is energy.
        let energy = strength.max(1.0);
        let [r, g, b] = material.emissive.map(|x| x / energy);
        self.put("emission", color([r, g, b, 1.0]));
        self.put("emission_energy_multiplier", energy.to_string());
        if texture.is_some() {
            self.put("emission_operator", "1".into());
            self.texture("emission_texture", texture);
            if texture.is_some_and(|texture| texture.uv_set == 1) {
                self.put("emission_on_uv2", "true".into());
            }
        }
    }

    /// Sets, transforms and wrapping of texture coordinates, of which a material has one of each.
    fn coordinates(&mut self, textures: [Option<TextureUse>; 5], name: &str) {
        let in_material = if name.is_empty() { String::new() } else { format!(" of material {name:?}") };
        let [base, rough, normal, ..] = textures;
        let first = textures.into_iter().flatten().next();
        if [base, rough, normal].into_iter().flatten().any(|texture| texture.uv_set > 0)
            || textures.into_iter().flatten().any(|texture| texture.uv_set > 1)
        {
            self.remarks.push(format!("textures{in_material} use the first texture coordinates, not others"));
        }
        let Some(first) = first else { return };
        let others = || textures.into_iter().flatten();
        let [[a, b, u], [c, d, v]] = first.transform.0;
        if b != 0.0 || c != 0.0 || others().any(|texture| texture.transform != first.transform) {
            self.remarks.push(format!(
                "transforms of textures{in_material} are left out, which are turned or differ"
            ));
        } else if first.transform != crate::drawn::UvTransform::default() {
            self.put("uv1_scale", format!("Vector3({a}, {d}, 1)"));
            self.put("uv1_offset", format!("Vector3({u}, {v}, 0)"));
        }
        if others().all(|texture| texture.sampler.wrap == [Wrap::ClampToEdge; 2]) {
            self.put("texture_repeat", "false".into());
        } else if others().any(|texture| texture.sampler.wrap != [Wrap::Repeat; 2]) {
            self.remarks
                .push(format!("textures{in_material} repeat where they should be mirrored or clamped"));
        }
        if !first.sampler.is_smooth {
            // Nearest pixels, with reduced copies.
            self.put("texture_filter", "2".into());
        }
    }

    /// Multiplies the color with those of the vertices.
    pub(super) fn use_vertex_colors(&mut self, space: ColorSpace) {
        let property = "vertex_color_use_as_albedo";
        if self.properties.iter().any(|&(other, _)| other == property) {
            return;
        }
        self.put(property, "true".into());
        if space == ColorSpace::Srgb {
            self.put("vertex_color_is_srgb", "true".into());
        }
    }

    /// Images that the material refers to.
    pub(super) fn images(&self) -> impl Iterator<Item = usize> {
        self.images.iter().copied()
    }
}

impl fmt::Display for MaterialText {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.properties.iter().try_for_each(|(name, value)| writeln!(out, "{name} = {value}"))
    }
}

/// A color: Godot has colors of materials in sRGB.
fn color(linear: [f32; 4]) -> String {
    let [r, g, b, a] = linear;
    let [r, g, b] = [r, g, b].map(linear_to_srgb);
    format!("Color({r}, {g}, {b}, {})", a.clamp(0.0, 1.0))
}
