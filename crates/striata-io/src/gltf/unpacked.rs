//! Decompressed data of a document: decoded at first use, kept for later uses, limited in size.

use std::cell::{Cell, OnceCell};
use std::sync::Arc;

use super::draco_mesh::DracoMesh;
use super::json::JsonNode;
use super::shared_cache::UnpackedCache;
use crate::error::Fault;

/// Memory that decompressed data may take regardless of the file size, in bytes.
const ALWAYS_ALLOWED_BYTES: u64 = 1 << 28;

/// Additional memory allowed per byte of the file.
const BYTES_PER_INPUT_BYTE: u64 = 64;

/// Decompressed data of each buffer view.
#[derive(Default)]
pub(crate) struct Unpacked<'a> {
    views: Vec<OnceCell<Arc<Vec<u8>>>>,
    draco_meshes: Vec<OnceCell<Arc<DracoMesh>>>,
    bytes: Cell<u64>,
    /// Cache that documents over the same buffers share, if there is one.
    shared: Option<&'a UnpackedCache>,
}

impl<'a> Unpacked<'a> {
    /// Creates the empty slots of a document's buffer views.
    pub(super) fn new(view_count: usize) -> Self {
        let views = (0..view_count).map(|_| OnceCell::new()).collect();
        let draco_meshes = (0..view_count).map(|_| OnceCell::new()).collect();
        Self { views, draco_meshes, bytes: Cell::new(0), shared: None }
    }

    /// Takes data that other documents have decompressed, and gives them its own.
    #[cfg(all(feature = "pieces", not(target_family = "wasm")))]
    pub(crate) fn share(&mut self, cache: &'a UnpackedCache) {
        self.shared = Some(cache);
    }

    /// Returns the decompressed bytes of an existing view.
    pub(super) fn view(
        &self,
        index: u64,
        decode: impl FnOnce() -> Result<Vec<u8>, Fault>,
    ) -> Result<&[u8], Fault> {
        let decode = || match self.shared {
            Some(shared) => shared.views.get(index, decode, |bytes| bytes.len() as u64),
            None => decode().map(Arc::new),
        };
        filled(&self.views[index as usize], decode).map(Vec::as_slice)
    }

    /// Returns the mesh that is compressed in an existing view.
    pub(super) fn draco_mesh(
        &self,
        index: u64,
        decode: impl FnOnce() -> Result<DracoMesh, Fault>,
    ) -> Result<&DracoMesh, Fault> {
        let decode = || match self.shared {
            Some(shared) => shared.draco_meshes.get(index, decode, DracoMesh::bytes),
            None => decode().map(Arc::new),
        };
        filled(&self.draco_meshes[index as usize], decode)
    }

    /// Counts what other documents over the same buffers have decompressed against the limit of this one.
    #[cfg(all(feature = "pieces", not(target_family = "wasm")))]
    pub(crate) fn count(&mut self, bytes: u64) {
        self.bytes.set(self.bytes.get().saturating_add(bytes));
    }

    /// Returns the size of what has been decompressed for this document, in bytes.
    #[cfg(all(feature = "pieces", not(target_family = "wasm")))]
    pub(crate) fn bytes(&self) -> u64 {
        self.bytes.get()
    }

    /// Returns how many more bytes may be decompressed from a file of `input_bytes` bytes.
    pub(super) fn bytes_left(&self, input_bytes: u64) -> u64 {
        ALWAYS_ALLOWED_BYTES
            .max(input_bytes.saturating_mul(BYTES_PER_INPUT_BYTE))
            .saturating_sub(self.bytes.get())
    }

    /// Accounts for data that are about to be decompressed; fails if they are far too large for the file.
    pub(crate) fn claim(&self, bytes: u64, input_bytes: u64, at: &JsonNode<'_>) -> Result<(), Fault> {
        if bytes > self.bytes_left(input_bytes) {
            let reason = format!("the data expand to {bytes} bytes, in a file of {input_bytes} bytes");
            return Err(at.fault(reason));
        }
        self.bytes.set(self.bytes.get() + bytes);
        Ok(())
    }
}

fn filled<T>(cell: &OnceCell<Arc<T>>, decode: impl FnOnce() -> Result<Arc<T>, Fault>) -> Result<&T, Fault> {
    match cell.get() {
        Some(value) => Ok(value),
        None => {
            let value = decode()?;
            Ok(cell.get_or_init(|| value))
        }
    }
}
