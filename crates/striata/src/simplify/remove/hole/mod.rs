//! The hole that a removed vertex leaves: its ring in space, and properties of its possible diagonals
//! and triangles.
//!
//! A star that is sharply bent cannot be projected to a single plane. Each diagonal of the ring
//! therefore has its own facing direction, half of it from the old triangles on one side of the
//! diagonal and half from those on the other; "over", "left of" and "flipped" refer to that direction.
//!
//! All coordinates are relative to the removed vertex, which is therefore the origin.

mod point_sides;
mod search;

use glam::Vec3;

use super::removal_options::MAX_DEGREE;
use crate::simplify::collapse::fan::distance_squared;
use crate::simplify::collapse::height_field::area;

/// An open ring has one more position than triangles.
const MAX_RING: usize = MAX_DEGREE + 1;
/// Least cosine between the normals of a new triangle and of an old one at the same edge.
const FLIP_COSINE: f32 = 0.2;
/// A new triangle must have at least this quality (1 is equilateral), unless an old one was worse.
const SLIVER_QUALITY: f32 = 0.01;
/// Below this quality, the normal of a triangle is noise.
const NEEDLE_QUALITY: f32 = 0.02;
/// Gaps below this share of the edge, both squared, are single-precision noise on flat surfaces.
const GAP_NOISE: f32 = 1e-11;
/// Factor that makes `TWICE_ROOT_3 * |normal| / (sum of squared edges)` 1 for equilateral triangles.
const TWICE_ROOT_3: f32 = 3.464_101_6;

/// Three indices into the ring in ascending order, which is counterclockwise.
pub(super) type RingTriangle = [u8; 3];

/// Sharp edges at a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Features {
    None,
    /// One feature edge passes through the vertex, to these two members of the ring.
    Crease(usize, usize),
    /// Several feature edges meet at the vertex, or one ends there.
    Corner,
}

/// Cost of a part of a triangulation: a largest value, then a sum, which decides among equal ones. Costs
/// that are not allowed are infinite in both.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
struct HoleCost {
    /// Largest squared distance; 0 unless the criterion asks for it.
    largest: f32,
    sum: f32,
}

/// One hole, prepared for the search; reused as scratch.
#[derive(Debug, Default)]
pub(super) struct Hole {
    n: usize,
    is_closed: bool,
    ring: [Vec3; MAX_RING],
    /// Unscaled normals of the old triangles `(v, i, i + 1)`.
    normals: [Vec3; MAX_RING],
    /// Whether the old triangle's normal is unreliable.
    is_normal_unreliable: [bool; MAX_RING],
    /// The ring in plan, and 1 or -1 if new triangles must face up or down; 0 if they need not.
    plan: [[f32; 2]; MAX_RING],
    plan_facing: f64,
    least_quality: f32,
    area: f32,
    /// Facing direction of the surface around the diagonal between two members of the ring.
    facing: [[Vec3; MAX_RING]; MAX_RING],
    /// Largest squared gap between a diagonal and the old spokes that it crosses.
    gap_squared: [[f32; MAX_RING]; MAX_RING],
    /// Bit `j` of entry `i`: whether the edge `i`-`j` is allowed.
    allowed: [u32; MAX_RING],
    /// Search state: the least cost between two members of the ring, and the apex of the triangle there.
    best: [[HoleCost; MAX_RING]; MAX_RING],
    apex: [[u8; MAX_RING]; MAX_RING],
    /// For each diagonal, a bit mask of the points to its left, in `words` words.
    left: Vec<u64>,
    words: usize,
}

/// Quality of a triangle: 1 if equilateral, 0 without area.
fn quality(normal_length: f32, edges_squared: f32) -> f32 {
    TWICE_ROOT_3 * normal_length / edges_squared.max(f32::MIN_POSITIVE)
}

fn edges_squared([a, b, c]: [Vec3; 3]) -> f32 {
    (b - a).length_squared() + (c - b).length_squared() + (c - a).length_squared()
}

impl Hole {
    /// Loads the ring, counterclockwise and relative to the removed vertex.
    pub(super) fn load(&mut self, ring: impl ExactSizeIterator<Item = Vec3>, is_closed: bool) {
        self.n = ring.len();
        self.is_closed = is_closed;
        for (slot, p) in self.ring.iter_mut().zip(ring) {
            *slot = p;
        }
        self.allowed[..self.n].fill((1 << self.n) - 1);
        self.area = 0.0;
        self.plan_facing = 0.0;
        self.least_quality = f32::INFINITY;
        let mut sum = Vec3::ZERO;
        for t in 0..self.triangle_count() {
            let (a, b) = (self.ring[t], self.ring[self.after(t)]);
            let normal = a.cross(b);
            let length = normal.length();
            let quality = quality(length, edges_squared([Vec3::ZERO, a, b]));
            self.normals[t] = normal;
            self.is_normal_unreliable[t] = quality <= NEEDLE_QUALITY;
            self.least_quality = self.least_quality.min(quality);
            self.area += 0.5 * length;
            sum += normal;
        }
        for t in 0..self.triangle_count() {
            // A triangle that was folded over may unfold.
            self.is_normal_unreliable[t] |= self.normals[t].dot(sum) <= 0.0;
        }
        self.measure_diagonals(sum);
    }

    /// Forbids triangles that do not face up (1) or down (-1) in plan, given the ring in plan.
    pub(super) fn keep_facing(&mut self, facing: f64, plan: impl Iterator<Item = [f32; 2]>) {
        self.plan_facing = facing;
        self.plan.iter_mut().zip(plan).for_each(|(slot, p)| *slot = p);
    }

    /// Number of old triangles.
    fn triangle_count(&self) -> usize {
        self.n - usize::from(!self.is_closed)
    }

    /// Area of the old triangles.
    pub(super) fn area(&self) -> f32 {
        self.area
    }

    /// Returns a member of the ring relative to the removed vertex.
    pub(super) fn at(&self, i: usize) -> Vec3 {
        self.ring[i]
    }

    fn after(&self, i: usize) -> usize {
        if i + 1 == self.n { 0 } else { i + 1 }
    }

    /// Whether `i < j` are adjacent in the ring, or its first and last member.
    fn is_side(&self, i: usize, j: usize) -> bool {
        j == i + 1 || (i == 0 && j + 1 == self.n)
    }

    /// Forbids the new edge between two members of the ring.
    pub(super) fn forbid(&mut self, i: usize, j: usize) {
        self.allowed[i] &= !(1 << j);
        self.allowed[j] &= !(1 << i);
    }

    /// Forbids all new edges that would cross the one between `i` and `j`, so that every triangulation
    /// contains it.
    pub(super) fn keep_edge(&mut self, i: usize, j: usize) {
        let (i, j) = (i.min(j), i.max(j));
        for a in i + 1..j {
            for b in (0..i).chain(j + 1..self.n) {
                self.forbid(a, b);
            }
        }
    }

    /// Finds the sharp spokes, at which the cosine between the normals on both sides is less than `cosine`.
    pub(super) fn features(&self, cosine: f32) -> Features {
        let first = usize::from(!self.is_closed);
        let is_sharp = |i: &usize| {
            let before = if *i == 0 { self.n - 1 } else { i - 1 };
            let (a, b) = (self.normals[before], self.normals[*i]);
            a.dot(b) < cosine * a.length() * b.length()
        };
        let mut sharp = (first..self.triangle_count()).filter(is_sharp);
        match (sharp.next(), sharp.next(), sharp.next()) {
            (None, ..) => Features::None,
            (Some(a), Some(b), None) if self.is_closed => Features::Crease(a, b),
            _ => Features::Corner,
        }
    }

    fn measure_diagonals(&mut self, sum: Vec3) {
        for i in 0..self.n {
            let mut side = Vec3::ZERO;
            for j in i + 1..self.n {
                side += self.normals[j - 1];
                let (facing, gap_squared) = if j == i + 1 {
                    (side.normalize_or_zero(), 0.0)
                } else {
                    let other = if self.is_closed { sum - side } else { Vec3::ZERO };
                    let facing = side.normalize_or_zero() + other.normalize_or_zero();
                    let is_side = self.is_side(i, j);
                    (
                        facing.normalize_or_zero(),
                        if is_side { 0.0 } else { self.gap_squared_along(i, j, facing) },
                    )
                };
                (self.facing[i][j], self.gap_squared[i][j]) = (facing, gap_squared);
            }
        }
    }

    /// Largest squared distance between the line `i`-`j` and the old spokes that it crosses, seen along
    /// `facing`.
    fn gap_squared_along(&self, i: usize, j: usize, facing: Vec3) -> f32 {
        let (from, along) = (self.ring[i], self.ring[j] - self.ring[i]);
        let across = facing.cross(along);
        let length_squared = along.length_squared().max(f32::MIN_POSITIVE);
        let mut worst = 0.0f32;
        let mut is_crossed = false;
        // The removed vertex is the origin; spokes to the other side of the line cross it.
        let own = -across.dot(from);
        let mut look = |k: usize| {
            let its = across.dot(self.ring[k] - from);
            if own * its < 0.0 {
                is_crossed = true;
                let crossing = self.ring[k] * (own / (own - its));
                worst = worst.max(along.cross(crossing - from).length_squared() / length_squared);
            }
        };
        if own > 0.0 {
            (i + 1..j).for_each(&mut look);
        } else {
            (j + 1..self.n).chain(0..i).for_each(&mut look);
        }
        if !is_crossed {
            // The line crosses no spoke here, so it leaves the area that the star covers.
            worst = self.distance_squared_from_star(from + 0.5 * along);
        }
        if worst > GAP_NOISE * length_squared { worst } else { 0.0 }
    }

    /// Squared distance of a point from the old triangles.
    fn distance_squared_from_star(&self, at: Vec3) -> f32 {
        let triangle = |t: usize| distance_squared(-at, self.ring[t] - at, self.ring[self.after(t)] - at);
        (0..self.triangle_count()).map(triangle).fold(f32::INFINITY, f32::min)
    }

    /// Returns the new edges of a triangulation, each once: every triangle is adjacent to the one
    /// between its first and last corner.
    fn diagonals(&self, floor: &[RingTriangle]) -> impl Iterator<Item = (usize, usize)> {
        let over = floor.iter().map(|&[i, _, j]| (usize::from(i), usize::from(j)));
        over.filter(|&(i, j)| !self.is_side(i, j))
    }

    /// Returns the sum of the squared gaps under the new edges of a triangulation, and the largest one.
    pub(super) fn gaps_squared(&self, floor: &[RingTriangle]) -> (f32, f32) {
        let gaps = self.diagonals(floor).map(|(i, j)| self.gap_squared[i][j]);
        gaps.fold((0.0, 0.0), |(sum, worst), gap| (sum + gap, f32::max(worst, gap)))
    }

    /// Largest squared distance of the new edges' midpoints from the old triangles, or 0 if it may be
    /// rounding.
    pub(super) fn protrusion_squared(&self, floor: &[RingTriangle]) -> f32 {
        let of = |(i, j): (usize, usize)| {
            let (from, along) = (self.ring[i], self.ring[j] - self.ring[i]);
            let squared = self.distance_squared_from_star(from + 0.5 * along);
            if squared > GAP_NOISE * along.length_squared() { squared } else { 0.0 }
        };
        self.diagonals(floor).map(of).fold(0.0, f32::max)
    }

    /// Returns the unscaled normal of a new triangle; `None` if it would be flipped or a sliver.
    fn valid_normal(&self, [i, j, k]: [usize; 3]) -> Option<Vec3> {
        let corners @ [a, b, c] = [i, j, k].map(|x| self.ring[x]);
        let normal = (b - a).cross(c - a);
        let length = normal.length();
        let thinnest = SLIVER_QUALITY.min(self.least_quality);
        if length == 0.0 || quality(length, edges_squared(corners)) < thinnest {
            return None;
        }
        if self.plan_facing != 0.0 && self.plan_facing * area([i, j, k].map(|x| self.plan[x])) <= 0.0 {
            return None;
        }
        let facing = self.facing_of([i, j, k]);
        let follows_facing = normal.dot(facing) > FLIP_COSINE * length * facing.length();
        let follows = |t: usize| {
            let old = self.normals[t];
            self.is_normal_unreliable[t] || normal.dot(old) > FLIP_COSINE * length * old.length()
        };
        let is_sound = follows_facing
            && (j != i + 1 || follows(i))
            && (k != j + 1 || follows(j))
            && (!self.is_closed || i != 0 || k + 1 != self.n || follows(k));
        is_sound.then_some(normal)
    }

    fn facing_of(&self, [i, j, k]: [usize; 3]) -> Vec3 {
        self.facing[i][j] + self.facing[j][k] + self.facing[i][k]
    }
}
