//! Mean and spread of repeated measurements.

/// Mean, range and standard deviation of some numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// Mean; 0 if there are no numbers.
    pub mean: f64,
    /// Smallest number.
    pub min: f64,
    /// Largest number.
    pub max: f64,
    /// Standard deviation of the sample; 0 for fewer than two numbers.
    pub std: f64,
}

impl Spread {
    /// Measures some numbers.
    pub fn of(numbers: &[f64]) -> Self {
        let Some(&first) = numbers.first() else { return Self::default() };
        let n = numbers.len() as f64;
        let mean = numbers.iter().sum::<f64>() / n;
        let squares: f64 = numbers.iter().map(|number| (number - mean).powi(2)).sum();
        let extreme = |pick: fn(f64, f64) -> f64| numbers.iter().copied().fold(first, pick);
        let std = (squares / (n - 1.0).max(1.0)).sqrt();
        Self { mean, min: extreme(f64::min), max: extreme(f64::max), std }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_has_mean_range_and_deviation() {
        let spread = Spread::of(&[2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0]);
        assert_eq!((spread.mean, spread.min, spread.max), (5.0, 2.0, 9.0));
        assert!((spread.std - (32f64 / 7.0).sqrt()).abs() < 1e-12);
        assert_eq!(Spread::of(&[6.0]), Spread { mean: 6.0, min: 6.0, max: 6.0, std: 0.0 });
        assert_eq!(Spread::of(&[]), Spread::default());
    }
}
