//! Measurements of one level of one contender.

use serde::Serialize;
use striata::mesh::{DistanceOptions, surface_distance};

use super::attribute_distance::{AttributeSpread, attribute_distance};
use super::contender::{Level, Request};
use super::subject::ComparedAsset;
use striata_command::failure::Failure;

/// Number of samples on each surface for distances, and on the original for attributes.
pub(super) const SAMPLES: usize = 100_000;

/// Measurements of one level.
#[derive(Clone, Debug, Serialize)]
pub(super) struct LevelRow {
    /// Name of the contender.
    pub contender: &'static str,
    /// Requested percentage of the triangles.
    pub percent: f64,
    pub target_count: usize,
    pub triangle_count: usize,
    /// Whether the level has no more triangles than requested.
    pub is_reached: bool,
    /// The larger one-sided RMS distance; like all distances here a share of the diagonal.
    pub rms: f64,
    pub max: f64,
    pub normal_mean_degrees: Option<f64>,
    pub normal_p95_degrees: Option<f64>,
    /// Difference of texture coordinates, in UV units.
    pub uv_mean: Option<f64>,
    pub uv_p95: Option<f64>,
    /// Share of the samples that were compared with a triangle on the same side.
    pub same_side_share: f64,
    /// RMS difference in gray levels, 0 to 255.
    pub gray_rms: f64,
    /// Covered area relative to the original's.
    pub silhouette: f64,
    /// Mean difference of colors with materials, 0 to 255.
    pub color_mean: Option<f64>,
    /// Peak signal-to-noise ratio of the pictures, dB.
    pub picture_db: Option<f64>,
    /// The error that the contender reports.
    pub error: Option<f64>,
    /// Ratio of the reported error to the measured maximum.
    pub error_ratio: Option<f64>,
    /// The error limit passed to the contender, as a share of the extent.
    pub error_limit: Option<f64>,
    pub secs: f64,
}

/// Measures a level against the original.
///
/// # Errors
/// If the level is inconsistent or empty.
pub(super) fn measure_level(
    subject: &ComparedAsset,
    request: &Request,
    contender: &'static str,
    level: Level,
) -> Result<LevelRow, Failure> {
    let options = DistanceOptions::default().with_sample_count(SAMPLES);
    let failed = |error| Failure::internal(format!("a level of {contender}: {error}"));
    let mesh = subject.lit(level.mesh);
    let distance = surface_distance(&subject.reference, &mesh, &options).map_err(failed)?;
    let attributes = attribute_distance(&subject.reference, &mesh, &options).map_err(failed)?;
    let seen = subject.gallery.compare(&mesh);
    let mean = |spread: AttributeSpread| spread.mean;
    let tail = |spread: AttributeSpread| spread.percentile_95;
    let share = |length: f64| length / distance.diagonal.max(f64::MIN_POSITIVE);
    Ok(LevelRow {
        contender,
        percent: request.percent,
        target_count: request.target_count,
        triangle_count: mesh.triangle_count(),
        is_reached: mesh.triangle_count() <= request.target_count,
        rms: share(distance.rms),
        max: share(distance.max),
        normal_mean_degrees: attributes.normal.map(mean).map(f64::to_degrees),
        normal_p95_degrees: attributes.normal.map(tail).map(f64::to_degrees),
        uv_mean: attributes.uv.map(mean),
        uv_p95: attributes.uv.map(tail),
        same_side_share: attributes.same_side_share,
        gray_rms: seen.gray_rms,
        silhouette: seen.silhouette,
        color_mean: seen.color_mean,
        picture_db: seen.decibels,
        error: level.error.map(share),
        error_ratio: level.error.map(|error| error / distance.max).filter(|ratio| ratio.is_finite()),
        error_limit: level.error_limit,
        secs: level.secs,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_rounded_down_despite_floating_point_errors() {
        assert_eq!(Request::new(10.0, 1_000).target_count, 100);
        assert_eq!(Request::new(2.0, 99).target_count, 1);
        assert_eq!(Request::new(29.0, 100).target_count, 29);
    }
}
