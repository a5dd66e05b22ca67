//! Stores of the bytes of paged files: files, folders, addresses.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::{Path, PathBuf};

use crate::{HEAD_NAME, PagedError, StoredPlace, Want, image_path, page_path};

/// A source of ranges of bytes.
pub trait Store: Send + Sync {
    /// Name of the file, folder or address, for messages.
    fn name(&self) -> &str;

    /// Reads bytes; returns fewer if the object ends early.
    ///
    /// # Errors
    /// [`PagedError::Io`] if the bytes cannot be read.
    fn read(&self, place: StoredPlace, range: Range<u64>) -> Result<Vec<u8>, PagedError>;

    /// Reads several ranges, in parallel if that is faster.
    ///
    /// # Errors
    /// [`PagedError::Io`] of the first range that cannot be read.
    fn read_all(&self, wants: &[Want]) -> Result<Vec<Vec<u8>>, PagedError> {
        wants.iter().map(|want| self.read(want.place, want.range.clone())).collect()
    }
}

/// Opens a file, a folder, or an address (`https://`, `s3://`, `gs://`, `az://`).
///
/// # Errors
/// [`PagedError::FeatureOff`] if addresses are not supported by this build.
pub fn open_store(address: &str) -> Result<Box<dyn Store>, PagedError> {
    if address.contains("://") {
        #[cfg(feature = "remote")]
        return Ok(Box::new(crate::remote::RemoteStore::open(address)?));
        #[cfg(not(feature = "remote"))]
        return Err(PagedError::FeatureOff { address: address.to_owned(), feature: "remote" });
    }
    Ok(Box::new(FileStore::new(Path::new(address))))
}

/// Path of an object in a folder.
pub(crate) fn path_in(folder: &Path, place: StoredPlace) -> PathBuf {
    match place {
        StoredPlace::Head => folder.join(HEAD_NAME),
        StoredPlace::Page(id) => folder.join(page_path(id)),
        StoredPlace::Image(index) => folder.join(image_path(index)),
    }
}

/// A paged file, or a folder of pages.
#[derive(Clone, Debug)]
pub struct FileStore {
    path: PathBuf,
    name: String,
}

impl FileStore {
    /// Wraps a path.
    pub fn new(path: &Path) -> Self {
        Self { path: path.to_owned(), name: path.display().to_string() }
    }
}

impl Store for FileStore {
    fn name(&self) -> &str {
        &self.name
    }

    fn read(&self, place: StoredPlace, range: Range<u64>) -> Result<Vec<u8>, PagedError> {
        let path = match place {
            StoredPlace::Head if !self.path.is_dir() => self.path.clone(),
            place => path_in(&self.path, place),
        };
        let failed = |source| PagedError::Io { place: path.display().to_string(), source };
        let mut file = File::open(&path).map_err(failed)?;
        file.seek(SeekFrom::Start(range.start)).map_err(failed)?;
        let mut bytes = Vec::new();
        file.take(range.end.saturating_sub(range.start)).read_to_end(&mut bytes).map_err(failed)?;
        Ok(bytes)
    }
}
