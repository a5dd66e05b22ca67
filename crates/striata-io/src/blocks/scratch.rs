//! Temporary files that disappear with the process.

use std::fs::File;
use std::io;
use std::path::PathBuf;

use crate::ReadError;

/// Folder for unnamed temporary files.
#[derive(Clone, Debug)]
pub(super) struct ScratchFolder {
    pub folder: PathBuf,
}

impl ScratchFolder {
    /// Creates an unnamed temporary file.
    pub(super) fn file(&self) -> Result<File, ReadError> {
        tempfile::tempfile_in(&self.folder).map_err(|error| self.error(error))
    }

    /// Wraps a system error with a description of the temporary file.
    pub(super) fn error(&self, source: io::Error) -> ReadError {
        ReadError::Io { file: self.name(), source }
    }

    /// Returns a description of the temporary file for messages.
    pub(super) fn name(&self) -> String {
        format!("temporary file in {}", self.folder.display())
    }
}
