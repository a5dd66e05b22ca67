//! How inputs are opened.

use std::path::PathBuf;

/// How an input is opened.
#[derive(Clone, Debug, PartialEq)]
pub struct PieceOptions {
    /// Triangles per piece, about; default 100,000.
    pub piece_triangle_count: usize,
    /// Folder for what must be converted before it can be read in pieces; default the system's temporary folder.
    /// Its files are removed with the source.
    pub scratch: Option<PathBuf>,
    /// Heights of a terrain are multiplied by this; default 1.
    pub z_scale: f64,
}

impl Default for PieceOptions {
    fn default() -> Self {
        Self { piece_triangle_count: 100_000, scratch: None, z_scale: 1.0 }
    }
}

impl PieceOptions {
    /// Sets the folder for converted inputs.
    pub fn with_scratch(self, folder: PathBuf) -> Self {
        Self { scratch: Some(folder), ..self }
    }

    /// Sets the factor on the heights of a terrain.
    pub fn with_z_scale(self, z_scale: f64) -> Self {
        Self { z_scale, ..self }
    }

    /// Sets the number of triangles per piece.
    pub fn with_piece_triangle_count(self, piece_triangle_count: usize) -> Self {
        Self { piece_triangle_count: piece_triangle_count.max(1), ..self }
    }

    /// Creates a temporary file in the scratch folder; it has no name and disappears when it is closed.
    pub(super) fn scratch_file(&self) -> std::io::Result<std::fs::File> {
        match &self.scratch {
            Some(folder) => tempfile::tempfile_in(folder),
            None => tempfile::tempfile(),
        }
    }
}
