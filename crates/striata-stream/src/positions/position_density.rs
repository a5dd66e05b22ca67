//! The guesses at a new vertex's position as densities, axis by axis.

use wide::{i16x8, i32x4};

use super::axis::{AxisInput, DISTANCES, SIZES, SPREADS};
use super::bumps::{Bumps, Width};
use super::guesses::{ACROSS, Guesses, INSIDE, KINDS, MIDDLE, PLANES, guess};
use super::local::{LANES, LocalRing, Point};
use crate::entropy::log2_q8;
use crate::topology::neighborhood::Neighborhood;

/// Distances, in 1/256 of the radius, within which a guess gains weight after the first and the second
/// axis: a wide and a narrow one.
const NEAR: [[i32; 2]; 2] = [[45, 10], [130, 20]];
/// Weight factor of a guess that was far off. One within the wide distance gains up to 12288, one within
/// the narrow distance up to 16384 more.
const FAR_FACTOR: i16 = 2800;
/// Initial weights of guesses, and of plane heights when they are added.
const INITIAL_WEIGHT: i16 = 1 << 9;
const INITIAL_PLANE_WEIGHT: i16 = 400;
/// Number of features that a coordinate is blended from.
pub(super) const FEATURES: usize = KINDS + 4;
/// Reciprocals: 4096 divided by each number.
pub(super) const INVERSES: [i32; LANES + 1] = [0, 4096, 2048, 1365, 1024, 819, 683, 585, 512];

/// Guesses at one new vertex, and their weights.
#[derive(Clone, Debug)]
pub(super) struct PositionDensity {
    /// The surroundings of the vertex.
    pub local: LocalRing,
    guesses: [Guesses; KINDS],
    bumps: [Bumps; KINDS],
    is_last: bool,
    /// Whether the last axis points against the normal.
    is_inward: bool,
    /// By axis, the vertex that split and three points derived from it.
    kept: [[i32; 4]; 3],
    /// Weight of each guess, given the coordinates known so far.
    weights: [i16x8; KINDS],
}

impl PositionDensity {
    /// Creates an empty state.
    pub(super) fn new() -> Self {
        Self {
            local: LocalRing::default(),
            guesses: [Guesses::default(); KINDS],
            bumps: [Bumps::default(); KINDS],
            weights: [i16x8::ZERO; KINDS],
            is_last: false,
            is_inward: false,
            kept: [[0; 4]; 3],
        }
    }

    /// Gathers the surroundings of another vertex and makes its guesses.
    pub(super) fn gather(&mut self, neighborhood: &Neighborhood<'_>) {
        self.local.gather(neighborhood);
        guess(&self.local, &mut self.guesses);
        self.kept = kept_points(&self.local);
        for (weights, guesses) in self.weights.iter_mut().zip(&self.guesses) {
            *weights = first_lanes(guesses.count) & i16x8::splat(INITIAL_WEIGHT);
        }
    }

    /// Moves the bumps to the guesses along an axis, given the coordinates known so far.
    pub(super) fn move_bumps(&mut self, slot: usize, normal: [i64; 3], axes: [usize; 3], coords: [i32; 3]) {
        self.is_last = slot == 2;
        self.is_inward = normal[axes[2]] < 0;
        if slot == 2 {
            self.move_guesses_along_surface(normal, axes, coords);
            self.add_plane_heights(axes, coords);
        } else {
            for (bumps, guesses) in self.bumps.iter_mut().zip(&self.guesses) {
                bumps.at = guesses.at[axes[slot]];
            }
        }
        // The sum of all weights is scaled to between 2^14 and 2^15.
        let total: i32 = self.weights.iter().map(|weights| sum(weights.dot(i16x8::ONE))).sum();
        let lift = 14 - total.max(1).ilog2() as i32;
        for (bumps, weights) in self.bumps.iter_mut().zip(&mut self.weights) {
            *weights = if lift >= 0 { *weights << lift as u32 } else { *weights >> -lift as u32 };
            bumps.weight = weights.to_array();
        }
    }

    /// Moves all guesses along the ring's plane to the known coordinates of the vertex.
    fn move_guesses_along_surface(&mut self, normal: [i64; 3], axes: [usize; 3], coords: [i32; 3]) {
        let [a, b, c] = axes;
        let [x, y] = [a, b].map(|a| self.local.to_local_axis(coords[a], a));
        let steepness = if normal[c] == 0 { 1 } else { normal[c] };
        for at in 0..4 {
            let rise =
                normal[a] * i64::from(x - self.kept[a][at]) + normal[b] * i64::from(y - self.kept[b][at]);
            self.kept[c][at] = (i64::from(self.kept[c][at]) - rise / steepness).clamp(-16_000, 16_000) as i32;
        }
        // Slopes of at most 1, in 1/16384; differences of a few radii, times 4.
        let slopes = [a, b].map(|a| i16x8::splat((normal[a] * 16_383 / steepness) as i16));
        let known = [x, y].map(|x| i16x8::splat(x as i16));
        for (bumps, guesses) in self.bumps.iter_mut().zip(&self.guesses) {
            let [rise, more] = [(a, 0), (b, 1)].map(|(a, i)| {
                let off = known[i].saturating_sub(i16x8::new(guesses.at[a]));
                let off: i16x8 = off.max(i16x8::splat(-8191)).min(i16x8::splat(8191)) << 2u32;
                off.mul_keep_high(slopes[i])
            });
            let moved = i16x8::new(guesses.at[c]).saturating_sub(rise).saturating_sub(more);
            bumps.at = moved.to_array();
        }
    }

    /// Adds as guesses the heights of the planes across ring edges.
    fn add_plane_heights(&mut self, [a, b, c]: [usize; 3], coords: [i32; 3]) {
        let local = &self.local;
        let [x, y] = [a, b].map(|a| local.to_local_axis(coords[a], a));
        let mut count = 0;
        for i in 0..local.count {
            let j = if i + 1 == local.count { 0 } else { i + 1 };
            let (Some(p), Some(q), Some(r)) = (local.ring[i], local.ring[j], local.apexes[i]) else {
                continue;
            };
            let normal = cross(minus(q, p), minus(r, p));
            if 2 * normal[c].abs() <= normal[a].abs().max(normal[b].abs()) {
                continue;
            }
            let rise = (normal[a] * i64::from(x - p[a]) + normal[b] * i64::from(y - p[b])) / normal[c];
            self.bumps[PLANES].at[count] = (i64::from(p[c]) - rise).clamp(-16_000, 16_000) as i16;
            count += 1;
        }
        self.guesses[PLANES].count = count;
        self.weights[PLANES] = first_lanes(count) & i16x8::splat(INITIAL_PLANE_WEIGHT);
    }

    /// Returns the center of the ring, and the features from which a coordinate is blended, relative to
    /// it. They are the mean of each kind of guess (for the middles, the weighted mean of all guesses)
    /// and the points derived from the vertex that split.
    pub(super) fn features(&self, axis: usize) -> (i32, [i32; FEATURES]) {
        let base = i32::from(self.bumps[MIDDLE].at[0]);
        let mut features = [0; FEATURES];
        let (mut all, mut total) = (0, 0);
        for (kind, (bumps, guesses)) in self.bumps.iter().zip(&self.guesses).enumerate() {
            let (at, weight) = (i16x8::new(bumps.at), i16x8::new(bumps.weight));
            if guesses.count > 0 {
                let sum = sum(at.dot(first_lanes(guesses.count) & i16x8::ONE));
                features[kind] = ((sum * INVERSES[guesses.count]) >> 12) - base;
            }
            all += sum(at.dot(weight)) >> 4;
            total += sum(weight.dot(i16x8::ONE));
        }
        features[MIDDLE] = all / (total >> 4).max(1) - base;
        features[KINDS..].copy_from_slice(&self.kept[axis].map(|x| x - base));
        (base, features)
    }

    /// Returns the input for coding one axis: the expected coordinate, densities and context classes.
    pub(super) fn axis(
        &self,
        axis: usize,
        width: u32,
        (expected, context): (i32, usize),
        features: &[i32; FEATURES],
    ) -> AxisInput<'_> {
        let local = &self.local;
        // Guesses are no more precise than the grid.
        let narrowest = local.shift.clamp(0, 13) as u32;
        let size = 2 * (local.shift + 16) + (local.radius >> 9 & 1);
        let distance = (self.kept[axis][0] - expected).abs();
        let is_mirrored = if self.is_last { self.is_inward } else { self.kept[axis][0] < expected };
        let spread = [INSIDE, ACROSS].iter().map(|&kind| features[kind].unsigned_abs()).sum::<u32>();
        let spread = log2_q8(spread * 1024 / local.radius as u32 + 16) - 1024;
        AxisInput {
            local,
            axis,
            bumps: &self.bumps,
            width: Width::new(width.max(narrowest)),
            // Plus one if mirrored, so that the expected cell is the first one above the center in either
            // direction.
            center: local.to_grid(expected, axis).wrapping_add(i32::from(is_mirrored)),
            is_last: self.is_last,
            is_mirrored,
            size: (size as usize).min(SIZES - 1),
            context,
            distance: (distance * 16 / local.radius).min(DISTANCES as i32 - 1) as usize,
            spread: (spread >> 7).clamp(0, SPREADS as i32 - 1) as usize,
        }
    }

    /// Reduces the weights of guesses that were far from the actual coordinate.
    pub(super) fn reweight(&mut self, slot: usize, found: i32) {
        let found = i16x8::splat(found as i16);
        let reaches = NEAR[slot].map(|reach| {
            let reach = (self.local.radius * reach) >> 8;
            let lift = 13 - reach.ilog2();
            (i16x8::splat(reach as i16), i16x8::splat((((1 << 28) / (reach << lift)) - 1) as i16), lift)
        });
        for (weights, bumps) in self.weights.iter_mut().zip(&self.bumps) {
            let off = found.saturating_sub(i16x8::new(bumps.at));
            let off = off.max(-off);
            let [wide, narrow] = reaches.map(|(reach, inverse, lift)| {
                // A distance of zero gives 2^14.
                let near: i16x8 = reach.saturating_sub(off).max(i16x8::ZERO) << lift;
                let near: i16x8 = near.mul_keep_high(inverse) << 2u32;
                near.mul_keep_high(near)
            });
            let factor = i16x8::splat(FAR_FACTOR) + wide + (wide << 1u32) + (narrow << 2u32);
            *weights = weights.mul_keep_high(factor);
        }
    }
}

/// Returns the normal of the ring, and the axes from the most tangential to the most normal.
pub(super) fn normal_order(local: &LocalRing) -> ([i64; 3], [usize; 3]) {
    let mut normal = [0i64; 3];
    for i in 0..local.count {
        let j = if i + 1 == local.count { 0 } else { i + 1 };
        let (Some(p), Some(q)) = (local.ring[i], local.ring[j]) else { continue };
        normal.iter_mut().zip(cross(p, q)).for_each(|(sum, x)| *sum += x);
    }
    let mut axes = [0, 1, 2];
    axes.sort_by_key(|&a| normal[a].abs());
    (normal, axes)
}

/// Returns, for each axis, the vertex that split, the midpoint of its neighbors in the ring, that of
/// their other neighbors, and that of the vertices across its edges to its neighbors.
fn kept_points(local: &LocalRing) -> [[i32; 4]; 3] {
    let n = local.count;
    let kept = local.ring[0].unwrap_or_default();
    let adjacent = mean(local.ring[1 % n], local.ring[n - 1]);
    let further = mean(local.ring[2 % n], local.ring[(2 * n - 2) % n]);
    let behind = mean(local.apexes[0], local.apexes[n - 1]);
    [0, 1, 2].map(|a| [kept[a], adjacent[a], further[a], behind[a]])
}

/// Returns the midpoint of two points, or the only known one.
pub(super) fn mean(p: Option<Point>, q: Option<Point>) -> Point {
    match (p, q) {
        (Some(p), Some(q)) => [0, 1, 2].map(|a| (p[a] + q[a]) >> 1),
        (p, q) => p.or(q).unwrap_or_default(),
    }
}

fn minus(p: Point, q: Point) -> Point {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn cross(p: Point, q: Point) -> [i64; 3] {
    let part = |b: usize, c: usize| i64::from(p[b]) * i64::from(q[c]) - i64::from(p[c]) * i64::from(q[b]);
    [part(1, 2), part(2, 0), part(0, 1)]
}

fn sum(lanes: i32x4) -> i32 {
    lanes.to_array().iter().sum()
}

/// Returns a mask of the first lanes.
fn first_lanes(count: usize) -> i16x8 {
    i16x8::new([0, 1, 2, 3, 4, 5, 6, 7]).simd_lt(i16x8::splat(count as i16))
}
