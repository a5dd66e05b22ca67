//! The class `PagedLodData`: levels of a paged file, read page by page.

use std::path::Path;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use pyo3::prelude::*;
use striata::mesh::replay;
use striata::view::{Camera, DetailBox, ScreenError};
use striata_paged::{HEAD_NAME, PAGED_MAGIC, PagedError, PagedFile};

use crate::errors::{Outcome, decode_error, os_error, value_error};
use crate::job;
use crate::lod::LodData;
use crate::mesh::PyMeshData;
use crate::options::TargetArgument;

/// Reading takes a time that is unknown before it is done.
const UNKNOWN_SIZE: usize = usize::MAX;

/// A paged file, which threads read one after another.
#[pyclass(frozen, module = "striata._striata")]
pub(crate) struct PagedLodData {
    file: Arc<Mutex<PagedFile>>,
}

/// Errors of reading a paged file.
pub(crate) fn paged_error(error: PagedError) -> PyErr {
    match error {
        PagedError::Io { place, source } => os_error(&source, place),
        other => decode_error(other),
    }
}

/// Whether a path is a paged file or a folder of pages.
pub(crate) fn is_paged(path: &Path) -> bool {
    use std::io::Read as _;
    if path.join(HEAD_NAME).is_file() {
        return true;
    }
    let mut magic = [0; PAGED_MAGIC.len()];
    let read = std::fs::File::open(path).and_then(|mut file| file.read_exact(&mut magic));
    read.is_ok() && &magic == PAGED_MAGIC
}

impl PagedLodData {
    /// Reads the head of a file or folder.
    pub(crate) fn open(path: &Path) -> Outcome<Self> {
        let file = PagedFile::open(&path.to_string_lossy()).map_err(paged_error)?;
        Ok(Self { file: Arc::new(Mutex::new(file)) })
    }

    /// Runs work on the file on another thread, once its images have been read.
    fn run<T: Send + 'static>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut PagedFile) -> Outcome<T> + Send + 'static,
    ) -> Outcome<T> {
        let file = Arc::clone(&self.file);
        job::run(py, UNKNOWN_SIZE, None, move |_| {
            let mut file = locked(&file);
            file.load_images().map_err(paged_error)?;
            work(&mut file)
        })
    }
}

fn locked(file: &Mutex<PagedFile>) -> MutexGuard<'_, PagedFile> {
    file.lock().unwrap_or_else(PoisonError::into_inner)
}

#[pymethods]
impl PagedLodData {
    #[getter]
    fn face_count(&self) -> u64 {
        locked(&self.file).metadata().triangle_count
    }

    #[getter]
    fn point_count(&self) -> u64 {
        locked(&self.file).metadata().vertex_count
    }

    #[getter]
    fn page_count(&self) -> u32 {
        locked(&self.file).reader().page_count()
    }

    #[getter]
    fn diagonal(&self) -> f64 {
        locked(&self.file).metadata().diagonal()
    }

    /// Smallest and largest coordinates.
    #[getter]
    fn bounds(&self) -> ([f32; 3], [f32; 3]) {
        let file = locked(&self.file);
        (file.metadata().min, file.metadata().max)
    }

    /// Metadata of the mesh, as JSON.
    fn metadata(&self) -> Outcome<String> {
        serde_json::to_string(locked(&self.file).metadata()).map_err(value_error)
    }

    /// Requests, bytes and pages that have been read.
    #[getter]
    fn statistics(&self) -> (u64, u64, u64) {
        let read = locked(&self.file).statistics();
        (read.request_count, read.byte_count, read.page_count)
    }

    /// All levels of up to a number of triangles.
    fn lod(&self, py: Python<'_>, triangles: usize) -> Outcome<LodData> {
        self.run(py, move |file| {
            let level = file.level_for_triangles(triangles).map_err(paged_error)?;
            Ok(LodData::from(level.refinable))
        })
    }

    /// A level for a target, with only the vertices that it uses.
    fn level(&self, py: Python<'_>, wanted: TargetArgument) -> Outcome<PyMeshData> {
        let wanted = wanted.target()?;
        self.run(py, move |file| {
            let levels = file.levels_for(&[wanted]).map_err(paged_error)?.refinable;
            let (split_count, _) = wanted.resolve(&levels.sequence);
            Ok(PyMeshData::from(replay(&levels, split_count).without_unused_vertices()))
        })
    }

    /// The level for a view.
    #[expect(clippy::too_many_arguments, reason = "the Python half passes them by position")]
    fn view(
        &self,
        py: Python<'_>,
        eye: [f32; 3],
        target: [f32; 3],
        up: [f32; 3],
        tan_half_fov: f64,
        screen: [u32; 2],
        pixels: f32,
        budget: Option<usize>,
    ) -> Outcome<PyMeshData> {
        let camera = Camera::new(eye, target, up, tan_half_fov, screen).map_err(value_error)?;
        // With a limit, tolerances are relaxed by factors, so none may be zero.
        let least = if budget.is_some() { 1e-6 } else { 0.0 };
        let criterion = ScreenError::new(camera, pixels.max(least));
        self.run(py, move |file| {
            let found = file.level_for_view(&criterion, budget).map_err(paged_error)?;
            Ok(PyMeshData::from(found.cut.mesh))
        })
    }

    /// The level with full detail in a box.
    fn box_level(
        &self,
        py: Python<'_>,
        min: [f32; 3],
        max: [f32; 3],
        error_outside: f32,
    ) -> Outcome<PyMeshData> {
        self.run(py, move |file| {
            let cut = file.level_for(&DetailBox { min, max, error_outside }).map_err(paged_error)?;
            Ok(PyMeshData::from(cut.mesh))
        })
    }
}
