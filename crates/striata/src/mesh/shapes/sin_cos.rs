//! Sines and cosines that are bit-identical on every machine.

/// Sine and cosine of `index / count` of a full turn.
///
/// The results of platform functions differ in the last bit. This sums the series over an eighth of a turn
/// and derives the rest by symmetry.
pub(super) fn sin_cos_of_turn(index: u32, count: u32) -> (f64, f64) {
    let count = u64::from(count.max(1));
    let eighths = 8 * (u64::from(index) % count);
    let (octant, rest) = (eighths / count, (eighths % count) as f64 / count as f64);
    // Odd octants run backward from their end, so that the series is only evaluated for angles up to pi / 4.
    let angle = std::f64::consts::FRAC_PI_4 * if octant % 2 == 0 { rest } else { 1.0 - rest };
    let (s, c) = (sin_series(angle), cos_series(angle));
    match octant {
        0 => (s, c),
        1 => (c, s),
        2 => (c, -s),
        3 => (s, -c),
        4 => (-s, -c),
        5 => (-c, -s),
        6 => (-c, s),
        _ => (-s, c),
    }
}

fn sin_series(x: f64) -> f64 {
    (1..9).rev().fold(1.0, |sum, k| 1.0 - sum * x * x / f64::from(2 * k * (2 * k + 1))) * x
}

fn cos_series(x: f64) -> f64 {
    (1..10).rev().fold(1.0, |sum, k| 1.0 - sum * x * x / f64::from(2 * k * (2 * k - 1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_match_the_platform() {
        for count in [1, 3, 7, 8, 12, 124, 1000] {
            for index in 0..2 * count {
                let angle = std::f64::consts::TAU * f64::from(index) / f64::from(count);
                let (s, c) = sin_cos_of_turn(index, count);
                assert!(
                    (s - angle.sin()).abs() < 4e-15 && (c - angle.cos()).abs() < 4e-15,
                    "{index}/{count}"
                );
            }
        }
        assert_eq!(sin_cos_of_turn(1, 4), (1.0, 0.0));
        assert_eq!(sin_cos_of_turn(1, 2), (0.0, -1.0));
    }
}
