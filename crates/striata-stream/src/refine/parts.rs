//! The state of a refinement apart from its models.

use super::growth::GrowingMesh;
use super::walk::BatchWalk;
use crate::connectivity::SplitContext;
use crate::format::grid::PositionGrid;
use crate::topology::surface::{Surface, triangle_of};
use crate::wedges::split::SplitWedges;

/// The mesh and surface refined so far.
#[derive(Clone, Debug)]
pub(crate) struct RefinedLevel {
    /// The surface, including all splits done so far.
    pub surface: Surface,
    /// Grid coordinates of each vertex of the surface.
    pub grid_points: Vec<[i32; 3]>,
    /// The grid that these coordinates refer to.
    pub grid: PositionGrid,
    /// The mesh that the surface represents.
    pub growth: GrowingMesh,
}

/// Progress within the current batch.
#[derive(Clone, Debug)]
pub(crate) struct Batch {
    /// The order in which vertices are visited.
    pub walk: BatchWalk,
    /// Whether vertices of the batch remain to be visited.
    pub is_under_way: bool,
    /// Number of splits so far.
    pub split_count: usize,
}

/// Limits that a stream must respect.
#[derive(Clone, Debug)]
pub(crate) struct StreamLimits {
    /// Maximum number of triangles that move to a new vertex.
    pub max_patch: u32,
    /// Number of vertex visits that are still allowed.
    pub visits_left: u64,
    /// Maximum number of vertices in excess of one per position. In a reader, the number of bytes limits it.
    pub most_wedges: u64,
}

/// A run of splits within a batch. The connectivity of all of them is coded first, then the values of each.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stretch {
    /// Corners of the patches of all splits, stored consecutively.
    pub patches: Vec<u32>,
    /// End of each split's patch in that list.
    pub ends: Vec<u32>,
    /// Corners around the new vertex.
    pub corners: Vec<u32>,
    /// Vertices that those corners refer to.
    pub shown: SplitWedges,
}

impl RefinedLevel {
    /// Returns the context in which a vertex is visited.
    #[inline]
    pub(crate) fn split_context<'a>(
        &'a self,
        walk: &'a BatchWalk,
        limits: &StreamLimits,
    ) -> SplitContext<'a> {
        SplitContext {
            surface: &self.surface,
            grid_points: &self.grid_points,
            walk,
            max_patch: limits.max_patch,
        }
    }

    /// Reserves memory for a number of splits.
    pub(crate) fn reserve(&mut self, steps: usize) {
        self.surface.reserve(steps);
        self.grid_points.reserve(steps);
        self.growth.reserve(steps);
    }
}

impl Stretch {
    /// Number of splits whose connectivity is known.
    pub(crate) fn split_count(&self) -> usize {
        self.ends.len()
    }

    /// Removes all splits.
    pub(crate) fn clear(&mut self) {
        self.patches.clear();
        self.ends.clear();
    }

    /// Records a split whose patch has been appended to [`patches`](Self::patches), and marks its triangles, so that no
    /// other split of the batch uses them.
    pub(crate) fn close_split(&mut self, surface: &mut Surface, batch: u32) {
        let start = self.ends.last().map_or(0, |&end| end as usize);
        for &corner in &self.patches[start..] {
            surface.set_mark(triangle_of(corner), batch);
        }
        self.ends.push(self.patches.len() as u32);
    }

    /// Iterates over the patches of the splits.
    pub(crate) fn patches(&self) -> impl Iterator<Item = &[u32]> {
        let mut start = 0;
        self.ends.iter().map(move |&end| {
            let patch = &self.patches[start..end as usize];
            start = end as usize;
            patch
        })
    }
}
