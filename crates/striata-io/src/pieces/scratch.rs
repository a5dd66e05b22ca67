//! Temporary files, and files as bytes.

use std::fs::File;
use std::io::{self, Read as _};
use std::ops::Deref;

use memmap2::Mmap;

use super::PieceOptions;
use crate::ReadError;

/// Bytes of a file.
#[derive(Debug)]
pub(crate) enum Mapped {
    File(Mmap),
    Owned(Vec<u8>),
}

impl Mapped {
    /// Maps a whole file; what is no regular file is read instead.
    pub(crate) fn new(mut file: File) -> io::Result<Self> {
        let metadata = file.metadata()?;
        if !metadata.is_file() || metadata.len() == 0 {
            let mut bytes = Vec::new();
            file.read_to_end(&mut bytes)?;
            return Ok(Self::Owned(bytes));
        }
        #[expect(unsafe_code, reason = "mapping a file is unsafe by nature; there is no safe way to do it")]
        // SAFETY: the map is only ever read as bytes, and every reader accepts arbitrary bytes. If another
        // process changes the file meanwhile, we may read old or new bytes, and if it truncates the file, a
        // signal may end this process.
        unsafe {
            Mmap::map(&file).map(Self::File)
        }
    }
}

impl From<Vec<u8>> for Mapped {
    fn from(bytes: Vec<u8>) -> Self {
        Self::Owned(bytes)
    }
}

impl Deref for Mapped {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        match self {
            Self::File(map) => map,
            Self::Owned(bytes) => bytes,
        }
    }
}

/// Creates a temporary file without a name: it disappears when it is closed, however the process ends.
pub(crate) fn scratch_file(options: &PieceOptions) -> Result<File, ReadError> {
    let made = match &options.scratch {
        Some(folder) => tempfile::tempfile_in(folder),
        None => tempfile::tempfile(),
    };
    made.map_err(|source| scratch_error(options, source))
}

/// Wraps a system error with a description of the temporary file.
pub(crate) fn scratch_error(options: &PieceOptions, source: io::Error) -> ReadError {
    let folder = options.scratch.clone().unwrap_or_else(std::env::temp_dir);
    ReadError::Io { file: format!("temporary file in {}", folder.display()), source }
}
