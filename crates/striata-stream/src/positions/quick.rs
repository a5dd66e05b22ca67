//! Codes positions from one prediction that was made ahead: the fastest model to decode.
//!
//! The prediction blends the center of the ring, the points suggested by the surrounding triangles, and
//! the vertex that split, with learned weights. The residual is one symbol per axis and its low bits.

use super::ahead::{POINTS, Prediction, Surroundings};
use super::residual::{ResidualAxis, ResidualContext};
use crate::entropy::{Coder, log2_q8};

/// Number of spread classes.
const SPREADS: usize = 16;
/// Number of valence classes, which have separate weights.
const VALENCES: usize = 4;

/// A position model that predicts all vertices of a stretch ahead.
#[derive(Clone, Debug)]
pub(crate) struct QuickPositions {
    /// First vertex of the stretch, and the predictions of it and the following vertices.
    first: u32,
    predictions: Vec<Prediction>,
    /// By direction (along or across the surface) and valence.
    weights: [[[i32; POINTS]; VALENCES]; 2],
    axes: [ResidualAxis; 3],
}

impl QuickPositions {
    /// Creates an untrained model.
    pub(super) fn new() -> Self {
        Self {
            first: 0,
            predictions: Vec::new(),
            weights: [[[16_000, 0, 0]; VALENCES]; 2],
            axes: std::array::from_fn(|_| ResidualAxis::new(SPREADS * VALENCES)),
        }
    }

    /// Begins a stretch whose new vertices start at `first`.
    pub(super) fn begin_stretch(&mut self, first: u32) {
        self.first = first;
        self.predictions.clear();
    }

    /// Predicts the next vertex of the stretch.
    pub(crate) fn look_ahead(&mut self, around: &Surroundings) {
        self.predictions.push(Prediction::new(around));
    }

    /// Codes the grid coordinates of a vertex of the stretch that has been predicted.
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, vertex: u32, actual: [i32; 3]) -> [i32; 3] {
        let prediction = &self.predictions[(vertex - self.first) as usize];
        let valence = prediction.count.clamp(4, 7) - 4;
        let mut coords = [0; 3];
        // Change of the last axis's prediction due to the first two coordinates.
        let mut rise = 0;
        for (slot, &a) in prediction.axes.iter().enumerate() {
            let features = &prediction.features[a];
            let weights = &mut self.weights[slot / 2][valence];
            let expected = predict(weights, features);
            let lifted = if slot < 2 { expected } else { (expected + rise).clamp(-8000, 8000) };
            let center = prediction.to_grid(lifted, a);
            let spread =
                ((log2_q8(features[0].unsigned_abs() + 16) - 1024) >> 7).clamp(0, SPREADS as i32 - 1);
            let spread = spread as usize * VALENCES + valence;
            let context = ResidualContext { size: prediction.size, spread, noise: prediction.noise(slot) };
            let residual = actual[a].wrapping_sub(center);
            coords[a] = center.wrapping_add(self.axes[slot].code(coder, context, residual));
            let found = prediction.distance_from_center(coords[a], a);
            learn(weights, features, (found - lifted).clamp(-prediction.radius, prediction.radius));
            if slot < 2 {
                rise -= ((found - expected) * prediction.slopes[slot]) >> 12;
            }
        }
        coords
    }
}

/// Returns the weighted sum of features, in local units.
#[inline]
fn predict(weights: &[i32; POINTS], features: &[i32; POINTS]) -> i32 {
    let sum: i64 = weights.iter().zip(features).map(|(&w, &x)| i64::from(w) * i64::from(x)).sum();
    (sum >> 16) as i32
}

/// Moves the weights along the gradient of the squared error. In local units, one step size suits all rings.
#[inline]
fn learn(weights: &mut [i32; POINTS], features: &[i32; POINTS], error: i32) {
    for (weight, &x) in weights.iter_mut().zip(features) {
        *weight = (*weight + ((x * error) >> LEARN_SHIFT)).clamp(-1 << 18, 1 << 18);
    }
}

/// Weights move by the product of feature and error, shifted right by this.
const LEARN_SHIFT: u32 = 10;
