//! Materials, textures, samplers and images, passed through unchanged.

use std::collections::BTreeSet;

use striata::mesh::{Appearance, Image, Material};

use super::document::Document;
use super::json::JsonNode;
use super::primitive::document_fault;
use super::uri;
use crate::error::{Fault, Place};
use crate::gltf_json::extensions_in;
use crate::images::{ImageBudget, ImageError, media_type};
use crate::report::Warnings;

/// Reads the materials, textures, samplers and images of a document.
pub(crate) fn appearance(document: &Document<'_>, warnings: &mut Warnings) -> Result<Appearance, Fault> {
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
    let images = images(document, warnings)?;
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

/// Reads all images, with a warning for each file that is not available.
pub(super) fn images(document: &Document<'_>, warnings: &mut Warnings) -> Result<Vec<Image>, Fault> {
    let mut budget = ImageBudget::new(document.input_bytes);
    let images = document.root.entries("images")?;
    images.iter().map(|at| image(document, at, &mut budget, warnings)).collect()
}

/// Reads an image with its bytes if they are available, otherwise with its URI and a warning.
fn image(
    document: &Document<'_>,
    at: &JsonNode<'_>,
    budget: &mut ImageBudget,
    warnings: &mut Warnings,
) -> Result<Image, Fault> {
    let mut image = Image {
        name: at.text("name").to_owned(),
        mime_type: at.text("mimeType").to_owned(),
        ..Image::default()
    };
    let uri = at.text("uri");
    let too_large = |error: ImageError| document_fault(error.to_string());
    if let Some(view) = at.unsigned("bufferView")? {
        let bytes = document.view(view, at)?.0;
        budget.take(bytes.len() as u64).map_err(too_large)?;
        image.bytes = bytes.to_vec();
    } else if let Some(data) = uri::data(uri) {
        let (bytes, mime_type) = data.map_err(|reason| at.fault(reason))?;
        budget.take(bytes.len() as u64).map_err(too_large)?;
        image.bytes = bytes;
        if image.mime_type.is_empty() {
            image.mime_type = mime_type;
        }
    } else if uri.is_empty() {
        warnings.push(Place::Json(at.path.clone()), "the image has no data and names no file");
    } else {
        image.uri = uri.to_owned();
        let read = uri::path(uri, &document.source).map(|path| budget.read(&path));
        let reason = match read {
            Ok(Err(error @ ImageError::TooLarge { .. })) => return Err(too_large(error)),
            Ok(Err(error)) => Some(format!("texture `{}`: {error}", uri::shortened(uri))),
            Ok(Ok(bytes)) => {
                image.bytes = bytes;
                None
            }
            Err(reason) => Some(reason),
        };
        if let Some(reason) = reason {
            warnings.push(Place::Json(at.path.clone()), reason);
        }
    }
    if image.mime_type.is_empty() {
        image.mime_type = media_type(&image.bytes).to_owned();
    }
    Ok(image)
}
