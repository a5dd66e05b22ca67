//! The pages that a view needs.

use crate::model::step_bits::StepBits;

/// A page that a view needs and that is not in memory.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AbsentPage {
    /// Index of the page.
    pub page: u32,
    /// Weight of what it bounds; 1 if only steps outside of it need it.
    pub weight: f32,
}

/// What a view needs of a table in pages.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PageDemand {
    /// Pages in memory that the view evaluates or shows, ascending. The others may be unloaded.
    pub used: Vec<u32>,
    /// Pages that are not in memory, those with the largest weights first.
    pub absent: Vec<AbsentPage>,
}

/// Gathers a demand.
pub(super) struct DemandBuilder {
    used: StepBits,
    /// Weight of each absent page that is needed, otherwise 0.
    weights: Vec<f32>,
}

impl DemandBuilder {
    pub(super) fn new(page_count: usize) -> Self {
        Self { used: StepBits::none(page_count), weights: vec![0.0; page_count] }
    }

    pub(super) fn note_used(&mut self, page: u32) {
        self.used.insert(page);
    }

    pub(super) fn note_absent(&mut self, page: u32, weight: f32) {
        let kept = &mut self.weights[page as usize];
        *kept = kept.max(weight);
    }

    pub(super) fn finish(self) -> PageDemand {
        let pages = 0..self.weights.len() as u32;
        let used = pages.clone().filter(|&page| self.used.has(page)).collect();
        let absent = pages.zip(&self.weights).filter(|&(_, &weight)| weight > 0.0);
        let mut absent: Vec<_> = absent.map(|(page, &weight)| AbsentPage { page, weight }).collect();
        // Stable, so equal weights are sorted by page.
        absent.sort_by(|a, b| b.weight.total_cmp(&a.weight));
        PageDemand { used, absent }
    }
}
