//! File with random access, of which a small part is cached in memory.
//!
//! The page with index `i` is cached in slot `i` modulo the number of slots. Loading a page evicts the
//! previous one of its slot, which is written back if it was changed. Vertices that are close in space are
//! usually close in the file, so most accesses hit a cached page.

use std::io::{self, Read, Seek, SeekFrom, Write};

use crate::file_view::FileView;

const PAGE_BYTES: usize = 1 << 14;
/// Number of cached pages: 8 MiB in memory.
const SLOT_COUNT: usize = 512;

/// Part of a file, accessed through cached pages.
#[derive(Debug)]
pub(super) struct CachedFile {
    file: FileView,
    /// Offset of the first page in the file.
    start: u64,
    bytes: u64,
    pages: Vec<CachedPage>,
}

/// Cached page.
#[derive(Clone, Debug, Default)]
struct CachedPage {
    index: Option<u64>,
    is_changed: bool,
    bytes: Vec<u8>,
}

impl CachedFile {
    /// Opens the part of a file that starts at `start` and is `bytes` long.
    pub(super) fn new(file: FileView, start: u64, bytes: u64) -> Self {
        let page_count = bytes.div_ceil(PAGE_BYTES as u64).clamp(1, SLOT_COUNT as u64);
        Self { file, start, bytes, pages: vec![CachedPage::default(); page_count as usize] }
    }

    /// Fills `out` with the bytes from `at` on.
    pub(super) fn read(&mut self, mut at: u64, mut out: &mut [u8]) -> io::Result<()> {
        while !out.is_empty() {
            let (page, first) = self.page(at)?;
            let length = out.len().min(page.bytes.len().saturating_sub(first));
            if length == 0 {
                return Err(io::ErrorKind::UnexpectedEof.into());
            }
            let (head, rest) = out.split_at_mut(length);
            head.copy_from_slice(&page.bytes[first..first + length]);
            (at, out) = (at + length as u64, rest);
        }
        Ok(())
    }

    /// Reads entry `index` of an array of four-byte integers.
    pub(super) fn read_u32(&mut self, index: u32) -> io::Result<u32> {
        let mut bytes = [0; 4];
        self.read(u64::from(index) * 4, &mut bytes)?;
        Ok(u32::from_le_bytes(bytes))
    }

    /// Overwrites entry `index` of an array of four-byte integers.
    pub(super) fn write_u32(&mut self, index: u32, number: u32) -> io::Result<()> {
        let (page, first) = self.page(u64::from(index) * 4)?;
        let Some(bytes) = page.bytes.get_mut(first..first + 4) else {
            return Err(io::ErrorKind::UnexpectedEof.into());
        };
        bytes.copy_from_slice(&number.to_le_bytes());
        page.is_changed = true;
        Ok(())
    }

    /// Returns the page of a byte, and the offset of that byte in it.
    #[inline]
    fn page(&mut self, at: u64) -> io::Result<(&mut CachedPage, usize)> {
        let (index, first) = (at / PAGE_BYTES as u64, (at % PAGE_BYTES as u64) as usize);
        let slot = (index % self.pages.len() as u64) as usize;
        if self.pages[slot].index != Some(index) {
            self.change_page(slot, index)?;
        }
        Ok((&mut self.pages[slot], first))
    }

    /// Loads a page into a slot, after writing back the changed page that was there.
    fn change_page(&mut self, slot: usize, index: u64) -> io::Result<()> {
        let page = &mut self.pages[slot];
        let offset_of = |index: u64| SeekFrom::Start(self.start + index * PAGE_BYTES as u64);
        if let Some(old) = page.index.take().filter(|_| page.is_changed) {
            self.file.seek(offset_of(old))?;
            self.file.write_all(&page.bytes)?;
        }
        let left = self.bytes.saturating_sub(index * PAGE_BYTES as u64);
        page.bytes.resize(left.min(PAGE_BYTES as u64) as usize, 0);
        self.file.seek(offset_of(index))?;
        self.file.read_exact(&mut page.bytes)?;
        (page.index, page.is_changed) = (Some(index), false);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;

    #[test]
    fn evicted_pages_are_written_back() {
        let file = tempfile::tempfile().unwrap();
        // Three times what fits into the cache, and half a page.
        let count = (3 * SLOT_COUNT * PAGE_BYTES + PAGE_BYTES / 2) as u32 / 4;
        file.set_len(u64::from(count) * 4).unwrap();
        let mut paged = CachedFile::new(FileView::new(Arc::new(file)), 0, u64::from(count) * 4);
        let step = PAGE_BYTES as u32 / 4 + 7;
        for index in (0..count).step_by(step as usize) {
            paged.write_u32(index, index ^ 0x5555).unwrap();
        }
        for index in (0..count).step_by(step as usize) {
            assert_eq!(paged.read_u32(index).unwrap(), index ^ 0x5555);
        }
        assert_eq!(paged.read_u32(1).unwrap(), 0);
        assert!(paged.read_u32(count).is_err() && paged.write_u32(count, 1).is_err());
    }

    #[test]
    fn a_read_may_span_two_pages() {
        let mut file = tempfile::tempfile().unwrap();
        let bytes: Vec<u8> = (0..2 * PAGE_BYTES + 9).map(|i| (i * 7 % 251) as u8).collect();
        file.write_all(&bytes).unwrap();
        let mut paged = CachedFile::new(FileView::new(Arc::new(file)), 5, bytes.len() as u64 - 5);
        let mut out = [0; 12];
        paged.read(PAGE_BYTES as u64 - 3, &mut out).unwrap();
        assert_eq!(out, bytes[PAGE_BYTES + 2..PAGE_BYTES + 14]);
        assert!(paged.read(bytes.len() as u64 - 10, &mut out).is_err());
    }
}
