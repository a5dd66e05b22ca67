//! Levels of detail in `.striata` files: [`save`] and [`open`].

use std::fs;
use std::path::Path;

use striata::Lod;
use striata::file::{StriataFile, WriteOptions};

use crate::{Place, ReadError, WriteError, write_atomically};

/// Writes a [`Lod`] as one `.striata` file, with the mesh, all levels and the data for view-dependent
/// refinement.
///
/// The file is written completely or not at all.
///
/// # Errors
/// Returns [`WriteError`] with the file and the reason.
pub fn save(path: impl AsRef<Path>, lod: &Lod) -> Result<(), WriteError> {
    let path = path.as_ref();
    let refused = |reason: String| WriteError::BadMesh { file: path.display().to_string(), reason };
    let bytes = lod.to_striata(&WriteOptions::default()).map_err(|error| refused(error.to_string()))?;
    write_atomically(path, |out| out.write_all(&bytes))
}

/// Reads a [`Lod`] from a `.striata` file, whichever models it contains.
///
/// A file whose mesh is a progressive stream is opened by the crate `striata-stream` instead.
///
/// # Errors
/// Returns [`ReadError`] with the file and the reason.
pub fn open(path: impl AsRef<Path>) -> Result<Lod, ReadError> {
    let path = path.as_ref();
    let file = || path.display().to_string();
    let bytes = fs::read(path).map_err(|source| ReadError::Io { file: file(), source })?;
    StriataFile::parse(&bytes)
        .and_then(|parsed| Lod::from_file(&parsed))
        .map_err(|error| ReadError::Malformed { file: file(), place: Place::File, reason: error.to_string() })
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;
    use striata::{LodOptions, Target};

    use super::*;

    #[test]
    fn opens_what_was_saved() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("torus.striata");
        let lod = Lod::build(&shapes::torus(24, 12, 1.0, 0.4), &LodOptions::default()).unwrap();
        save(&path, &lod).unwrap();
        let opened = open(&path).unwrap();
        let target = Target::Triangles(100);
        assert_eq!(opened.level(target).indices(), lod.level(target).indices());
    }

    #[test]
    fn other_files_are_refused_by_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("text.striata");
        fs::write(&path, "no model").unwrap();
        let error = open(&path).unwrap_err().to_string();
        assert!(error.contains("text.striata") && error.contains("not a .striata file"), "{error}");
        assert!(matches!(open(folder.path().join("none.striata")), Err(ReadError::Io { .. })));
    }
}
