//! Distances between surfaces.

use std::sync::Arc;

use numpy::{IntoPyArray as _, PyArray1};
use pyo3::prelude::*;
use striata::mesh::{
    DistanceError, DistanceOptions, IndexedMesh, OneSidedDistance, TriangleTree,
    surface_distance_with_progress,
};
use striata::{Progress, ProgressFn};

use crate::errors::{Outcome, cancelled, value_error};
use crate::job;
use crate::mesh::PyMeshData;

/// Number of vertices measured between two looks at the progress.
const VERTICES_PER_REPORT: usize = 1 << 12;

/// Maximum, root mean square and mean of one direction.
type OneSided = (f64, f64, f64);

/// Both directions, the diagonal of the first mesh, and the number of samples.
type DistanceFacts = (OneSided, OneSided, f64, usize);

/// Measures the distance between two surfaces by sampling.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the Python half passes them by position")]
pub(crate) fn distance(
    py: Python<'_>,
    a: &PyMeshData,
    b: &PyMeshData,
    samples: usize,
    seed: u64,
    progress: Option<Bound<'_, PyAny>>,
) -> Outcome<DistanceFacts> {
    let (a, b) = (Arc::clone(&a.mesh), Arc::clone(&b.mesh));
    let size = a.triangle_count() + b.triangle_count() + samples / 10;
    let options = DistanceOptions::default().with_sample_count(samples).with_seed(seed);
    let measured = job::run(py, size, progress.as_ref(), move |progress| {
        surface_distance_with_progress(&a, &b, &options, progress).map_err(|error| match error {
            DistanceError::Cancelled(reason) => cancelled(reason),
            error => value_error(error),
        })
    })?;
    let side = |side: OneSidedDistance| (side.max, side.rms, side.mean);
    Ok((side(measured.a_to_b), side(measured.b_to_a), measured.diagonal, measured.sample_count))
}

/// Distance of each vertex of the first mesh to the surface of the second.
#[pyfunction]
pub(crate) fn vertex_distances<'py>(
    py: Python<'py>,
    from_: &PyMeshData,
    to: &PyMeshData,
) -> Outcome<Bound<'py, PyArray1<f64>>> {
    let (from, to) = (Arc::clone(&from_.mesh), Arc::clone(&to.mesh));
    let size = from.vertex_count() + to.triangle_count();
    let distances = job::run(py, size, None, move |progress| measured(&from, &to, progress))?;
    Ok(distances.into_pyarray(py))
}

fn measured(from: &IndexedMesh, to: &IndexedMesh, progress: &mut ProgressFn<'_>) -> Outcome<Vec<f64>> {
    let tree = TriangleTree::new(to).map_err(value_error)?;
    if to.triangles.is_empty() {
        return Err(value_error("the second mesh has no triangle to measure a distance to"));
    }
    let mut hint = usize::MAX;
    let mut distances = Vec::with_capacity(from.vertex_count());
    for points in from.positions.chunks(VERTICES_PER_REPORT) {
        let (done, total) = (distances.len() as u64, from.vertex_count() as u64);
        Progress { phase: "measure", done, total }.report(progress).map_err(cancelled)?;
        distances.extend(points.iter().map(|p| tree.distance_from_hint(p.map(f64::from), &mut hint)));
    }
    Ok(distances)
}
