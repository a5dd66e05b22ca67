//! Approximation of `KHR_materials_pbrSpecularGlossiness` by metallic-roughness.

use serde_json::Value;

use super::json::{number, numbers};
use super::texture_use::{TextureReader, TextureUse};

/// Reflectance of a dielectric at normal incidence.
const DIELECTRIC: f32 = 0.04;

/// Roughness of a material whose glossiness is in the alpha channel of an image.
const TEXTURED_ROUGHNESS: f32 = 0.6;

/// A reflection as metallic-roughness describes it.
#[derive(Clone, Debug)]
pub(super) struct Reflection {
    pub base_color: [f32; 4],
    pub base_color_texture: Option<TextureUse>,
    pub metallic: f32,
    pub roughness: f32,
}

/// Reads the reflection of a material.
///
/// The diffuse color becomes the base color. A material without an image of its reflection becomes a metal
/// as far as it reflects more than a dielectric would; its base color then is that of the reflection.
pub(super) fn read_specular_glossiness(value: &Value, textures: &TextureReader<'_>) -> Reflection {
    let unit = |x: f32| x.clamp(0.0, 1.0);
    let diffuse: [f32; 4] = numbers(value, "diffuseFactor").unwrap_or([1.0; 4]).map(unit);
    let specular: [f32; 3] = numbers(value, "specularFactor").unwrap_or([1.0; 3]).map(unit);
    let base_color_texture = textures.read(value, "diffuseTexture");
    if textures.read(value, "specularGlossinessTexture").is_some() {
        let (metallic, roughness) = (0.0, TEXTURED_ROUGHNESS);
        return Reflection { base_color: diffuse, base_color_texture, metallic, roughness };
    }
    let roughness = 1.0 - unit(number(value, "glossinessFactor").unwrap_or(1.0));
    let strongest = specular.into_iter().fold(0.0, f32::max);
    let is_textured = base_color_texture.is_some();
    let metallic = if is_textured { 0.0 } else { metallic_of(brightest(diffuse), strongest) };
    let color = |k: usize| {
        let of_diffuse = diffuse[k] / (1.0 - DIELECTRIC) * (1.0 - strongest);
        unit(of_diffuse + metallic * metallic * (specular[k] - of_diffuse))
    };
    let base_color = if is_textured { diffuse } else { [color(0), color(1), color(2), diffuse[3]] };
    Reflection { base_color, base_color_texture, metallic, roughness }
}

fn brightest([r, g, b, _]: [f32; 4]) -> f32 {
    r.max(g).max(b)
}

/// Solves for the metalness with which metallic-roughness has the same diffuse and specular reflection.
fn metallic_of(diffuse: f32, specular: f32) -> f32 {
    if specular <= DIELECTRIC {
        return 0.0;
    }
    // d and s are the diffuse and specular reflection of a base color c and a metalness m:
    // d = c (1 - m), s = 0.04 (1 - m) + c m, which is quadratic in m.
    let b = diffuse * (1.0 - specular) / (1.0 - DIELECTRIC) + specular - 2.0 * DIELECTRIC;
    let c = DIELECTRIC - specular;
    let root = (b * b - 4.0 * DIELECTRIC * c).max(0.0).sqrt();
    ((root - b) / (2.0 * DIELECTRIC)).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn read(value: &Value) -> Reflection {
        let document = Value::Null;
        read_specular_glossiness(value, &TextureReader { document: &document, images: &[] })
    }

    #[test]
    fn dielectrics_and_metals_are_recognized() {
        let plastic = read(&json!({
            "diffuseFactor": [0.5, 0.1, 0.1, 1],
            "specularFactor": [0.04, 0.04, 0.04],
            "glossinessFactor": 0.25,
        }));
        assert_eq!((plastic.metallic, plastic.roughness), (0.0, 0.75));
        assert!((plastic.base_color[0] - 0.5).abs() < 1e-6, "{plastic:?}");
        let gold = read(&json!({ "diffuseFactor": [0, 0, 0, 1], "specularFactor": [1, 0.77, 0.34] }));
        assert!((gold.metallic - 1.0).abs() < 1e-5, "{gold:?}");
        assert!((gold.base_color[1] - 0.77).abs() < 1e-5 && gold.roughness == 0.0, "{gold:?}");
    }
}
