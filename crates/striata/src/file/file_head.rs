//! Sections and counts of a file, read from its first bytes only.
//!
//! This is enough to list files, and to decide which byte ranges to fetch over a network. Cost: linear in
//! the size of the section table.

use super::container::{Container, HEADER_BYTES, read_header, read_sections};
use super::{DecodeError, SectionInfo, SectionKind, Summary};

/// Section table and summary of a `.striata` file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FileHead {
    /// Length of the whole file, in bytes.
    pub file_bytes: u64,
    /// All sections, in file order.
    pub sections: Vec<SectionInfo>,
    /// Counts and bounds.
    pub summary: Summary,
}

impl FileHead {
    /// Reads the head from the first bytes of a file; `None` if more bytes are needed.
    ///
    /// # Errors
    /// [`DecodeError`] if the bytes do not start a `.striata` file of the supported version, or are damaged.
    pub fn read(bytes: &[u8]) -> Result<Option<Self>, DecodeError> {
        if bytes.len() < HEADER_BYTES {
            return Ok(None);
        }
        let (file_bytes, head_bytes) = read_header(bytes)?;
        if bytes.len() < head_bytes {
            return Ok(None);
        }
        let sections = read_sections(bytes, head_bytes, file_bytes)?;
        Container::check_single_mesh(&sections)?;
        let kind = SectionKind::SUMMARY;
        let mut summaries = sections.iter().filter(|section| section.kind == kind);
        let (Some(section), 0) = (summaries.next(), summaries.count()) else {
            let found = sections.iter().filter(|section| section.kind == kind).count();
            return Err(DecodeError::SectionCount { kind, found });
        };
        let Some(summary) = bytes_of(bytes, section) else { return Ok(None) };
        let (found, expected) = (crc32fast::hash(summary), section.checksum);
        if found != expected {
            return Err(DecodeError::Checksum { kind, offset: section.offset, found, expected });
        }
        let summary = Summary::from_bytes(summary)?;
        Ok(Some(Self { file_bytes, sections, summary }))
    }

    /// The section of the progressive stream, if the file has one.
    pub fn stream(&self) -> Option<SectionInfo> {
        self.sections.iter().copied().find(|section| section.kind == SectionKind::STREAM)
    }
}

fn bytes_of<'a>(bytes: &'a [u8], section: &SectionInfo) -> Option<&'a [u8]> {
    let start = usize::try_from(section.offset).ok()?;
    bytes.get(start..start.checked_add(usize::try_from(section.bytes).ok()?)?)
}
