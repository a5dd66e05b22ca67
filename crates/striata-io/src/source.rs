//! Origin of the bytes that are read.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// Origin of bytes: used for messages, for the extension, and for files in the same folder.
#[derive(Clone, Copy, Debug, Default)]
pub struct Source<'a> {
    /// Name of the file, as shown in messages; its extension decides the format if the content does not.
    pub name: &'a str,
    /// Folder to which references (buffers, images) are relative; without it, none are followed.
    pub folder: Option<&'a Path>,
    /// Whether references may lead to folders above `folder` (`../textures/wood.png`). Off by default, because
    /// an untrusted file could otherwise include any file of the machine; readers that get a path set it.
    pub outside_allowed: bool,
    /// Collects the paths of the files that references lead to, once they are opened.
    pub followed: Option<&'a Mutex<BTreeSet<PathBuf>>>,
}

impl<'a> Source<'a> {
    /// Creates a source that only has a name.
    pub fn new(name: &'a str) -> Self {
        Self { name, ..Self::default() }
    }

    /// Creates the source of a file at a path: references start at its folder and may lead to others.
    pub fn of_path(name: &'a str, path: &'a Path) -> Self {
        let folder = path.parent().map(|p| if p.as_os_str().is_empty() { Path::new(".") } else { p });
        Self { name, folder, outside_allowed: true, ..Self::default() }
    }

    /// Sets the folder of the files that the source refers to.
    #[must_use]
    pub fn with_folder(self, folder: &'a Path) -> Self {
        Self { folder: Some(folder), ..self }
    }

    /// Sets [`outside_allowed`](Self::outside_allowed).
    #[must_use]
    pub fn with_outside_allowed(self, outside_allowed: bool) -> Self {
        Self { outside_allowed, ..self }
    }
}
