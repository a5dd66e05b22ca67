//! The part of a table in pages that is always in memory, and how a table is cut into pages.

use glam::Vec3;

use super::page::Page;
use crate::mesh::{IndexedMesh, ZOrderCurve};
use crate::model::fans::{FanScene, Fans, listed};
use crate::model::part_record::direction;
use crate::model::step_vertices::StepVertices;
use crate::view::{NormalCone, Part};

/// The pages of a table: which page has each step, bounds of each page, and the entries of the base.
#[derive(Clone, Debug, PartialEq)]
pub struct FanDirectory {
    pub(super) vertices: StepVertices<'static>,
    pub(super) group_count: usize,
    /// Page of each step.
    pub(super) page_of: Box<[u32]>,
    /// Bounds of all steps of each page, and their number.
    pub(super) pages: Vec<(Part, u32)>,
    /// Entries of the base vertices.
    pub(super) base: Page,
    /// Steps that are children of the base although its entries do not name them.
    pub(super) orphans: Vec<u32>,
}

impl FanDirectory {
    /// Number of pages.
    pub fn page_count(&self) -> usize {
        self.pages.len()
    }

    /// Number of steps.
    pub fn step_count(&self) -> usize {
        self.page_of.len()
    }

    /// Returns the page of a step.
    ///
    /// # Panics
    /// If the step does not exist.
    pub fn page_of(&self, step: u32) -> u32 {
        self.page_of[step as usize]
    }

    /// Number of bytes in memory.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.vertices.firsts[..])
            + size_of_val(&self.page_of[..])
            + size_of_val(&self.pages[..])
            + size_of_val(&self.orphans[..])
            + self.base.bytes()
    }

    pub(super) fn step_count_of(&self, page: u32) -> Option<u32> {
        self.pages.get(page as usize).map(|&(_, count)| count)
    }
}

impl Fans {
    /// Cuts the table into pages of at most `max_steps` steps: returns what has to be in memory, and the bytes of
    /// each page. `mesh` is the full mesh.
    ///
    /// # Panics
    /// If the mesh belongs to another table, the table has no bounds, or `max_steps` is 0.
    pub fn to_pages(&self, mesh: &IndexedMesh, max_steps: usize) -> (FanDirectory, Vec<Vec<u8>>) {
        assert!(max_steps > 0, "pages have at least one step");
        let scene = FanScene::new(self, &mesh.positions);
        let steps_of_pages = self.steps_of_pages(mesh, max_steps);
        let mut page_of = vec![0; self.step_count];
        for (page, steps) in (0..).zip(&steps_of_pages) {
            steps.iter().for_each(|&step| page_of[step as usize] = page);
        }
        let bounds = steps_of_pages.iter().map(|steps| (bounds_of(&scene, steps), steps.len() as u32));
        let mut base = Page::default();
        (0..self.vertices.base_vertex_count).for_each(|vertex| base.push_entry(self.entry_bytes(vertex)));
        base.close();
        let directory = FanDirectory {
            vertices: self.vertices.clone(),
            group_count: self.group_count,
            page_of: page_of.into(),
            pages: bounds.collect(),
            base,
            orphans: self.orphans.clone(),
        };
        let pages = (0..).zip(steps_of_pages);
        let pages = pages.map(|(index, steps)| self.page(&scene, steps).to_bytes(index)).collect();
        (directory, pages)
    }

    /// Chooses the steps of each page: bands of steps, each with as many as all coarser ones together, are cut along
    /// a curve through space.
    fn steps_of_pages(&self, mesh: &IndexedMesh, max_steps: usize) -> Vec<Vec<u32>> {
        let curve = ZOrderCurve::of(mesh);
        let code = |step: u32| {
            let center = mesh.positions[self.center_vertex(step)];
            curve.as_ref().map_or(0, |curve| curve.code(center))
        };
        let mut pages = Vec::new();
        let (mut start, mut end) = (0, max_steps.min(self.step_count));
        while start < end {
            let mut band: Vec<u32> = (start as u32..end as u32).collect();
            band.sort_by_cached_key(|&step| (code(step), step));
            let page_count = band.len().div_ceil(max_steps);
            for steps in band.chunks(band.len().div_ceil(page_count)) {
                let mut steps = steps.to_vec();
                steps.sort_unstable();
                pages.push(steps);
            }
            (start, end) = (end, (2 * end).min(self.step_count));
        }
        pages
    }

    fn page(&self, scene: &FanScene<'_>, steps: Vec<u32>) -> Page {
        let mut page = Page::default();
        for &step in &steps {
            page.centers.push(scene.part(step).sphere.center);
            page.records.push(scene.record(step));
            page.far.extend(listed(&self.far, step).map(|target| [step, target]));
            self.vertices.of_step(step as usize).for_each(|vertex| page.push_entry(self.entry_bytes(vertex)));
        }
        page.steps = steps;
        page.close();
        page
    }

    /// Returns the encoded entry of a vertex.
    fn entry_bytes(&self, vertex: u32) -> &[u8] {
        let [start, end] = [vertex, vertex + 1].map(|vertex| self.table.start(vertex as usize));
        &self.table.arrays().entries[start..end]
    }
}

/// Returns bounds that enclose those of some steps.
fn bounds_of(scene: &FanScene<'_>, steps: &[u32]) -> Part {
    let first = scene.part(steps[0]);
    let cone = NormalCone::around(direction(first.cone.axis).to_array());
    let parts = || steps.iter().map(|&step| scene.part(step));
    let mut bounds = parts().fold(Part { cone, ..first }, |all, part| Part {
        sphere: all.sphere.with_sphere(&part.sphere),
        cone: all.cone.with_cone(&part.cone),
        error: all.error.max(part.error),
    });
    // Packed axes are shorter than 1, and the shorter an axis, the less its part counts as turned away. The page must
    // not be turned away unless all of its steps are.
    let lengths = parts().map(|part| Vec3::from(part.cone.axis).length());
    let length = lengths.fold(1.0, f32::min) * (1.0 - 1e-5);
    bounds.cone.axis = bounds.cone.axis.map(|x| x * length);
    bounds
}
