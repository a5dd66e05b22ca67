//! Share of the viewport that an object covers when a level's error becomes visible.

use std::f64::consts::PI;

/// Returns the largest screen coverage, 0 to 1, at which a level may be shown whose error spans as many pixels as
/// allowed when the bounding sphere has this radius in pixels; a level without an error has no such radius.
pub(super) fn coverage(radius_px: f64, viewport_px: [u32; 2]) -> f64 {
    let [width, height] = viewport_px.map(|pixels| f64::from(pixels.max(1)));
    let share = PI * radius_px * radius_px / (width * height);
    // Without an error, any size is right: the radius is then infinite, or no number.
    if share < 1.0 { share } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_spans_one_pixel_at_its_coverage() {
        let (error, radius) = (0.02, 3.0);
        let share = coverage(radius / error, [1600, 900]);
        // The disc of this area has a radius of 150 pixels for 3 units: 0.02 units are one pixel.
        let radius_px = (share * 1600.0 * 900.0 / PI).sqrt();
        assert!((radius_px - 150.0).abs() < 1e-9);
        let twice = coverage(2.0 * radius / error, [1600, 900]);
        assert!((twice / share - 4.0).abs() < 1e-9);
    }

    #[test]
    fn coverage_is_a_share() {
        let coverage_of = |error: f64, radius: f64| coverage(radius / error, [1920, 1080]);
        assert_eq!(coverage_of(0.0, 1.0), 1.0);
        assert_eq!(coverage_of(1e-9, 1.0), 1.0);
        assert_eq!(coverage_of(1.0, 0.0), 0.0);
        assert_eq!(coverage_of(0.0, 0.0), 1.0);
    }
}
