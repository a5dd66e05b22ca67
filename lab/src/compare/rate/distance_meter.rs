//! Measures the distance of other meshes to a reference mesh.

use serde::Serialize;
use striata::mesh::{DistanceOptions, IndexedMesh, surface_distance};

/// Number of samples on each surface.
const SAMPLES: usize = 100_000;

/// The distance of what is shown after a number of bytes.
#[derive(Clone, Debug, Serialize)]
pub(super) struct RateRow {
    /// Name of the coder; rows with the same name form a series.
    pub name: String,
    pub bytes: usize,
    pub triangle_count: usize,
    /// Maximum and RMS distance in percent of the diagonal.
    pub max: f64,
    pub rms: f64,
}

/// Measures distances to one mesh.
pub(super) struct DistanceMeter<'m> {
    pub reference: &'m IndexedMesh,
}

impl DistanceMeter<'_> {
    /// Measures one mesh; returns `None` if it has no surface.
    pub(super) fn row(&self, name: &str, bytes: usize, shown: &IndexedMesh) -> Option<RateRow> {
        let options = DistanceOptions::default().with_sample_count(SAMPLES);
        let distance = surface_distance(self.reference, shown, &options).ok()?;
        let percent = 100.0 / distance.diagonal;
        Some(RateRow {
            name: name.to_owned(),
            bytes,
            triangle_count: shown.triangle_count(),
            max: distance.max * percent,
            rms: distance.rms * percent,
        })
    }
}
