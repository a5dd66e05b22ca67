//! [`Ring`]: the ring of a vertex that may split: its neighbors and their history, and its lengths, angles,
//! areas and curvature.
//!
//! Measures are binary logarithms of squares, in 1/256, since roots and quotients then cost nothing.
//! Vectors to neighbors are shifted down to 13 bits if they are longer, so that products stay small.

use crate::entropy::log2_q8;

/// An edge from the vertex, and the triangle counterclockwise of it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct RingSpoke {
    /// Far end of the edge.
    pub vertex: u32,
    /// Whether the far end is virtual, which closes a boundary loop.
    pub is_virtual: bool,
    /// Whether another split has claimed the triangle.
    pub is_claimed: bool,
    /// Whether the triangle's angle at the vertex is obtuse.
    pub is_obtuse: bool,
    /// State of the far end in this batch: 0 not visited, 1 stays, 2 splits, 3 new.
    pub state: u8,
    /// Age of the far end in batches, up to 3.
    pub age: u8,
    /// Number of triangles around the far end after all splits known so far.
    pub valence: u8,
    /// Vector to the far end; zeros if that is virtual.
    pub step: [i32; 3],
    /// Area vector of the triangle, twice its area long; zeros if the triangle is virtual.
    pub normal: [i32; 3],
    /// Length of the edge.
    pub length: i32,
    /// Twice the area of the triangle.
    pub area: i32,
    /// Distance of the next edge's far end from the plane of the triangle before this edge: a measure of
    /// curvature.
    pub height: i32,
    /// Tangent of the triangle's angle at the vertex.
    pub tangent: i32,
}

/// The ring of a vertex and its measures.
#[derive(Clone, Debug, Default)]
pub(super) struct Ring {
    /// Edges and triangles, counterclockwise.
    pub spokes: Vec<RingSpoke>,
    /// Number of neighbors in each state.
    pub states: [usize; 4],
    /// Number of neighbors created in the previous batch.
    pub young: usize,
    /// Number of triangles that may move to a new vertex.
    pub free: usize,
    /// Maximum number of consecutive triangles that may move to a new vertex.
    pub free_run: usize,
    /// Mean of the share of splits around the neighbors that have been visited, in 1/256.
    pub density: i32,
    /// Mean of the lengths.
    pub length: i32,
    /// Mean of the areas.
    pub area: i32,
    /// Mean of the heights.
    pub height: i32,
    /// Bitwise or of the magnitudes of all vector components, before the shift.
    pub magnitudes: u32,
    /// Number of bits by which the vectors were shifted down.
    shift: i32,
}

/// Number of bits of a vector's components.
const STEP_BITS: i32 = 13;
/// Heights below this are noise from the grid.
const MIN_HEIGHT: i32 = -512;

/// Returns the binary logarithm, in 1/256.
#[inline]
pub(super) fn log2_wide(number: u64) -> i32 {
    let spare = (64 - number.leading_zeros()).saturating_sub(32);
    log2_q8((number >> spare) as u32) + ((spare as i32) << 8)
}

/// 65536 / n, rounded up.
const INVERSES: [i64; 16] = {
    let mut table = [0; 16];
    let mut n = 1;
    while n < 16 {
        table[n] = 65536 / n as i64 + 1;
        n += 1;
    }
    table
};

/// Returns the mean, approximately rounded down; 0 if `count` is 0.
#[inline]
pub(super) fn mean(sum: i64, count: usize) -> i32 {
    match INVERSES.get(count) {
        Some(inverse) => ((sum * inverse) >> 16) as i32,
        None => (sum / count as i64) as i32,
    }
}

#[inline]
pub(super) fn dot(a: [i32; 3], b: [i32; 3]) -> i32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(super) fn dot_wide(a: [i64; 3], b: [i64; 3]) -> i64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(super) fn cross(a: [i32; 3], b: [i32; 3]) -> [i32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl Ring {
    /// Measures the ring that [`gather`](Self::gather) has filled in.
    pub(super) fn measure(&mut self) {
        self.shift = (32 - STEP_BITS - self.magnitudes.leading_zeros() as i32).max(0);
        if self.shift > 0 {
            let shift = self.shift;
            self.spokes.iter_mut().for_each(|spoke| spoke.step = spoke.step.map(|x| x >> shift));
        }
        self.measure_triangles();
        self.measure_heights();
    }

    fn measure_triangles(&mut self) {
        let n = self.spokes.len();
        let (mut lengths, mut areas, mut edge_count, mut triangle_count) = (0, 0, 0, 0);
        for i in 0..n {
            let after = &self.spokes[if i + 1 < n { i + 1 } else { 0 }];
            let (next_step, is_open) = (after.step, after.is_virtual);
            let spoke = &mut self.spokes[i];
            if spoke.is_virtual {
                continue;
            }
            spoke.length = log2_q8(dot(spoke.step, spoke.step) as u32);
            lengths += i64::from(spoke.length);
            edge_count += 1;
            if is_open {
                continue;
            }
            spoke.normal = cross(spoke.step, next_step);
            let normal = spoke.normal.map(i64::from);
            spoke.area = log2_wide(dot_wide(normal, normal) as u64);
            let cosine = dot(spoke.step, next_step);
            spoke.tangent = spoke.area - 2 * log2_q8(cosine.unsigned_abs());
            spoke.is_obtuse = cosine < 0;
            areas += i64::from(spoke.area);
            triangle_count += 1;
        }
        self.length = mean(lengths, edge_count);
        self.area = mean(areas, triangle_count);
    }

    fn measure_heights(&mut self) {
        let n = self.spokes.len();
        let (mut heights, mut count) = (0, 0);
        for i in 0..n {
            let before = &self.spokes[if i > 0 { i - 1 } else { n - 1 }];
            let after = &self.spokes[if i + 1 < n { i + 1 } else { 0 }];
            if before.is_virtual || after.is_virtual || self.spokes[i].is_virtual {
                continue;
            }
            let volume = dot_wide(before.normal.map(i64::from), after.step.map(i64::from));
            let height = 2 * log2_wide(volume.unsigned_abs()) - before.area + 512 * self.shift;
            let height = height.max(MIN_HEIGHT);
            heights += i64::from(height);
            count += 1;
            self.spokes[i].height = height;
        }
        self.height = mean(heights, count);
    }

    /// Returns the mean length in grid units.
    pub(super) fn grid_length(&self) -> i32 {
        self.length + 512 * self.shift
    }
}

#[cfg(test)]
mod tests {
    use super::super::split_context::SplitContext;
    use super::super::tests::surface_of;
    use super::super::vertex_history::VertexHistories;
    use super::*;
    use crate::refine::walk::BatchWalk;
    use crate::topology::surface::triangle_of;

    #[test]
    fn a_flat_hexagon_has_equal_measures() {
        // Vertex 0 is virtual and closes the hexagon around vertex 1.
        let rim = |i: u32| 2 + i % 6;
        let triangles: Vec<[u32; 3]> =
            (0..6).flat_map(|i| [[1, rim(i), rim(i + 1)], [0, rim(i + 1), rim(i)]]).collect();
        let mut surface = surface_of(&triangles, 8, 1);
        let [x, y] = [500, 866];
        let hexagon = [[2 * x, 0], [x, y], [-x, y], [-2 * x, 0], [-x, -y], [x, -y]];
        let grid_points: Vec<[i32; 3]> =
            [[0; 3], [70, 80, 90]].into_iter().chain(hexagon.map(|[x, y]| [70 + x, 80 + y, 90])).collect();
        let mut walk = BatchWalk::default();
        walk.begin(&surface);
        let mut history = VertexHistories::default();
        history.begin_batch(&surface);
        let corners: Vec<u32> = surface.ring(1).collect();
        surface.set_mark(triangle_of(corners[2]), walk.batch());
        let split_context =
            SplitContext { surface: &surface, grid_points: &grid_points, walk: &walk, max_patch: 5 };
        let mut ring = Ring::default();
        ring.gather(&split_context, &history, 1, &corners);
        ring.measure();
        assert_eq!((ring.free, ring.free_run, ring.states), (5, 5, [6, 0, 0, 0]));
        assert!((ring.height - MIN_HEIGHT).abs() <= 1);
        assert!((ring.grid_length() - 5102).abs() < 4, "{}", ring.grid_length());
        for spoke in &ring.spokes {
            assert!((spoke.length - ring.length).abs() < 4 && (spoke.area - ring.area).abs() < 4);
            // The squared tangent of 60 degrees is 3.
            assert!((spoke.tangent - 406).abs() < 4 && !spoke.is_obtuse && spoke.valence == 4);
        }
        // Around a vertex of the rim, the hole counts as virtual.
        let corners: Vec<u32> = surface.ring(2).collect();
        ring.gather(&split_context, &history, 2, &corners);
        ring.measure();
        let open: Vec<_> = ring.spokes.iter().filter(|s| s.is_virtual).collect();
        assert!(open.len() == 1 && open[0].step == [0; 3] && open[0].area == 0);
        assert_eq!(ring.spokes.iter().filter(|s| s.area > 0).count(), 2);
    }
}
