//! Buffers of a document: in the binary chunk of a GLB, embedded as data URIs, or in files next to it.

use std::collections::BTreeMap;
use std::fs::File;
use std::io;
use std::ops::Deref;

use super::compression::{self, GeometryCompression};
use super::json::JsonNode;
use super::uri;
use crate::Source;
use crate::companions::{Companions, NameKind};
use crate::error::Fault;

/// Bytes of all buffers; each URI is loaded once, however many buffers name it.
pub(crate) struct Buffers<B> {
    loaded: Vec<B>,
    /// Place of the bytes of each entry of `buffers`.
    entries: Vec<BufferPlace>,
    file_bytes: u64,
}

/// Place of the bytes of a buffer.
#[derive(Clone, Copy)]
enum BufferPlace {
    /// In the binary chunk.
    Chunk,
    /// Nowhere: the buffer is a placeholder for compressed data, and plain views into it are errors.
    Nowhere,
    /// In this entry of the loaded ones.
    Loaded(usize),
}

impl<B: Deref<Target = [u8]> + From<Vec<u8>>> Buffers<B> {
    /// Loads all buffers; `read` reads the files.
    pub(crate) fn load(
        root: &JsonNode<'_>,
        source: &Source<'_>,
        read: impl Fn(File) -> io::Result<B>,
    ) -> Result<Self, Fault> {
        let mut buffers = Self { loaded: Vec::new(), entries: Vec::new(), file_bytes: 0 };
        let mut known: BTreeMap<&str, usize> = BTreeMap::new();
        let mut companions = Companions::new(source);
        for (index, at) in root.entries("buffers")?.iter().enumerate() {
            let length = at.required_unsigned("byteLength")?;
            // Nothing is read from buffers for readers that cannot decompress.
            let is_fallback = compression::meshopt(at).is_some_and(|at| at.flag("fallback"));
            let uri = if is_fallback && GeometryCompression::Meshopt.is_on() { "" } else { at.text("uri") };
            if uri.is_empty() {
                buffers.entries.push(if index == 0 { BufferPlace::Chunk } else { BufferPlace::Nowhere });
                continue;
            }
            let place = match known.get(uri) {
                Some(&place) => place,
                None => {
                    let bytes = buffers.bytes_of(at, uri, &mut companions, &read)?;
                    buffers.loaded.push(bytes);
                    known.insert(uri, buffers.loaded.len() - 1);
                    buffers.loaded.len() - 1
                }
            };
            let found = buffers.loaded[place].len();
            if (found as u64) < length {
                return Err(at.fault(format!("{length} bytes are declared, found {found}")));
            }
            buffers.entries.push(BufferPlace::Loaded(place));
        }
        Ok(buffers)
    }

    fn bytes_of(
        &mut self,
        at: &JsonNode<'_>,
        uri: &str,
        companions: &mut Companions<'_>,
        read: impl Fn(File) -> io::Result<B>,
    ) -> Result<B, Fault> {
        if let Some(data) = uri::data(uri) {
            return data.map(|(bytes, _)| bytes.into()).map_err(|reason| at.fault(reason));
        }
        let found = companions.find("", uri, NameKind::Uri).file;
        let bytes = found.and_then(|found| read(found.file).map_err(|error| error.to_string()));
        let bytes = bytes.map_err(|reason| at.fault(format!("`{}`: {reason}", uri::shortened(uri))))?;
        self.file_bytes += bytes.len() as u64;
        Ok(bytes)
    }

    /// Returns the bytes of each entry of `buffers`; `chunk` is the binary chunk of a GLB.
    pub(super) fn slices<'a>(&'a self, chunk: Option<&'a [u8]>) -> Vec<&'a [u8]> {
        let slice = |place: &BufferPlace| match *place {
            BufferPlace::Chunk => chunk.unwrap_or_default(),
            BufferPlace::Nowhere => &[],
            BufferPlace::Loaded(index) => &self.loaded[index],
        };
        self.entries.iter().map(slice).collect()
    }

    /// Returns the size of all loaded bytes.
    pub(super) fn loaded_bytes(&self) -> u64 {
        self.loaded.iter().map(|bytes| bytes.len() as u64).sum()
    }

    /// Returns the size of the files among the loaded bytes.
    #[cfg(all(feature = "pieces", not(target_family = "wasm")))]
    pub(crate) fn file_bytes(&self) -> u64 {
        self.file_bytes
    }
}
