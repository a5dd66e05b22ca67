//! Bytes of a file, mapped into memory, so that files may be larger than it.

use std::collections::BTreeSet;
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use super::PieceOptions;
use super::scratch::{Mapped, scratch_error, scratch_file};
use super::spool::Spool;
use crate::compressed::Compression;
use crate::text::{has_lone_returns, trimmed, with_line_feeds};
use crate::{ReadError, Source};

/// Number of bytes of a text that are copied at once.
const BYTES_AT_ONCE: usize = 1 << 20;

/// Opened file, unpacked if it was compressed.
#[derive(Debug)]
pub(crate) struct PieceInput {
    /// Name in messages.
    pub name: String,
    /// Name without the extensions of compressions, by which the format is detected.
    pub inner_name: String,
    /// Folder of files that the input refers to.
    pub(super) folder: PathBuf,
    /// The file, or the temporary file into which it was unpacked.
    pub file: File,
    /// Unpacked bytes.
    pub bytes: Mapped,
    /// Files that it refers to, as far as they have been opened.
    followed: Mutex<BTreeSet<PathBuf>>,
    /// Size of the file itself.
    pub(super) file_bytes: u64,
    /// Size of the unpacked file, before any conversion.
    pub(super) unpacked_bytes: u64,
}

impl PieceInput {
    /// Opens a file; what is compressed is unpacked into a temporary file.
    pub(crate) fn open(path: &Path, options: &PieceOptions) -> Result<Self, ReadError> {
        let name = path.display().to_string();
        let io = |source| ReadError::Io { file: name.clone(), source };
        let file = File::open(path).map_err(io)?;
        let bytes = file.try_clone().and_then(Mapped::new).map_err(io)?;
        let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let (file_bytes, folder) = (bytes.len() as u64, folder.to_owned());
        let inner_name = name.clone();
        let unpacked_bytes = file_bytes;
        let followed = Mutex::default();
        let mut input = Self { name, inner_name, folder, file, bytes, followed, file_bytes, unpacked_bytes };
        // The same number of nested compressions as for meshes in memory.
        for _ in 0..3 {
            let Some(compression) = Compression::of(&input.bytes) else { break };
            input.unpack(compression, options)?;
        }
        input.unpacked_bytes = input.bytes.len() as u64;
        if input.bytes.is_empty() {
            return Err(ReadError::Empty { file: input.name });
        }
        Ok(input)
    }

    #[cfg(feature = "compressed")]
    fn unpack(&mut self, compression: Compression, options: &PieceOptions) -> Result<(), ReadError> {
        let mut file = scratch_file(options)?;
        let mut out = io::BufWriter::new(&mut file);
        crate::compressed::unpack_into(&self.bytes, compression, &self.name, &mut out)?;
        let flushed = io::Write::flush(&mut out);
        drop(out);
        let mapped = flushed.and_then(|()| Mapped::new(file.try_clone()?));
        (self.bytes, self.file) = (mapped.map_err(|source| scratch_error(options, source))?, file);
        if Compression::from_extension(&self.inner_name).is_some()
            && let Some((stem, _)) = self.inner_name.rsplit_once('.')
        {
            self.inner_name = stem.to_owned();
        }
        Ok(())
    }

    #[cfg(not(feature = "compressed"))]
    fn unpack(&mut self, compression: Compression, _options: &PieceOptions) -> Result<(), ReadError> {
        let (file, what) = (self.name.clone(), compression.as_str());
        Err(ReadError::FeatureOff { file, what, feature: "compressed" })
    }

    /// Replaces a text whose lines end in carriage returns alone by a temporary file with line feeds.
    pub(super) fn make_plain_text(&mut self, options: &PieceOptions) -> Result<(), ReadError> {
        let text = trimmed(&self.bytes);
        if !has_lone_returns(text) {
            return Ok(());
        }
        let mut spool = Spool::new(options)?;
        let mut copy = Vec::new();
        for (number, part) in text.chunks(BYTES_AT_ONCE).enumerate() {
            copy.clear();
            copy.extend_from_slice(part);
            let next = text.get((number + 1) * BYTES_AT_ONCE);
            with_line_feeds(&mut copy, next == Some(&b'\n'));
            spool.write(&copy);
        }
        self.bytes = spool.finish(options)?;
        Ok(())
    }

    /// The input for readers of whole files.
    pub(crate) fn source(&self) -> Source<'_> {
        let source = Source::new(&self.name).with_folder(&self.folder).with_outside_allowed(true);
        Source { followed: Some(&self.followed), ..source }
    }

    /// The files that readers have followed references to: buffers, images, material libraries.
    pub(super) fn companions(&self) -> Vec<PathBuf> {
        self.followed.lock().map(|files| files.iter().cloned().collect()).unwrap_or_default()
    }
}
