//! How near to a mesh something comes.

use serde::Serialize;
use striata::mesh::{DistanceOptions, IndexedMesh, surface_distance};

/// Samples of each surface.
const SAMPLES: usize = 100_000;

/// What is shown after some bytes.
#[derive(Clone, Debug, Serialize)]
pub(super) struct RateRow {
    /// The way; its rows belong together.
    pub(super) name: String,
    pub(super) bytes: usize,
    pub(super) triangle_count: usize,
    /// Percent of the diagonal.
    pub(super) max: f64,
    pub(super) rms: f64,
}

/// Measures distances to one mesh.
pub(super) struct Ruler<'m> {
    pub(super) reference: &'m IndexedMesh,
}

impl Ruler<'_> {
    /// None where what is shown has no surface.
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
