//! Prefiltered environments: how rough surfaces see the gradient and the soft lights.
//!
//! Each part of an environment depends only on the angle to an axis, and so does the GGX lobe of a surface
//! that is seen along its normal. Averaging one over the other keeps this symmetry, and multiplies the
//! coefficients of the two in Legendre polynomials. So a small table of angle and roughness contains every
//! prefiltered level exactly, and no cube maps are needed.

use std::sync::LazyLock;

use glam::Vec3;

use crate::environment::Environment;

/// Columns of the table: cosines from -1 to 1.
pub(crate) const COLUMN_COUNT: usize = 512;
/// Rows of the table: `r (2 - r)` of the roughness `r`, from 0 to 1.
pub(crate) const ROW_COUNT: usize = 33;

/// Number of Legendre polynomials. The coefficients of a light of sharpness 100 have fallen to 1e-9 by then.
const DEGREE_COUNT: usize = 64;
/// Number of samples of each integral.
const SAMPLE_COUNT: usize = 1024;

/// Sharpest light that the table resolves.
const MAX_SHARPNESS: f64 = 100.0;

/// An environment with its table.
#[derive(Debug)]
pub(crate) struct EnvironmentTable {
    environment: Environment,
    /// Directions of the lights.
    axes: [Vec3; 3],
    /// Row by row, with four values per entry: the share of the sky, and the three lights.
    pub entries: Vec<[f32; 4]>,
}

/// The studio, which is computed when it is first used.
pub(crate) static STUDIO: LazyLock<EnvironmentTable> =
    LazyLock::new(|| EnvironmentTable::new(&Environment::studio()));

impl EnvironmentTable {
    pub(crate) fn new(environment: &Environment) -> Self {
        let axes = environment.lobes.map(|lobe| Vec3::from(lobe.direction).normalize_or(Vec3::Y));
        Self { environment: *environment, axes, entries: table_of(environment) }
    }

    /// Returns the radiance from a unit direction, averaged for a roughness from 0 to 1. At roughness 1 it is the
    /// light that arrives at a surface with this normal, divided by pi.
    pub(crate) fn radiance(&self, direction: Vec3, roughness: f32) -> Vec3 {
        let roughness = roughness.clamp(0.0, 1.0);
        let row = roughness * (2.0 - roughness) * (ROW_COUNT - 1) as f32;
        let [ground, sky] = [self.environment.ground, self.environment.sky].map(Vec3::from);
        let mut sum = ground.lerp(sky, self.entry(direction.y, row, 0));
        for (part, (axis, lobe)) in (1..).zip(self.axes.iter().zip(&self.environment.lobes)) {
            sum += Vec3::from(lobe.color) * self.entry(direction.dot(*axis), row, part);
        }
        sum
    }

    /// Interpolates between entries.
    fn entry(&self, cosine: f32, row: f32, part: usize) -> f32 {
        let column = (0.5 + 0.5 * cosine).clamp(0.0, 1.0) * (COLUMN_COUNT - 1) as f32;
        let (left, top) = ((column as usize).min(COLUMN_COUNT - 2), (row as usize).min(ROW_COUNT - 2));
        let (dx, dy) = (column - left as f32, row - top as f32);
        let between = |row: usize| {
            let [a, b] = [left, left + 1].map(|column| self.entries[row * COLUMN_COUNT + column][part]);
            a + dx * (b - a)
        };
        let (a, b) = (between(top), between(top + 1));
        a + dy * (b - a)
    }
}

fn table_of(environment: &Environment) -> Vec<[f32; 4]> {
    let parts: [Vec<f64>; 4] = std::array::from_fn(|part| match part.checked_sub(1) {
        None => coefficients(|y| environment.sky_share(y)),
        Some(lobe) => {
            let sharpness = f64::from(environment.lobes[lobe].sharpness).clamp(0.0, MAX_SHARPNESS);
            coefficients(|cosine| (sharpness * (cosine - 1.0)).exp())
        }
    });
    let columns: Vec<[f64; DEGREE_COUNT]> =
        (0..COLUMN_COUNT).map(|at| legendre(2.0 * at as f64 / (COLUMN_COUNT - 1) as f64 - 1.0)).collect();
    let mut table = Vec::with_capacity(COLUMN_COUNT * ROW_COUNT);
    for row in 0..ROW_COUNT {
        let roughness = 1.0 - (1.0 - row as f64 / (ROW_COUNT - 1) as f64).sqrt();
        let blur = ggx_coefficients(roughness * roughness);
        table.extend(columns.iter().map(|polynomials| {
            let value = |part: &Vec<f64>| -> f64 {
                (0..DEGREE_COUNT).map(|degree| part[degree] * blur[degree] * polynomials[degree]).sum()
            };
            std::array::from_fn(|part| value(&parts[part]).max(0.0) as f32)
        }));
    }
    table
}

/// Returns the Legendre polynomials at a point.
fn legendre(x: f64) -> [f64; DEGREE_COUNT] {
    let mut values = [1.0; DEGREE_COUNT];
    values[1] = x;
    for degree in 2..DEGREE_COUNT {
        let n = degree as f64;
        values[degree] = ((2.0 * n - 1.0) * x * values[degree - 1] - (n - 1.0) * values[degree - 2]) / n;
    }
    values
}

/// Returns the coefficients of a function of the cosine.
fn coefficients(function: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut sums = vec![0.0; DEGREE_COUNT];
    let step = std::f64::consts::PI / SAMPLE_COUNT as f64;
    for sample in 0..SAMPLE_COUNT {
        // Equal steps of the angle: polynomials are steepest where the cosine hardly changes.
        let (sine, cosine) = ((sample as f64 + 0.5) * step).sin_cos();
        let value = function(cosine) * sine * step;
        for (degree, (sum, polynomial)) in sums.iter_mut().zip(legendre(cosine)).enumerate() {
            *sum += (degree as f64 + 0.5) * value * polynomial;
        }
    }
    sums
}

/// Returns the factors by which the lobe of a GGX surface, seen along its normal and weighted by the cosine,
/// scales the coefficients of the light. Reflected directions are sampled by their density.
fn ggx_coefficients(alpha: f64) -> [f64; DEGREE_COUNT] {
    let alpha_2 = alpha * alpha;
    let mut sums = [0.0; DEGREE_COUNT];
    for sample in 0..SAMPLE_COUNT {
        let part = (sample as f64 + 0.5) / SAMPLE_COUNT as f64;
        let cosine = (1.0 - part - alpha_2 * part) / (1.0 - part + alpha_2 * part);
        if cosine > 0.0 {
            for (sum, polynomial) in sums.iter_mut().zip(legendre(cosine)) {
                *sum += cosine * polynomial;
            }
        }
    }
    let total = sums[0].max(f64::MIN_POSITIVE);
    sums.map(|sum| sum / total)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(table: &[[f32; 4]], row: usize, column: usize, part: usize) -> f64 {
        f64::from(table[row * COLUMN_COUNT + column][part])
    }

    #[test]
    fn smooth_surfaces_mirror_the_environment() {
        let studio = Environment::studio();
        let table = table_of(&studio);
        for column in 0..COLUMN_COUNT {
            let x = 2.0 * column as f64 / (COLUMN_COUNT - 1) as f64 - 1.0;
            let expected = [studio.sky_share(x), (24.0 * (x - 1.0)).exp(), (8.0 * (x - 1.0)).exp()];
            for (part, expected) in expected.into_iter().enumerate() {
                let found = entry(&table, 0, column, part);
                assert!((found - expected).abs() < 2e-3, "{part} at {x}: {found}, not {expected}");
            }
        }
    }

    #[test]
    fn the_roughest_row_is_the_mean_over_the_cosine() {
        let studio = Environment::studio();
        let table = table_of(&studio);
        // Facing a light: the mean of exp(k (x - 1)) weighted by 2 x over 0..1.
        for (part, k) in [(1, 24.0f64), (2, 8.0), (3, 16.0)] {
            let expected = 2.0 * (1.0 / k - (1.0 - (-k).exp()) / (k * k));
            let found = entry(&table, ROW_COUNT - 1, COLUMN_COUNT - 1, part);
            assert!((found - expected).abs() < 2e-3, "{part}: {found}, not {expected}");
        }
    }

    #[test]
    fn uniform_light_is_uniform_at_every_roughness() {
        let mut even = Environment::uniform([1.0; 3]);
        even.lobes[1].sharpness = 0.0;
        let table = table_of(&even);
        assert!(table.iter().all(|entry| (f64::from(entry[2]) - 1.0).abs() < 1e-3));
    }

    /// Unit directions spread evenly over the sphere.
    fn directions(count: usize) -> impl Iterator<Item = Vec3> {
        (0..count).map(move |i| {
            let y = 1.0 - 2.0 * (i as f32 + 0.5) / count as f32;
            let (sin, cos) = (2.399_963_1 * i as f32).sin_cos();
            let radius = (1.0 - y * y).sqrt();
            Vec3::new(radius * cos, y, radius * sin)
        })
    }

    #[test]
    fn rough_surfaces_see_averages_over_the_sphere() {
        let studio = &*STUDIO;
        for roughness in [0.35f32, 0.6, 1.0] {
            for axis in directions(20) {
                let (mut sum, mut total) = (Vec3::ZERO, 0.0);
                for direction in directions(20_000) {
                    let cos = axis.dot(direction);
                    let d = (1.0 + cos) / 2.0 * (roughness.powi(4) - 1.0) + 1.0;
                    let weight = cos.max(0.0) / (d * d);
                    sum += weight * studio.radiance(direction, 0.0);
                    total += weight;
                }
                let (found, expected) = (studio.radiance(axis, roughness), sum / total);
                let is_close = (found - expected).abs().cmple(0.012 * expected.max(Vec3::splat(0.5))).all();
                assert!(is_close, "roughness {roughness}: {found} instead of {expected}");
            }
        }
    }
}
