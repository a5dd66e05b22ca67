//! Part files: the output of a task for later tasks, in segments that are named by level and cell.
//!
//! A part is written under a temporary name and then renamed, so a part file is either complete or absent. A task
//! that runs twice writes the same bytes again. The table of segments is at the end.

use std::fs::File;
use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::PagedBuildError;
use super::plan::temporary_in;
use crate::PageId;

const MAGIC: &[u8; 8] = b"striapar";
/// Bytes of one entry of the table: level, cell, offset, length.
const ENTRY_BYTES: usize = 24;
/// Bytes after the table: its length, its checksum, and the magic number.
const TAIL_BYTES: usize = 16;

/// One segment of a part file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct PartSegment {
    pub id: PageId,
    pub offset: u64,
    pub byte_count: u64,
}

/// Writes a part file, which is removed unless [`Self::finish`] is called.
pub(super) struct PartWriter {
    path: PathBuf,
    file: BufWriter<tempfile::NamedTempFile>,
    segments: Vec<PartSegment>,
    offset: u64,
}

impl PartWriter {
    pub(super) fn create(path: &Path) -> Result<Self, PagedBuildError> {
        let folder = path.parent().unwrap_or(Path::new("."));
        let file = temporary_in(folder);
        let file = BufWriter::new(file.map_err(|source| PagedBuildError::io(path, source))?);
        Ok(Self { path: path.to_owned(), file, segments: Vec::new(), offset: 0 })
    }

    /// Appends a segment.
    pub(super) fn write(&mut self, id: PageId, bytes: &[u8]) -> Result<(), PagedBuildError> {
        self.segments.push(PartSegment { id, offset: self.offset, byte_count: bytes.len() as u64 });
        self.offset += bytes.len() as u64;
        self.file.write_all(bytes).map_err(|source| PagedBuildError::io(&self.path, source))
    }

    /// Writes the table and gives the file its final name.
    pub(super) fn finish(mut self) -> Result<(), PagedBuildError> {
        let mut table = Vec::with_capacity(self.segments.len() * ENTRY_BYTES + TAIL_BYTES);
        for segment in &self.segments {
            table.extend(u32::from(segment.id.level).to_le_bytes());
            table.extend(segment.id.cell.to_le_bytes());
            table.extend(segment.offset.to_le_bytes());
            table.extend(segment.byte_count.to_le_bytes());
        }
        let crc = crc32fast::hash(&table);
        table.extend((self.segments.len() as u32).to_le_bytes());
        table.extend(crc.to_le_bytes());
        table.extend(MAGIC);
        let path = self.path.clone();
        let failed = |source| PagedBuildError::io(&path, source);
        self.file.write_all(&table).map_err(failed)?;
        let file = self.file.into_inner().map_err(|error| failed(error.into_error()))?;
        file.persist(&self.path).map_err(|error| failed(error.error))?;
        Ok(())
    }
}

/// A part file that is being read.
#[derive(Debug)]
pub(super) struct PartFile {
    path: PathBuf,
    pub segments: Vec<PartSegment>,
}

impl PartFile {
    /// Reads the table.
    pub(super) fn open(path: &Path) -> Result<Self, PagedBuildError> {
        let mut file = File::open(path).map_err(|source| PagedBuildError::io(path, source))?;
        let failed = |source| PagedBuildError::io(path, source);
        let damaged = || PagedBuildError::Damaged { path: path.to_owned() };
        let total = file.metadata().map_err(failed)?.len();
        let tail_at = total.checked_sub(TAIL_BYTES as u64).ok_or_else(damaged)?;
        let mut tail = [0; TAIL_BYTES];
        file.seek(SeekFrom::Start(tail_at)).map_err(failed)?;
        file.read_exact(&mut tail).map_err(failed)?;
        let word = |at: usize| u32::from_le_bytes([tail[at], tail[at + 1], tail[at + 2], tail[at + 3]]);
        let table_bytes = u64::from(word(0)) * ENTRY_BYTES as u64;
        if &tail[8..] != MAGIC || table_bytes > tail_at {
            return Err(damaged());
        }
        let mut table = vec![0; table_bytes as usize];
        file.seek(SeekFrom::Start(tail_at - table_bytes)).map_err(failed)?;
        file.read_exact(&mut table).map_err(failed)?;
        if crc32fast::hash(&table) != word(4) {
            return Err(damaged());
        }
        let segments = table.chunks_exact(ENTRY_BYTES).map(|entry| {
            let u32_at =
                |at: usize| u32::from_le_bytes([entry[at], entry[at + 1], entry[at + 2], entry[at + 3]]);
            let u64_at = |at: usize| u64::from(u32_at(at)) | u64::from(u32_at(at + 4)) << 32;
            let id = PageId { level: u32_at(0) as u8, cell: u32_at(4) };
            PartSegment { id, offset: u64_at(8), byte_count: u64_at(16) }
        });
        let segments: Vec<PartSegment> = segments.collect();
        let end = |s: &PartSegment| s.offset.checked_add(s.byte_count);
        if segments.iter().any(|s| end(s).is_none_or(|end| end > tail_at - table_bytes)) {
            return Err(damaged());
        }
        Ok(Self { path: path.to_owned(), segments })
    }

    /// Reads one segment.
    pub(super) fn read(&self, segment: &PartSegment) -> Result<Vec<u8>, PagedBuildError> {
        let failed = |source| PagedBuildError::io(&self.path, source);
        let mut file = File::open(&self.path).map_err(failed)?;
        file.seek(SeekFrom::Start(segment.offset)).map_err(failed)?;
        let mut bytes = vec![0; segment.byte_count as usize];
        file.read_exact(&mut bytes).map_err(failed)?;
        Ok(bytes)
    }

    /// Adds the name of the file to an error.
    pub(super) fn named(&self, error: PagedBuildError) -> PagedBuildError {
        match error {
            PagedBuildError::DamagedPart => PagedBuildError::Damaged { path: self.path.clone() },
            other => other,
        }
    }
}

/// Segments of several part files, by name.
#[derive(Debug, Default)]
pub(super) struct PartIndex {
    parts: Vec<PartFile>,
    /// Name, file, and number of the segment in its file; sorted.
    entries: Vec<(PageId, u32, u32)>,
}

impl PartIndex {
    /// Reads the tables of files, in this order.
    pub(super) fn open(paths: impl Iterator<Item = PathBuf>) -> Result<Self, PagedBuildError> {
        let mut index = Self::default();
        for (number, path) in (0..).zip(paths) {
            let part = PartFile::open(&path)?;
            index.entries.extend(part.segments.iter().zip(0..).map(|(s, at)| (s.id, number, at)));
            index.parts.push(part);
        }
        index.entries.sort_unstable();
        Ok(index)
    }

    /// Names of all segments, each once, in ascending order.
    pub(super) fn ids(&self) -> impl Iterator<Item = PageId> + '_ {
        self.entries.chunk_by(|a, b| a.0 == b.0).map(|run| run[0].0)
    }

    /// All segments with a name, in the order of the files.
    pub(super) fn find(&self, id: PageId) -> impl Iterator<Item = (&PartFile, &PartSegment)> {
        let from = self.entries.partition_point(|entry| entry.0 < id);
        let found = self.entries[from..].iter().take_while(move |entry| entry.0 == id);
        found.map(|&(_, file, at)| {
            let part = &self.parts[file as usize];
            (part, &part.segments[at as usize])
        })
    }
}
