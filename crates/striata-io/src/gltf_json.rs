//! glTF objects that a mesh carries as JSON text.

use std::collections::BTreeSet;

use serde_json::Value;
#[cfg(any(feature = "ply", feature = "obj"))]
use striata::mesh::Appearance;

/// Collects the names of all extensions used within a value.
pub(crate) fn extensions_in(value: &Value, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(map) => {
            if let Some(Value::Object(extensions)) = map.get("extensions") {
                found.extend(extensions.keys().cloned());
            }
            map.values().for_each(|value| extensions_in(value, found));
        }
        Value::Array(entries) => entries.iter().for_each(|value| extensions_in(value, found)),
        _ => {}
    }
}

/// Returns how many copies of its texture a unit of the texture coordinates of a glTF material covers, along each
/// axis: the scale of the texture transform (`KHR_texture_transform`) of its base color texture, or of
/// the first of its other textures.
#[cfg(feature = "gltf")]
pub fn texcoord_scale(material: &Value) -> [f32; 2] {
    const TEXTURES: [&str; 5] = [
        "/pbrMetallicRoughness/baseColorTexture",
        "/normalTexture",
        "/pbrMetallicRoughness/metallicRoughnessTexture",
        "/emissiveTexture",
        "/occlusionTexture",
    ];
    let shown = TEXTURES.iter().find_map(|texture| material.pointer(texture));
    let scale = shown.and_then(|texture| texture.pointer("/extensions/KHR_texture_transform/scale"));
    let axis = |axis: usize| {
        let number = scale.and_then(|scale| scale.get(axis)?.as_f64()).map(|number| number.abs() as f32);
        number.filter(|number| number.is_finite() && *number > 0.0).unwrap_or(1.0)
    };
    [axis(0), axis(1)]
}

/// Returns a number as JSON with the fewest digits that read back as the same `f32`.
#[cfg(any(feature = "obj", feature = "threemf"))]
pub(crate) fn number(value: f32) -> Value {
    let shortest: f64 = value.to_string().parse().unwrap_or(0.0);
    serde_json::Number::from_f64(shortest).map_or(Value::from(0), Value::Number)
}

/// Returns a number of a glTF object, or its default.
#[cfg(any(feature = "ply", feature = "obj"))]
pub(crate) fn float(value: Option<&Value>, default: f32) -> f32 {
    value.and_then(Value::as_f64).map_or(default, |value| value as f32)
}

/// Returns the numbers of a glTF array; those that are missing have their defaults.
#[cfg(any(feature = "ply", feature = "obj"))]
pub(crate) fn floats<const N: usize>(value: Option<&Value>, defaults: [f32; N]) -> [f32; N] {
    std::array::from_fn(|index| float(value.and_then(|value| value.get(index)), defaults[index]))
}

/// Texture of a material, as other formats express it.
#[cfg(any(feature = "ply", feature = "obj"))]
pub(crate) struct TextureInfo {
    /// Index of the image.
    pub image: usize,
    /// Scale and offset of the texture coordinates, if they are transformed.
    pub transform: Option<([f32; 2], [f32; 2])>,
    /// Whether the texture does not repeat.
    pub clamps: bool,
    /// Names of its properties that other formats cannot express.
    pub lost: Vec<String>,
}

#[cfg(any(feature = "ply", feature = "obj"))]
impl TextureInfo {
    /// Follows a reference to a texture; [`None`] if it leads to no image.
    pub(crate) fn of(info: &Value, appearance: &Appearance) -> Option<Self> {
        let index = |value: Option<&Value>| value.and_then(Value::as_u64).and_then(|i| i.try_into().ok());
        let parsed =
            |list: &[String], index: usize| -> Option<Value> { serde_json::from_str(list.get(index)?).ok() };
        let texture = parsed(&appearance.textures_json, index(info.get("index"))?)?;
        let extensions = || texture.get("extensions").and_then(Value::as_object).into_iter().flatten();
        let source = index(texture.get("source"));
        let image = source.or_else(|| extensions().find_map(|(_, value)| index(value.get("source"))))?;
        let mut out = Self { image, transform: None, clamps: false, lost: Vec::new() };
        if float(info.get("texCoord"), 0.0) != 0.0 {
            out.lost.push("the second set of texture coordinates".to_owned());
        }
        for (name, value) in info.get("extensions").and_then(Value::as_object).into_iter().flatten() {
            if name == "KHR_texture_transform" {
                out.set_transform(value);
            } else {
                out.lost.push(name.clone());
            }
        }
        if let Some(sampler) =
            index(texture.get("sampler")).and_then(|i| parsed(&appearance.samplers_json, i))
        {
            out.set_sampler(&sampler);
        }
        Some(out)
    }

    fn set_transform(&mut self, value: &Value) {
        let (scale, offset) = (floats(value.get("scale"), [1.0; 2]), floats(value.get("offset"), [0.0; 2]));
        self.transform = ((scale, offset) != ([1.0; 2], [0.0; 2])).then_some((scale, offset));
        if float(value.get("rotation"), 0.0) != 0.0 {
            self.lost.push("the rotation".to_owned());
        }
        if float(value.get("texCoord"), 0.0) != 0.0 {
            self.lost.push("the second set of texture coordinates".to_owned());
        }
    }

    fn set_sampler(&mut self, sampler: &Value) {
        const REPEAT: f32 = 10497.0;
        const CLAMP_TO_EDGE: f32 = 33071.0;
        const NEAREST: f32 = 9728.0;
        let wraps = ["wrapS", "wrapT"].map(|key| float(sampler.get(key), REPEAT));
        self.clamps = wraps == [CLAMP_TO_EDGE; 2];
        if !self.clamps && wraps != [REPEAT; 2] {
            self.lost.push("the wrap mode".to_owned());
        }
        if float(sampler.get("magFilter"), 0.0) == NEAREST {
            self.lost.push("the filter".to_owned());
        }
    }
}
