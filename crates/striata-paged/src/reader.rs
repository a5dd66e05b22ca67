//! A reader without input and output: the caller asks which bytes it needs, fetches them and passes them in.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::parallel::map_in_parallel;
use crate::{
    HeadDefect, Leaf, Metadata, PREFIX_BYTES, Page, PageBound, PageEntry, PageId, PagedError, Prefix, Root,
};

/// Size of the first request: enough for the head of most files.
const FIRST_BYTES: u64 = 1 << 16;
/// Pages that are at most this many bytes apart in a file are read together.
const MAX_GAP: u64 = 1 << 14;
/// Maximum size of a request in bytes.
const MAX_WANT: u64 = 8 << 20;

/// File or object that contains bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum StoredPlace {
    /// The file, or the head of a folder or bucket.
    Head,
    /// A page that is an object of its own.
    Page(PageId),
    /// An image that is an object of its own, by index.
    Image(u32),
}

/// Bytes that are wanted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Want {
    /// File or object that contains them.
    pub place: StoredPlace,
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
    head: Option<ReadHead>,
    requested: BTreeSet<u32>,
    withheld: BTreeSet<u32>,
    pages: BTreeMap<u32, Page>,
}

#[derive(Debug)]
struct ReadHead {
    prefix: Prefix,
    metadata: Metadata,
    page_count: u32,
    entries: BTreeMap<u32, PageEntry>,
    leaves: Vec<Leaf>,
    wanted_leaves: BTreeSet<u32>,
}

impl PagedReader {
    /// Creates a reader that has not read anything yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Metadata of the mesh; `None` before the head has arrived.
    pub fn metadata(&self) -> Option<&Metadata> {
        self.head.as_ref().map(|head| &head.metadata)
    }

    /// Place of the contents of an image; `None` if the file does not have them, or before the head has arrived.
    pub fn image_want(&self, index: u32) -> Option<Want> {
        let head = self.head.as_ref()?;
        let image = head.metadata.images.get(index as usize).filter(|image| image.byte_count > 0)?;
        let (place, first) = match head.prefix.is_separate {
            true => (StoredPlace::Image(index), 0),
            false => (StoredPlace::Head, head.prefix.pages_offset.checked_add(image.offset)?),
        };
        Some(Want { place, range: first..first.checked_add(image.byte_count)? })
    }

    /// Keeps the contents of an image, which all levels have from then on.
    ///
    /// # Errors
    /// [`PagedError::ImageChecksum`] if they are not those that the file was built with.
    pub fn supply_image(&mut self, index: u32, bytes: Vec<u8>) -> Result<(), PagedError> {
        let image = self.head.as_mut().and_then(|head| head.metadata.images.get_mut(index as usize));
        match image {
            Some(image) if bytes.len() as u64 == image.byte_count && crc32fast::hash(&bytes) == image.crc => {
                image.bytes = bytes;
                Ok(())
            }
            _ => Err(PagedError::ImageChecksum { index }),
        }
    }

    /// Gives away the contents of an image; empty if they have not been supplied.
    pub fn take_image(&mut self, index: u32) -> Vec<u8> {
        let images = self.head.as_mut().map(|head| &mut head.metadata.images);
        let image = images.and_then(|images| images.get_mut(index as usize));
        image.map(|image| std::mem::take(&mut image.bytes)).unwrap_or_default()
    }

    /// Number of pages; 0 before the head has arrived.
    pub fn page_count(&self) -> u32 {
        self.head.as_ref().map_or(0, |head| head.page_count)
    }

    /// Entry of a page in the directory; `None` if its part of the directory has not been read.
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

    /// Drops a page from memory.
    pub fn evict(&mut self, page: u32) {
        self.pages.remove(&page);
        self.requested.remove(&page);
    }

    /// Forgets the requests of pages that have not arrived.
    pub fn cancel_requests(&mut self) {
        self.requested.retain(|page| self.pages.contains_key(page));
    }

    /// Withholds a damaged page: neither it nor a page that refines it is selected any more, so that levels stay coarse
    /// there. Returns false if no level can do without the page, or if it is withheld already.
    pub fn withhold(&mut self, id: PageId) -> bool {
        let found = self.entries().find(|&(index, entry)| index > 0 && entry.id == id);
        let Some((index, _)) = found else { return false };
        self.evict(index);
        self.withheld.insert(index)
    }

    /// Requests pages; those that have been read already are not read again.
    pub fn request(&mut self, pages: impl IntoIterator<Item = u32>) {
        let count = self.page_count();
        self.requested.extend(pages.into_iter().filter(|&page| page < count));
    }

    /// Finds the pages with at least one part that needs detail, and all of their ancestors: a set that can be
    /// assembled.
    /// The set always contains the base page.
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

    /// Adds all ancestors of pages, and the base page; leaves out withheld pages and those that refine them.
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
        if !head.wanted_leaves.is_empty() {
            return None;
        }
        let mut left_out = self.withheld.clone();
        // Until none is left that refines one of them; usually parents come first.
        while !left_out.is_empty() {
            let before = selected.len();
            let refines =
                |page: &u32| head.entries[page].parents.iter().any(|parent| left_out.contains(parent));
            let more: Vec<u32> = selected.iter().copied().filter(refines).collect();
            left_out.extend(more);
            selected.retain(|page| !left_out.contains(page));
            if selected.len() == before {
                break;
            }
        }
        Some(selected.into_iter().collect())
    }

    /// Requests the parts of the directory that have pages with keys of at least `key`, and returns whether all of
    /// them have been read. If it returns false, fetch what is wanted and call it again.
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

    /// Largest errors in parts of the directory that have not been read, in mesh units.
    pub(crate) fn unread_errors(&self) -> impl Iterator<Item = f32> {
        let unread = |head: &ReadHead, leaf: &Leaf| !head.entries.contains_key(&leaf.first_page);
        self.head.iter().flat_map(move |head| {
            head.leaves.iter().filter(move |leaf| unread(head, leaf)).map(|leaf| leaf.bound.error)
        })
    }

    /// The bytes that are wanted now. Pages that are close to each other are wanted together.
    pub fn wants(&self) -> Vec<Want> {
        let have = self.head_bytes.len() as u64;
        let Some(head) = &self.head else {
            let need = Prefix::parse(&self.head_bytes)
                .map_or(FIRST_BYTES, |prefix| PREFIX_BYTES + prefix.metadata_bytes + prefix.root_bytes);
            return vec![Want { place: StoredPlace::Head, range: have..need.max(have + 1) }];
        };
        let leaves_at = head.leaves_offset();
        let mut wants: Vec<Want> = Vec::new();
        for &index in &head.wanted_leaves {
            let leaf = &head.leaves[index as usize];
            let first = leaves_at + leaf.offset;
            wants.push(Want { place: StoredPlace::Head, range: first..first + leaf.byte_count });
        }
        for &index in self.requested.iter().filter(|index| !self.pages.contains_key(index)) {
            let Some(entry) = head.entries.get(&index) else { continue };
            let size = u64::from(entry.byte_count);
            if head.prefix.is_separate {
                wants.push(Want { place: StoredPlace::Page(entry.id), range: 0..size });
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
                _ => wants.push(Want { place: StoredPlace::Head, range: first..first + size }),
            }
        }
        wants
    }

    /// Takes bytes that were wanted.
    ///
    /// # Errors
    /// [`PagedError`] if they are damaged, or fewer than wanted.
    pub fn supply(&mut self, want: &Want, bytes: &[u8]) -> Result<(), PagedError> {
        self.supply_all(&[(want, bytes)])
    }

    /// Takes bytes of several wants; pages are decoded in parallel (feature `parallel`).
    ///
    /// # Errors
    /// See [`Self::supply`]. Pages that arrived undamaged are kept.
    pub fn supply_all(&mut self, arrived: &[(&Want, &[u8])]) -> Result<(), PagedError> {
        let Some(head) = &mut self.head else {
            return arrived.iter().try_for_each(|(want, bytes)| self.supply_head(want, bytes));
        };
        for (want, bytes) in arrived.iter().filter(|(want, _)| want.place == StoredPlace::Head) {
            head.supply_leaves(want, bytes)?;
        }
        let head = &*head;
        let pages = self.requested.iter().filter(|index| !self.pages.contains_key(index));
        let found: Vec<(u32, &PageEntry, &[u8])> = head.find_pages(pages.copied(), arrived);
        let decoded = map_in_parallel(&found, |&(index, entry, bytes)| (index, head.decode(entry, bytes)));
        let mut result = Ok(());
        for (index, page) in decoded {
            match page {
                Ok(page) => drop(self.pages.insert(index, page)),
                Err(error) => result = result.and(Err(error)),
            }
        }
        result
    }

    fn supply_head(&mut self, want: &Want, bytes: &[u8]) -> Result<(), PagedError> {
        let have = self.head_bytes.len() as u64;
        if want.place != StoredPlace::Head || want.range.start != have || bytes.is_empty() {
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
        self.head = Some(ReadHead { prefix, metadata, page_count, entries, leaves, wanted_leaves });
        self.head_bytes = Vec::new();
        Ok(())
    }
}

impl ReadHead {
    /// First byte of the directory's leaves.
    fn leaves_offset(&self) -> u64 {
        PREFIX_BYTES + self.prefix.metadata_bytes + self.prefix.root_bytes
    }

    /// Takes the parts of the directory that are in some bytes.
    fn supply_leaves(&mut self, want: &Want, bytes: &[u8]) -> Result<(), PagedError> {
        for index in self.wanted_leaves.clone() {
            let leaf = &self.leaves[index as usize];
            let first = self.leaves_offset() + leaf.offset;
            if let Some(bytes) = within(want, bytes, &(first..first + leaf.byte_count)) {
                let entries = leaf.parse(bytes, &self.metadata)?;
                self.entries.extend((leaf.first_page..).zip(entries));
                self.wanted_leaves.remove(&index);
            }
        }
        Ok(())
    }

    /// Finds the bytes of pages among those that have arrived.
    fn find_pages<'a>(
        &'a self,
        pages: impl Iterator<Item = u32>,
        arrived: &[(&Want, &'a [u8])],
    ) -> Vec<(u32, &'a PageEntry, &'a [u8])> {
        let mut by_place: Vec<&(&Want, &'a [u8])> = arrived.iter().collect();
        by_place.sort_by_key(|(want, _)| (want.place, want.range.start));
        let bytes_of = |entry: &PageEntry| {
            let (place, first) = match self.prefix.is_separate {
                true => (StoredPlace::Page(entry.id), 0),
                false => (StoredPlace::Head, self.prefix.pages_offset + entry.offset),
            };
            let after =
                by_place.partition_point(|(want, _)| (want.place, want.range.start) <= (place, first));
            let (want, bytes) = by_place[..after].last().filter(|(want, _)| want.place == place)?;
            let range = first..first + u64::from(entry.byte_count);
            // Fewer bytes than wanted do not match the checksum.
            (want.range.end >= range.end).then(|| within(want, bytes, &range).unwrap_or_default())
        };
        let found = pages.filter_map(|index| {
            let entry = self.entries.get(&index)?;
            Some((index, entry, bytes_of(entry)?))
        });
        found.collect()
    }

    fn decode(&self, entry: &PageEntry, bytes: &[u8]) -> Result<Page, PagedError> {
        if bytes.len() as u64 != u64::from(entry.byte_count) || crc32fast::hash(bytes) != entry.crc {
            return Err(PagedError::Checksum { id: entry.id });
        }
        let page = Page::from_bytes(entry.id, bytes, &self.metadata)?;
        if page.imports.iter().any(|import| !entry.parents.contains(&import.page)) {
            let reason = "it imports from a page that is not its parent";
            return Err(PagedError::Mismatch { id: entry.id, reason });
        }
        Ok(page)
    }
}

/// The bytes of a range among those of a want.
fn within<'a>(want: &Want, bytes: &'a [u8], range: &Range<u64>) -> Option<&'a [u8]> {
    let from = usize::try_from(range.start.checked_sub(want.range.start)?).ok()?;
    bytes.get(from..from.checked_add(usize::try_from(range.end - range.start).ok()?)?)
}
