//! The light of pictures with materials: a studio that is fixed in the world, with y up.
//!
//! The radiance is a gradient from ground to sky plus three soft lamps, each an exponential lobe around an
//! axis. Reflections on a rough surface see the radiance averaged by the GGX distribution, with the view
//! along the normal [Kar13]. Gradient and lobes are symmetric about an axis and so is the average, which
//! therefore is a function of two numbers, the angle to the axis and the roughness: a small table for each.
//! At roughness 1, the distribution is the cosine, and the average is the irradiance divided by pi.
//!
//! The tables take about 50 kB and are computed once.

use std::sync::OnceLock;

use super::vector::{Vec3, add, dot, mix, scaled, unit};

const GROUND: Vec3 = [0.32, 0.29, 0.26];
const SKY: Vec3 = [0.80, 0.88, 1.00];

/// A lamp: `color * exp(sharpness * (cos - 1))`, where `cos` is that of the angle to its axis.
struct Lobe {
    axis: Vec3,
    color: Vec3,
    sharpness: f32,
}

const LOBES: [Lobe; 3] = [
    Lobe { axis: [-0.55, 0.65, 0.75], color: [5.0, 4.7, 4.3], sharpness: 24.0 },
    Lobe { axis: [0.9, 0.25, 0.45], color: [1.1, 1.2, 1.4], sharpness: 8.0 },
    Lobe { axis: [0.3, 0.5, -0.85], color: [2.2, 2.2, 2.3], sharpness: 16.0 },
];

/// Entries along the angle and along the roughness.
const ANGLES: usize = 96;
const ROUGHNESSES: usize = 32;

/// The light of the studio, averaged for reflections.
#[derive(Debug)]
pub(super) struct Studio {
    gradient: Table,
    lobes: [Table; 3],
    axes: [Vec3; 3],
}

impl Studio {
    /// Returns the studio, which is computed when it is first used.
    pub(super) fn get() -> &'static Self {
        static STUDIO: OnceLock<Studio> = OnceLock::new();
        STUDIO.get_or_init(|| Self {
            gradient: Table::of(sky_share),
            lobes: LOBES.map(|lobe| Table::of(|cos| (lobe.sharpness * (cos - 1.0)).exp())),
            axes: LOBES.map(|lobe| unit(lobe.axis)),
        })
    }

    /// Returns the radiance from a unit direction, averaged for a roughness from 0 to 1.
    pub(super) fn radiance(&self, direction: Vec3, roughness: f32) -> Vec3 {
        let mut sum = mix(GROUND, SKY, self.gradient.get(direction[1], roughness));
        for ((table, &axis), lobe) in self.lobes.iter().zip(&self.axes).zip(&LOBES) {
            sum = add(sum, scaled(lobe.color, table.get(dot(direction, axis), roughness)));
        }
        sum
    }

    /// Returns the light that arrives at a surface with this normal, divided by pi.
    pub(super) fn irradiance(&self, normal: Vec3) -> Vec3 {
        self.radiance(normal, 1.0)
    }
}

/// Share of the sky in the gradient at a height from -1 to 1.
fn sky_share(y: f32) -> f32 {
    let t = ((0.5 + 0.5 * y - 0.35) / 0.3).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Averages of a function of the angle to an axis.
#[derive(Debug)]
struct Table(Vec<[f32; ANGLES]>);

impl Table {
    fn of(function: impl Fn(f32) -> f32) -> Self {
        let row = |row: usize| {
            let kernel = Kernel::of(row as f32 / (ROUGHNESSES - 1) as f32);
            std::array::from_fn(|column| {
                let u = column as f32 / (ANGLES - 1) as f32;
                kernel.average(&function, 1.0 - 2.0 * u * u)
            })
        };
        Self((0..ROUGHNESSES).map(row).collect())
    }

    fn get(&self, cos: f32, roughness: f32) -> f32 {
        // Half the sine of the angle grows evenly with small angles, where lobes change most.
        let column = (0.5 - 0.5 * cos).clamp(0.0, 1.0).sqrt() * (ANGLES - 1) as f32;
        let row = roughness.clamp(0.0, 1.0) * (ROUGHNESSES - 1) as f32;
        let (left, top) = ((column as usize).min(ANGLES - 2), (row as usize).min(ROUGHNESSES - 2));
        let (dx, dy) = (column - left as f32, row - top as f32);
        let between = |row: &[f32; ANGLES]| row[left] + dx * (row[left + 1] - row[left]);
        let (a, b) = (between(&self.0[top]), between(&self.0[top + 1]));
        a + dy * (b - a)
    }
}

/// Directions around an axis with weights: where a rough surface reflects from, seen along its normal.
struct Kernel {
    /// Cosine and sine of the angle to the axis, and weight; the weights add up to 1.
    rings: Vec<[f32; 3]>,
    /// Cosines of angles around the axis.
    turns: Vec<f32>,
}

impl Kernel {
    fn of(roughness: f32) -> Self {
        const RINGS: usize = 48;
        const TURNS: usize = 12;
        let square = roughness.powi(4);
        let ring = |index: usize| {
            let share = (index as f32 + 0.5) / RINGS as f32;
            // Half vectors distributed as in GGX; the reflected direction is twice as far away.
            let half_cos_square = (1.0 - share) / (1.0 + (square - 1.0) * share);
            let cos = 2.0 * half_cos_square - 1.0;
            [cos, (1.0 - cos * cos).max(0.0).sqrt(), cos.max(0.0)]
        };
        let mut rings: Vec<[f32; 3]> = (0..RINGS).map(ring).filter(|ring| ring[2] > 0.0).collect();
        let total: f32 = rings.iter().map(|ring| ring[2]).sum();
        rings.iter_mut().for_each(|ring| ring[2] /= total);
        let turn = |index: usize| (std::f32::consts::PI * (index as f32 + 0.5) / TURNS as f32).cos();
        Self { rings, turns: (0..TURNS).map(turn).collect() }
    }

    /// Average of a function of the cosine to an axis that has this cosine to the kernel's.
    fn average(&self, function: &impl Fn(f32) -> f32, cos: f32) -> f32 {
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let ring = |&[ring_cos, ring_sin, weight]: &[f32; 3]| {
            let values = self.turns.iter().map(|turn| function(cos * ring_cos + sin * ring_sin * turn));
            weight * values.sum::<f32>() / self.turns.len() as f32
        };
        self.rings.iter().map(ring).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Unit directions spread evenly over the sphere.
    fn directions(count: usize) -> impl Iterator<Item = Vec3> {
        (0..count).map(move |i| {
            let y = 1.0 - 2.0 * (i as f32 + 0.5) / count as f32;
            let (sin, cos) = (2.399_963_1 * i as f32).sin_cos();
            let radius = (1.0 - y * y).sqrt();
            [radius * cos, y, radius * sin]
        })
    }

    fn exact(direction: Vec3) -> Vec3 {
        let mut sum = mix(GROUND, SKY, sky_share(direction[1]));
        for lobe in &LOBES {
            let cos = dot(direction, unit(lobe.axis));
            sum = add(sum, scaled(lobe.color, (lobe.sharpness * (cos - 1.0)).exp()));
        }
        sum
    }

    fn assert_close(found: Vec3, expected: Vec3, what: &str) {
        for (x, y) in found.into_iter().zip(expected) {
            assert!((x - y).abs() < 0.012 * y.max(0.5), "{what}: {found:?} instead of {expected:?}");
        }
    }

    #[test]
    fn smooth_surfaces_see_the_studio_itself() {
        for direction in directions(200) {
            assert_close(Studio::get().radiance(direction, 0.0), exact(direction), "mirror");
        }
    }

    #[test]
    fn rough_surfaces_see_averages_over_the_sphere() {
        for roughness in [0.35f32, 0.6, 1.0] {
            for axis in directions(20) {
                let (mut sum, mut total) = ([0.0; 3], 0.0);
                for direction in directions(20_000) {
                    let cos = dot(axis, direction);
                    let square = roughness.powi(4);
                    let half_cos_square = (1.0 + cos) / 2.0;
                    let d = half_cos_square * (square - 1.0) + 1.0;
                    let weight = cos.max(0.0) / (d * d);
                    sum = add(sum, scaled(exact(direction), weight));
                    total += weight;
                }
                let expected = scaled(sum, 1.0 / total);
                let found = Studio::get().radiance(axis, roughness);
                assert_close(found, expected, &format!("roughness {roughness}"));
            }
        }
    }
}
