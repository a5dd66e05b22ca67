//! Inputs of a build: files, or generated data.

use std::fs::{File, Metadata};
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

use serde::{Deserialize, Serialize};
use striata_io::pieces::{FractalTerrain, PieceOptions, PieceSource, Tiles, open_all, open_pieces};

use super::PagedBuildError;

/// Input of a build. It is stored in the plan, so every task opens it again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BuildInput {
    /// Files of one mesh: meshes in any supported format, or rasters of one terrain.
    Files(Vec<PathBuf>),
    /// A generated terrain with this many samples per side, for tests and benchmarks.
    Terrain(u32),
    /// Copies of one file next to each other, for benchmarks.
    Tiles {
        /// Number of copies.
        count: u32,
        /// The file.
        path: PathBuf,
    },
}

/// A file of the input, as it was when the plan was made.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct InputState {
    path: PathBuf,
    bytes: u64,
    /// Time of the last change, in nanoseconds since 1970; `None` if the system does not say.
    modified: Option<u64>,
    /// Time of the last change of the entry, in nanoseconds, which programs cannot set; `None` if the system has
    /// none.
    #[serde(default)]
    changed: Option<i64>,
    /// CRC-32 of the content.
    checksum: u32,
}

impl InputState {
    fn of(path: &Path) -> Result<Self, PagedBuildError> {
        let FileTimes { bytes, modified, changed } = FileTimes::of(path)?;
        Ok(Self { path: path.to_owned(), bytes, modified, changed, checksum: checksum_of(path)? })
    }

    /// Compares the file with what it was. Its contents are only read if a time differs, as those of a copy on
    /// another machine do. Copies that keep the time of their content differ in the other one.
    fn check(&self) -> Result<(), PagedBuildError> {
        let found = FileTimes::of(&self.path)?;
        let is_untouched =
            found.modified.is_some() && found.modified == self.modified && found.changed == self.changed;
        let is_same =
            found.bytes == self.bytes && (is_untouched || checksum_of(&self.path)? == self.checksum);
        if is_same { Ok(()) } else { Err(PagedBuildError::InputChanged { path: self.path.clone() }) }
    }
}

/// Size and times of a file.
struct FileTimes {
    bytes: u64,
    modified: Option<u64>,
    changed: Option<i64>,
}

impl FileTimes {
    fn of(path: &Path) -> Result<Self, PagedBuildError> {
        let metadata = std::fs::metadata(path).map_err(|source| PagedBuildError::io(path, source))?;
        let modified = metadata.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
        let modified = modified.and_then(|time| u64::try_from(time.as_nanos()).ok());
        Ok(Self { bytes: metadata.len(), modified, changed: changed(&metadata) })
    }
}

#[cfg(unix)]
fn changed(metadata: &Metadata) -> Option<i64> {
    use std::os::unix::fs::MetadataExt as _;
    metadata.ctime().checked_mul(1_000_000_000)?.checked_add(metadata.ctime_nsec())
}

#[cfg(not(unix))]
fn changed(_metadata: &Metadata) -> Option<i64> {
    None
}

fn checksum_of(path: &Path) -> Result<u32, PagedBuildError> {
    let failed = |source| PagedBuildError::io(path, source);
    let (mut file, mut hasher) = (File::open(path).map_err(failed)?, crc32fast::Hasher::new());
    let mut block = vec![0; 1 << 20];
    loop {
        match file.read(&mut block).map_err(failed)? {
            0 => return Ok(hasher.finalize()),
            count => hasher.update(&block[..count]),
        }
    }
}

/// Checks that no file has changed since the plan was made.
pub(super) fn check_inputs(states: &[InputState]) -> Result<(), PagedBuildError> {
    states.iter().try_for_each(InputState::check)
}

/// Some files as they are now.
pub(super) fn states_of(paths: &[PathBuf]) -> Result<Vec<InputState>, PagedBuildError> {
    paths.iter().map(|path| InputState::of(path)).collect()
}

impl BuildInput {
    /// The files that are named, as they are now; those that they refer to are known once they are open.
    pub(super) fn states(&self) -> Result<Vec<InputState>, PagedBuildError> {
        match self {
            Self::Files(paths) => states_of(paths),
            Self::Tiles { path, .. } => Ok(vec![InputState::of(path)?]),
            Self::Terrain(_) => Ok(Vec::new()),
        }
    }

    /// Opens the input.
    ///
    /// # Errors
    /// [`PagedBuildError::Read`] with the file, the place and the reason.
    pub fn open(&self, options: &PieceOptions) -> Result<Box<dyn PieceSource>, PagedBuildError> {
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
