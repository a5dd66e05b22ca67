//! Materials, textures, samplers and images, passed through unchanged.

use std::collections::BTreeSet;
use std::fs;

use serde_json::Value;
use striata::mesh::{Appearance, Image, Material};

use super::document::Document;
use super::json::JsonNode;
use super::primitive::document_fault;
use super::uri;
use crate::error::Fault;

/// Memory that images may take regardless of the file size, in bytes.
const ALWAYS_ALLOWED_BYTES: u64 = 1 << 30;

/// Additional memory allowed per byte of the file.
const BYTES_PER_INPUT_BYTE: u64 = 64;

/// Reads the materials, textures, samplers and images of a document.
pub(super) fn appearance(document: &Document<'_>) -> Result<Appearance, Fault> {
    let root = &document.root;
    let mut extensions = BTreeSet::new();
    let mut raw = |at: &JsonNode<'_>| {
        extensions_in(at.value, &mut extensions);
        at.value.to_string()
    };
    let material = |at: JsonNode<'_>, gltf_json| Material { name: at.text("name").to_owned(), gltf_json };
    let materials = root.entries("materials")?.into_iter().map(|at| {
        let gltf_json = raw(&at);
        material(at, gltf_json)
    });
    let materials = materials.collect();
    let textures_json = root.entries("textures")?.iter().map(&mut raw).collect();
    let samplers_json = root.entries("samplers")?.iter().map(&mut raw).collect();
    let (images, _) = images(document)?;
    let extensions_used = extensions.into_iter().collect();
    Ok(Appearance {
        materials,
        images,
        textures_json,
        samplers_json,
        extensions_used,
        ..Appearance::default()
    })
}

/// Reads all images; also returns a warning for each file that is not available.
pub(super) fn images(document: &Document<'_>) -> Result<(Vec<Image>, Vec<String>), Fault> {
    let (mut images, mut warnings) = (Vec::new(), Vec::new());
    let mut image_bytes = 0;
    for at in document.root.entries("images")? {
        let image = image(document, &at, &mut warnings)?;
        image_bytes += image.bytes.len() as u64;
        if image_bytes > ALWAYS_ALLOWED_BYTES.max(document.input_bytes * BYTES_PER_INPUT_BYTE) {
            let input_bytes = document.input_bytes;
            return Err(document_fault(format!(
                "{image_bytes} bytes of images in a file of {input_bytes} bytes"
            )));
        }
        images.push(image);
    }
    Ok((images, warnings))
}

/// Collects the names of all extensions used within a value.
pub(super) fn extensions_in(value: &Value, found: &mut BTreeSet<String>) {
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

/// Reads an image with its bytes if they are available, otherwise with its URI.
fn image(document: &Document<'_>, at: &JsonNode<'_>, warnings: &mut Vec<String>) -> Result<Image, Fault> {
    let mut image = Image {
        name: at.text("name").to_owned(),
        mime_type: at.text("mimeType").to_owned(),
        ..Image::default()
    };
    let uri = at.text("uri");
    if let Some(view) = at.unsigned("bufferView")? {
        image.bytes = document.view(view, at)?.0.to_vec();
    } else if let Some(data) = uri::data(uri) {
        let (bytes, mime_type) = data.map_err(|reason| at.fault(reason))?;
        image.bytes = bytes;
        if image.mime_type.is_empty() {
            image.mime_type = mime_type;
        }
    } else {
        image.uri = uri.to_owned();
        match file_bytes(uri, document) {
            Ok(bytes) => image.bytes = bytes,
            Err(reason) => warnings.push(format!("{}: {reason}", at.path)),
        }
    }
    if image.mime_type.is_empty() {
        image.mime_type = mime_type(&image.bytes).to_owned();
    }
    Ok(image)
}

/// Reads the file of an image, or says why this is not possible.
fn file_bytes(uri: &str, document: &Document<'_>) -> Result<Vec<u8>, String> {
    let path = uri::path(uri, &document.source)?;
    if path.exists() && !path.is_file() {
        return Err(format!("`{}` is not a regular file", uri::shortened(uri)));
    }
    fs::read(&path).map_err(|error| format!("`{}`: {error}", uri::shortened(uri)))
}

/// Detects the media type of an image by its first bytes.
fn mime_type(bytes: &[u8]) -> &'static str {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => "image/png",
        [0xff, 0xd8, 0xff, ..] => "image/jpeg",
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => "image/webp",
        [0xab, b'K', b'T', b'X', b' ', b'2', b'0', ..] => "image/ktx2",
        [b'D', b'D', b'S', b' ', ..] => "image/vnd-ms.dds",
        _ => "",
    }
}
