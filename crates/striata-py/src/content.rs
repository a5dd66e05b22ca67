//! Content of a file or a stream: a mesh or a scene, with or without levels.

use pyo3::IntoPyObjectExt as _;
use pyo3::prelude::*;

use crate::errors::Outcome;
use crate::lod::LodData;
use crate::mesh::PyMeshData;
use crate::paged::PagedLodData;
use crate::scene::{LodSceneData, PySceneData};

/// One of the classes of the module.
pub(crate) enum LoadedContent {
    Mesh(PyMeshData),
    Scene(PySceneData),
    Lod(LodData),
    LodScene(LodSceneData),
    PagedLod(PagedLodData),
}

impl LoadedContent {
    pub(crate) fn into_python(self, py: Python<'_>) -> Outcome<Bound<'_, PyAny>> {
        match self {
            Self::Mesh(data) => data.into_bound_py_any(py),
            Self::Scene(data) => data.into_bound_py_any(py),
            Self::Lod(data) => data.into_bound_py_any(py),
            Self::LodScene(data) => data.into_bound_py_any(py),
            Self::PagedLod(data) => data.into_bound_py_any(py),
        }
    }
}
