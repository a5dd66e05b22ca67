//! Sample points on a surface, distributed by area and by edge length.
//!
//! Samples are stratified: sample `k` of `n` lies in the triangle in which the running sum of the weights
//! passes `k / n`, at the next point of a low-discrepancy sequence. Sample points are computed when they
//! are needed and never stored.

use std::ops::Range;

use glam::DVec3;

use super::triangle_tree::to_dvec3;
use super::{IndexedMesh, Random};

/// Number of area samples for each sample on an edge.
const AREA_SAMPLES_PER_EDGE_SAMPLE: usize = 4;

/// Number of samples that one task measures; fixed, so that sums do not depend on the number of threads.
pub(super) const CHUNK_SIZE: usize = 4_096;

/// A sample point on the area of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceSample {
    /// Position, in mesh units.
    pub point: [f64; 3],
    /// Index of the triangle that contains it.
    pub triangle: usize,
    /// Barycentric coordinates in that triangle.
    pub weights: [f64; 3],
}

/// The sample points of one surface, computed on demand.
pub struct SurfaceSamples<'a> {
    pub(super) mesh: &'a IndexedMesh,
    pub(super) used_vertices: Vec<u32>,
    pub(super) sides: Strata,
    pub(super) areas: Strata,
    pub(super) seed: u64,
}

impl<'a> SurfaceSamples<'a> {
    /// Places `sample_count` samples on the area and a quarter as many on the edges.
    ///
    /// # Panics
    /// If [`IndexedMesh::check`] fails with an index out of range.
    pub fn new(mesh: &'a IndexedMesh, sample_count: usize, seed: u64) -> Self {
        let mut used = vec![false; mesh.positions.len()];
        for &v in mesh.triangles.iter().flatten() {
            used[v as usize] = true;
        }
        let mut random = Random::new(seed);
        let areas = mesh.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| to_dvec3(mesh.positions[v as usize]));
            (b - a).cross(c - a).length()
        });
        let lengths = mesh.triangles.iter().map(|t| {
            let [a, b, c] = t.map(|v| to_dvec3(mesh.positions[v as usize]));
            (b - a).length() + (c - b).length() + (a - c).length()
        });
        Self {
            mesh,
            used_vertices: (0..used.len() as u32).filter(|&v| used[v as usize]).collect(),
            areas: Strata::new(areas, sample_count, random.unit()),
            sides: Strata::new(lengths, sample_count.div_ceil(AREA_SAMPLES_PER_EDGE_SAMPLE), random.unit()),
            seed: random.next_u64(),
        }
    }

    /// Calls `measure` with chunks of the samples on the area, on several threads if enabled.
    ///
    /// Returns the results in the order of the samples. There are no samples if the area is 0.
    pub fn map_area_chunks<T: Send>(
        &self,
        measure: impl Fn(&mut dyn Iterator<Item = SurfaceSample>) -> T + Sync,
    ) -> Vec<T> {
        let sample = |(k, triangle)| {
            let uv = low_discrepancy_point(self.seed, k);
            let point = self.point_on_triangle(triangle, uv).to_array();
            SurfaceSample { point, triangle, weights: weights_on_triangle(uv) }
        };
        map_chunks(0..self.areas.count(), |range| measure(&mut self.areas.samples(range).map(sample)))
    }

    pub(super) fn point_count(&self) -> usize {
        self.used_vertices.len() + self.sides.count() + self.areas.count()
    }

    fn corners(&self, triangle: usize) -> [DVec3; 3] {
        self.mesh.triangles[triangle].map(|v| to_dvec3(self.mesh.positions[v as usize]))
    }

    /// Point on the perimeter of a triangle; `u` from 0 to 1 goes around it once, at constant speed.
    pub(super) fn point_on_side(&self, triangle: usize, u: f64) -> DVec3 {
        let [a, b, c] = self.corners(triangle);
        let lengths = [(b - a).length(), (c - b).length(), (a - c).length()];
        let mut along = u * (lengths[0] + lengths[1] + lengths[2]);
        for ((start, end), length) in [(a, b), (b, c), (c, a)].into_iter().zip(lengths) {
            if along < length {
                return start.lerp(end, along / length);
            }
            along -= length;
        }
        a
    }

    /// Point of a triangle; points distributed evenly over the unit square are distributed evenly over the
    /// triangle.
    pub(super) fn point_on_triangle(&self, triangle: usize, uv: [f64; 2]) -> DVec3 {
        let [a, b, c] = self.corners(triangle);
        let [_, v, w] = weights_on_triangle(uv);
        a + v * (b - a) + w * (c - a)
    }
}

/// Barycentric coordinates for a point of the unit square, whose upper half is folded onto the lower one:
/// areas stay in proportion.
fn weights_on_triangle([u, v]: [f64; 2]) -> [f64; 3] {
    let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
    [1.0 - u - v, u, v]
}

/// Point `k` of Roberts' two-dimensional R2 sequence, whose first `n` points are evenly spread for every `n`.
pub(super) fn low_discrepancy_point(seed: u64, k: usize) -> [f64; 2] {
    // 2^64 divided by the plastic number and by its square; wrapping arithmetic takes the fractional part
    // exactly.
    const STEPS: [u64; 2] = [0xC13F_A9A9_02A6_328F, 0x91E1_0DA5_C79E_7B1D];
    let starts = [seed, seed.rotate_left(32)];
    std::array::from_fn(|d| {
        let bits = starts[d].wrapping_add(STEPS[d].wrapping_mul(k as u64));
        (bits >> 11) as f64 / (1u64 << 53) as f64
    })
}

/// Samples assigned to triangles in proportion to a weight, by systematic sampling.
pub(super) struct Strata {
    /// Index of the first sample of each triangle, followed by the sample count.
    first: Vec<usize>,
}

impl Strata {
    /// Assigns `count` samples, or none if all weights are 0; `shift` in 0..1 offsets all of them.
    pub(super) fn new(weights: impl Iterator<Item = f64> + Clone, count: usize, shift: f64) -> Self {
        let total: f64 = weights.clone().sum();
        let mut first = vec![0];
        let mut sum = 0.0;
        let scale = if total > 0.0 { count as f64 / total } else { 0.0 };
        for weight in weights {
            sum += weight;
            first.push(((sum * scale + shift) as usize).min(count));
        }
        // Rounding must not lose the last sample.
        if total > 0.0
            && let Some(last) = first.last_mut()
        {
            *last = count;
        }
        Self { first }
    }

    pub(super) fn count(&self) -> usize {
        self.first[self.first.len() - 1]
    }

    /// Returns every sample of the range, with its triangle.
    pub(super) fn samples(&self, range: Range<usize>) -> impl Iterator<Item = (usize, usize)> {
        let mut triangle = self.first.partition_point(|&first| first <= range.start) - 1;
        range.map(move |k| {
            while self.first[triangle + 1] <= k {
                triangle += 1;
            }
            (k, triangle)
        })
    }
}

/// Calls `measure` for a range in chunks, on several threads if enabled; returns the results in order.
pub(super) fn map_chunks<T: Send>(all: Range<usize>, measure: impl Fn(Range<usize>) -> T + Sync) -> Vec<T> {
    let chunk = |index: usize| {
        let start = all.start + index * CHUNK_SIZE;
        measure(start..(start + CHUNK_SIZE).min(all.end))
    };
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        (0..all.len().div_ceil(CHUNK_SIZE)).into_par_iter().map(chunk).collect()
    }
    #[cfg(not(feature = "parallel"))]
    (0..all.len().div_ceil(CHUNK_SIZE)).map(chunk).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_proportional_to_area() {
        let strata = Strata::new([1.0, 0.0, 3.0, 0.5].into_iter(), 900, 0.3);
        assert_eq!(strata.first, vec![0, 200, 200, 800, 900]);
        let mut dealt = [0; 4];
        strata.samples(150..850).for_each(|(_, t)| dealt[t] += 1);
        assert_eq!(dealt, [50, 0, 600, 50]);
        assert_eq!(Strata::new([0.0, 0.0].into_iter(), 10, 0.5).count(), 0);
    }
}
