//! Tiers: rounded errors of steps that never fall from a step to those that it needs.
//!
//! A step can only be refined together with the vertices around it, so a level that refines all steps of some error
//! also refines others, of smaller errors, far away from the first. The *tier* of a step is the largest error among the
//! step and all that need it, rounded to an eighth of an octave. So the steps from some tier up are complete as they
//! are, and whether a step belongs to a level follows from its tier and its place alone: any region of a level can be
//! made without the rest.
//!
//! ```text
//!  finest pages            coarser pages            base page
//!  error of each step ---> largest of own and ---> ...
//!       |  "these vertices need at least my tier"
//! ```
//!
//! Let a step be undone in one of two levels only, and let a region be outside of the bounding box of the triangles
//! around it. Then both levels have the same triangles in that region, because the triangles after the step are in the
//! same box. `cut` visits fine steps first, so this holds for all steps together.
//!
//! Cost: one pass over all pages, a byte per position, and memory for the ancestors of a few pages.

use striata::mesh::Bounds;

use crate::cut::PageSurface;
use crate::loaded::LoadedPages;
use crate::parallel::map_in_parallel;
use crate::{PagedCut, PagedError, PagedFile};

/// Bits of a float below those that make a tier: 3 bits of the fraction are left.
const DROPPED_BITS: u32 = 20;
/// Largest tier, that of the largest error.
const LARGEST: u8 = u8::MAX;
/// Pages whose tiers are found together.
const BATCH: usize = 16;

/// The tier of every step of a paged file.
#[derive(Clone, Debug)]
pub struct StepTiers {
    /// Upper bits of an error of tier 0; negative if there is none.
    first: i64,
    /// By index of the page.
    pages: Vec<PageTiers>,
    /// Number of steps of each tier.
    counts: Vec<u64>,
    /// For each axis, whether a triangle faces against it, and whether one faces along it.
    facings: [[bool; 2]; 3],
}

#[derive(Clone, Debug, Default)]
struct PageTiers {
    /// By owned position.
    tiers: Vec<u8>,
    largest: u8,
    /// Bounds of all triangles of the page, at any level.
    bounds: Option<Bounds>,
}

/// Tiers that a page adds to its own and to those of coarser pages.
struct FoundTiers {
    own: PageTiers,
    /// Page, position and tier of what it needs.
    needed: Vec<(u32, u32, u8)>,
    facings: [[bool; 2]; 3],
}

impl StepTiers {
    /// Number of tiers by which errors differ that differ by a factor of 16.
    pub const PER_SIXTEENTH: u16 = 32;
    /// A tier that no step has: a level without any step.
    pub const NONE: u16 = LARGEST as u16 + 1;

    /// Number of steps of at least this tier.
    pub fn step_count_from(&self, tier: u16) -> u64 {
        self.counts[(tier as usize).min(self.counts.len())..].iter().sum()
    }

    /// The error of a level that refines all steps of at least this tier, in mesh units.
    pub fn error_below(&self, tier: u16) -> f32 {
        match (self.first + i64::from(tier), tier) {
            (_, ..2) => 0.0,
            (bits, _) => f32::from_bits((bits.clamp(0, 0x7f7) as u32) << DROPPED_BITS),
        }
    }

    /// Whether no triangle turns over, seen along an axis.
    pub fn is_height_field(&self, axis: usize) -> bool {
        self.facings[axis][0] != self.facings[axis][1]
    }

    /// Tier 0 only has steps without any error.
    fn tier_of(&self, error: f32) -> u8 {
        let bits = i64::from(error.to_bits() >> DROPPED_BITS) - self.first;
        if error > 0.0 { bits.clamp(1, i64::from(LARGEST)) as u8 } else { 0 }
    }

    fn find(&self, loaded: &LoadedPages<'_>, slot: u32) -> FoundTiers {
        let page = loaded.page(slot);
        let mut surface = PageSurface::new(loaded, slot);
        let facings = surface.facings();
        let mut tiers = self.pages[loaded.index_of(slot) as usize].tiers.clone();
        let owned = tiers.len();
        tiers.resize(surface.node_count(), 0);
        for position in surface.order() {
            let tier = tiers[position as usize].max(self.tier_of(page.errors[position as usize]));
            tiers[position as usize] = tier;
            surface.gather(position);
            surface.for_each_needed(position, |v| {
                let needed = &mut tiers[surface.node(v) as usize];
                *needed = tier.max(*needed);
            });
            surface.collapse();
        }
        let mut needed = Vec::new();
        for (import, place) in (page.positions.len() as u32..).zip(loaded.imports_of(slot)) {
            let tier = tiers[surface.node(import) as usize];
            if tier > 0 {
                let position = loaded.page(place.slot).position_of(place.vertex);
                needed.push((loaded.index_of(place.slot), position, tier));
            }
        }
        tiers.truncate(owned);
        let largest = tiers.iter().copied().max().unwrap_or(0);
        FoundTiers { own: PageTiers { tiers, largest, bounds: surface.bounds() }, needed, facings }
    }
}

impl PagedFile {
    /// Finds the tier of every step, in one pass over all pages.
    ///
    /// # Errors
    /// Any error of reading a page, and those of `report`, which is called with the number of pages done and of all.
    pub fn tiers<E: From<PagedError>>(
        &mut self,
        mut report: impl FnMut(u64, u64) -> Result<(), E>,
    ) -> Result<StepTiers, E> {
        let all = self.select(|_| true)?;
        let largest = self.reader().entries().map(|(_, entry)| entry.error).fold(0.0, f32::max);
        let first = i64::from(largest.to_bits() >> DROPPED_BITS) - i64::from(LARGEST);
        let entries = self.reader().entries();
        let page = |count: u32| PageTiers { tiers: vec![0; count as usize], ..PageTiers::default() };
        let pages = entries.map(|(_, entry)| page(entry.position_count)).collect();
        let mut tiers =
            StepTiers { first, pages, counts: vec![0; LARGEST as usize + 1], facings: Default::default() };
        let level_of = |file: &Self, page: u32| file.reader().entry(page).map(|entry| entry.id.level);
        let levels: Vec<Vec<u32>> =
            all.chunk_by(|&a, &b| level_of(self, a) == level_of(self, b)).map(<[u32]>::to_vec).collect();
        let mut done = 0;
        for level in levels.iter().rev() {
            for batch in level.chunks(BATCH) {
                let found = self.with_loaded(batch, |loaded| {
                    let slots: Vec<u32> = (0..loaded.len() as u32)
                        .filter(|&slot| batch.binary_search(&loaded.index_of(slot)).is_ok())
                        .collect();
                    map_in_parallel(&slots, |&slot| (loaded.index_of(slot), tiers.find(loaded, slot)))
                })?;
                for (index, FoundTiers { own, needed, facings }) in found {
                    for (known, facing) in
                        tiers.facings.as_flattened_mut().iter_mut().zip(facings.as_flattened())
                    {
                        *known |= facing;
                    }
                    if index > 0 {
                        own.tiers.iter().for_each(|&tier| tiers.counts[tier as usize] += 1);
                    }
                    tiers.pages[index as usize] = own;
                    for (page, position, tier) in needed {
                        let known = &mut tiers.pages[page as usize].tiers[position as usize];
                        *known = tier.max(*known);
                    }
                }
                done += batch.len() as u64;
                report(done, all.len() as u64)?;
            }
        }
        Ok(tiers)
    }

    /// Runs a function on pages and all of their ancestors.
    fn with_loaded<R>(
        &mut self,
        pages: &[u32],
        run: impl FnOnce(&LoadedPages<'_>) -> R,
    ) -> Result<R, PagedError> {
        let pages = self.closed(pages)?;
        self.load(&pages)?;
        Ok(run(&LoadedPages::new(&self.loaded(&pages))?))
    }

    /// Makes the coarsest level that refines every step for which `is_wanted` is true, given the tier of the step and
    /// the bounds of the triangles around it. Reads only the pages that this needs: `is_wanted` must also be true for
    /// larger tiers and larger bounds.
    ///
    /// # Errors
    /// [`PagedError`] if a page cannot be read or does not match the others.
    pub fn cut_tiers(
        &mut self,
        tiers: &StepTiers,
        is_wanted: impl Fn(u8, &Bounds) -> bool + Sync,
    ) -> Result<PagedCut, PagedError> {
        let needs = |page: &&PageTiers| page.bounds.is_some_and(|bounds| is_wanted(page.largest, &bounds));
        let pages = (0..).zip(&tiers.pages).filter(|(_, page)| needs(page)).map(|(index, _)| index);
        let pages = self.closed(&pages.collect::<Vec<u32>>())?;
        let cut = self.cut_pages(&pages)?.cut_steps(&|surface: &PageSurface<'_>, page, position| {
            let tier = tiers.pages[page as usize].tiers[position as usize];
            is_wanted(tier, &surface.bounds_around(position))
        });
        Ok(cut)
    }
}
