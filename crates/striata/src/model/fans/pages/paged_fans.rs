//! A table with some of its pages, and what instances can show with them.

use super::demand::{DemandBuilder, PageDemand};
use super::directory::FanDirectory;
use super::page::Page;
use crate::model::ModelError;
use crate::model::fans::table::{Entry, FanView};
use crate::model::fans::{FanInstance, listed};
use crate::model::step_bits::StepBits;
use crate::view::{Criterion, Part};

/// A table of fans of which some pages are in memory; see the module documentation of
/// [`fans`](crate::model::fans).
///
/// ```
/// use striata::model::{Fans, PagedFans};
/// use striata::view::{Camera, ScreenError};
/// use striata::{mesh::shapes, simplify::build_sequence};
///
/// let refinable = build_sequence(&shapes::terrain(40, 1), &Default::default())?.refinable;
/// let fans = Fans::build(&refinable);
/// let (directory, pages) = fans.to_pages(&refinable.mesh, 64); // `pages` may be written anywhere
/// let mut paged = PagedFans::new(directory);
/// let mut instance = paged.base_instance();
/// let camera = Camera::new([0.5, 0.5, 0.5], [0.0; 3], [0.0, 0.0, 1.0], 0.5, [800, 600])?;
/// let criterion = ScreenError::new(camera, 2.0);
/// loop {
///     let demand = paged.refine(&mut instance, &criterion); // a valid surface, whatever is loaded
///     let Some(most_urgent) = demand.absent.first() else { break };
///     paged.load(&pages[most_urgent.page as usize])?;
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct PagedFans {
    directory: FanDirectory,
    pages: Vec<Option<Page>>,
}

impl PagedFans {
    /// Creates a table without pages, which can show the base.
    pub fn new(directory: FanDirectory) -> Self {
        let pages = vec![None; directory.page_count()];
        Self { directory, pages }
    }

    /// Returns the directory.
    pub fn directory(&self) -> &FanDirectory {
        &self.directory
    }

    /// Returns an instance that shows the base.
    pub fn base_instance(&self) -> FanInstance {
        let step_count = self.directory.step_count();
        let mut collapsed = StepBits::none(step_count);
        collapsed.set_range(0..step_count);
        FanInstance { step_count, collapsed }
    }

    /// Loads a page from its bytes and returns its index.
    ///
    /// # Errors
    /// [`ModelError`] if the bytes are not a page of this table; nothing is changed then. Whether pages fit to each
    /// other is not checked.
    pub fn load(&mut self, bytes: &[u8]) -> Result<u32, ModelError> {
        let (index, page) = Page::from_bytes(bytes, &self.directory)?;
        self.pages[index as usize] = Some(page);
        Ok(index)
    }

    /// Unloads a page. Instances that show steps of the page must be [settled](Self::settle) before they are drawn.
    ///
    /// # Panics
    /// If the page does not exist.
    pub fn unload(&mut self, page: u32) {
        self.pages[page as usize] = None;
    }

    /// Whether a page is in memory.
    ///
    /// # Panics
    /// If the page does not exist.
    pub fn is_loaded(&self, page: u32) -> bool {
        self.pages[page as usize].is_some()
    }

    /// Number of bytes in memory.
    pub fn bytes(&self) -> usize {
        let slots = size_of_val(&self.pages[..]);
        self.directory.bytes() + slots + self.pages.iter().flatten().map(Page::bytes).sum::<usize>()
    }

    /// Refines an instance from the base to what a criterion wants and what that needs, as far as the pages allow.
    /// Returns which pages the view needs.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn refine(&self, instance: &mut FanInstance, criterion: &impl Criterion) -> PageDemand {
        self.check(instance);
        instance.collapsed.set_range(0..instance.step_count);
        let mut demand = DemandBuilder::new(self.pages.len());
        self.split_wanted(instance, criterion, &mut demand);
        self.split_needed(instance, criterion, &mut demand);
        self.settle(instance);
        demand.finish()
    }

    /// Splits all steps that the criterion wants and whose pages are loaded, down the tree of steps.
    fn split_wanted(
        &self,
        instance: &mut FanInstance,
        criterion: &impl Criterion,
        demand: &mut DemandBuilder,
    ) {
        let mut known = StepBits::none(instance.step_count);
        let mut learn = |fan: FanView<'_>| {
            fan.creators().filter(|creator| creator.is_child).for_each(|c| known.insert(c.step));
        };
        let base = 0..self.directory.vertices.base_vertex_count;
        base.for_each(|vertex| self.base_entry(vertex).for_each(&mut learn));
        self.directory.orphans.iter().for_each(|&step| known.insert(step));
        let mut next = 0;
        // Children are finer than their parents.
        while let Some(step) = known.first_from(next) {
            next = step + 1;
            let index = self.directory.page_of(step);
            let Some(page) = &self.pages[index as usize] else {
                let weight = criterion.weigh(self.bounds(index)).weight;
                demand.note_absent(index, if weight > 1.0 { weight } else { 0.0 });
                continue;
            };
            demand.note_used(index);
            if criterion.weigh(&page.part(page.slot(step))).should_refine() {
                instance.collapsed.remove(step);
                self.for_each_fan(page, step, |fan| {
                    fan.creators().filter(|creator| creator.is_child).for_each(|c| known.insert(c.step));
                });
            }
        }
    }

    /// Splits all steps that split ones need, whether or not their pages are loaded.
    fn split_needed(
        &self,
        instance: &mut FanInstance,
        criterion: &impl Criterion,
        demand: &mut DemandBuilder,
    ) {
        // What a step needs is coarser.
        let mut end = instance.step_count as u32;
        while let Some(step) = instance.collapsed.last_absent_before(end) {
            end = step;
            let index = self.directory.page_of(step);
            let Some(page) = &self.pages[index as usize] else {
                demand.note_absent(index, criterion.weigh(self.bounds(index)).weight.max(1.0));
                continue;
            };
            demand.note_used(index);
            self.for_each_needed(page, step, |needed| instance.collapsed.remove(needed));
        }
    }

    /// Collapses all steps of an instance that cannot be shown: those whose pages are not loaded, and those that need
    /// them. Returns the number of steps collapsed.
    ///
    /// # Panics
    /// If the instance belongs to a different table.
    pub fn settle(&self, instance: &mut FanInstance) -> usize {
        self.check(instance);
        let mut count = 0;
        for step in 0..instance.step_count as u32 {
            if !instance.is_refined(step) {
                continue;
            }
            let page = self.pages[self.directory.page_of(step) as usize].as_ref();
            let can_be_shown = page.is_some_and(|page| {
                let mut has_all = true;
                self.for_each_needed(page, step, |needed| has_all &= instance.is_refined(needed));
                has_all
            });
            if !can_be_shown {
                instance.collapsed.insert(step);
                count += 1;
            }
        }
        count
    }

    /// Appends the triangles of a group that an instance shows.
    ///
    /// # Panics
    /// If the group does not exist, the instance belongs to a different table, or it shows a step whose page has
    /// been unloaded.
    pub fn group_triangles_into(&self, instance: &FanInstance, group: usize, out: &mut Vec<[u32; 3]>) {
        self.check(instance);
        assert!(group < self.directory.group_count, "group {group} of {}", self.directory.group_count);
        let mut indices = Vec::new();
        let mut write = |fan: FanView<'_>| {
            if fan.group as usize == group {
                fan.triangles_into(fan.mask(|step| instance.collapsed.has(step)), &mut indices);
            }
        };
        let base = 0..self.directory.vertices.base_vertex_count;
        base.for_each(|vertex| self.base_entry(vertex).for_each(&mut write));
        for step in (0..instance.step_count as u32).filter(|&step| instance.is_refined(step)) {
            let page = self.pages[self.directory.page_of(step) as usize].as_ref();
            self.for_each_fan(page.expect("an instance shows only pages that are loaded"), step, &mut write);
        }
        out.extend_from_slice(indices.as_chunks().0);
    }

    /// Returns all triangles that an instance shows, group by group.
    ///
    /// # Panics
    /// If the instance belongs to a different table, or it shows a step whose page has been unloaded.
    pub fn triangles(&self, instance: &FanInstance) -> Vec<[u32; 3]> {
        let mut triangles = Vec::new();
        for group in 0..self.directory.group_count {
            self.group_triangles_into(instance, group, &mut triangles);
        }
        triangles
    }

    fn bounds(&self, page: u32) -> &Part {
        &self.directory.pages[page as usize].0
    }

    fn base_entry(&self, vertex: u32) -> Entry<'_> {
        self.directory.base.entry(vertex as usize, vertex, 0, self.directory.group_count > 1)
    }

    fn for_each_fan<'p>(&self, page: &'p Page, step: u32, mut visit: impl FnMut(FanView<'p>)) {
        let first = page.firsts[page.slot(step)] as usize;
        for (index, vertex) in (first..).zip(self.directory.vertices.of_step(step as usize)) {
            page.entry(index, vertex, step + 1, self.directory.group_count > 1).for_each(&mut visit);
        }
    }

    /// Visits the steps that must be split before this one, some of them repeatedly.
    fn for_each_needed(&self, page: &Page, step: u32, mut visit: impl FnMut(u32)) {
        let vertices = &self.directory.vertices;
        let own = vertices.of_step(step as usize);
        self.for_each_fan(page, step, |fan| {
            let above = fan.nodes().filter(|node| *node >= vertices.base_vertex_count && !own.contains(node));
            above.for_each(|node| visit(vertices.step_of(node) as u32));
        });
        listed(&page.far, step).for_each(visit);
    }

    fn check(&self, instance: &FanInstance) {
        assert_eq!(instance.step_count, self.directory.step_count(), "the instance is of another table");
    }
}
