//! Reflectance of rough surfaces under uniform light: the second factor of the split sum [Kar13].

use std::sync::LazyLock;

/// Side of the table.
pub(crate) const SIDE: usize = 32;

/// Number of directions per entry.
const SAMPLE_COUNT: u32 = 512;

/// Scale and offset of the reflectance at normal incidence. Columns are roughness, rows are the cosine to the
/// eye, both at the middle of each entry.
pub(crate) static REFLECTANCE_TABLE: LazyLock<Vec<[f32; 2]>> = LazyLock::new(|| {
    let middle = |at: usize| (at as f64 + 0.5) / SIDE as f64;
    let entries = (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (middle(column), middle(row))));
    entries.map(|(roughness, cosine)| reflectance(roughness, cosine).map(|x| x as f32)).collect()
});

/// Returns scale and offset for a roughness and a cosine to the eye, both from 0 to 1.
pub(crate) fn split_sum(roughness: f32, cosine: f32) -> [f32; 2] {
    let at = |x: f32| (x * SIDE as f32 - 0.5).clamp(0.0, (SIDE - 1) as f32);
    let (column, row) = (at(roughness), at(cosine));
    let (left, top) = ((column as usize).min(SIDE - 2), (row as usize).min(SIDE - 2));
    let (dx, dy) = (column - left as f32, row - top as f32);
    std::array::from_fn(|k| {
        let between = |row: usize| {
            let [a, b] = [left, left + 1].map(|column| REFLECTANCE_TABLE[row * SIDE + column][k]);
            a + dx * (b - a)
        };
        let (a, b) = (between(top), between(top + 1));
        a + dy * (b - a)
    })
}

/// Integrates over half vectors that are distributed like the microfacets of GGX.
fn reflectance(roughness: f64, cosine: f64) -> [f64; 2] {
    let alpha = roughness * roughness;
    let alpha_2 = alpha * alpha;
    let to_eye = [(1.0 - cosine * cosine).sqrt(), cosine];
    let mut sums = [0.0; 2];
    for sample in 0..SAMPLE_COUNT {
        let turn = std::f64::consts::TAU * f64::from(sample.reverse_bits()) / 4_294_967_296.0;
        let part = (f64::from(sample) + 0.5) / f64::from(SAMPLE_COUNT);
        let cosine_half = ((1.0 - part) / (1.0 + (alpha_2 - 1.0) * part)).sqrt();
        let across_half = (1.0 - cosine_half * cosine_half).max(0.0).sqrt() * turn.cos();
        let between = (to_eye[0] * across_half + to_eye[1] * cosine_half).max(0.0);
        let cosine_light = 2.0 * between * cosine_half - cosine;
        if cosine_light > 0.0 {
            let shadowed = |to: f64, other: f64| to * (alpha_2 + (1.0 - alpha_2) * other * other).sqrt();
            let visibility = 0.5 / (shadowed(cosine_light, cosine) + shadowed(cosine, cosine_light));
            let weight = 4.0 * cosine_light * visibility * between / cosine_half.max(1e-9);
            let grazing = (1.0 - between).powi(5);
            sums[0] += weight * (1.0 - grazing);
            sums[1] += weight * grazing;
        }
    }
    sums.map(|sum| sum / f64::from(SAMPLE_COUNT))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smooth_surfaces_reflect_everything_and_rough_ones_less() {
        for cosine in [0.1, 0.5, 0.9] {
            let total = |roughness| reflectance(roughness, cosine).iter().sum::<f64>();
            assert!((total(0.05) - 1.0).abs() < 0.02, "{cosine}: {}", total(0.05));
            assert!(total(1.0) < 0.8 && total(1.0) > 0.2, "{cosine}: {}", total(1.0));
        }
        for roughness in [-1.0, 0.0, 0.3, 1.0, 2.0] {
            for cosine in [-1.0, 0.0, 1.0, 3.0] {
                let total: f32 = split_sum(roughness, cosine).iter().sum();
                assert!((0.0..=1.01).contains(&total), "{roughness} {cosine}: {total}");
            }
        }
        // Schlick's term at a cosine of 0.5 is 1/32 for a mirror.
        assert!((reflectance(0.03, 0.5)[1] - 1.0 / 32.0).abs() < 2e-3);
    }
}
