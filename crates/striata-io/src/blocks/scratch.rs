//! Temporary files that disappear with the process.

use std::fs::File;
use std::io;
use std::path::PathBuf;

use crate::ReadError;

/// Folder for unnamed temporary files.
#[derive(Clone, Debug)]
pub(super) struct ScratchFolder {
    pub(super) folder: PathBuf,
}

impl ScratchFolder {
    pub(super) fn file(&self) -> Result<File, ReadError> {
        tempfile::tempfile_in(&self.folder).map_err(|error| self.error(error))
    }

    pub(super) fn error(&self, source: io::Error) -> ReadError {
        ReadError::Io { file: self.name(), source }
    }

    pub(super) fn name(&self) -> String {
        format!("temporary file in {}", self.folder.display())
    }
}
