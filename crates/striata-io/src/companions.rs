//! Files next to the one that is read, found by the names that OBJ, MTL and PLY files give them.
//!
//! Such names come from other machines. Backslashes are separators, and upper and lower case are the same if
//! no file has exactly the given name. A name may lead to another folder, but not out of the folder of the
//! file that is read, unless [`Source::outside_allowed`] is set. Absolute names (`C:\art\wood.png`) are
//! replaced by the file name alone, because textures usually travel with the model.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};

use crate::Source;

/// Finds companions of one file. Listings of folders are kept, so that many missing names are no slower than
/// a few.
pub(crate) struct Companions<'a> {
    source: Source<'a>,
    /// Names in each folder, by their lower-case form.
    listings: BTreeMap<PathBuf, BTreeMap<String, OsString>>,
}

/// A companion by its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Companion {
    /// Path relative to the folder of the source, with `/` as separator; the file may not exist.
    pub relative: String,
    /// Path of the file, or the reason why the name is not followed.
    pub path: Result<PathBuf, String>,
}

impl Companion {
    /// Returns the folder part of the relative path; empty for the folder of the source.
    pub(crate) fn folder(&self) -> &str {
        self.relative.rsplit_once('/').map_or("", |(folder, _)| folder)
    }

    /// Returns the file name without its folder.
    pub(crate) fn file_name(&self) -> &str {
        self.relative.rsplit_once('/').map_or(&self.relative, |(_, name)| name)
    }
}

impl<'a> Companions<'a> {
    pub(crate) fn new(source: &Source<'a>) -> Self {
        Self { source: *source, listings: BTreeMap::new() }
    }

    /// Finds the file called `name` in a file that is in `folder`, which is relative to the source's folder.
    pub(crate) fn find(&mut self, folder: &str, name: &str) -> Companion {
        let (parts, leaves) = parts_of(folder, name);
        let relative = parts.join("/");
        let Some(root) = self.source.folder else {
            return Companion { relative, path: Err("the folder of the file is not known".to_owned()) };
        };
        if leaves && !self.source.outside_allowed {
            return Companion { relative, path: Err("it leaves the folder of the file".to_owned()) };
        }
        let exact = root.join(&relative);
        let path = if exact.exists() { exact } else { self.in_any_case(root, &parts).unwrap_or(exact) };
        Companion { relative, path: Ok(path) }
    }

    /// Finds a path whose parts have the given names in upper or lower case.
    fn in_any_case(&mut self, root: &Path, parts: &[&str]) -> Option<PathBuf> {
        let mut path = root.to_owned();
        for part in parts {
            let next = path.join(part);
            path = if next.exists() {
                next
            } else {
                let name = self.listing(&path).get(&part.to_lowercase())?.clone();
                path.join(name)
            };
        }
        Some(path)
    }

    fn listing(&mut self, folder: &Path) -> &BTreeMap<String, OsString> {
        self.listings.entry(folder.to_owned()).or_insert_with(|| {
            let mut names: Vec<OsString> =
                fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.file_name()).collect();
            // If several names differ only in case, the first one is found on every machine.
            names.sort_unstable_by(|a, b| b.cmp(a));
            names.into_iter().map(|name| (name.to_string_lossy().to_lowercase(), name)).collect()
        })
    }
}

/// Splits a name into the parts of a path relative to the source's folder, and returns whether the path
/// leaves that folder.
fn parts_of<'n>(folder: &'n str, name: &'n str) -> (Vec<&'n str>, bool) {
    let separators = ['/', '\\'];
    let is_drive = matches!(name.as_bytes(), [letter, b':', ..] if letter.is_ascii_alphabetic());
    let is_absolute = is_drive || name.starts_with(separators) || name.contains("://");
    let mut parts: Vec<&str> = folder.split('/').filter(|part| !part.is_empty()).collect();
    if is_absolute {
        // `C:x` has no separator, but is relative to the current folder of a drive.
        let last = name.rsplit(['/', '\\', ':']).next().unwrap_or("");
        parts.extend(Some(last).filter(|last| !matches!(*last, "" | "." | "..")));
        return (parts, false);
    }
    for part in name.split(separators) {
        match part {
            "" | "." => {}
            ".." if parts.last().is_some_and(|&last| last != "..") => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    let leaves = parts.first() == Some(&"..");
    (parts, leaves)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_relative_paths() {
        for (folder, name, expected) in [
            ("", "a b.png", "a b.png"),
            ("", r"maps\\wood\a.png", "maps/wood/a.png"),
            ("mtl", "./a.png", "mtl/a.png"),
            ("mtl/x", "../../a.png", "a.png"),
            ("mtl", "../../a.png", "../a.png"),
            ("", "../../a.png", "../../a.png"),
            ("", "a/../../b/../c", "../c"),
            ("mtl", r"C:\art\wood.png", "mtl/wood.png"),
            ("", "C:wood.png", "wood.png"),
            ("", "/etc/passwd", "passwd"),
            ("", r"\\server\share\..", ""),
            ("", "file:///a/b.png", "b.png"),
        ] {
            let (parts, leaves) = parts_of(folder, name);
            assert_eq!(parts.join("/"), expected, "{folder} {name}");
            assert_eq!(leaves, expected.starts_with(".."), "{folder} {name}");
        }
    }

    #[test]
    fn files_are_found_in_any_case_but_not_outside() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("model");
        fs::create_dir_all(inner.join("Maps")).unwrap();
        fs::write(inner.join("Maps/Wood.PNG"), "").unwrap();
        fs::write(folder.path().join("secret.png"), "").unwrap();
        let source = Source::new("x.obj").with_folder(&inner);
        let mut companions = Companions::new(&source);
        let found = companions.find("", r"maps\wood.png");
        assert_eq!(found.path.as_deref(), Ok(inner.join("Maps/Wood.PNG").as_path()));
        assert_eq!((found.folder(), found.file_name()), ("maps", "wood.png"));
        assert!(!companions.find("", "maps/lost.png").path.unwrap().exists());
        assert!(companions.find("", "../secret.png").path.unwrap_err().contains("leaves the folder"));
        let mut outside = Companions::new(&Source { outside_allowed: true, ..source });
        assert!(outside.find("", "../SECRET.png").path.unwrap().exists());
        assert!(Companions::new(&Source::new("x")).find("", "a.png").path.is_err());
    }
}
