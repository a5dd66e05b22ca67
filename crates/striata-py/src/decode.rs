//! Decoding of streams and `.striata` files from memory.
//!
//! Streams are decoded in pieces, with a look at the progress callback before each.

use std::fmt::Display;

use pyo3::prelude::*;
use striata::file::DecodeError;
use striata::{Cancelled, Lod, Progress, ProgressFn};
use striata_scene::LodScene;
use striata_scene::file::{SceneFile, is_scene_file};
use striata_scene::stream::SceneStreamDecoder;
use striata_stream::StreamDecoder;

use crate::content::LoadedContent;
use crate::errors::{Outcome, cancelled, decode_error};
use crate::job;
use crate::lod::LodData;
use crate::scene::LodSceneData;

/// Number of bytes of a scene that are decoded between two looks at the progress.
const PIECE_BYTES: usize = 1 << 16;

/// Why bytes were not decoded. Workers make no Python objects, so the caller converts it.
#[derive(Debug)]
pub(crate) enum DecodeFault {
    Cancelled(Cancelled),
    /// The bytes cannot be decoded; the text gives the reason.
    Bytes(String),
}

impl DecodeFault {
    /// The exception for bytes from memory, or from a file.
    pub(crate) fn into_error(self, file: Option<&str>) -> PyErr {
        match (self, file) {
            (Self::Cancelled(reason), _) => cancelled(reason),
            (Self::Bytes(reason), None) => decode_error(reason),
            (Self::Bytes(reason), Some(file)) => decode_error(format!("{file}: {reason}")),
        }
    }
}

fn bad_bytes(reason: impl Display) -> DecodeFault {
    DecodeFault::Bytes(reason.to_string())
}

type Decoded<T> = Result<T, DecodeFault>;

const TRUNCATED: &str = "the stream is truncated (decode what is there with allow_truncated=True)";

/// Decodes a stream or a `.striata` file from memory.
#[pyfunction]
pub(crate) fn decode<'py>(
    py: Python<'py>,
    bytes: Vec<u8>,
    allow_truncated: bool,
    progress: Option<Bound<'py, PyAny>>,
) -> Outcome<Bound<'py, PyAny>> {
    let size = bytes.len();
    let content = job::run(py, size, progress.as_ref(), move |progress| {
        decoded(&bytes, allow_truncated, progress).map_err(|fault| fault.into_error(None))
    })?;
    content.into_python(py)
}

/// Decodes whatever the bytes are.
pub(crate) fn decoded(
    bytes: &[u8],
    allow_truncated: bool,
    progress: &mut ProgressFn<'_>,
) -> Decoded<LoadedContent> {
    if bytes.starts_with(&striata::file::SCENE_STREAM_MAGIC) {
        let lods = scene_stream(bytes, allow_truncated, progress)?;
        return Ok(LoadedContent::LodScene(LodSceneData { lods }));
    }
    if bytes.starts_with(&striata::file::STREAM_MAGIC) {
        return Ok(LoadedContent::Lod(mesh_stream(bytes, allow_truncated, progress)?));
    }
    if is_scene_file(bytes) {
        let lods = SceneFile::parse(bytes).and_then(|file| file.lod_scene()).map_err(bad_bytes)?;
        return Ok(LoadedContent::LodScene(LodSceneData { lods }));
    }
    let file = striata_stream::open(bytes).map_err(bad_bytes)?;
    match file.stream() {
        Some(stream) if file.is_stream_only() => {
            Ok(LoadedContent::Lod(mesh_stream(stream.map_err(bad_bytes)?, false, progress)?))
        }
        _ => Ok(LoadedContent::Lod(LodData::of_file(&file, bytes).map_err(bad_bytes)?)),
    }
}

fn mesh_stream(bytes: &[u8], allow_truncated: bool, progress: &mut ProgressFn<'_>) -> Decoded<LodData> {
    let mut decoder = StreamDecoder::new();
    if decoder.push_with_progress(bytes, progress).map_err(bad_bytes)? < bytes.len() {
        return Err(DecodeFault::Cancelled(Cancelled));
    }
    if !decoder.is_complete() {
        if !allow_truncated {
            return Err(bad_bytes(TRUNCATED));
        }
        decoder.finish().map_err(bad_bytes)?;
    }
    if decoder.has_fragments() {
        return Err(bad_bytes(DecodeError::NoCollapses));
    }
    let refinable = decoder.refinable_mesh().ok_or_else(|| bad_bytes("the stream has no mesh"))?;
    refinable.mesh.check().map_err(bad_bytes)?;
    Ok(LodData::from(refinable))
}

fn scene_stream(bytes: &[u8], allow_truncated: bool, progress: &mut ProgressFn<'_>) -> Decoded<LodScene> {
    let mut decoder = SceneStreamDecoder::new();
    for (index, piece) in bytes.chunks(PIECE_BYTES).enumerate() {
        let (done, total) = ((index * PIECE_BYTES) as u64, bytes.len() as u64);
        Progress { phase: "decode", done, total }.report(progress).map_err(DecodeFault::Cancelled)?;
        decoder.push(piece).map_err(bad_bytes)?;
    }
    if !decoder.is_complete() {
        if !allow_truncated {
            return Err(bad_bytes(TRUNCATED));
        }
        decoder.finish().map_err(bad_bytes)?;
    }
    let scene = decoder.scene().map_err(bad_bytes)?;
    let meshes = decoder.refinable_meshes().into_iter();
    let lods: Vec<Option<Lod>> = meshes.map(|mesh| mesh.map(Lod::from_refinable)).collect();
    for lod in lods.iter().flatten() {
        lod.prepare_with_progress(progress).map_err(DecodeFault::Cancelled)?;
    }
    LodScene::from_lods(scene.without_meshes(), lods).map_err(bad_bytes)
}
