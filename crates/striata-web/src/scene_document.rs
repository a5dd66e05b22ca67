//! The document of a scene and its images, as a page takes them.

use wasm_bindgen::prelude::wasm_bindgen;

/// The document of a scene, its buffer and images. Each `take_` method returns its part once.
#[wasm_bindgen]
#[derive(Debug)]
pub struct SceneDocument {
    pub(crate) json: String,
    pub(crate) buffer: Vec<u8>,
    pub(crate) has_animations: bool,
    pub(crate) images: Vec<SceneImage>,
}

#[wasm_bindgen]
impl SceneDocument {
    /// The glTF document as JSON, without geometry, images and `buffers`.
    pub fn take_json(&mut self) -> String {
        std::mem::take(&mut self.json)
    }

    /// The buffer that the document's buffer views refer to.
    pub fn take_buffer(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.buffer)
    }

    /// Whether the document has all of its animations.
    #[wasm_bindgen(getter)]
    pub fn has_animations(&self) -> bool {
        self.has_animations
    }

    /// Takes the first image that was not taken yet.
    pub fn take_image(&mut self) -> Option<SceneImage> {
        (!self.images.is_empty()).then(|| self.images.remove(0))
    }
}

/// An image of a scene, or its preview.
#[wasm_bindgen]
#[derive(Debug)]
pub struct SceneImage {
    /// Whether this is the image itself.
    pub is_full: bool,
    pub(crate) bytes: Vec<u8>,
    pub(crate) mime_type: String,
    pub(crate) uri: String,
}

#[wasm_bindgen]
impl SceneImage {
    /// The image file; empty if the scene does not contain it.
    pub fn take_bytes(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.bytes)
    }

    /// MIME type; empty if it is unknown.
    #[wasm_bindgen(getter)]
    pub fn mime_type(&self) -> String {
        self.mime_type.clone()
    }

    /// URI of the image in the source of the scene; empty if it had none.
    #[wasm_bindgen(getter)]
    pub fn uri(&self) -> String {
        self.uri.clone()
    }
}
