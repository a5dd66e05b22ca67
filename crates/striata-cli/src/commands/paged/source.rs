//! Paged files as inputs of verbs that need a mesh in memory.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use striata::file::{WriteOptions, write_striata};
use striata_command::failure::Failure;
use striata_command::input::Input;
use striata_paged::{HEAD_NAME, PAGED_MAGIC, PagedFile};

use super::failure_of;

/// Whether a path or an address is a paged file or a folder of pages.
pub(crate) fn is_paged_file(path: &Path) -> bool {
    if path.to_string_lossy().contains("://") || path.join(HEAD_NAME).is_file() {
        return true;
    }
    let mut magic = [0; PAGED_MAGIC.len()];
    File::open(path).is_ok_and(|mut file| file.read_exact(&mut magic).is_ok()) && &magic == PAGED_MAGIC
}

/// Opens an input. Of a paged file, reads all levels with up to `triangle_count` triangles; the result is the same as a
/// .striata file without models.
///
/// # Errors
/// If the input cannot be read.
pub(crate) fn open_input(path: &Path, triangle_count: usize) -> Result<Input, Failure> {
    if !is_paged_file(path) {
        return Input::open(path);
    }
    let name = path.to_string_lossy();
    let mut file = PagedFile::open(&name).map_err(failure_of)?;
    file.load_images().map_err(failure_of)?;
    let assembled = file.level_for_triangles(triangle_count).map_err(failure_of)?;
    let known = assembled.refinable;
    let mut bytes = Vec::new();
    let options = WriteOptions::default().with_metadata("source", file.metadata().source.clone());
    write_striata(&known, &[], &options, &mut bytes).map_err(|error| Failure::internal(error.to_string()))?;
    Input::of_bytes(&name, bytes)
}
