//! Positions from one prediction that was made ahead: the quickest to read.
//!
//! The prediction blends the middle of the ring, what the triangles around it point to, and the vertex that split, by learned
//! weights. What is left is one symbol an axis, and the bits below.

use super::ahead::{Outlook, POINTS, Surroundings};
use super::residual::{Circumstances, code_residual};
use crate::entropy::{AdaptiveNumber, Coder, QuickSymbol, Rate, code_by_two, log2_q8};

/// Kinds of sizes, and kinds of disagreement.
const SIZES: usize = 64;
const SPREADS: usize = 16;
/// Kinds of rings and axes that have weights of their own.
const VALENCES: usize = 4;

/// How slowly symbols are learned in the end.
const LAST_SHIFT: u32 = 7;

/// A model of positions that looks ahead.
#[derive(Clone, Debug)]
pub(crate) struct QuickPositions {
    /// The first vertex of the stretch, and what is foretold of it and the next ones.
    first: u32,
    outlooks: Vec<Outlook>,
    /// Along the surface and across it, by valence.
    weights: [[[i32; POINTS]; VALENCES]; 2],
    axes: [QuickAxis; 3],
}

/// How far off predictions are along an axis: zero, or a sign and a bucket (1, 2 to 3, ..), all else being noise.
#[derive(Clone, Debug)]
struct QuickAxis {
    by_size: Vec<QuickSymbol>,
    by_spread: Vec<QuickSymbol>,
    far: AdaptiveNumber,
}

impl QuickAxis {
    fn new() -> Self {
        Self {
            by_size: vec![QuickSymbol::new(16); SIZES],
            by_spread: vec![QuickSymbol::new(16); SPREADS * VALENCES],
            far: AdaptiveNumber::new(SIZES, Rate::Steady),
        }
    }

    /// Codes how far off the prediction is.
    #[inline]
    fn code<C: Coder>(&mut self, coder: &mut C, at: Circumstances, actual: i32) -> i32 {
        let Self { by_size, by_spread, far } = self;
        let models = [&mut by_size[at.size], &mut by_spread[at.spread]];
        code_residual(coder, far, at, actual, |coder, meant| code_by_two(coder, models, meant, LAST_SHIFT))
    }
}

impl QuickPositions {
    /// Knows nothing yet.
    pub(super) fn new() -> Self {
        Self {
            first: 0,
            outlooks: Vec::new(),
            weights: [[[16_000, 0, 0]; VALENCES]; 2],
            axes: [QuickAxis::new(), QuickAxis::new(), QuickAxis::new()],
        }
    }

    /// A stretch makes vertices from this one on.
    pub(super) fn begin_stretch(&mut self, first: u32) {
        self.first = first;
        self.outlooks.clear();
    }

    /// Looks ahead at the next vertex of the stretch.
    pub(crate) fn look_ahead(&mut self, around: &Surroundings) {
        self.outlooks.push(Outlook::new(around));
    }

    /// Codes the place of a vertex of the stretch that was looked ahead at.
    pub(super) fn code<C: Coder>(&mut self, coder: &mut C, vertex: u32, actual: [i32; 3]) -> [i32; 3] {
        let outlook = &self.outlooks[(vertex - self.first) as usize];
        let valence = outlook.count.clamp(4, 7) - 4;
        let mut place = [0; 3];
        // What the place found so far adds to the height of the last axis.
        let mut rise = 0;
        for (slot, &a) in outlook.axes.iter().enumerate() {
            let features = &outlook.features[a];
            let weights = &mut self.weights[slot / 2][valence];
            let expected = predict(weights, features);
            let lifted = if slot < 2 { expected } else { (expected + rise).clamp(-8000, 8000) };
            let center = outlook.to_grid(lifted, a);
            let spread =
                ((log2_q8(features[0].unsigned_abs() + 16) - 1024) >> 7).clamp(0, SPREADS as i32 - 1);
            let spread = spread as usize * VALENCES + valence;
            let circumstances = Circumstances { size: outlook.size, spread, noise: outlook.noise(slot) };
            let residual = actual[a].wrapping_sub(center);
            place[a] = center.wrapping_add(self.axes[slot].code(coder, circumstances, residual));
            let found = outlook.off_middle(place[a], a);
            learn(weights, features, (found - lifted).clamp(-outlook.radius, outlook.radius));
            if slot < 2 {
                rise -= ((found - expected) * outlook.slopes[slot]) >> 12;
            }
        }
        place
    }
}

/// Where features point to, in local units.
#[inline]
fn predict(weights: &[i32; POINTS], features: &[i32; POINTS]) -> i32 {
    let sum: i64 = weights.iter().zip(features).map(|(&w, &x)| i64::from(w) * i64::from(x)).sum();
    (sum >> 16) as i32
}

/// Moves weights along the gradient of the squared error. Local units make steps of one size fit all rings.
#[inline]
fn learn(weights: &mut [i32; POINTS], features: &[i32; POINTS], error: i32) {
    for (weight, &x) in weights.iter_mut().zip(features) {
        *weight = (*weight + ((x * error) >> LEARN_SHIFT)).clamp(-1 << 18, 1 << 18);
    }
}

/// Weights move by the product of feature and error over 2 to this.
const LEARN_SHIFT: u32 = 10;
