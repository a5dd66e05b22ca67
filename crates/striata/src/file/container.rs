//! Header and table of sections.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;

use super::DecodeError;

pub(super) const MAGIC: [u8; 8] = *b"STRIATA\0";
/// Version of the file format that is written, and the only one that is read.
pub const VERSION: u32 = 1;
pub(super) const HEADER_BYTES: usize = 64;
pub(super) const ENTRY_BYTES: usize = 32;
pub(super) const ALIGNMENT: usize = 64;
/// Far over what any file needs; keeps a hostile table from being long work.
const MAX_SECTIONS: usize = 65_536;
/// Readers that do not know the section must refuse the file.
pub(super) const REQUIRED: u32 = 1;

/// The kind of a section: four letters.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SectionKind(pub [u8; 4]);

impl SectionKind {
    /// Counts and bounds, see [`Summary`](super::Summary).
    pub const SUMMARY: Self = Self(*b"SUMM");
    /// Texts about the file, by key.
    pub const METADATA: Self = Self(*b"META");
    /// Positions of the vertices.
    pub const POSITIONS: Self = Self(*b"POSN");
    /// One attribute layer; there may be many.
    pub const LAYER: Self = Self(*b"LAYR");
    /// Groups of triangles.
    pub const GROUPS: Self = Self(*b"GRUP");
    /// Materials, images and textures.
    pub const APPEARANCE: Self = Self(*b"APPR");
    /// Triangles of the full mesh; only in files without strips.
    pub const TRIANGLES: Self = Self(*b"TRIS");
    /// First vertices of the positions; only where a position has several.
    pub const FIRST_VERTICES: Self = Self(*b"SQFV");
    /// Targets of the collapses.
    pub const TARGETS: Self = Self(*b"SQTG");
    /// Errors of the levels.
    pub const ERRORS: Self = Self(*b"SQER");
    /// Triangles that each collapse removes.
    pub const REMOVED: Self = Self(*b"SQRM");
    /// Indices of the strips of the full mesh, from which models of strips start.
    pub const STRIP_INDICES: Self = Self(*b"LSIX");
    /// First index of each strip.
    pub const STRIP_OFFSETS: Self = Self(*b"LSOF");
    /// First strip of each group.
    pub const STRIP_GROUPS: Self = Self(*b"LSGR");
    /// LodStrips: bytes of each record.
    pub const RECORD_LENGTHS: Self = Self(*b"LSRL");
    /// LodStrips: the records.
    pub const RECORDS: Self = Self(*b"LSAR");
    /// MTS: the last change of its strip after which each place is there.
    pub const LAST_CHANGES: Self = Self(*b"MTLC");
    /// MTS: first break of each strip.
    pub const BREAK_OFFSETS: Self = Self(*b"MTBO");
    /// MTS: the breaks.
    pub const BREAKS: Self = Self(*b"MTBR");
    /// MTS: bytes of each record.
    pub const CHANGE_LENGTHS: Self = Self(*b"MTRL");
    /// MTS: the records, which name the strips that a step changes.
    pub const CHANGES: Self = Self(*b"MTCH");
    /// Fans: the entries of all vertices.
    pub const FAN_ENTRIES: Self = Self(*b"FNEN");
    /// Fans: where each block of vertices begins, or each vertex.
    pub const FAN_BLOCKS: Self = Self(*b"FNBL");
    /// Fans: where each vertex begins in its block.
    pub const FAN_STARTS: Self = Self(*b"FNST");
    /// Fans: steps that wait for others beside those that make their triangles.
    pub const FAN_WAITS: Self = Self(*b"FNWT");
    /// Fans: steps whose target is not around them.
    pub const FAN_FAR_TARGETS: Self = Self(*b"FNFT");
    /// Fans: steps that no entry has.
    pub const FAN_ORPHANS: Self = Self(*b"FNOR");
    /// Fans: what a criterion needs of each step.
    pub const FAN_BOUNDS: Self = Self(*b"FNBD");
    /// Patterns: how numbers are packed.
    pub const PATTERN_WIDTHS: Self = Self(*b"PTWD");
    /// Patterns: the rules.
    pub const PATTERN_RULES: Self = Self(*b"PTRU");
    /// Patterns: the ways in which ceilings are shared.
    pub const PATTERN_WAYS: Self = Self(*b"PTWY");
    /// Patterns: where each block of records begins.
    pub const PATTERN_BLOCKS: Self = Self(*b"PTBL");
    /// Patterns: the records of all steps.
    pub const PATTERN_RECORDS: Self = Self(*b"PTRC");
    /// Patterns: triangles of the base and where they go.
    pub const PATTERN_BASE: Self = Self(*b"PTBS");
    /// Patterns: vertices that no triangle of a fragment tells.
    pub const PATTERN_EXTRAS: Self = Self(*b"PTEX");
    /// Patterns: what a criterion needs of each step.
    pub const PATTERN_BOUNDS: Self = Self(*b"PTBD");
    /// The progressive stream.
    pub const STREAM: Self = Self(*b"STRM");

    fn is_known(self) -> bool {
        [
            Self::SUMMARY,
            Self::METADATA,
            Self::POSITIONS,
            Self::LAYER,
            Self::GROUPS,
            Self::APPEARANCE,
            Self::TRIANGLES,
            Self::FIRST_VERTICES,
            Self::TARGETS,
            Self::ERRORS,
            Self::REMOVED,
            Self::STRIP_INDICES,
            Self::STRIP_OFFSETS,
            Self::STRIP_GROUPS,
            Self::RECORD_LENGTHS,
            Self::RECORDS,
            Self::LAST_CHANGES,
            Self::BREAK_OFFSETS,
            Self::BREAKS,
            Self::CHANGE_LENGTHS,
            Self::CHANGES,
            Self::FAN_ENTRIES,
            Self::FAN_BLOCKS,
            Self::FAN_STARTS,
            Self::FAN_WAITS,
            Self::FAN_FAR_TARGETS,
            Self::FAN_ORPHANS,
            Self::FAN_BOUNDS,
            Self::PATTERN_WIDTHS,
            Self::PATTERN_RULES,
            Self::PATTERN_WAYS,
            Self::PATTERN_BLOCKS,
            Self::PATTERN_RECORDS,
            Self::PATTERN_BASE,
            Self::PATTERN_EXTRAS,
            Self::PATTERN_BOUNDS,
            Self::STREAM,
        ]
        .contains(&self)
    }
}

impl fmt::Display for SectionKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0.escape_ascii())
    }
}

impl fmt::Debug for SectionKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

/// One section as the table lists it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SectionInfo {
    /// What it holds.
    pub kind: SectionKind,
    /// Where it begins in the file.
    pub offset: u64,
    /// Its bytes.
    pub bytes: u64,
    /// True where a reader that does not know the kind must refuse the file.
    pub is_required: bool,
    pub(super) checksum: u32,
}

/// When checksums of sections are compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Verify {
    /// Each section when it is read: opening touches only the header.
    #[default]
    WhenRead,
    /// All sections at once: opening reads the whole file.
    All,
}

/// Whether the end of a file may be missing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ending {
    /// The file has the length that its header says.
    Whole,
    /// It may end anywhere within its stream.
    Cut,
}

/// The bytes of a file with its checked table.
#[derive(Clone, Debug)]
pub(super) struct Container<'a> {
    bytes: &'a [u8],
    pub(super) sections: Vec<SectionInfo>,
    is_verified: bool,
    /// The length that the header says.
    length: u64,
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    bytes.get(at..at + 4).and_then(|b| b.try_into().ok()).map_or(0, u32::from_le_bytes)
}

fn u64_at(bytes: &[u8], at: usize) -> u64 {
    u64::from(u32_at(bytes, at)) | u64::from(u32_at(bytes, at + 4)) << 32
}

/// Checksum of header and table, its own field taken as zero.
pub(super) fn header_checksum(head: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&head[..24]);
    hasher.update(&[0; 4]);
    hasher.update(&head[28..]);
    hasher.finalize()
}

impl<'a> Container<'a> {
    pub(super) fn parse(bytes: &'a [u8], verify: Verify, ending: Ending) -> Result<Self, DecodeError> {
        let found = bytes.len() as u64;
        let (length, head_bytes) = read_header(bytes)?;
        if found != length && (ending == Ending::Whole || found > length) {
            return Err(DecodeError::FileLength { found, expected: length });
        }
        let sections = read_sections(bytes, head_bytes, length)?;
        if found < length {
            // All but the stream has to be there.
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

    /// A stream of so many bytes as the only section, its chunks checked by themselves.
    pub(super) fn of_stream(bytes: &'a [u8], length: u64) -> Self {
        let kind = SectionKind::STREAM;
        let stream = SectionInfo { kind, offset: 0, bytes: length, is_required: true, checksum: 0 };
        Self { bytes, sections: vec![stream], is_verified: true, length }
    }

    fn checked_bytes(&self, section: &SectionInfo) -> Result<&'a [u8], DecodeError> {
        // The table was checked against the length in the header: only a stream may reach beyond what is there, which is a usize.
        let there = &self.bytes[section.offset as usize..];
        let length = section.bytes.min(there.len() as u64);
        let bytes = &there[..length as usize];
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

    /// Whether the file ends before its header says.
    pub(super) fn is_cut(&self) -> bool {
        (self.bytes.len() as u64) < self.length
    }

    /// The sections of a kind, in the order of the file.
    pub(super) fn all(&self, kind: SectionKind) -> impl Iterator<Item = Result<&'a [u8], DecodeError>> {
        self.sections.iter().filter(move |s| s.kind == kind).map(|s| self.checked_bytes(s))
    }

    /// The one section of a kind, if there is any.
    pub(super) fn find(&self, kind: SectionKind) -> Result<Option<&'a [u8]>, DecodeError> {
        let mut sections = self.sections.iter().filter(|s| s.kind == kind);
        let Some(section) = sections.next() else { return Ok(None) };
        match sections.count() {
            0 => self.checked_bytes(section).map(Some),
            more => Err(DecodeError::SectionCount { kind, found: more + 1 }),
        }
    }

    /// The one section of a kind.
    pub(super) fn get(&self, kind: SectionKind) -> Result<&'a [u8], DecodeError> {
        self.find(kind)?.ok_or(DecodeError::SectionCount { kind, found: 0 })
    }

    /// The one section of a kind as numbers; borrowed where the bytes are aligned.
    pub(super) fn numbers<T: bytemuck::AnyBitPattern + bytemuck::NoUninit>(
        &self,
        kind: SectionKind,
    ) -> Result<Cow<'a, [T]>, DecodeError> {
        numbers(kind, self.get(kind)?)
    }
}

/// Bytes as numbers; borrowed where they are aligned.
pub(super) fn numbers<T: bytemuck::AnyBitPattern + bytemuck::NoUninit>(
    kind: SectionKind,
    bytes: &[u8],
) -> Result<Cow<'_, [T]>, DecodeError> {
    if !bytes.len().is_multiple_of(size_of::<T>()) {
        let reason = "the length is no multiple of a number's bytes";
        return Err(DecodeError::Malformed { kind, offset: bytes.len(), reason });
    }
    Ok(match bytemuck::try_cast_slice(bytes) {
        Ok(slice) => Cow::Borrowed(slice),
        Err(_) => bytes.chunks_exact(size_of::<T>()).map(bytemuck::pod_read_unaligned).collect(),
    })
}

/// The length of the file as its header says, and the bytes of header and table.
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

/// The table that follows the header, checked against its checksum and the file's length.
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
            return Err(DecodeError::SectionPlace { kind, offset, length, file_length });
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

/// Bytes from `end` on to the next place where a section may begin.
pub(super) fn padding(end: usize) -> Range<usize> {
    end..end.next_multiple_of(ALIGNMENT)
}
