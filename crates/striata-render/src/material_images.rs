//! The images of a material, and their meanings.

use striata_scene::drawn::{AlphaMode, Material, TextureUse};

use crate::mips::ImageMeaning;

/// Slots of [`material_images`].
pub(crate) const BASE_COLOR: usize = 0;
pub(crate) const METALLIC_ROUGHNESS: usize = 1;
pub(crate) const NORMAL: usize = 2;
pub(crate) const OCCLUSION: usize = 3;
pub(crate) const EMISSIVE: usize = 4;

/// An image that a material uses.
pub(crate) type UsedImage<'a> = (&'a TextureUse, ImageMeaning);

/// Returns the images of a material in the order of their slots.
pub(crate) fn material_images(material: &Material) -> [Option<UsedImage<'_>>; 5] {
    let cutoff = match material.alpha_mode {
        AlphaMode::Mask(cutoff) => {
            let of_image = 255.0 * cutoff / material.base_color[3];
            (of_image > 0.5 && of_image < 255.5).then(|| of_image.ceil().clamp(1.0, 255.0) as u8)
        }
        _ => None,
    };
    [
        material.base_color_texture.as_ref().map(|used| (used, ImageMeaning::Color { cutoff })),
        material.metallic_roughness_texture.as_ref().map(|used| (used, ImageMeaning::Linear)),
        material.normal_texture.as_ref().map(|used| (used, ImageMeaning::Normal)),
        material.occlusion_texture.as_ref().map(|used| (used, ImageMeaning::Linear)),
        material.emissive_texture.as_ref().map(|used| (used, ImageMeaning::Color { cutoff: None })),
    ]
}
