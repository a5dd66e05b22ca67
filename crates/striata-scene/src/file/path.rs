//! Levels of scenes in files: [`save`] and [`open`].

use std::fs;
use std::path::Path;

use striata::Lod;
use striata::file::WriteOptions;
use striata_io::{Place, ReadError, WriteError, write_atomically};

use super::{SceneFile, is_scene_file};
use crate::LodScene;

/// Writes a scene with the levels of all meshes as one `.striata` file.
///
/// The file is written completely or not at all.
///
/// # Errors
/// Returns [`WriteError`] with the file and the reason.
pub fn save(path: impl AsRef<Path>, scene: &LodScene) -> Result<(), WriteError> {
    let path = path.as_ref();
    let refused = |reason: String| WriteError::BadMesh { file: path.display().to_string(), reason };
    let bytes = scene.to_striata(&WriteOptions::default()).map_err(|error| refused(error.to_string()))?;
    write_atomically(path, |out| out.write_all(&bytes))
}

/// Reads a scene from a `.striata` file. A file of a single mesh becomes a scene with one node.
///
/// # Errors
/// Returns [`ReadError`] with the file and the reason.
pub fn open(path: impl AsRef<Path>) -> Result<LodScene, ReadError> {
    let path = path.as_ref();
    let file = || path.display().to_string();
    let bytes = fs::read(path).map_err(|source| ReadError::Io { file: file(), source })?;
    opened(&bytes).map_err(|reason| ReadError::Malformed { file: file(), place: Place::File, reason })
}

fn opened(bytes: &[u8]) -> Result<LodScene, String> {
    if is_scene_file(bytes) {
        let file = SceneFile::parse(bytes).map_err(|error| error.to_string())?;
        return file.lod_scene().map_err(|error| error.to_string());
    }
    let lod = striata_stream::open(bytes).and_then(|file| Lod::from_file(&file));
    LodScene::from_lod(lod.map_err(|error| error.to_string())?).map_err(|error| error.to_string())
}
