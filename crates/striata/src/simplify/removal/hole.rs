//! The hole that a removed vertex leaves, and the best of all triangulations of it.
//!
//! The ring is a polygon in space; sub-polygons `i..=j` of it are triangulated best first, the short ones
//! before the long ones (dynamic programming over intervals, as for [`matrix chains`](https://en.wikipedia.org/wiki/Polygon_triangulation)):
//!
//! ```text
//!            k
//!          /   \          best(i, j) = least over k of  best(i, k) + best(k, j) + triangle(i, k, j)
//!    ...  /     \  ...                 + what the new edge (i, j) costs
//!        i ----- j
//! ```
//!
//! That is exact as long as costs add up over triangles and new edges. Distances do: seen along the normals of the star,
//! each point that is followed lies over one triangle of any triangulation, and each new edge crosses the old
//! spokes where the two surfaces are farthest apart.
//!
//! O(n^3) for a ring of n, each triangle looked at once.

use glam::Vec3;

use super::options::{HoleCriterion, MAX_DEGREE};
use super::points::Point;

/// An open ring has one position more than triangles.
const MAX_RING: usize = MAX_DEGREE + 1;
/// Cosine that the normals of a new triangle and of an old one at the same edge must at least have between them.
const FLIP_COSINE: f32 = 0.2;
/// A new triangle may not be thinner than this (1 is equilateral), unless an old one was thinner still.
const SLIVER_QUALITY: f32 = 0.01;
/// Below this the normal of a triangle is noise.
const NEEDLE_QUALITY: f32 = 0.02;
/// Squared gaps under this share of the squared edge are what single precision leaves of flat places.
const GAP_NOISE: f32 = 1e-11;
/// Makes `TWICE_ROOT_3 * |normal| / (sum of squared edges)` 1 for equilateral triangles.
const TWICE_ROOT_3: f32 = 3.464_101_6;

/// Three indices into the ring, counterclockwise.
pub(super) type RingTriangle = [u8; 3];

/// Sharp edges at a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Features {
    None,
    /// One passes through, to these two members of the ring.
    Course(usize, usize),
    /// They meet or end here.
    Corner,
}

/// One hole, prepared for the search; scratch.
#[derive(Debug, Default)]
pub(super) struct Hole {
    n: usize,
    is_closed: bool,
    /// The ring relative to the removed vertex.
    ring: [Vec3; MAX_RING],
    /// Unscaled normals of the old triangles `(v, i, i + 1)`.
    normals: [Vec3; MAX_RING],
    /// True where the old triangle's normal says nothing.
    is_vague: [bool; MAX_RING],
    least_quality: f32,
    /// What the surface faces around the diagonal between two members of the ring.
    facing: [[Vec3; MAX_RING]; MAX_RING],
    /// Largest squared gap between a diagonal and the old spokes that it crosses.
    gap_squared: [[f32; MAX_RING]; MAX_RING],
    /// Bit `j` of entry `i`: the edge `i`-`j` may be there.
    allowed: [u32; MAX_RING],
    best: [[f32; MAX_RING]; MAX_RING],
    apex: [[u8; MAX_RING]; MAX_RING],
    /// For each pair, which points lie to its left: `words` words.
    left: Vec<u64>,
    words: usize,
    /// Cost of a squared gap.
    gap_weight: f32,
    area: f32,
}

fn quality(normal_length: f32, edges_squared: f32) -> f32 {
    TWICE_ROOT_3 * normal_length / edges_squared.max(f32::MIN_POSITIVE)
}

impl Hole {
    /// Takes the ring relative to the removed vertex, counterclockwise.
    pub(super) fn load(&mut self, ring: impl ExactSizeIterator<Item = Vec3>, is_closed: bool) {
        self.n = ring.len();
        self.is_closed = is_closed;
        for (slot, p) in self.ring.iter_mut().zip(ring) {
            *slot = p;
        }
        let n = self.n;
        let all = (1u32 << n) - 1;
        self.allowed[..n].fill(all);
        self.area = 0.0;
        self.least_quality = f32::INFINITY;
        let mut sum = Vec3::ZERO;
        for t in 0..self.triangle_count() {
            let (a, b) = (self.ring[t], self.ring[self.after(t)]);
            let normal = a.cross(b);
            let length = normal.length();
            let q = quality(length, a.length_squared() + b.length_squared() + (b - a).length_squared());
            self.normals[t] = normal;
            self.is_vague[t] = q <= NEEDLE_QUALITY;
            self.least_quality = self.least_quality.min(q);
            self.area += 0.5 * length;
            sum += normal;
        }
        for t in 0..self.triangle_count() {
            // A triangle that was folded over may unfold.
            self.is_vague[t] |= self.normals[t].dot(sum) <= 0.0;
        }
        self.compute_facing(sum);
    }

    /// Old triangles.
    pub(super) fn triangle_count(&self) -> usize {
        self.n - usize::from(!self.is_closed)
    }

    /// Area of the old triangles.
    pub(super) fn area(&self) -> f32 {
        self.area
    }

    /// A member of the ring relative to the removed vertex.
    pub(super) fn at(&self, i: usize) -> Vec3 {
        self.ring[i]
    }

    fn after(&self, i: usize) -> usize {
        if i + 1 == self.n { 0 } else { i + 1 }
    }

    /// Forbids the new edge between two members of the ring.
    pub(super) fn forbid(&mut self, i: usize, j: usize) {
        self.allowed[i] &= !(1 << j);
        self.allowed[j] &= !(1 << i);
    }

    /// Forbids all new edges that would cross the one between `i` and `j`.
    pub(super) fn keep_edge(&mut self, i: usize, j: usize) {
        let (i, j) = (i.min(j), i.max(j));
        for a in i + 1..j {
            for b in (0..i).chain(j + 1..self.n) {
                self.forbid(a, b);
            }
        }
    }

    /// Which spokes are sharp: the normals on both sides have less than this cosine between them.
    pub(super) fn sharp_spokes(&self, cosine: f32) -> Features {
        let first = usize::from(!self.is_closed);
        let is_sharp = |i: &usize| {
            let before = if *i == 0 { self.n - 1 } else { i - 1 };
            let (a, b) = (self.normals[before], self.normals[*i]);
            a.dot(b) < cosine * a.length() * b.length()
        };
        let mut sharp = (first..self.triangle_count()).filter(is_sharp);
        match (sharp.next(), sharp.next(), sharp.next()) {
            (None, ..) => Features::None,
            (Some(a), Some(b), None) if self.is_closed => Features::Course(a, b),
            _ => Features::Corner,
        }
    }

    /// True where an edge of the ring, old or new, closes it from the last to the first.
    fn is_side(&self, i: usize, j: usize) -> bool {
        j == i + 1 || (i == 0 && j + 1 == self.n)
    }

    /// Directions around the diagonals: half from each side, so that a crease turns neither against the other.
    fn compute_facing(&mut self, sum: Vec3) {
        for i in 0..self.n {
            let mut side = Vec3::ZERO;
            for j in i + 1..self.n {
                side += self.normals[j - 1];
                let other = if self.is_closed { sum - side } else { Vec3::ZERO };
                let facing = match j == i + 1 {
                    true => side.normalize_or_zero(),
                    false => (side.normalize_or_zero() + other.normalize_or_zero()).normalize_or_zero(),
                };
                self.facing[i][j] = facing;
                self.facing[j][i] = facing;
                if !self.is_side(i, j) {
                    let gap = self.gap_squared_of(i, j, facing);
                    self.gap_squared[i][j] = gap;
                    self.gap_squared[j][i] = gap;
                } else {
                    self.gap_squared[i][j] = 0.0;
                    self.gap_squared[j][i] = 0.0;
                }
            }
        }
    }

    /// Largest squared distance from the line `i`-`j` of where it crosses old spokes, seen along `facing`.
    fn gap_squared_of(&self, i: usize, j: usize, facing: Vec3) -> f32 {
        let (from, along) = (self.ring[i], self.ring[j] - self.ring[i]);
        let across = facing.cross(along);
        let length_squared = along.length_squared().max(f32::MIN_POSITIVE);
        // The removed vertex is the origin; spokes on the other side of the line cross it.
        let own = -across.dot(from);
        let mut worst = 0.0f32;
        let mut look = |k: usize| {
            let its = across.dot(self.ring[k] - from);
            if own * its < 0.0 {
                let crossing = self.ring[k] * (own / (own - its));
                let gap = along.cross(crossing - from).length_squared() / length_squared;
                if gap > GAP_NOISE * length_squared {
                    worst = worst.max(gap);
                }
            }
        };
        if own > 0.0 {
            (i + 1..j).for_each(&mut look);
        } else {
            (j + 1..self.n).chain(0..i).for_each(&mut look);
        }
        worst
    }

    /// Largest squared gap under the new edges of a triangulation.
    pub(super) fn worst_gap_squared(&self, floor: &[RingTriangle]) -> f32 {
        let edges = floor.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (a, c)]);
        edges.map(|(i, j)| self.gap_squared[i as usize][j as usize]).fold(0.0, f32::max)
    }

    /// Sum of the squared gaps under the new edges of a triangulation.
    pub(super) fn gap_squared_sum(&self, floor: &[RingTriangle]) -> f32 {
        let edges = floor.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (a, c)]);
        0.5 * edges.map(|(i, j)| self.gap_squared[i as usize][j as usize]).sum::<f32>()
    }

    /// Notes for each pair of the ring on which side the points lie.
    fn compute_sides(&mut self, points: &[Point]) {
        self.words = points.len().div_ceil(64);
        self.left.clear();
        self.left.resize(MAX_RING * MAX_RING * self.words, 0);
        for i in 0..self.n {
            for j in i + 1..self.n {
                let at = (i * MAX_RING + j) * self.words;
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
        self.left[(i * MAX_RING + j) * self.words + word]
    }

    /// Normal of a new triangle; `None` where it would be flipped or a sliver.
    fn sound_normal(&self, [i, j, k]: [usize; 3]) -> Option<Vec3> {
        let [a, b, c] = [i, j, k].map(|x| self.ring[x]);
        let normal = (b - a).cross(c - a);
        let length = normal.length();
        let edges = (b - a).length_squared() + (c - b).length_squared() + (c - a).length_squared();
        if length == 0.0 || quality(length, edges) < SLIVER_QUALITY.min(self.least_quality) {
            return None;
        }
        let facing = self.facing[i][j] + self.facing[j][k] + self.facing[i][k];
        if normal.dot(facing) <= FLIP_COSINE * length * facing.length() {
            return None;
        }
        let follows = |t: usize| {
            let old = self.normals[t];
            self.is_vague[t] || normal.dot(old) > FLIP_COSINE * length * old.length()
        };
        let is_sound = (j != i + 1 || follows(i))
            && (k != j + 1 || follows(j))
            && (!self.is_closed || i != 0 || k + 1 != self.n || follows(k));
        is_sound.then_some(normal)
    }

    /// What a triangle costs; infinite where it may not be.
    fn triangle_cost(&self, corners: [usize; 3], points: &[Point], criterion: HoleCriterion) -> f32 {
        let Some(normal) = self.sound_normal(corners) else { return f32::INFINITY };
        let [i, j, k] = corners;
        match criterion {
            HoleCriterion::Distance => {
                let inverse = 1.0 / normal.length_squared();
                let height = normal.dot(self.ring[i]);
                let mut sum = 0.0;
                for word in 0..self.words {
                    let mut bits =
                        self.left_of(i, j, word) & self.left_of(j, k, word) & !self.left_of(i, k, word);
                    if word + 1 == self.words && !points.len().is_multiple_of(64) {
                        bits &= (1 << (points.len() % 64)) - 1;
                    }
                    while bits != 0 {
                        let point = &points[64 * word + bits.trailing_zeros() as usize];
                        bits &= bits - 1;
                        let h = normal.dot(point.at) - height;
                        sum += point.weight * h * h;
                    }
                }
                sum * inverse
            }
            HoleCriterion::Flatness => {
                let facing = self.facing[i][j] + self.facing[j][k] + self.facing[i][k];
                let length = normal.length();
                0.5 * length * (1.0 - normal.dot(facing) / (length * facing.length()))
            }
            HoleCriterion::Shape => {
                let [a, b, c] = corners.map(|x| self.ring[x]);
                let edges = (b - a).length_squared() + (c - b).length_squared() + (c - a).length_squared();
                1.0 / quality(normal.length(), edges) - 1.0
            }
        }
    }

    /// The best triangulation into `floor`; false where there is none.
    pub(super) fn triangulate(
        &mut self,
        points: &[Point],
        criterion: HoleCriterion,
        gap_weight: f32,
        floor: &mut Vec<RingTriangle>,
    ) -> bool {
        floor.clear();
        self.gap_weight = if criterion == HoleCriterion::Distance { gap_weight } else { 0.0 };
        if criterion == HoleCriterion::Distance {
            self.compute_sides(points);
        }
        let n = self.n;
        for i in 0..n - 1 {
            self.best[i][i + 1] = 0.0;
        }
        for span in 2..n {
            for i in 0..n - span {
                self.best[i][i + span] = self.best_between(i, i + span, points, criterion);
            }
        }
        let is_found = self.best[0][n - 1] < f32::INFINITY;
        if is_found {
            self.collect(0, n - 1, floor);
        }
        is_found
    }

    fn best_between(&mut self, i: usize, j: usize, points: &[Point], criterion: HoleCriterion) -> f32 {
        if self.allowed[i] & 1 << j == 0 {
            return f32::INFINITY;
        }
        let mut least = f32::INFINITY;
        for k in i + 1..j {
            let parts = self.best[i][k] + self.best[k][j];
            if parts < least {
                let cost = parts + self.triangle_cost([i, k, j], points, criterion);
                if cost < least {
                    least = cost;
                    self.apex[i][j] = k as u8;
                }
            }
        }
        least + self.gap_weight * self.gap_squared[i][j]
    }

    fn collect(&self, i: usize, j: usize, floor: &mut Vec<RingTriangle>) {
        if j < i + 2 {
            return;
        }
        let k = self.apex[i][j] as usize;
        floor.push([i as u8, k as u8, j as u8]);
        self.collect(i, k, floor);
        self.collect(k, j, floor);
    }

    /// The best fan around one of `apexes` into `floor`; which one that is.
    pub(super) fn best_fan(
        &mut self,
        points: &[Point],
        gap_weight: f32,
        apexes: impl Iterator<Item = usize>,
        floor: &mut Vec<RingTriangle>,
    ) -> Option<usize> {
        self.compute_sides(points);
        let n = self.n;
        let mut best = None;
        let mut least = f32::INFINITY;
        for apex in apexes {
            let others = (0..n).filter(|&i| i != apex);
            if others.clone().any(|i| self.allowed[apex] & 1 << i == 0) {
                continue;
            }
            let mut cost = gap_weight * others.map(|i| self.gap_squared[apex][i]).sum::<f32>();
            for triangle in fan(n, apex) {
                cost += self.triangle_cost(triangle, points, HoleCriterion::Distance);
            }
            if cost < least {
                least = cost;
                best = Some(apex);
            }
        }
        floor.clear();
        if let Some(apex) = best {
            floor.extend(fan(n, apex).map(|triangle| triangle.map(|x| x as u8)));
        }
        best
    }
}

/// The triangles of the fan around one member of a ring of `n`, corners rising.
fn fan(n: usize, apex: usize) -> impl Iterator<Item = [usize; 3]> {
    (1..n - 1).map(move |step| {
        let mut triangle = [apex, (apex + step) % n, (apex + step + 1) % n];
        triangle.sort_unstable();
        triangle
    })
}
