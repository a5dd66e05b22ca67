//! Writer of material libraries: what `materials` reads, and glTF materials as far as MTL can express them.
//!
//! Each statement is the inverse of the one that is read, so that materials of OBJ files come back unchanged.
//! Whatever MTL has no statement for is left out with a warning.

use std::fmt::Write as _;

use serde_json::Value;
use striata::mesh::{Appearance, IndexedMesh};

use crate::color_space::{linear_to_srgb, srgb_to_linear};
use crate::error::Place;
use crate::gltf_json::{TextureInfo, float, floats};
use crate::image_files::ImageFiles;
use crate::report::{Warnings, shortened};

/// First line of our libraries, by which they are recognized.
const HEAD: &str = "# Written by striata\n";

/// Largest exponent of a highlight that programs accept.
const MAX_EXPONENT: f32 = 1000.0;

/// Whether a library is an earlier output of ours.
pub(super) fn is_own(bytes: &[u8]) -> bool {
    bytes.starts_with(HEAD.as_bytes())
}

/// Returns the library of the materials, which are called `names`; [`None`] if all of them are only names.
pub(super) fn library(
    mesh: &IndexedMesh,
    names: &[String],
    images: &mut ImageFiles<'_>,
    warnings: &mut Warnings,
) -> Option<String> {
    let mut out = HEAD.to_owned();
    for (material, name) in mesh.appearance.materials.iter().zip(names) {
        let Ok(value) = serde_json::from_str::<Value>(&material.gltf_json) else { continue };
        let (appearance, lost) = (&mesh.appearance, Vec::new());
        let mut writer = MaterialWriter { value: &value, appearance, images, warnings, lost, out: &mut out };
        writer.statements(name);
        let lost = std::mem::take(&mut writer.lost);
        for what in lost {
            let reason = format!("material `{}`: MTL cannot store {what}; it is left out", shortened(name));
            warnings.push(Place::File, reason);
        }
    }
    (out.len() > HEAD.len()).then_some(out)
}

/// Writes the statements of one material.
struct MaterialWriter<'w, 'i> {
    value: &'w Value,
    appearance: &'w Appearance,
    images: &'w mut ImageFiles<'i>,
    warnings: &'w mut Warnings,
    /// Names of the properties that MTL has no statement for.
    lost: Vec<String>,
    out: &'w mut String,
}

impl MaterialWriter<'_, '_> {
    fn statements(&mut self, name: &str) {
        self.line("\nnewmtl", name);
        let alpha = self.base_color();
        self.reflection();
        self.alpha(alpha);
        self.emission();
        self.normals();
        let is_unlit = self.value.pointer("/extensions/KHR_materials_unlit").is_some();
        self.line("illum", if is_unlit { "0" } else { "2" });
        self.remaining_members();
    }

    fn line(&mut self, keyword: &str, text: &str) {
        let written = writeln!(self.out, "{keyword} {text}");
        debug_assert!(written.is_ok(), "writing to memory does not fail");
    }

    /// Writes the base color, and returns its alpha.
    fn base_color(&mut self) -> f32 {
        let [red, green, blue, alpha] =
            floats(self.value.pointer("/pbrMetallicRoughness/baseColorFactor"), [1.0; 4]);
        self.line("Kd", &[red, green, blue].map(|c| srgb_text(c, 1.0)).join(" "));
        let has_texture = self.texture("/pbrMetallicRoughness/baseColorTexture", "map_Kd", "");
        if has_texture && [red, green, blue] != [1.0; 3] {
            self.lost.push("a color that the base color texture is multiplied with".to_owned());
        }
        alpha
    }

    fn reflection(&mut self) {
        let factor = |name: &str| float(self.value.pointer(&format!("/pbrMetallicRoughness/{name}")), 1.0);
        let (roughness, metallic) = (factor("roughnessFactor"), factor("metallicFactor"));
        self.line("Pr", &roughness.to_string());
        self.line("Pm", &metallic.to_string());
        // For programs that do not know `Pr`: the inverse of what is read from other files.
        let exponent = (2.0 / roughness.powi(4).max(1e-4) - 2.0).clamp(0.0, MAX_EXPONENT);
        self.line("Ns", &exponent.round().to_string());
        let pointer = "/pbrMetallicRoughness/metallicRoughnessTexture";
        self.texture(pointer, "map_Pr", "-imfchan g ");
        if metallic > 0.0 {
            self.texture(pointer, "map_Pm", "-imfchan b ");
        }
    }

    fn alpha(&mut self, alpha: f32) {
        let mode = self.value.get("alphaMode").and_then(Value::as_str).unwrap_or("OPAQUE");
        let cutoff = float(self.value.get("alphaCutoff"), 0.5);
        match mode {
            "BLEND" if alpha < 1.0 => self.line("d", &alpha.to_string()),
            "MASK" | "BLEND" => {
                self.texture("/pbrMetallicRoughness/baseColorTexture", "map_d", "");
                let pointer = "/pbrMetallicRoughness/baseColorTexture";
                if mode == "BLEND" && self.value.pointer(pointer).is_some() {
                    self.lost.push("the alpha mode BLEND, which is read as MASK".to_owned());
                }
                if mode == "MASK" && cutoff != 0.5 {
                    self.lost.push(format!("the alpha cutoff {cutoff}"));
                }
            }
            _ => {}
        }
    }

    fn emission(&mut self) {
        let factor = floats(self.value.get("emissiveFactor"), [0.0; 3]);
        let pointer = "/extensions/KHR_materials_emissive_strength/emissiveStrength";
        let strength = float(self.value.pointer(pointer), 1.0);
        if factor == [0.0; 3] {
            return;
        }
        let light = factor.map(|c| c * strength);
        // The brightest channel is the strength that is read.
        let strength = light.into_iter().fold(1.0, f32::max);
        let color = light.map(|c| srgb_text(c / strength, strength));
        self.line("Ke", &color.join(" "));
        self.texture("/emissiveTexture", "map_Ke", "");
    }

    fn normals(&mut self) {
        let scale = float(self.value.pointer("/normalTexture/scale"), 1.0);
        let option = if scale == 1.0 { String::new() } else { format!("-bm {scale} ") };
        self.texture("/normalTexture", "norm", &option);
    }

    /// Writes the texture at a place of the material, and returns whether there is one.
    fn texture(&mut self, pointer: &str, keyword: &str, options: &str) -> bool {
        let Some(value) = self.value.pointer(pointer) else { return false };
        let what = pointer.rsplit('/').next().unwrap_or(pointer);
        let Some(info) = TextureInfo::of(value, self.appearance) else {
            self.lost.push(format!("{what}, which names no image"));
            return false;
        };
        let Some(name) = self.images.name_of(info.image, self.warnings) else { return false };
        let mut text = options.to_owned();
        if let Some(([scale_u, scale_v], [offset_u, offset_v])) = info.transform {
            let offset_v = 1.0 - scale_v - offset_v;
            text += &format!("-s {scale_u} {scale_v} 1 -o {offset_u} {offset_v} 0 ");
        }
        if info.clamps {
            text += "-clamp on ";
        }
        let lost = info.lost.iter().map(|lost| format!("{lost} of {what}"));
        for lost in lost.filter(|lost| !self.lost.contains(lost)).collect::<Vec<_>>() {
            self.lost.push(lost);
        }
        self.line(keyword, &(text + &name));
        true
    }

    /// Notes the members that no statement expresses.
    fn remaining_members(&mut self) {
        let Some(members) = self.value.as_object() else { return };
        for (name, value) in members {
            match name.as_str() {
                "name"
                | "pbrMetallicRoughness"
                | "normalTexture"
                | "emissiveTexture"
                | "emissiveFactor"
                | "alphaMode"
                | "alphaCutoff" => {}
                "doubleSided" if value == &Value::Bool(false) => {}
                "extensions" => {
                    const KNOWN: [&str; 2] = ["KHR_materials_unlit", "KHR_materials_emissive_strength"];
                    let extensions = value.as_object().into_iter().flatten().map(|(name, _)| name);
                    self.lost.extend(extensions.filter(|name| !KNOWN.contains(&name.as_str())).cloned());
                }
                other => self.lost.push(other.to_owned()),
            }
        }
    }
}

/// Returns the shortest sRGB value that is read as this linear one if it is divided by the strength.
fn srgb_text(linear: f32, strength: f32) -> String {
    let value = linear_to_srgb(linear) * strength;
    let is_exact =
        |text: &String| text.parse::<f32>().is_ok_and(|value| srgb_to_linear(value / strength) == linear);
    let found = (0..=9).map(|digits| format!("{value:.digits$}")).find(is_exact);
    found.unwrap_or_else(|| value.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_come_back_with_few_digits() {
        for text in ["0", "1", "0.5", "0.8", "0.25", "0.123456", "0.031372"] {
            assert_eq!(srgb_text(srgb_to_linear(text.parse().unwrap()), 1.0), text);
        }
        for i in 0..1000 {
            let linear = i as f32 / 999.0;
            let back = srgb_to_linear(srgb_text(linear, 1.0).parse().unwrap());
            assert!((back - linear).abs() < 1e-6, "{linear} became {back}");
        }
    }
}
