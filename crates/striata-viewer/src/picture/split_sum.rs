//! The share of light that a surface reflects at each angle, by GGX: the second factor of the split sum
//! [Kar13], as scale and offset of the reflectance at normal incidence.

use std::sync::OnceLock;

/// Entries along the angle and along the roughness.
const SIZE: usize = 32;
/// Directions that are summed for an entry.
const SAMPLES: u32 = 128;

/// Scale and offset for each roughness (rows) and cosine of the view angle (columns).
type Table = [[[f32; 2]; SIZE]; SIZE];

/// Returns scale and offset for a roughness and a cosine of the view angle, both from 0 to 1.
pub(super) fn split_sum(roughness: f32, cos: f32) -> [f32; 2] {
    static TABLE: OnceLock<Box<Table>> = OnceLock::new();
    let table = TABLE.get_or_init(|| {
        let share = |index: usize| index as f32 / (SIZE - 1) as f32;
        Box::new(std::array::from_fn(|row| std::array::from_fn(|x| integrate(share(row), share(x)))))
    });
    let [row, column] = [roughness, cos].map(|x| x.clamp(0.0, 1.0) * (SIZE - 1) as f32);
    let (top, left) = ((row as usize).min(SIZE - 2), (column as usize).min(SIZE - 2));
    let (dy, dx) = (row - top as f32, column - left as f32);
    let between = |row: &[[f32; 2]; SIZE], k: usize| row[left][k] + dx * (row[left + 1][k] - row[left][k]);
    [0, 1].map(|k| {
        let (a, b) = (between(&table[top], k), between(&table[top + 1], k));
        a + dy * (b - a)
    })
}

/// Integrates over half vectors that are distributed as in GGX.
fn integrate(roughness: f32, view_cos: f32) -> [f32; 2] {
    let view_cos = view_cos.max(1e-3);
    let view = [(1.0 - view_cos * view_cos).sqrt(), view_cos];
    let square = roughness.max(0.02).powi(4);
    let smith = |a: f32, b: f32| a * (square + (1.0 - square) * b * b).sqrt();
    let mut sum = [0.0f32; 2];
    for sample in 0..SAMPLES {
        let share = (sample as f32 + 0.5) / SAMPLES as f32;
        // Reversed bits are spread evenly over the interval.
        let turn = sample.reverse_bits() as f32 / u32::MAX as f32;
        let half_cos = ((1.0 - share) / (1.0 + (square - 1.0) * share)).sqrt();
        let half_sin = (1.0 - half_cos * half_cos).max(0.0).sqrt();
        let half_x = half_sin * (2.0 * std::f32::consts::PI * turn).cos();
        let view_half = (view[0] * half_x + view[1] * half_cos).max(0.0);
        let light_cos = 2.0 * view_half * half_cos - view_cos;
        if light_cos <= 0.0 {
            continue;
        }
        let visibility = 0.5 / (smith(light_cos, view_cos) + smith(view_cos, light_cos)).max(1e-9);
        let weight = 4.0 * visibility * light_cos * view_half / half_cos.max(1e-6);
        let fresnel = (1.0 - view_half).powi(5);
        sum[0] += weight * (1.0 - fresnel);
        sum[1] += weight * fresnel;
    }
    // No surface reflects more than it receives, whatever the samples were.
    let total = (sum[0] + sum[1]).max(SAMPLES as f32);
    sum.map(|x| x / total)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_surfaces_follow_schlick_and_rough_ones_lose_energy() {
        for cos in [0.2f32, 0.5, 0.9] {
            let [scale, offset] = split_sum(0.05, cos);
            let fresnel = (1.0 - cos).powi(5);
            assert!((scale - (1.0 - fresnel)).abs() < 0.03 && (offset - fresnel).abs() < 0.03, "{cos}");
        }
        let total = |roughness| split_sum(roughness, 0.5).iter().sum::<f32>();
        assert!(total(0.1) > 0.97 && total(1.0) > 0.3 && total(1.0) < 0.7, "{}", total(1.0));
        for roughness in [-1.0, 0.0, 0.3, 1.0, 2.0] {
            for cos in [-1.0, 0.0, 1.0, 3.0] {
                let total: f32 = split_sum(roughness, cos).iter().sum();
                assert!((0.0..=1.0001).contains(&total), "{roughness} {cos}: {total}");
            }
        }
    }
}
