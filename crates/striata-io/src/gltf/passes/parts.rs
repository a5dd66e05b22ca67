//! A glTF document that passes change, and its arrays.

use serde_json::{Value, json};

use crate::gltf::document::GltfDocument;

/// glTF document before it is embedded into a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct GltfParts {
    /// The JSON; its `buffers[0]`, if there is one, describes `binary` and has no URI.
    pub root: Value,
    /// Contents of the first buffer.
    pub binary: Vec<u8>,
}

impl GltfParts {
    /// Appends bytes to the binary, aligned to 4, and returns a plain buffer view of them.
    pub(super) fn push_bytes(&mut self, bytes: &[u8]) -> Value {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let view = json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len() });
        self.binary.extend_from_slice(bytes);
        self.declare_binary();
        view
    }

    /// Makes the first buffer describe the binary; adds it if there is none.
    pub(super) fn declare_binary(&mut self) {
        if array_length(&self.root, "buffers") == 0 {
            push_entries(&mut self.root, "buffers", vec![json!({})]);
        }
        if let Some(buffer) = self.root.pointer_mut("/buffers/0").filter(|buffer| buffer.is_object()) {
            buffer["byteLength"] = json!(self.binary.len());
        }
    }
}

/// Opens a snapshot of a document for reading.
pub(super) fn open<'a>(snapshot: &'a Value, binary: &'a [u8]) -> GltfDocument<'a> {
    GltfDocument::of_parts(snapshot, binary)
}

/// Returns the number of entries of an array at the root; 0 if there is none.
pub(super) fn array_length(root: &Value, key: &str) -> usize {
    root.get(key).and_then(Value::as_array).map_or(0, Vec::len)
}

/// Appends entries to an array at the root, which is added if there are any.
pub(super) fn push_entries(root: &mut Value, key: &str, entries: Vec<Value>) {
    if entries.is_empty() {
        return;
    }
    let Some(object) = root.as_object_mut() else { return };
    let array = object.entry(key).or_insert_with(|| json!([]));
    if let Some(array) = array.as_array_mut() {
        array.extend(entries);
    }
}

/// Returns the entries of an array; none if it is missing or of another type.
pub(super) fn entries<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// Returns the entries of an array; none if it is missing or of another type.
pub(super) fn entries_mut<'a>(value: &'a mut Value, key: &str) -> &'a mut [Value] {
    value.get_mut(key).and_then(Value::as_array_mut).map_or(&mut [], Vec::as_mut_slice)
}

/// Returns a reference to an entry of an array, if it is one.
pub(super) fn index(value: &Value) -> Option<u64> {
    let whole = |x: f64| (x.fract() == 0.0 && (0.0..9e15).contains(&x)).then_some(x as u64);
    value.as_u64().or_else(|| value.as_f64().and_then(whole))
}

/// Returns the index that a member of an object contains.
pub(super) fn index_at(value: &Value, key: &str) -> Option<usize> {
    usize::try_from(index(value.get(key)?)?).ok()
}
