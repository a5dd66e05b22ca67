//! What a refinement consists of beside its models.

use super::growth::Growth;
use super::walk::Walk;
use crate::connectivity::Scene;
use crate::format::grid::PositionGrid;
use crate::topology::rings::Rings;
use crate::topology::surface::{Cut, Surface, triangle_of};
use crate::wedges::split::SplitWedges;

/// What is there so far.
#[derive(Clone, Debug)]
pub(crate) struct Level {
    /// The surface, with all splits that have been done.
    pub(crate) surface: Surface,
    /// Grid coordinates by vertex of the surface.
    pub(crate) places: Vec<[i32; 3]>,
    /// What the grid coordinates mean.
    pub(crate) grid: PositionGrid,
    /// The mesh that the surface stands for.
    pub(crate) growth: Growth,
}

/// Where a batch stands.
#[derive(Clone, Debug)]
pub(crate) struct Batch {
    /// Who is asked next.
    pub(crate) walk: Walk,
    /// Whether there is more to be asked.
    pub(crate) is_under_way: bool,
    /// Splits so far.
    pub(crate) split_count: usize,
}

/// What a stream may not go beyond.
#[derive(Clone, Debug)]
pub(crate) struct Limits {
    /// Most triangles that a new vertex takes over.
    pub(crate) max_patch: u32,
    /// Vertices that may still be asked.
    pub(crate) visits_left: u64,
    /// Vertices beyond one a position that there may be; a reader's bytes cannot give more.
    pub(crate) most_wedges: u64,
}

/// Splits whose connectivity has been coded, while their values are coded one by one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stretch {
    /// Corners of the patches of all splits.
    pub(crate) patches: Vec<u32>,
    /// The end of the patch of each split.
    pub(crate) ends: Vec<u32>,
    /// Vertices that split and whose cuts are coded next.
    pub(crate) group: Vec<u32>,
    /// The corners around these.
    pub(crate) rings: Rings,
    /// The corners around the vertex that is asked, or around the new one.
    pub(crate) corners: Vec<u32>,
    /// What those corners show.
    pub(crate) shown: SplitWedges,
}

impl Level {
    /// What is seen when a vertex is asked.
    #[inline]
    pub(crate) fn scene<'a>(&'a self, walk: &'a Walk, limits: &Limits) -> Scene<'a> {
        Scene { surface: &self.surface, places: &self.places, walk, max_patch: limits.max_patch }
    }

    /// Makes room for so many splits.
    pub(crate) fn reserve(&mut self, steps: usize) {
        self.surface.reserve(steps);
        self.places.reserve(steps);
        self.growth.reserve(steps);
    }
}

impl Stretch {
    /// Splits of which the connectivity is known.
    pub(crate) fn split_count(&self) -> usize {
        self.ends.len()
    }

    /// No splits.
    pub(crate) fn clear(&mut self) {
        self.patches.clear();
        self.ends.clear();
    }

    /// Notes a split and marks the triangles of its patch: no other split of the batch may have them.
    pub(crate) fn take(&mut self, surface: &mut Surface, cut: Cut, batch: u32) {
        let mut corner = cut.first;
        for at in 0..cut.length {
            if at > 0 {
                corner = surface.swing(corner);
            }
            surface.set_mark(triangle_of(corner), batch);
            self.patches.push(corner);
        }
        self.ends.push(self.patches.len() as u32);
    }

    /// The same for a split whose corners are the last ones of the list already.
    pub(crate) fn close(&mut self, surface: &mut Surface, batch: u32) {
        let start = self.ends.last().map_or(0, |&end| end as usize);
        for &corner in &self.patches[start..] {
            surface.set_mark(triangle_of(corner), batch);
        }
        self.ends.push(self.patches.len() as u32);
    }

    /// The patch of each split.
    pub(crate) fn patches(&self) -> impl Iterator<Item = &[u32]> {
        let mut start = 0;
        self.ends.iter().map(move |&end| {
            let patch = &self.patches[start..end as usize];
            start = end as usize;
            patch
        })
    }
}
