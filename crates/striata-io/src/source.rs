//! Origin of the bytes that are read.

use std::path::Path;

/// Origin of bytes: used for messages, for the extension, and for files in the same folder.
#[derive(Clone, Copy, Debug, Default)]
pub struct Source<'a> {
    /// Name of the file, as shown in messages; its extension decides the format if the content does not.
    pub name: &'a str,
    /// Folder to which references (buffers, images) are relative; without it, none are followed.
    pub folder: Option<&'a Path>,
    /// Whether references may leave `folder` (`../textures/wood.png`). Off by default, because an untrusted
    /// file could otherwise include any file of the machine.
    pub outside_allowed: bool,
}

impl<'a> Source<'a> {
    /// Creates a source that only has a name.
    pub fn new(name: &'a str) -> Self {
        Self { name, ..Self::default() }
    }

    /// Sets the folder of the files that the source refers to.
    #[must_use]
    pub fn with_folder(self, folder: &'a Path) -> Self {
        Self { folder: Some(folder), ..self }
    }
}
