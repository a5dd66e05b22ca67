//! Appearance of a surface without materials: colors and edges.

use crate::shot::STONE;

/// Appearance of a surface. Colors are linear light, 0 to 1 per channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Color of surfaces that have none of their own. Default: warm stone.
    pub base: [f32; 3],
    /// Background color and opacity.
    pub background: [f32; 4],
    /// Whether to color each group of triangles differently. Default: false.
    pub shows_groups: bool,
    /// Edge color and opacity; opacity 0 draws none. Only an [`Inspection`](crate::gpu::Inspection) draws edges.
    pub edges: [f32; 4],
    /// Edge width in pixels. Default: 1.
    pub edge_width_px: f32,
    /// Whether to cull back faces. Default: false.
    pub hides_back: bool,
    /// Strength of the lighting: 0 shows unlit colors, 1 lights them fully. Default: 1.
    pub light: f32,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            base: STONE,
            background: [0.012, 0.013, 0.017, 1.0],
            shows_groups: false,
            edges: [0.0, 0.0, 0.0, 0.0],
            edge_width_px: 1.0,
            hides_back: false,
            light: 1.0,
        }
    }
}

/// Returns a color for the n-th strip, fan or group, as opaque linear light in bytes. Consecutive colors
/// differ clearly: hues advance by the golden ratio, in two alternating shades.
pub fn palette_color(index: u32) -> [u8; 4] {
    let hue = (f64::from(index) * 0.618_033_988_749_895).fract() as f32 * 6.0;
    let shade = if index.is_multiple_of(2) { 0.85 } else { 0.60 };
    // Each channel rises and falls along the hue circle.
    let channel = |shift: f32| {
        let amount = (2.0 - ((hue + shift) % 6.0 - 3.0).abs()).clamp(0.0, 1.0);
        (255.0 * shade * (0.24 + 0.60 * amount) + 0.5) as u8
    };
    [channel(3.0), channel(1.0), channel(5.0), 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbors_differ_in_color() {
        for index in (0..50).chain(1_000_000..1_000_050) {
            let (a, b) = (palette_color(index), palette_color(index + 1));
            let difference: u32 = a.iter().zip(b).map(|(&x, y)| u32::from(x.abs_diff(y))).sum();
            assert!(difference > 40, "{index}: {a:?} {b:?}");
        }
    }
}
