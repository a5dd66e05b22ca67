//! The classes `SceneData` and `LodSceneData`: whole glTF scenes.

use std::sync::Arc;

use pyo3::prelude::*;
use pyo3::types::PyBytes;
use striata::file::WriteOptions;
use striata::{Cancelled, LodOptions, ProgressFn, simplify::SimplifyError};
use striata_io::{Format, Scene, scene_losses, scene_to_bytes};
use striata_scene::glb_stream::GlbStreamError;
use striata_scene::stream::{SceneEncodeError, SceneStreamOptions, encode_scene_with_progress};
use striata_scene::{GlbStreamOptions, LodScene};

use crate::errors::{Outcome, cancelled, simplify_error, value_error, warning_texts, write_error};
use crate::job;
use crate::lod::LodData;
use crate::mesh::{ImageTuple, PyMeshData, image_tuples};
use crate::options::{SimplifyArguments, TargetArgument, reason};

/// A glTF scene.
#[pyclass(frozen, module = "striata._striata", name = "SceneData")]
#[derive(Clone, Debug)]
pub(crate) struct PySceneData {
    pub scene: Arc<Scene>,
}

/// A scene with all levels of its meshes.
#[pyclass(frozen, module = "striata._striata")]
#[derive(Clone, Debug)]
pub(crate) struct LodSceneData {
    pub lods: LodScene,
}

/// Node, mesh and transform (16 numbers in column order) of an instance.
type Instance = (Option<usize>, usize, [f64; 16]);

#[pymethods]
impl PySceneData {
    /// Scene of a single mesh.
    #[staticmethod]
    fn of_mesh(mesh: &PyMeshData) -> Outcome<Self> {
        Ok(Self::from(Scene::from_mesh(striata::mesh::IndexedMesh::clone(&mesh.mesh)).map_err(value_error)?))
    }

    /// The document as JSON.
    fn document(&self) -> String {
        self.scene.document().to_string()
    }

    /// Mesh of each entry of the document, or `None`.
    fn meshes(&self) -> Vec<Option<PyMeshData>> {
        self.scene.meshes().iter().map(|mesh| mesh.clone().map(PyMeshData::from)).collect()
    }

    fn mesh_names(&self) -> Vec<String> {
        (0..self.scene.meshes().len()).map(|mesh| self.scene.mesh_name(mesh).to_owned()).collect()
    }

    /// Images as tuples of name, location, MIME type and contents.
    fn images<'py>(&self, py: Python<'py>) -> Vec<ImageTuple<'py>> {
        image_tuples(py, self.scene.images())
    }

    fn instances(&self) -> Vec<Instance> {
        self.scene.instances().iter().map(|i| (i.node, i.mesh, i.transform)).collect()
    }

    fn warnings(&self) -> Vec<String> {
        warning_texts(self.scene.warnings())
    }

    #[getter]
    fn face_count(&self) -> usize {
        self.scene.triangle_count()
    }

    #[getter]
    fn diagonal(&self) -> f64 {
        self.scene.diagonal()
    }

    /// Warnings of data that a `striata`, `stri` or `glb` file does not hold; `file` is its name.
    fn losses(&self, format: &str, file: &str) -> Vec<String> {
        let format = match format {
            "striata" => Format::Striata,
            "stri" => Format::Stream,
            _ => Format::Glb,
        };
        warning_texts(&scene_losses(format, &self.scene, file))
    }

    /// One mesh of everything shown, with all transforms applied.
    fn flattened(&self, py: Python<'_>) -> Outcome<PyMeshData> {
        let scene = Arc::clone(&self.scene);
        let size = scene.triangle_count();
        job::run(py, size, None, move |_| Ok(PyMeshData::from(scene.flattened().map_err(write_error)?)))
    }

    /// The scene with equal parts merged.
    fn deduplicated(&self, py: Python<'_>) -> Outcome<Self> {
        let scene = Arc::clone(&self.scene);
        job::run(py, scene.triangle_count(), None, move |_| {
            Ok(Self::from(Scene::clone(&scene).deduplicated().0))
        })
    }

    /// The scene without keyframes that are within a tolerance of what their neighbors give.
    fn resampled(&self, py: Python<'_>, tolerance: f64) -> Outcome<Self> {
        let scene = Arc::clone(&self.scene);
        job::run(py, scene.triangle_count(), None, move |_| {
            let (resampled, _) = Scene::clone(&scene).resampled(tolerance).map_err(value_error)?;
            Ok(Self::from(resampled))
        })
    }

    /// Builds all levels of all meshes.
    fn build(
        &self,
        py: Python<'_>,
        guaranteed: bool,
        options: SimplifyArguments,
        progress: Option<Bound<'_, PyAny>>,
    ) -> Outcome<LodSceneData> {
        let options =
            LodOptions::default().with_sequence(options.sequence()?).with_guaranteed_errors(guaranteed);
        let scene = Arc::clone(&self.scene);
        let size = scene.triangle_count().max(usize::from(u16::MAX));
        let lods = job::run(py, size, progress.as_ref(), move |progress| {
            LodScene::build_with_progress(&scene, &options, progress).map_err(|error| match error.error {
                SimplifyError::Cancelled(_) => simplify_error(error.error),
                _ => value_error(error),
            })
        })?;
        Ok(LodSceneData { lods })
    }

    /// Bytes of a GLB file.
    fn to_glb<'py>(&self, py: Python<'py>) -> Outcome<Bound<'py, PyBytes>> {
        let scene = Arc::clone(&self.scene);
        let size = scene.triangle_count().max(usize::from(u16::MAX));
        let bytes = job::run(py, size, None, move |_| {
            scene_to_bytes(Format::Glb, &scene, &striata_io::WriteOptions::default()).map_err(write_error)
        })?;
        Ok(PyBytes::new(py, &bytes))
    }
}

impl From<Scene> for PySceneData {
    fn from(scene: Scene) -> Self {
        Self { scene: Arc::new(scene) }
    }
}

/// Split counts, triangles, vertices, error and stop reason of a level.
type LevelFacts = (Vec<usize>, usize, usize, f64, &'static str);

#[pymethods]
impl LodSceneData {
    #[getter]
    fn face_count(&self) -> usize {
        self.lods.triangle_count()
    }

    #[getter]
    fn has_guaranteed_errors(&self) -> bool {
        self.lods.has_guaranteed_errors()
    }

    #[getter]
    fn diagonal(&self) -> f64 {
        self.lods.full_scene().diagonal()
    }

    /// Levels of each mesh, or `None`.
    fn lods(&self) -> Vec<Option<LodData>> {
        self.lods.lods().iter().map(|lod| lod.clone().map(LodData::from)).collect()
    }

    fn full_scene(&self) -> PySceneData {
        PySceneData::from(self.lods.full_scene())
    }

    fn level(&self, py: Python<'_>, target: TargetArgument) -> Outcome<LevelFacts> {
        let target = target.target()?;
        let level = py.detach(|| self.lods.level(target));
        let reason = reason(level.stop_reason);
        Ok((level.split_counts, level.triangle_count, level.vertex_count, level.error, reason))
    }

    /// Scene of a level, given by the split count of each mesh.
    fn level_scene(&self, py: Python<'_>, target: TargetArgument) -> Outcome<PySceneData> {
        let target = target.target()?;
        let lods = self.lods.clone();
        let size = lods.triangle_count();
        let scene = job::run(py, size, None, move |_| Ok(lods.level_scene(&lods.level(target))))?;
        Ok(PySceneData::from(scene))
    }

    /// Bytes of a file with all levels: `striata`, `stri` or `glb`.
    fn to_bytes<'py>(
        &self,
        py: Python<'py>,
        format: String,
        progress: Option<Bound<'py, PyAny>>,
    ) -> Outcome<Bound<'py, PyBytes>> {
        let lods = self.lods.clone();
        let size = lods.triangle_count().max(usize::from(u16::MAX));
        let bytes = job::run(py, size, progress.as_ref(), move |progress| match format.as_str() {
            "striata" => lods.to_striata(&WriteOptions::default()).map_err(value_error),
            "glb" => {
                let bytes = lods.to_glb_with_stream_and_progress(&GlbStreamOptions::default(), progress);
                bytes.map_err(|error| match error {
                    GlbStreamError::Cancelled(reason) => cancelled(reason),
                    error => value_error(error),
                })
            }
            "stri" => scene_bytes(&lods.full_scene(), &SceneStreamOptions::default(), progress),
            _ => Err(value_error(format!(
                "cannot store all levels as {format:?}, only as striata, stri or glb"
            ))),
        })?;
        Ok(PyBytes::new(py, &bytes))
    }
}

/// Encodes a scene in a worker.
pub(crate) fn scene_bytes(
    scene: &Scene,
    options: &SceneStreamOptions,
    progress: &mut ProgressFn<'_>,
) -> Outcome<Vec<u8>> {
    match encode_scene_with_progress(scene, options, progress) {
        Ok(encoded) => Ok(encoded.bytes),
        Err(SceneEncodeError::Cancelled) => Err(cancelled(Cancelled)),
        Err(error) => Err(value_error(error)),
    }
}
