//! The scene that has been received so far.

use std::collections::BTreeSet;

use serde_json::{Value, json};
use striata::mesh::{Image, IndexedMesh, TriangleGroup};
use striata_io::{Scene, SceneParts};

use super::SceneStreamError;
use super::buffer::animated_accessors;
use super::head::SceneHead;
use super::images::ImageState;
use super::json::triangle_primitives;
use super::received::Received;
use crate::textures::{ImageFormat, placeholder_png, without_sources};

/// Buffers up to this length are filled with zeros while parts of them are missing, bytes.
const ZEROED_BYTES: u64 = 1 << 26;

/// Larger buffers need one received byte for this many bytes of zeros.
const ZEROED_PER_BYTE: u64 = 1024;

/// Checks that document and table belong together, before anything else arrives.
pub(super) fn check_head(head: &SceneHead) -> Result<(), SceneStreamError> {
    let fail = |reason: String| Err(SceneStreamError::Document(reason));
    for (mesh, entry) in head.meshes.iter().enumerate() {
        let Some(entry) = entry else { continue };
        let primitives = triangle_primitives(&head.document, mesh).count();
        // Without groups, one primitive contains all triangles.
        let groups = entry.group_count.max(1);
        if groups as usize != primitives {
            return fail(format!("meshes[{mesh}] has {groups} groups for {primitives} triangle primitives"));
        }
    }
    let entries = |key: &str| head.document.get(key).and_then(Value::as_array).map_or(0, Vec::len);
    for (key, found) in [("meshes", head.meshes.len()), ("images", head.images.len())] {
        let expected = entries(key);
        if found != expected {
            return fail(format!("the table has {found} {key}, but the document has {expected}"));
        }
    }
    Ok(())
}

/// Everything of a scene but its geometry, as far as it has been received.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct ReceivedDocument {
    /// The glTF document. Attributes of triangle primitives are `null`, images have neither `uri` nor
    /// `bufferView`, and there are no `buffers`. It has no animations until their data has arrived.
    pub document: Value,
    /// The buffer that the document's buffer views refer to.
    pub buffer: Vec<u8>,
    /// The images; previews or single pixels of the average color instead of those that have not arrived.
    pub images: Vec<Image>,
    /// Whether the data of animations has arrived, or there is none.
    pub has_animations: bool,
}

/// Puts the document together, given the number of bytes received.
pub(super) fn prefix_document(received: &Received, bytes: u64) -> Result<ReceivedDocument, SceneStreamError> {
    let mut document = received.head.document.clone();
    let has_animations = received.parts[1].is_some() || received.head.buffer[1].is_empty();
    let buffer = buffer_of(received, bytes, &mut document)?;
    let images = images_of(received, &mut document);
    Ok(ReceivedDocument { document, buffer, images, has_animations })
}

/// Builds the scene of everything that has been received, given the number of bytes received.
pub(super) fn prefix_scene(received: &Received, bytes: u64) -> Result<Scene, SceneStreamError> {
    let ReceivedDocument { document, buffer, images, .. } = prefix_document(received, bytes)?;
    let meshes = received.head.meshes.iter().enumerate().map(|(mesh, entry)| {
        let group_count = entry.as_ref()?.group_count;
        let refinable = received.mesh(mesh)?.refinable_mesh().map(|refinable| refinable.mesh);
        Some(refinable.unwrap_or_else(|| empty_mesh(group_count)))
    });
    let meshes = meshes.collect();
    Ok(Scene::from_parts(SceneParts { document, buffer, images, meshes })?)
}

/// A mesh that shows nothing; the number of groups was compared with the document.
fn empty_mesh(group_count: u32) -> IndexedMesh {
    let groups = vec![TriangleGroup::default(); group_count as usize];
    IndexedMesh { groups, ..IndexedMesh::default() }
}

/// Puts the parts of the buffer together. Without the part for animations, the document loses its animations.
fn buffer_of(received: &Received, bytes: u64, document: &mut Value) -> Result<Vec<u8>, SceneStreamError> {
    let length = received.head.buffer_bytes();
    let is_missing = |part: usize| received.parts[part].is_none() && !received.head.buffer[part].is_empty();
    let is_zeroed_too_long = length > ZEROED_BYTES.max(bytes.saturating_mul(ZEROED_PER_BYTE));
    if is_missing(0) || is_missing(1) && is_zeroed_too_long {
        let drawable_at = received.document_end.saturating_add(received.head.base_bytes);
        return Err(SceneStreamError::NotDrawable { found: bytes, needed: drawable_at.max(bytes + 1) });
    }
    if is_missing(1) {
        remove_animations(document);
    }
    let mut buffer = vec![0; usize::try_from(length).unwrap_or(0)];
    for (ranges, part) in received.head.buffer.iter().zip(&received.parts) {
        let Some(mut rest) = part.as_deref() else { continue };
        for range in ranges {
            let (own, others) = rest.split_at(range.length as usize);
            buffer[range.offset as usize..][..own.len()].copy_from_slice(own);
            rest = others;
        }
    }
    Ok(buffer)
}

/// Removes the animations of a document, and the ranges of their numbers, which have not arrived.
fn remove_animations(document: &mut Value) {
    let animated = animated_accessors(document);
    let Some(root) = document.as_object_mut() else { return };
    root.remove("animations");
    let accessors = root.get_mut("accessors").and_then(Value::as_array_mut).into_iter().flatten();
    let animated = accessors.enumerate().filter(|(index, _)| animated.contains(index));
    for entry in animated.filter_map(|(_, accessor)| accessor.as_object_mut()) {
        entry.remove("min");
        entry.remove("max");
    }
}

/// Returns the images, and adapts MIME types and textures to those that are not complete.
fn images_of(received: &Received, document: &mut Value) -> Vec<Image> {
    let mut replaced = BTreeSet::new();
    let mut images = Vec::with_capacity(received.images.len());
    for (index, entry) in received.head.images.iter().enumerate() {
        let found = received.image(index);
        let mut image = Image {
            name: entry.name.clone(),
            uri: entry.uri.clone(),
            mime_type: entry.mime_type.clone(),
            bytes: found.bytes.to_vec(),
        };
        if matches!(found.state, ImageState::Placeholder | ImageState::Preview) {
            if found.state == ImageState::Placeholder {
                image.bytes = placeholder_png(found.average);
            }
            let format = ImageFormat::detect(&image.bytes).unwrap_or(ImageFormat::Png);
            image.mime_type = format.mime_type().to_owned();
            if let Some(Value::Object(entry)) = document.pointer_mut(&format!("/images/{index}")) {
                entry.insert("mimeType".to_owned(), json!(format.mime_type()));
            }
            replaced.insert(index);
        }
        images.push(image);
    }
    if !replaced.is_empty() {
        without_sources(document, &replaced);
    }
    images
}
