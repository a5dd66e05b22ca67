//! The head of a paged file: a prefix of fixed size, metadata, and the directory of pages.
//!
//! ```text
//! prefix  64 bytes: magic, version, flags, sizes of metadata and root, offset of the pages, checksums
//! metadata         JSON
//! root             small files: all entries; large ones: an entry for each leaf
//! leaves           up to 1,024 entries each
//! pages            coarse to fine
//! ```

use crate::bytes::{put_varint, take_varint};
use crate::directory::MAX_BOUNDS;
use crate::{HeadDefect, Metadata, PageBound, PageEntry, PageId, PagedError};

/// First bytes of every head.
pub const PAGED_MAGIC: &[u8; 8] = b"striataP";
/// Name of the head in a folder or bucket.
pub const HEAD_NAME: &str = "head.striata";
/// Bytes of the prefix.
pub const PREFIX_BYTES: u64 = 64;
const VERSION: u32 = 1;
/// Flag: pages are objects of their own.
const SEPARATE: u32 = 1;
/// Number of pages above which the directory has leaves.
const MAX_ROOT_PAGES: usize = 2048;
/// Pages per leaf.
const LEAF_PAGES: usize = 1024;
/// Maximum size of a head in bytes.
const MAX_HEAD_BYTES: u64 = 1 << 32;
/// Maximum number of pages.
const MAX_PAGES: u64 = 1 << 28;

/// The first bytes of a paged file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Prefix {
    /// Whether pages are objects of their own, in a folder or bucket.
    pub is_separate: bool,
    /// Bytes of the metadata, which follow the prefix.
    pub metadata_bytes: u64,
    /// Bytes of the root of the directory, which follow the metadata.
    pub root_bytes: u64,
    /// Offset of the first page.
    pub pages_offset: u64,
    metadata_crc: u32,
    root_crc: u32,
}

/// One leaf of the directory, as the root describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Leaf {
    /// First byte, counted from the end of the root.
    pub offset: u64,
    /// Number of bytes.
    pub byte_count: u64,
    /// CRC-32 of the bytes.
    pub crc: u32,
    /// First page.
    pub first_page: u32,
    /// Number of pages.
    pub page_count: u32,
    /// Offset of its first page.
    pub page_offset: u64,
    /// Bounds and largest error of all its pages.
    pub bound: PageBound,
    /// Largest key of its steps.
    pub key: f32,
}

/// The root of a directory: entries, or leaves.
#[derive(Clone, Debug, PartialEq)]
pub enum Root {
    /// All entries.
    Entries(Vec<PageEntry>),
    /// Leaves that contain the entries.
    Leaves(Vec<Leaf>),
}

/// Writes the head of a file, or of a folder if `is_separate`. Entries must be in directory order.
pub fn write_head(metadata: &Metadata, entries: &[PageEntry], is_separate: bool) -> Vec<u8> {
    write_head_with(metadata, entries, is_separate, MAX_ROOT_PAGES)
}

fn write_head_with(
    metadata: &Metadata,
    entries: &[PageEntry],
    is_separate: bool,
    max_root_pages: usize,
) -> Vec<u8> {
    // Serializing plain data cannot fail.
    let json = serde_json::to_vec(metadata).unwrap_or_default();
    let (root, leaves) = write_directory(&BoundsQuantizer::of(metadata), entries, max_root_pages);
    let pages_offset = PREFIX_BYTES + (json.len() + root.len() + leaves.len()) as u64;
    let mut bytes = PAGED_MAGIC.to_vec();
    bytes.extend(VERSION.to_le_bytes());
    bytes.extend((if is_separate { SEPARATE } else { 0 }).to_le_bytes());
    bytes.extend((json.len() as u64).to_le_bytes());
    bytes.extend((root.len() as u64).to_le_bytes());
    bytes.extend(pages_offset.to_le_bytes());
    bytes.extend(crc32fast::hash(&json).to_le_bytes());
    bytes.extend(crc32fast::hash(&root).to_le_bytes());
    bytes.resize(PREFIX_BYTES as usize - 4, 0);
    let crc = crc32fast::hash(&bytes);
    bytes.extend(crc.to_le_bytes());
    bytes.extend(json);
    bytes.extend(root);
    bytes.extend(leaves);
    bytes
}

fn write_directory(
    quantizer: &BoundsQuantizer,
    entries: &[PageEntry],
    max_root_pages: usize,
) -> (Vec<u8>, Vec<u8>) {
    let mut root = Vec::new();
    put_varint(&mut root, entries.len() as u64);
    if entries.len() <= max_root_pages {
        put_varint(&mut root, 0);
        root.extend(write_entries(quantizer, entries, 0));
        return (root, Vec::new());
    }
    put_varint(&mut root, entries.len().div_ceil(LEAF_PAGES) as u64);
    let mut leaves = Vec::new();
    for (i, part) in entries.chunks(LEAF_PAGES).enumerate() {
        let bytes = write_entries(quantizer, part, (i * LEAF_PAGES) as u32);
        put_varint(&mut root, bytes.len() as u64);
        put_varint(&mut root, part.iter().map(|entry| u64::from(entry.byte_count)).sum());
        root.extend(crc32fast::hash(&bytes).to_le_bytes());
        quantizer.put(&mut root, &joined(part));
        let key = part.iter().map(|entry| entry.key).fold(0.0, f32::max);
        root.extend(class_of(key, KEY_BITS));
        leaves.extend(bytes);
    }
    (root, leaves)
}

/// Returns the common bounds and the largest error of pages.
fn joined(entries: &[PageEntry]) -> PageBound {
    let mut all = PageBound { min: [f32::MAX; 3], max: [f32::MIN; 3], error: 0.0 };
    for bound in entries.iter().flat_map(|entry| &entry.bounds) {
        for axis in 0..3 {
            all.min[axis] = all.min[axis].min(bound.min[axis]);
            all.max[axis] = all.max[axis].max(bound.max[axis]);
        }
        all.error = all.error.max(bound.error);
    }
    all
}

/// Number of low bits of keys and errors that are always zero.
const KEY_BITS: u32 = 18;
const ERROR_BITS: u32 = 17;

/// A rounded number in two bytes; numbers that are not rounded are rounded up.
fn class_of(x: f32, zero_bits: u32) -> [u8; 2] {
    let up = x.max(0.0).to_bits().saturating_add((1 << zero_bits) - 1);
    ((up.min(f32::MAX.to_bits()) >> zero_bits) as u16).to_le_bytes()
}

/// Coordinates as shares of the bounds of the mesh, in 16 bits, rounded outward.
struct BoundsQuantizer {
    min: [f64; 3],
    step: [f64; 3],
}

impl BoundsQuantizer {
    const LARGEST: f64 = 65_535.0;

    fn of(metadata: &Metadata) -> Self {
        let min = metadata.min.map(f64::from);
        let step = [0, 1, 2].map(|a| (f64::from(metadata.max[a]) - min[a]) / Self::LARGEST);
        Self { min, step }
    }

    fn put(&self, bytes: &mut Vec<u8>, bound: &PageBound) {
        for (corner, is_max) in [(bound.min, false), (bound.max, true)] {
            for (axis, &x) in corner.iter().enumerate() {
                let share = (f64::from(x) - self.min[axis]) / self.step[axis];
                let share = if is_max { share.ceil() } else { share.floor() };
                // Without extent the share is not a number, which becomes 0.
                bytes.extend((share.clamp(0.0, Self::LARGEST) as u16).to_le_bytes());
            }
        }
        bytes.extend(class_of(bound.error, ERROR_BITS));
    }

    fn take(&self, parser: &mut Parser<'_>) -> Result<PageBound, HeadDefect> {
        let mut corners = [[0.0; 3]; 2];
        for (i, corner) in corners.iter_mut().enumerate() {
            for (axis, x) in corner.iter_mut().enumerate() {
                let share = f64::from(u16::from_le_bytes(parser.array()?));
                let exact = (self.min[axis] + share * self.step[axis]) as f32;
                // The sum may have been rounded inward.
                *x = if i == 0 { exact.next_down() } else { exact.next_up() };
            }
        }
        let [min, max] = corners;
        Ok(PageBound { min, max, error: parser.class(ERROR_BITS)? })
    }
}

fn write_entries(quantizer: &BoundsQuantizer, entries: &[PageEntry], first: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    for (index, entry) in (first..).zip(entries) {
        bytes.push(entry.id.level);
        put_varint(&mut bytes, u64::from(entry.id.cell));
        bytes.extend(entry.crc.to_le_bytes());
        let counts = [
            entry.byte_count,
            entry.position_count,
            entry.vertex_count,
            entry.triangle_count,
            entry.added_triangle_count,
        ];
        counts.iter().for_each(|&count| put_varint(&mut bytes, u64::from(count)));
        bytes.extend(class_of(entry.error, ERROR_BITS));
        bytes.extend(class_of(entry.key, KEY_BITS));
        put_varint(&mut bytes, entry.parents.len() as u64);
        let mut last = index;
        for &parent in entry.parents.iter().rev() {
            put_varint(&mut bytes, u64::from(last - parent));
            last = parent;
        }
        put_varint(&mut bytes, entry.bounds.len() as u64);
        entry.bounds.iter().for_each(|bound| quantizer.put(&mut bytes, bound));
    }
    bytes
}

/// Reads from the front of bytes; every method fails at their end.
struct Parser<'a> {
    bytes: &'a [u8],
}

impl Parser<'_> {
    fn varint(&mut self) -> Result<u64, HeadDefect> {
        take_varint(&mut self.bytes).ok_or(HeadDefect::Truncated)
    }

    fn count(&mut self, most: u64) -> Result<u32, HeadDefect> {
        let count = self.varint()?;
        if count > most.min(u64::from(u32::MAX)) { Err(HeadDefect::Count(count)) } else { Ok(count as u32) }
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], HeadDefect> {
        let (taken, rest) = self.bytes.split_first_chunk::<N>().ok_or(HeadDefect::Truncated)?;
        self.bytes = rest;
        Ok(*taken)
    }

    fn u32(&mut self) -> Result<u32, HeadDefect> {
        self.array().map(u32::from_le_bytes)
    }

    fn class(&mut self, zero_bits: u32) -> Result<f32, HeadDefect> {
        let class = u16::from_le_bytes(self.array()?);
        let x = f32::from_bits(u32::from(class) << zero_bits);
        if x.is_finite() { Ok(x) } else { Err(HeadDefect::NotFinite) }
    }
}

impl Prefix {
    /// Reads the first [`PREFIX_BYTES`] bytes of a file.
    ///
    /// # Errors
    /// [`PagedError::Head`] if they do not begin a paged file.
    pub fn parse(bytes: &[u8]) -> Result<Self, PagedError> {
        let bytes: &[u8; PREFIX_BYTES as usize] =
            bytes.first_chunk().ok_or(PagedError::Head(HeadDefect::Truncated))?;
        if !bytes.starts_with(PAGED_MAGIC) {
            return Err(HeadDefect::Magic.into());
        }
        let u32_at = |at: usize| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        let u64_at = |at: usize| u64::from(u32_at(at)) | u64::from(u32_at(at + 4)) << 32;
        if u32_at(8) != VERSION {
            return Err(HeadDefect::Version(u32_at(8)).into());
        }
        if crc32fast::hash(&bytes[..60]) != u32_at(60) {
            return Err(HeadDefect::Checksum("prefix").into());
        }
        let prefix = Self {
            is_separate: u32_at(12) & SEPARATE != 0,
            metadata_bytes: u64_at(16),
            root_bytes: u64_at(24),
            pages_offset: u64_at(32),
            metadata_crc: u32_at(40),
            root_crc: u32_at(44),
        };
        let end = prefix.metadata_bytes.checked_add(prefix.root_bytes);
        let end = end.and_then(|bytes| bytes.checked_add(PREFIX_BYTES));
        if end.is_none_or(|end| end > prefix.pages_offset) || prefix.pages_offset > MAX_HEAD_BYTES {
            return Err(HeadDefect::Sizes.into());
        }
        Ok(prefix)
    }

    /// Reads metadata and root, which follow the prefix.
    ///
    /// # Errors
    /// [`PagedError::Head`] if they are damaged.
    pub fn parse_rest(&self, bytes: &[u8]) -> Result<(Metadata, Root), PagedError> {
        let (json, rest) =
            bytes.split_at_checked(self.metadata_bytes as usize).ok_or(HeadDefect::Truncated)?;
        let root = rest.get(..self.root_bytes as usize).ok_or(HeadDefect::Truncated)?;
        if crc32fast::hash(json) != self.metadata_crc {
            return Err(HeadDefect::Checksum("metadata").into());
        }
        if crc32fast::hash(root) != self.root_crc {
            return Err(HeadDefect::Checksum("directory").into());
        }
        let mut metadata: Metadata =
            serde_json::from_slice(json).map_err(|error| HeadDefect::Metadata(error.to_string()))?;
        // Earlier files have only the addresses of images, among the materials.
        if let Some(images) = metadata.appearance.get("images").filter(|_| metadata.images.is_empty()) {
            metadata.images = serde_json::from_value(images.clone())
                .map_err(|error| HeadDefect::Metadata(error.to_string()))?;
        }
        metadata.check().map_err(HeadDefect::Metadata)?;
        let root = parse_root(&BoundsQuantizer::of(&metadata), root)?;
        Ok((metadata, root))
    }
}

fn parse_root(quantizer: &BoundsQuantizer, bytes: &[u8]) -> Result<Root, HeadDefect> {
    let mut parser = Parser { bytes };
    let page_count = parser.count(MAX_PAGES)?;
    let leaf_count = parser.varint()?;
    if leaf_count == 0 {
        return parse_entries(quantizer, &mut parser, 0, page_count, 0).map(Root::Entries);
    }
    if leaf_count != u64::from(page_count).div_ceil(LEAF_PAGES as u64) {
        return Err(HeadDefect::Count(leaf_count));
    }
    let (mut leaves, mut offset, mut page_offset) = (Vec::new(), 0u64, 0u64);
    for leaf in 0..leaf_count as u32 {
        let (byte_count, pages_bytes) = (parser.varint()?, parser.varint()?);
        let crc = parser.u32()?;
        let first_page = leaf * LEAF_PAGES as u32;
        let bound = quantizer.take(&mut parser)?;
        let key = parser.class(KEY_BITS)?;
        let count = (LEAF_PAGES as u32).min(page_count - first_page);
        leaves.push(Leaf { offset, byte_count, crc, first_page, page_count: count, page_offset, bound, key });
        offset = offset.checked_add(byte_count).ok_or(HeadDefect::Sizes)?;
        page_offset = page_offset.checked_add(pages_bytes).ok_or(HeadDefect::Sizes)?;
    }
    Ok(Root::Leaves(leaves))
}

impl Leaf {
    /// Reads the entries of a leaf.
    ///
    /// # Errors
    /// [`PagedError::Head`] if it is damaged.
    pub fn parse(&self, bytes: &[u8], metadata: &Metadata) -> Result<Vec<PageEntry>, PagedError> {
        if bytes.len() as u64 != self.byte_count || crc32fast::hash(bytes) != self.crc {
            return Err(HeadDefect::Checksum("directory").into());
        }
        let (quantizer, mut parser) = (BoundsQuantizer::of(metadata), Parser { bytes });
        Ok(parse_entries(&quantizer, &mut parser, self.first_page, self.page_count, self.page_offset)?)
    }
}

fn parse_entries(
    quantizer: &BoundsQuantizer,
    parser: &mut Parser<'_>,
    first: u32,
    count: u32,
    mut offset: u64,
) -> Result<Vec<PageEntry>, HeadDefect> {
    let mut entries: Vec<PageEntry> = Vec::new();
    for index in first..first + count {
        let [level] = parser.array()?;
        let cell = parser.count(u64::MAX)?;
        let crc = parser.u32()?;
        let mut counts = [0; 5];
        for count in &mut counts {
            *count = parser.count(u64::MAX)?;
        }
        let (error, key) = (parser.class(ERROR_BITS)?, parser.class(KEY_BITS)?);
        let parent_count = parser.count(u64::from(index))?;
        let (mut parents, mut last) = (Vec::new(), index);
        for _ in 0..parent_count {
            let delta = parser.count(u64::from(last))?;
            if delta == 0 {
                return Err(HeadDefect::Parent { page: index });
            }
            last -= delta;
            parents.push(last);
        }
        parents.reverse();
        let bound_count = parser.count(MAX_BOUNDS as u64)?;
        let bounds = (0..bound_count).map(|_| quantizer.take(parser)).collect::<Result<_, _>>()?;
        let [byte_count, position_count, vertex_count, triangle_count, added_triangle_count] = counts;
        entries.push(PageEntry {
            id: PageId { level, cell },
            offset,
            byte_count,
            crc,
            position_count,
            vertex_count,
            triangle_count,
            added_triangle_count,
            error,
            key,
            parents,
            bounds,
        });
        offset = offset.checked_add(u64::from(byte_count)).ok_or(HeadDefect::Sizes)?;
    }
    Ok(entries)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entries(count: u32) -> Vec<PageEntry> {
        let mut offset = 0;
        let entry = |i: u32| {
            let bound = PageBound { min: [i as f32, 0.0, 1.0], max: [i as f32 + 1.0; 3], error: 0.5 };
            let entry = PageEntry {
                id: PageId { level: 3 - (i * 4 / count) as u8, cell: i },
                offset,
                byte_count: 1000 + i,
                crc: i * 77,
                position_count: 10,
                vertex_count: 11,
                triangle_count: 20 + i,
                added_triangle_count: 15,
                error: 0.25,
                key: 1.0,
                parents: (i.saturating_sub(3)..i).collect(),
                bounds: vec![bound; 1 + i as usize % 8],
            };
            offset += u64::from(entry.byte_count);
            entry
        };
        (0..count).map(entry).collect()
    }

    fn metadata() -> Metadata {
        Metadata { cell_counts: vec![4, 2, 1], max: [20_000.0; 3], ..Metadata::default() }
    }

    fn parse(bytes: &[u8]) -> Result<(Metadata, Vec<PageEntry>), PagedError> {
        let prefix = Prefix::parse(bytes)?;
        let (metadata, root) = prefix.parse_rest(&bytes[PREFIX_BYTES as usize..])?;
        let entries = match root {
            Root::Entries(entries) => entries,
            Root::Leaves(leaves) => {
                let at = (PREFIX_BYTES + prefix.metadata_bytes + prefix.root_bytes) as usize;
                let mut all = Vec::new();
                for leaf in leaves {
                    let from = at + leaf.offset as usize;
                    let bytes = bytes.get(from..from + leaf.byte_count as usize);
                    all.extend(leaf.parse(bytes.ok_or(HeadDefect::Truncated)?, &metadata)?);
                }
                all
            }
        };
        Ok((metadata, entries))
    }

    #[test]
    fn addresses_of_images_in_earlier_files_are_read() {
        let appearance = serde_json::json!({"images": [{"name": "bark", "uri": "bark.png"}]});
        let bytes = write_head(&Metadata { appearance, ..metadata() }, &entries(5), false);
        let (prefix, rest) = bytes.split_at(PREFIX_BYTES as usize);
        let (read, _) = Prefix::parse(prefix).unwrap().parse_rest(rest).unwrap();
        let expected =
            crate::PagedImage { name: "bark".into(), uri: "bark.png".into(), ..Default::default() };
        assert_eq!(read.images, [expected]);
    }

    #[test]
    fn heads_round_trip_with_and_without_leaves() {
        let metadata = Metadata { source: "a".to_owned(), triangle_count: 9, ..metadata() };
        for most in [100_000, 100] {
            let entries = entries(10_000);
            let bytes = write_head_with(&metadata, &entries, false, most);
            let (read, found) = parse(&bytes).unwrap();
            assert_eq!(read, metadata);
            assert_eq!(found.len(), entries.len());
            for (found, entry) in found.iter().zip(&entries) {
                for (wide, bound) in found.bounds.iter().zip(&entry.bounds) {
                    assert!((0..3).all(|a| wide.min[a] <= bound.min[a] && wide.max[a] >= bound.max[a]));
                    assert!((0..3).all(|a| bound.min[a] - wide.min[a] < 0.5 && wide.error == bound.error));
                }
                assert_eq!(PageEntry { bounds: entry.bounds.clone(), ..found.clone() }, *entry);
            }
        }
    }

    #[test]
    fn damage_is_an_error() {
        let bytes = write_head(&metadata(), &entries(20), true);
        assert!(Prefix::parse(&bytes).unwrap().is_separate);
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1;
            assert!(parse(&damaged).is_err(), "byte {at}");
            assert!(parse(&bytes[..at]).is_err());
        }
    }

    #[test]
    fn damage_behind_checksums_is_found_or_harmless() {
        let entries = entries(20);
        let quantizer = BoundsQuantizer::of(&metadata());
        let root = write_directory(&quantizer, &entries, 100).0;
        for at in 0..root.len() {
            for bit in 0..8 {
                let mut damaged = root.clone();
                damaged[at] ^= 1 << bit;
                if let Ok(Root::Entries(entries)) = parse_root(&quantizer, &damaged) {
                    let is_smaller = |(i, entry): (usize, &PageEntry)| {
                        entry.parents.iter().all(|&parent| (parent as usize) < i)
                    };
                    assert!(entries.iter().enumerate().all(is_smaller));
                }
            }
        }
    }
}
