//! Decoding of the images that materials use.

use std::collections::BTreeSet;

use striata_io::Scene;

use super::Material;
use crate::textures::{MAX_SIDE, RgbaImage, TextureError, image_info, image_roles};

/// Limits of the memory for decoded images.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ImageLimits {
    /// Larger images are reduced until no side is longer, pixels; at least 1. Default 16,384.
    pub max_side: u32,
    /// If all images together have more bytes of pixels, larger ones are reduced further. Default 1 GiB.
    pub total_bytes: u64,
}

impl Default for ImageLimits {
    fn default() -> Self {
        Self { max_side: MAX_SIDE, total_bytes: 1 << 30 }
    }
}

impl ImageLimits {
    /// Sets the longest side of an image, in pixels.
    #[must_use]
    pub fn with_max_side(self, max_side: u32) -> Self {
        Self { max_side, ..self }
    }

    /// Sets the size of all images together, in bytes of pixels.
    #[must_use]
    pub fn with_total_bytes(self, total_bytes: u64) -> Self {
        Self { total_bytes, ..self }
    }
}

/// The images that materials use, as pixels.
#[derive(Clone, Debug, Default)]
pub struct DecodedImages {
    /// One entry for each image of the scene; [`None`] if no material uses it, or it cannot be decoded.
    pub images: Vec<Option<RgbaImage>>,
    /// Images that cannot be decoded, with the reasons.
    pub warnings: Vec<String>,
}

/// Decodes the images that some materials use, within limits. An image that cannot be decoded causes a
/// warning, and its references are removed from the materials.
///
/// `run` is called with the number of images and a function that decodes one of them, and returns the
/// results in order; it may use several threads.
pub fn decode_images(
    scene: &Scene,
    materials: &mut [Material],
    limits: &ImageLimits,
    run: impl FnOnce(usize, &(dyn Fn(usize) -> DecodeResult + Sync)) -> Vec<DecodeResult>,
) -> DecodedImages {
    let used: BTreeSet<usize> =
        materials.iter().flat_map(Material::textures).map(|use_| use_.image).collect();
    let used: Vec<usize> = used.into_iter().filter(|&image| image < scene.images().len()).collect();
    let max_side = fitting_side(scene, &used, limits);
    let roles = image_roles(scene.document());
    let role = |index: usize| roles.get(used[index]).copied().unwrap_or_default();
    let decoded = run(used.len(), &|index| {
        RgbaImage::decode(&scene.images()[used[index]].bytes, role(index), max_side)
    });
    let mut out = DecodedImages { images: vec![None; scene.images().len()], warnings: Vec::new() };
    for (&image, result) in used.iter().zip(decoded) {
        match result {
            Ok(decoded) => out.images[image] = Some(decoded),
            // Images without bytes were reported when the scene was read.
            Err(_) if scene.images()[image].bytes.is_empty() => {}
            Err(error) => out.warnings.push(format!("{}: {error}; it is drawn without", label(scene, image))),
        }
    }
    for material in materials {
        material.without_unknown_images(|image| out.images.get(image).is_some_and(Option::is_some));
    }
    out
}

/// Result of decoding one image.
pub type DecodeResult = Result<RgbaImage, TextureError>;

/// Returns the largest side with which all images fit into the limit, halving it as often as needed.
fn fitting_side(scene: &Scene, used: &[usize], limits: &ImageLimits) -> u32 {
    let sizes: Vec<[u64; 2]> = used
        .iter()
        .filter_map(|&image| image_info(&scene.images()[image].bytes).ok())
        .map(|info| [u64::from(info.width), u64::from(info.height)])
        .collect();
    let mut side = limits.max_side.clamp(1, MAX_SIDE);
    let bytes_at = |side: u32| -> u64 {
        let of = |&[width, height]: &[u64; 2]| {
            let longest = width.max(height).max(1);
            let scaled = |x: u64| if longest > u64::from(side) { x * u64::from(side) / longest } else { x };
            4 * scaled(width).max(1) * scaled(height).max(1)
        };
        sizes.iter().map(of).sum()
    };
    while side > 1 && bytes_at(side) > limits.total_bytes {
        side /= 2;
    }
    side
}

/// Name of an image in messages.
fn label(scene: &Scene, image: usize) -> String {
    let entry = &scene.images()[image];
    match [&entry.name, &entry.uri].into_iter().find(|text| !text.is_empty()) {
        Some(text) => {
            let name: String = text.chars().filter(|c| !c.is_control()).take(80).collect();
            format!("image {image} (`{name}`)")
        }
        None => format!("image {image}"),
    }
}
