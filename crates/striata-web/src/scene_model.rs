//! A scene that is decoded from a stream: its document, images, and a [`Model`] for each mesh.

use std::rc::Rc;

use striata_scene::stream::{ImageState, SceneStreamInfo, SceneStreamUpdate};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::Model;
use crate::scene_document::{SceneDocument, SceneImage};
use crate::scene_parts::SharedScene;
use crate::stream_source::StreamSource;
use crate::streamed_model::StreamedModel;
use crate::{Failure, limits};

/// Maximum length of the first packet, bytes.
const MAX_HEAD_BYTES: usize = 1 << 26;

/// A scene. [Push](Self::push) the bytes of its stream; the models of its [meshes](Self::mesh) then show what
/// has arrived.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct SceneModel {
    shared: SharedScene,
    /// Bytes received so far, until the first packet is complete.
    head: Vec<u8>,
    is_checked: bool,
    /// Images that have improved since they were last asked for.
    images: Vec<u32>,
}

#[wasm_bindgen]
impl SceneModel {
    /// Creates a scene that has not received anything.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Appends bytes of the stream and decodes all complete packets.
    ///
    /// # Errors
    /// If the bytes are not a valid stream, or the scene is too large for a page. What was received before
    /// stays.
    pub fn push(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        if self.is_checked {
            let update = self.shared.borrow_mut().decoder.push(bytes)?;
            self.note(update);
            return Ok(());
        }
        self.head.extend_from_slice(bytes);
        let Some(info) = SceneStreamInfo::read(&self.head)? else {
            if self.head.len() > MAX_HEAD_BYTES {
                return Err(Failure::too_large("the document of the scene is too long"));
            }
            return Ok(());
        };
        limits::check_scene(&info)?;
        self.is_checked = true;
        self.shared.borrow_mut().changed = vec![Vec::new(); info.meshes.len()];
        let bytes = std::mem::take(&mut self.head);
        self.push(&bytes)
    }

    /// Ends a stream that was cut: decodes what the last, incomplete packet contains.
    ///
    /// # Errors
    /// If the scene cannot be drawn.
    pub fn finish(&mut self) -> Result<(), Failure> {
        if self.is_complete() {
            return Ok(());
        }
        let update = self.shared.borrow_mut().decoder.finish()?;
        self.note(update);
        Ok(())
    }

    /// Whether the document has arrived.
    #[wasm_bindgen(getter)]
    pub fn has_document(&self) -> bool {
        self.shared.borrow().decoder.document().is_some()
    }

    /// Whether every mesh can be drawn.
    #[wasm_bindgen(getter)]
    pub fn is_drawable(&self) -> bool {
        self.shared.borrow().decoder.is_drawable()
    }

    /// Whether the whole stream has been decoded.
    #[wasm_bindgen(getter)]
    pub fn is_complete(&self) -> bool {
        self.shared.borrow().decoder.is_complete()
    }

    /// Size of the whole stream in bytes, or 0 while it is unknown.
    #[wasm_bindgen(getter)]
    pub fn stream_bytes(&self) -> f64 {
        self.shared.borrow().decoder.stream_bytes().unwrap_or(0) as f64
    }

    /// Returns the document, its buffer and images, as far as they have arrived.
    ///
    /// # Errors
    /// If the document or the skins have not arrived.
    pub fn document(&self) -> Result<SceneDocument, Failure> {
        let received = self.shared.borrow().decoder.received_document()?;
        let images = received.images.into_iter().enumerate();
        let image = |(index, image): (usize, striata::mesh::Image)| SceneImage {
            is_full: self.has_whole_image(index),
            bytes: image.bytes,
            mime_type: image.mime_type,
            uri: image.uri,
        };
        Ok(SceneDocument {
            json: received.document.to_string(),
            buffer: received.buffer,
            has_animations: received.has_animations,
            images: images.map(image).collect(),
        })
    }

    /// Takes the numbers of the images that have improved since the last call.
    pub fn take_images(&mut self) -> Vec<u32> {
        std::mem::take(&mut self.images)
    }

    /// Returns the part of an image that has arrived.
    pub fn image(&self, index: usize) -> Option<SceneImage> {
        let shared = self.shared.borrow();
        let image = shared.decoder.image(index)?;
        Some(SceneImage {
            is_full: image.state == ImageState::Full,
            bytes: image.bytes.to_vec(),
            mime_type: String::new(),
            uri: String::new(),
        })
    }

    /// Number of glTF meshes; 0 before the document has arrived.
    #[wasm_bindgen(getter)]
    pub fn mesh_count(&self) -> usize {
        self.shared.borrow().decoder.mesh_count()
    }

    /// Returns the model of a mesh; nothing if the mesh has no triangles.
    pub fn mesh(&self, index: usize) -> Option<Model> {
        self.shared.borrow().decoder.mesh(index)?;
        let source = StreamSource::InScene(Rc::clone(&self.shared), index);
        Some(Model::of_stream(StreamedModel::of_source(source)))
    }
}

impl SceneModel {
    fn has_whole_image(&self, index: usize) -> bool {
        let shared = self.shared.borrow();
        shared.decoder.image(index).is_some_and(|image| image.state == ImageState::Full)
    }

    fn note(&mut self, update: SceneStreamUpdate) {
        let mut shared = self.shared.borrow_mut();
        for change in update.meshes {
            if let Some(changed) = shared.changed.get_mut(change.mesh) {
                changed.extend(change.update.changed_triangles);
            }
        }
        self.images.extend(update.images.into_iter().map(|image| image as u32));
    }
}
