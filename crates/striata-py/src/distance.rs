//! Distances between surfaces.

use std::sync::Arc;

use numpy::{IntoPyArray as _, PyArray1};
use pyo3::prelude::*;
use striata::mesh::{DistanceOptions, IndexedMesh, OneSidedDistance, TriangleTree, surface_distance};

use crate::errors::{Outcome, value_error};
use crate::job;
use crate::mesh::MeshData;

/// Maximum, root mean square and mean of one direction.
type OneSided = (f64, f64, f64);

/// Both directions, the diagonal of the first mesh, and the number of samples.
type DistanceFacts = (OneSided, OneSided, f64, usize);

/// Measures the distance between two surfaces by sampling.
#[pyfunction]
pub(crate) fn distance(
    py: Python<'_>,
    a: &MeshData,
    b: &MeshData,
    samples: usize,
    seed: u64,
) -> Outcome<DistanceFacts> {
    let (a, b) = (Arc::clone(&a.mesh), Arc::clone(&b.mesh));
    let size = a.triangle_count() + b.triangle_count() + samples / 10;
    let options = DistanceOptions::default().with_sample_count(samples).with_seed(seed);
    let measured =
        job::run(py, size, None, move |_| surface_distance(&a, &b, &options).map_err(value_error))?;
    let side = |side: OneSidedDistance| (side.max, side.rms, side.mean);
    Ok((side(measured.a_to_b), side(measured.b_to_a), measured.diagonal, measured.sample_count))
}

/// Distance of each vertex of the first mesh to the surface of the second.
#[pyfunction]
pub(crate) fn vertex_distances<'py>(
    py: Python<'py>,
    from_: &MeshData,
    to: &MeshData,
) -> Outcome<Bound<'py, PyArray1<f64>>> {
    let (from, to) = (Arc::clone(&from_.mesh), Arc::clone(&to.mesh));
    let size = from.vertex_count() + to.triangle_count();
    let distances = job::run(py, size, None, move |_| measured(&from, &to))?;
    Ok(distances.into_pyarray(py))
}

fn measured(from: &IndexedMesh, to: &IndexedMesh) -> Outcome<Vec<f64>> {
    let tree = TriangleTree::new(to).map_err(value_error)?;
    if to.triangles.is_empty() {
        return Err(value_error("the second mesh has no triangle to measure a distance to"));
    }
    let mut hint = usize::MAX;
    let points = from.positions.iter().map(|p| p.map(f64::from));
    Ok(points.map(|point| tree.distance_within(point, 0.0, &mut hint)).collect())
}
