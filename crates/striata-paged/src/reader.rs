//! A reader without input and output: it says which bytes it wants, and takes them.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::{
    HeadDefect, Leaf, Metadata, PREFIX_BYTES, Page, PageBound, PageEntry, PageId, PagedError, Prefix, Root,
};

/// Bytes that are wanted first: enough for the head of most files.
const FIRST_BYTES: u64 = 1 << 16;
/// Pages closer than this in a file are read at once, in bytes.
const MAX_GAP: u64 = 1 << 14;
/// At most so many bytes are wanted at once.
const MAX_WANT: u64 = 8 << 20;

/// Where bytes are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    /// The file, or the head of a folder or bucket.
    Head,
    /// A page that is an object of its own.
    Page(PageId),
}

/// Bytes that are wanted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Want {
    /// Where they are.
    pub place: Place,
    /// Which bytes; the first want may reach beyond the end of a small file.
    pub range: Range<u64>,
}

/// Reads a paged file from bytes that the caller fetches, in any order.
///
/// Call [`wants`](Self::wants), fetch the ranges, pass them to [`supply`](Self::supply), and repeat until nothing
/// is wanted.
#[derive(Debug, Default)]
pub struct PagedReader {
    head_bytes: Vec<u8>,
    head: Option<Head>,
    requested: BTreeSet<u32>,
    pages: BTreeMap<u32, Page>,
}

#[derive(Debug)]
struct Head {
    prefix: Prefix,
    metadata: Metadata,
    page_count: u32,
    entries: BTreeMap<u32, PageEntry>,
    leaves: Vec<Leaf>,
    wanted_leaves: BTreeSet<u32>,
}

impl PagedReader {
    /// Creates a reader that knows nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// What the file says about the mesh; `None` before the head has arrived.
    pub fn metadata(&self) -> Option<&Metadata> {
        self.head.as_ref().map(|head| &head.metadata)
    }

    /// Number of pages; 0 before the head has arrived.
    pub fn page_count(&self) -> u32 {
        self.head.as_ref().map_or(0, |head| head.page_count)
    }

    /// What the directory says about a page; `None` if its part of the directory has not been read.
    pub fn entry(&self, page: u32) -> Option<&PageEntry> {
        self.head.as_ref()?.entries.get(&page)
    }

    /// A page, if it has been read.
    pub fn page(&self, page: u32) -> Option<&Page> {
        self.pages.get(&page)
    }

    /// All pages that have been read, by index.
    pub fn pages(&self) -> impl Iterator<Item = (u32, &Page)> {
        self.pages.iter().map(|(&index, page)| (index, page))
    }

    /// Forgets a page.
    pub fn evict(&mut self, page: u32) {
        self.pages.remove(&page);
        self.requested.remove(&page);
    }

    /// Requests pages; those that have been read already are not read again.
    pub fn request(&mut self, pages: impl IntoIterator<Item = u32>) {
        let count = self.page_count();
        self.requested.extend(pages.into_iter().filter(|&page| page < count));
    }

    /// Finds the pages of which some part needs detail, and all of their ancestors: a set that can be assembled.
    /// The base page always belongs to it.
    ///
    /// Returns `None` if more of the directory must be read first: fetch what is wanted, and call it again.
    pub fn select(&mut self, mut needs: impl FnMut(&PageBound) -> bool) -> Option<Vec<u32>> {
        let head = self.head.as_mut()?;
        let missing = head.leaves.iter().zip(0..).filter(|(leaf, _)| {
            !head.entries.contains_key(&leaf.first_page) && (leaf.first_page == 0 || needs(&leaf.bound))
        });
        head.wanted_leaves.extend(missing.map(|(_, index)| index));
        if !head.wanted_leaves.is_empty() {
            return None;
        }
        let is_needed = |entry: &PageEntry| entry.bounds.iter().any(&mut needs);
        let mut open: Vec<u32> = Vec::new();
        let mut needs_page = is_needed;
        open.extend(head.entries.iter().filter(|(_, entry)| needs_page(entry)).map(|(&index, _)| index));
        self.close(open)
    }

    /// Adds all ancestors of pages, and the base page.
    ///
    /// Returns `None` if more of the directory must be read first: fetch what is wanted, and call it again.
    pub fn close(&mut self, pages: impl IntoIterator<Item = u32>) -> Option<Vec<u32>> {
        let head = self.head.as_mut()?;
        let mut open: Vec<u32> = pages.into_iter().chain([0]).collect();
        let mut selected = BTreeSet::new();
        while let Some(index) = open.pop() {
            if !selected.insert(index) {
                continue;
            }
            match head.entries.get(&index) {
                Some(entry) => open.extend(&entry.parents),
                None => {
                    let leaf = head.leaves.partition_point(|leaf| leaf.first_page <= index).saturating_sub(1);
                    head.wanted_leaves.insert(leaf as u32);
                }
            }
        }
        head.wanted_leaves.is_empty().then(|| selected.into_iter().collect())
    }

    /// Asks for the parts of the directory that have pages with keys of at least `key`; returns whether all of
    /// them have been read. Otherwise, fetch what is wanted, and call it again.
    pub fn request_directory(&mut self, key: f32) -> bool {
        let Some(head) = &mut self.head else { return false };
        let is_missing = |leaf: &Leaf| !head.entries.contains_key(&leaf.first_page);
        let leaves = head.leaves.iter().zip(0..);
        let missing =
            leaves.filter(|(leaf, _)| is_missing(leaf) && (leaf.first_page == 0 || leaf.key >= key));
        head.wanted_leaves.extend(missing.map(|(_, index)| index));
        head.wanted_leaves.is_empty()
    }

    /// The largest key in parts of the directory that have not been read.
    pub fn unknown_key(&self) -> Option<f32> {
        let head = self.head.as_ref()?;
        let unknown = head.leaves.iter().filter(|leaf| !head.entries.contains_key(&leaf.first_page));
        unknown.map(|leaf| leaf.key).reduce(f32::max)
    }

    /// Entries of the directory that have been read, by index.
    pub fn entries(&self) -> impl Iterator<Item = (u32, &PageEntry)> {
        self.head.iter().flat_map(|head| &head.entries).map(|(&index, entry)| (index, entry))
    }

    /// The bytes that are wanted now. Pages that are close to each other are wanted together.
    pub fn wants(&self) -> Vec<Want> {
        let have = self.head_bytes.len() as u64;
        let Some(head) = &self.head else {
            let need = Prefix::parse(&self.head_bytes)
                .map_or(FIRST_BYTES, |prefix| PREFIX_BYTES + prefix.metadata_bytes + prefix.root_bytes);
            return vec![Want { place: Place::Head, range: have..need.max(have + 1) }];
        };
        let leaves_at = PREFIX_BYTES + head.prefix.metadata_bytes + head.prefix.root_bytes;
        let mut wants: Vec<Want> = Vec::new();
        for &index in &head.wanted_leaves {
            let leaf = &head.leaves[index as usize];
            let first = leaves_at + leaf.offset;
            wants.push(Want { place: Place::Head, range: first..first + leaf.byte_count });
        }
        for &index in self.requested.iter().filter(|index| !self.pages.contains_key(index)) {
            let Some(entry) = head.entries.get(&index) else { continue };
            let size = u64::from(entry.byte_count);
            if head.prefix.is_separate {
                wants.push(Want { place: Place::Page(entry.id), range: 0..size });
                continue;
            }
            let first = head.prefix.pages_offset + entry.offset;
            match wants.last_mut() {
                Some(last)
                    if first >= last.range.end
                        && first - last.range.end <= MAX_GAP
                        && first + size - last.range.start <= MAX_WANT =>
                {
                    last.range.end = first + size;
                }
                _ => wants.push(Want { place: Place::Head, range: first..first + size }),
            }
        }
        wants
    }

    /// Takes bytes that were wanted.
    ///
    /// # Errors
    /// [`PagedError`] if they are damaged, or fewer than wanted.
    pub fn supply(&mut self, want: &Want, bytes: &[u8]) -> Result<(), PagedError> {
        let Some(head) = &mut self.head else { return self.supply_head(want, bytes) };
        if let Place::Page(id) = want.place {
            let found = head.entries.iter().find(|(_, entry)| entry.id == id).map(|(&index, _)| index);
            return found.map_or(Ok(()), |index| self.supply_page(index, bytes));
        }
        let within = |range: &Range<u64>| {
            let from = range.start.checked_sub(want.range.start)? as usize;
            bytes.get(from..from.checked_add((range.end - range.start) as usize)?)
        };
        let leaves_at = PREFIX_BYTES + head.prefix.metadata_bytes + head.prefix.root_bytes;
        for index in head.wanted_leaves.clone() {
            let leaf = &head.leaves[index as usize];
            let first = leaves_at + leaf.offset;
            if let Some(bytes) = within(&(first..first + leaf.byte_count)) {
                let entries = leaf.parse(bytes, &head.metadata)?;
                head.entries.extend((leaf.first_page..).zip(entries));
                head.wanted_leaves.remove(&index);
            }
        }
        let offset = head.prefix.pages_offset;
        let mut arrived = Vec::new();
        for &index in self.requested.iter().filter(|index| !self.pages.contains_key(index)) {
            let Some(entry) = head.entries.get(&index) else { continue };
            let first = offset + entry.offset;
            let range = first..first + u64::from(entry.byte_count);
            if range.start >= want.range.start && range.end <= want.range.end {
                arrived.push((index, range));
            }
        }
        for (index, range) in arrived {
            let id = self.entry(index).map_or(PageId { level: 0, cell: 0 }, |entry| entry.id);
            let bytes = within(&range).ok_or(PagedError::Checksum { id })?;
            self.supply_page(index, bytes)?;
        }
        Ok(())
    }

    fn supply_head(&mut self, want: &Want, bytes: &[u8]) -> Result<(), PagedError> {
        let have = self.head_bytes.len() as u64;
        if want.place != Place::Head || want.range.start != have || bytes.is_empty() {
            return Err(HeadDefect::Truncated.into());
        }
        self.head_bytes.extend_from_slice(bytes);
        let prefix = Prefix::parse(&self.head_bytes)?;
        let need = PREFIX_BYTES + prefix.metadata_bytes + prefix.root_bytes;
        if (self.head_bytes.len() as u64) < need {
            return Ok(());
        }
        let (metadata, root) = prefix.parse_rest(&self.head_bytes[PREFIX_BYTES as usize..need as usize])?;
        let (entries, leaves) = match root {
            Root::Entries(entries) => ((0..).zip(entries).collect::<BTreeMap<_, _>>(), Vec::new()),
            Root::Leaves(leaves) => (BTreeMap::new(), leaves),
        };
        let page_count = match leaves.last() {
            Some(last) => last.first_page + last.page_count,
            None => entries.len() as u32,
        };
        let wanted_leaves = BTreeSet::new();
        self.head = Some(Head { prefix, metadata, page_count, entries, leaves, wanted_leaves });
        self.head_bytes = Vec::new();
        Ok(())
    }

    fn supply_page(&mut self, index: u32, bytes: &[u8]) -> Result<(), PagedError> {
        let Some(head) = &self.head else { return Ok(()) };
        let Some(entry) = head.entries.get(&index) else { return Ok(()) };
        if bytes.len() as u64 != u64::from(entry.byte_count) || crc32fast::hash(bytes) != entry.crc {
            return Err(PagedError::Checksum { id: entry.id });
        }
        let page = Page::from_bytes(entry.id, bytes, &head.metadata)?;
        if page.imports.iter().any(|import| !entry.parents.contains(&import.page)) {
            let reason = "it imports from a page that is not its parent";
            return Err(PagedError::Mismatch { id: entry.id, reason });
        }
        self.pages.insert(index, page);
        Ok(())
    }
}
