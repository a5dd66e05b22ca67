//! Tiles of paged files, and arrays of the levels of `.striata` files.

use std::path::{Path, PathBuf};

use pyo3::prelude::*;
use serde_json::Value;
use striata::ProgressFn;
use striata::file::StriataFile;
use striata_paged::PagedFile;
use striata_tiles::{
    NeuroglancerOptions, NeuroglancerWriter, Sharding, TileFormat, TilesError, TilesOptions, VertexBits,
    write_zarr,
};

use crate::errors::{Outcome, cancelled, decode_error, os_error, value_error, write_error};
use crate::job;
use crate::paged::paged_error;

/// Writing takes a time that is unknown before it is done.
const UNKNOWN_SIZE: usize = usize::MAX;

/// Options of tiles, as items of a Python object.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct TilesArguments {
    format: String,
    tile_triangles: u64,
    encoding: String,
    bits: u32,
    segment_id: u64,
    sharded: bool,
}

fn tiles_error(error: TilesError) -> PyErr {
    match error {
        TilesError::Paged(error) => paged_error(error),
        TilesError::Write(error) => write_error(error),
        TilesError::Io { path, source } => os_error(&source, path.display().to_string()),
        TilesError::Cancelled(reason) => cancelled(reason),
        other => value_error(other),
    }
}

/// Writes a folder of tiles from a paged file, or one of arrays from a `.striata` file; returns numbers and remarks as
/// JSON.
#[pyfunction]
pub(crate) fn write_tiles(
    py: Python<'_>,
    path: PathBuf,
    output: PathBuf,
    options: TilesArguments,
    progress: Option<&Bound<'_, PyAny>>,
) -> Outcome<String> {
    job::run(py, UNKNOWN_SIZE, progress, move |progress| {
        let report = match options.format.as_str() {
            "zarr" => zarr(&path, &output, progress),
            "neuroglancer" => neuroglancer(&path, &output, &options, progress),
            _ => tileset(&path, &output, &options, progress),
        };
        report.map(|report| report.to_string())
    })
}

fn tileset(
    path: &Path,
    output: &Path,
    arguments: &TilesArguments,
    progress: &mut ProgressFn<'_>,
) -> Outcome<Value> {
    let mut file = PagedFile::open(&path.to_string_lossy()).map_err(paged_error)?;
    let mut options = TilesOptions::default();
    options.tile_triangles = arguments.tile_triangles;
    options.format = match arguments.encoding.as_str() {
        "quantized" => TileFormat::Quantized,
        "meshopt" => TileFormat::Meshopt,
        "draco" => TileFormat::Draco,
        _ => TileFormat::Float,
    };
    let report = striata_tiles::write_tiles(&mut file, output, &options, progress).map_err(tiles_error)?;
    serde_json::to_value(report).map_err(value_error)
}

fn neuroglancer(
    path: &Path,
    output: &Path,
    arguments: &TilesArguments,
    progress: &mut ProgressFn<'_>,
) -> Outcome<Value> {
    let mut file = PagedFile::open(&path.to_string_lossy()).map_err(paged_error)?;
    let mut options = NeuroglancerOptions::default();
    options.fragment_triangles = arguments.tile_triangles;
    options.bits = if arguments.bits == 10 { VertexBits::Ten } else { VertexBits::Sixteen };
    options.sharding = arguments.sharded.then(|| Sharding::of_count(1));
    let mut writer = NeuroglancerWriter::new(output, options).map_err(tiles_error)?;
    writer.add(arguments.segment_id, &mut file, progress).map_err(tiles_error)?;
    serde_json::to_value(writer.finish().map_err(tiles_error)?).map_err(value_error)
}

fn zarr(path: &Path, output: &Path, progress: &mut ProgressFn<'_>) -> Outcome<Value> {
    let bytes = std::fs::read(path).map_err(|error| os_error(&error, path.display().to_string()))?;
    let file = StriataFile::parse(&bytes).map_err(decode_error)?;
    let refinable = file.refinable_mesh().map_err(decode_error)?;
    let is_guaranteed = file.has_guaranteed_errors().map_err(decode_error)?;
    let report = write_zarr(&refinable, is_guaranteed, output, progress).map_err(tiles_error)?;
    serde_json::to_value(report).map_err(value_error)
}
