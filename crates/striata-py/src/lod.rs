//! The class `LodData`: every level of a mesh.

use std::sync::Arc;

use numpy::{IntoPyArray as _, PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use striata::file::{DecodeError, StriataFile, WriteOptions};
use striata::mesh::{RefinableMesh, weld};
use striata::simplify::{build_welded_sequence_with_progress, certify_collapses_in_any_state_with_progress};
use striata::{Lod, Target};

use crate::arrays::{signed, signed_rows};
use crate::errors::{Outcome, cancelled, decode_error, simplify_error, value_error};
use crate::job;
use crate::mesh::{PyMeshData, file_points, is_internal, move_origin, without_internal_layers};
use crate::one_level::check_locked;
use crate::options::{SimplifyArguments, TargetArgument, reason};
use crate::sources::{VertexSources, level_triangles, representatives};
use crate::strip_level::StripLevelData;
use crate::view::ViewData;

/// Every level of a mesh, and where its vertices come from.
#[pyclass(frozen, module = "striata._striata")]
#[derive(Clone, Debug)]
pub(crate) struct LodData {
    lod: Lod,
    /// `None` if the levels were read from a file.
    sources: Option<Arc<VertexSources>>,
    /// The file with the strips of the levels, which are read when they are needed.
    file_with_strips: Option<Arc<[u8]>>,
}

impl From<Lod> for LodData {
    fn from(lod: Lod) -> Self {
        Self { lod, sources: None, file_with_strips: None }
    }
}

impl From<RefinableMesh> for LodData {
    fn from(refinable: RefinableMesh) -> Self {
        Self::from(Lod::from_refinable(refinable))
    }
}

/// Builds every level of a mesh.
#[pyfunction]
pub(crate) fn build(
    py: Python<'_>,
    mesh: &PyMeshData,
    guaranteed: bool,
    options: SimplifyArguments,
    progress: Option<Bound<'_, PyAny>>,
) -> Outcome<LodData> {
    let (mesh, options) = (Arc::clone(&mesh.mesh), options.sequence()?);
    job::run(py, mesh.triangle_count(), progress.as_ref(), move |progress| {
        options.check().and_then(|()| check_locked(&options, &mesh)).map_err(simplify_error)?;
        let welded = weld(&mesh).map_err(value_error)?;
        let position_of_source = welded.position_of_source.clone();
        let built =
            build_welded_sequence_with_progress(welded, &options, progress).map_err(simplify_error)?;
        let sequence = &built.refinable.sequence;
        let sources = VertexSources::new(&mesh, &position_of_source, sequence, built.source_vertex);
        let lod = if guaranteed {
            let certified = certify_collapses_in_any_state_with_progress(&built.refinable, progress);
            Lod::from_certified(certified.map_err(|error| simplify_error(error.into()))?)
        } else {
            Lod::from_refinable(built.refinable)
        };
        Ok(LodData { lod, sources: Some(Arc::new(sources)), file_with_strips: None })
    })
}

#[pymethods]
impl LodData {
    #[getter]
    fn step_count(&self) -> usize {
        self.lod.sequence().step_count()
    }

    #[getter]
    fn has_guaranteed_errors(&self) -> bool {
        self.lod.has_guaranteed_errors()
    }

    /// Input vertex of each vertex, or `None` for levels read from a file.
    fn vertices<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<i32>>> {
        Some(signed(py, self.sources.as_ref()?.input_of_vertex.clone()))
    }

    /// Vertex of each input vertex; -1 if no level contains it. `None` for levels read from a file.
    fn vertex_of_input<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<i32>>> {
        Some(signed(py, self.sources.as_ref()?.vertex_of_input.clone()))
    }

    fn points<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        file_points(py, self.lod.mesh())
    }

    /// Origin of the points that single precision is relative to.
    #[getter]
    fn origin(&self) -> [f64; 3] {
        self.lod.mesh().origin
    }

    fn mesh(&self) -> PyMeshData {
        PyMeshData::from(without_internal_layers(self.lod.mesh()))
    }

    /// Split count of the level that a target selects, and how well it is met.
    fn resolve(&self, target: TargetArgument) -> Outcome<(usize, &'static str)> {
        let (split_count, stop_reason) = target.target()?.resolve(self.lod.sequence());
        Ok((split_count, reason(stop_reason)))
    }

    /// Number of triangles and of vertices, and the error of a level.
    fn level_facts(&self, split_count: usize) -> (usize, usize, f32) {
        let sequence = self.lod.sequence();
        let split_count = split_count.min(sequence.step_count());
        let counts = (sequence.triangle_count_at(split_count), sequence.vertex_count_at(split_count));
        (counts.0, counts.1, sequence.error_at(split_count))
    }

    /// Triangles of a level, and the input triangle of each (the triangle of the full mesh, for levels read
    /// from a file).
    fn level_faces<'py>(
        &self,
        py: Python<'py>,
        split_count: usize,
    ) -> (Bound<'py, PyArray2<i32>>, Bound<'py, PyArray1<i32>>) {
        let (triangles, origins) = py.detach(|| {
            let (triangles, mut origins) =
                level_triangles(self.lod.mesh(), &self.representatives(split_count));
            if let Some(sources) = &self.sources {
                origins.iter_mut().for_each(|t| *t = sources.input_of_triangle[*t as usize]);
            }
            (triangles, origins)
        });
        (signed_rows(py, triangles), signed(py, origins))
    }

    /// Level as strips with the restart index -1.
    fn level_strips<'py>(&self, py: Python<'py>, split_count: usize) -> Outcome<Bound<'py, PyArray1<i32>>> {
        let lod = self.lod.clone();
        let indices = job::run(py, self.size(), None, move |progress| {
            lod.prepare_with_progress(progress).map_err(cancelled)?;
            Ok(lod.level(Target::SplitCount(split_count)).strips().indices)
        })?;
        Ok(signed(py, indices))
    }

    /// Level as a mesh of its own, with all layers, groups and materials.
    fn level_mesh(&self, py: Python<'_>, split_count: usize) -> PyMeshData {
        let level = py.detach(|| self.lod.level_mesh(Target::SplitCount(split_count)));
        PyMeshData::from(without_internal_layers(&level))
    }

    /// For each vertex, the vertex that represents it at a level.
    fn representative<'py>(&self, py: Python<'py>, split_count: usize) -> Bound<'py, PyArray1<i32>> {
        signed(py, py.detach(|| self.representatives(split_count)))
    }

    /// Collapses in the order in which they coarsen the mesh: removed vertex, target, step, error after the
    /// step, and number of triangles after it.
    fn sequence<'py>(&self, py: Python<'py>) -> CollapseArrays<'py> {
        let [removed, targets, steps] = py.detach(|| self.collapses());
        let sequence = self.lod.sequence();
        let at = |step: &u32| sequence.step_count() - 1 - *step as usize;
        let errors: Vec<f32> = steps.iter().map(|step| sequence.error_at(at(step))).collect();
        let faces: Vec<i32> = steps.iter().map(|step| sequence.triangle_count_at(at(step)) as i32).collect();
        (
            signed(py, removed),
            signed(py, targets),
            signed(py, steps),
            errors.into_pyarray(py),
            faces.into_pyarray(py),
        )
    }

    fn view(&self, py: Python<'_>) -> Outcome<ViewData> {
        let lod = self.lod.clone();
        job::run(py, self.size(), None, move |progress| {
            lod.prepare_with_progress(progress).map_err(cancelled)?;
            Ok(ViewData::new(&lod))
        })
    }

    fn strip_level(&self, py: Python<'_>) -> Outcome<StripLevelData> {
        let data = self.clone();
        job::run(py, self.size(), None, move |_| {
            data.take_strips(&data.lod)?;
            Ok(data.lod.strip_level(Target::Detail(1.0)).map_err(value_error)?.into())
        })
    }

    /// Bytes of a `.striata` file, with all points moved by an offset.
    fn to_striata<'py>(&self, py: Python<'py>, offset: [f64; 3]) -> Outcome<Bound<'py, PyBytes>> {
        let data = self.clone();
        let bytes = job::run(py, self.size(), None, move |progress| {
            let lod = stored(data.lod.clone(), offset);
            data.take_strips(&lod)?;
            lod.prepare_with_progress(progress).map_err(cancelled)?;
            lod.to_striata(&WriteOptions::default()).map_err(value_error)
        })?;
        Ok(PyBytes::new(py, &bytes))
    }
}

/// Removed vertices, targets, steps, errors and triangle counts.
type CollapseArrays<'py> = (
    Bound<'py, PyArray1<i32>>,
    Bound<'py, PyArray1<i32>>,
    Bound<'py, PyArray1<i32>>,
    Bound<'py, PyArray1<f32>>,
    Bound<'py, PyArray1<i32>>,
);

impl LodData {
    /// Levels of a file, whose strips are read when they are needed.
    ///
    /// # Errors
    /// [`DecodeError`] if the file is damaged.
    pub(crate) fn of_file(file: &StriataFile<'_>, bytes: &[u8]) -> Result<Self, DecodeError> {
        let lod = Lod::from_file(file)?;
        let file_with_strips = file.has_lod_strips().then(|| bytes.into());
        Ok(Self { file_with_strips, ..Self::from(lod) })
    }

    /// Gives the strips of the file, if it has any, to levels of the same mesh.
    fn take_strips(&self, lod: &Lod) -> Outcome<()> {
        let Some(bytes) = &self.file_with_strips else { return Ok(()) };
        let file = striata_stream::open(bytes).map_err(decode_error)?;
        if let Some(strips) = file.lod_strips() {
            let strips = strips.map_err(decode_error)?.into_owned();
            lod.clone().with_strips(strips).map_err(decode_error)?;
        }
        Ok(())
    }

    /// For each vertex of the full mesh, the vertex that represents it at a level. Split counts above the full mesh mean
    /// the full mesh.
    fn representatives(&self, split_count: usize) -> Vec<u32> {
        let sequence = self.lod.sequence();
        representatives(sequence, split_count.min(sequence.step_count()))
    }

    /// Number of triangles of the full mesh.
    fn size(&self) -> usize {
        self.lod.mesh().triangle_count()
    }

    /// Removed vertices, their targets and the number of each step, in the order of coarsening.
    fn collapses(&self) -> [Vec<u32>; 3] {
        let sequence = self.lod.sequence();
        let count = sequence.targets().len();
        let [mut removed, mut targets, mut steps] = [(); 3].map(|()| Vec::with_capacity(count));
        for step in (0..sequence.step_count()).rev() {
            for vertex in sequence.step_vertices(step) {
                removed.push(vertex);
                targets.push(sequence.target(vertex));
                steps.push((sequence.step_count() - 1 - step) as u32);
            }
        }
        [removed, targets, steps]
    }
}

/// Levels as a file stores them: points moved by an offset, without layers that exist only for simplification.
fn stored(lod: Lod, offset: [f64; 3]) -> Lod {
    if offset == [0.0; 3] && !lod.mesh().layers.iter().any(is_internal) {
        return lod;
    }
    let mut mesh = without_internal_layers(lod.mesh());
    move_origin(&mut mesh, offset);
    let refinable = RefinableMesh { mesh, sequence: lod.sequence().clone() };
    match lod.has_guaranteed_errors() {
        true => Lod::from_certified(refinable),
        false => Lod::from_refinable(refinable),
    }
}
