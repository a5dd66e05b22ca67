//! Passes over a finished glTF document: quantization, and compression with meshoptimizer or Draco.
//!
//! A pass takes any document as JSON and binary data, whoever wrote it, and changes what it understands.
//! Data that are damaged, or that an unknown extension may refer to, stay as they are, so a pass never
//! fails. All passes read through a snapshot of the document with the accessors of the reader, collect new
//! accessors and views in `additions`, put references to them into the document, and finally let `compact`
//! drop what nothing refers to any more.
//!
//! - `quantize`: floats become small integers (`KHR_mesh_quantization`).
//! - `meshopt`: buffer views are compressed (`EXT_meshopt_compression`), after vertices and triangles have
//!   been put into a better order.
//! - `draco`: primitives are compressed (`KHR_draco_mesh_compression`).
//!
//! The `references` and `extensions` of the reader know where documents refer to accessors and buffer views,
//! and which extensions add no other places.

mod additions;
mod compact;
mod draco;
mod elements;
mod extensions;
mod meshopt;
mod primitives;
mod quantize;
#[cfg(test)]
mod tests;

use serde_json::{Value, json};

use super::document::Document;
use crate::WriteOptions;
use crate::error::Refusal;
use compact::compact;
use draco::draco;
use meshopt::meshopt;
use quantize::{Texcoords, quantize};

/// glTF document before it is embedded into a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct GltfParts {
    /// The JSON; its `buffers[0]`, if there is one, describes `binary` and has no URI.
    pub root: Value,
    /// Contents of the first buffer.
    pub binary: Vec<u8>,
}

impl GltfParts {
    /// Runs the passes that the options ask for.
    ///
    /// # Errors
    /// If the options contradict each other, or this build lacks a compression.
    pub(crate) fn apply(&mut self, options: &WriteOptions) -> Result<(), Refusal> {
        if options.draco && options.meshopt {
            let reason = "it cannot be compressed with both Draco and meshoptimizer".to_owned();
            return Err(Refusal::Unsupported(reason));
        }
        for (is_wanted, is_on, feature) in [
            (options.meshopt, cfg!(feature = "meshopt"), "meshopt"),
            (options.draco, cfg!(feature = "draco"), "draco"),
        ] {
            if is_wanted && !is_on {
                let reason = format!("this build cannot compress it: the feature `{feature}` is off");
                return Err(Refusal::Unsupported(reason));
            }
        }
        if options.draco {
            // Draco quantizes by itself.
            draco(self, options.quantize.as_ref());
            return Ok(());
        }
        if let Some(quantization) = &options.quantize {
            let texcoords = if options.meshopt { Texcoords::Floats } else { Texcoords::Integers };
            quantize(self, quantization, texcoords);
        }
        if options.meshopt {
            meshopt(self, options.quantize.as_ref());
        }
        Ok(())
    }

    /// Appends bytes to the binary, aligned to 4, and returns a plain buffer view of them.
    fn push_bytes(&mut self, bytes: &[u8]) -> Value {
        self.binary.resize(self.binary.len().next_multiple_of(4), 0);
        let view = json!({ "buffer": 0, "byteOffset": self.binary.len(), "byteLength": bytes.len() });
        self.binary.extend_from_slice(bytes);
        self.declare_binary();
        view
    }

    /// Makes the first buffer describe the binary; adds it if there is none.
    fn declare_binary(&mut self) {
        if array_length(&self.root, "buffers") == 0 {
            push_entries(&mut self.root, "buffers", vec![json!({})]);
        }
        if let Some(buffer) = self.root.pointer_mut("/buffers/0").filter(|buffer| buffer.is_object()) {
            buffer["byteLength"] = json!(self.binary.len());
        }
    }
}

/// Opens a snapshot of a document for reading.
fn open<'a>(snapshot: &'a Value, binary: &'a [u8]) -> Document<'a> {
    Document::of_parts(snapshot, binary)
}

/// Returns the number of entries of an array at the root; 0 if there is none.
fn array_length(root: &Value, key: &str) -> usize {
    root.get(key).and_then(Value::as_array).map_or(0, Vec::len)
}

/// Appends entries to an array at the root, which is added if there are any.
fn push_entries(root: &mut Value, key: &str, entries: Vec<Value>) {
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
fn entries<'a>(value: &'a Value, key: &str) -> &'a [Value] {
    value.get(key).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// Returns the entries of an array; none if it is missing or of another type.
fn entries_mut<'a>(value: &'a mut Value, key: &str) -> &'a mut [Value] {
    value.get_mut(key).and_then(Value::as_array_mut).map_or(&mut [], Vec::as_mut_slice)
}

/// Returns a reference to an entry of an array, if it is one.
fn index(value: &Value) -> Option<u64> {
    let whole = |x: f64| (x.fract() == 0.0 && (0.0..9e15).contains(&x)).then_some(x as u64);
    value.as_u64().or_else(|| value.as_f64().and_then(whole))
}

/// Returns the index that a member of an object contains.
fn index_at(value: &Value, key: &str) -> Option<usize> {
    usize::try_from(index(value.get(key)?)?).ok()
}
