//! The destination of tiles: a folder, or an archive of the format 3TZ.
//!
//! Both are written next to their place and renamed when they are complete.

use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Read as _, Write as _};
use std::path::{Path, PathBuf};

use md5::{Digest as _, Md5};
use serde_json::Value;
use tempfile::{NamedTempFile, TempDir};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipArchive, ZipWriter};

use crate::error::TilesError;

/// Last entry of an archive, by which readers find the others.
const INDEX: &str = "@3dtilesIndex1@";
/// Name by which outputs of this crate are known again.
pub(crate) const GENERATOR: &str = "striata";
/// Files that describe outputs, each with the JSON pointer to the name of the generator.
const DESCRIPTIONS: [(&str, &str); 3] = [
    ("tileset.json", "/asset/generator"),
    ("info", "/generator"),
    ("zarr.json", "/attributes/striata/generator"),
];
/// Largest description of a tileset that is read to learn who wrote it.
const MAX_JSON_BYTES: u64 = 64 << 20;

/// Files of a tileset while it is written.
pub(crate) enum Sink {
    Folder(FolderSink),
    Archive { file: NamedTempFile, writer: Box<ZipWriter<File>> },
}

/// Files of a folder while it is written.
#[derive(Debug)]
pub(crate) struct FolderSink {
    folder: TempDir,
    subfolders: BTreeSet<String>,
}

/// Whether a path names an archive.
fn is_archive(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("3tz"))
}

/// Checks that nothing is at the place of a tileset but one that may be replaced.
///
/// # Errors
/// [`TilesError::Place`] with the reason.
pub fn check_output(path: &Path) -> Result<(), TilesError> {
    if !is_archive(path) {
        return check_folder(path);
    }
    match fs::metadata(path) {
        Ok(there) if there.is_dir() => Err(refused(path, "it is a folder")),
        _ => Ok(()),
    }
}

/// Checks that nothing is at the place of a folder of tiles, of any kind, but one that may be replaced.
///
/// # Errors
/// [`TilesError::Place`] with the reason.
pub fn check_folder(path: &Path) -> Result<(), TilesError> {
    if is_archive(path) {
        return Err(refused(path, "only 3D Tiles can be one file"));
    }
    let Ok(there) = fs::metadata(path) else { return Ok(()) };
    if !there.is_dir() {
        return Err(refused(path, "it is a file, but tiles need a folder"));
    }
    let is_empty = fs::read_dir(path).is_ok_and(|mut files| files.next().is_none());
    match is_empty || DESCRIPTIONS.iter().any(|(name, place)| is_ours(&path.join(name), place)) {
        true => Ok(()),
        false => Err(refused(path, "it is a folder, but no tileset of striata")),
    }
}

fn refused(path: &Path, reason: &'static str) -> TilesError {
    TilesError::Place { path: path.to_owned(), reason }
}

fn is_ours(path: &Path, place: &str) -> bool {
    let Ok(file) = File::open(path) else { return false };
    let document: Result<Value, _> = serde_json::from_reader(io::BufReader::new(file.take(MAX_JSON_BYTES)));
    document.is_ok_and(|document| document.pointer(place).is_some_and(|name| name == GENERATOR))
}

impl FolderSink {
    pub(crate) fn new(path: &Path) -> Result<Self, TilesError> {
        let mut builder = temporary();
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o777));
        let folder = builder.tempdir_in(parent_of(path));
        let folder = folder.map_err(|source| TilesError::Io { path: path.to_owned(), source })?;
        Ok(Self { folder, subfolders: BTreeSet::new() })
    }

    /// Creates a file, or opens the one that has been created.
    pub(crate) fn open(&mut self, name: &str) -> io::Result<File> {
        if let Some((subfolder, _)) = name.rsplit_once('/')
            && !self.subfolders.contains(subfolder)
        {
            fs::create_dir_all(self.folder.path().join(subfolder))?;
            self.subfolders.insert(subfolder.to_owned());
        }
        let path = self.folder.path().join(name);
        OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)
    }

    /// Gives the folder its name.
    pub(crate) fn finish(self, path: &Path) -> io::Result<()> {
        replace_folder(self.folder, path)
    }
}

fn temporary() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".striata-").suffix(".part");
    builder
}

fn parent_of(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

impl Sink {
    pub(crate) fn new(path: &Path) -> Result<Self, TilesError> {
        if !is_archive(path) {
            return FolderSink::new(path).map(Self::Folder);
        }
        let made = |source| TilesError::Io { path: path.to_owned(), source };
        let mut builder = temporary();
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let file = builder.tempfile_in(parent_of(path)).map_err(made)?;
        let writer = Box::new(ZipWriter::new(file.reopen().map_err(made)?));
        Ok(Self::Archive { file, writer })
    }

    /// Adds a file.
    pub(crate) fn put(&mut self, name: &str, bytes: &[u8]) -> io::Result<()> {
        match self {
            Self::Folder(folder) => folder.open(name)?.write_all(bytes),
            Self::Archive { writer, .. } => {
                writer.start_file(name, options(CompressionMethod::Deflated))?;
                writer.write_all(bytes)
            }
        }
    }

    /// Gives the tileset its name.
    pub(crate) fn finish(self, path: &Path) -> io::Result<()> {
        match self {
            Self::Folder(folder) => folder.finish(path),
            Self::Archive { file, writer } => {
                writer.finish()?;
                let index = index_of(file.reopen()?)?;
                let mut writer = ZipWriter::new_append(file.reopen()?)?;
                writer.start_file(INDEX, options(CompressionMethod::Stored))?;
                writer.write_all(&index)?;
                writer.finish()?;
                file.persist(path).map_err(|error| error.error).map(drop)
            }
        }
    }
}

/// Without a time, so that the same tiles are the same bytes.
fn options(method: CompressionMethod) -> SimpleFileOptions {
    SimpleFileOptions::default().compression_method(method).last_modified_time(zip::DateTime::default())
}

/// Hash of the name and offset of each entry, sorted as readers search them: by the hash as two little-endian numbers.
fn index_of(file: File) -> io::Result<Vec<u8>> {
    let mut archive = ZipArchive::new(file)?;
    let mut entries = Vec::with_capacity(archive.len());
    for place in 0..archive.len() {
        let entry = archive.by_index_raw(place)?;
        let hash: [u8; 16] = Md5::digest(entry.name()?.as_bytes()).into();
        let words = hash.as_chunks::<8>().0;
        entries.push((u64::from_le_bytes(words[0]), u64::from_le_bytes(words[1]), entry.header_start()));
    }
    entries.sort_unstable();
    let numbers = entries.into_iter().flat_map(|(low, high, offset)| [low, high, offset]);
    Ok(numbers.flat_map(u64::to_le_bytes).collect())
}

/// Renames a folder; one that is there already is moved aside first, and comes back if that fails.
fn replace_folder(folder: TempDir, path: &Path) -> io::Result<()> {
    let path: PathBuf = path.components().collect();
    if !path.exists() {
        fs::rename(folder.path(), &path)?;
        let _ = folder.keep();
        return Ok(());
    }
    let aside = tempfile::Builder::new().prefix(".striata-").suffix(".old").tempdir_in(parent_of(&path))?;
    let old = aside.path().join("old");
    fs::rename(&path, &old)?;
    if let Err(error) = fs::rename(folder.path(), &path) {
        fs::rename(&old, &path)?;
        return Err(error);
    }
    let _ = folder.keep();
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_archive_ends_with_an_index_of_its_entries() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.3tz");
        let mut sink = Sink::new(&path).unwrap();
        for name in ["tileset.json", "0/0_0_0.glb", "1/0_0_0.glb"] {
            sink.put(name, name.as_bytes()).unwrap();
        }
        sink.finish(&path).unwrap();
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
        let mut archive = ZipArchive::new(File::open(&path).unwrap()).unwrap();
        let mut index = Vec::new();
        let mut last = archive.by_index(3).unwrap();
        assert_eq!(last.name().unwrap(), INDEX);
        last.read_to_end(&mut index).unwrap();
        drop(last);
        let bytes = fs::read(&path).unwrap();
        let entries: Vec<[u64; 3]> = index
            .chunks(24)
            .map(|e| [0, 8, 16].map(|i| u64::from_le_bytes(e[i..i + 8].try_into().unwrap())))
            .collect();
        assert_eq!(entries.len(), 3);
        assert!(entries.is_sorted());
        for [low, high, offset] in entries {
            let header = &bytes[offset as usize..];
            assert_eq!(&header[..4], b"PK\x03\x04");
            let length = u16::from_le_bytes([header[26], header[27]]) as usize;
            let hash: [u8; 16] = Md5::digest(&header[30..30 + length]).into();
            assert_eq!(hash, [low.to_le_bytes(), high.to_le_bytes()].concat()[..]);
        }
    }
}
