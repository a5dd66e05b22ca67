//! What the first bytes of a file tell: sections and counts, without the rest of it.
//!
//! Lists of files need no more, and who fetches a file over a network learns from it which bytes to ask for.
//! Cost: time and memory of the table, no more than the bytes that are there.

use super::container::{HEADER_BYTES, read_header, read_sections};
use super::{DecodeError, SectionInfo, SectionKind, Summary};

/// Table and counts of a `.striata` file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FileHead {
    /// Bytes of the whole file.
    pub file_bytes: u64,
    /// All sections, in the order of the file.
    pub sections: Vec<SectionInfo>,
    /// Counts and bounds.
    pub summary: Summary,
}

impl FileHead {
    /// Reads the head from the first bytes of a file; none where there are too few of them.
    ///
    /// # Errors
    /// [`DecodeError`] where they begin no `.striata` file that this version reads, or are damaged.
    pub fn read(bytes: &[u8]) -> Result<Option<Self>, DecodeError> {
        if bytes.len() < HEADER_BYTES {
            return Ok(None);
        }
        let (file_bytes, head_bytes) = read_header(bytes)?;
        if bytes.len() < head_bytes {
            return Ok(None);
        }
        let sections = read_sections(bytes, head_bytes, file_bytes)?;
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
