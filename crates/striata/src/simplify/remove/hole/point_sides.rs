//! Determines which points lie over which triangle of the ring.
//!
//! Each diagonal separates the points; those of a triangle are on its side of all three edges. Each point is
//! then over exactly one triangle of any triangulation, so sums over points are sums over triangles.

use super::{Hole, RingTriangle};
use crate::simplify::collapse::costs::TrackedVertex;

impl Hole {
    /// Computes on which side of each diagonal the points lie.
    pub(super) fn compute_sides(&mut self, points: &[TrackedVertex]) {
        self.words = points.len().div_ceil(64);
        self.left.clear();
        self.left.resize(self.n * self.n * self.words, 0);
        for i in 0..self.n {
            for j in i + 1..self.n {
                let at = (i * self.n + j) * self.words;
                let is_side = self.is_side(i, j);
                let words = &mut self.left[at..at + self.words];
                if j == i + 1 {
                    words.fill(u64::MAX);
                } else if !is_side {
                    let from = self.ring[i];
                    let across = self.facing[i][j].cross(self.ring[j] - from);
                    let threshold = across.dot(from);
                    for (word, points) in words.iter_mut().zip(points.chunks(64)) {
                        for (bit, point) in points.iter().enumerate() {
                            *word |= u64::from(across.dot(point.at) > threshold) << bit;
                        }
                    }
                }
            }
        }
    }

    fn left_of(&self, i: usize, j: usize, word: usize) -> u64 {
        self.left[(i * self.n + j) * self.words + word]
    }

    /// Calls `f` with the points that lie over a triangle of the ring.
    #[inline]
    pub(super) fn for_each_point_over(
        &self,
        [i, j, k]: [usize; 3],
        points: &[TrackedVertex],
        mut f: impl FnMut(&TrackedVertex),
    ) {
        for (word, points) in points.chunks(64).enumerate() {
            let mut bits = self.left_of(i, j, word) & self.left_of(j, k, word) & !self.left_of(i, k, word);
            bits &= u64::MAX >> (64 - points.len());
            while bits != 0 {
                f(&points[bits.trailing_zeros() as usize]);
                bits &= bits - 1;
            }
        }
    }

    /// Returns the sum of the weighted squared heights of the points over the triangles of a floor, and
    /// the largest squared height.
    ///
    /// The points must be those of the last search.
    pub(in crate::simplify::remove) fn point_heights(
        &self,
        floor: &[RingTriangle],
        points: &[TrackedVertex],
    ) -> (f32, f32) {
        let (mut sum, mut worst) = (0.0, 0.0f32);
        for &triangle in floor {
            let corners = triangle.map(usize::from);
            let [a, b, c] = corners.map(|i| self.ring[i]);
            let normal = (b - a).cross(c - a);
            let inverse = 1.0 / normal.length_squared().max(f32::MIN_POSITIVE);
            self.for_each_point_over(corners, points, |point| {
                let height = normal.dot(point.at - a);
                let squared = height * height * inverse;
                sum += point.weight * squared;
                worst = worst.max(squared);
            });
        }
        (sum, worst)
    }
}
