//! The beginning of a page.

use super::lattice::Lattice;
use crate::{Import, Metadata, Page};

/// Counts and lattice at the start of a page.
pub(super) struct PageCounts {
    pub positions: usize,
    pub vertices: usize,
    pub imports: usize,
    pub triangles: usize,
    /// Pages of imports, ascending.
    pub pages: Vec<u32>,
    /// Coarsest lattice that contains all positions.
    pub lattice: Lattice,
}

impl PageCounts {
    pub(super) fn of(page: &Page, metadata: &Metadata) -> Self {
        let mut pages: Vec<u32> = page.imports.iter().map(|import| import.page).collect();
        pages.sort_unstable();
        pages.dedup();
        Self {
            positions: page.first.len().saturating_sub(1),
            vertices: page.positions.len(),
            imports: page.imports.len(),
            triangles: page.triangles.len(),
            pages,
            lattice: Lattice::of(page, metadata),
        }
    }
}

/// Placeholder of an import that has not been named yet.
pub(super) const UNKNOWN: Import = Import { page: 0, vertex: 0 };
