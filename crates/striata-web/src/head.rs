//! Where in a `.striata` file its stream lies, told by the file's first bytes, so that a page fetches only that.

use wasm_bindgen::prelude::wasm_bindgen;

use crate::Failure;

const MAGIC: &[u8] = b"STRIATA\0";
const HEADER_BYTES: usize = 64;
const ROW_BYTES: usize = 32;
/// As many as a file may have.
const MOST_SECTIONS: usize = 65_536;
/// Where the header keeps its own checksum.
const CHECKSUM_AT: usize = 24;

/// What the first bytes of a file tell of the place of its stream.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StreamPlace {
    /// First bytes of the file that it takes to know; more than were given: ask again with so many.
    pub needed: f64,
    /// Where the stream begins, bytes from the file's beginning.
    pub offset: f64,
    /// Its bytes; 0 if the file has no stream.
    pub length: f64,
}

#[wasm_bindgen]
impl StreamPlace {
    /// Looks for the stream of a `.striata` file.
    ///
    /// # Errors
    /// Where the bytes begin no `.striata` file, or its header is damaged.
    pub fn find(head: &[u8]) -> Result<Self, Failure> {
        let needed = |count: usize| Self { needed: count as f64, offset: 0.0, length: 0.0 };
        if !head.starts_with(MAGIC) {
            return Err(Failure::format("this is no .striata file"));
        }
        let Some(header) = head.first_chunk::<HEADER_BYTES>() else { return Ok(needed(HEADER_BYTES)) };
        let section_count = u32_at(header, 12) as usize;
        if section_count > MOST_SECTIONS {
            let message = format!("the header is damaged: it tells of {section_count} sections");
            return Err(Failure::corrupt(message));
        }
        let end = HEADER_BYTES + ROW_BYTES * section_count;
        let Some(table) = head.get(HEADER_BYTES..end) else { return Ok(needed(end)) };
        check_sum(&head[..end])?;
        let file_length = u64_at(header, 16);
        let (rows, _) = table.as_chunks::<ROW_BYTES>();
        let Some(row) = rows.iter().find(|row| row.starts_with(b"STRM")) else { return Ok(needed(end)) };
        let (offset, length) = (u64_at(row, 8), u64_at(row, 16));
        if offset.checked_add(length).is_none_or(|stream_end| stream_end > file_length) {
            let message = format!("the stream of {length} bytes at byte {offset} lies outside the file");
            return Err(Failure::corrupt(message));
        }
        Ok(Self { needed: end as f64, offset: offset as f64, length: length as f64 })
    }
}

/// # Errors
/// Where the header is not what it was when it was written.
fn check_sum(head: &[u8]) -> Result<(), Failure> {
    let expected = u32_at(head, CHECKSUM_AT);
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&head[..CHECKSUM_AT]);
    hasher.update(&[0; 4]);
    hasher.update(&head[CHECKSUM_AT + 4..]);
    let found = hasher.finalize();
    if found == expected {
        return Ok(());
    }
    Err(Failure::corrupt(format!("the header is damaged: checksum {found:08x}, expected {expected:08x}")))
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    bytes[at..].first_chunk().map_or(0, |&b| u32::from_le_bytes(b))
}

fn u64_at(bytes: &[u8], at: usize) -> u64 {
    bytes[at..].first_chunk().map_or(0, |&b| u64::from_le_bytes(b))
}
