//! Materials and what they say of their textures.

use std::collections::BTreeSet;
use std::sync::Arc;

use serde_json::{Value, json};
use striata::mesh::{Appearance, AttributeLayer, IndexedMesh, Semantic};
use striata_paged::Metadata;
use striata_scene::drawn::{TextureReader, UvTransform, Wrap};
use striata_scene::textures::ImageInfo;

use super::regions::Regions;

/// A material and its textures.
pub(crate) struct MaterialTextures {
    /// The material without textures that are missing.
    pub material: Value,
    pub textures: Vec<MaterialTexture>,
    /// Set and transform of the texture coordinates; `None` if textures have different ones.
    pub coordinates: Option<(u8, UvTransform)>,
    /// Size of the largest image, texels, and its charts.
    pub size: [u32; 2],
    pub regions: Option<Arc<Regions>>,
    /// Area of the surface, and of its triangles in texels.
    pub areas: [f64; 2],
}

/// A texture of a material.
#[derive(Clone, Debug)]
pub(crate) struct MaterialTexture {
    /// JSON pointer to the reference.
    pub pointer: String,
    pub image: usize,
    pub wrap: [Wrap; 2],
    pub sampler: Value,
    pub set: u8,
    pub transform: UvTransform,
}

impl MaterialTextures {
    pub(super) fn read(
        material: &Value,
        reader: &TextureReader<'_>,
        infos: &[Option<ImageInfo>],
        metadata: &Metadata,
        warnings: &mut BTreeSet<String>,
    ) -> Self {
        let mut textures = Vec::new();
        references(material, "", &mut |parent, pointer, name| {
            let Some(found) = reader.read(parent, name) else { return };
            let index = parent[name]["index"].as_u64().unwrap_or(0) as usize;
            let sampler = reader.document["textures"][index]["sampler"].as_u64();
            let sampler = sampler.map_or(Value::Null, |s| reader.document["samplers"][s as usize].clone());
            let name = Semantic::TexCoord(found.uv_set).to_string();
            if !metadata.layers.iter().any(|layer| layer.semantic == name) {
                warnings.insert(format!(
                    "textures of the material {} are left out: the mesh has no {name}",
                    material["name"].as_str().unwrap_or("without a name")
                ));
                return;
            }
            textures.push(MaterialTexture {
                pointer,
                image: found.image,
                wrap: found.sampler.wrap,
                sampler: if sampler.is_object() { sampler } else { json!({}) },
                set: found.uv_set,
                transform: found.transform,
            });
        });
        let mut out = Self {
            material: material.clone(),
            textures,
            coordinates: None,
            size: [1; 2],
            regions: None,
            areas: [0.0; 2],
        };
        out.keep(|texture| infos.get(texture.image).is_some_and(Option::is_some));
        let first = out.textures.first().map(|texture| (texture.set, texture.transform));
        out.coordinates = first.filter(|&(set, transform)| {
            out.textures.iter().all(|t| (t.set, t.transform) == (set, transform))
        });
        let sizes = out.textures.iter().filter_map(|texture| *infos.get(texture.image)?);
        let sizes = sizes.map(|info| [info.width, info.height]);
        out.size = sizes.max_by_key(|&[w, h]| u64::from(w) * u64::from(h)).unwrap_or([1; 2]);
        out
    }

    /// Removes textures for which `is_kept` is false, and references that lead nowhere.
    pub(super) fn keep(&mut self, is_kept: impl Fn(&MaterialTexture) -> bool) {
        self.textures.retain(is_kept);
        let kept: BTreeSet<&str> = self.textures.iter().map(|texture| texture.pointer.as_str()).collect();
        remove_textures(&mut self.material, "", &|pointer| kept.contains(pointer));
    }

    /// Texture coordinates of the charts, in texels of the largest image; `None` if there are none.
    pub(super) fn texel_places<'m>(
        &self,
        mesh: &'m IndexedMesh,
    ) -> Option<impl Fn(u32) -> [f64; 2] + use<'m>> {
        let (set, UvTransform(rows)) = self.coordinates?;
        let layer: &AttributeLayer = mesh.layer(&Semantic::TexCoord(set))?;
        let size = self.size.map(f64::from);
        let rows = rows.map(|row| row.map(f64::from));
        Some(move |vertex: u32| {
            let [u, v] = [0, 1].map(|i| f64::from(layer.get(vertex as usize, i)));
            [0, 1].map(|i| (rows[i][0] * u + rows[i][1] * v + rows[i][2]) * size[i])
        })
    }
}

/// Calls `visit` with the parent, the JSON pointer and the name of each reference to a texture.
fn references(value: &Value, path: &str, visit: &mut dyn FnMut(&Value, String, &str)) {
    for (name, member) in value.as_object().into_iter().flatten() {
        let pointer = member_pointer(path, name);
        if name.ends_with("Texture") && member.get("index").is_some() {
            visit(value, pointer, name);
        } else {
            references(member, &pointer, visit);
        }
    }
}

/// Materials without what refers to textures.
pub(crate) fn without_textures(appearance: Appearance) -> Appearance {
    let mut appearance = Appearance {
        images: Vec::new(),
        textures_json: Vec::new(),
        samplers_json: Vec::new(),
        georeference: String::new(),
        ..appearance
    };
    for material in &mut appearance.materials {
        if let Ok(mut value) = serde_json::from_str(&material.gltf_json) {
            remove_textures(&mut value, "", &|_| false);
            material.gltf_json = value.to_string();
        }
    }
    appearance
}

/// Removes references to textures, which are objects with an index whose names end in `Texture`, except those for whose
/// JSON pointers `is_kept` is true.
fn remove_textures(value: &mut Value, path: &str, is_kept: &impl Fn(&str) -> bool) {
    if let Value::Object(members) = value {
        members.retain(|name, value| {
            let is_texture = name.ends_with("Texture") && value.get("index").is_some();
            !is_texture || is_kept(&member_pointer(path, name))
        });
        for (name, value) in members.iter_mut() {
            remove_textures(value, &member_pointer(path, name), is_kept);
        }
    }
}

/// JSON pointer of a member of an object.
fn member_pointer(path: &str, name: &str) -> String {
    format!("{path}/{}", name.replace('~', "~0").replace('/', "~1"))
}
