//! Clusters of all levels of a mesh.

use std::sync::Arc;

use numpy::{IntoPyArray as _, PyArray1, PyArray2};
use pyo3::prelude::*;
use striata::clusters::{ClusterDag, ClusterOptions};

use crate::arrays::{rows_to_array, signed_rows};
use crate::errors::{Outcome, simplify_error};
use crate::job;
use crate::mesh::PyMeshData;
use crate::options::SimplifyArguments;

/// Arrays of clusters and groups: triangles; first triangle, number of triangles, group, refined group or -1, and group of
/// the mesh of each cluster; spheres of the clusters; depths, spheres and errors of the groups.
type ClusterArrays<'py> = (
    Bound<'py, PyArray2<i32>>,
    Bound<'py, PyArray2<i64>>,
    Bound<'py, PyArray2<f32>>,
    Bound<'py, PyArray1<i64>>,
    Bound<'py, PyArray2<f32>>,
    Bound<'py, PyArray1<f32>>,
);

/// Builds the clusters of all levels of a mesh.
#[pyfunction]
pub(crate) fn build_clusters<'py>(
    py: Python<'py>,
    mesh: &PyMeshData,
    sizes: [usize; 3],
    options: SimplifyArguments,
    progress: Option<Bound<'py, PyAny>>,
) -> Outcome<ClusterArrays<'py>> {
    let [max_triangles, max_vertices, group_size] = sizes;
    let options = ClusterOptions::default()
        .with_sequence(options.sequence()?)
        .with_max_triangles(max_triangles)
        .with_max_vertices(max_vertices)
        .with_group_size(group_size);
    let mesh = Arc::clone(&mesh.mesh);
    let ClusterDag { clusters, groups, triangles } =
        job::run(py, mesh.triangle_count(), progress.as_ref(), move |progress| {
            ClusterDag::build_with_progress(&mesh, &options, progress).map_err(simplify_error)
        })?;
    let row = |c: &striata::clusters::Cluster| {
        let refines = c.refines.map_or(-1, |group| group as i64);
        [c.triangles.start as i64, c.triangles.len() as i64, c.group as i64, refines, c.mesh_group as i64]
    };
    let sphere = |sphere: &striata::view::Sphere| {
        let [x, y, z] = sphere.center;
        [x, y, z, sphere.radius]
    };
    let depths: Vec<i64> = groups.iter().map(|group| group.depth as i64).collect();
    let errors: Vec<f32> = groups.iter().map(|group| group.error).collect();
    Ok((
        signed_rows(py, triangles),
        rows_to_array(py, clusters.iter().map(row).collect()),
        rows_to_array(py, clusters.iter().map(|c| sphere(&c.sphere)).collect()),
        depths.into_pyarray(py),
        rows_to_array(py, groups.iter().map(|group| sphere(&group.sphere)).collect()),
        errors.into_pyarray(py),
    ))
}
