//! Light from all around: a gradient from the ground to the sky, and up to three soft lights.

/// A soft light of an environment: its radiance falls off smoothly around a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnvironmentLobe {
    /// Direction toward the light; need not have length 1.
    pub direction: [f32; 3],
    /// Radiance in the middle of the light.
    pub color: [f32; 3],
    /// Concentration k, 0 to 100: at an angle, the radiance is the color times exp(k (cos(angle) - 1)).
    pub sharpness: f32,
}

/// Radiance that arrives from each direction of the world, linear light. The y axis points up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Environment {
    /// Radiance from below.
    pub ground: [f32; 3],
    /// Radiance from above.
    pub sky: [f32; 3],
    /// Heights of a direction, 0 (down) to 1 (up), between which the ground turns into the sky.
    pub horizon: [f32; 2],
    /// Soft lights; black ones add nothing.
    pub lobes: [EnvironmentLobe; 3],
}

impl Default for Environment {
    fn default() -> Self {
        Self::studio()
    }
}

impl Environment {
    /// A photographer's studio: a warm floor, a bluish ceiling, a strong key light from the upper left, a
    /// weak fill light from the right and a rim light from behind.
    pub fn studio() -> Self {
        let lobe = |direction, color, sharpness| EnvironmentLobe { direction, color, sharpness };
        Self {
            ground: [0.32, 0.29, 0.26],
            sky: [0.80, 0.88, 1.00],
            horizon: [0.35, 0.65],
            lobes: [
                lobe([-0.55, 0.65, 0.75], [5.0, 4.7, 4.3], 24.0),
                lobe([0.9, 0.25, 0.45], [1.1, 1.2, 1.4], 8.0),
                lobe([0.3, 0.5, -0.85], [2.2, 2.2, 2.3], 16.0),
            ],
        }
    }

    /// An environment with one radiance from all directions.
    pub fn uniform(color: [f32; 3]) -> Self {
        let lobe = EnvironmentLobe { direction: [0.0, 1.0, 0.0], color: [0.0; 3], sharpness: 1.0 };
        Self { ground: color, sky: color, horizon: [0.0, 1.0], lobes: [lobe; 3] }
    }

    /// Share of the sky at a height of -1 to 1.
    pub(crate) fn sky_share(&self, y: f64) -> f64 {
        let [from, to] = self.horizon.map(f64::from);
        let t = ((0.5 + 0.5 * y - from) / (to - from).max(1e-3)).clamp(0.0, 1.0);
        t * t * (3.0 - 2.0 * t)
    }
}
