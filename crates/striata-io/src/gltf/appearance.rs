//! Materials, textures, samplers and images, passed through unchanged.

use std::collections::BTreeSet;

use serde_json::Value;
use striata::mesh::{Appearance, Image, Material};

use super::document::GltfDocument;
use super::georeference::georeference_in;
use super::json::JsonNode;
use super::primitive::document_fault;
use super::uri;
use crate::companions::{Companions, NameKind};
use crate::error::{Fault, Place};
use crate::gltf_json::extensions_in;
use crate::images::{ImageBudget, ImageError, image_from_afar, media_type, png_of};
use crate::report::Warnings;

/// Reads the materials, textures, samplers and images of a document.
pub(crate) fn appearance(document: &GltfDocument<'_>, warnings: &mut Warnings) -> Result<Appearance, Fault> {
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
        georeference: georeference_in(root.value).map(Value::to_string).unwrap_or_default(),
        materials,
        images,
        textures_json,
        samplers_json,
        extensions_used,
        ..Appearance::default()
    })
}

/// Reads all images, with a warning for each file that is not available.
pub(super) fn images(document: &GltfDocument<'_>, warnings: &mut Warnings) -> Result<Vec<Image>, Fault> {
    let mut reader = ImageReader {
        document,
        companions: Companions::new(&document.source),
        budget: ImageBudget::new(document.input_bytes),
        warnings,
    };
    document.root.entries("images")?.iter().map(|at| reader.image(at)).collect()
}

/// Reads images one after another.
struct ImageReader<'r, 'd> {
    document: &'r GltfDocument<'d>,
    companions: Companions<'d>,
    budget: ImageBudget,
    warnings: &'r mut Warnings,
}

impl ImageReader<'_, '_> {
    /// Reads an image with its bytes if they are available, otherwise with its URI and a warning.
    fn image(&mut self, at: &JsonNode<'_>) -> Result<Image, Fault> {
        let mut image = Image {
            name: at.text("name").to_owned(),
            mime_type: at.text("mimeType").to_owned(),
            ..Image::default()
        };
        let uri = at.text("uri");
        if let Some(view) = at.unsigned("bufferView")? {
            let bytes = self.document.view(view, at)?.0;
            self.take(bytes.len())?;
            image.bytes = bytes.to_vec();
        } else if let Some(data) = uri::data(uri) {
            let (bytes, mime_type) = data.map_err(|reason| at.fault(reason))?;
            self.take(bytes.len())?;
            image.bytes = bytes;
            if image.mime_type.is_empty() {
                image.mime_type = mime_type;
            }
        } else if uri.is_empty() {
            self.warn(at, "the image has no data and names no file".to_owned());
        } else {
            image.uri = uri.to_owned();
            image.bytes = self.file(at, uri)?;
        }
        match png_of(&image.bytes, if image.uri.is_empty() { &image.name } else { &image.uri }) {
            Some(Ok(png)) => (image.bytes, image.mime_type) = (png, "image/png".to_owned()),
            Some(Err(reason)) => self.warn(at, reason),
            None => {}
        }
        if image.mime_type.is_empty() {
            image.mime_type = media_type(&image.bytes).to_owned();
        }
        Ok(image)
    }

    /// Returns the bytes of the file that a URI names; empty with a warning if it is not available.
    fn file(&mut self, at: &JsonNode<'_>, uri: &str) -> Result<Vec<u8>, Fault> {
        let companion = self.companions.find("", uri, NameKind::Uri);
        let is_outside = companion.is_outside();
        let read = match companion.file.map(|found| self.budget.read(found.file)) {
            Ok(Err(error @ ImageError::TooLarge { .. })) => return Err(document_fault(error.to_string())),
            Ok(read) => read.map_err(|error| error.to_string()),
            Err(reason) => Err(reason),
        };
        Ok(read.and_then(|bytes| image_from_afar(bytes, uri, is_outside)).unwrap_or_else(|reason| {
            self.warn(at, format!("texture `{}`: {reason}", uri::shortened(uri)));
            Vec::new()
        }))
    }

    fn take(&mut self, length: usize) -> Result<(), Fault> {
        self.budget.take(length as u64).map_err(|error| document_fault(error.to_string()))
    }

    fn warn(&mut self, at: &JsonNode<'_>, reason: String) {
        self.warnings.push(Place::Json(at.path.clone()), reason);
    }
}
