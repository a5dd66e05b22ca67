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
//! Borders of any kind (boundaries, edges with three triangles, seams) are **special** edges: a vertex on some may only
//! move along one of the strongest kind, and pays the squared area between the old and the new course of all.
//!
//! A candidate that survives pays for the distances of the fan that it leaves (see [`Star::distance_cost`]). Triangles
//! are worked on eight at a time; sums are folded in a fixed order, so results are the same on every machine.

use glam::Vec3;
use wide::{f32x4, f32x8};

use super::fan;
use super::links::{LinkEdge, LinkKind, Links};

/// Triangles in one vector.
const LANES: usize = 8;

/// Marks lanes past the last triangle.
const NO_TRIANGLE: f32 = 2.0;

/// What makes an edge special, the weakest first: a vertex moves along the strongest that it is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Border {
    /// Its triangles show different wedges.
    Seam,
    /// It has three or more triangles, or two that disagree about its direction.
    Branch,
    /// It has one triangle.
    Boundary,
}

/// An edge of the star that lies on a border.
#[derive(Clone, Copy, Debug)]
struct Special {
    neighbor: u32,
    border: Border,
    /// Squared difference of the attributes on both sides of a seam; infinite for other borders, and for seams that must stay.
    difference_squared: f32,
}

impl Special {
    /// What it costs that this edge's end moves so that twice the area of `swept_squared`, squared, is swept.
    fn leave_cost(&self, swept_squared: f32) -> f32 {
        let course = BORDER_WEIGHT * swept_squared;
        if self.difference_squared == f32::INFINITY {
            return course;
        }
        course.min(0.5 * swept_squared.sqrt() * self.difference_squared)
    }

    /// What it costs that the border, whose only edge this is, recedes by a squared length.
    fn recede_cost(&self, length_squared: f32) -> f32 {
        (length_squared * length_squared).min(length_squared * self.difference_squared)
    }
}

/// For two triangles of a star, the squared difference of attributes if they show the center as different wedges.
pub(in crate::simplify) type SeamBetween<'a> = &'a dyn Fn(&Star, usize, usize) -> Option<f32>;

/// Three coordinates of many points.
type Coordinates = [Vec<f32>; 3];

/// Scratch that holds one star at a time.
#[derive(Debug, Default)]
pub(in crate::simplify) struct Star {
    /// Neighbours, each once; candidates for the target.
    pub(in crate::simplify) ids: Vec<u32>,
    /// Neighbours relative to v; one more for the ring's wrap, then zeros up to whole lanes.
    offsets: Coordinates,
    /// Corners of each triangle as indices into `ids`; empty for rings, whose triangle i is (i, i + 1).
    pairs: Vec<[u32; 2]>,
    /// Both corners of each triangle where `pairs` is in use.
    corners: [Coordinates; 2],
    /// Unscaled normals of the triangles, zeros up to whole lanes.
    normals: Coordinates,
    /// Cost of each neighbour as the target; infinite where it may not be.
    pub(in crate::simplify) costs: Vec<f32>,
    /// Triangle numbers, where followed.
    pub(in crate::simplify) triangles: Vec<u32>,
    triangle_count: usize,
    /// The quadratic form: xx, yy, zz, xy, xz, yz.
    form: [f32; 6],
    /// Area of all triangles, doubled.
    area_doubled: f32,
    /// Sum of the normals: the normal of any surface with this border.
    mean_normal: Vec3,
    /// 1 in the lanes of triangles that a candidate makes vanish, `NO_TRIANGLE` past the last one.
    vanishes: Vec<f32>,
    /// Midpoints of new edges, and their squared distances from the old triangles.
    middles: Vec<(Vec3, f32x8)>,
    edges: Vec<LinkEdge>,
    special: Vec<Special>,
    /// The vertex of the center that each triangle shows, if [`Wedges::load`](super::wedges::Wedges::load) was called.
    pub(in crate::simplify) shown: Vec<u32>,
}

/// Eight floats from `index` on; every array is padded so that they are there.
#[inline]
fn lanes(array: &[f32], index: usize) -> f32x8 {
    f32x8::new(array[index..].first_chunk().copied().unwrap_or([0.0; LANES]))
}

/// Sum in a fixed order.
#[inline]
fn fold(sums: f32x4) -> f32 {
    let [a, b, c, d] = sums.to_array();
    (a + c) + (b + d)
}

/// Three vectors at once.
#[derive(Clone, Copy)]
struct Vec3x8 {
    x: f32x8,
    y: f32x8,
    z: f32x8,
}

impl Vec3x8 {
    #[inline]
    fn load([x, y, z]: [&[f32]; 3], index: usize) -> Self {
        Self { x: lanes(x, index), y: lanes(y, index), z: lanes(z, index) }
    }

    #[inline]
    fn splat(v: Vec3) -> Self {
        Self { x: f32x8::splat(v.x), y: f32x8::splat(v.y), z: f32x8::splat(v.z) }
    }

    #[inline]
    fn dot(self, o: Self) -> f32x8 {
        self.x * o.x + self.y * o.y + self.z * o.z
    }

    #[inline]
    fn cross(self, o: Self) -> Self {
        Self {
            x: self.y * o.z - self.z * o.y,
            y: self.z * o.x - self.x * o.z,
            z: self.x * o.y - self.y * o.x,
        }
    }

    #[inline]
    fn minus(self, o: Self) -> Self {
        Self { x: self.x - o.x, y: self.y - o.y, z: self.z - o.z }
    }
}

/// Slices of three arrays from `first` on.
#[inline]
fn slices(arrays: &Coordinates, first: usize) -> [&[f32]; 3] {
    [&arrays[0][first..], &arrays[1][first..], &arrays[2][first..]]
}

/// Makes room for `len` entries; what is there stays, what is new is zero.
fn grow(array: &mut Vec<f32>, len: usize) {
    if array.len() < len {
        array.resize(2 * len, 0.0);
    }
}

impl Star {
    /// Triangles.
    pub(in crate::simplify) fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// Area of the star, in scaled units.
    pub(in crate::simplify) fn area(&self) -> f32 {
        0.5 * self.area_doubled
    }

    /// Squared length of the longest edge of all triangles.
    pub(in crate::simplify) fn longest_edge_squared(&self) -> f32 {
        let spokes = (0..self.ids.len()).map(|i| self.offset(i).length_squared());
        let rim = (0..self.triangle_count).map(|t| {
            let [a, b] = self.triangle(t).map(|i| self.offset(i));
            (a - b).length_squared()
        });
        spokes.chain(rim).fold(0.0, f32::max)
    }

    /// Neighbour `i` relative to the centre.
    #[inline]
    pub(in crate::simplify) fn offset(&self, i: usize) -> Vec3 {
        let [x, y, z] = &self.offsets;
        Vec3::new(x[i], y[i], z[i])
    }

    /// The two neighbours that span triangle `t`.
    #[inline]
    pub(in crate::simplify) fn triangle(&self, t: usize) -> [usize; 2] {
        if self.pairs.is_empty() {
            [t, if t + 1 == self.ids.len() { 0 } else { t + 1 }]
        } else {
            self.pairs[t].map(|i| i as usize)
        }
    }

    /// First and second corners of all triangles.
    #[inline]
    fn corners(&self) -> [[&[f32]; 3]; 2] {
        if self.pairs.is_empty() {
            [slices(&self.offsets, 0), slices(&self.offsets, 1)]
        } else {
            [slices(&self.corners[0], 0), slices(&self.corners[1], 0)]
        }
    }

    /// Gathers the star of `v`, triangle numbers included where links follow them.
    pub(in crate::simplify) fn gather(&mut self, links: &Links, positions: &[[f32; 4]], v: u32) {
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
        // Room for a whole vector past the wrap.
        let padded = n + 1 + 2 * LANES;
        self.offsets.iter_mut().for_each(|array| grow(array, padded));
        let [vx, vy, vz, _] = positions[v as usize];
        let [x, y, z] = &mut self.offsets;
        let (x, y, z) = (&mut x[..padded], &mut y[..padded], &mut z[..padded]);
        for (i, &id) in self.ids.iter().enumerate() {
            let [px, py, pz, _] = positions[id as usize];
            x[i] = px - vx;
            y[i] = py - vy;
            z[i] = pz - vz;
        }
        for array in [x, y, z] {
            array[n] = array[0];
            array[n + 1..n + 1 + LANES].copy_from_slice(&[0.0; LANES]);
        }
        if !self.pairs.is_empty() {
            self.load_corners();
        }
    }

    fn load_corners(&mut self) {
        let padded = self.triangle_count.next_multiple_of(LANES) + LANES;
        for (side, corners) in self.corners.iter_mut().enumerate() {
            for (offsets, corners) in self.offsets.iter().zip(corners) {
                grow(corners, padded);
                for (corner, pair) in corners.iter_mut().zip(&self.pairs) {
                    *corner = offsets[pair[side] as usize];
                }
            }
        }
    }

    fn compute_normals(&mut self) {
        let m = self.triangle_count;
        let mut normals = std::mem::take(&mut self.normals);
        normals.iter_mut().for_each(|array| grow(array, m + 2 * LANES));
        let [a, b] = self.corners();
        let mut next = 0;
        while next < m {
            let t = next;
            next += LANES;
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

    /// Fills `costs` with the quadratic form at every neighbour.
    pub(in crate::simplify) fn compute_costs(&mut self) {
        self.form = self.quadric();
        let [xx, yy, zz, xy, xz, yz] = self.form.map(f32x8::splat);
        let n = self.ids.len();
        self.costs.clear();
        let offsets = slices(&self.offsets, 0);
        let mut next = 0;
        while next < n {
            let i = next;
            next += LANES;
            let Vec3x8 { x, y, z } = Vec3x8::load(offsets, i);
            let mixed = xy * x * y + xz * x * z + yz * y * z;
            let form = xx * x * x + yy * y * y + zz * z * z + (mixed + mixed);
            // Rounding may leave a tiny negative number where the form is zero.
            self.costs.extend(form.fast_max(f32x8::ZERO).to_array());
        }
        self.costs.truncate(n);
    }

    /// The quadratic form at a place that need not be a neighbour.
    pub(in crate::simplify) fn cost_at(&self, at: Vec3) -> f32 {
        let [xx, yy, zz, xy, xz, yz] = self.form;
        let Vec3 { x, y, z } = at;
        let mixed = xy * x * y + xz * x * z + yz * y * z;
        (xx * x * x + yy * y * y + zz * z * z + (mixed + mixed)).max(0.0)
    }

    /// The form of this module's header: xx, yy, zz, xy, xz, yz.
    fn quadric(&mut self) -> [f32; 6] {
        // xx yy zz xy xz yz | nx ny nz | area
        let mut sums = [f32x4::ZERO; 10];
        let mut t = 0;
        while t < self.triangle_count {
            let [x, y, z] = slices(&self.normals, t)
                .map(|array| f32x4::new(array.first_chunk().copied().unwrap_or([0.0; 4])));
            let length = (x * x + y * y + z * z).sqrt();
            let weight = f32x4::splat(0.5) / length.fast_max(f32x4::splat(f32::MIN_POSITIVE));
            let (wx, wy, wz) = (weight * x, weight * y, weight * z);
            let terms = [wx * x, wy * y, wz * z, wx * y, wx * z, wy * z, x, y, z, length];
            for (sum, term) in sums.iter_mut().zip(terms) {
                *sum += term;
            }
            t += 4;
        }
        let [xx, yy, zz, xy, xz, yz, nx, ny, nz, area] = sums.map(fold);
        self.area_doubled = area;
        self.mean_normal = Vec3::new(nx, ny, nz);
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
    /// `seam_between(i, j)` gives the squared difference of attributes if triangles `i` and `j` show v different wedges; infinite
    /// if the seam must stay.
    pub(in crate::simplify) fn apply_borders(
        &mut self,
        kind: LinkKind,
        seam_between: Option<SeamBetween<'_>>,
    ) {
        if kind == LinkKind::Closed && seam_between.is_none() {
            return;
        }
        if kind == LinkKind::Open && seam_between.is_none() {
            let last = self.ids.len() - 1;
            let swept = BORDER_WEIGHT * self.offset(0).cross(self.offset(last)).length_squared();
            let (first_cost, last_cost) = (self.costs[0] + swept, self.costs[last] + swept);
            self.costs.fill(f32::INFINITY);
            (self.costs[0], self.costs[last]) = (first_cost, last_cost);
            return;
        }
        let mut special = std::mem::take(&mut self.special);
        special.clear();
        for i in 0..self.ids.len() {
            special.extend(self.special_edge(i, seam_between));
        }
        self.charge_borders(&special);
        self.special = special;
    }

    fn charge_borders(&mut self, special: &[Special]) {
        let Some(strongest) = special.iter().map(|s| s.border).max() else { return };
        // Seams that may be crossed bind nobody to their course.
        let binds = strongest > Border::Seam || special.iter().any(|s| s.difference_squared == f32::INFINITY);
        let mut costs = std::mem::take(&mut self.costs);
        for (i, cost) in costs.iter_mut().enumerate() {
            if binds && !special.iter().any(|s| s.neighbor as usize == i && s.border == strongest) {
                *cost = f32::INFINITY;
                continue;
            }
            let u = self.offset(i);
            let others = special.iter().filter(|s| s.neighbor as usize != i);
            let swept =
                |s: &Special| s.leave_cost(self.offset(s.neighbor as usize).cross(u).length_squared());
            *cost += others.map(swept).sum::<f32>();
            if let [end] = special {
                // The border ends here and would recede.
                *cost += end.recede_cost(u.length_squared());
            }
        }
        self.costs = costs;
    }

    /// The edge to neighbor `i`, if it lies on a border.
    fn special_edge(&self, i: usize, seam_between: Option<SeamBetween<'_>>) -> Option<Special> {
        let (before, after, count) = self.triangles_at(i);
        let (border, difference_squared) = match (before, after) {
            _ if count == 1 => (Border::Boundary, f32::INFINITY),
            (Some(t), Some(s)) if count == 2 => (Border::Seam, seam_between?(self, t, s)?),
            _ => (Border::Branch, f32::INFINITY),
        };
        Some(Special { neighbor: i as u32, border, difference_squared })
    }

    /// The last triangle that ends at neighbor `i`, the last one that begins there, and how many do either.
    fn triangles_at(&self, i: usize) -> (Option<usize>, Option<usize>, usize) {
        if self.pairs.is_empty() {
            let n = self.ids.len();
            let is_closed = self.triangle_count == n;
            let before = if i > 0 { Some(i - 1) } else { is_closed.then_some(n - 1) };
            let after = (i < self.triangle_count).then_some(i);
            return (before, after, usize::from(before.is_some()) + usize::from(after.is_some()));
        }
        let (mut before, mut after, mut count) = (None, None, 0);
        for (t, pair) in self.pairs.iter().enumerate() {
            let [a, b] = pair.map(|x| x as usize);
            if a == i {
                after = Some(t);
                count += 1;
            }
            if b == i {
                before = Some(t);
                count += 1;
            }
        }
        (before, after, count)
    }

    /// Squared distance of v from the fan that neighbour `k` as the target would leave; `None` where a triangle would
    /// flip or become a sliver.
    pub(in crate::simplify) fn fan_distance_squared(&mut self, k: usize) -> Option<f32> {
        self.mark_vanishing(Some(k));
        let distance_squared = self.distance_squared_from(self.offset(k))?;
        if distance_squared < f32::INFINITY {
            return Some(distance_squared);
        }
        // No triangle is left (the last one of a border): the edges of the old ones are what remains.
        let edge = |t: usize| {
            let [a, b] = self.triangle(t).map(|i| self.offset(i));
            fan::distance_squared(self.offset(k), a, b)
        };
        Some((0..self.triangle_count).map(edge).fold(f32::INFINITY, f32::min))
    }

    /// The same for a target that is no neighbour: all triangles stay.
    pub(in crate::simplify) fn moved_distance_squared(&mut self, to: Vec3) -> Option<f32> {
        self.mark_vanishing(None);
        self.distance_squared_from(to)
    }

    fn distance_squared_from(&self, u: Vec3) -> Option<f32> {
        let u = Vec3x8::splat(u);
        let uu = u.dot(u);
        let star = fan::StarNormal::new(self.mean_normal);
        let [a, b] = self.corners();
        let normals = slices(&self.normals, 0);
        let mut least = f32x8::splat(f32::INFINITY);
        let mut next = 0;
        while next < self.triangle_count {
            let t = next;
            next += LANES;
            let (a, b) = (Vec3x8::load(a, t), Vec3x8::load(b, t));
            let vanishes = lanes(&self.vanishes, t).simd_gt(f32x8::ZERO);
            let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
            let (ua, ub) = (u.dot(a), u.dot(b));
            let old = Vec3x8::load(normals, t);
            let new = a.minus(u).cross(b.minus(u));
            let new_squared = new.dot(new);
            let change = fan::Change {
                old_length: old.dot(old).sqrt(),
                new_length: new_squared.sqrt(),
                new_on_old: new.dot(old),
                new_on_mean: new.dot(Vec3x8::splat(self.mean_normal)),
                old_on_mean: old.dot(Vec3x8::splat(self.mean_normal)),
                old_edges: aa + bb + (aa + bb - ab - ab),
                new_edges: (aa + uu - ua - ua) + (bb + uu - ub - ub) + (aa + bb - ab - ab),
            };
            if !(change.is_allowed(star) | vanishes).all() {
                return None;
            }
            // The origin against the triangle (u, a, b); its height over all of them comes from the old normal.
            let triangle = fan::Products {
                d: [uu - ua, uu - ub, ua - aa, ua - ab, ub - ab, ub - bb],
                corners: [uu, aa, bb],
                height: u.dot(old),
                normal_squared: new_squared,
            };
            let distance_squared =
                vanishes.bitselect(f32x8::splat(f32::INFINITY), triangle.distance_squared());
            least = least.fast_min(distance_squared);
        }
        Some(least.to_array().into_iter().fold(f32::INFINITY, f32::min))
    }

    /// Squared distance of the point `p` from the fan that was judged last, neighbour `k` being the target; infinite
    /// where no triangle is left.
    pub(in crate::simplify) fn fan_distance_squared_of(&self, k: usize, p: Vec3) -> f32 {
        let [a, b] = self.corners();
        let (u, p) = (Vec3x8::splat(self.offset(k)), Vec3x8::splat(p));
        let mut least = f32x8::splat(f32::INFINITY);
        let mut next = 0;
        while next < self.triangle_count {
            let t = next;
            next += LANES;
            let (a, b) = (Vec3x8::load(a, t), Vec3x8::load(b, t));
            let vanishes = lanes(&self.vanishes, t).simd_gt(f32x8::ZERO);
            let (ua, ub, up, ap, bp) = (a.minus(u), b.minus(u), p.minus(u), p.minus(a), p.minus(b));
            let normal = ua.cross(ub);
            let triangle = fan::Products {
                d: [ua.dot(up), ub.dot(up), ua.dot(ap), ub.dot(ap), ua.dot(bp), ub.dot(bp)],
                corners: [up.dot(up), ap.dot(ap), bp.dot(bp)],
                height: normal.dot(up),
                normal_squared: normal.dot(normal),
            };
            let squared = vanishes.bitselect(f32x8::splat(f32::INFINITY), triangle.distance_squared());
            least = least.fast_min(squared);
        }
        least.to_array().into_iter().fold(f32::INFINITY, f32::min)
    }

    /// The cost of a squared distance from v over the area of the star.
    pub(in crate::simplify) fn distance_cost(&self, squared: f32) -> f32 {
        (self.area() + SPIKE_WEIGHT * squared) * squared
    }

    /// Notes which triangles a collapse to neighbour `k` removes.
    pub(in crate::simplify) fn mark_vanishing(&mut self, k: Option<usize>) {
        let padded = self.triangle_count.next_multiple_of(LANES);
        grow(&mut self.vanishes, padded);
        let mut vanishes = std::mem::take(&mut self.vanishes);
        let (real, rest) = vanishes[..padded].split_at_mut(self.triangle_count);
        real.fill(0.0);
        rest.fill(NO_TRIANGLE);
        match k {
            None => {}
            Some(k) if self.pairs.is_empty() => {
                // Triangle k begins at the neighbour, the one before ends there.
                let before = if k == 0 { self.ids.len() - 1 } else { k - 1 };
                for t in [k, before] {
                    if let Some(lane) = real.get_mut(t) {
                        *lane = 1.0;
                    }
                }
            }
            Some(k) => {
                for (lane, pair) in real.iter_mut().zip(&self.pairs) {
                    if pair.contains(&(k as u32)) {
                        *lane = 1.0;
                    }
                }
            }
        }
        self.vanishes = vanishes;
    }

    /// The candidate that looks cheapest at present; the first of equal ones.
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

    /// How far the fan's new edges stick out: the largest squared distance of their midpoints from the old star.
    ///
    /// The distance of v alone does not see a fan that bridges a valley.
    pub(in crate::simplify) fn protrusion_squared(&mut self, k: usize) -> f32 {
        // A ring of three has no new edge; where sheets meet there can be one among fewer.
        if self.pairs.is_empty() && self.triangle_count < 4 {
            return 0.0;
        }
        let mut middles = std::mem::take(&mut self.middles);
        let u = self.offset(k);
        middles.clear();
        for i in 0..self.ids.len() {
            if i != k && !self.is_edge(i, k) {
                middles.push((0.5 * (self.offset(i) + u), f32x8::splat(f32::INFINITY)));
            }
        }
        let [a, b] = self.corners();
        let normals = slices(&self.normals, 0);
        let mut next = 0;
        while next < self.triangle_count {
            let t = next;
            next += LANES;
            let (a, b) = (Vec3x8::load(a, t), Vec3x8::load(b, t));
            let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
            let normal = Vec3x8::load(normals, t);
            let normal_squared = normal.dot(normal);
            let is_none = lanes(&self.vanishes, t).simd_gt(f32x8::ONE);
            for (middle, least) in &mut middles {
                // The midpoint against the triangle (v, a, b), v being the origin.
                let mm = f32x8::splat(middle.length_squared());
                let middle = Vec3x8::splat(*middle);
                let (ma, mb) = (middle.dot(a), middle.dot(b));
                let triangle = fan::Products {
                    d: [ma, mb, ma - aa, mb - ab, ma - ab, mb - bb],
                    corners: [mm, mm - ma - ma + aa, mm - mb - mb + bb],
                    height: middle.dot(normal),
                    normal_squared,
                };
                *least = least
                    .fast_min(is_none.bitselect(f32x8::splat(f32::INFINITY), triangle.distance_squared()));
            }
        }
        let worst =
            middles.iter().map(|(_, least)| least.to_array().into_iter().fold(f32::INFINITY, f32::min));
        let worst = worst.fold(0.0, f32::max);
        self.middles = middles;
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

/// Weight of the area between the old and the new course of a border; 1 to 50 differ little in RMS, and small ones lose
/// thin ears of the boundary early.
const BORDER_WEIGHT: f32 = 4.0;
/// Area, in squared distances, that a spike counts for beyond the area of its star: thin spikes have next to none,
/// but they are seen.
const SPIKE_WEIGHT: f32 = 32.0;
