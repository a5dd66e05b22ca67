//! The star of one position, gathered once and evaluated for all its possible targets.
//!
//! The cost of moving the origin `v` to a neighbor `u` is a quadratic form of `u`: the squared
//! distances from the planes of the triangles around `v`, weighted by area, plus the squared change of
//! volume over the area, all of the *current* mesh (memoryless [LT98], [Hop99]). Planes through `v`
//! give no linear part, so the whole form has six coefficients:
//!
//! ```text
//! c_i = (a_i - v) x (b_i - v)       twice the area of triangle i times its normal
//! Q   = sum c_i c_i^T / (2 |c_i|) + N N^T / A,    N = sum c_i / 2,    A = sum |c_i| / 2
//! cost(u) = (u - v)^T Q (u - v)     [length^4]
//! ```
//!
//! Borders of any kind (boundaries, edges with three triangles, seams) restrict the candidates: a
//! vertex on a border may only move along an edge of its strongest kind of border, and the cost includes the
//! squared area between the old and the new path of every border.
//!
//! The full cost of a candidate includes the distances of its fan (see [`Star::distance_cost`]).
//! Triangles are processed eight at a time; sums are folded in a fixed order, so that results are the
//! same on every machine.

mod border_edge;
mod borders;
mod candidate;
mod lanes;
mod ring;

use glam::Vec3;
use wide::{f32x4, f32x8};

use super::links::Links;
use border_edge::BorderEdge;
use lanes::{Coordinates, LANES, Vec3x8, ensure_len, lane_sum, load_four, slices, vector_starts};
pub(in crate::simplify) use ring::{EdgeSides, StarRing};

/// Area, as a multiple of the squared distance, that a spike counts for in addition to the area of its
/// star: thin spikes have almost no area, but are visible.
const SPIKE_WEIGHT: f32 = 32.0;

/// Function that returns the squared difference of attributes between two triangles of a star if they
/// use different wedges of the center.
pub(in crate::simplify) type SeamBetween<'a> = &'a dyn Fn(&Star, usize, usize) -> Option<f32>;

/// Scratch for the star of one position at a time.
#[derive(Debug, Default)]
pub(in crate::simplify) struct Star {
    /// Neighbors, which are the candidates for the target, and triangles.
    pub ring: StarRing,
    /// Neighbors relative to `v`, then the first one again for rings, then zeros up to whole lanes.
    offsets: Coordinates,
    /// Both corners of each triangle if they are not consecutive neighbors.
    corners: [Coordinates; 2],
    /// Unscaled normals of the triangles, then zeros up to whole lanes.
    normals: Coordinates,
    /// Cost of each neighbor as the target; infinite if it is not allowed.
    pub costs: Vec<f32>,
    /// Coefficients of the quadratic form: xx, yy, zz, xy, xz, yz.
    form: [f32; 6],
    /// Doubled area of all triangles.
    area_doubled: f32,
    /// Sum of the normals, which is the same for any surface with this border.
    mean_normal: Vec3,
    /// 1 for triangles that a candidate removes, `NO_TRIANGLE` in lanes past the last triangle, otherwise 0.
    vanishes: Vec<f32>,
    /// Midpoints of new edges, and their squared distances from the old triangles.
    middles: Vec<(Vec3, f32x8)>,
    border_edges: Vec<BorderEdge>,
    /// The vertex of the center that each triangle uses, if
    /// [`Wedges::load_center_wedges`](super::wedges::Wedges::load_center_wedges) was called.
    pub center_wedges: Vec<u32>,
}

impl Star {
    /// Area of the star, in scaled units.
    pub(in crate::simplify) fn area(&self) -> f32 {
        0.5 * self.area_doubled
    }

    /// Squared length of the longest edge of the star.
    pub(in crate::simplify) fn longest_edge_squared(&self) -> f32 {
        let spokes = (0..self.ring.ids.len()).map(|i| self.offset(i).length_squared());
        let rim = (0..self.ring.triangle_count()).map(|t| {
            let [a, b] = self.ring.triangle(t).map(|i| self.offset(i));
            (a - b).length_squared()
        });
        spokes.chain(rim).fold(0.0, f32::max)
    }

    /// Position of neighbor `i` relative to the center.
    #[inline]
    pub(in crate::simplify) fn offset(&self, i: usize) -> Vec3 {
        let [x, y, z] = &self.offsets;
        Vec3::new(x[i], y[i], z[i])
    }

    /// Returns the first and second corners of all triangles.
    #[inline]
    fn corners(&self) -> [[&[f32]; 3]; 2] {
        match self.ring.pairs() {
            None => [slices(&self.offsets, 0), slices(&self.offsets, 1)],
            Some(_) => [slices(&self.corners[0], 0), slices(&self.corners[1], 0)],
        }
    }

    /// Gathers the star of `v`, with triangle indices if the links store them.
    pub(in crate::simplify) fn gather(&mut self, links: &Links, positions: &[[f32; 4]], v: u32) {
        self.ring.gather(links, v);
        self.load_offsets(positions, v);
        self.compute_normals();
    }

    fn load_offsets(&mut self, positions: &[[f32; 4]], v: u32) {
        let n = self.ring.ids.len();
        // Leaves room for a whole SIMD vector after the repeated first entry.
        let padded = n + 1 + 2 * LANES;
        self.offsets.iter_mut().for_each(|array| ensure_len(array, padded));
        let [vx, vy, vz, _] = positions[v as usize];
        let [x, y, z] = &mut self.offsets;
        let (x, y, z) = (&mut x[..padded], &mut y[..padded], &mut z[..padded]);
        for (i, &id) in self.ring.ids.iter().enumerate() {
            let [px, py, pz, _] = positions[id as usize];
            x[i] = px - vx;
            y[i] = py - vy;
            z[i] = pz - vz;
        }
        for array in [x, y, z] {
            array[n] = array[0];
            array[n + 1..n + 1 + LANES].copy_from_slice(&[0.0; LANES]);
        }
        let Some(pairs) = self.ring.pairs() else { return };
        let padded = self.ring.triangle_count().next_multiple_of(LANES) + LANES;
        for (side, corners) in self.corners.iter_mut().enumerate() {
            for (offsets, corners) in self.offsets.iter().zip(corners) {
                ensure_len(corners, padded);
                for (corner, pair) in corners.iter_mut().zip(pairs) {
                    *corner = offsets[pair[side] as usize];
                }
            }
        }
    }

    fn compute_normals(&mut self) {
        let m = self.ring.triangle_count();
        let mut normals = std::mem::take(&mut self.normals);
        normals.iter_mut().for_each(|array| ensure_len(array, m + 2 * LANES));
        let [a, b] = self.corners();
        for t in vector_starts(m) {
            let normal = Vec3x8::load(a, t).cross(Vec3x8::load(b, t));
            for (array, lanes) in normals.iter_mut().zip([normal.x, normal.y, normal.z]) {
                array[t..t + LANES].copy_from_slice(&lanes.to_array());
            }
        }
        for array in &mut normals {
            array[m..m + LANES].copy_from_slice(&[0.0; LANES]);
        }
        self.normals = normals;
    }

    /// Fills `costs` with the value of the quadratic form at every neighbor.
    pub(in crate::simplify) fn compute_costs(&mut self) {
        self.form = self.quadric();
        let [xx, yy, zz, xy, xz, yz] = self.form.map(f32x8::splat);
        let n = self.ring.ids.len();
        self.costs.clear();
        let offsets = slices(&self.offsets, 0);
        for i in vector_starts(n) {
            let Vec3x8 { x, y, z } = Vec3x8::load(offsets, i);
            let mixed = xy * x * y + xz * x * z + yz * y * z;
            let form = xx * x * x + yy * y * y + zz * z * z + (mixed + mixed);
            // Rounding may give a tiny negative number if the form is zero.
            self.costs.extend(form.fast_max(f32x8::ZERO).to_array());
        }
        self.costs.truncate(n);
    }

    /// Value of the quadratic form at a position that need not be a neighbor.
    pub(in crate::simplify) fn cost_at(&self, at: Vec3) -> f32 {
        let [xx, yy, zz, xy, xz, yz] = self.form;
        let Vec3 { x, y, z } = at;
        let mixed = xy * x * y + xz * x * z + yz * y * z;
        (xx * x * x + yy * y * y + zz * z * z + (mixed + mixed)).max(0.0)
    }

    /// Returns the quadratic form of the module header: xx, yy, zz, xy, xz, yz.
    fn quadric(&mut self) -> [f32; 6] {
        // Sums: xx yy zz xy xz yz | nx ny nz | area.
        let mut sums = [f32x4::ZERO; 10];
        for t in (0..self.ring.triangle_count()).step_by(4) {
            let [x, y, z] = &self.normals;
            let (x, y, z) = (load_four(x, t), load_four(y, t), load_four(z, t));
            let length = (x * x + y * y + z * z).sqrt();
            let weight = f32x4::splat(0.5) / length.fast_max(f32x4::splat(f32::MIN_POSITIVE));
            let (wx, wy, wz) = (weight * x, weight * y, weight * z);
            let terms = [wx * x, wy * y, wz * z, wx * y, wx * z, wy * z, x, y, z, length];
            for (sum, term) in sums.iter_mut().zip(terms) {
                *sum += term;
            }
        }
        let mut folded = [0.0; 10];
        folded.iter_mut().zip(sums).for_each(|(out, sum)| *out = lane_sum(sum));
        let [xx, yy, zz, xy, xz, yz, nx, ny, nz, area] = folded;
        self.area_doubled = area;
        self.mean_normal = Vec3::new(nx, ny, nz);
        // N and A are both doubled, so half of the doubled quotient remains.
        let weight = 0.5 / area.max(f32::MIN_POSITIVE);
        [
            xx + weight * nx * nx,
            yy + weight * ny * ny,
            zz + weight * nz * nz,
            xy + weight * nx * ny,
            xz + weight * nx * nz,
            yz + weight * ny * nz,
        ]
    }

    /// Cost of a squared distance from `v` over the area of the star.
    pub(in crate::simplify) fn distance_cost(&self, squared: f32) -> f32 {
        (self.area() + SPIKE_WEIGHT * squared) * squared
    }

    /// Returns the candidate with the least cost so far; the first one in a tie.
    pub(in crate::simplify) fn cheapest(&self) -> Option<(usize, f32)> {
        let mut best = None;
        let mut least = f32::INFINITY;
        for (k, &cost) in self.costs.iter().enumerate() {
            if cost < least {
                least = cost;
                best = Some(k);
            }
        }
        best.map(|k| (k, least))
    }
}
