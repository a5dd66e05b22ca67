//! What is seen around a vertex that may split: its neighbors and their history, then lengths, angles, areas and bends.
//!
//! Measures are logarithms to base 2 in 1/256, of squares, since roots and quotients are then free. Steps to neighbors are
//! shifted down to 13 bits where they are longer, so that products stay small.

use crate::entropy::log2_q8;

/// An edge from the vertex, and the triangle behind it, counter-clockwise.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Spoke {
    /// The other end.
    pub(super) vertex: u32,
    /// The other end stands for a boundary loop.
    pub(super) is_virtual: bool,
    /// The triangle cannot go to a new vertex any more.
    pub(super) is_taken: bool,
    /// The angle of the triangle is over 90 degrees.
    pub(super) is_blunt: bool,
    /// What became of the other end: not asked, stays, splits, new.
    pub(super) fate: u8,
    /// Its age in batches, up to 3.
    pub(super) age: u8,
    /// Triangles around it, with all splits that are known.
    pub(super) valence: u8,
    /// To the other end; zeros where that is virtual.
    pub(super) step: [i32; 3],
    /// Twice the area of the triangle as a vector; zeros where the triangle is virtual.
    pub(super) normal: [i32; 3],
    /// The length.
    pub(super) length: i32,
    /// Twice the area of the triangle.
    pub(super) area: i32,
    /// How far the next edge's end lies from the plane of the triangle before this edge.
    pub(super) height: i32,
    /// The tangent of the triangle's angle.
    pub(super) tangent: i32,
}

/// A vertex and what is around it.
#[derive(Clone, Debug, Default)]
pub(super) struct Ring {
    /// Edges and triangles, counter-clockwise.
    pub(super) spokes: Vec<Spoke>,
    /// Neighbors by what became of them.
    pub(super) fates: [usize; 4],
    /// Neighbors made in the last batch.
    pub(super) young: usize,
    /// Triangles that may go to a new vertex.
    pub(super) free: usize,
    /// The most of them in a row.
    pub(super) free_run: usize,
    /// The share of splits that the neighbors asked before saw, in 1/256.
    pub(super) density: i32,
    /// Mean of the lengths.
    pub(super) length: i32,
    /// Mean of the areas.
    pub(super) area: i32,
    /// Mean of the heights.
    pub(super) height: i32,
    /// All bits of the steps, as long as they are not shifted.
    pub(super) reach: u32,
    /// Bits by which steps were shifted down.
    shift: i32,
}

/// Bits of a step.
const STEP_BITS: i32 = 13;
/// Heights below this are noise of the grid.
const LEAST_HEIGHT: i32 = -512;

/// The logarithm to base 2 in 1/256.
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

/// A sum over a count, rounded down, about; 0 for none.
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
    /// Measures what [`gather`](Self::gather) found.
    pub(super) fn measure(&mut self) {
        self.shift = (32 - STEP_BITS - self.reach.leading_zeros() as i32).max(0);
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
            let behind = &self.spokes[if i + 1 < n { i + 1 } else { 0 }];
            let (next_step, is_open) = (behind.step, behind.is_virtual);
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
            spoke.is_blunt = cosine < 0;
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
            let behind = &self.spokes[if i + 1 < n { i + 1 } else { 0 }];
            if before.is_virtual || behind.is_virtual || self.spokes[i].is_virtual {
                continue;
            }
            let volume = dot_wide(before.normal.map(i64::from), behind.step.map(i64::from));
            let height = 2 * log2_wide(volume.unsigned_abs()) - before.area + 512 * self.shift;
            let height = height.max(LEAST_HEIGHT);
            heights += i64::from(height);
            count += 1;
            self.spokes[i].height = height;
        }
        self.height = mean(heights, count);
    }

    /// The mean length in steps of the grid.
    pub(super) fn grid_length(&self) -> i32 {
        self.length + 512 * self.shift
    }
}

#[cfg(test)]
mod tests {
    use super::super::memory::Memory;
    use super::super::scene::Scene;
    use super::super::tests::surface_of;
    use super::*;
    use crate::refine::walk::{Walk, WalkOrder};
    use crate::topology::surface::triangle_of;

    #[test]
    fn a_flat_hexagon_is_seen_as_one() {
        // Vertex 0 is virtual and closes the hexagon around vertex 1.
        let rim = |i: u32| 2 + i % 6;
        let triangles: Vec<[u32; 3]> =
            (0..6).flat_map(|i| [[1, rim(i), rim(i + 1)], [0, rim(i + 1), rim(i)]]).collect();
        let mut surface = surface_of(&triangles, 8, 1);
        let [x, y] = [500, 866];
        let hexagon = [[2 * x, 0], [x, y], [-x, y], [-2 * x, 0], [-x, -y], [x, -y]];
        let places: Vec<[i32; 3]> =
            [[0; 3], [70, 80, 90]].into_iter().chain(hexagon.map(|[x, y]| [70 + x, 80 + y, 90])).collect();
        let mut walk = Walk::new(WalkOrder::Near);
        walk.begin(&surface);
        let mut memory = Memory::default();
        memory.begin_batch(&surface);
        let corners: Vec<u32> = surface.ring(1).collect();
        surface.set_mark(triangle_of(corners[2]), walk.batch());
        let scene = Scene { surface: &surface, places: &places, walk: &walk, max_patch: 5 };
        let mut ring = Ring::default();
        ring.gather(&scene, &memory, (1, &corners));
        ring.measure();
        assert_eq!((ring.free, ring.free_run, ring.fates), (5, 5, [6, 0, 0, 0]));
        assert!((ring.height - LEAST_HEIGHT).abs() <= 1);
        assert!((ring.grid_length() - 5102).abs() < 4, "{}", ring.grid_length());
        for spoke in &ring.spokes {
            assert!((spoke.length - ring.length).abs() < 4 && (spoke.area - ring.area).abs() < 4);
            // The squared tangent of 60 degrees is 3.
            assert!((spoke.tangent - 406).abs() < 4 && !spoke.is_blunt && spoke.valence == 4);
        }
        // From the rim, the hole is no place.
        let corners: Vec<u32> = surface.ring(2).collect();
        ring.gather(&scene, &memory, (2, &corners));
        ring.measure();
        let open: Vec<_> = ring.spokes.iter().filter(|s| s.is_virtual).collect();
        assert!(open.len() == 1 && open[0].step == [0; 3] && open[0].area == 0);
        assert_eq!(ring.spokes.iter().filter(|s| s.area > 0).count(), 2);
    }
}
