//! A weighted sum of what might tell a coordinate, its weights learned from what came.

/// How much of an error the weights take in, in 1/65536.
const RATE: i64 = 2000;
/// What is added to the squares of the features.
const CALM: i64 = 40_000;

/// Weights of features.
#[derive(Clone, Copy, Debug)]
pub(super) struct Blend<const N: usize> {
    weights: [i32; N],
}

impl<const N: usize> Blend<N> {
    /// These weights at first, in 1/65536.
    pub(super) fn new(weights: [i32; N]) -> Self {
        Self { weights }
    }

    /// Where the features point to; they are distances from the middle of the ring.
    #[inline]
    pub(super) fn predict(&self, features: &[i32; N]) -> i32 {
        let sum: i64 = self.weights.iter().zip(features).map(|(&w, &x)| i64::from(w) * i64::from(x)).sum();
        (sum >> 16) as i32
    }

    /// Learns how far off the prediction was: normalized least mean squares.
    #[inline]
    pub(super) fn learn(&mut self, features: &[i32; N], error: i32) {
        let power = features.iter().map(|&x| i64::from(x) * i64::from(x)).sum::<i64>() + CALM;
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
    fn a_blend_finds_the_weights_of_what_it_sees() {
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
