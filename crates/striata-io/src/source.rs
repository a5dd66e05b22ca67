//! Where bytes come from.

use std::path::Path;

/// Where bytes come from: for messages, for the extension, and for files in the same folder.
#[derive(Clone, Copy, Debug, Default)]
pub struct Source<'a> {
    /// The file's name, as messages shall show it; its extension decides where the content does not.
    pub name: &'a str,
    /// The folder that relative references (buffers, images) start from; none are followed without it.
    pub folder: Option<&'a Path>,
    /// Lets references leave `folder` (`../textures/wood.png`); off by default, since a file from a
    /// stranger could pull in any file of the machine.
    pub outside_allowed: bool,
}

impl<'a> Source<'a> {
    /// A source by name alone.
    pub fn new(name: &'a str) -> Self {
        Self { name, ..Self::default() }
    }

    /// Sets the folder of files that the source refers to.
    #[must_use]
    pub fn with_folder(self, folder: &'a Path) -> Self {
        Self { folder: Some(folder), ..self }
    }
}
