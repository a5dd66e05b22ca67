//! What a build reads.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use striata_io::pieces::{FractalTerrain, PieceOptions, PieceSource, Tiles, open_all, open_pieces};

use super::BuildError;

/// What a build reads. It is stored in the plan, so every task opens it again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BuildInput {
    /// Files of one mesh: meshes in any supported format, or rasters of one terrain.
    Files(Vec<PathBuf>),
    /// A generated terrain with this many samples per side, for tests and benchmarks.
    Terrain(u32),
    /// Copies of one file side by side, for benchmarks.
    Tiles {
        /// Number of copies.
        count: u32,
        /// The file.
        path: PathBuf,
    },
}

impl BuildInput {
    /// Opens the input.
    ///
    /// # Errors
    /// [`BuildError::Read`] with the file, the place and the reason.
    pub fn open(&self, options: &PieceOptions) -> Result<Box<dyn PieceSource>, BuildError> {
        Ok(match self {
            Self::Files(paths) if paths.len() == 1 => open_pieces(&paths[0], options)?,
            Self::Files(paths) => open_all(paths, options)?,
            Self::Terrain(side) => Box::new(FractalTerrain::new(*side, 1)),
            Self::Tiles { count, path } => {
                let columns = count.isqrt().max(1);
                Box::new(Tiles::new(open_pieces(path, options)?, columns, count.div_ceil(columns))?)
            }
        })
    }
}
