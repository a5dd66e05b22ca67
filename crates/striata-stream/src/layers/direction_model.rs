//! Codes unit vectors: normals, and tangents with their sign.
//!
//! A direction is predicted from the directions around it and from the geometry: their mean, their affine
//! fit, the normal of the surrounding triangles, and the neighbors' directions **mirrored** at the plane
//! perpendicular to the edge to them. On a circular arc the mirrored direction is exact, regardless of where
//! on the arc the vertex lies. For each degree of conflict between geometry and neighbors, the model uses
//! the prediction, or learned sum of predictions, that did best recently. If they agree, geometry is
//! usually best; if not, the mean is.

use crate::entropy::{AdaptiveBit, Coder, Rate};
use crate::format::effort::Effort;
use crate::layers::directions::{Octahedron, scaled};
use crate::layers::history::LayerHistory;
use crate::layers::layer_neighborhood::{BASE_KIND, KINDS, LayerNeighborhood, LayerValues};
use crate::layers::least_squares::LeastSquares;
use crate::layers::residuals::{Expected, PredictorSelector, Residuals, SCALES, scale_of};

/// Bits of the length to which directions are scaled before they are added.
pub(crate) const UNIT_BITS: u32 = 15;

/// Fraction bits of a reciprocal.
const RECIPROCAL_BITS: u32 = 44;

/// Number of predictions that compete in the base mesh.
const CANDIDATES: usize = 10;
/// Number of predictions with a learned sum, which compete if the position has one vertex.
const SUMMED_CANDIDATES: usize = CANDIDATES + 1;
/// Maximum number of predictions, reached if the position has several vertices.
const MOST_CANDIDATES: usize = SUMMED_CANDIDATES + 4;
/// Number of terms in the learned sum, in addition to the first prediction.
const TERMS: usize = 4;
/// Initial weights of these terms, in 1/65536, if the position has one vertex: affine fit, mean, near
/// neighbors, all mirrored neighbors.
const FIRST_WEIGHTS: [i64; TERMS] = [26_000, -20_000, 10_000, 8_000];
/// Indices of the predictions.
const AFFINE: usize = 0;
const MEAN: usize = 1;
const GEOMETRIC: usize = 2;
const NEAR: usize = 4;
const MIRRORED: usize = 5;
const TARGET: usize = 7;
const SUM: usize = CANDIDATES;
const WHOLE: usize = SUMMED_CANDIDATES;
const SIBLING: usize = SUMMED_CANDIDATES + 3;
/// Maximum number of vertices of the same position from which a hidden vertex is predicted.
const MOST_SIBLINGS: u32 = 6;
/// Number of conflict classes.
const CONFLICTS: usize = SCALES.div_ceil(4);

/// Number of vertices after which the selectors learn only from every fourth vertex.
const LEARNING: u32 = 2048;

/// Model of a layer of unit vectors.
#[derive(Clone, Debug)]
pub(crate) struct DirectionModel {
    grid: Octahedron,
    /// By kind of vertex and conflict class of two octaves.
    selectors: Vec<PredictorSelector<MOST_CANDIDATES>>,
    residuals: Residuals,
    /// Residuals and copies of earlier vertices.
    history: LayerHistory,
    /// Weights of the learned sums, one set for each selector.
    sums: Vec<LeastSquares<TERMS>>,
    coded_count: u32,
    /// Whether the sign of the fourth component equals the target's.
    is_same_sign: Option<AdaptiveBit>,
}

/// Estimates of a direction from the geometry and the surrounding directions. All vectors have the same
/// length, or are zero.
struct Estimates {
    /// Direction of the vertex that it collapses to.
    target: [i64; 3],
    /// Mean of the ring.
    mean: [i64; 3],
    /// Affine fit to the ring.
    affine: [i64; 3],
    /// Estimate from the geometry.
    geometric: [i64; 3],
    /// Sum of the mirrored neighbors, and the sum in which near neighbors have more weight.
    mirrored: [i64; 3],
    near: [i64; 3],
    /// Mean distance of the ring's directions from their mean, in 1/16 grid steps.
    spread: u64,
}

impl Estimates {
    /// Uses the geometry alone, because no other direction is known.
    fn from_geometry(geometric: [i64; 3]) -> Self {
        let g = geometric;
        let (target, mean, affine, mirrored, near) = (g, g, g, g, g);
        Self { target, mean, affine, geometric, mirrored, near, spread: u64::from(u32::MAX) }
    }

    /// Estimates the direction of the next vertex.
    fn of(
        grid: Octahedron,
        values: &LayerValues,
        neighborhood: &LayerNeighborhood<'_>,
        geometric: [i64; 3],
    ) -> Self {
        let unit = unit_of(grid);
        let direction = |vertex: u32| {
            let integers = values.of(vertex);
            grid.direction([integers[0], integers[1]]).map(|x| x * (unit / grid.side()))
        };
        let geometric = scaled(geometric, unit);
        let Some(target) = neighborhood.target.map(direction) else { return Self::from_geometry(geometric) };
        let [mut mean, mut affine, mut mirrored, mut near] = [[0i64; 3]; 4];
        for ((&vertex, &arm), &weight) in
            neighborhood.ring.iter().zip(&neighborhood.fit.arms).zip(&neighborhood.fit.weights)
        {
            let d = direction(vertex);
            let dot = |a: [i64; 3], b: [i64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let reciprocal = (1 << RECIPROCAL_BITS) / dot(arm, arm).max(1);
            let along = (2 * dot(arm, d) * reciprocal) >> (RECIPROCAL_BITS - 16);
            for axis in 0..3 {
                let mirror = d[axis] - ((along * arm[axis]) >> 16);
                mean[axis] += d[axis];
                affine[axis] += d[axis] * i64::from(weight);
                mirrored[axis] += mirror;
                // The sum saturates if thousands of neighbors share the vertex's own position.
                near[axis] = near[axis].saturating_add(mirror * (reciprocal >> 12));
            }
        }
        let mean = scaled(if mean == [0; 3] { target } else { mean }, unit);
        let [affine, mirrored, near] = [affine, mirrored, near].map(|d| scaled(d, unit));
        let off: u64 = neighborhood.ring.iter().map(|&v| distance(direction(v), mean)).sum();
        let spread = grid.side() as u64 * 16 * off / (unit as u64 * neighborhood.ring.len().max(1) as u64);
        Self { target, mean, affine, geometric, mirrored, near, spread }
    }

    /// Returns the predictions of a vertex on its own in the order of their indices.
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

/// Length to which the directions of a grid are scaled before they are added: a multiple of its side.
fn unit_of(grid: Octahedron) -> i64 {
    grid.side() * (1 << UNIT_BITS >> (grid.side() + 1).ilog2()).max(1)
}

fn difference(a: [i64; 3], b: [i64; 3]) -> [i64; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

fn distance(a: [i64; 3], b: [i64; 3]) -> u64 {
    (0..3).map(|axis| (a[axis] - b[axis]).unsigned_abs()).sum()
}

/// Candidate predictions of a direction, and measures of their reliability.
struct DirectionPrediction {
    /// Contains `count` candidates, followed by repetitions.
    candidates: [[i64; 3]; MOST_CANDIDATES],
    count: usize,
    /// The first term of the learned sum, and the differences of the others from it.
    first: [i64; 3],
    terms: [[i64; 3]; TERMS],
    /// Mean distance of the ring's directions from their mean, and distance between mirrored neighbors
    /// and geometry, both in 1/16 grid steps.
    spread: u64,
    conflict: u64,
}

impl DirectionPrediction {
    /// Returns the predictions of a vertex on its own, without a learned sum.
    fn of(
        grid: Octahedron,
        values: &LayerValues,
        neighborhood: &LayerNeighborhood<'_>,
        geometric: [i64; 3],
    ) -> (Self, Estimates) {
        let estimates = Estimates::of(grid, values, neighborhood, geometric);
        let in_grid = |off: u64| off * 16 * grid.side() as u64 / unit_of(grid) as u64;
        let conflict = in_grid(distance(estimates.geometric, estimates.mirrored));
        let own = estimates.candidates();
        let mut candidates = [own[CANDIDATES - 1]; MOST_CANDIDATES];
        candidates[..CANDIDATES].copy_from_slice(&own);
        let (first, terms) = ([0; 3], [[0; 3]; TERMS]);
        let prediction =
            Self { candidates, count: CANDIDATES, first, terms, spread: estimates.spread, conflict };
        (prediction, estimates)
    }

    /// Adds the learned sum. All its terms already have the same length.
    fn add_sum(&mut self, kind: usize, sums: &[LeastSquares<TERMS>]) {
        let (first, others) = match kind {
            0 => (GEOMETRIC, [AFFINE, MEAN, NEAR, MIRRORED]),
            1 => (MEAN, [AFFINE, GEOMETRIC, WHOLE, SIBLING]),
            _ => (TARGET, [MEAN, WHOLE, WHOLE + 1, SIBLING]),
        };
        self.first = self.candidates[first];
        self.terms = others.map(|index| difference(self.candidates[index], self.first));
        let sum = sums[self.selector(kind)].predict(&self.terms);
        self.candidates[SUM] = std::array::from_fn(|axis| self.first[axis] + sum[axis]);
        self.count = self.count.max(SUMMED_CANDIDATES);
    }

    /// Returns the index of the selector for these predictions.
    fn selector(&self, kind: usize) -> usize {
        kind * CONFLICTS + scale_of(self.conflict) / 4
    }

    /// Returns the three predictions that differ most from each other in nature.
    fn main_candidates(&self, kind: usize) -> [[i64; 3]; 3] {
        let indices = match kind {
            0 | BASE_KIND => [AFFINE, GEOMETRIC, MIRRORED],
            1 => [AFFINE, WHOLE, SIBLING],
            _ => [TARGET, WHOLE, SIBLING],
        };
        indices.map(|index| self.candidates[index])
    }

    /// Adds predictions from the whole position to those of one of its vertices: a seam in the texture
    /// coordinates is often no seam in the normals.
    fn add_position(
        &mut self,
        grid: Octahedron,
        values: &LayerValues,
        neighborhood: &LayerNeighborhood<'_>,
        own: &Estimates,
    ) {
        let whole = neighborhood.whole.filter(|_| !neighborhood.is_hidden).map(|(ring, fit)| {
            let neighborhood = LayerNeighborhood { ring, fit, ..*neighborhood };
            Estimates::of(grid, values, &neighborhood, fit.normal)
        });
        let whole = whole.as_ref().unwrap_or(own);
        let sum = |a: [i64; 3], b: [i64; 3]| -> [i64; 3] { std::array::from_fn(|i| a[i] + b[i]) };
        let unit = unit_of(grid);
        let direction = |vertex: u32| {
            let of = values.of(vertex);
            grid.direction([of[0], of[1]]).map(|x| x * (unit / grid.side()))
        };
        // Same offset from the target as the previous vertex of the position has from its own target.
        let sibling = neighborhood.sibling_target.map_or(own.target, |other| {
            let change = sum(direction(values.vertex_count() as u32 - 1), direction(other).map(|x| -x));
            sum(own.target, change)
        });
        let more = if neighborhood.is_hidden && neighborhood.sibling_count > 0 {
            // The predictions already include the geometry of the whole position.
            let last = values.vertex_count() as u32 - 1;
            let latest = neighborhood.sibling_count.min(MOST_SIBLINGS);
            let mean = (0..latest).fold([0; 3], |mean, back| sum(mean, direction(last - back)));
            let mean = scaled(mean, unit);
            [direction(last), mean, sum(own.target, mean), sibling]
        } else {
            [whole.geometric, whole.mirrored, sum(whole.geometric, whole.mirrored), sibling]
        };
        self.candidates[WHOLE..].copy_from_slice(&more);
        self.count = MOST_CANDIDATES;
    }
}

/// Neighbors and surface normal, from which a direction is predicted.
pub(crate) struct DirectionPlace<'a> {
    /// Values of its neighbors.
    pub neighborhood: &'a LayerNeighborhood<'a>,
    /// Normal of the surface.
    pub geometric: [i64; 3],
}

impl DirectionModel {
    /// Creates an untrained model for integers with this number of bits.
    pub(crate) fn new(bits: u32, has_sign: bool, effort: Effort) -> Self {
        Self {
            grid: Octahedron::new(bits),
            selectors: vec![PredictorSelector::new(); KINDS * CONFLICTS],
            residuals: Residuals::new(effort, 2),
            history: LayerHistory::new(),
            sums: (0..KINDS * CONFLICTS)
                .map(|selector| {
                    LeastSquares::new(if selector < CONFLICTS { FIRST_WEIGHTS } else { [0; TERMS] })
                })
                .collect(),
            coded_count: 0,
            is_same_sign: has_sign.then(|| AdaptiveBit::new(Rate::Steady)),
        }
    }

    /// Codes the direction of the next vertex; a writer passes it as `actual`. `geometric` is the
    /// direction estimated from the geometry, of any length.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &mut LayerValues,
        DirectionPlace { neighborhood, geometric }: DirectionPlace<'_>,
        actual: Option<&[i32]>,
    ) {
        if let Some(vertex) = self.history.code_copy(coder, values, neighborhood, actual) {
            values.copy(vertex);
            self.history.record_copy();
            return;
        }
        let kind = neighborhood.kind();
        let prediction = self.prediction(values, neighborhood, geometric, kind);
        let best = self.selectors[prediction.selector(kind)].best(prediction.count);
        let predicted = self.grid.point(prediction.candidates[best]);
        let off = actual.map_or([0; 2], |m| self.grid.difference([m[0], m[1]], predicted));
        let off = self.residual(coder, (neighborhood, kind), (&prediction, predicted), off);
        let point = self.grid.moved(predicted, off);
        self.learn(point, &prediction, kind);
        let target_sign = neighborhood.target.and_then(|v| values.of(v).get(2).copied()).unwrap_or(1);
        values.push(&point);
        if let Some(is_same) = &mut self.is_same_sign {
            let is_same = is_same.code(coder, actual.is_none_or(|m| m[2] == target_sign));
            values.push(&[if is_same { target_sign } else { -target_sign }]);
        }
    }

    /// Returns all predictions of the next vertex.
    fn prediction(
        &self,
        values: &LayerValues,
        neighborhood: &LayerNeighborhood<'_>,
        geometric: [i64; 3],
        kind: usize,
    ) -> DirectionPrediction {
        let (mut prediction, estimates) = DirectionPrediction::of(self.grid, values, neighborhood, geometric);
        if kind > 0 && kind != BASE_KIND {
            prediction.add_position(self.grid, values, neighborhood, &estimates);
        }
        // Too little is known around vertices of the base mesh to learn a sum.
        if kind != BASE_KIND {
            prediction.add_sum(kind, &self.sums);
        }
        prediction
    }

    /// Codes the difference between the direction and its prediction.
    fn residual<C: Coder>(
        &mut self,
        coder: &mut C,
        (neighborhood, kind): (&LayerNeighborhood<'_>, usize),
        (prediction, predicted): (&DirectionPrediction, [i32; 2]),
        off: [i32; 2],
    ) -> [i32; 2] {
        let ring = scale_of(1 << (neighborhood.ring.len() / 2).min(16));
        let scales = [
            scale_of(prediction.spread),
            scale_of(prediction.conflict),
            self.history.scale_around(neighborhood),
        ];
        let [a, b, c] = scales;
        let others = if self.residuals.looks_at_others() {
            prediction
                .main_candidates(kind)
                .map(|other| self.grid.difference(self.grid.point(other), predicted))
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
        self.history.record_residual(size);
        [x, y]
    }

    /// Updates the learned sums and selectors.
    fn learn(&mut self, point: [i32; 2], prediction: &DirectionPrediction, kind: usize) {
        let selector = prediction.selector(kind);
        self.coded_count = self.coded_count.wrapping_add(1);
        let is_early = self.coded_count < LEARNING;
        if prediction.count > CANDIDATES && (is_early || self.coded_count.is_multiple_of(2)) {
            let unit = unit_of(self.grid) / self.grid.side();
            let actual = self.grid.direction(point).map(|x| x * unit);
            // Errors below two grid steps all count alike.
            self.sums[selector].learn(&prediction.terms, difference(actual, prediction.first), 2 * unit);
        }
        if self.coded_count > LEARNING && !self.coded_count.is_multiple_of(4) {
            return;
        }
        let mut off = [0; MOST_CANDIDATES];
        for (off, &candidate) in off.iter_mut().zip(&prediction.candidates[..prediction.count]) {
            let [x, y] = self.grid.difference(point, self.grid.point(candidate));
            *off = u64::from(x.unsigned_abs()) + u64::from(y.unsigned_abs());
        }
        self.selectors[selector].learn(off);
    }

    /// Removes the history of all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        self.history.truncate(vertex_count);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layers::ring_fit::RingFit;

    #[test]
    fn mirrored_neighbors_are_exact_on_a_sphere() {
        let grid = Octahedron::new(12);
        let grid_point = |d: [f64; 3]| -> [i32; 3] { d.map(|x| (x * 2000.0) as i32) };
        let unit = |x: f64, y: f64| {
            let length = (x * x + y * y + 1.0).sqrt();
            [x / length, y / length, 1.0 / length]
        };
        // A ring whose vertices are all on one side.
        let ring = [unit(0.4, 0.1), unit(0.5, 0.4), unit(0.1, 0.5), unit(0.3, 0.3)];
        let here = unit(0.1, 0.0);
        let point = |d: [f64; 3]| grid.point(d.map(|x| (x * 1e6) as i64));
        let values = LayerValues::from_integers(ring.iter().flat_map(|&d| point(d)).collect(), 2);
        let mut fit = RingFit::default();
        fit.measure(grid_point(here), &ring.map(grid_point), true);
        let neighborhood = LayerNeighborhood::new(Some(0), &[0, 1, 2, 3], &fit);
        let estimates = Estimates::of(grid, &values, &neighborhood, fit.normal);
        let off = |d: [i64; 3]| {
            let difference = grid.difference(point(here), grid.point(d));
            difference[0].abs().max(difference[1].abs())
        };
        assert!(off(estimates.mirrored) < 5 && off(estimates.near) < 5, "{}", off(estimates.mirrored));
        assert!(off(estimates.mean) > 200);
    }
}
