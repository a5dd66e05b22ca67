//! Reading and writing of files.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use pyo3::prelude::*;
use striata::ProgressFn;
use striata_io::pieces::is_raster;
use striata_io::{Format, Source, WriteOptions, convert_colors, needs_other_colors, write_atomically};
use striata_scene::glb_stream::{GlbStreamReadError, read_glb_with_stream_and_progress};

use crate::content::LoadedContent;
use crate::decode::decoded;
use crate::errors::{Outcome, cancelled, decode_error, os_error, read_error, warning_texts, write_error};
use crate::job;
use crate::mesh::PyMeshData;
use crate::paged::{PagedLodData, is_paged};
use crate::scene::{LodSceneData, PySceneData};

/// Work that always deserves a thread, since its size is unknown before it is done.
const UNKNOWN_SIZE: usize = usize::MAX;

/// Opens a file of any kind; returns its content and warnings.
#[pyfunction]
pub(crate) fn open_file(py: Python<'_>, path: PathBuf) -> Outcome<(Bound<'_, PyAny>, Vec<String>)> {
    let (content, warnings) = job::run(py, UNKNOWN_SIZE, None, move |progress| opened(&path, progress))?;
    Ok((content.into_python(py)?, warnings))
}

fn opened(path: &Path, progress: &mut ProgressFn<'_>) -> Outcome<(LoadedContent, Vec<String>)> {
    let name = path.display().to_string();
    if is_paged(path) {
        return Ok((LoadedContent::PagedLod(PagedLodData::open(path)?), Vec::new()));
    }
    if is_raster(path) {
        let report = striata_io::read_with_report(path).map_err(read_error)?;
        return Ok((LoadedContent::Mesh(PyMeshData::from(report.mesh)), warning_texts(&report.warnings)));
    }
    let bytes = fs::read(path).map_err(|error| os_error(&error, name.clone()))?;
    let (bytes, inner_name) = striata_io::decompressed(bytes.into(), &name).map_err(read_error)?;
    let source = Source::of_path(&name, path);
    match Format::detect(&bytes, &inner_name) {
        Some(Format::Striata | Format::Stream) => {
            let content = decoded(&bytes, false, progress).map_err(|fault| fault.into_error(Some(&name)))?;
            Ok((content, Vec::new()))
        }
        Some(Format::Gltf | Format::Glb) => {
            let lods = read_glb_with_stream_and_progress(&bytes, &source, progress);
            let lods = lods.map_err(|error| match error {
                GlbStreamReadError::Cancelled(reason) => cancelled(reason),
                error => decode_error(error),
            })?;
            if let Some(lods) = lods {
                return Ok((LoadedContent::LodScene(LodSceneData { lods }), Vec::new()));
            }
            opened_scene(&bytes, &source)
        }
        Some(format) if format.has_scenes() => opened_scene(&bytes, &source),
        _ => {
            let report = striata_io::read_bytes_with_report(&bytes, &source).map_err(read_error)?;
            let warnings = warning_texts(&report.warnings);
            Ok((LoadedContent::Mesh(PyMeshData::from(report.mesh)), warnings))
        }
    }
}

fn opened_scene(bytes: &[u8], source: &Source<'_>) -> Outcome<(LoadedContent, Vec<String>)> {
    let scene = striata_io::read_scene_bytes(bytes, source).map_err(read_error)?;
    let warnings = warning_texts(scene.warnings());
    Ok((LoadedContent::Scene(PySceneData::from(scene)), warnings))
}

/// How files are written.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct WriteArguments {
    ascii: bool,
    embed: bool,
    shading: bool,
    is_level: bool,
}

impl WriteArguments {
    fn options(&self) -> WriteOptions {
        let Self { ascii, embed, shading, is_level } = *self;
        let options = WriteOptions::default().with_ascii(ascii).with_embed(embed).with_shading(shading);
        options.with_cache_order(is_level)
    }
}

/// Writes a mesh in the format of the extension, with its triangles in cache order if it is a level, and returns what
/// the format cannot store.
#[pyfunction]
pub(crate) fn write_mesh(
    py: Python<'_>,
    path: PathBuf,
    mesh: &PyMeshData,
    options: WriteArguments,
) -> Outcome<Vec<String>> {
    let mut mesh = Arc::clone(&mesh.mesh);
    let options = options.options();
    job::run(py, UNKNOWN_SIZE, None, move |_| {
        if let Some(format) = Format::from_extension(&path)
            && needs_other_colors(&mesh, format)
        {
            convert_colors(Arc::make_mut(&mut mesh), format);
        }
        let warnings = striata_io::write_with_report(&path, &mesh, &options).map_err(write_error)?;
        Ok(warnings.iter().map(ToString::to_string).collect())
    })
}

/// Writes a scene in the format of the extension, with its triangles in cache order if it is a level, and returns what
/// the format cannot store.
#[pyfunction]
pub(crate) fn write_scene(
    py: Python<'_>,
    path: PathBuf,
    scene: &PySceneData,
    options: WriteArguments,
) -> Outcome<Vec<String>> {
    let scene = Arc::clone(&scene.scene);
    let options = options.options();
    job::run(py, UNKNOWN_SIZE, None, move |_| {
        let warnings = striata_io::write_scene_with_report(&path, &scene, &options).map_err(write_error)?;
        Ok(warnings.iter().map(ToString::to_string).collect())
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
