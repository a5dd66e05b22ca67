//! Saves screenshots of the window as PNG files.

use std::path::Path;

use striata_gpu::Picture;

use striata_command::failure::Failure;

/// Writes a picture without its opacity, since a window is opaque.
///
/// # Errors
/// If the file cannot be written.
pub(super) fn save(picture: &Picture, path: &Path) -> Result<(), Failure> {
    let bytes = encode(picture)
        .map_err(|error| Failure::internal(format!("cannot encode the screenshot: {error}")))?;
    Ok(striata_io::write_atomically(path, |out| out.write_all(&bytes))?)
}

fn encode(picture: &Picture) -> Result<Vec<u8>, png::EncodingError> {
    let rgb: Vec<u8> = picture.rgba.as_chunks().0.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    Ok(file)
}
