//! The class `ViewData`: an instance that follows a camera.

use std::sync::{Mutex, MutexGuard, PoisonError};

use numpy::PyArray2;
use pyo3::prelude::*;
use striata::view::Camera;
use striata::{Lod, View};

use crate::arrays::signed_rows;
use crate::errors::{Outcome, value_error};

/// A view, which threads update one after another.
#[pyclass(frozen, module = "striata._striata")]
#[derive(Debug)]
pub(crate) struct ViewData {
    view: Mutex<View>,
}

impl ViewData {
    pub(crate) fn new(lod: &Lod) -> Self {
        Self { view: Mutex::new(lod.view()) }
    }

    fn lock(&self) -> MutexGuard<'_, View> {
        self.view.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[pymethods]
impl ViewData {
    /// Updates the view; returns the number of splits and of collapses.
    #[expect(clippy::too_many_arguments, reason = "the Python half passes them by position")]
    fn update(
        &self,
        py: Python<'_>,
        eye: [f32; 3],
        target: [f32; 3],
        up: [f32; 3],
        tan_half_fov: f64,
        screen: [u32; 2],
        pixels: f32,
        budget: Option<usize>,
    ) -> Outcome<(usize, usize)> {
        let camera = Camera::new(eye, target, up, tan_half_fov, screen).map_err(value_error)?;
        let update = py.detach(|| match budget {
            Some(limit) => self.lock().update_to_budget(&camera, pixels, limit),
            None => self.lock().update(&camera, pixels),
        });
        Ok((update.split_count, update.collapse_count))
    }

    /// Triangles shown.
    fn faces<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<i32>> {
        let triangles = py.detach(|| self.lock().triangles().to_vec());
        signed_rows(py, triangles)
    }

    #[getter]
    fn face_count(&self, py: Python<'_>) -> usize {
        py.detach(|| self.lock().triangle_count())
    }
}
