//! The output folder of the demo.

use std::fs;
use std::path::Path;

use striata_io::write_atomically;

use striata_command::failure::Failure;
use striata_command::output::format_bytes;

/// The output folder, with the names and descriptions of the files written so far.
pub(super) struct DemoFolder<'a> {
    path: &'a Path,
    pub files: Vec<(String, String)>,
}

impl<'a> DemoFolder<'a> {
    pub(super) fn create(path: &'a Path) -> Result<Self, Failure> {
        fs::create_dir_all(path).map_err(|error| {
            Failure::user(format!("{}: {error}", path.display()))
                .with_hint("name a folder that you can write to")
        })?;
        Ok(Self { path, files: Vec::new() })
    }

    pub(super) fn write(&mut self, name: &str, what: &str, bytes: &[u8]) -> Result<(), Failure> {
        write_atomically(&self.path.join(name), |out| out.write_all(bytes))?;
        self.files.push((name.to_owned(), format!("{what}, {}", format_bytes(bytes.len()))));
        Ok(())
    }
}
