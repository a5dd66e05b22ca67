//! Punctual lights of a scene, in the units of `KHR_lights_punctual`; they cast no shadows.

/// Shape of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LitLightKind {
    /// Parallel light from infinitely far away; intensity in lux.
    Directional,
    /// Light in all directions; intensity in candela.
    Point,
    /// A cone of light; intensity in candela.
    Spot {
        /// Angle from the axis at which the light begins to fall off, radians.
        inner_angle: f32,
        /// Angle from the axis at which the light ends, radians.
        outer_angle: f32,
    },
}

/// A punctual light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LitLight {
    /// Shape of the light.
    pub kind: LitLightKind,
    /// Color times intensity, linear light.
    pub color: [f32; 3],
    /// Position in the world; unused by directional lights.
    pub position: [f64; 3],
    /// Direction in which the light travels; unused by point lights.
    pub direction: [f32; 3],
    /// Distance at which the light ends; [`None`] if it does not end.
    pub range: Option<f32>,
}
