//! The densities of a new vertex's place, axis by axis.

use super::super::super::entropy::log2_q8;
use super::super::hood::Hood;
use super::axis::{Axis, SIZES, SPREADS};
use super::blend::Features;
use super::bumps::{Bumps, Width};
use super::guesses::{Guesses, KINDS, MIDDLE, MOVED, STRAIGHT, guess};
use super::local::{LANES, Local, Point};

/// Within which distance, in 1/256 of the radius, a guess of the first and of the second axis counts for more: widely, narrowly.
const NEAR: [[i32; 2]; 2] = [[45, 10], [130, 20]];
/// What a guess counts that was far off, and how much more one that was narrowly right; widely right is 256.
const FAR_WORTH: i32 = 60;
const NARROW_WORTH: i32 = 400;

/// What is known of one new vertex, with the first `USED` kinds of guesses.
#[derive(Clone, Debug)]
pub(super) struct Sight<const USED: usize> {
    /// What is around it.
    pub(super) local: Local,
    guesses: [Guesses; KINDS],
    bumps: [Bumps; USED],
    /// How much each guess counts, by what is known of the vertex already.
    weights: [[i32; LANES]; USED],
}

impl<const USED: usize> Sight<USED> {
    /// True where guesses need what is two rings away.
    pub(super) const LOOKS_BEYOND: bool = USED > STRAIGHT;

    /// Nothing seen yet.
    pub(super) fn new() -> Self {
        Self {
            local: Local::default(),
            guesses: [Guesses::default(); KINDS],
            bumps: [Bumps::default(); USED],
            weights: [[0; LANES]; USED],
        }
    }

    /// Looks at the surroundings of another vertex.
    pub(super) fn look(&mut self, hood: &Hood<'_>) {
        self.local.look(hood, Self::LOOKS_BEYOND);
        guess(&self.local, &mut self.guesses);
        for (weights, guesses) in self.weights.iter_mut().zip(&self.guesses) {
            *weights = std::array::from_fn(|j| if j < guesses.count { 1 << 16 } else { 0 });
        }
    }

    /// The normal of the ring, and the axes from the most tangential to the most normal.
    pub(super) fn order(&self) -> ([i64; 3], [usize; 3]) {
        let local = &self.local;
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

    /// Puts the bumps where the guesses are along an axis, given what is known of the place.
    pub(super) fn aim(&mut self, slot: usize, (normal, axes): ([i64; 3], [usize; 3]), place: [i32; 3]) {
        if slot == 2 {
            self.move_along(normal, axes, place);
            self.raise_planes(axes, place);
        } else {
            for (bumps, guesses) in self.bumps.iter_mut().zip(&self.guesses) {
                bumps.at = guesses.at[axes[slot]];
            }
        }
        // Weights of a density sum up to 2^14.
        let total: i64 = self.weights.as_flattened().iter().map(|&w| i64::from(w)).sum();
        let factor = (1i64 << 40) / total.max(1);
        for (bumps, weights) in self.bumps.iter_mut().zip(&self.weights) {
            for (weight, &w) in bumps.weight.iter_mut().zip(weights) {
                *weight = ((i64::from(w) * factor) >> 26) as i16;
            }
        }
    }

    /// Moves all guesses along the ring's plane to what is known of the vertex.
    fn move_along(&mut self, normal: [i64; 3], axes: [usize; 3], place: [i32; 3]) {
        let [a, b, c] = axes;
        let [x, y] = [a, b].map(|a| self.local.localise_axis(place[a], a));
        let steep = if normal[c] == 0 { 1 } else { normal[c] };
        let [dx, dy] = [a, b].map(|a| (normal[a] * 4096 / steep) as i32);
        for (bumps, guesses) in self.bumps.iter_mut().zip(&self.guesses) {
            for j in 0..LANES {
                let off = dx * (x - i32::from(guesses.at[a][j])) + dy * (y - i32::from(guesses.at[b][j]));
                let moved = i32::from(guesses.at[c][j]) - (off >> 12);
                bumps.at[j] = moved.clamp(-16_000, 16_000) as i16;
            }
        }
    }

    /// Puts the heights of the planes across ring edges in the place of a kind.
    fn raise_planes(&mut self, [a, b, c]: [usize; 3], place: [i32; 3]) {
        let local = &self.local;
        let [x, y] = [a, b].map(|a| local.localise_axis(place[a], a));
        let mut count = 0;
        self.weights[MOVED] = [0; LANES];
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
            self.bumps[MOVED].at[count] = (i64::from(p[c]) - rise).clamp(-16_000, 16_000) as i16;
            self.weights[MOVED][count] = 1 << 14;
            count += 1;
        }
        self.guesses[MOVED].count = count;
    }

    /// What the blends are made of.
    pub(super) fn features(&self) -> Features {
        let mut features = Features { base: i32::from(self.bumps[MIDDLE].at[0]), off: [0; KINDS] };
        let (mut sum, mut total) = (0, 0);
        for (kind, (bumps, guesses)) in self.bumps.iter().zip(&self.guesses).enumerate() {
            if guesses.count > 0 {
                let all: i32 = bumps.at[..guesses.count].iter().map(|&x| i32::from(x)).sum();
                features.off[kind] = all / guesses.count as i32 - features.base;
            }
            for (&weight, &at) in bumps.weight.iter().zip(&bumps.at) {
                sum += i32::from(weight) * i32::from(at);
                total += i32::from(weight);
            }
        }
        features.off[MIDDLE] = sum / total.max(1) - features.base;
        features
    }

    /// What one axis is coded with.
    pub(super) fn axis<const WIDTHS: usize>(
        &self,
        axis: usize,
        widths: [u32; WIDTHS],
        expected: i32,
        place: usize,
        features: &Features,
    ) -> Axis<'_, USED, WIDTHS> {
        let local = &self.local;
        // Guesses are no better than the grid.
        let narrowest = local.shift.clamp(0, 13) as u32;
        let size = 2 * (local.shift + 16) + (local.radius >> 9 & 1);
        let spread = log2_q8(features.spread() * 1024 / local.radius as u32 + 16) - 1024;
        Axis {
            local,
            axis,
            bumps: &self.bumps,
            widths: widths.map(|width| Width::new(width.max(narrowest))),
            centre: local.to_grid(expected, axis),
            size: (size as usize).min(SIZES - 1),
            place,
            spread: (spread >> 7).clamp(0, SPREADS as i32 - 1) as usize,
        }
    }

    /// Guesses far from what was found count less from now on.
    pub(super) fn reweigh(&mut self, slot: usize, found: i32) {
        let [wide, narrow] = NEAR[slot].map(|reach| {
            let reach = (self.local.radius * reach) >> 8;
            (reach, (1 << 22) / reach)
        });
        for (weights, bumps) in self.weights.iter_mut().zip(&self.bumps) {
            for (weight, &at) in weights.iter_mut().zip(&bumps.at) {
                let off = (i32::from(at) - found).abs();
                let near = |(reach, inverse): (i32, i32)| ((reach - off).max(0) * inverse) >> 14;
                let (wide, narrow) = (near(wide), near(narrow));
                let worth = FAR_WORTH + ((wide * wide + ((NARROW_WORTH * narrow * narrow) >> 8)) >> 8);
                *weight = (*weight * worth) >> 9;
            }
        }
    }
}

fn minus(p: Point, q: Point) -> Point {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn cross(p: Point, q: Point) -> [i64; 3] {
    let part = |b: usize, c: usize| i64::from(p[b]) * i64::from(q[c]) - i64::from(p[c]) * i64::from(q[b]);
    [part(1, 2), part(2, 0), part(0, 1)]
}
