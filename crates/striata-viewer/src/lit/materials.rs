//! Materials and images of a document.

use std::sync::Arc;

use striata_gpu::{AlphaMode, LitImage, LitMaterial, TextureFilter, TextureSampler, TextureUse, TextureWrap};
use striata_scene::drawn::{self, Material, Wrap};
use striata_scene::textures::RgbaImage;

/// Converts a material. References to a third or later set of texture coordinates are left out.
pub(crate) fn lit_material(material: &Material) -> LitMaterial {
    let texture = |texture: &Option<drawn::TextureUse>| texture.as_ref().and_then(texture_use);
    LitMaterial {
        name: material.name.clone(),
        base_color: material.base_color,
        base_color_texture: texture(&material.base_color_texture),
        metallic: material.metallic,
        roughness: material.roughness,
        metallic_roughness_texture: texture(&material.metallic_roughness_texture),
        normal_texture: texture(&material.normal_texture),
        normal_scale: material.normal_scale,
        occlusion_texture: texture(&material.occlusion_texture),
        occlusion_strength: material.occlusion_strength,
        emissive: material.emissive,
        emissive_texture: texture(&material.emissive_texture),
        alpha_mode: match material.alpha_mode {
            drawn::AlphaMode::Opaque => AlphaMode::Opaque,
            drawn::AlphaMode::Mask(cutoff) => AlphaMode::Mask { cutoff },
            drawn::AlphaMode::Blend => AlphaMode::Blend,
        },
        is_double_sided: material.is_double_sided,
        is_unlit: material.is_unlit,
    }
}

/// Converts an image; one that no material uses becomes a white pixel.
pub(crate) fn lit_image(image: Option<&RgbaImage>) -> LitImage {
    match image {
        Some(RgbaImage { width, height, rgba }) => {
            LitImage { width: *width, height: *height, rgba: Arc::clone(rgba) }
        }
        None => LitImage { width: 1, height: 1, rgba: [255; 4].into() },
    }
}

fn texture_use(texture: &drawn::TextureUse) -> Option<TextureUse> {
    let wrap = |wrap| match wrap {
        Wrap::Repeat => TextureWrap::Repeat,
        Wrap::MirroredRepeat => TextureWrap::Mirror,
        Wrap::ClampToEdge => TextureWrap::Clamp,
    };
    let drawn::Sampler { wrap: wraps, is_smooth, has_mip_maps } = texture.sampler;
    let mag_filter = if is_smooth { TextureFilter::Linear } else { TextureFilter::Nearest };
    let mip_filter = has_mip_maps.then_some(TextureFilter::Linear);
    let sampler =
        TextureSampler { wrap: wraps.map(wrap), mag_filter, min_filter: TextureFilter::Linear, mip_filter };
    let uv_transform = texture.transform.0;
    (texture.uv_set < 2).then_some(TextureUse {
        image: texture.image,
        sampler,
        uv_set: texture.uv_set,
        uv_transform,
    })
}

#[cfg(test)]
mod tests {
    use striata_scene::drawn::{Sampler, UvTransform};

    use super::*;

    #[test]
    fn textures_keep_their_sampling_and_third_coordinates_are_left_out() {
        let sampler = Sampler {
            wrap: [Wrap::ClampToEdge, Wrap::MirroredRepeat],
            is_smooth: false,
            has_mip_maps: false,
        };
        let of_set =
            |uv_set| drawn::TextureUse { image: 3, sampler, uv_set, transform: UvTransform::default() };
        let material = Material {
            base_color_texture: Some(of_set(1)),
            normal_texture: Some(of_set(2)),
            alpha_mode: drawn::AlphaMode::Mask(0.25),
            ..Material::default()
        };
        let lit = lit_material(&material);
        let texture = lit.base_color_texture.expect("the second set is drawn");
        assert_eq!((texture.image, texture.uv_set), (3, 1));
        assert_eq!(texture.sampler.wrap, [TextureWrap::Clamp, TextureWrap::Mirror]);
        assert_eq!((texture.sampler.mag_filter, texture.sampler.mip_filter), (TextureFilter::Nearest, None));
        assert_eq!(lit.normal_texture, None);
        assert_eq!(lit.alpha_mode, AlphaMode::Mask { cutoff: 0.25 });
    }
}
