//! A weighted sum of features that predicts a coordinate. Its weights adapt to the actual coordinates.

/// Learning rate, in 1/65536.
const RATE: i64 = 2000;
/// Added to the squared length of the features, so that small features do not cause large steps.
const DAMPING: i64 = 40_000;

/// Weights of the features.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blend<const N: usize> {
    weights: [i32; N],
}

impl<const N: usize> Blend<N> {
    /// Creates a blend with initial weights, in 1/65536.
    pub(super) fn new(weights: [i32; N]) -> Self {
        Self { weights }
    }

    /// Returns the prediction. Features and prediction are distances from the center of the ring.
    #[inline]
    pub(super) fn predict(&self, features: &[i32; N]) -> i32 {
        let sum: i64 = self.weights.iter().zip(features).map(|(&w, &x)| i64::from(w) * i64::from(x)).sum();
        (sum >> 16) as i32
    }

    /// Adapts the weights to the error of a prediction, by normalized least mean squares.
    #[inline]
    pub(super) fn learn(&mut self, features: &[i32; N], error: i32) {
        let power = features.iter().map(|&x| i64::from(x) * i64::from(x)).sum::<i64>() + DAMPING;
        let pull = (i64::from(error) * (RATE << 12)) / power;
        for (weight, &x) in self.weights.iter_mut().zip(features) {
            let step = (i64::from(x) * pull) >> 12;
            *weight = (i64::from(*weight) + step).clamp(-1 << 18, 1 << 18) as i32;
        }
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;

    #[test]
    fn a_blend_learns_the_weights_of_its_features() {
        let mut random = Random::new(1);
        let mut blend = Blend::new([0; 3]);
        let mut last = 0;
        for _ in 0..4000 {
            let features = [(); 3].map(|()| random.below(2000) as i32 - 1000);
            let truth = features[0] / 2 - features[1] / 4 + random.below(20) as i32;
            last = (truth - blend.predict(&features)).abs();
            blend.learn(&features, truth - blend.predict(&features));
        }
        assert!(last < 60, "{last}");
        assert!((blend.weights[0] - 32_768).abs() < 2500 && (blend.weights[1] + 16_384).abs() < 2500);
    }
}
