//! Triangle strips.

use std::sync::Arc;

use numpy::PyArray1;
use pyo3::prelude::*;
use striata_strip::{StripOptions, StripifyError, stripify_with_progress};

use crate::arrays::signed;
use crate::errors::{Outcome, cancelled, value_error};
use crate::job;
use crate::mesh::PyMeshData;

/// Makes strips; returns one index list with the restart index -1 (or repeated indices if `stitched`), and the
/// number of strips.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the Python half passes them by position")]
pub(crate) fn strip<'py>(
    py: Python<'py>,
    mesh: &PyMeshData,
    stripifier: &str,
    seed: u64,
    effort: f64,
    cache_weight: f64,
    cache_size: usize,
    stitched: bool,
    progress: Option<Bound<'py, PyAny>>,
) -> Outcome<(Bound<'py, PyArray1<i32>>, usize)> {
    let options = StripOptions::default()
        .with_stripifier(stripifier.parse().map_err(value_error)?)
        .with_seed(seed)
        .with_effort(effort)
        .with_cache_weight(cache_weight)
        .with_cache_size(cache_size);
    let mesh = Arc::clone(&mesh.mesh);
    // A search of a small mesh takes long if the effort is large.
    let size = (mesh.triangle_count() as f64 * effort.max(1.0)) as usize;
    let (indices, count) = job::run(py, size, progress.as_ref(), move |progress| {
        let strips = stripify_with_progress(&mesh, &options, progress).map_err(|error| match error {
            StripifyError::Cancelled(reason) => cancelled(reason),
            error => value_error(error),
        })?;
        let joined = if stitched { strips.to_stitched_indices() } else { strips.to_restart_indices() };
        Ok((joined.indices, strips.strip_count()))
    })?;
    Ok((signed(py, indices), count))
}
