//! The star of one position, gathered once and judged against all its possible targets.
//!
//! The cost of moving the origin `v` to a neighbour `u` is a quadratic form of `u`: the squared distances from the
//! planes of the triangles around v, weighted by area, plus the squared change of volume over the area, all of the
//! *current* mesh (memoryless [LT98], [Hop99]). A plane through v gives no linear part, so six numbers hold
//! the whole form:
//!
//! ```text
//! c_i = (a_i - v) x (b_i - v)       twice the area of triangle i times its normal
//! Q   = sum c_i c_i^T / (2 |c_i|) + N N^T / A,    N = sum c_i / 2,    A = sum |c_i| / 2
//! cost(u) = (u - v)^T Q (u - v)     [length^4]
//! ```
//!
//! Borders of any kind (boundaries, seams, edges with three triangles) are **special** edges: a vertex on some may only
//! move along one of them, and pays the squared area between the old and the new course of the border.

use glam::Vec3;

use super::fan;
use super::links::{LinkEdge, LinkKind, Links};

/// Lanes that sums are spread over, so that they vectorise and give the same bits everywhere.
const LANES: usize = 4;

/// Scratch that holds one star at a time.
#[derive(Debug, Default)]
pub(super) struct Star {
    /// Neighbours, each once; candidates for the target.
    pub(super) ids: Vec<u32>,
    /// Offsets of the neighbours from v; one more for the ring's wrap, then zeros up to whole lanes.
    x: Vec<f32>,
    y: Vec<f32>,
    z: Vec<f32>,
    /// Normals of the triangles, zeros up to whole lanes.
    cx: Vec<f32>,
    cy: Vec<f32>,
    cz: Vec<f32>,
    /// Cost of each neighbour as the target; infinite where it may not be.
    pub(super) costs: Vec<f32>,
    /// Corners of each triangle as indices into `ids`; empty for rings, whose triangle i is (i, i + 1).
    pairs: Vec<[u32; 2]>,
    /// Triangle numbers, where followed.
    pub(super) triangles: Vec<u32>,
    triangle_count: usize,
    /// Area of all triangles, doubled.
    area_doubled: f32,
    edges: Vec<LinkEdge>,
    special: Vec<u32>,
}

impl Star {
    /// Triangles.
    pub(super) fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// Area of the star, in scaled units.
    pub(super) fn area(&self) -> f32 {
        0.5 * self.area_doubled
    }

    /// Neighbour `i` relative to the centre.
    #[inline]
    pub(super) fn offset(&self, i: usize) -> Vec3 {
        Vec3::new(self.x[i], self.y[i], self.z[i])
    }

    /// Unscaled normal of triangle `t`.
    #[inline]
    pub(super) fn normal(&self, t: usize) -> Vec3 {
        Vec3::new(self.cx[t], self.cy[t], self.cz[t])
    }

    /// Sum of the normals: the normal of any surface with this border.
    pub(super) fn mean_normal(&self) -> Vec3 {
        (0..self.triangle_count).map(|t| self.normal(t)).sum()
    }

    /// The two neighbours that span triangle `t`.
    #[inline]
    pub(super) fn triangle(&self, t: usize) -> [usize; 2] {
        if self.pairs.is_empty() {
            [t, if t + 1 == self.ids.len() { 0 } else { t + 1 }]
        } else {
            self.pairs[t].map(|i| i as usize)
        }
    }

    /// Gathers the star of `v`, triangle numbers included where links follow them.
    pub(super) fn gather(&mut self, links: &Links, positions: &[[f32; 4]], v: u32) {
        self.pairs.clear();
        match links.kind(v) {
            LinkKind::Closed | LinkKind::Open => {
                self.ids.clear();
                self.ids.extend_from_slice(links.entries(v));
                self.triangle_count = links.triangle_count(v);
                if links.follows_triangles() {
                    self.triangles.clear();
                    self.triangles.extend_from_slice(&links.entry_triangles(v)[..self.triangle_count]);
                }
            }
            LinkKind::Empty | LinkKind::Edges => self.gather_edges(links, v),
        }
        self.load_offsets(positions, v);
        self.compute_normals();
    }

    fn gather_edges(&mut self, links: &Links, v: u32) {
        links.edges_into(v, &mut self.edges);
        self.triangle_count = self.edges.len();
        self.ids.clear();
        self.ids.extend(self.edges.iter().flat_map(|e| [e.a, e.b]));
        self.ids.sort_unstable();
        self.ids.dedup();
        let place = |id: u32| self.ids.binary_search(&id).unwrap_or(0) as u32;
        self.pairs.extend(self.edges.iter().map(|e| [place(e.a), place(e.b)]));
        self.triangles.clear();
        self.triangles.extend(self.edges.iter().map(|e| e.triangle));
    }

    fn load_offsets(&mut self, positions: &[[f32; 4]], v: u32) {
        let n = self.ids.len();
        let padded = (n + 1).next_multiple_of(LANES) + LANES;
        for array in [&mut self.x, &mut self.y, &mut self.z] {
            array.resize(padded, 0.0);
        }
        let [vx, vy, vz, _] = positions[v as usize];
        let (x, y, z) = (&mut self.x[..padded], &mut self.y[..padded], &mut self.z[..padded]);
        for (i, &id) in self.ids.iter().enumerate() {
            let [px, py, pz, _] = positions[id as usize];
            x[i] = px - vx;
            y[i] = py - vy;
            z[i] = pz - vz;
        }
        for array in [x, y, z] {
            let first = array[0];
            array[n..].fill(0.0);
            array[n] = first;
        }
    }

    fn compute_normals(&mut self) {
        let m = self.triangle_count;
        let padded = m.next_multiple_of(LANES);
        for array in [&mut self.cx, &mut self.cy, &mut self.cz] {
            array.resize(padded, 0.0);
        }
        let (cx, cy, cz) = (&mut self.cx[..padded], &mut self.cy[..padded], &mut self.cz[..padded]);
        if self.pairs.is_empty() {
            let (x, y, z) = (&self.x[..padded + 1], &self.y[..padded + 1], &self.z[..padded + 1]);
            for i in 0..padded {
                cx[i] = y[i] * z[i + 1] - z[i] * y[i + 1];
                cy[i] = z[i] * x[i + 1] - x[i] * z[i + 1];
                cz[i] = x[i] * y[i + 1] - y[i] * x[i + 1];
            }
        } else {
            for (i, &[a, b]) in self.pairs.iter().enumerate() {
                let (a, b) = (a as usize, b as usize);
                cx[i] = self.y[a] * self.z[b] - self.z[a] * self.y[b];
                cy[i] = self.z[a] * self.x[b] - self.x[a] * self.z[b];
                cz[i] = self.x[a] * self.y[b] - self.y[a] * self.x[b];
            }
        }
        // Lanes past the last triangle must not count.
        for array in [cx, cy, cz] {
            array[m..].fill(0.0);
        }
    }

    /// Fills `costs` with the quadratic form at every neighbour.
    pub(super) fn compute_costs(&mut self) {
        let [xx, yy, zz, xy, xz, yz] = self.quadric();
        let n = self.ids.len();
        let padded = n.next_multiple_of(LANES);
        self.costs.resize(padded, 0.0);
        let (x, y, z) = (&self.x[..padded], &self.y[..padded], &self.z[..padded]);
        for (i, cost) in self.costs[..padded].iter_mut().enumerate() {
            let form = xx * x[i] * x[i]
                + yy * y[i] * y[i]
                + zz * z[i] * z[i]
                + 2.0 * (xy * x[i] * y[i] + xz * x[i] * z[i] + yz * y[i] * z[i]);
            // Rounding may leave a tiny negative number where the form is zero.
            *cost = form.max(0.0);
        }
        self.costs.truncate(n);
    }

    /// The form of this module's header: xx, yy, zz, xy, xz, yz.
    fn quadric(&mut self) -> [f32; 6] {
        let padded = self.triangle_count.next_multiple_of(LANES);
        let (cx, cy, cz) = (&self.cx[..padded], &self.cy[..padded], &self.cz[..padded]);
        // xx yy zz xy xz yz | nx ny nz | area
        let mut sums = [[0.0f32; LANES]; 10];
        for i in (0..padded).step_by(LANES) {
            for lane in 0..LANES {
                let (x, y, z) = (cx[i + lane], cy[i + lane], cz[i + lane]);
                let length = (x * x + y * y + z * z).sqrt();
                let weight = 0.5 / length.max(f32::MIN_POSITIVE);
                sums[0][lane] += weight * x * x;
                sums[1][lane] += weight * y * y;
                sums[2][lane] += weight * z * z;
                sums[3][lane] += weight * x * y;
                sums[4][lane] += weight * x * z;
                sums[5][lane] += weight * y * z;
                sums[6][lane] += x;
                sums[7][lane] += y;
                sums[8][lane] += z;
                sums[9][lane] += length;
            }
        }
        let [xx, yy, zz, xy, xz, yz, nx, ny, nz, area] = sums.map(|[a, b, c, d]| (a + c) + (b + d));
        self.area_doubled = area;
        // N and A are both doubled: half of the doubled quotient is left.
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

    /// Restricts the candidates to the special edges of `v` and adds what leaving their course costs.
    ///
    /// `is_seam(i, j)` says whether triangles `i` and `j` show v different wedges.
    pub(super) fn apply_borders(&mut self, kind: LinkKind, is_seam: Option<&dyn Fn(usize, usize) -> bool>) {
        if kind == LinkKind::Closed && is_seam.is_none() {
            return;
        }
        if kind == LinkKind::Open && is_seam.is_none() {
            let last = self.ids.len() - 1;
            let swept = BORDER_WEIGHT * self.offset(0).cross(self.offset(last)).length_squared();
            let (first_cost, last_cost) = (self.costs[0] + swept, self.costs[last] + swept);
            self.costs.fill(f32::INFINITY);
            (self.costs[0], self.costs[last]) = (first_cost, last_cost);
            return;
        }
        self.find_special(is_seam);
        if self.special.is_empty() {
            return;
        }
        let special = std::mem::take(&mut self.special);
        let mut costs = std::mem::take(&mut self.costs);
        for (i, cost) in costs.iter_mut().enumerate() {
            if special.binary_search(&(i as u32)).is_err() {
                *cost = f32::INFINITY;
                continue;
            }
            let u = self.offset(i);
            let swept = |&j: &u32| self.offset(j as usize).cross(u).length_squared();
            *cost += BORDER_WEIGHT * special.iter().filter(|&&j| j as usize != i).map(swept).sum::<f32>();
            if special.len() == 1 {
                // The border ends here and would recede.
                *cost += u.length_squared() * u.length_squared();
            }
        }
        (self.special, self.costs) = (special, costs);
    }

    fn find_special(&mut self, is_seam: Option<&dyn Fn(usize, usize) -> bool>) {
        self.special.clear();
        for i in 0..self.ids.len() {
            let mut before = None;
            let mut after = None;
            let mut count = 0;
            for t in 0..self.triangle_count {
                let [a, b] = self.triangle(t);
                if a == i {
                    after = Some(t);
                    count += 1;
                }
                if b == i {
                    before = Some(t);
                    count += 1;
                }
            }
            let is_inner = match (before, after) {
                (Some(t), Some(s)) if count == 2 => !is_seam.is_some_and(|f| f(t, s)),
                _ => false,
            };
            if !is_inner {
                self.special.push(i as u32);
            }
        }
    }

    /// What replaces the star if neighbour `k` is the target; `None` where a triangle would flip or become a sliver.
    pub(super) fn fan(&self, k: usize) -> Option<Fan> {
        let u = self.offset(k);
        let mean = self.mean_normal();
        let mut distance_squared = f32::INFINITY;
        for t in 0..self.triangle_count {
            let [i, j] = self.triangle(t);
            if i == k || j == k {
                continue;
            }
            let (a, b) = (self.offset(i), self.offset(j));
            if !fan::may_replace(u, a, b, self.normal(t), mean) {
                return None;
            }
            distance_squared = distance_squared.min(fan::distance_squared(u, a, b));
        }
        if distance_squared == f32::INFINITY {
            // No triangle is left (the last one of a border): the edges of the old ones are what remains.
            for t in 0..self.triangle_count {
                let [i, j] = self.triangle(t);
                distance_squared =
                    distance_squared.min(fan::distance_squared(u, self.offset(i), self.offset(j)));
            }
        }
        let off = distance_squared + self.protrusion_squared(k, u);
        Some(Fan { distance_squared, cost: (self.area() + SPIKE_WEIGHT * off) * off })
    }

    /// How far the fan's new edges stick out: the largest squared distance of their midpoints from the old star.
    ///
    /// The distance of v alone does not see a fan that bridges a valley.
    fn protrusion_squared(&self, k: usize, u: Vec3) -> f32 {
        if self.triangle_count < 4 {
            return 0.0;
        }
        let mut worst = 0.0f32;
        for i in 0..self.ids.len() {
            if i == k || self.is_edge(i, k) {
                continue;
            }
            let middle = 0.5 * (self.offset(i) + u);
            let mut least = f32::INFINITY;
            for t in 0..self.triangle_count {
                let [a, b] = self.triangle(t);
                least = least.min(fan::distance_squared(
                    -middle,
                    self.offset(a) - middle,
                    self.offset(b) - middle,
                ));
            }
            worst = worst.max(least);
        }
        worst
    }

    /// True where neighbours `i` and `k` span a triangle with v.
    fn is_edge(&self, i: usize, k: usize) -> bool {
        if self.pairs.is_empty() {
            let (low, high) = (i.min(k), i.max(k));
            let wraps = self.triangle_count == self.ids.len();
            high - low == 1 || (wraps && low == 0 && high + 1 == self.ids.len())
        } else {
            (0..self.triangle_count).any(|t| {
                let pair = self.triangle(t);
                pair.contains(&i) && pair.contains(&k)
            })
        }
    }
}

/// How a fan compares with the star it replaces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fan {
    /// Squared distance of v from it.
    pub(super) distance_squared: f32,
    /// What its distances add to the cost of the collapse, scaled units to the fourth.
    pub(super) cost: f32,
}

/// Weight of the area between the old and the new course of a border; 1 to 50 differ little in RMS, and small ones lose
/// thin ears of the boundary early.
const BORDER_WEIGHT: f32 = 4.0;
/// Area, in squared distances, that a spike counts for beyond the area of its star: thin spikes have next to none,
/// but they are seen.
const SPIKE_WEIGHT: f32 = 32.0;
