//! A paged file that is read as needed.

use std::collections::BTreeSet;

use striata::simplify::Target;

use crate::{
    Assembled, CutPages, Metadata, Page, PageBound, PageId, PagedError, PagedReader, Store, Want, assemble,
    open_store,
};

/// Default limit of the vertices of all pages in memory, about 600 MB; beyond it, pages of earlier levels are dropped.
const MAX_CACHED_VERTICES: u64 = 10_000_000;
/// Maximum number of bytes in memory before their pages are decoded, unless a single request is larger.
const MAX_BATCH_BYTES: u64 = 32 << 20;

/// Numbers of requests, bytes and pages that have been read so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ReadStatistics {
    /// Number of requests.
    pub request_count: u64,
    /// Number of bytes.
    pub byte_count: u64,
    /// Number of pages.
    pub page_count: u64,
}

/// Pages and steps from which the last level of a paged file was made.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ShownPages {
    /// Number of pages whose vertices are in the level.
    pub page_count: usize,
    /// Number of steps in the pages that were read for it.
    pub step_count: usize,
}

/// Levels that have been prepared, and facts about the last one.
#[derive(Clone, Debug, Default)]
pub(crate) struct LevelState {
    /// The pages, if any are prepared.
    pub prepared: Option<Assembled>,
    /// The targets for which it was prepared.
    pub targets: Vec<Target>,
    /// Pages and steps of the last level.
    pub shown: ShownPages,
}

/// A paged file, folder or address; only the pages that a level needs are read.
///
/// ```no_run
/// use striata_paged::PagedFile;
///
/// let mut file = PagedFile::open("city.striata")?;
/// let level = file.level_for_triangles(50_000)?;
/// println!("{} triangles", level.refinable.mesh.triangle_count());
/// # Ok::<(), striata_paged::PagedError>(())
/// ```
pub struct PagedFile {
    store: Box<dyn Store>,
    reader: PagedReader,
    statistics: ReadStatistics,
    max_vertices: u64,
    pub(crate) levels: LevelState,
}

impl PagedFile {
    /// Opens a file, a folder, or an address.
    ///
    /// # Errors
    /// [`PagedError`] if the head cannot be read.
    pub fn open(address: &str) -> Result<Self, PagedError> {
        Self::with_store(open_store(address)?)
    }

    /// Reads from any store.
    ///
    /// # Errors
    /// [`PagedError`] if the head cannot be read.
    pub fn with_store(store: Box<dyn Store>) -> Result<Self, PagedError> {
        let (reader, statistics) = (PagedReader::new(), ReadStatistics::default());
        let (max_vertices, levels) = (MAX_CACHED_VERTICES, LevelState::default());
        let mut file = Self { store, reader, statistics, max_vertices, levels };
        while file.reader.metadata().is_none() {
            file.fetch()?;
        }
        Ok(file)
    }

    /// Sets the number of vertices above which pages of earlier levels are dropped from memory; default 10 million.
    /// A vertex takes about 60 bytes.
    #[must_use]
    pub fn with_max_vertices(self, max_vertices: u64) -> Self {
        Self { max_vertices, ..self }
    }

    /// Name of the file or address.
    pub fn name(&self) -> &str {
        self.store.name()
    }

    /// The reader, with the directory and the pages read so far.
    pub fn reader(&self) -> &PagedReader {
        &self.reader
    }

    /// Metadata of the mesh.
    ///
    /// # Panics
    /// Never: an open file has metadata.
    pub fn metadata(&self) -> &Metadata {
        self.reader.metadata().expect("the head has been read")
    }

    /// Numbers of requests, bytes and pages that have been read so far.
    pub fn statistics(&self) -> ReadStatistics {
        self.statistics
    }

    /// Withholds a damaged page, as [`PagedReader::withhold`] does; levels can then be read without it.
    pub fn withhold(&mut self, id: PageId) -> bool {
        self.reader.withhold(id)
    }

    /// Reads the contents of all images, which every mesh of this file has from then on.
    ///
    /// # Errors
    /// [`PagedError`] if an image cannot be read or is damaged.
    pub fn load_images(&mut self) -> Result<(), PagedError> {
        for index in 0..self.metadata().images.len() as u32 {
            self.load_image(index)?;
        }
        Ok(())
    }

    /// Reads the contents of an image, unless that has been done or the file does not have them.
    ///
    /// # Errors
    /// [`PagedError`] if the image cannot be read or is damaged.
    pub fn load_image(&mut self, index: u32) -> Result<(), PagedError> {
        let is_loaded =
            self.metadata().images.get(index as usize).is_some_and(|image| !image.bytes.is_empty());
        let Some(want) = self.reader.image_want(index).filter(|_| !is_loaded) else { return Ok(()) };
        let bytes = self.store.read(want.place, want.range)?;
        self.statistics.request_count += 1;
        self.statistics.byte_count += bytes.len() as u64;
        self.reader.supply_image(index, bytes)
    }

    /// Gives away the contents of an image, which must be read again before meshes have them.
    pub fn take_image(&mut self, index: u32) -> Vec<u8> {
        self.reader.take_image(index)
    }

    /// Fetches everything that the reader wants now.
    fn fetch(&mut self) -> Result<(), PagedError> {
        let wants = self.reader.wants();
        let mut rest = wants.as_slice();
        while !rest.is_empty() {
            let mut byte_count = 0;
            let is_within = |want: &&Want| {
                byte_count += want.range.end - want.range.start;
                byte_count <= MAX_BATCH_BYTES
            };
            let count = rest.iter().take_while(is_within).count().max(1);
            let (batch, others) = rest.split_at(count);
            let arrived = self.store.read_all(batch)?;
            self.statistics.request_count += batch.len() as u64;
            self.statistics.byte_count += arrived.iter().map(|bytes| bytes.len() as u64).sum::<u64>();
            let before = self.reader.pages().count();
            let arrived: Vec<(&Want, &[u8])> = batch.iter().zip(arrived.iter().map(Vec::as_slice)).collect();
            self.reader.supply_all(&arrived)?;
            self.statistics.page_count += (self.reader.pages().count() - before) as u64;
            rest = others;
        }
        Ok(())
    }

    /// Finds the pages of which some part needs detail, with their ancestors.
    ///
    /// # Errors
    /// [`PagedError`] if the directory cannot be read.
    pub fn select(&mut self, mut needs: impl FnMut(&PageBound) -> bool) -> Result<Vec<u32>, PagedError> {
        loop {
            if let Some(pages) = self.reader.select(&mut needs) {
                return Ok(pages);
            }
            self.fetch()?;
        }
    }

    /// Reads pages, which must contain all of their ancestors, and makes one mesh with levels of them.
    ///
    /// # Errors
    /// [`PagedError`] if a page cannot be read or does not match the others.
    pub fn assemble(&mut self, pages: &[u32]) -> Result<Assembled, PagedError> {
        self.load(pages)?;
        assemble(&self.loaded(pages), self.metadata())
    }

    /// Reads pages, which must contain all of their ancestors, to cut levels of varying detail from them.
    ///
    /// # Errors
    /// [`PagedError`] if a page cannot be read or does not match the others.
    pub fn cut_pages(&mut self, pages: &[u32]) -> Result<CutPages<'_>, PagedError> {
        self.load(pages)?;
        CutPages::new(&self.loaded(pages), self.metadata())
    }

    /// Reads pages, unless they have been read.
    pub(crate) fn load(&mut self, pages: &[u32]) -> Result<(), PagedError> {
        self.make_room(pages);
        // Another level may have been given up because its bytes were missing.
        self.reader.cancel_requests();
        self.reader.request(pages.iter().copied());
        self.fetch()
    }

    /// Drops pages of earlier levels if memory would otherwise exceed the limit.
    fn make_room(&mut self, pages: &[u32]) {
        let vertices = |page: u32| self.reader.entry(page).map_or(0, |entry| u64::from(entry.vertex_count));
        let known: Vec<u32> = self.reader.pages().map(|(index, _)| index).collect();
        let needed: BTreeSet<u32> = pages.iter().copied().collect();
        let others: Vec<u32> = known.into_iter().filter(|page| !needed.contains(page)).collect();
        let total: u64 = others.iter().chain(&needed).map(|&page| vertices(page)).sum();
        if total > self.max_vertices {
            others.into_iter().for_each(|page| self.reader.evict(page));
        }
    }

    /// The pages among `pages` that have been read.
    pub(crate) fn loaded(&self, pages: &[u32]) -> Vec<(u32, &Page)> {
        pages.iter().filter_map(|&index| Some((index, self.reader.page(index)?))).collect()
    }

    /// The mesh with all levels whose error exceeds `error`, in mesh units.
    ///
    /// # Errors
    /// See [`Self::assemble`].
    pub fn level_for_error(&mut self, error: f32) -> Result<Assembled, PagedError> {
        let pages = self.select(|bound| bound.error > error)?;
        self.assemble(&pages)
    }

    /// The mesh with all levels of up to `triangle_count` triangles.
    ///
    /// Its sequence is that of the whole file down to the returned level: steps beyond it have been dropped only
    /// if they are less important than every step of the pages that were not read.
    ///
    /// # Errors
    /// See [`Self::assemble`].
    pub fn level_for_triangles(&mut self, triangle_count: usize) -> Result<Assembled, PagedError> {
        let mut wanted = triangle_count as u64;
        // Coarse pages come first in the directory, so its beginning is enough for coarse levels.
        let mut key = f32::INFINITY;
        loop {
            while !self.reader.request_directory(key) {
                self.fetch()?;
            }
            let unknown = self.reader.unknown_key();
            let by_key = self.pages_by_key();
            let known = by_key.partition_point(|page| unknown.is_none_or(|unknown| page.0 > unknown));
            let mut sum = 0;
            let enough = by_key[..known].iter().position(|&(_, _, added)| {
                sum += u64::from(added);
                sum >= wanted
            });
            if enough.is_none()
                && let Some(unknown) = unknown
            {
                key = unknown;
                continue;
            }
            let count = enough.map_or(by_key.len(), |last| last + 1);
            let limit = by_key.get(count).map_or(0.0, |next| next.0).max(unknown.unwrap_or(0.0));
            let pages = self.with_ancestors(&by_key[..count])?;
            let level = self.assemble(&pages)?;
            let complete = level.split_count_for_key(limit.next_up());
            let is_enough = level.refinable.sequence.triangle_count_at(complete) >= triangle_count;
            if is_enough || (count == by_key.len() && unknown.is_none()) {
                return Ok(level);
            }
            wanted = wanted.max(sum) * 3 / 2 + 1;
        }
    }

    /// The mesh with all levels that some targets select. Each target is resolved in the sequence of that mesh.
    ///
    /// # Errors
    /// See [`Self::assemble`].
    pub fn levels_for(&mut self, targets: &[Target]) -> Result<Assembled, PagedError> {
        let (mut triangles, mut error) = (None, None::<f64>);
        for &target in targets {
            let needed = match target {
                Target::Error(distance) => {
                    error = Some(error.map_or(distance, |least| least.min(distance)));
                    continue;
                }
                Target::Triangles(count) => count,
                // A surface has about two triangles per vertex, a soup fewer.
                Target::Vertices(count) => count.saturating_mul(3),
                // Steps are counted from the base, so all must be known.
                _ => usize::MAX,
            };
            triangles = triangles.max(Some(needed));
        }
        match (triangles, error) {
            (Some(count), None) => self.level_for_triangles(count),
            (None, Some(error)) => self.level_for_error(error as f32),
            _ => self.level_for_triangles(usize::MAX),
        }
    }

    /// Largest error of the steps in pages that have not been read, in mesh units: no level made of the others has a
    /// smaller one.
    pub fn unread_error(&self) -> f32 {
        let unread = self.reader.entries().filter(|&(index, _)| self.reader.page(index).is_none());
        unread.map(|(_, entry)| entry.error).chain(self.reader.unread_errors()).fold(0.0, f32::max)
    }

    /// Key, index and number of triangles of all known pages, by key.
    fn pages_by_key(&self) -> Vec<(f32, u32, u32)> {
        let entries = self.reader.entries().map(|(index, entry)| {
            (if index == 0 { f32::INFINITY } else { entry.key }, index, entry.added_triangle_count)
        });
        let mut by_key: Vec<(f32, u32, u32)> = entries.collect();
        by_key.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        by_key
    }

    /// Pages with their ancestors, which have larger keys.
    fn with_ancestors(&mut self, pages: &[(f32, u32, u32)]) -> Result<Vec<u32>, PagedError> {
        self.closed(&pages.iter().map(|&(_, index, _)| index).collect::<Vec<u32>>())
    }

    /// Pages with all of their ancestors.
    pub(crate) fn closed(&mut self, pages: &[u32]) -> Result<Vec<u32>, PagedError> {
        loop {
            if let Some(pages) = self.reader.close(pages.iter().copied()) {
                return Ok(pages);
            }
            self.fetch()?;
        }
    }
}
