//! Codes unit vectors: normals, and tangents with their sign.
//!
//! A direction is predicted from those around and from the geometry: their mean and affine fit, the normal of the triangles
//! around, and the directions of neighbours **mirrored** at the plane across the edge to them. On a circle's arc the
//! last is exact, wherever on the arc the vertex lies. Which of these, or which sum of them, did best lately is asked for
//! each degree of conflict between geometry and neighbours: where they agree geometry is best, where not the mean.

use super::super::entropy::{AdaptiveBit, Coder, Rate};
use super::Effort;
use super::directions::{Octahedron, scaled};
use super::layer_model::{LayerHood, LayerValues};
use super::residuals::{Contest, Residuals, SCALES, scale_of};

/// Bits of the length that directions have where they are added.
const UNIT_BITS: u32 = 15;

/// Bits of a reciprocal.
const RECIPROCAL_BITS: u32 = 44;

/// Predictions that compete.
const CANDIDATES: usize = 10;

/// Vertices after which only every fourth tells which prediction did best.
const LEARNING: u32 = 2048;

/// Unit vectors.
#[derive(Clone, Debug)]
pub(super) struct DirectionModel {
    grid: Octahedron,
    /// By scale of the conflict, two octaves each.
    contests: Vec<Contest<CANDIDATES>>,
    residuals: Residuals,
    /// What was off lately, in 1/16.
    recent: u64,
    coded_count: u32,
    /// Whether the sign of a fourth component is as the target's.
    is_same_sign: Option<AdaptiveBit>,
}

/// What is known of a direction before it is coded; all vectors are of one length, or zero.
struct Outlook {
    target: [i64; 3],
    mean: [i64; 3],
    affine: [i64; 3],
    geometric: [i64; 3],
    /// The sum of the mirrored neighbours, and the same with near ones counting more.
    mirrored: [i64; 3],
    near: [i64; 3],
    /// How far the ring is from its mean, in 1/16 of the grid.
    spread: u64,
}

impl Outlook {
    /// Knows nothing but the geometry.
    fn alone(geometric: [i64; 3]) -> Self {
        let g = geometric;
        let (target, mean, affine, mirrored, near) = (g, g, g, g, g);
        Self { target, mean, affine, geometric, mirrored, near, spread: u64::from(u32::MAX) }
    }

    fn of(grid: Octahedron, values: &LayerValues, hood: &LayerHood<'_>) -> Self {
        let unit = unit_of(grid);
        let direction = |vertex: u32| {
            let integers = values.of(vertex);
            grid.direction([integers[0], integers[1]]).map(|x| x * (unit / grid.side()))
        };
        let geometric = scaled(hood.fit.normal, unit);
        let Some(target) = hood.target.map(direction) else { return Self::alone(geometric) };
        let [mut mean, mut affine, mut mirrored, mut near] = [[0i64; 3]; 4];
        for ((&vertex, &arm), &weight) in hood.ring.iter().zip(&hood.fit.arms).zip(&hood.fit.weights) {
            let d = direction(vertex);
            let dot = |a: [i64; 3], b: [i64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let reciprocal = (1 << RECIPROCAL_BITS) / dot(arm, arm).max(1);
            let along = (2 * dot(arm, d) * reciprocal) >> (RECIPROCAL_BITS - 16);
            for axis in 0..3 {
                let mirror = d[axis] - ((along * arm[axis]) >> 16);
                mean[axis] += d[axis];
                affine[axis] += d[axis] * i64::from(weight);
                mirrored[axis] += mirror;
                near[axis] += mirror * (reciprocal >> 12);
            }
        }
        let mean = scaled(if mean == [0; 3] { target } else { mean }, unit);
        let [affine, mirrored, near] = [affine, mirrored, near].map(|d| scaled(d, unit));
        let off: u64 = hood.ring.iter().map(|&v| distance(direction(v), mean)).sum();
        let spread = grid.side() as u64 * 16 * off / (unit as u64 * hood.ring.len().max(1) as u64);
        Self { target, mean, affine, geometric, mirrored, near, spread }
    }

    fn candidates(&self) -> [[i64; 3]; CANDIDATES] {
        let sum = |geometric: i64, mirrored: i64, mean: i64| -> [i64; 3] {
            std::array::from_fn(|a| {
                geometric * self.geometric[a] + mirrored * self.mirrored[a] + mean * self.mean[a]
            })
        };
        let sums = [sum(1, 0, 1), sum(1, 1, 0), sum(4, 4, -1), sum(6, 2, -1)];
        let [a, b, c, d] = sums;
        [self.affine, self.mean, self.geometric, a, self.near, self.mirrored, b, self.target, c, d]
    }
}

/// The length of directions on a grid where they are added: a multiple of its side.
fn unit_of(grid: Octahedron) -> i64 {
    grid.side() * (1 << UNIT_BITS >> (grid.side() + 1).ilog2()).max(1)
}

fn distance(a: [i64; 3], b: [i64; 3]) -> u64 {
    (0..3).map(|axis| (a[axis] - b[axis]).unsigned_abs()).sum()
}

impl DirectionModel {
    /// Nothing learned, for integers of so many bits.
    pub(super) fn new(bits: u32, has_sign: bool, effort: Effort) -> Self {
        Self {
            grid: Octahedron::new(bits),
            contests: vec![Contest::new(); SCALES.div_ceil(4)],
            residuals: Residuals::new(effort, 2),
            recent: 0,
            coded_count: 0,
            is_same_sign: has_sign.then(|| AdaptiveBit::new(Rate::Steady)),
        }
    }

    /// Codes the direction of the next vertex, `meant` by a writer.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &mut LayerValues,
        hood: &LayerHood<'_>,
        meant: Option<&[i32]>,
    ) {
        let outlook = Outlook::of(self.grid, values, hood);
        let conflict = distance(outlook.geometric, outlook.mirrored) * 16 * self.grid.side() as u64
            / unit_of(self.grid) as u64;
        let candidates = outlook.candidates();
        let contest = scale_of(conflict) / 4;
        let predicted = self.grid.point(candidates[self.contests[contest].best()]);
        let off = meant.map_or([0; 2], |m| self.grid.difference([m[0], m[1]], predicted));
        let ring = 1 << (hood.ring.len() / 2).min(16);
        let scales = [outlook.spread, conflict, self.recent, ring].map(scale_of);
        let x = self.residuals.signed(coder, 0, scales, off[0]);
        let scales = [scales[0], scales[1], scales[2], scale_of(16 * u64::from(x.unsigned_abs()))];
        let y = self.residuals.signed(coder, 1, scales, off[1]);
        self.recent = (7 * self.recent + 8 * (u64::from(x.unsigned_abs()) + u64::from(y.unsigned_abs()))) / 8;
        let point = self.grid.moved(predicted, [x, y]);
        self.learn(point, &candidates, contest);
        let target_sign = hood.target.and_then(|v| values.of(v).get(2).copied()).unwrap_or(1);
        values.push(&point);
        if let Some(is_same) = &mut self.is_same_sign {
            let is_same = is_same.code(coder, meant.is_none_or(|m| m[2] == target_sign));
            values.push(&[if is_same { target_sign } else { -target_sign }]);
        }
    }

    fn learn(&mut self, point: [i32; 2], candidates: &[[i64; 3]; CANDIDATES], contest: usize) {
        self.coded_count = self.coded_count.wrapping_add(1);
        if self.coded_count > LEARNING && !self.coded_count.is_multiple_of(4) {
            return;
        }
        self.contests[contest].learn(candidates.map(|candidate| {
            let [x, y] = self.grid.difference(point, self.grid.point(candidate));
            u64::from(x.unsigned_abs()) + u64::from(y.unsigned_abs())
        }));
    }
}
