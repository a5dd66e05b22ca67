//! Document whose buffers are mapped into memory.

use std::ops::Range;
use std::path::PathBuf;

use serde_json::Value;

use crate::error::Fault;
use crate::gltf::parts::{
    Buffers, GltfDocument, JsonNode, UnpackedCache, check_requirements, chunk_ranges, parse,
};
use crate::pieces::input::PieceInput;
use crate::pieces::scratch::Mapped;
use crate::report::Warnings;
use crate::{Format, ReadError};

/// Largest number of elements of an accessor; what they take is compared with the buffers anyway.
const MAX_ELEMENTS: u64 = 1 << 40;

/// Parsed document with its buffers, none of which is copied.
pub(super) struct OpenedDocument {
    root: Value,
    json_bytes: usize,
    input: PieceInput,
    /// Range of the binary chunk in the file, bytes; [`None`] if there is none.
    chunk: Option<Range<usize>>,
    buffers: Buffers<Mapped>,
    /// Decompressed views and meshes.
    cache: UnpackedCache,
}

impl OpenedDocument {
    /// Parses the document and maps its buffers.
    pub(super) fn open(
        input: PieceInput,
        format: Format,
        warnings: &mut Warnings,
    ) -> Result<Self, ReadError> {
        let in_file = |fault: Fault| fault.in_file(&input.name);
        let (json, chunk) = match format {
            Format::Glb => chunk_ranges(&input.bytes, warnings).map_err(in_file)?,
            _ => (0..input.bytes.len(), None),
        };
        let json_bytes = json.len();
        let root = parse(&input.bytes[json]).map_err(in_file)?;
        let at = JsonNode { value: &root, path: String::new() };
        let source = input.source();
        let buffers = check_requirements(&at).and_then(|()| Buffers::load(&at, &source, Mapped::new));
        let buffers = buffers.map_err(in_file)?;
        Ok(Self { root, json_bytes, input, chunk, buffers, cache: UnpackedCache::default() })
    }

    /// Name of the file.
    pub(super) fn name(&self) -> &str {
        &self.input.name
    }

    /// Size of the file and of the files of its buffers.
    pub(super) fn byte_count(&self) -> u64 {
        self.input.file_bytes + self.buffers.file_bytes()
    }

    /// Paths of the files that it refers to.
    pub(super) fn companions(&self) -> Vec<PathBuf> {
        self.input.companions()
    }

    /// Creates a document for one thread, which shares what it decompresses with others.
    pub(super) fn document(&self) -> Result<GltfDocument<'_>, Fault> {
        let chunk = self.chunk.clone().map(|range| &self.input.bytes[range]);
        let source = self.input.source();
        let mut document = GltfDocument::new(&self.root, self.json_bytes, &self.buffers, chunk, source)?;
        document.max_elements = MAX_ELEMENTS;
        document.unpacked.share(&self.cache);
        Ok(document)
    }

    /// Creates a document to read a piece with.
    pub(super) fn document_of_piece(&self) -> Result<GltfDocument<'_>, Fault> {
        self.cache.begin_read();
        self.document()
    }

    /// Creates a document to go on with where little of what the last one has decompressed is needed.
    pub(super) fn document_after(&self, last: &GltfDocument<'_>) -> Result<GltfDocument<'_>, Fault> {
        self.cache.expire();
        let mut document = self.document()?;
        document.unpacked.count(last.unpacked.bytes());
        Ok(document)
    }
}
