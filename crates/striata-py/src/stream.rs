//! Encoding and decoding of progressive streams.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use striata::file::DecodeError;
use striata::mesh::IndexedMesh;
use striata::simplify::{BatchOptions, build_batches_with_progress};
use striata::{Cancelled, ProgressFn};
use striata_io::Scene;
use striata_scene::stream::SceneStreamOptions;
use striata_stream::{
    Effort, Precision, SHAPE_STEPS, StreamDecoder as Decoder, StreamError, StreamOptions,
    encode_stream_with_progress,
};

use crate::arrays::signed_rows;
use crate::errors::{Outcome, cancelled, decode_error, internal_error, simplify_error, value_error};
use crate::job;
use crate::lod::LodData;
use crate::mesh::{PyMeshData, file_points};
use crate::options::choice;
use crate::scene::{PySceneData, scene_bytes};

/// Precision as bits or a tolerance; lossless if neither is given. And the effort.
type Quality = (Option<u32>, Option<f64>, String);

fn stream_options((bits, tolerance, effort): Quality) -> Outcome<StreamOptions> {
    let precision = match (bits, tolerance) {
        (Some(bits), _) => Precision::Bits(bits),
        (None, Some(tolerance)) => Precision::Tolerance(tolerance),
        (None, None) => Precision::Lossless,
    };
    let efforts = [("fast", Effort::Fast), ("compact", Effort::Compact)];
    let effort = choice("effort", &effort, &efforts)?;
    Ok(StreamOptions::default().with_precision(precision).with_effort(effort))
}

/// Encodes a mesh as a progressive stream.
#[pyfunction]
pub(crate) fn encode_mesh<'py>(
    py: Python<'py>,
    mesh: &PyMeshData,
    quality: Quality,
    progress: Option<Bound<'py, PyAny>>,
) -> Outcome<Bound<'py, PyBytes>> {
    let (mesh, options) = (Arc::clone(&mesh.mesh), stream_options(quality)?);
    let bytes = job::run(py, mesh.triangle_count(), progress.as_ref(), move |progress| {
        let step = options.grid_step(&mesh).map_err(value_error)?;
        let batches = BatchOptions::default().with_shape_step(Some(SHAPE_STEPS * step));
        let built = build_batches_with_progress(&mesh, &batches, progress).map_err(simplify_error)?;
        let encoded = encode_stream_with_progress(&built.built.refinable, &built.batches, &options, progress);
        Ok(encoded.map_err(stream_error)?.bytes)
    })?;
    Ok(PyBytes::new(py, &bytes))
}

/// Encodes a scene as one progressive stream.
#[pyfunction]
pub(crate) fn encode_scene<'py>(
    py: Python<'py>,
    scene: &PySceneData,
    quality: Quality,
    preview_side: u32,
    progress: Option<Bound<'py, PyAny>>,
) -> Outcome<Bound<'py, PyBytes>> {
    let options = stream_options(quality)?;
    let options = SceneStreamOptions::default().with_stream(options).with_preview_side(preview_side);
    let scene: Arc<Scene> = Arc::clone(&scene.scene);
    let size = scene.triangle_count().max(usize::from(u16::MAX));
    let bytes =
        job::run(py, size, progress.as_ref(), move |progress| scene_bytes(&scene, &options, progress))?;
    Ok(PyBytes::new(py, &bytes))
}

fn stream_error(error: StreamError) -> PyErr {
    match error {
        StreamError::Cancelled(reason) => cancelled(reason),
        error => value_error(error),
    }
}

/// A decoder, and the bytes that it has not seen yet because a call was interrupted.
#[derive(Debug, Default)]
struct Feed {
    decoder: Decoder,
    waiting: Vec<u8>,
}

impl Feed {
    /// Decodes the bytes that wait; what is left when the caller cancels goes on waiting.
    fn decode(&mut self, progress: &mut ProgressFn<'_>) -> Outcome<()> {
        let mut bytes = std::mem::take(&mut self.waiting);
        let accepted = self.decoder.push_with_progress(&bytes, progress).map_err(decode_error)?;
        if accepted == bytes.len() {
            return Ok(());
        }
        bytes.drain(..accepted);
        self.waiting = bytes;
        Err(cancelled(Cancelled))
    }
}

/// A decoder of a stream that arrives in pieces.
#[pyclass(frozen, module = "striata._striata")]
#[derive(Debug)]
pub(crate) struct DecoderData {
    feed: Arc<Mutex<Feed>>,
}

impl DecoderData {
    fn lock(&self) -> MutexGuard<'_, Feed> {
        locked(&self.feed)
    }
}

fn locked(feed: &Mutex<Feed>) -> MutexGuard<'_, Feed> {
    feed.lock().unwrap_or_else(PoisonError::into_inner)
}

#[pymethods]
impl DecoderData {
    #[new]
    fn new() -> Self {
        Self { feed: Arc::default() }
    }

    /// Decodes the next bytes. If the call is interrupted, the next one decodes the rest.
    fn push(&self, py: Python<'_>, bytes: Vec<u8>) -> Outcome<()> {
        let feed = Arc::clone(&self.feed);
        job::run(py, bytes.len(), None, move |progress| {
            let mut feed = locked(&feed);
            feed.waiting.extend_from_slice(&bytes);
            feed.decode(progress)
        })
    }

    /// Decodes what it can of a stream that will not go on.
    fn finish(&self, py: Python<'_>) -> Outcome<()> {
        let feed = Arc::clone(&self.feed);
        job::run(py, usize::MAX, None, move |progress| {
            let mut feed = locked(&feed);
            feed.decode(progress)?;
            feed.decoder.finish().map(drop).map_err(decode_error)
        })
    }

    fn points<'py>(&self, py: Python<'py>) -> Bound<'py, PyAny> {
        let mesh = py.detach(|| {
            let decoder = &self.lock().decoder;
            let origin = decoder.info().map_or([0.0; 3], |info| info.origin);
            IndexedMesh { origin, ..IndexedMesh::new(decoder.positions().to_vec(), Vec::new()) }
        });
        file_points(py, &mesh)
    }

    fn faces<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<i32>> {
        let triangles = py.detach(|| self.lock().decoder.triangles().to_vec());
        signed_rows(py, triangles)
    }

    /// The levels decoded so far; `None` before the base mesh has arrived.
    fn lod(&self, py: Python<'_>) -> Outcome<Option<LodData>> {
        let feed = Arc::clone(&self.feed);
        job::run(py, usize::MAX, None, move |_| {
            let feed = locked(&feed);
            if feed.decoder.has_fragments() {
                return Err(value_error(DecodeError::NoCollapses));
            }
            let Some(mesh) = feed.decoder.refinable_mesh() else { return Ok(None) };
            mesh.mesh.check().map_err(internal_error)?;
            Ok(Some(LodData::from(mesh)))
        })
    }

    /// Whether the stream is complete, number of splits decoded, number of all splits, error now, and length
    /// of the stream in bytes; `None` until the header has arrived.
    fn facts(&self, py: Python<'_>) -> (bool, usize, Option<usize>, Option<f32>, Option<u64>) {
        py.detach(|| {
            let decoder = &self.lock().decoder;
            let length = decoder.info().map(|info| info.stream_bytes);
            let (done, all) = (decoder.split_count(), decoder.step_count());
            (decoder.is_complete(), done, all, decoder.error(), length)
        })
    }
}
