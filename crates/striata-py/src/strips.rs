//! Triangle strips.

use std::sync::Arc;

use numpy::PyArray1;
use pyo3::prelude::*;
use striata_strip::{StripOptions, stripify};

use crate::arrays::signed;
use crate::errors::{Outcome, value_error};
use crate::job;
use crate::mesh::MeshData;

/// Makes strips; returns one index list with the restart index -1 (or repeated indices if `stitched`), and the
/// number of strips.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the Python half passes them by position")]
pub(crate) fn strip<'py>(
    py: Python<'py>,
    mesh: &MeshData,
    stripifier: &str,
    seed: u64,
    effort: f64,
    cache_weight: f64,
    cache_size: usize,
    stitched: bool,
) -> Outcome<(Bound<'py, PyArray1<i32>>, usize)> {
    let options = StripOptions::default()
        .with_stripifier(stripifier.parse().map_err(value_error)?)
        .with_seed(seed)
        .with_effort(effort)
        .with_cache_weight(cache_weight)
        .with_cache_size(cache_size);
    let mesh = Arc::clone(&mesh.mesh);
    let (indices, count) = job::run(py, mesh.triangle_count(), None, move |_| {
        let strips = stripify(&mesh, &options).map_err(value_error)?;
        let joined = if stitched { strips.to_stitched_indices() } else { strips.to_restart_indices() };
        Ok((joined.indices, strips.strip_count()))
    })?;
    Ok((signed(py, indices), count))
}
