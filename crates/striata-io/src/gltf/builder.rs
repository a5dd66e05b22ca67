//! Parts of a document that grow while it is written: bytes, buffer views and accessors.

use std::collections::HashMap;
use std::hash::{BuildHasher as _, BuildHasherDefault, DefaultHasher};

use serde_json::{Value, json};

const ARRAY_BUFFER: u32 = 34962;
pub(super) const ELEMENT_ARRAY_BUFFER: u32 = 34963;
pub(super) const TRIANGLE_STRIP: u32 = 5;

/// Parts of the document written so far.
#[derive(Default)]
pub(super) struct GltfBuilder {
    pub binary: Vec<u8>,
    pub views: Vec<Value>,
    pub accessors: Vec<Value>,
    /// Entries of `views` that are still `null`, last first.
    free_views: Vec<usize>,
    /// Entries of `accessors` that are still `null`, last first.
    free_accessors: Vec<usize>,
    /// URIs of the images that are files of their own.
    pub image_uris: Vec<Option<String>>,
    /// Views of vertices and indices by their use and a hash of their bytes.
    shared_views: HashMap<(String, u64), usize>,
    /// Accessors of vertices and indices by their use and their JSON.
    shared_accessors: HashMap<(String, String), usize>,
}

/// Returns the indices of all entries that are `null`, last first.
fn free_slots(entries: &[Value]) -> Vec<usize> {
    (0..entries.len()).rev().filter(|&index| entries[index].is_null()).collect()
}

/// Sets a free entry, or appends one, and returns its index.
fn put(entries: &mut Vec<Value>, free: &mut Vec<usize>, entry: Value) -> usize {
    match free.pop() {
        Some(index) => {
            entries[index] = entry;
            index
        }
        None => {
            entries.push(entry);
            entries.len() - 1
        }
    }
}

impl GltfBuilder {
    /// Continues a document, whose entries that are `null` are used first.
    pub(super) fn continuing(binary: Vec<u8>, views: Vec<Value>, accessors: Vec<Value>) -> Self {
        let (free_views, free_accessors) = (free_slots(&views), free_slots(&accessors));
        Self { binary, views, accessors, free_views, free_accessors, ..Self::default() }
    }

    pub(super) fn with_image_uris(self, image_uris: Vec<Option<String>>) -> Self {
        Self { image_uris, ..self }
    }

    /// Fills entries that are still `null` with harmless ones, because others keep their indices.
    pub(super) fn fill_free_slots(&mut self) {
        while self.views.last().is_some_and(Value::is_null) {
            self.views.pop();
        }
        while self.accessors.last().is_some_and(Value::is_null) {
            self.accessors.pop();
        }
        let has_free_view = self.views.iter().any(Value::is_null);
        if has_free_view && self.binary.is_empty() {
            self.binary.push(0);
        }
        for view in self.views.iter_mut().filter(|view| view.is_null()) {
            *view = json!({ "buffer": 0, "byteLength": 1 });
        }
        for accessor in self.accessors.iter_mut().filter(|accessor| accessor.is_null()) {
            *accessor = json!({ "componentType": 5126, "count": 1, "type": "SCALAR" });
        }
        (self.free_views, self.free_accessors) = (Vec::new(), Vec::new());
    }

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
        put(&mut self.views, &mut self.free_views, view)
    }

    /// Adds an accessor and returns its index.
    pub(super) fn push_accessor(&mut self, accessor: Value) -> usize {
        put(&mut self.accessors, &mut self.free_accessors, accessor)
    }

    /// Adds vertex data as a view; `role` is the use of the data. Equal data with the same use have the same view.
    pub(super) fn push_vertex_data(&mut self, role: &str, bytes: &[u8], stride: usize) -> usize {
        self.push_shared_view(format!("{role} {stride}"), bytes, ARRAY_BUFFER, Some(stride))
    }

    /// Adds indices as a view; equal ones have the same view.
    pub(super) fn push_index_data(&mut self, bytes: &[u8]) -> usize {
        self.push_shared_view("indices".to_owned(), bytes, ELEMENT_ARRAY_BUFFER, None)
    }

    fn push_shared_view(&mut self, role: String, bytes: &[u8], target: u32, stride: Option<usize>) -> usize {
        let hash = BuildHasherDefault::<DefaultHasher>::default().hash_one(bytes);
        let key = (role, hash);
        if let Some(&view) = self.shared_views.get(&key)
            && self.bytes_of(view) == Some(bytes)
        {
            return view;
        }
        let view = self.push_view(bytes, Some(target), stride);
        self.shared_views.insert(key, view);
        view
    }

    fn bytes_of(&self, view: usize) -> Option<&[u8]> {
        let number = |key: &str| usize::try_from(self.views[view].get(key)?.as_u64()?).ok();
        self.binary.get(number("byteOffset")?..)?.get(..number("byteLength")?)
    }

    /// Adds an accessor of vertices or indices; equal ones with the same use are one.
    pub(super) fn push_shared_accessor(&mut self, role: &str, accessor: Value) -> usize {
        let key = (role.to_owned(), accessor.to_string());
        if let Some(&known) = self.shared_accessors.get(&key) {
            return known;
        }
        let index = self.push_accessor(accessor);
        self.shared_accessors.insert(key, index);
        index
    }
}
