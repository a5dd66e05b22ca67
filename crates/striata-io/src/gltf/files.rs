//! Forms of a glTF file: GLB, JSON with everything embedded, or JSON with files next to it.

use std::path::Path;

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, utf8_percent_encode};
use serde_json::json;
use striata::mesh::Image;

use super::passes::GltfParts;
use super::{container, uri};
use crate::error::Refusal;
use crate::image_files::ImageFiles;
use crate::report::Warnings;
use crate::{Format, WriteOptions};

/// Destination of a document, and of the remarks on what its compression changes.
pub(crate) struct GltfContainer<'f, 'm> {
    form: Form<'f, 'm>,
    warnings: &'f mut Warnings,
}

/// Destination of the binary data and images of a document.
enum Form<'f, 'm> {
    /// Into the file, which is GLB.
    Glb,
    /// Into the file, as text.
    Embedded,
    /// Into files next to it.
    Files { images: &'f mut ImageFiles<'m>, output: &'f Path },
}

impl<'f, 'm> GltfContainer<'f, 'm> {
    /// Creates the container of a file; only one with a path can have others next to it.
    pub(crate) fn new(
        format: Format,
        options: &WriteOptions,
        path: Option<&'f Path>,
        images: &'f mut ImageFiles<'m>,
        warnings: &'f mut Warnings,
    ) -> Self {
        let form = match path {
            _ if format == Format::Glb => Form::Glb,
            Some(output) if !options.embed => Form::Files { images, output },
            _ => Form::Embedded,
        };
        Self { form, warnings }
    }

    /// Returns the URI of each image that becomes a file of its own.
    pub(super) fn image_uris(&mut self, all: &[Image]) -> Vec<Option<String>> {
        let Self { form: Form::Files { images, .. }, warnings } = self else { return Vec::new() };
        let is_stored = |image: &Image| !image.bytes.is_empty() && !image.mime_type.is_empty();
        let mut name_of = |index: usize| images.name_of(index, warnings);
        let stored = all.iter().enumerate().map(|(index, image)| is_stored(image).then_some(index));
        stored.map(|index| name_of(index?).as_deref().map(encoded)).collect()
    }

    /// Quantizes and compresses a document as the options say, and returns the contents of the file itself.
    pub(super) fn packed(self, mut parts: GltfParts, options: &WriteOptions) -> Result<Vec<u8>, Refusal> {
        parts.apply(options, self.warnings)?;
        if matches!(self.form, Form::Glb) {
            return container::joined(parts.to_json().into_bytes(), parts.binary)
                .ok_or_else(|| Refusal::Unsupported("the file would be larger than 4 GiB".to_owned()));
        }
        parts.parse_written()?;
        if let Some(buffer) = parts.root.pointer_mut("/buffers/0") {
            buffer["uri"] = json!(self.buffer_uri(parts.binary));
        }
        Ok(format!("{:#}\n", parts.root).into_bytes())
    }

    fn buffer_uri(self, binary: Vec<u8>) -> String {
        let Self { form: Form::Files { images, output }, warnings } = self else {
            return format!("data:application/octet-stream;base64,{}", uri::to_base64(&binary));
        };
        let name = output.file_name().map(|name| name.to_string_lossy().into_owned());
        let stem = name.as_deref().and_then(|name| name.split(".gltf").next()).unwrap_or("scene");
        let wanted = format!("{stem}.bin");
        let is_ours = is_named_in(output, &encoded(&wanted));
        let is_own: fn(&[u8]) -> bool = if is_ours { |_| true } else { |_| false };
        encoded(&images.add(&wanted, binary, is_own, warnings))
    }
}

/// Whether a glTF file that the output replaces has a buffer of this name, which is then replaced too.
fn is_named_in(output: &Path, name: &str) -> bool {
    let Ok(text) = std::fs::read(output) else { return false };
    let Ok(document) = serde_json::from_slice::<serde_json::Value>(&text) else { return false };
    document.pointer("/buffers/0/uri").and_then(serde_json::Value::as_str) == Some(name)
}

/// Returns a relative path as a URI.
fn encoded(path: &str) -> String {
    const RESERVED: AsciiSet =
        NON_ALPHANUMERIC.remove(b'-').remove(b'.').remove(b'_').remove(b'~').remove(b'/');
    utf8_percent_encode(path, &RESERVED).to_string()
}
