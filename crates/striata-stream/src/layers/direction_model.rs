//! Codes unit vectors: normals, and tangents with their sign.
//!
//! A direction is predicted from those around and from the geometry: their mean and affine fit, the normal of the triangles
//! around, and the directions of neighbors **mirrored** at the plane across the edge to them. On a circle's arc the
//! last is exact, wherever on the arc the vertex lies. Which of these, or which sum of them, did best lately is asked for
//! each degree of conflict between geometry and neighbors: where they agree geometry is best, where not the mean.

use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::format::form::{Effort, StreamVersion};
use crate::layers::directions::{Octahedron, scaled};
use crate::layers::history::LayerHistory;
use crate::layers::hood::{BASE_KIND, KINDS, LayerHood, LayerValues};
use crate::layers::least_squares::LeastSquares;
use crate::layers::residuals::{Contest, Expected, Residuals, SCALES, scale_of};

/// Bits of the length that directions have where they are added.
pub(crate) const UNIT_BITS: u32 = 15;

/// Bits of a reciprocal.
const RECIPROCAL_BITS: u32 = 44;

/// Predictions that compete at the only vertex of a position.
const CANDIDATES: usize = 10;
/// The same from version 2 on, where a learned sum is among them.
const SUMMED_CANDIDATES: usize = CANDIDATES + 1;
/// Predictions that compete at one of several vertices of a position.
const MOST_CANDIDATES: usize = SUMMED_CANDIDATES + 4;
/// Predictions that are added up, besides the first.
const TERMS: usize = 4;
/// Their weights at first, in 1/65536, at the only vertex of a position: of the affine fit, the mean, near neighbors and all
/// of them.
const FIRST_WEIGHTS: [i64; TERMS] = [26_000, -20_000, 10_000, 8_000];
/// Places among the predictions.
const AFFINE: usize = 0;
const MEAN: usize = 1;
const GEOMETRIC: usize = 2;
const NEAR: usize = 4;
const MIRRORED: usize = 5;
const TARGET: usize = 7;
const SUM: usize = CANDIDATES;
const WHOLE: usize = SUMMED_CANDIDATES;
const BESIDE: usize = SUMMED_CANDIDATES + 3;
/// Vertices of the same position that a hidden one is predicted from.
const MOST_SIBLINGS: u32 = 6;
/// Classes of conflicts.
const CONFLICTS: usize = SCALES.div_ceil(4);

/// Vertices after which only every fourth tells which prediction did best.
const LEARNING: u32 = 2048;

/// Unit vectors.
#[derive(Clone, Debug)]
pub(crate) struct DirectionModel {
    grid: Octahedron,
    /// By kind of vertex and scale of the conflict, two octaves each.
    contests: Vec<Contest<MOST_CANDIDATES>>,
    residuals: Residuals,
    /// What was off lately, in 1/16, for version 1.
    recent: u64,
    /// What is known of earlier vertices, from version 2 on.
    history: Option<LayerHistory>,
    /// Weights of sums of predictions, for each contest.
    sums: Vec<LeastSquares<TERMS>>,
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
    /// The sum of the mirrored neighbors, and the same with near ones counting more.
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

    fn of(grid: Octahedron, values: &LayerValues, (hood, geometric): (&LayerHood<'_>, [i64; 3])) -> Self {
        let unit = unit_of(grid);
        let direction = |vertex: u32| {
            let integers = values.of(vertex);
            grid.direction([integers[0], integers[1]]).map(|x| x * (unit / grid.side()))
        };
        let geometric = scaled(geometric, unit);
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
                // Thousands of neighbors at the very place are too many for the sum.
                near[axis] = near[axis].saturating_add(mirror * (reciprocal >> 12));
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

fn difference(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

fn distance(a: [i64; 3], b: [i64; 3]) -> u64 {
    (0..3).map(|axis| (a[axis] - b[axis]).unsigned_abs()).sum()
}

/// Predictions of a direction, and how sure they are.
struct Forecast {
    /// As many as `count`, then repetitions.
    candidates: [[i64; 3]; MOST_CANDIDATES],
    count: usize,
    /// What is added up: a first prediction, and differences of others from it.
    first: [i64; 3],
    terms: [[i64; 3]; TERMS],
    /// How far the ring is from its mean, and neighbors from the geometry, in 1/16 of the grid.
    spread: u64,
    conflict: u64,
}

impl Forecast {
    /// What version 1 predicts.
    fn of(
        grid: Octahedron,
        values: &LayerValues,
        (hood, geometric): (&LayerHood<'_>, [i64; 3]),
    ) -> (Self, Outlook) {
        let outlook = Outlook::of(grid, values, (hood, geometric));
        let in_grid = |off: u64| off * 16 * grid.side() as u64 / unit_of(grid) as u64;
        let conflict = in_grid(distance(outlook.geometric, outlook.mirrored));
        let own = outlook.candidates();
        let mut candidates = [own[CANDIDATES - 1]; MOST_CANDIDATES];
        candidates[..CANDIDATES].copy_from_slice(&own);
        let (first, terms) = ([0; 3], [[0; 3]; TERMS]);
        let forecast = Self { candidates, count: CANDIDATES, first, terms, spread: outlook.spread, conflict };
        (forecast, outlook)
    }

    /// Adds the sum whose weights were learned. What is added up is of one length as it is.
    fn add_sum(&mut self, kind: usize, sums: &[LeastSquares<TERMS>]) {
        let (first, others) = match kind {
            0 => (GEOMETRIC, [AFFINE, MEAN, NEAR, MIRRORED]),
            1 => (MEAN, [AFFINE, GEOMETRIC, WHOLE, BESIDE]),
            _ => (TARGET, [MEAN, WHOLE, WHOLE + 1, BESIDE]),
        };
        self.first = self.candidates[first];
        self.terms = others.map(|place| difference(self.candidates[place], self.first));
        let sum = sums[self.contest(kind)].predict(&self.terms);
        self.candidates[SUM] = std::array::from_fn(|axis| self.first[axis] + sum[axis]);
        self.count = self.count.max(SUMMED_CANDIDATES);
    }

    /// Which contest its predictions are in.
    fn contest(&self, kind: usize) -> usize {
        kind * CONFLICTS + scale_of(self.conflict) / 4
    }

    /// The predictions that differ most in kind.
    fn main(&self, kind: usize) -> [[i64; 3]; 3] {
        let places = match kind {
            0 | BASE_KIND => [AFFINE, GEOMETRIC, MIRRORED],
            1 => [AFFINE, WHOLE, BESIDE],
            _ => [TARGET, WHOLE, BESIDE],
        };
        places.map(|place| self.candidates[place])
    }

    /// What the whole position says of one of its vertices: seams of texture coordinates are none of normals.
    fn add_position(
        &mut self,
        grid: Octahedron,
        values: &LayerValues,
        (hood, own): (&LayerHood<'_>, &Outlook),
    ) {
        let whole = hood.whole.filter(|_| !hood.is_hidden).map(|(ring, fit)| {
            let hood = LayerHood { ring, fit, ..*hood };
            Outlook::of(grid, values, (&hood, fit.normal))
        });
        let whole = whole.as_ref().unwrap_or(own);
        let sum = |a: [i64; 3], b: [i64; 3]| -> [i64; 3] { std::array::from_fn(|i| a[i] + b[i]) };
        let unit = unit_of(grid);
        let direction = |vertex: u32| {
            let of = values.of(vertex);
            grid.direction([of[0], of[1]]).map(|x| x * (unit / grid.side()))
        };
        // As far from the target as the vertex before it is from its own.
        let beside = hood.sibling_target.map_or(own.target, |other| {
            let change = sum(direction(values.vertex_count() as u32 - 1), direction(other).map(|x| -x));
            sum(own.target, change)
        });
        let more = if hood.is_hidden && hood.sibling_count > 0 {
            // The geometry of the whole position is among the predictions already.
            let last = values.vertex_count() as u32 - 1;
            let latest = hood.sibling_count.min(MOST_SIBLINGS);
            let mean = (0..latest).fold([0; 3], |mean, back| sum(mean, direction(last - back)));
            let mean = scaled(mean, unit);
            [direction(last), mean, sum(own.target, mean), beside]
        } else {
            [whole.geometric, whole.mirrored, sum(whole.geometric, whole.mirrored), beside]
        };
        self.candidates[WHOLE..].copy_from_slice(&more);
        self.count = MOST_CANDIDATES;
    }
}

impl DirectionModel {
    /// Nothing learned, for integers of so many bits.
    pub(crate) fn new(bits: u32, has_sign: bool, terms: (Effort, StreamVersion)) -> Self {
        Self {
            grid: Octahedron::new(bits),
            contests: vec![Contest::new(terms.1); KINDS * CONFLICTS],
            residuals: Residuals::new(terms, 2),
            recent: 0,
            history: (terms.1 > StreamVersion::One).then(LayerHistory::new),
            sums: (0..KINDS * CONFLICTS)
                .map(|contest| {
                    LeastSquares::new(if contest < CONFLICTS { FIRST_WEIGHTS } else { [0; TERMS] })
                })
                .collect(),
            coded_count: 0,
            is_same_sign: has_sign.then(|| AdaptiveBit::new(Rate::Steady)),
        }
    }

    /// Codes the direction of the next vertex, `meant` by a writer; the geometry tells of a direction of any length.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &mut LayerValues,
        (hood, geometric): (&LayerHood<'_>, [i64; 3]),
        meant: Option<&[i32]>,
    ) {
        if let Some(history) = &mut self.history
            && let Some(vertex) = history.copied(coder, values, hood, meant)
        {
            values.copy(vertex);
            history.note_copy();
            return;
        }
        let kind = if self.history.is_some() { hood.kind() } else { 0 };
        let forecast = self.forecast(values, (hood, geometric), kind);
        let best = self.contests[forecast.contest(kind)].best(forecast.count);
        let predicted = self.grid.point(forecast.candidates[best]);
        let off = meant.map_or([0; 2], |m| self.grid.difference([m[0], m[1]], predicted));
        let off = self.residual(coder, (hood, kind), (&forecast, predicted), off);
        let point = self.grid.moved(predicted, off);
        self.learn(point, &forecast, kind);
        let target_sign = hood.target.and_then(|v| values.of(v).get(2).copied()).unwrap_or(1);
        values.push(&point);
        if let Some(is_same) = &mut self.is_same_sign {
            let is_same = is_same.code(coder, meant.is_none_or(|m| m[2] == target_sign));
            values.push(&[if is_same { target_sign } else { -target_sign }]);
        }
    }

    /// All predictions of the next vertex.
    fn forecast(
        &self,
        values: &LayerValues,
        (hood, geometric): (&LayerHood<'_>, [i64; 3]),
        kind: usize,
    ) -> Forecast {
        let (mut forecast, outlook) = Forecast::of(self.grid, values, (hood, geometric));
        if kind > 0 && kind != BASE_KIND {
            forecast.add_position(self.grid, values, (hood, &outlook));
        }
        // Around a vertex of the base little is known, and that is as nothing elsewhere.
        if self.history.is_some() && kind != BASE_KIND {
            forecast.add_sum(kind, &self.sums);
        }
        forecast
    }

    /// Codes what a prediction was off.
    fn residual<C: Coder>(
        &mut self,
        coder: &mut C,
        (hood, kind): (&LayerHood<'_>, usize),
        (forecast, predicted): (&Forecast, [i32; 2]),
        off: [i32; 2],
    ) -> [i32; 2] {
        let lately = match &self.history {
            Some(history) => history.scale_around(hood),
            None => scale_of(self.recent),
        };
        let ring = scale_of(1 << (hood.ring.len() / 2).min(16));
        let scales = [scale_of(forecast.spread), scale_of(forecast.conflict), lately];
        let [a, b, c] = scales;
        let others = if self.residuals.looks_at_others() {
            forecast.main(kind).map(|other| self.grid.difference(self.grid.point(other), predicted))
        } else {
            [[0; 2]; 3]
        };
        let others = [0, 1].map(|axis| others.map(|other| i64::from(other[axis])));
        let expected = Expected { scales: [a, b, c, ring], others: others[0] };
        let x = self.residuals.signed(coder, 2 * kind, expected, off[0]);
        let first = scale_of(16 * u64::from(x.unsigned_abs()));
        let expected = Expected { scales: [a, b, c, first], others: others[1] };
        let y = self.residuals.signed(coder, 2 * kind + 1, expected, off[1]);
        let size = u64::from(x.unsigned_abs()) + u64::from(y.unsigned_abs());
        self.recent = (7 * self.recent + 8 * size) / 8;
        if let Some(history) = &mut self.history {
            history.note(size);
        }
        [x, y]
    }

    fn learn(&mut self, point: [i32; 2], forecast: &Forecast, kind: usize) {
        let contest = forecast.contest(kind);
        self.coded_count = self.coded_count.wrapping_add(1);
        let is_early = self.coded_count < LEARNING;
        if forecast.count > CANDIDATES && (is_early || self.coded_count.is_multiple_of(2)) {
            let unit = unit_of(self.grid) / self.grid.side();
            let meant = self.grid.direction(point).map(|x| x * unit);
            // Errors of two steps are as good as none.
            self.sums[contest].learn(&forecast.terms, difference(meant, forecast.first), 2 * unit);
        }
        if self.coded_count > LEARNING && !self.coded_count.is_multiple_of(4) {
            return;
        }
        let mut off = [0; MOST_CANDIDATES];
        for (off, &candidate) in off.iter_mut().zip(&forecast.candidates[..forecast.count]) {
            let [x, y] = self.grid.difference(point, self.grid.point(candidate));
            *off = u64::from(x.unsigned_abs()) + u64::from(y.unsigned_abs());
        }
        self.contests[contest].learn(off);
    }

    /// Forgets what is known of all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        if let Some(history) = &mut self.history {
            history.truncate(vertex_count);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layers::ring_fit::RingFit;

    #[test]
    fn on_a_sphere_mirrored_neighbors_are_exact() {
        let grid = Octahedron::new(12);
        let place = |d: [f64; 3]| -> [i32; 3] { d.map(|x| (x * 2000.0) as i32) };
        let unit = |x: f64, y: f64| {
            let length = (x * x + y * y + 1.0).sqrt();
            [x / length, y / length, 1.0 / length]
        };
        // A ring that is all on one side.
        let ring = [unit(0.4, 0.1), unit(0.5, 0.4), unit(0.1, 0.5), unit(0.3, 0.3)];
        let here = unit(0.1, 0.0);
        let point = |d: [f64; 3]| grid.point(d.map(|x| (x * 1e6) as i64));
        let values = LayerValues::from_integers(ring.iter().flat_map(|&d| point(d)).collect(), 2);
        let mut fit = RingFit::default();
        fit.measure(place(here), &ring.map(place), true);
        let hood = LayerHood::new(Some(0), &[0, 1, 2, 3], &fit);
        let outlook = Outlook::of(grid, &values, (&hood, fit.normal));
        let off = |d: [i64; 3]| {
            let difference = grid.difference(point(here), grid.point(d));
            difference[0].abs().max(difference[1].abs())
        };
        assert!(off(outlook.mirrored) < 5 && off(outlook.near) < 5, "{}", off(outlook.mirrored));
        assert!(off(outlook.mean) > 200);
    }
}
