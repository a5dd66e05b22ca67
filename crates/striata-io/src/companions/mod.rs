//! Files that the one that is read refers to, found by the names that OBJ, MTL, PLY and glTF files give them.
//!
//! Such names come from other machines, so several readings of a name are tried (`names`), first with exactly
//! these letters, then in upper or lower case. `..` is resolved before anything is opened. A name may lead to
//! a folder above that of the source only if [`Source::outside_allowed`] is set.
//!
//! Links are followed as long as they stay in the folder of the source, or in the folder above it at which the
//! name begins, never out of it (`beneath`): an archive with a link could otherwise include any file of the
//! machine in what is made of it.

mod beneath;
mod names;

pub(crate) use names::NameKind;

use std::fs::File;
use std::path::PathBuf;

use crate::Source;
use beneath::{Folders, Missing};
use names::{Names, RelativePath};

/// Finds companions of one file. Listings of folders are kept, so that many missing names are no slower than
/// a few.
pub(crate) struct Companions<'a> {
    source: Source<'a>,
    folders: Folders,
}

/// A companion by its name.
#[derive(Debug)]
pub(crate) struct Companion {
    /// Path relative to the folder of the source, with `/` as separator; the file may not exist.
    pub relative: String,
    /// The file, or the reason why there is none.
    pub file: Result<FoundFile, String>,
}

/// A regular file that has been found and opened.
#[derive(Debug)]
pub(crate) struct FoundFile {
    pub file: File,
    /// Path at which it was found, for messages and to recognize it.
    pub path: PathBuf,
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

    /// Whether the file lies outside the folder of the source.
    pub(crate) fn is_outside(&self) -> bool {
        self.relative.starts_with("../")
    }
}

impl<'a> Companions<'a> {
    pub(crate) fn new(source: &Source<'a>) -> Self {
        Self { source: *source, folders: Folders::default() }
    }

    /// Finds and opens the file called `name` in a file that is in `folder`, which is relative to the
    /// source's folder.
    pub(crate) fn find(&mut self, folder: &str, name: &str, kind: NameKind) -> Companion {
        let names = match Names::of(folder, name, kind) {
            Ok(names) => names,
            Err(reason) => return Companion { relative: String::new(), file: Err(reason) },
        };
        let (relative, file) = match self.open_first(&names) {
            Ok((path, file)) => (path.to_string(), Ok(file)),
            Err(reason) => (names.usual.to_string(), Err(reason)),
        };
        Companion { relative, file }
    }

    /// Opens the first of several names that exists.
    fn open_first<'n>(&mut self, names: &'n Names) -> Result<(&'n RelativePath, FoundFile), String> {
        let Some(folder) = self.source.folder else {
            return Err("the folder of the file is not known".to_owned());
        };
        let mut refusal = None;
        for in_any_case in [false, true] {
            for path in &names.candidates {
                if path.ups > 0 && !self.source.outside_allowed {
                    refusal.get_or_insert("it leaves the folder of the file".to_owned());
                    continue;
                }
                match self.folders.open(folder, path, in_any_case) {
                    Ok(opened) => {
                        if let Some(mut followed) = self.source.followed.and_then(|list| list.lock().ok()) {
                            followed.insert(opened.path.clone());
                        }
                        return Ok((path, opened));
                    }
                    Err(Missing::NotFound) => {}
                    Err(Missing::Refused(reason)) => drop(refusal.get_or_insert(reason)),
                }
            }
        }
        Err(refusal.unwrap_or_else(|| names.not_found()))
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn files_are_found_in_any_case_but_not_outside() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("model");
        fs::create_dir_all(inner.join("Maps")).unwrap();
        fs::write(inner.join("Maps/Wood.PNG"), "").unwrap();
        fs::write(folder.path().join("secret.png"), "").unwrap();
        let source = Source::new("x.obj").with_folder(&inner);
        let mut companions = Companions::new(&source);
        let found = companions.find("", r"maps\wood.png", NameKind::Plain);
        assert_eq!((found.folder(), found.file_name(), found.is_outside()), ("maps", "wood.png", false));
        assert_eq!(found.file.unwrap().path, inner.join("Maps/Wood.PNG"));
        let error = |companions: &mut Companions<'_>, name: &str| {
            companions.find("", name, NameKind::Plain).file.unwrap_err()
        };
        assert_eq!(error(&mut companions, "maps/lost.png"), "not found");
        assert_eq!(error(&mut companions, "maps"), "not a regular file");
        assert_eq!(error(&mut companions, "../secret.png"), "it leaves the folder of the file");
        assert!(companions.find("", "../model/maps/wood.png", NameKind::Plain).file.is_err());
        let mut outside = Companions::new(&Source { outside_allowed: true, ..source });
        assert!(outside.find("", "../SECRET.png", NameKind::Plain).file.is_ok());
        assert!(outside.find("", "../model/maps/wood.png", NameKind::Uri).file.is_ok());
        assert!(outside.find("", "../model/maps/wood.png", NameKind::Uri).is_outside());
        let above = "../".repeat(60) + "secret.png";
        assert_eq!(error(&mut outside, &above), "not found");
        assert!(error(&mut Companions::new(&Source::new("x")), "a.png").contains("not known"));
    }

    #[test]
    fn names_are_read_as_uris_and_as_they_stand() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["100%.png", "a b.png", "grün.png", "x?v=1.png"] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        let source = Source::new("x.gltf").with_folder(folder.path());
        let mut companions = Companions::new(&source);
        for kind in [NameKind::Plain, NameKind::Uri] {
            for name in [
                "100%.png",
                "100%25.png",
                "a%20b.png",
                "a b.png?v=2",
                "gr%C3%BCn.png#top",
                "x?v=1.png",
                "./A B.PNG",
            ] {
                let found = companions.find("", name, kind);
                assert!(found.file.is_ok(), "{name}: {found:?}");
            }
        }
    }

    #[test]
    #[cfg(unix)]
    fn links_are_followed_inside_only() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("model");
        fs::create_dir_all(inner.join("maps")).unwrap();
        fs::write(inner.join("maps/wood.png"), "").unwrap();
        fs::write(folder.path().join("secret.png"), "").unwrap();
        symlink("maps/wood.png", inner.join("inside.png")).unwrap();
        symlink("../secret.png", inner.join("outside.png")).unwrap();
        symlink("/etc/passwd", inner.join("passwd.bin")).unwrap();
        symlink("..", inner.join("up")).unwrap();
        symlink("/etc", folder.path().join("etc")).unwrap();
        let source = Source { outside_allowed: true, ..Source::new("x.obj").with_folder(&inner) };
        let mut companions = Companions::new(&source);
        let mut find = |name: &str| companions.find("", name, NameKind::Uri).file;
        assert!(find("inside.png").is_ok());
        for name in ["outside.png", "passwd.bin", "up/secret.png", "../etc/passwd", "PASSWD.bin"] {
            let reason = find(name).unwrap_err();
            assert!(reason.contains("a link leads out of the folder"), "{name}: {reason}");
        }
        // The folder itself may be reached through a link.
        symlink(&inner, folder.path().join("alias")).unwrap();
        let alias = folder.path().join("alias");
        let source = Source { outside_allowed: true, ..Source::new("x.obj").with_folder(&alias) };
        let mut companions = Companions::new(&source);
        assert!(companions.find("", "maps/wood.png", NameKind::Plain).file.is_ok());
        assert!(companions.find("", "../secret.png", NameKind::Plain).file.is_ok());
    }
}
