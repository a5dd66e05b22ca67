//! The folder that is served: which names lead to a file in it, and that no name leads out.
//!
//! Every file is opened relative to the folder by `cap-std`, which follows symbolic links only while they stay inside, at the
//! moment of opening. Before that, names must be plain: no empty, hidden or dotted parts, none that any system reads
//! otherwise. Only models, and what models refer to, are there for the outside.

use std::path::{Path, PathBuf};
use std::time::SystemTime;

use cap_std::ambient_authority;
use cap_std::fs::{Dir, Metadata};
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};

use super::kinds::{has_companions, is_companion, is_model};
use striata_command::failure::Failure;

/// Folders within folders that are looked into.
const MAX_DEPTH: usize = 8;
/// Models that are listed.
const MAX_MODELS: usize = 2_000;
/// Entries of folders that are looked at for one list.
const MAX_ENTRIES: usize = 50_000;

/// What is kept as it is in the part of a path.
const PLAIN: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'_').remove(b'.').remove(b'~');

/// A folder, or one file of it, as the outside may see it.
#[derive(Debug)]
pub(super) struct Folder {
    dir: Dir,
    path: PathBuf,
    only: Option<String>,
}

/// What tells one state of a file from another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    /// Its length.
    pub(super) bytes: u64,
    /// When it was changed.
    pub(super) modified: SystemTime,
    /// Which file it is; 0 where the system does not tell.
    inode: u64,
}

/// A file that is there, opened.
#[derive(Debug)]
pub(super) struct Found {
    /// Its path within the folder.
    pub(super) name: String,
    /// Its bytes.
    pub(super) file: std::fs::File,
    /// Its state when it was opened.
    pub(super) stamp: Stamp,
}

/// The models of a folder.
#[derive(Debug, Default)]
pub(super) struct Walked {
    /// Paths within the folder, in order, and their states.
    pub(super) models: Vec<(String, Stamp)>,
    /// Whether there are more.
    pub(super) is_cut: bool,
    entry_count: usize,
}

impl Folder {
    /// A folder, or the folder of a file with nothing but that file.
    ///
    /// # Errors
    /// Where there is neither, or the file is no model.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        let shown = path.display();
        let path = path.canonicalize().map_err(|error| {
            Failure::user(format!("{shown}: {error}")).with_hint("name a folder with models, or one model")
        })?;
        let (folder, only) = if path.is_dir() { (path, None) } else { split(path)? };
        let dir = Dir::open_ambient_dir(&folder, ambient_authority());
        let dir = dir.map_err(|error| Failure::user(format!("{}: {error}", folder.display())))?;
        Ok(Self { dir, path: folder, only })
    }

    /// Where it lies.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// The one file that is served, where it is not the folder.
    pub(super) fn only(&self) -> Option<&str> {
        self.only.as_deref()
    }

    /// What the folder is called.
    pub(super) fn name(&self) -> String {
        self.path.file_name().map_or_else(|| "/".to_owned(), |name| name.to_string_lossy().into_owned())
    }

    /// Opens the file that a part of a URL means, if it is there for the outside.
    pub(super) fn find(&self, encoded: &str) -> Option<Found> {
        let name = decoded(encoded)?;
        if !self.admits(&name) {
            return None;
        }
        // Pipes would wait for a writer when they are opened.
        self.dir.metadata(&name).ok().filter(Metadata::is_file)?;
        let file = self.dir.open(&name).ok()?;
        let metadata = file.metadata().ok().filter(Metadata::is_file)?;
        Some(Found { name, file: file.into_std(), stamp: Stamp::of(&metadata) })
    }

    fn admits(&self, name: &str) -> bool {
        match &self.only {
            None => is_model(name) || is_companion(name),
            Some(only) => name == only || has_companions(only) && is_companion(name),
        }
    }

    /// The models that are there, by path.
    pub(super) fn walk(&self) -> Walked {
        let mut walked = Walked::default();
        match &self.only {
            Some(name) => {
                walked.models.extend(self.find(&encoded(name)).map(|found| (found.name, found.stamp)))
            }
            None => self.walk_into(&self.dir, "", 0, &mut walked),
        }
        walked.models.sort_by(|(a, _), (b, _)| a.cmp(b));
        walked
    }

    fn walk_into(&self, dir: &Dir, prefix: &str, depth: usize, walked: &mut Walked) {
        let Ok(entries) = dir.entries() else { return };
        for entry in entries.flatten() {
            walked.entry_count += 1;
            if walked.entry_count > MAX_ENTRIES || walked.models.len() >= MAX_MODELS {
                walked.is_cut = true;
                return;
            }
            let Ok(name) = entry.file_name().into_string() else { continue };
            let Ok(kind) = entry.file_type() else { continue };
            if !is_plain(&name) {
                continue;
            }
            if kind.is_dir() {
                // Links to folders are not followed, so that no folder is met twice.
                if depth >= MAX_DEPTH {
                    walked.is_cut = true;
                } else if let Ok(inner) = entry.open_dir() {
                    self.walk_into(&inner, &format!("{prefix}{name}/"), depth + 1, walked);
                }
            } else if is_model(&name) {
                let name = format!("{prefix}{name}");
                // Where a link leads is judged from the served folder on, as when the file is asked for.
                let metadata = if kind.is_symlink() { self.dir.metadata(&name) } else { entry.metadata() };
                let stamp = metadata.ok().filter(Metadata::is_file).map(|metadata| Stamp::of(&metadata));
                walked.models.extend(stamp.map(|stamp| (name, stamp)));
            }
        }
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

    /// Seconds from 1970 to the change.
    pub(super) fn modified_secs(&self) -> u64 {
        self.modified.duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_secs())
    }

    /// Letters that are others for another state.
    pub(super) fn tag(&self) -> String {
        let nanos = self.modified.duration_since(SystemTime::UNIX_EPOCH).map_or(0, |since| since.as_nanos());
        format!("{:x}-{nanos:x}-{:x}", self.bytes, self.inode)
    }
}

/// The folder of a file and the file's name.
fn split(path: PathBuf) -> Result<(PathBuf, Option<String>), Failure> {
    let shown = path.display().to_string();
    let name = path.file_name().and_then(|name| name.to_str()).map(str::to_owned);
    let (Some(parent), Some(name)) = (path.parent(), name) else {
        return Err(Failure::user(format!("{shown}: the name is no text")));
    };
    if !is_model(&name) || !path.is_file() {
        return Err(Failure::user(format!("{shown}: this is neither a folder nor a model"))
            .with_hint("models end in .striata .stri .ply .obj .stl .off .gltf .glb, and .gz or .zst"));
    }
    Ok((parent.to_owned(), Some(name)))
}

/// A path within the folder as a URL holds it.
pub(super) fn encoded(name: &str) -> String {
    let parts: Vec<String> =
        name.split('/').map(|part| utf8_percent_encode(part, PLAIN).to_string()).collect();
    parts.join("/")
}

/// The path within the folder that a part of a URL means; none where its parts are not plain.
fn decoded(encoded: &str) -> Option<String> {
    let name = percent_decode_str(encoded).decode_utf8().ok()?.into_owned();
    name.split('/').all(is_plain).then_some(name)
}

/// A name that every system takes for one of a file in this very folder, and that is not hidden.
fn is_plain(part: &str) -> bool {
    let is_reserved = |letter: char| letter.is_control() || matches!(letter, '\\' | ':');
    !part.is_empty() && !part.starts_with('.') && !part.contains(is_reserved)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_plain_names_are_looked_for() {
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
    fn names_come_back_from_urls() {
        for name in ["a.ply", "sub folder/ä #?%&+.obj", "x~_-.stl"] {
            let url = encoded(name);
            assert!(url.is_ascii() && !url.contains(['#', '?', '&', ' ', '+']), "{url}");
            assert_eq!(decoded(&url).as_deref(), Some(name));
        }
    }
}
