//! Header and section table of a file.

use std::borrow::Cow;
use std::ops::Range;

use super::DecodeError;
use super::mesh_sections::metadata_from_bytes;
use super::section_kind::SectionKind;

pub(super) const MAGIC: [u8; 8] = *b"STRIATA\0";
/// Version of the file format that is written, and the only one that can be read.
pub const VERSION: u32 = 2;
pub(super) const HEADER_BYTES: usize = 64;
pub(super) const ENTRY_BYTES: usize = 32;
const ALIGNMENT: usize = 64;
/// Far more than any file needs; limits the work that a malicious table can cause.
pub(super) const MAX_SECTIONS: usize = 65_536;
/// Section flag: readers that do not know the kind must reject the file.
pub(super) const REQUIRED: u32 = 1;

/// A section, as listed in the section table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SectionInfo {
    /// Kind of the section.
    pub kind: SectionKind,
    /// Offset of the section in the file, in bytes.
    pub offset: u64,
    /// Length of the section, in bytes.
    pub bytes: u64,
    /// Whether a reader that does not know the kind must reject the file.
    pub is_required: bool,
    pub(super) checksum: u32,
}

/// When the checksums of sections are verified.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Verify {
    /// When a section is first read: opening a file touches only its header.
    #[default]
    WhenRead,
    /// All when the file is opened, which reads the whole file.
    All,
}

/// Whether a file may be truncated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ending {
    /// The file must have the length given in its header.
    Whole,
    /// The file may end anywhere within its stream.
    Cut,
}

/// The bytes of a file with its validated section table, whatever the sections contain.
#[derive(Clone, Debug)]
pub struct Container<'a> {
    bytes: &'a [u8],
    pub(super) sections: Vec<SectionInfo>,
    is_verified: bool,
    /// Length of the file, as given in its header.
    length: u64,
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    bytes.get(at..at + 4).and_then(|b| b.try_into().ok()).map_or(0, u32::from_le_bytes)
}

fn u64_at(bytes: &[u8], at: usize) -> u64 {
    u64::from(u32_at(bytes, at)) | u64::from(u32_at(bytes, at + 4)) << 32
}

/// Checksum of header and table, with the checksum field itself set to zero.
pub(super) fn header_checksum(head: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&head[..24]);
    hasher.update(&[0; 4]);
    hasher.update(&head[28..]);
    hasher.finalize()
}

impl<'a> Container<'a> {
    /// Reads the header and the section table of a complete file; `verify` says when the checksums of
    /// sections are compared.
    ///
    /// # Errors
    /// [`DecodeError`] if the bytes are not a container, or are damaged.
    pub fn open(bytes: &'a [u8], verify: Verify) -> Result<Self, DecodeError> {
        Self::parse(bytes, verify, Ending::Whole)
    }

    pub(super) fn parse(bytes: &'a [u8], verify: Verify, ending: Ending) -> Result<Self, DecodeError> {
        let found = bytes.len() as u64;
        let (length, head_bytes) = read_header(bytes)?;
        if found != length && (ending == Ending::Whole || found > length) {
            return Err(DecodeError::FileLength { found, expected: length });
        }
        let sections = read_sections(bytes, head_bytes, length)?;
        if found < length {
            // Everything but the stream must be present.
            let stream = sections.last().filter(|last| last.kind == SectionKind::STREAM);
            let expected = stream.map_or(length, |stream| stream.offset);
            if found < expected {
                return Err(DecodeError::FileLength { found, expected });
            }
        }
        let mut container = Self { bytes, sections, is_verified: false, length };
        if verify == Verify::All {
            for section in &container.sections {
                container.checked_bytes(section)?;
            }
            container.is_verified = true;
        }
        Ok(container)
    }

    /// A container whose only section is a stream of `length` bytes; its chunks have their own checksums.
    pub(super) fn of_stream(bytes: &'a [u8], length: u64) -> Self {
        let kind = SectionKind::STREAM;
        let stream = SectionInfo { kind, offset: 0, bytes: length, is_required: true, checksum: 0 };
        Self { bytes, sections: vec![stream], is_verified: true, length }
    }

    fn checked_bytes(&self, section: &SectionInfo) -> Result<&'a [u8], DecodeError> {
        // The table was checked against the length in the header; only a stream can extend past the
        // available bytes, whose count is a usize.
        let available = &self.bytes[section.offset as usize..];
        let length = section.bytes.min(available.len() as u64);
        let bytes = &available[..length as usize];
        let is_whole = length == section.bytes;
        if is_whole && !self.is_verified {
            let (found, expected) = (crc32fast::hash(bytes), section.checksum);
            if found != expected {
                let (kind, offset) = (section.kind, section.offset);
                return Err(DecodeError::Checksum { kind, offset, found, expected });
            }
        }
        Ok(bytes)
    }

    /// Fails if the file contains a scene, whose meshes are files of their own.
    pub(super) fn check_single_mesh(sections: &[SectionInfo]) -> Result<(), DecodeError> {
        let is_scene = sections.iter().any(|section| section.kind == SectionKind::SCENE);
        if is_scene { Err(DecodeError::Scene) } else { Ok(()) }
    }

    /// Whether the file is shorter than its header says.
    pub(super) fn is_truncated(&self) -> bool {
        (self.bytes.len() as u64) < self.length
    }

    /// All sections, in file order.
    pub fn sections(&self) -> &[SectionInfo] {
        &self.sections
    }

    /// Key-value texts about the file; empty if there are none.
    ///
    /// # Errors
    /// [`DecodeError`] if the section is damaged or repeated.
    pub fn metadata(&self) -> Result<Vec<(String, String)>, DecodeError> {
        self.find(SectionKind::METADATA)?.map_or(Ok(Vec::new()), metadata_from_bytes)
    }

    /// All sections of a kind, in file order; an error for each that is damaged.
    pub fn all(&self, kind: SectionKind) -> impl Iterator<Item = Result<&'a [u8], DecodeError>> {
        self.sections.iter().filter(move |s| s.kind == kind).map(|s| self.checked_bytes(s))
    }

    /// The section of a kind, or `None`.
    ///
    /// # Errors
    /// [`DecodeError`] if there are several, or if the section is damaged.
    pub fn find(&self, kind: SectionKind) -> Result<Option<&'a [u8]>, DecodeError> {
        let mut sections = self.sections.iter().filter(|s| s.kind == kind);
        let Some(section) = sections.next() else { return Ok(None) };
        match sections.count() {
            0 => self.checked_bytes(section).map(Some),
            more => Err(DecodeError::SectionCount { kind, found: more + 1 }),
        }
    }

    /// The only section of a kind.
    ///
    /// # Errors
    /// [`DecodeError`] if there is none or more than one, or if the section is damaged.
    pub fn get(&self, kind: SectionKind) -> Result<&'a [u8], DecodeError> {
        self.find(kind)?.ok_or(DecodeError::SectionCount { kind, found: 0 })
    }

    /// The only section of a kind as an array of numbers; borrowed if the bytes are aligned.
    pub(super) fn numbers<T: bytemuck::AnyBitPattern + bytemuck::NoUninit>(
        &self,
        kind: SectionKind,
    ) -> Result<Cow<'a, [T]>, DecodeError> {
        numbers(kind, self.get(kind)?)
    }
}

/// Reinterprets bytes as numbers; borrowed if the bytes are aligned.
pub(super) fn numbers<T: bytemuck::AnyBitPattern + bytemuck::NoUninit>(
    kind: SectionKind,
    bytes: &[u8],
) -> Result<Cow<'_, [T]>, DecodeError> {
    if !bytes.len().is_multiple_of(size_of::<T>()) {
        let reason = "the length is not a multiple of the element size";
        return Err(DecodeError::Malformed { kind, offset: bytes.len(), reason });
    }
    Ok(match bytemuck::try_cast_slice(bytes) {
        Ok(slice) => Cow::Borrowed(slice),
        Err(_) => bytes.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned).collect(),
    })
}

/// File length given in the header, and length of header and section table together, in bytes.
pub(super) fn read_header(bytes: &[u8]) -> Result<(u64, usize), DecodeError> {
    if !bytes.starts_with(&MAGIC) {
        return Err(DecodeError::Magic { found: bytes[..bytes.len().min(8)].to_vec() });
    }
    let found = bytes.len() as u64;
    if bytes.len() < HEADER_BYTES {
        return Err(DecodeError::FileLength { found, expected: HEADER_BYTES as u64 });
    }
    let version = u32_at(bytes, 8);
    if version != VERSION {
        return Err(DecodeError::Version { found: version, supported: VERSION });
    }
    let length = u64_at(bytes, 16);
    let count = u32_at(bytes, 12) as usize;
    let head_bytes = HEADER_BYTES + ENTRY_BYTES * count.min(MAX_SECTIONS + 1);
    if count > MAX_SECTIONS || head_bytes as u64 > length {
        return Err(DecodeError::FileLength { found: length, expected: head_bytes as u64 });
    }
    Ok((length, head_bytes))
}

/// Reads the section table after verifying its checksum; checks it against the file's length.
pub(super) fn read_sections(
    bytes: &[u8],
    head_bytes: usize,
    file_length: u64,
) -> Result<Vec<SectionInfo>, DecodeError> {
    let found = bytes.len() as u64;
    let head =
        bytes.get(..head_bytes).ok_or(DecodeError::FileLength { found, expected: head_bytes as u64 })?;
    let (checksum, expected) = (header_checksum(head), u32_at(head, 24));
    if checksum != expected {
        return Err(DecodeError::HeaderChecksum { found: checksum, expected });
    }
    read_table(head, file_length)
}

fn read_table(head: &[u8], file_length: u64) -> Result<Vec<SectionInfo>, DecodeError> {
    let mut sections = Vec::with_capacity((head.len() - HEADER_BYTES) / ENTRY_BYTES);
    let mut end = head.len() as u64;
    for entry in head[HEADER_BYTES..].chunks_exact(ENTRY_BYTES) {
        let kind = SectionKind([entry[0], entry[1], entry[2], entry[3]]);
        let (flags, offset, length) = (u32_at(entry, 4), u64_at(entry, 8), u64_at(entry, 16));
        let section_end = offset.checked_add(length).filter(|&e| e <= file_length);
        let Some(section_end) =
            section_end.filter(|_| offset >= end && offset.is_multiple_of(ALIGNMENT as u64))
        else {
            return Err(DecodeError::SectionLocation { kind, offset, length, file_length });
        };
        let is_required = flags & REQUIRED != 0;
        if is_required && !kind.is_known() {
            return Err(DecodeError::UnknownSection { kind });
        }
        sections.push(SectionInfo { kind, offset, bytes: length, is_required, checksum: u32_at(entry, 24) });
        end = section_end;
    }
    Ok(sections)
}

/// Padding bytes from `end` up to the next offset at which a section may start.
pub(super) fn padding(end: usize) -> Range<usize> {
    end..end.next_multiple_of(ALIGNMENT)
}
