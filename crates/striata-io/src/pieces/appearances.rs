//! Materials and images of several inputs in one list.

use serde_json::Value;
use striata::mesh::Appearance;

/// Appends an appearance, with its indices shifted; returns the number of materials before.
pub(super) fn append(to: &mut Appearance, from: &Appearance) -> u32 {
    to.color_space = from.color_space;
    if to.georeference.is_empty() {
        to.georeference = from.georeference.clone();
    }
    let first_material = to.materials.len() as u32;
    let [textures, images, samplers] = [to.textures_json.len(), to.images.len(), to.samplers_json.len()];
    for material in &from.materials {
        let mut material = material.clone();
        material.gltf_json = edited(&material.gltf_json, |value| shift_textures(value, textures));
        to.materials.push(material);
    }
    for texture in &from.textures_json {
        to.textures_json.push(edited(texture, |value| {
            shift_members(value, "source", images);
            shift_members(value, "sampler", samplers);
        }));
    }
    to.images.extend(from.images.iter().cloned());
    to.samplers_json.extend(from.samplers_json.iter().cloned());
    extend_with_new(&mut to.extensions_used, &from.extensions_used);
    extend_with_new(&mut to.material_libraries, &from.material_libraries);
    first_material
}

fn extend_with_new(to: &mut Vec<String>, from: &[String]) {
    for name in from {
        if !to.contains(name) {
            to.push(name.clone());
        }
    }
}

/// Changes a JSON text; what is no JSON stays as it is.
fn edited(text: &str, edit: impl FnOnce(&mut Value)) -> String {
    match serde_json::from_str(text) {
        Ok(mut value) => {
            edit(&mut value);
            value.to_string()
        }
        Err(_) => text.to_owned(),
    }
}

/// Shifts the index of every texture: objects whose names end in `Texture`, in extensions too.
fn shift_textures(value: &mut Value, by: usize) {
    let Value::Object(members) = value else { return };
    for (name, member) in members {
        if name.ends_with("Texture")
            && let Some(index) = member.get_mut("index")
        {
            shift(index, by);
        }
        shift_textures(member, by);
    }
}

/// Shifts all members with a name, in extensions too.
fn shift_members(value: &mut Value, wanted: &str, by: usize) {
    let Value::Object(members) = value else { return };
    for (name, member) in members {
        if name == wanted {
            shift(member, by);
        }
        shift_members(member, wanted, by);
    }
}

fn shift(index: &mut Value, by: usize) {
    if let Some(number) = index.as_u64() {
        *index = Value::from(number.saturating_add(by as u64));
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::{Image, Material};

    use super::*;

    #[test]
    fn indices_are_shifted() {
        let gltf_json = r#"{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}"#.to_owned();
        let one = Appearance {
            materials: vec![Material { name: "a".to_owned(), gltf_json }],
            images: vec![Image::default()],
            textures_json: vec![r#"{"sampler":0,"source":0}"#.to_owned()],
            samplers_json: vec!["{}".to_owned()],
            ..Appearance::default()
        };
        let mut both = one.clone();
        assert_eq!(append(&mut both, &one), 1);
        assert_eq!(both.textures_json[1], r#"{"sampler":1,"source":1}"#);
        assert!(both.materials[1].gltf_json.contains(r#""index":1"#));
        assert_eq!((both.materials[0].clone(), both.images.len()), (one.materials[0].clone(), 2));
    }
}
