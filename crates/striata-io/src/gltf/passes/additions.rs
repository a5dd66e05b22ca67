//! New accessors and buffer views of a document, collected by a pass and added at its end.
//!
//! Elements of one kind are stored one after another in a single buffer view, because a view takes as much
//! JSON as a hundred elements take bytes.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::elements::Elements;
use super::parts::{GltfParts, array_length, push_entries};

pub(super) const ARRAY_BUFFER: u32 = 34962;
pub(super) const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// Properties that the elements of a buffer view have in common.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct ViewKind {
    /// Use of the elements, in words.
    pub role: String,
    /// Number of the component type.
    pub component: u32,
    /// Components of an element.
    pub width: usize,
    /// Distance of elements in bytes.
    pub stride: usize,
    /// Use of the view on a GPU; vertex data also declare their stride.
    pub target: Option<u32>,
}

impl ViewKind {
    /// Returns the kind of elements that belong to vertices.
    pub(super) fn of_vertices(role: &str, elements: &Elements) -> Self {
        Self { stride: elements.stride(), target: Some(ARRAY_BUFFER), ..Self::of_others(role, elements) }
    }

    /// Returns the kind of indices.
    pub(super) fn of_indices(role: &str, elements: &Elements) -> Self {
        Self { target: Some(ELEMENT_ARRAY_BUFFER), ..Self::of_others(role, elements) }
    }

    /// Returns the kind of elements that belong neither to vertices nor to triangles.
    pub(super) fn of_others(role: &str, elements: &Elements) -> Self {
        Self {
            role: role.to_owned(),
            component: elements.component.number(),
            width: elements.width,
            stride: elements.element_bytes(),
            target: None,
        }
    }
}

/// View that grows.
#[derive(Debug)]
pub(super) struct Shelf {
    pub kind: ViewKind,
    pub bytes: Vec<u8>,
}

/// Accessors and views to add to a document.
#[derive(Debug)]
pub(super) struct Additions {
    first_view: usize,
    first_accessor: usize,
    pub shelves: Vec<Shelf>,
    shelf_of: BTreeMap<ViewKind, usize>,
    accessors: Vec<Value>,
}

impl Additions {
    /// Starts without additions to a document.
    pub(super) fn new(root: &Value) -> Self {
        Self {
            first_view: array_length(root, "bufferViews"),
            first_accessor: array_length(root, "accessors"),
            shelves: Vec::new(),
            shelf_of: BTreeMap::new(),
            accessors: Vec::new(),
        }
    }

    /// Stores elements, and writes their place into an accessor.
    pub(super) fn store(&mut self, kind: ViewKind, elements: &Elements, accessor: &mut Value) {
        let next = self.shelves.len();
        let number = *self.shelf_of.entry(kind.clone()).or_insert(next);
        if number == next {
            self.shelves.push(Shelf { kind: kind.clone(), bytes: Vec::new() });
        }
        let bytes = &mut self.shelves[number].bytes;
        // Elements of other views than those of vertices may be smaller than their alignment.
        bytes.resize(bytes.len().next_multiple_of(elements.component.bytes()), 0);
        accessor["bufferView"] = json!(self.first_view + number);
        set_offset(accessor, bytes.len());
        bytes.extend_from_slice(&elements.padded(kind.stride));
    }

    /// Adds an accessor, and returns its index.
    pub(super) fn push_accessor(&mut self, accessor: Value) -> usize {
        self.accessors.push(accessor);
        self.first_accessor + self.accessors.len() - 1
    }

    /// Adds elements with an accessor, and returns the accessor's index.
    pub(super) fn push(&mut self, kind: ViewKind, elements: &Elements, mut accessor: Value) -> usize {
        self.store(kind, elements, &mut accessor);
        self.push_accessor(accessor)
    }

    /// Adds everything to the document; `view` adds the bytes of a shelf to the binary, and returns its
    /// buffer view.
    pub(super) fn apply(self, parts: &mut GltfParts, mut view: impl FnMut(&mut GltfParts, &Shelf) -> Value) {
        let views: Vec<Value> = self.shelves.iter().map(|shelf| view(parts, shelf)).collect();
        push_entries(&mut parts.root, "bufferViews", views);
        push_entries(&mut parts.root, "accessors", self.accessors);
    }
}

/// Adds the bytes of a shelf as they are.
pub(super) fn plain_view(parts: &mut GltfParts, shelf: &Shelf) -> Value {
    let mut view = parts.push_bytes(&shelf.bytes);
    describe(&mut view, &shelf.kind);
    view
}

/// Declares the target of a view, and the stride of vertex data.
pub(super) fn describe(view: &mut Value, kind: &ViewKind) {
    if let Some(target) = kind.target {
        view["target"] = json!(target);
    }
    if kind.target == Some(ARRAY_BUFFER) {
        view["byteStride"] = json!(kind.stride);
    }
}

/// Sets the offset of an accessor in its view.
pub(super) fn set_offset(accessor: &mut Value, offset: usize) {
    match offset {
        0 => remove(accessor, "byteOffset"),
        offset => accessor["byteOffset"] = json!(offset),
    }
}

/// Removes a member of an object.
pub(super) fn remove(value: &mut Value, key: &str) {
    if let Some(object) = value.as_object_mut() {
        object.remove(key);
    }
}
