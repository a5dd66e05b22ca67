//! Images of a PLY file that is written: one comment for each, and the number of each face if there are
//! several.

use std::borrow::Cow;
use std::collections::BTreeMap;

use serde_json::{Value, json};
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};

use super::texcoords::{has_origin, with_bottom_origin};
use crate::Format;
use crate::error::Place;
use crate::gltf_json::{TextureInfo, float};
use crate::image_files::ImageFiles;
use crate::losses::{is_added, label, of_group_names, used_materials};
use crate::report::Warnings;
use crate::text::{push_f32, push_one_minus_f32};

/// Images of the faces.
#[derive(Debug, Default)]
pub(super) struct WrittenTextures {
    /// Names of the images, for `comment TextureFile`.
    pub names: Vec<String>,
    /// Image of each triangle, -1 for none; [`None`] if all have the first one.
    pub numbers: Option<Vec<i32>>,
}

impl WrittenTextures {
    /// Finds the images of a mesh, and warns about what else its materials say.
    pub(super) fn of(mesh: &IndexedMesh, images: &mut ImageFiles<'_>, warnings: &mut Warnings) -> Self {
        of_group_names(mesh, Format::Ply, warnings);
        let mut out = Self::default();
        let mut number_of_material = BTreeMap::new();
        for material in used_materials(mesh) {
            if let Some(name) = name_of(mesh, material, images, warnings) {
                let known = out.names.iter().position(|known| *known == name);
                let number = known.unwrap_or_else(|| {
                    out.names.push(name);
                    out.names.len() - 1
                });
                number_of_material.insert(material, number as i32);
            }
        }
        if out.names.is_empty() {
            return out;
        }
        let mut numbers = vec![-1; mesh.triangles.len()];
        for group in &mesh.groups {
            let number = group.material.and_then(|material| number_of_material.get(&(material as usize)));
            numbers[group.range()].fill(number.copied().unwrap_or(-1));
        }
        out.numbers = numbers.iter().any(|&number| number != 0).then_some(numbers);
        out
    }
}

/// Returns the name of the image that is the base color of a material. Warns about everything else.
fn name_of(
    mesh: &IndexedMesh,
    material: usize,
    images: &mut ImageFiles<'_>,
    warnings: &mut Warnings,
) -> Option<String> {
    let known = mesh.appearance.materials.get(material).filter(|known| !is_added(known))?;
    let value: Value = serde_json::from_str(&known.gltf_json).unwrap_or_default();
    let info = value.pointer("/pbrMetallicRoughness/baseColorTexture");
    let info = info.and_then(|info| TextureInfo::of(info, &mesh.appearance));
    let has_texcoords = mesh.layer(&Semantic::TexCoord(0)).is_some_and(has_origin);
    let label = label(material, &known.name);
    let Some(info) = info.filter(|_| has_texcoords) else {
        let reason = format!("PLY cannot store the material {label} without an image; it is left out");
        warnings.push(Place::File, reason);
        return None;
    };
    if !is_image_only(&value) || info.transform.is_some() || info.clamps || !info.lost.is_empty() {
        let reason = format!("PLY stores only the base color image of the material {label}");
        warnings.push(Place::File, reason);
    }
    images.name_of(info.image, warnings)
}

/// Whether a material is what a reader of PLY makes of an image.
fn is_image_only(material: &Value) -> bool {
    let is_default = |(name, value): (&String, &Value)| match name.as_str() {
        "name" | "baseColorTexture" => true,
        "metallicFactor" => float(Some(value), 1.0) == 0.0,
        "roughnessFactor" => float(Some(value), 1.0) == 1.0,
        "baseColorFactor" => *value == json!([1.0, 1.0, 1.0, 1.0]),
        _ => false,
    };
    let pbr = material.get("pbrMetallicRoughness").and_then(Value::as_object);
    let has_default_metal = pbr.is_some_and(|pbr| pbr.contains_key("metallicFactor"));
    let others = material.as_object().into_iter().flatten();
    has_default_metal
        && pbr.into_iter().flatten().all(is_default)
        && others.filter(|(name, _)| *name != "pbrMetallicRoughness").all(is_default)
}

/// Texture coordinates and numbers of faces, which programs expect if there are several images.
pub(super) struct FaceTexcoords<'m> {
    numbers: &'m [i32],
    texcoords: Cow<'m, AttributeLayer>,
    in_text: &'m AttributeLayer,
}

impl<'m> FaceTexcoords<'m> {
    /// Returns the texture coordinates and numbers of the faces of a mesh; [`None`] if all show the same image.
    pub(super) fn of(mesh: &'m IndexedMesh, textures: &'m WrittenTextures) -> Option<Self> {
        let in_text = mesh.layer(&Semantic::TexCoord(0))?;
        let numbers = textures.numbers.as_deref()?;
        Some(Self { numbers, texcoords: with_bottom_origin(in_text), in_text })
    }

    /// Appends the properties of a face in binary.
    pub(super) fn push_binary(&self, index: usize, triangle: &[u32; 3], out: &mut Vec<u8>) {
        out.push(6);
        for &vertex in triangle {
            for component in 0..2 {
                out.extend_from_slice(&self.texcoords.get(vertex as usize, component).to_le_bytes());
            }
        }
        out.extend_from_slice(&self.numbers[index].to_le_bytes());
    }

    /// Appends the properties of a face as text, with a blank after each number.
    pub(super) fn push_ascii(&self, index: usize, triangle: [u32; 3], out: &mut Vec<u8>) {
        out.extend_from_slice(b"6 ");
        for vertex in triangle {
            push_f32(out, self.in_text.get(vertex as usize, 0));
            out.push(b' ');
            push_one_minus_f32(out, self.in_text.get(vertex as usize, 1));
            out.push(b' ');
        }
        out.extend_from_slice(format!("{} ", self.numbers[index]).as_bytes());
    }
}
