//! Document with its buffers loaded, and bounds-checked access to them.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::fs;
use std::rc::Rc;

use serde_json::Value;

use super::compression::{self, Compression};
use super::json::JsonNode;
use super::meshopt;
use super::unpacked::Unpacked;
use super::uri;
use crate::Source;
use crate::error::{Fault, Place};

/// Whether a file may require an extension: it is supported, or only changes appearance, which is passed
/// through.
fn can_be_required(extension: &str) -> bool {
    const KNOWN: [&str; 12] = [
        "KHR_mesh_quantization",
        "KHR_texture_transform",
        "KHR_texture_basisu",
        "KHR_lights_punctual",
        "KHR_animation_pointer",
        "KHR_xmp_json_ld",
        "EXT_texture_webp",
        "EXT_texture_avif",
        "MSFT_texture_dds",
        "EXT_lights_image_based",
        "EXT_lights_ies",
        "KHR_texture_procedurals",
    ];
    KNOWN.contains(&extension) || extension.starts_with("KHR_materials_")
}

/// Size that a document may have whose text is not at hand, bytes.
const JSON_BYTES: u64 = 1 << 20;

/// Parsed document with its buffers.
pub(super) struct Document<'a> {
    pub root: JsonNode<'a>,
    buffers: Vec<Rc<Cow<'a, [u8]>>>,
    /// Size of the document and its buffers in bytes; limits the size of the mesh.
    pub input_bytes: u64,
    pub source: Source<'a>,
    pub unpacked: Unpacked,
}

impl<'a> Document<'a> {
    /// Checks the requirements of the document and loads its buffers.
    pub(super) fn open(
        root: &'a Value,
        blob: Option<&'a [u8]>,
        json_bytes: usize,
        source: &Source<'a>,
    ) -> Result<Self, Fault> {
        let root = JsonNode { value: root, path: String::new() };
        let version = root.get("asset").map_or("", |asset| asset.text("version"));
        if !version.starts_with("2.") {
            let place = Place::Json("asset.version".to_owned());
            return Err(match version {
                "" => {
                    Fault::Malformed(place, "`asset.version` is missing: this is not a glTF file".to_owned())
                }
                _ => Fault::Unsupported(place, format!("glTF version `{}`", uri::shortened(version))),
            });
        }
        for extension in root.entries("extensionsRequired")? {
            let name = extension.value.as_str().unwrap_or("");
            match Compression::of_extension(name) {
                Some(compression) if compression.is_on() => {}
                Some(compression) => return Err(compression.feature_off()),
                None if can_be_required(name) => {}
                None => return Err(Fault::Extension(name.to_owned())),
            }
        }
        let unpacked = Unpacked::new(root.values("bufferViews")?.len());
        let (buffers, input_bytes) = (Vec::new(), json_bytes as u64);
        let mut document = Self { root, buffers, input_bytes, source: *source, unpacked };
        document.load_buffers(blob)?;
        Ok(document)
    }

    /// Opens a document without buffers of its own: all its buffer views lie in `buffer`.
    pub(super) fn over(root: &'a Value, buffer: &'a [u8]) -> Result<Self, Fault> {
        let root = JsonNode { value: root, path: String::new() };
        let unpacked = Unpacked::new(root.values("bufferViews")?.len());
        let buffers = vec![Rc::new(Cow::Borrowed(buffer))];
        let (input_bytes, source) = (JSON_BYTES + buffer.len() as u64, Source::default());
        Ok(Self { root, buffers, input_bytes, source, unpacked })
    }

    /// Opens a document whose first buffer is at hand, whatever it requires. Other buffers are not loaded,
    /// so what refers to them cannot be read.
    pub(super) fn of_parts(root: &'a Value, binary: &'a [u8]) -> Self {
        let root = JsonNode { value: root, path: String::new() };
        let count = |key: &str| root.value.get(key).and_then(Value::as_array).map_or(0, Vec::len);
        let bytes_of = |index: usize| if index == 0 { binary } else { &[][..] };
        let buffers = (0..count("buffers")).map(|i| Rc::new(Cow::Borrowed(bytes_of(i)))).collect();
        let unpacked = Unpacked::new(count("bufferViews"));
        let input_bytes = JSON_BYTES + binary.len() as u64;
        Self { root, buffers, input_bytes, source: Source::default(), unpacked }
    }

    fn load_buffers(&mut self, blob: Option<&'a [u8]>) -> Result<(), Fault> {
        let mut known: BTreeMap<&str, Rc<Cow<'a, [u8]>>> = BTreeMap::new();
        for (index, at) in self.root.entries("buffers")?.iter().enumerate() {
            let length = at.required_unsigned("byteLength")?;
            // Nothing is read from buffers for readers that cannot decompress.
            let is_fallback = compression::meshopt(at).is_some_and(|at| at.flag("fallback"));
            let uri = if is_fallback && Compression::Meshopt.is_on() { "" } else { at.text("uri") };
            let bytes = if let Some(bytes) = known.get(uri) {
                Rc::clone(bytes)
            } else if uri.is_empty() {
                match blob.filter(|_| index == 0) {
                    Some(blob) => Rc::new(Cow::Borrowed(blob)),
                    // A placeholder for compressed data; uncompressed views into it report an error.
                    None => Rc::new(Cow::Borrowed(&[][..])),
                }
            } else {
                let bytes = Rc::new(Cow::Owned(self.buffer_bytes(at, uri)?));
                known.insert(uri, Rc::clone(&bytes));
                self.input_bytes += bytes.len() as u64;
                bytes
            };
            if !uri.is_empty() && (bytes.len() as u64) < length {
                return Err(at.fault(format!("{length} bytes are declared, found {}", bytes.len())));
            }
            self.buffers.push(bytes);
        }
        self.input_bytes += blob.map_or(0, |b| b.len() as u64);
        Ok(())
    }

    fn buffer_bytes(&self, at: &JsonNode<'_>, uri: &str) -> Result<Vec<u8>, Fault> {
        if let Some(data) = uri::data(uri) {
            return data.map(|(bytes, _)| bytes).map_err(|reason| at.fault(reason));
        }
        let path = uri::path(uri, &self.source).map_err(|reason| at.fault(reason))?;
        if path.exists() && !path.is_file() {
            // Reading a pipe could block forever.
            return Err(at.fault(format!("`{}` is not a regular file", uri::shortened(uri))));
        }
        fs::read(&path).map_err(|error| at.fault(format!("`{}`: {error}", uri::shortened(uri))))
    }

    /// Returns entry `index` of an array at the document's root; `from` is the value that refers to it.
    pub(super) fn item(&self, array: &str, index: u64, from: &JsonNode<'_>) -> Result<JsonNode<'a>, Fault> {
        self.root.item(array, index, from)
    }

    /// Returns the bytes of a buffer view, and its stride if it has one.
    pub(super) fn view(&self, index: u64, from: &JsonNode<'_>) -> Result<(&[u8], Option<usize>), Fault> {
        let at = self.item("bufferViews", index, from)?;
        let stride = at.unsigned("byteStride")?;
        if stride.is_some_and(|s| !(1..=252).contains(&s)) {
            return Err(at.fault(format!("byteStride is {}, but may be 4 to 252", stride.unwrap_or(0))));
        }
        let bytes = match compression::meshopt(&at) {
            Some(packed) if Compression::Meshopt.is_on() || self.lacks_bytes(&at) => {
                self.unpacked.view(index, || meshopt::decompressed(self, &at, &packed))?
            }
            _ => self.range(&at)?,
        };
        Ok((bytes, stride.map(|s| s as usize)))
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
