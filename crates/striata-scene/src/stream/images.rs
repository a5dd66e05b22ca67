//! Images of a stream: previews for the writer, and what the reader has of each image.

use striata::{Cancelled, Progress, ProgressFn};
use striata_io::Scene;

use super::head::ImageEntry;
use super::image_use::image_areas;
use super::schedule::{Item, WholeCosts};
use crate::textures::{TextureRole, image_info, image_roles};

/// Image as a writer sends it: its entry in the table, its preview, and measures of its importance.
#[derive(Clone, Debug, Default)]
pub(super) struct PreparedImage {
    pub entry: ImageEntry,
    /// Preview, or nothing.
    pub preview: Vec<u8>,
    /// Whether the image itself is small enough to take the place of its preview.
    pub is_early: bool,
    /// Area that the image is seen on, square units of the scene, weighted by role.
    area: f64,
    /// Contrast that the preview shows and that a single color has lost, 0 to 1.
    contrast: f64,
    /// Contrast that the preview has lost, 0 to 1.
    lost_contrast: f64,
}

/// Images up to this many times the size of their preview are sent instead of it.
const EARLY_FACTOR: usize = 2;

/// Images up to this length are sent early if there is no preview, bytes.
const EARLY_BYTES: usize = 1024;

/// Contrast that is assumed to be lost if an image cannot be decoded.
const UNKNOWN_CONTRAST: f64 = 0.1;

/// Makes previews of all images.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
pub(super) fn prepare(
    scene: &Scene,
    preview_side: u32,
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<PreparedImage>, Cancelled> {
    let roles = image_roles(scene.document());
    let areas = image_areas(scene);
    let prepare = |(index, image): (usize, &striata::mesh::Image)| {
        let role = roles.get(index).copied().unwrap_or_default();
        let mut entry = ImageEntry {
            bytes: image.bytes.len() as u64,
            average: role.neutral(),
            name: image.name.clone(),
            uri: image.uri.clone(),
            mime_type: image.mime_type.clone(),
            ..ImageEntry::default()
        };
        let area = areas[index];
        if let Ok(info) = image_info(&image.bytes) {
            entry.size = (info.width, info.height);
        }
        let Some(SmallImage { bytes, average, contrast, lost_contrast }) =
            preview_of(&image.bytes, role, preview_side)
        else {
            let is_early = !image.bytes.is_empty() && image.bytes.len() <= EARLY_BYTES;
            let lost_contrast = UNKNOWN_CONTRAST;
            return PreparedImage { entry, is_early, area, lost_contrast, ..Default::default() };
        };
        entry.average = average;
        if image.bytes.len() <= EARLY_FACTOR * bytes.len() {
            return PreparedImage {
                entry,
                is_early: true,
                area,
                contrast,
                lost_contrast,
                ..Default::default()
            };
        }
        entry.preview_bytes = bytes.len() as u64;
        PreparedImage { entry, preview: bytes, is_early: false, area, contrast, lost_contrast }
    };
    let total = scene.images().len() as u64;
    let images = scene.images().iter().enumerate().map(|(index, image)| {
        Progress { phase: "previews", done: index as u64, total }.report(progress)?;
        Ok(prepare((index, image)))
    });
    images.collect()
}

/// A preview with its measures.
struct SmallImage {
    bytes: Vec<u8>,
    average: [u8; 4],
    contrast: f64,
    lost_contrast: f64,
}

#[cfg(feature = "textures")]
fn preview_of(bytes: &[u8], role: TextureRole, max_side: u32) -> Option<SmallImage> {
    use crate::textures::{TextureTransfer, preview};

    // Colors decide how a small picture looks; other maps are good enough at half of the size.
    let max_side = if role.transfer == TextureTransfer::Srgb { max_side } else { max_side.div_ceil(2) };
    let preview = preview(bytes, role, max_side)?;
    Some(SmallImage {
        bytes: preview.image.bytes,
        average: preview.average,
        contrast: f64::from(preview.contrast),
        lost_contrast: f64::from(preview.lost_contrast),
    })
}

#[cfg(not(feature = "textures"))]
fn preview_of(_: &[u8], _: TextureRole, _: u32) -> Option<SmallImage> {
    None
}

impl PreparedImage {
    /// Returns the preview and the image with the geometric errors that they stand for, in a scene with this diagonal.
    pub(super) fn costs(&self, image: usize, diagonal: f64) -> Vec<WholeCosts> {
        let error_of = |contrast: f64| {
            let error = self.area * contrast / (4.0 * diagonal);
            if error.is_finite() { error } else { 0.0 }
        };
        let (bytes, preview_bytes) = (self.entry.bytes, self.preview.len() as u64);
        let item = Item::Image(image);
        if bytes == 0 {
            return Vec::new();
        }
        if preview_bytes == 0 {
            let error = error_of(self.contrast.hypot(self.lost_contrast));
            return vec![WholeCosts { item, bytes, error }];
        }
        let error = error_of(self.contrast);
        let preview = WholeCosts { item: Item::Preview(image), bytes: preview_bytes, error };
        // The preview comes first: an image that gains more per byte waits for it.
        let most = error * bytes as f64 / preview_bytes as f64;
        vec![preview, WholeCosts { item, bytes, error: error_of(self.lost_contrast).min(most) }]
    }
}

/// How much of an image has been received.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageState {
    /// The source has no bytes for this image.
    Missing,
    /// Only its average color is known.
    Placeholder,
    /// A small version of it has been received.
    Preview,
    /// It is complete.
    Full,
}

/// Part of an image that has been received: the image, its preview, or its average color only.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ReceivedImage<'d> {
    /// How much has been received.
    pub state: ImageState,
    /// The image or its preview as a file; empty if neither has been received.
    pub bytes: &'d [u8],
    /// Average color, RGBA.
    pub average: [u8; 4],
}
