//! Levels whose detail varies over the mesh, made of pages in one pass over their steps.
//!
//! Steps are undone from fine to coarse, page by page, because the steps of a page depend only on each other and on
//! coarser pages. A wanted step is kept, and so is every vertex around it, because a split needs its whole one-ring.
//! The kept steps are therefore closed under dependencies, and the result has no cracks.
//!
//! ```text
//!  finest pages          coarser pages              base page
//!  keep or undo   --->   keep or undo       --->    stays
//!        |  "these vertices must stay"     |
//!        |  "these triangles are replaced" |
//!        v                                 v
//!      triangles of the level, each from the finest page that owns one of its corners
//! ```
//!
//! Pages of one level are independent of each other and run in parallel (feature `parallel`); the result is the
//! same with any number of threads.

mod page_surface;

use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use striata::mesh::IndexedMesh;
use striata::view::Part;

use crate::loaded::{LoadedPages, coarse_vertices};
use crate::mesh_parts::{Triangles, appearance, gathered_layers, grouped};
use crate::parallel::map_in_parallel;
use crate::replaced::Replaced;
use crate::{Metadata, Page, PagedError};
pub(crate) use page_surface::PageSurface;

/// A level whose detail varies.
#[derive(Clone, Debug)]
pub struct PagedCut {
    /// The mesh.
    pub mesh: IndexedMesh,
    /// Index in the directory of the page that each vertex of the mesh comes from.
    pub page_of_vertex: Vec<u32>,
    /// Number of steps that are refined.
    pub refined_count: usize,
    /// Number of steps of the pages.
    pub step_count: usize,
    /// Largest error of a step of the pages that is not refined, in mesh units.
    pub error: f32,
}

/// Pages from which levels of varying detail are cut.
pub struct CutPages<'a> {
    loaded: LoadedPages<'a>,
    metadata: &'a Metadata,
}

/// Messages from pages to coarser ones while a level is cut.
struct Messages {
    /// For each page, the owned positions that finer pages need.
    is_needed: Vec<Vec<AtomicBool>>,
    /// For each page, the triangles that finer pages have replaced.
    replaced: Vec<Mutex<Replaced>>,
}

/// Triangles, number of refined steps and error that one page contributes to a level.
#[derive(Default)]
struct Contribution {
    /// Corners in the numbering of all pages, and group.
    triangles: Vec<([u32; 3], u32)>,
    /// Numbers of these triangles in the page.
    places: Vec<u32>,
    refined_count: usize,
    error: f32,
}

impl<'a> CutPages<'a> {
    /// Creates a cut from pages with their indices in the directory; all parents of a page must be included.
    ///
    /// # Errors
    /// [`PagedError::Mismatch`] if a parent of a page is absent or the pages do not fit together.
    pub fn new(pages: &[(u32, &'a Page)], metadata: &'a Metadata) -> Result<Self, PagedError> {
        Ok(Self { loaded: LoadedPages::new(pages)?, metadata })
    }

    /// Makes the coarsest level that refines every step for which `is_wanted` is true, and the steps that these need.
    ///
    /// A part has the position of the step, the length of the longest edge there as its radius, and the error of
    /// the surface without it.
    pub fn cut(&self, is_wanted: impl Fn(&Part) -> bool + Sync) -> PagedCut {
        self.cut_steps(&|surface, _, position| is_wanted(&surface.part(position)))
    }

    /// Makes the coarsest level that refines every step for which `is_wanted` is true, and the steps that these need. A
    /// step is the gathered position of a surface, with the index of its page.
    pub(crate) fn cut_steps(
        &self,
        is_wanted: &(impl Fn(&PageSurface<'_>, u32, u32) -> bool + Sync),
    ) -> PagedCut {
        let loaded = &self.loaded;
        let flags = |page: &Page| (1..page.first.len()).map(|_| AtomicBool::new(false)).collect();
        let messages = Messages {
            is_needed: loaded.pages().map(flags).collect(),
            replaced: (0..loaded.len()).map(|_| Mutex::default()).collect(),
        };
        let mut contributions: Vec<Contribution> = Vec::with_capacity(loaded.len());
        for level in loaded.levels() {
            let slots: Vec<u32> = level.collect();
            contributions.extend(map_in_parallel(&slots, |&slot| self.cut_page(slot, &messages, is_wanted)));
        }
        self.joined(contributions)
    }

    /// Keeps or undoes the steps of one page; all finer pages have been cut.
    fn cut_page(
        &self,
        slot: u32,
        messages: &Messages,
        is_wanted: &impl Fn(&PageSurface<'_>, u32, u32) -> bool,
    ) -> Contribution {
        let page = self.loaded.index_of(slot);
        let mut surface = PageSurface::new(&self.loaded, slot);
        let mut is_kept = vec![false; surface.node_count()];
        for (is_kept, is_needed) in is_kept.iter_mut().zip(&messages.is_needed[slot as usize]) {
            *is_kept = is_needed.load(Ordering::Relaxed);
        }
        let mut contribution = Contribution::default();
        for position in surface.order() {
            surface.gather(position);
            let is_needed = is_kept[position as usize];
            if !is_needed {
                if !is_wanted(&surface, page, position) {
                    contribution.error = contribution.error.max(surface.error_of(position));
                    surface.collapse();
                    continue;
                }
                is_kept[position as usize] = true;
            }
            contribution.refined_count += 1;
            surface.for_each_needed(position, |v| is_kept[surface.node(v) as usize] = true);
        }
        self.pass_needs_on(slot, &surface, &is_kept, messages);
        self.pass_replaced_on(slot, &surface, messages);
        (contribution.triangles, contribution.places) = self.triangles(slot, &surface, &is_kept, messages);
        contribution
    }

    /// Marks the imports that must be kept, in the pages that own them.
    fn pass_needs_on(&self, slot: u32, surface: &PageSurface<'_>, is_kept: &[bool], messages: &Messages) {
        let owned = self.loaded.page(slot).positions.len() as u32;
        for (import, place) in (owned..).zip(self.loaded.imports_of(slot)) {
            if is_kept[surface.node(import) as usize] {
                let position = self.loaded.page(place.slot).position_of(place.vertex);
                messages.is_needed[place.slot as usize][position as usize].store(true, Ordering::Relaxed);
            }
        }
    }

    /// Reports the triangles that this page replaces to the pages that own them.
    fn pass_replaced_on(&self, slot: u32, surface: &PageSurface<'_>, messages: &Messages) {
        let page = self.loaded.page(slot);
        if page.targets.is_empty() {
            return;
        }
        let is_refined =
            |t: usize| surface.is_alive[t] && surface.corners[t].iter().any(|&v| surface.owns(v));
        if !(0..page.triangles.len()).any(is_refined) {
            return;
        }
        let coarse = coarse_vertices(page);
        let mut by_owner: Vec<(u32, ([u32; 3], u32))> = Vec::new();
        for (t, corners) in surface.corners.iter().enumerate().filter(|&(t, _)| is_refined(t)) {
            let corners = corners.map(|v| if surface.owns(v) { coarse[v as usize] } else { v });
            let [a, b, c] = corners.map(|v| surface.node(v));
            if a == b || b == c || c == a {
                continue;
            }
            let imports = self.loaded.imports_of(slot);
            let owner = corners.map(|v| imports[v as usize - page.positions.len()].slot);
            let owner = owner[0].max(owner[1]).max(owner[2]);
            by_owner.push((owner, (corners.map(|v| self.loaded.number_in(slot, v)), page.tag_of(t))));
        }
        by_owner.sort_unstable_by_key(|&(owner, _)| owner);
        for run in by_owner.chunk_by(|a, b| a.0 == b.0) {
            let triangles: Vec<([u32; 3], u32)> = run.iter().map(|&(_, triangle)| triangle).collect();
            if let Ok(mut replaced) = messages.replaced[run[0].0 as usize].lock() {
                replaced.add_all(&triangles);
            }
        }
    }

    /// The triangles of the level of which this page is the finest owner, and where it has them.
    fn triangles(
        &self,
        slot: u32,
        surface: &PageSurface<'_>,
        is_kept: &[bool],
        messages: &Messages,
    ) -> (Vec<([u32; 3], u32)>, Vec<u32>) {
        let page = self.loaded.page(slot);
        let replaced = messages.replaced[slot as usize].lock();
        let mut replaced = replaced.map(|mut replaced| std::mem::take(&mut *replaced)).unwrap_or_default();
        let (mut triangles, mut places) = (Vec::new(), Vec::new());
        for (t, corners) in surface.corners.iter().enumerate() {
            if !surface.is_alive[t] || !corners.iter().any(|&v| surface.owns(v)) {
                continue;
            }
            let numbers = corners.map(|v| self.loaded.number_in(slot, v));
            // A finer page that replaces a triangle needs its corners. The base page keeps all of its own.
            let may_be_replaced =
                !replaced.is_empty() && corners.iter().all(|&v| is_kept[surface.node(v) as usize]);
            if !(may_be_replaced && replaced.take(numbers, page.tag_of(t))) {
                triangles.push((numbers, page.group_of(t)));
                places.push(t as u32);
            }
        }
        (triangles, places)
    }

    /// One mesh of what all pages contribute.
    fn joined(&self, contributions: Vec<Contribution>) -> PagedCut {
        let loaded = &self.loaded;
        let mut number = vec![0u32; loaded.vertex_count()];
        for (corners, _) in contributions.iter().flat_map(|contribution| &contribution.triangles) {
            corners.iter().for_each(|&v| number[v as usize] = 1);
        }
        let mut used = Vec::new();
        for (v, number) in (0..).zip(&mut number) {
            if *number != 0 {
                *number = used.len() as u32;
                used.push(loaded.place(v));
            }
        }
        let refined_count = contributions.iter().map(|contribution| contribution.refined_count).sum();
        let error = contributions.iter().map(|contribution| contribution.error).fold(0.0, f32::max);
        let mut triangles = Triangles::default();
        for (slot, mut own) in loaded.levels().into_iter().flatten().zip(contributions) {
            own.triangles.iter_mut().for_each(|(corners, _)| *corners = corners.map(|v| number[v as usize]));
            triangles.extend(own.triangles, loaded.page(slot), &own.places);
        }
        let (groups, triangles, triangle_layers) = grouped(triangles, self.metadata);
        let mesh = IndexedMesh {
            positions: used.iter().map(|at| loaded.page(at.slot).positions[at.vertex as usize]).collect(),
            layers: gathered_layers(loaded, &used, self.metadata),
            triangles,
            triangle_layers,
            groups,
            appearance: appearance(self.metadata),
            origin: self.metadata.origin,
            exact_positions: Vec::new(),
        };
        let page_of_vertex = used.iter().map(|at| loaded.index_of(at.slot)).collect();
        let step_count = loaded.pages().map(|page| page.keys.len()).sum();
        PagedCut { mesh, page_of_vertex, refined_count, step_count, error }
    }
}
