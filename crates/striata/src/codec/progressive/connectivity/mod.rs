//! Which vertices split, and which triangles go to the new vertex.

use super::super::entropy::{AdaptiveBit, Coder, Rate};
use super::Effort;
use super::surface::{Cut, Surface, next, triangle_of};
use super::walk::Walk;

/// What both sides know when a vertex is asked whether it splits.
pub(super) struct Scene<'a> {
    /// The surface, with the splits of earlier stretches done. Triangles that no other split of the batch may have are
    /// marked with the batch.
    pub(super) surface: &'a Surface,
    /// Grid coordinates of all vertices but virtual ones.
    pub(super) places: &'a [[i32; 3]],
    /// What has become of other vertices in this batch.
    pub(super) walk: &'a Walk,
    /// Most triangles that a new vertex takes over.
    pub(super) max_patch: u32,
}

impl Scene<'_> {
    /// True where a triangle cannot go to a new vertex any more in this batch.
    #[inline]
    pub(super) fn is_taken(&self, triangle: u32) -> bool {
        self.surface.mark(triangle) == self.walk.batch()
    }
}

/// Adaptive models of flags and cuts.
#[derive(Clone, Debug)]
pub(super) struct ConnectivityModel {
    flags: Vec<AdaptiveBit>,
    lengths: Vec<AdaptiveBit>,
    starts: Vec<Cut>,
}

impl ConnectivityModel {
    pub(super) fn new(_effort: Effort) -> Self {
        Self {
            flags: vec![AdaptiveBit::new(Rate::Steady); 256],
            lengths: vec![AdaptiveBit::new(Rate::Steady); 1024],
            starts: Vec::new(),
        }
    }

    /// Told when a batch begins; `end` is the number of vertices, all with places.
    pub(super) fn begin_batch(&mut self, _surface: &Surface, _end: u32) {}

    /// Codes whether the vertex of `corners` (all corners around it, counter-clockwise) splits, and how.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        scene: &Scene<'_>,
        corners: &[u32],
        actual: Option<Cut>,
    ) -> Option<Cut> {
        let free = corners.iter().filter(|&&c| !scene.is_taken(triangle_of(c))).count();
        let n = corners.len();
        if free == 0 || n < 2 {
            return None;
        }
        let context = n.min(15) * 16 + (n - free).min(15);
        let splits = self.flags[context].code(coder, actual.is_some());
        if !splits {
            return None;
        }
        let most = (scene.max_patch as usize).min(n - 1);
        let mut length = 1;
        while length < most {
            let bit = &mut self.lengths[n.min(31) * 32 + length.min(31)];
            if !bit.code(coder, actual.is_some_and(|cut| cut.length as usize > length)) {
                break;
            }
            length += 1;
        }
        self.starts.clear();
        for i in 0..n {
            let run = (0..length).map(|j| corners[(i + j) % n]);
            let is_free = run.clone().all(|c| !scene.is_taken(triangle_of(c)));
            let is_inside = run.skip(1).all(|c| !scene.surface.is_virtual(scene.surface.vertex(next(c))));
            if is_free && is_inside {
                self.starts.push(Cut { first: corners[i], length: length as u32 });
            }
        }
        // A reader of a damaged stream may find no run of that length.
        let (mut low, mut high) = (0, self.starts.len());
        let at = self.starts.iter().position(|&cut| Some(cut) == actual).unwrap_or(0);
        while low + 1 < high {
            let middle = low.midpoint(high);
            let share = ((high - middle) * 65536 / (high - low)) as u32;
            if coder.bit(at >= middle, share) { low = middle } else { high = middle }
        }
        self.starts.get(low).copied()
    }
}
