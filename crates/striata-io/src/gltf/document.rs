//! Document with its buffers loaded, and bounds-checked access to them.

use std::ops::Deref;

use serde_json::Value;

use super::buffers::Buffers;
use super::compression::{self, GeometryCompression};
use super::extensions;
use super::json::JsonNode;
use super::meshopt;
use super::unpacked::Unpacked;
use super::uri;
use crate::Source;
use crate::error::{Fault, Place};

/// Size that a document may have whose text is not at hand, bytes.
const JSON_BYTES: u64 = 1 << 20;

/// Largest number of elements of an accessor that is read as a whole.
const MAX_ELEMENTS: u64 = u32::MAX as u64 / 4;

/// Parsed document with its buffers.
pub(crate) struct GltfDocument<'a> {
    pub root: JsonNode<'a>,
    /// Bytes of each buffer; empty for placeholders.
    buffers: Vec<&'a [u8]>,
    /// Size of the document and its buffers in bytes; limits the size of the mesh.
    pub input_bytes: u64,
    pub(super) source: Source<'a>,
    pub unpacked: Unpacked<'a>,
    /// Largest number of elements that an accessor may have.
    pub max_elements: u64,
}

/// Checks the version of a document and the extensions that it requires.
pub(crate) fn check_requirements(root: &JsonNode<'_>) -> Result<(), Fault> {
    let version = root.get("asset").map_or("", |asset| asset.text("version"));
    if !version.starts_with("2.") {
        let place = Place::Json("asset.version".to_owned());
        return Err(match version {
            "" => Fault::Malformed(place, "`asset.version` is missing: this is not a glTF file".to_owned()),
            _ => Fault::Unsupported(place, format!("glTF version `{}`", uri::shortened(version))),
        });
    }
    for extension in root.entries("extensionsRequired")? {
        let name = extension.value.as_str().unwrap_or("");
        match GeometryCompression::of_extension(name) {
            Some(compression) if compression.is_on() => {}
            Some(compression) => return Err(compression.feature_off()),
            None if extensions::is_known(name) => {}
            None => return Err(Fault::Extension(name.to_owned())),
        }
    }
    Ok(())
}

impl<'a> GltfDocument<'a> {
    /// Joins a document, which takes `json_bytes` as text, with its buffers; `chunk` is the binary chunk of a
    /// GLB.
    pub(crate) fn new<B: Deref<Target = [u8]> + From<Vec<u8>>>(
        root: &'a Value,
        json_bytes: usize,
        buffers: &'a Buffers<B>,
        chunk: Option<&'a [u8]>,
        source: Source<'a>,
    ) -> Result<Self, Fault> {
        let root = JsonNode { value: root, path: String::new() };
        let unpacked = Unpacked::new(root.values("bufferViews")?.len());
        let input_bytes =
            json_bytes as u64 + buffers.loaded_bytes() + chunk.map_or(0, |chunk| chunk.len() as u64);
        let buffers = buffers.slices(chunk);
        Ok(Self { root, buffers, input_bytes, source, unpacked, max_elements: MAX_ELEMENTS })
    }

    /// Opens a document without buffers of its own: all its buffer views lie in `buffer`.
    pub(super) fn over(root: &'a Value, buffer: &'a [u8]) -> Result<Self, Fault> {
        let root = JsonNode { value: root, path: String::new() };
        let unpacked = Unpacked::new(root.values("bufferViews")?.len());
        let (input_bytes, source) = (JSON_BYTES + buffer.len() as u64, Source::default());
        let (buffers, max_elements) = (vec![buffer], MAX_ELEMENTS);
        Ok(Self { root, buffers, input_bytes, source, unpacked, max_elements })
    }

    /// Opens a document whose first buffer is at hand, whatever it requires. Other buffers are not loaded,
    /// so what refers to them cannot be read.
    pub(super) fn of_parts(root: &'a Value, binary: &'a [u8]) -> Self {
        let root = JsonNode { value: root, path: String::new() };
        let count = |key: &str| root.value.get(key).and_then(Value::as_array).map_or(0, Vec::len);
        let bytes_of = |index: usize| if index == 0 { binary } else { &[][..] };
        let buffers = (0..count("buffers")).map(bytes_of).collect();
        let unpacked = Unpacked::new(count("bufferViews"));
        let (input_bytes, source) = (JSON_BYTES + binary.len() as u64, Source::default());
        Self { root, buffers, input_bytes, source, unpacked, max_elements: MAX_ELEMENTS }
    }

    /// Returns entry `index` of an array at the document's root; `from` is the value that refers to it.
    pub(crate) fn item(&self, array: &str, index: u64, from: &JsonNode<'_>) -> Result<JsonNode<'a>, Fault> {
        self.root.item(array, index, from)
    }

    /// Returns the bytes of a buffer view, and its stride if it has one.
    pub(super) fn view(&self, index: u64, from: &JsonNode<'_>) -> Result<(&[u8], Option<usize>), Fault> {
        let at = self.item("bufferViews", index, from)?;
        let stride = stride(&at)?;
        let bytes = match self.packed(&at) {
            Some(packed) => {
                let source = |bytes| {
                    let range = self.range(&packed)?;
                    self.unpacked.claim(bytes, self.input_bytes, &packed).map(|()| range)
                };
                self.unpacked.view(index, || meshopt::decompressed(&at, &packed, source))?
            }
            None => self.range(&at)?,
        };
        Ok((bytes, stride))
    }

    /// Returns the extension object of a view that must be decompressed.
    pub(super) fn packed(&self, at: &JsonNode<'a>) -> Option<JsonNode<'a>> {
        compression::meshopt(at).filter(|_| GeometryCompression::Meshopt.is_on() || self.lacks_bytes(at))
    }

    /// Whether the buffer of a view is only a placeholder.
    fn lacks_bytes(&self, at: &JsonNode<'_>) -> bool {
        let index = at.unsigned("buffer").ok().flatten().and_then(|index| usize::try_from(index).ok());
        index.and_then(|index| self.buffers.get(index)).is_some_and(|buffer| buffer.is_empty())
    }

    /// Returns the bytes that an object describes by `buffer`, `byteOffset` and `byteLength`.
    pub(super) fn range(&self, at: &JsonNode<'_>) -> Result<&[u8], Fault> {
        let buffer_index = at.required_unsigned("buffer")?;
        let buffer = usize::try_from(buffer_index).ok().and_then(|i| self.buffers.get(i));
        let Some(buffer) = buffer else {
            let count = self.buffers.len();
            return Err(at.fault(format!("buffers[{buffer_index}] does not exist: there are {count}")));
        };
        let offset = at.unsigned("byteOffset")?.unwrap_or(0);
        let length = at.required_unsigned("byteLength")?;
        let end = offset.checked_add(length).filter(|&end| end <= buffer.len() as u64);
        let Some(end) = end else {
            let reason = format!("bytes {offset} + {length} of a buffer of {} bytes", buffer.len());
            return Err(at.fault(reason));
        };
        Ok(&buffer[offset as usize..end as usize])
    }
}

/// Returns the stride of a buffer view, if it has one.
pub(super) fn stride(view: &JsonNode<'_>) -> Result<Option<usize>, Fault> {
    let stride = view.unsigned("byteStride")?;
    match stride.filter(|s| !(1..=252).contains(s)) {
        Some(stride) => Err(view.fault(format!("byteStride is {stride}, but may be 4 to 252"))),
        None => Ok(stride.map(|s| s as usize)),
    }
}
