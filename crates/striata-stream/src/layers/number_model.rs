//! Codes numbers that can be interpolated: texture coordinates, colors, joint weights.
//!
//! Each component is predicted from the target, from the ring's mean and its affine fit, and from the
//! offset that the previous vertex of the same position has from its target. The model uses the
//! prediction that did best recently. The residual is coded in the context of how far the ring's values
//! spread around the prediction and how well the surrounding vertices could be predicted.

use crate::entropy::Coder;
use crate::format::effort::Effort;
use crate::layers::form::{LayerForm, NumberType, ValueTransform};
use crate::layers::history::LayerHistory;
use crate::layers::layer_neighborhood::{KINDS, LayerNeighborhood, LayerValues};
use crate::layers::residuals::{Expected, PredictorSelector, Residuals, scale_of};
use crate::layers::ring_fit::WEIGHT_BITS;

/// Number of competing predictions.
const PREDICTIONS: usize = 5;

/// Predictions of one integer, and measures of their reliability.
pub(crate) struct NumberPredictions {
    predictions: [i64; PREDICTIONS],
    /// Distance between two of them, in 1/16.
    conflict: u64,
    /// Mean distance of the ring's values from their mean, in 1/16.
    spread: u64,
}

impl NumberPredictions {
    /// Makes all predictions the same value, with the largest uncertainty.
    fn constant(value: i64) -> Self {
        Self { predictions: [value; PREDICTIONS], conflict: u64::from(u32::MAX), spread: u64::from(u32::MAX) }
    }
}

/// Predicts a component from the same component of the surrounding vertices.
pub(crate) fn predict_number(
    values: &LayerValues,
    neighborhood: &LayerNeighborhood<'_>,
    component: usize,
) -> NumberPredictions {
    let value = |vertex: u32| i64::from(values.of(vertex)[component]);
    let Some(target) = neighborhood.target.map(value) else { return NumberPredictions::constant(0) };
    // Same offset from the target as the previous vertex of the position has from its own target.
    let sibling = neighborhood
        .sibling_target
        .map_or(target, |other| target + value(values.vertex_count() as u32 - 1) - value(other));
    if neighborhood.ring.is_empty() {
        return NumberPredictions::constant(target);
    }
    let n = neighborhood.ring.len() as i64;
    let (mut sum, mut weighted) = (0, 0);
    for (&vertex, &weight) in neighborhood.ring.iter().zip(&neighborhood.fit.weights) {
        let from_target = value(vertex) - target;
        sum += from_target;
        weighted += from_target * i64::from(weight);
    }
    let mean = target + (2 * sum + n).div_euclid(2 * n);
    let affine = target + ((weighted + (1 << WEIGHT_BITS >> 1)) >> WEIGHT_BITS);
    let spread: u64 = neighborhood.ring.iter().map(|&v| (value(v) - mean).unsigned_abs()).sum();
    let conflict = 16 * (affine - mean).unsigned_abs();
    NumberPredictions {
        conflict,
        predictions: [affine, mean, (affine + mean) >> 1, target, sibling],
        spread: 16 * spread / n as u64,
    }
}

/// Predicts a weight from the weights that the surrounding vertices give to the same joint.
pub(crate) fn predict_weight(
    values: &LayerValues,
    joints: &LayerValues,
    neighborhood: &LayerNeighborhood<'_>,
    coded: &[i32],
) -> NumberPredictions {
    let component = coded.len();
    let joint = joints.of(values.vertex_count() as u32)[component];
    let weight = |vertex: u32| -> i64 {
        let (joints, weights) = (joints.of(vertex), values.of(vertex));
        // Prefers the same component, since joints with zero weight may repeat.
        let at = Some(component).filter(|&c| joints[c] == joint);
        at.or_else(|| joints.iter().position(|&j| j == joint)).map_or(0, |c| i64::from(weights[c]))
    };
    let Some(target) = neighborhood.target else { return NumberPredictions::constant(0) };
    let sum: i64 = values.of(target).iter().map(|&w| i64::from(w)).sum();
    let left = sum - coded.iter().map(|&w| i64::from(w)).sum::<i64>();
    let n = neighborhood.ring.len().max(1) as i64;
    let mean = neighborhood.ring.iter().map(|&v| weight(v)).sum::<i64>() / n;
    let spread: u64 = neighborhood.ring.iter().map(|&v| (weight(v) - mean).unsigned_abs()).sum();
    let rest = left.clamp(0, sum.max(0));
    let conflict = 16 * (mean - rest).unsigned_abs();
    NumberPredictions {
        conflict,
        predictions: [mean, rest, weight(target), mean.min(rest), mean],
        spread: 16 * spread / n as u64,
    }
}

/// Model of a layer of numbers.
#[derive(Clone, Debug)]
pub(crate) struct NumberModel {
    /// By kind of vertex and component.
    selectors: Vec<PredictorSelector<PREDICTIONS>>,
    residuals: Residuals,
    /// Residuals and copies of earlier vertices.
    history: LayerHistory,
    /// Smallest and largest possible value.
    limits: (i64, i64),
    /// Components of the current vertex coded so far.
    coded: Vec<i32>,
}

/// Neighbors, from which the values at a vertex are predicted, and the values for an encoder.
pub(crate) struct NumberPlace<'a> {
    /// Values of its neighbors.
    pub neighborhood: &'a LayerNeighborhood<'a>,
    /// The values, if they are known.
    pub actual: Option<&'a [i32]>,
}

impl NumberModel {
    /// Creates an untrained model.
    pub(crate) fn new(form: &LayerForm, effort: Effort) -> Self {
        let limits = match (&form.transform, form.number_type) {
            (ValueTransform::Uniform { bits, .. }, _) => (0, (1i64 << bits) - 1),
            (_, NumberType::U8) => (0, 0xFF),
            (_, NumberType::U16) => (0, 0xFFFF),
            (_, NumberType::I8) => (-0x80, 0x7F),
            (_, NumberType::I16) => (-0x8000, 0x7FFF),
            _ => (i64::from(i32::MIN), i64::from(i32::MAX)),
        };
        let count = form.integer_count();
        Self {
            selectors: vec![PredictorSelector::new(); KINDS * count],
            residuals: Residuals::new(effort, count),
            history: LayerHistory::new(),
            limits,
            coded: Vec::with_capacity(count),
        }
    }

    /// Codes the integers of the next vertex; a writer passes them as `actual`.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &mut LayerValues,
        NumberPlace { neighborhood, actual }: NumberPlace<'_>,
        predict: impl Fn(&LayerValues, &[i32]) -> NumberPredictions,
    ) {
        if let Some(vertex) = self.history.code_copy(coder, values, neighborhood, actual) {
            values.copy(vertex);
            self.history.record_copy();
            return;
        }
        self.coded.clear();
        let kind = neighborhood.kind();
        let around = self.history.scale_around(neighborhood);
        let count = values.integer_count();
        let (mut before, mut sum) = (0, 0);
        for component in 0..count {
            let NumberPredictions { predictions, conflict, spread } = predict(values, &self.coded);
            let set = kind * count + component;
            let [affine, mean, _, target, sibling] = predictions;
            let selector = &mut self.selectors[set];
            let predicted =
                predictions[selector.best(PREDICTIONS)].clamp(self.limits.0, self.limits.1) as i32;
            let scales = [scale_of(spread), scale_of(conflict), around, scale_of(before)];
            let off = actual.map_or(0, |m| m[component].wrapping_sub(predicted));
            let third = if neighborhood.sibling_target.is_none() { target } else { sibling };
            let others = [affine, mean, third].map(|other| other - i64::from(predicted));
            let off = self.residuals.signed(coder, set, Expected { scales, others }, off);
            let value = predicted.wrapping_add(off);
            selector.learn(predictions.map(|p| (p - i64::from(value)).unsigned_abs()));
            before = 16 * u64::from(off.unsigned_abs());
            sum += u64::from(off.unsigned_abs());
            self.coded.push(value);
        }
        values.push(&self.coded);
        self.history.record_residual(sum);
    }

    /// Removes the history of all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        self.history.truncate(vertex_count);
    }
}
