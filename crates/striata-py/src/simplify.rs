//! Simplification to one level.

use std::sync::Arc;

use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use striata::ProgressFn;
use striata::mesh::IndexedMesh;
use striata::simplify::{
    Placement, SequenceOptions, SimplifyError, SimplifyOptions, StopReason, simplify_with_progress,
};

use crate::arrays::{signed, signed_rows};
use crate::errors::{Outcome, simplify_error};
use crate::job;
use crate::mesh::PyMeshData;
use crate::one_level::{OneLevelRequest, simplify_one_level, simplify_whole_mesh};
use crate::options::{SimplifyArguments, TargetArgument, reason};

/// One level as faces, kept input vertices, input triangle of each face, error and stop reason.
type LevelArrays<'py> =
    (Bound<'py, PyArray2<i32>>, Bound<'py, PyArray1<i32>>, Bound<'py, PyArray1<i32>>, f64, &'static str);

/// Simplifies a mesh to one level, in terms of its vertices and triangles.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the Python half passes them by position")]
pub(crate) fn simplify<'py>(
    py: Python<'py>,
    mesh: &PyMeshData,
    target: TargetArgument,
    max_error: Option<f64>,
    guaranteed: bool,
    options: SimplifyArguments,
    progress: Option<Bound<'py, PyAny>>,
) -> Outcome<LevelArrays<'py>> {
    let target = target.target()?;
    let request = OneLevelRequest { target, max_error, is_guaranteed: guaranteed };
    let (mesh, options) = (Arc::clone(&mesh.mesh), options.sequence()?);
    let level = job::run(py, mesh.triangle_count(), progress.as_ref(), move |progress| {
        simplify_one_level(&mesh, request, &options, progress).map_err(simplify_error)
    })?;
    let faces = signed_rows(py, level.triangles);
    let (kept, origins) = (signed(py, level.kept), signed(py, level.origins));
    Ok((faces, kept, origins, level.error, reason(level.stop_reason)))
}

/// Simplifies a mesh with its groups to one level of its own vertices, or of freely placed ones.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "the Python half passes them by position")]
pub(crate) fn simplify_mesh(
    py: Python<'_>,
    mesh: &PyMeshData,
    target: TargetArgument,
    max_error: Option<f64>,
    guaranteed: bool,
    free_placement: bool,
    options: SimplifyArguments,
    progress: Option<Bound<'_, PyAny>>,
) -> Outcome<(PyMeshData, f64, &'static str)> {
    let target = target.target()?;
    let request = OneLevelRequest { target, max_error, is_guaranteed: guaranteed };
    let (mesh, options) = (Arc::clone(&mesh.mesh), options.sequence()?);
    let (made, error, stop_reason) =
        job::run(py, mesh.triangle_count(), progress.as_ref(), move |progress| {
            let made = match free_placement {
                true => placed_freely(&mesh, request, options, progress),
                false => simplify_whole_mesh(&mesh, request, &options, progress),
            };
            made.map_err(simplify_error)
        })?;
    Ok((PyMeshData::from(made), error, reason(stop_reason)))
}

/// Simplifies with points that may lie anywhere. Errors are measured, not guaranteed.
fn placed_freely(
    mesh: &IndexedMesh,
    request: OneLevelRequest,
    options: SequenceOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<(IndexedMesh, f64, StopReason), SimplifyError> {
    let mut all = SimplifyOptions::default().with_target(request.target).with_sequence(options);
    all.tolerance = request.max_error;
    all.placement = Placement::Optimal;
    let level = simplify_with_progress(mesh, &all, progress)?;
    Ok((level.mesh, level.error, level.stop_reason))
}
