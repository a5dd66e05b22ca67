//! Re-encoding of all images of a scene.

use std::collections::BTreeSet;

use serde_json::{Value, json};
use striata_io::{Scene, SceneParts};

use super::recode::{RecodedImage, TextureOptions, recode};
use super::role::image_roles;
use super::sources::{with_webp_sources, without_sources};
use super::{EncodedImage, ImageFormat, TextureError};

/// Results of re-encoding the images of a scene.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct TextureReport {
    /// Images that were changed.
    pub changed: Vec<ImageChange>,
    /// Number of images that were already as requested, or that have no bytes.
    pub unchanged_count: usize,
    /// Images that stay as they are although they are not as requested, with the reason.
    pub warnings: Vec<String>,
}

/// An image that was changed.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ImageChange {
    /// Index of the image.
    pub image: usize,
    /// Width and height, pixels.
    pub size: (u32, u32),
    /// Format of the file.
    pub format: ImageFormat,
    /// Length of the file before, bytes.
    pub bytes_before: usize,
    /// Length of the file, bytes.
    pub bytes: usize,
}

/// Resizes and re-encodes the images of a scene, each as its [role](super::TextureRole) requires.
///
/// MIME types follow. Textures of images that become WebP refer to them by `EXT_texture_webp`, and those of
/// images that are no longer WebP do not. Images that cannot be decoded stay as they are, with a warning.
///
/// # Errors
/// [`TextureError`] if an option is out of range or an encoder fails.
pub fn recode_scene(scene: Scene, options: &TextureOptions) -> Result<(Scene, TextureReport), TextureError> {
    options.check()?;
    let roles = image_roles(scene.document());
    let mut report = TextureReport::default();
    let SceneParts { mut document, buffer, mut images, meshes } = scene.into_parts();
    let (mut to_webp, mut to_core) = (BTreeSet::new(), BTreeSet::new());
    for (index, image) in images.iter_mut().enumerate() {
        if image.bytes.is_empty() {
            report.unchanged_count += 1;
            continue;
        }
        let role = roles.get(index).copied().unwrap_or_default();
        let new = match recode(&image.bytes, role, options) {
            Ok(RecodedImage::Unchanged) => {
                report.unchanged_count += 1;
                continue;
            }
            Ok(RecodedImage::Changed(new)) => new,
            Ok(RecodedImage::Carried { reason }) => {
                report.warnings.push(format!("images[{index}]: {reason}"));
                continue;
            }
            Err(error @ (TextureError::Parameter { .. } | TextureError::Encode { .. })) => return Err(error),
            Err(error) => {
                report.warnings.push(format!("images[{index}]: {error}"));
                continue;
            }
        };
        let EncodedImage { format, width, height, bytes } = new;
        report.changed.push(ImageChange {
            image: index,
            size: (width, height),
            format,
            bytes_before: image.bytes.len(),
            bytes: bytes.len(),
        });
        (image.bytes, image.mime_type, image.uri) = (bytes, format.mime_type().to_owned(), String::new());
        if let Some(Value::Object(entry)) = document.pointer_mut(&format!("/images/{index}")) {
            entry.insert("mimeType".to_owned(), json!(format.mime_type()));
        }
        if format == ImageFormat::WebP { &mut to_webp } else { &mut to_core }.insert(index);
    }
    if !to_core.is_empty() {
        without_sources(&mut document, &to_core);
    }
    if !to_webp.is_empty() {
        with_webp_sources(&mut document, &to_webp);
    }
    let parts = SceneParts { document, buffer, images, meshes };
    let scene =
        Scene::from_parts(parts).map_err(|error| TextureError::Encode { reason: error.to_string() })?;
    Ok((scene, report))
}
