//! Textures: re-encoding of images and scenes, previews, limits, and damaged images.
use crate::samples::{self, encoded, ktx2, picture};
use image::{ImageFormat as Format, RgbaImage};
use serde_json::json;
use striata_scene::textures::{
    AlphaUse, ImageFormat, RecodedImage, TextureError, TextureFormat, TextureOptions, TextureRole,
    TextureTransfer, image_info, preview, recode, recode_scene,
};

const COLOR: TextureRole = TextureRole { transfer: TextureTransfer::Srgb, alpha: AlphaUse::Unused };
const COVERED: TextureRole = TextureRole { transfer: TextureTransfer::Srgb, alpha: AlphaUse::Coverage };

fn pixels(bytes: &[u8]) -> RgbaImage {
    image::load_from_memory(bytes).unwrap().into_rgba8()
}

fn changed(bytes: &[u8], role: TextureRole, options: TextureOptions) -> (ImageFormat, Vec<u8>) {
    match recode(bytes, role, &options).unwrap() {
        RecodedImage::Changed(new) => (new.format, new.bytes),
        other => panic!("{other:?}"),
    }
}

#[test]
fn images_that_are_as_requested_are_not_touched() {
    let options = TextureOptions::default();
    for format in [Format::Png, Format::Jpeg, Format::WebP] {
        let bytes = encoded(&picture(40, false, 1), format);
        assert_eq!(recode(&bytes, COLOR, &options).unwrap(), RecodedImage::Unchanged);
        let large = options.with_max_side(Some(40));
        assert_eq!(recode(&bytes, COLOR, &large).unwrap(), RecodedImage::Unchanged);
    }
    // Alpha that a JPEG could not keep.
    let clear = encoded(&picture(40, true, 1), Format::Png);
    let jpeg = options.with_format(Some(TextureFormat::Jpeg));
    assert_eq!(recode(&clear, COVERED, &jpeg).unwrap(), RecodedImage::Unchanged);
    assert_eq!(changed(&clear, COLOR, jpeg).0, ImageFormat::Jpeg);
}

#[test]
fn images_are_converted_and_reduced() {
    let original = picture(40, true, 2);
    let bytes = encoded(&original, Format::Png);
    let options = TextureOptions::default();
    let (format, webp) = changed(&bytes, COVERED, options.with_format(Some(TextureFormat::WebP)));
    assert_eq!(format, ImageFormat::WebP);
    assert_eq!(pixels(&webp), original, "WebP is lossless");
    let (format, small) = changed(&bytes, COVERED, options.with_max_side(Some(11)));
    assert_eq!(format, ImageFormat::Png);
    assert_eq!(pixels(&small).dimensions(), (11, 11));
    assert!(pixels(&small).pixels().any(|pixel| pixel[3] == 90), "alpha is kept");
    let info = image_info(&small).unwrap();
    assert_eq!((info.width, info.height), (11, 11));
}

#[test]
fn wrong_options_and_unknown_bytes_are_errors() {
    let bytes = encoded(&picture(8, false, 3), Format::Png);
    for options in
        [TextureOptions::default().with_max_side(Some(0)), TextureOptions::default().with_quality(0)]
    {
        assert!(matches!(recode(&bytes, COLOR, &options), Err(TextureError::Parameter { .. })));
    }
    let options = TextureOptions::default().with_max_side(Some(4));
    assert!(matches!(recode(b"GIF89a", COLOR, &options), Err(TextureError::Format { .. })));
    let carried = recode(&ktx2(), COLOR, &options).unwrap();
    assert!(matches!(carried, RecodedImage::Carried { .. }), "{carried:?}");
    assert_eq!(recode(&ktx2(), COLOR, &TextureOptions::default()).unwrap(), RecodedImage::Unchanged);
}

#[test]
fn texture_bombs_are_refused_by_their_header() {
    for (width, height) in [(60_000u32, 60_000u32), (16_384, 16_384), (u32::MAX, 1)] {
        let mut bytes = encoded(&picture(8, false, 4), Format::Png);
        bytes[16..20].copy_from_slice(&width.to_be_bytes());
        bytes[20..24].copy_from_slice(&height.to_be_bytes());
        let checksum = crc32fast::hash(&bytes[12..29]);
        bytes[29..33].copy_from_slice(&checksum.to_be_bytes());
        let error = recode(&bytes, COLOR, &TextureOptions::default().with_max_side(Some(64))).unwrap_err();
        assert!(matches!(error, TextureError::TooLarge { .. }), "{error}");
        assert_eq!(preview(&bytes, COLOR, 64), None);
    }
}

#[test]
fn previews_are_small_and_look_alike() {
    let original = picture(512, false, 5);
    let bytes = encoded(&original, Format::Png);
    let found = preview(&bytes, COLOR, 64).unwrap();
    assert_eq!((found.image.width, found.image.height), (64, 64));
    assert!(found.image.bytes.len() < 6000, "{}", found.image.bytes.len());
    let small = pixels(&found.image.bytes);
    let (near, far) = (small.get_pixel(2, 2), small.get_pixel(61, 61));
    assert!(near[0] < 60 && far[0] > 170, "{near:?} {far:?}");
    assert!(found.lost_contrast > 0.02 && found.lost_contrast < 0.2, "{}", found.lost_contrast);
    assert!(found.contrast > found.lost_contrast && found.contrast < 0.5, "{}", found.contrast);
    let flat = encoded(&RgbaImage::from_pixel(300, 200, image::Rgba([9, 80, 200, 255])), Format::Png);
    let found = preview(&flat, COLOR, 64).unwrap();
    assert_eq!((found.average, found.contrast, found.lost_contrast), ([9, 80, 200, 255], 0.0, 0.0));
    assert_eq!(found.image.format, ImageFormat::Png, "PNG is smaller for flat images");
    assert_eq!((found.image.width, found.image.height), (64, 43));
    let covered = preview(&encoded(&picture(100, true, 6), Format::Png), COVERED, 64).unwrap();
    assert_eq!(covered.image.format, ImageFormat::Png, "alpha is kept");
    assert!((150..200).contains(&covered.average[3]), "{:?}", covered.average);
}

#[test]
fn damaged_images_are_errors_or_images() {
    for format in [Format::Png, Format::Jpeg, Format::WebP] {
        let bytes = encoded(&picture(16, true, 7), format);
        for at in 0..bytes.len() {
            let mut bad = bytes.clone();
            bad[at] ^= 0xa5;
            let _ = preview(&bad, COVERED, 8);
            let _ = preview(&bytes[..at], COVERED, 8);
        }
    }
}

#[test]
fn scenes_are_re_encoded_with_their_references() {
    let scene = samples::scene(2);
    let options = TextureOptions::default().with_max_side(Some(16)).with_format(Some(TextureFormat::WebP));
    let (webp, report) = recode_scene(scene.clone(), &options).unwrap();
    assert_eq!(report.changed.len(), 3);
    assert_eq!(report.warnings.len(), 1, "{:?}", report.warnings);
    assert!(report.warnings[0].starts_with("images[2]: KTX2"));
    let document = webp.document();
    for texture in [0, 1, 3] {
        let expected = json!({ "extensions": { "EXT_texture_webp": { "source": texture } } });
        assert_eq!(document["textures"][texture], expected);
        assert_eq!(document["images"][texture]["mimeType"], "image/webp");
        assert_eq!(image_info(&webp.images()[texture].bytes).unwrap().format, ImageFormat::WebP);
    }
    let extensions = json!(["KHR_texture_basisu", "EXT_texture_webp"]);
    assert_eq!(document["extensionsUsed"], extensions);
    assert_eq!(document["extensionsRequired"], extensions);
    assert_eq!(webp.images()[2], scene.images()[2]);
    let back = TextureOptions::default().with_format(Some(TextureFormat::Png));
    let (png, report) = recode_scene(webp, &back).unwrap();
    assert_eq!(report.changed.len(), 3);
    assert_eq!(png.document()["textures"], scene.document()["textures"]);
    assert_eq!(png.document()["extensionsUsed"], scene.document()["extensionsUsed"]);
    assert_eq!(png.document()["images"][1]["mimeType"], "image/png");
    let (same, report) = recode_scene(scene.clone(), &TextureOptions::default()).unwrap();
    assert_eq!((same, report.unchanged_count), (scene, 4));
}
