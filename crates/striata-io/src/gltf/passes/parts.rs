//! A glTF document that passes change, and its arrays.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use crate::error::Refusal;
use crate::gltf::document::GltfDocument;

/// glTF document before it is embedded into a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct GltfParts {
    /// The JSON; its `buffers[0]`, if there is one, describes `binary` and has no URI.
    pub root: Value,
    /// Contents of the first buffer.
    pub binary: Vec<u8>,
    /// Arrays of the root that are written already, by their names.
    pub written: Vec<(&'static str, WrittenArray)>,
}

/// JSON array as text. A million entries take a tenth of the memory that they take as values.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct WrittenArray {
    text: String,
    pub len: usize,
}

impl WrittenArray {
    pub(in crate::gltf) fn push(&mut self, entry: &Value) {
        // Writing to a string cannot fail.
        let _ = write!(self.text, "{}{entry}", if self.len == 0 { "" } else { "," });
        self.len += 1;
    }
}

impl GltfParts {
    /// Parses the arrays that are written already, so that passes can change them.
    ///
    /// # Errors
    /// If the parser does not accept them, such as because they are nested too deeply.
    pub(in crate::gltf) fn parse_written(&mut self) -> Result<(), Refusal> {
        for (key, array) in std::mem::take(&mut self.written) {
            let entries = serde_json::from_str(&format!("[{}]", array.text))
                .map_err(|error| Refusal::Unsupported(format!("its array of {key}: {error}")))?;
            push_entries(&mut self.root, key, entries);
        }
        Ok(())
    }

    /// Returns the JSON of the document on one line.
    pub(in crate::gltf) fn to_json(&self) -> String {
        let none = Map::new();
        let root = self.root.as_object().unwrap_or(&none);
        let arrays: Vec<_> = self.written.iter().filter(|(_, array)| array.len > 0).collect();
        let mut keys: Vec<&str> =
            root.keys().map(String::as_str).chain(arrays.iter().map(|(key, _)| *key)).collect();
        keys.sort_unstable();
        let mut text = String::from("{");
        for key in keys {
            let separator = if text.len() == 1 { "" } else { "," };
            // Writing to a string cannot fail.
            let _ = match (root.get(key), arrays.iter().find(|(name, _)| *name == key)) {
                (Some(value), _) => write!(text, "{separator}{}:{value}", json!(key)),
                (None, Some((_, array))) => write!(text, "{separator}\"{key}\":[{}]", array.text),
                (None, None) => Ok(()),
            };
        }
        text + "}"
    }

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
