//! Features of a run of triangles as a whole.

use super::ring::{Ring, RingSpoke, cross, dot, dot_wide, log2_wide};

/// Number of features of a run.
pub(super) const FEATURES: usize = 6;
/// Number of values of a feature: 16 for each class of lengths.
pub(super) const VALUES: usize = 16 * LENGTH_CLASSES;
const LENGTH_CLASSES: usize = 8;
/// Values that mark a run with a virtual end.
const VIRTUAL_END: i32 = 15;
const VIRTUAL_END_WIDTH: i32 = 31;

/// A run of triangles, extended one by one.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Patch {
    first: usize,
    end: usize,
    length: usize,
    /// Sum of the edge vectors.
    steps: [i32; 3],
    /// Sum of the squared edge lengths.
    squares: u32,
    /// Sum of the area vectors of its triangles.
    normal: [i64; 3],
}

/// Returns the first value of a length's class.
#[inline]
pub(super) fn class_of(length: usize) -> usize {
    length.min(LENGTH_CLASSES - 1) * 16
}

impl Patch {
    /// Creates a run without triangles that starts at edge `first`.
    pub(super) fn begin(ring: &Ring, first: usize) -> Self {
        let step = ring.spokes[first].step;
        Self { first, end: first, length: 0, steps: step, squares: dot(step, step) as u32, normal: [0; 3] }
    }

    /// Extends the run by the next triangle.
    pub(super) fn grow(&mut self, ring: &Ring) {
        let last = &ring.spokes[self.end];
        self.end = if self.end + 1 < ring.spokes.len() { self.end + 1 } else { 0 };
        self.length += 1;
        let step = ring.spokes[self.end].step;
        self.steps = std::array::from_fn(|a| self.steps[a] + step[a]);
        self.normal = std::array::from_fn(|a| self.normal[a] + i64::from(last.normal[a]));
        self.squares = self.squares.saturating_add(dot(step, step) as u32);
    }

    /// Returns the features, each below [`VALUES`]; `whole` is the sum of the area vectors of all triangles
    /// around the vertex.
    pub(super) fn features(&self, ring: &Ring, whole: [i64; 3]) -> [usize; FEATURES] {
        let class = class_of(self.length);
        let size_log = log2_wide(self.length as u64 + 2);
        let (mut center, mut distance, mut width, mut nearer_count) =
            (VIRTUAL_END, VIRTUAL_END, VIRTUAL_END_WIDTH, VIRTUAL_END);
        let [first, end] = [self.first, self.end].map(|i| &ring.spokes[i]);
        if !first.is_virtual && !end.is_virtual {
            let steps = self.steps.map(i64::from);
            let square = log2_wide(dot_wide(steps, steps) as u64);
            center = ((square - size_log - log2_wide(self.squares.into()) + 15 * 64) >> 6).clamp(0, 14);
            distance = ((square - 2 * size_log - ring.length + 10 * 96) / 96).clamp(0, 14);
            width = self.width(first, end);
            nearer_count = self.nearer_count(ring);
        }
        let n = ring.spokes.len();
        let remaining = (n + 2 - self.length).clamp(3, 6) - 3;
        [
            class + center as usize,
            class + self.share(n, whole, size_log) as usize,
            class + distance as usize,
            remaining * 32 + width as usize,
            class + nearer_count as usize,
            self.other_claims(ring),
        ]
    }

    /// Returns the class of the mean area of the new vertex's triangles relative to that of the remaining
    /// ones.
    fn share(&self, n: usize, whole: [i64; 3], size_log: i32) -> i32 {
        let rest: [i64; 3] = std::array::from_fn(|a| whole[a] - self.normal[a]);
        let outside = (n - self.length.min(n - 1)) as u64;
        let share = log2_wide(dot_wide(self.normal, self.normal) as u64)
            - log2_wide(dot_wide(rest, rest) as u64)
            - 2 * (size_log - log2_wide(outside));
        ((share + 8 * 96) / 96).clamp(0, 15)
    }

    /// Returns how many of the run's edge ends are closer to their mean than to the split vertex.
    fn nearer_count(&self, ring: &Ring) -> i32 {
        let (n, size) = (ring.spokes.len(), self.length as i64 + 2);
        let steps = self.steps.map(i64::from);
        // |size e - sum|^2 < |sum|^2, divided by size.
        let is_nearer = |step: [i64; 3]| size * dot_wide(step, step) < 2 * dot_wide(step, steps);
        let at = |k: usize| if k < n { k } else { k - n };
        let edges = (self.first..=self.first + self.length).map(|k| ring.spokes[at(k)].step.map(i64::from));
        edges.filter(|&step| is_nearer(step)).count() as i32
    }

    /// Returns the angle between the end edges, in steps of about 11 degrees, up to 360 degrees.
    fn width(&self, first: &RingSpoke, end: &RingSpoke) -> i32 {
        const COSINES: [i32; 7] = [-20, -52, -106, -192, -326, -550, -1000];
        let cosine = dot(first.step, end.step);
        let square = 2 * log2_wide(cosine.unsigned_abs().into()) - first.length - end.length;
        let step = COSINES.iter().filter(|&&c| square <= c).count() as i32;
        let width = if cosine > 0 { step } else { 15 - step };
        let across = cross(first.step, end.step).map(i64::from);
        if dot_wide(self.normal, across) >= 0 { width } else { 30 - width }
    }

    /// Returns a feature of runs of one or two triangles: how many of the other vertices that could have
    /// claimed such a patch were visited but do not split.
    fn other_claims(&self, ring: &Ring) -> usize {
        let stays = |i: usize| usize::from(ring.spokes[i].state == 1);
        match self.length {
            1 => 1 + stays(self.first) + stays(self.end),
            2 => 4 + stays(if self.end > 0 { self.end - 1 } else { ring.spokes.len() - 1 }),
            _ => 0,
        }
    }
}
