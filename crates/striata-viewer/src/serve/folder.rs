//! The served folder: maps names to files inside it and rejects names that lead out.
//!
//! Every file is opened relative to the folder by `cap-std`, which follows symbolic links only while they
//! stay inside, at the moment of opening. Before that, names must be plain: no empty, hidden or dotted
//! parts, and nothing that any system interprets specially. Only models, and files that models refer to,
//! are accessible.

use std::path::{Path, PathBuf};
use std::time::SystemTime;

use cap_std::ambient_authority;
use cap_std::fs::{Dir, Metadata};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};

use super::kinds::{has_companions, is_companion, is_model};
use striata_command::failure::Failure;

/// Maximum depth of subfolders.
const MAX_DEPTH: usize = 8;
/// Maximum number of models listed.
const MAX_MODELS: usize = 2_000;
/// Maximum number of directory entries visited for one list.
const MAX_ENTRIES: usize = 50_000;

/// Characters that are not percent-encoded in a path segment.
const PLAIN: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'_').remove(b'.').remove(b'~');

/// A folder, or a single file in it, as clients may see it.
#[derive(Debug)]
pub(super) struct Folder {
    dir: Dir,
    path: PathBuf,
    only: Option<String>,
}

/// Identifies one state of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    /// Length in bytes.
    pub bytes: u64,
    /// Time of the last modification.
    pub modified: SystemTime,
    /// Inode number; 0 on systems without one.
    inode: u64,
}

/// A file that exists and has been opened.
#[derive(Debug)]
pub(super) struct OpenedFile {
    /// Path within the folder.
    pub name: String,
    /// Open handle.
    pub file: std::fs::File,
    /// State of the file when it was opened.
    pub stamp: Stamp,
}

/// The files of some kind found in a folder.
#[derive(Debug)]
pub(super) struct FoundFiles {
    /// Paths within the folder, sorted, with their stamps.
    pub files: Vec<(String, Stamp)>,
    /// Whether a limit was reached and files are missing.
    pub is_truncated: bool,
    entry_count: usize,
    is_wanted: fn(&str) -> bool,
}

impl Folder {
    /// Opens a folder, or a single file in its folder.
    ///
    /// # Errors
    /// If the path does not exist, or the file is not a model.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        let shown = path.display();
        let path = path.canonicalize().map_err(|error| {
            Failure::user(format!("{shown}: {error}"))
                .with_hint("pass a folder with models, or a single model")
        })?;
        let (folder, only) = if path.is_dir() { (path, None) } else { split(path)? };
        let dir = Dir::open_ambient_dir(&folder, ambient_authority());
        let dir = dir.map_err(|error| Failure::user(format!("{}: {error}", folder.display())))?;
        Ok(Self { dir, path: folder, only })
    }

    /// Path of the folder.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// The single file that is served, if not the whole folder.
    pub(super) fn only(&self) -> Option<&str> {
        self.only.as_deref()
    }

    /// Name of the folder.
    pub(super) fn name(&self) -> String {
        self.path.file_name().map_or_else(|| "/".to_owned(), |name| name.to_string_lossy().into_owned())
    }

    /// Opens the file that a percent-encoded path names, if clients may access it.
    pub(super) fn find(&self, encoded: &str) -> Option<OpenedFile> {
        let name = decoded(encoded)?;
        if !self.admits(&name) {
            return None;
        }
        // Opening a pipe would block until it has a writer.
        self.dir.metadata(&name).ok().filter(Metadata::is_file)?;
        let file = self.dir.open(&name).ok()?;
        let metadata = file.metadata().ok().filter(Metadata::is_file)?;
        Some(OpenedFile { name, file: file.into_std(), stamp: Stamp::of(&metadata) })
    }

    fn admits(&self, name: &str) -> bool {
        match &self.only {
            None => is_model(name) || is_companion(name),
            Some(only) => name == only || has_companions(only) && is_companion(name),
        }
    }

    /// Finds all models, sorted by path.
    pub(super) fn walk(&self) -> FoundFiles {
        let mut found = FoundFiles::of_kind(is_model);
        match &self.only {
            Some(name) => {
                found.files.extend(self.find(&encoded(name)).map(|found| (found.name, found.stamp)))
            }
            None => self.walk_into(&self.dir, "", 0, &mut found),
        }
        found.files.sort_by(|(a, _), (b, _)| a.cmp(b));
        found
    }

    /// Finds all files that models may refer to.
    pub(super) fn walk_companions(&self) -> FoundFiles {
        let mut found = FoundFiles::of_kind(is_companion);
        self.walk_into(&self.dir, "", 0, &mut found);
        found
    }

    fn walk_into(&self, dir: &Dir, prefix: &str, depth: usize, found: &mut FoundFiles) {
        let Ok(entries) = dir.entries() else { return };
        for entry in entries.flatten() {
            found.entry_count += 1;
            if found.entry_count > MAX_ENTRIES || found.files.len() >= MAX_MODELS {
                found.is_truncated = true;
                return;
            }
            let Ok(name) = entry.file_name().into_string() else { continue };
            let Ok(kind) = entry.file_type() else { continue };
            if !is_plain(&name) {
                continue;
            }
            if kind.is_dir() {
                // Links to folders are not followed, so that no folder is visited twice.
                if depth >= MAX_DEPTH {
                    found.is_truncated = true;
                } else if let Ok(inner) = entry.open_dir() {
                    self.walk_into(&inner, &format!("{prefix}{name}/"), depth + 1, found);
                }
            } else if (found.is_wanted)(&name) {
                let name = format!("{prefix}{name}");
                // Links are resolved from the served folder, as for requests.
                let metadata = if kind.is_symlink() { self.dir.metadata(&name) } else { entry.metadata() };
                let stamp = metadata.ok().filter(Metadata::is_file).map(|metadata| Stamp::of(&metadata));
                found.files.extend(stamp.map(|stamp| (name, stamp)));
            }
        }
    }
}

impl FoundFiles {
    fn of_kind(is_wanted: fn(&str) -> bool) -> Self {
        Self { files: Vec::new(), is_truncated: false, entry_count: 0, is_wanted }
    }
}

impl Stamp {
    fn of(metadata: &Metadata) -> Self {
        let modified = metadata.modified().map_or(SystemTime::UNIX_EPOCH, |time| time.into_std());
        #[cfg(unix)]
        let inode = cap_std::fs::MetadataExt::ino(metadata);
        #[cfg(not(unix))]
        let inode = 0;
        Self { bytes: metadata.len(), modified, inode }
    }

    /// Seconds from 1970 to the last modification.
    pub(super) fn modified_secs(&self) -> u64 {
        self.modified.duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_secs())
    }

    /// Text that differs between states of the file, for use as an entity tag.
    pub(super) fn tag(&self) -> String {
        let nanos = self.modified.duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_nanos());
        format!("{:x}-{nanos:x}-{:x}", self.bytes, self.inode)
    }
}

/// Splits a path into the folder and the file name.
fn split(path: PathBuf) -> Result<(PathBuf, Option<String>), Failure> {
    let shown = path.display().to_string();
    let name = path.file_name().and_then(|name| name.to_str()).map(str::to_owned);
    let (Some(parent), Some(name)) = (path.parent(), name) else {
        return Err(Failure::user(format!("{shown}: the file name is not valid Unicode")));
    };
    if !is_model(&name) || !path.is_file() {
        return Err(Failure::user(format!("{shown}: not a folder or a model")).with_hint(
            "supported: .striata .stri .ply .obj .stl .off .gltf .glb, optionally with .gz or .zst",
        ));
    }
    Ok((parent.to_owned(), Some(name)))
}

/// Percent-encodes a path within the folder.
pub(super) fn encoded(name: &str) -> String {
    let parts: Vec<String> =
        name.split('/').map(|part| utf8_percent_encode(part, PLAIN).to_string()).collect();
    parts.join("/")
}

/// Decodes a percent-encoded path; none if one of its parts is not plain.
fn decoded(encoded: &str) -> Option<String> {
    let name = percent_decode_str(encoded).decode_utf8().ok()?.into_owned();
    name.split('/').all(is_plain).then_some(name)
}

/// Whether every system interprets a path segment as a plain, visible file name in the same folder.
fn is_plain(part: &str) -> bool {
    let is_reserved = |letter: char| letter.is_control() || matches!(letter, '\\' | ':');
    !part.is_empty() && !part.starts_with('.') && !part.contains(is_reserved)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_plain_names_are_accepted() {
        for good in ["a.ply", "sub/a%20b.ply", "%C3%BCber.obj", "a..b.ply"] {
            assert!(decoded(good).is_some(), "{good}");
        }
        for bad in [
            "",
            "/a.ply",
            "a//b.ply",
            "a/",
            "../a.ply",
            "a/../b.ply",
            "%2e%2e/a.ply",
            "..%2fa.ply",
            "%2fetc/a.ply",
            "a%00.ply",
            "a%0a.ply",
            "..%5ca.ply",
            "c:a.ply",
            ".hidden/a.ply",
            "a/.b.ply",
            "./a.ply",
            "%ff.ply",
        ] {
            assert_eq!(decoded(bad), None, "{bad}");
        }
    }

    #[test]
    fn encoded_names_decode_to_themselves() {
        for name in ["a.ply", "sub folder/ä #?%&+.obj", "x~_-.stl"] {
            let url = encoded(name);
            assert!(url.is_ascii() && !url.contains(['#', '?', '&', ' ', '+']), "{url}");
            assert_eq!(decoded(&url).as_deref(), Some(name));
        }
    }
}
