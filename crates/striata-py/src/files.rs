//! Reading and writing of files, and decoding of bytes.

use std::fs;
use std::path::PathBuf;
use std::sync::Arc;

use pyo3::IntoPyObjectExt as _;
use pyo3::prelude::*;
use striata::Lod;
use striata_io::{Format, Source, WriteOptions, write_atomically};
use striata_scene::file::{SceneFile, is_scene_file};
use striata_scene::stream::SceneStreamDecoder;
use striata_scene::{LodScene, read_glb_with_stream};

use crate::errors::{Outcome, decode_error, os_error, read_error, write_error};
use crate::job;
use crate::lod::LodData;
use crate::mesh::MeshData;
use crate::scene::{LodSceneData, SceneData};

/// Work that always deserves a thread, since its size is unknown before it is done.
const UNKNOWN_SIZE: usize = usize::MAX;

/// What a file contains.
enum Content {
    Mesh(MeshData),
    Scene(SceneData),
    Lod(LodData),
    LodScene(LodSceneData),
}

impl Content {
    fn into_python(self, py: Python<'_>) -> Outcome<Bound<'_, PyAny>> {
        match self {
            Self::Mesh(data) => data.into_bound_py_any(py),
            Self::Scene(data) => data.into_bound_py_any(py),
            Self::Lod(data) => data.into_bound_py_any(py),
            Self::LodScene(data) => data.into_bound_py_any(py),
        }
    }
}

/// Opens a file of any kind; returns its content and warnings.
#[pyfunction]
pub(crate) fn open_file(py: Python<'_>, path: PathBuf) -> Outcome<(Bound<'_, PyAny>, Vec<String>)> {
    let (content, warnings) = job::run(py, UNKNOWN_SIZE, None, move |_| opened(&path))?;
    Ok((content.into_python(py)?, warnings))
}

fn opened(path: &PathBuf) -> Outcome<(Content, Vec<String>)> {
    let name = path.display().to_string();
    let bytes = fs::read(path).map_err(|error| os_error(&error, name.clone()))?;
    let (bytes, inner_name) = striata_io::decompressed(bytes.into(), &name).map_err(read_error)?;
    match Format::detect(&bytes, &inner_name) {
        Some(Format::Striata | Format::Stream) => {
            let content = decoded(&bytes, false).map_err(|error| decode_error(format!("{name}: {error}")))?;
            Ok((content, Vec::new()))
        }
        Some(Format::Gltf | Format::Glb) => {
            let folder = path.parent().map(PathBuf::from).unwrap_or_default();
            let source = Source::new(&inner_name).with_folder(&folder);
            if let Some(lods) = read_glb_with_stream(&bytes, &source).map_err(decode_error)? {
                return Ok((Content::LodScene(LodSceneData { lods }), Vec::new()));
            }
            drop(bytes);
            let scene = SceneData::from(striata_io::read_scene(path).map_err(read_error)?);
            let warnings = scene.scene.warnings().iter();
            let warnings = warnings.map(|w| format!("{}: {}: {}", w.file, w.place, w.reason)).collect();
            Ok((Content::Scene(scene), warnings))
        }
        _ => {
            drop(bytes);
            let report = striata_io::read_with_report(path).map_err(read_error)?;
            let warnings = report.warnings.iter();
            let warnings = warnings.map(|w| format!("{}: {}: {}", w.file, w.place, w.reason)).collect();
            Ok((Content::Mesh(MeshData::from(report.mesh)), warnings))
        }
    }
}

/// Decodes a stream or a `.striata` file from memory.
#[pyfunction]
pub(crate) fn decode(py: Python<'_>, bytes: Vec<u8>, allow_truncated: bool) -> Outcome<Bound<'_, PyAny>> {
    let size = bytes.len();
    job::run(py, size, None, move |_| decoded(&bytes, allow_truncated).map_err(decode_error))?.into_python(py)
}

fn decoded(bytes: &[u8], allow_truncated: bool) -> Result<Content, String> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    if bytes.starts_with(&striata::file::SCENE_STREAM_MAGIC) {
        return scene_stream(bytes, allow_truncated).map(|lods| Content::LodScene(LodSceneData { lods }));
    }
    if bytes.starts_with(&striata::file::STREAM_MAGIC) {
        let file = striata_stream::open_stream(bytes).map_err(|e| text(&e))?;
        if file.is_truncated() && !allow_truncated {
            return Err(TRUNCATED.to_owned());
        }
        let refinable = file.refinable_mesh().map_err(|e| text(&e))?;
        refinable.mesh.check().map_err(|e| text(&e))?;
        return Ok(Content::Lod(LodData::from(refinable)));
    }
    if is_scene_file(bytes) {
        let lods = SceneFile::parse(bytes).and_then(|file| file.lod_scene()).map_err(|e| text(&e))?;
        return Ok(Content::LodScene(LodSceneData { lods }));
    }
    let lod = striata_stream::open(bytes).and_then(|file| Lod::from_file(&file)).map_err(|e| text(&e))?;
    Ok(Content::Lod(LodData::from(lod)))
}

const TRUNCATED: &str = "the stream is truncated (decode what is there with allow_truncated=True)";

fn scene_stream(bytes: &[u8], allow_truncated: bool) -> Result<LodScene, String> {
    let mut decoder = SceneStreamDecoder::new();
    decoder.push(bytes).map_err(|error| error.to_string())?;
    if !decoder.is_complete() {
        if !allow_truncated {
            return Err(TRUNCATED.to_owned());
        }
        decoder.finish().map_err(|error| error.to_string())?;
    }
    let scene = decoder.scene().map_err(|error| error.to_string())?;
    LodScene::from_lods(scene.without_meshes(), decoder.lods()).map_err(|error| error.to_string())
}

/// Writes a mesh in the format of the extension.
#[pyfunction]
pub(crate) fn write_mesh(py: Python<'_>, path: PathBuf, mesh: &MeshData, ascii: bool) -> Outcome<()> {
    let mesh = Arc::clone(&mesh.mesh);
    job::run(py, UNKNOWN_SIZE, None, move |_| {
        striata_io::write(&path, &mesh, &WriteOptions::default().with_ascii(ascii)).map_err(write_error)
    })
}

/// Writes a scene in the format of the extension.
#[pyfunction]
pub(crate) fn write_scene(py: Python<'_>, path: PathBuf, scene: &SceneData) -> Outcome<()> {
    let scene = Arc::clone(&scene.scene);
    job::run(py, UNKNOWN_SIZE, None, move |_| {
        striata_io::write_scene(&path, &scene, &WriteOptions::default()).map_err(write_error)
    })
}

/// Writes bytes to a file that appears complete or not at all.
#[pyfunction]
pub(crate) fn write_bytes(py: Python<'_>, path: PathBuf, bytes: Vec<u8>) -> Outcome<()> {
    job::run(py, UNKNOWN_SIZE, None, move |_| {
        write_atomically(&path, |out| out.write_all(&bytes)).map_err(write_error)
    })
}

/// Name of the format of a file name; `None` if the extension names none.
#[pyfunction]
pub(crate) fn format_of(path: PathBuf) -> Option<&'static str> {
    Format::from_extension(path).map(Format::extension)
}

/// Self-contained HTML page of the viewer that shows a stream.
#[pyfunction]
pub(crate) fn viewer_page(name: &str, stream: &[u8]) -> Outcome<String> {
    striata_viewer::viewer_page::for_stream(name, stream)
        .map_err(|failure| crate::errors::internal_error(failure.message()))
}
