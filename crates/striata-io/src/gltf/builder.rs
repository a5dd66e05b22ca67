//! Parts of a document that grow while it is written: bytes, buffer views and accessors.

use serde_json::{Value, json};

const ARRAY_BUFFER: u32 = 34962;
pub(super) const ELEMENT_ARRAY_BUFFER: u32 = 34963;
pub(super) const TRIANGLE_STRIP: u32 = 5;

/// Parts of the document written so far.
#[derive(Default)]
pub(super) struct Builder {
    pub(super) binary: Vec<u8>,
    pub(super) views: Vec<Value>,
    pub(super) accessors: Vec<Value>,
}

impl Builder {
    /// Adds bytes as a buffer view, aligned to 4, and returns its index.
    pub(super) fn push_view(&mut self, bytes: &[u8], target: Option<u32>, stride: Option<usize>) -> usize {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let mut view = json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len() });
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        if let Some(stride) = stride {
            view["byteStride"] = json!(stride);
        }
        self.binary.extend_from_slice(bytes);
        self.views.push(view);
        self.views.len() - 1
    }

    /// Adds an accessor and returns its index.
    pub(super) fn push_accessor(&mut self, accessor: Value) -> usize {
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// Adds vertex data as a view of its own.
    pub(super) fn push_vertex_data(&mut self, bytes: &[u8], stride: usize) -> usize {
        self.push_view(bytes, Some(ARRAY_BUFFER), Some(stride))
    }
}
