//! Share of the viewport that an object covers when a level's error becomes visible.

use std::f64::consts::PI;

use super::LodChainOptions;

/// Returns the largest screen coverage, 0 to 1, at which a level with this error may be shown; `radius` is
/// that of the bounding sphere, in the units of the error.
pub(super) fn coverage(error: f64, radius: f64, options: &LodChainOptions) -> f64 {
    let [width, height] = options.viewport_px.map(|pixels| f64::from(pixels.max(1)));
    let radius_px = radius * options.error_px / error;
    let share = PI * radius_px * radius_px / (width * height);
    // Without an error, any size is right.
    if error > 0.0 && share < 1.0 { share } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_spans_one_pixel_at_its_coverage() {
        let options = LodChainOptions::default().with_viewport_px([1600, 900]);
        let (error, radius) = (0.02, 3.0);
        let share = coverage(error, radius, &options);
        // The disc of this area has a radius of 150 pixels for 3 units: 0.02 units are one pixel.
        let radius_px = (share * 1600.0 * 900.0 / PI).sqrt();
        assert!((radius_px - 150.0).abs() < 1e-9);
        let twice = coverage(error, radius, &options.with_error_px(2.0));
        assert!((twice / share - 4.0).abs() < 1e-9);
    }

    #[test]
    fn coverage_is_a_share() {
        let options = LodChainOptions::default();
        assert_eq!(coverage(0.0, 1.0, &options), 1.0);
        assert_eq!(coverage(1e-9, 1.0, &options), 1.0);
        assert_eq!(coverage(1.0, 0.0, &options), 0.0);
        assert_eq!(coverage(0.0, 0.0, &options), 1.0);
    }
}
