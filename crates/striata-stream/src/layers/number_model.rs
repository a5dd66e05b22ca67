//! Codes integers on an even scale: texture coordinates, colors, weights of joints.
//!
//! Each component is predicted from the target, the ring's mean and its affine fit, and from how the vertex before it at the
//! same position changed; the prediction that did best lately is taken. The rest is coded in the context of how far the
//! ring spreads around the prediction and how well the vertices around could be predicted.

use crate::entropy::Coder;
use crate::format::form::{Effort, StreamVersion};
use crate::layers::form::{LayerForm, NumberType, Transform};
use crate::layers::history::LayerHistory;
use crate::layers::layer_neighborhood::{KINDS, LayerNeighborhood, LayerValues};
use crate::layers::residuals::{Expected, PredictorSelector, Residuals, scale_of};
use crate::layers::ring_fit::WEIGHT_BITS;

/// Predictions that compete: in version 1 the first four.
const PREDICTIONS: usize = 5;

/// Predictions of one integer, and how far those around spread.
pub(crate) struct NumberPredictions {
    predictions: [i64; PREDICTIONS],
    /// How far two of them are from each other, in 1/16.
    conflict: u64,
    /// The mean distance of the ring's values from their mean, in 1/16.
    spread: u64,
}

impl NumberPredictions {
    fn constant(value: i64) -> Self {
        Self { predictions: [value; PREDICTIONS], conflict: u64::from(u32::MAX), spread: u64::from(u32::MAX) }
    }
}

/// Predictions of a component by its values around.
pub(crate) fn predict_number(
    values: &LayerValues,
    neighborhood: &LayerNeighborhood<'_>,
    component: usize,
) -> NumberPredictions {
    let value = |vertex: u32| i64::from(values.of(vertex)[component]);
    let Some(target) = neighborhood.target.map(value) else { return NumberPredictions::constant(0) };
    // As far from the target as the vertex before it at the same position is from its own.
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

/// Predictions of the weight of a component's joint, by the weights that the vertices around give to that joint.
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
        // The same joint at the same place, since names of joints without weight repeat.
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

/// Integers on an even scale.
#[derive(Clone, Debug)]
pub(crate) struct NumberModel {
    /// By kind of vertex and component.
    selectors: Vec<PredictorSelector<PREDICTIONS>>,
    residuals: Residuals,
    /// What each component was off lately, for version 1.
    recent: Vec<u64>,
    /// What is known of earlier vertices, from version 2 on.
    history: Option<LayerHistory>,
    /// Smallest and largest value there can be.
    limits: (i64, i64),
    /// The vertex that is being coded.
    coded: Vec<i32>,
}

impl NumberModel {
    /// Nothing learned.
    pub(crate) fn new(form: &LayerForm, parameters: (Effort, StreamVersion)) -> Self {
        let limits = match (&form.transform, form.number_type) {
            (Transform::Uniform { bits, .. }, _) => (0, (1i64 << bits) - 1),
            (_, NumberType::U8) => (0, 0xFF),
            (_, NumberType::U16) => (0, 0xFFFF),
            _ => (i64::from(i32::MIN), i64::from(i32::MAX)),
        };
        let count = form.integer_count();
        Self {
            selectors: vec![PredictorSelector::new(parameters.1); KINDS * count],
            residuals: Residuals::new(parameters, count),
            recent: vec![0; count],
            history: (parameters.1 > StreamVersion::One).then(LayerHistory::new),
            limits,
            coded: Vec::with_capacity(count),
        }
    }

    /// Codes the integers of the next vertex, `meant` by a writer.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        values: &mut LayerValues,
        (neighborhood, actual): (&LayerNeighborhood<'_>, Option<&[i32]>),
        predict: impl Fn(&LayerValues, &[i32]) -> NumberPredictions,
    ) {
        if let Some(history) = &mut self.history
            && let Some(vertex) = history.code_copy(coder, values, neighborhood, actual)
        {
            values.copy(vertex);
            history.record_copy();
            return;
        }
        self.coded.clear();
        let kind = if self.history.is_some() { neighborhood.kind() } else { 0 };
        let known = if self.history.is_some() { PREDICTIONS } else { 4 };
        let around = self.history.as_ref().map(|history| history.scale_around(neighborhood));
        let count = values.integer_count();
        let (mut before, mut sum) = (0, 0);
        for component in 0..count {
            let NumberPredictions { predictions, conflict, spread } = predict(values, &self.coded);
            let set = kind * count + component;
            let [affine, mean, _, target, sibling] = predictions;
            let selector = &mut self.selectors[set];
            let predicted = predictions[selector.best(known)].clamp(self.limits.0, self.limits.1) as i32;
            let lately = around.unwrap_or_else(|| scale_of(self.recent[component]));
            let scales = [scale_of(spread), scale_of(conflict), lately, scale_of(before)];
            let off = actual.map_or(0, |m| m[component].wrapping_sub(predicted));
            let third = if neighborhood.sibling_target.is_none() { target } else { sibling };
            let others = [affine, mean, third].map(|other| other - i64::from(predicted));
            let off = self.residuals.signed(coder, set, Expected { scales, others }, off);
            let value = predicted.wrapping_add(off);
            selector.learn(predictions.map(|p| (p - i64::from(value)).unsigned_abs()));
            before = 16 * u64::from(off.unsigned_abs());
            self.recent[component] = (7 * self.recent[component] + before) / 8;
            sum += u64::from(off.unsigned_abs());
            self.coded.push(value);
        }
        values.push(&self.coded);
        if let Some(history) = &mut self.history {
            history.record_residual(sum);
        }
    }

    /// Forgets what is known of all but the first vertices.
    pub(crate) fn truncate(&mut self, vertex_count: usize) {
        if let Some(history) = &mut self.history {
            history.truncate(vertex_count);
        }
    }
}
