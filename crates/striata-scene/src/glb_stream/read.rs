//! Reading: the streams of all meshes instead of the coarse level.

use serde_json::Value;
use striata::file::DecodeError;
use striata::simplify::{SequenceOptions, SimplifyError};
use striata::{Cancelled, Lod, LodOptions, ProgressFn, ignore_progress};
use striata_io::{MeshData, Scene, Source, mesh_data, read_scene_bytes};
use striata_stream::StreamDecoder;

use super::{GlbStreamReadError, STREAM_EXTENSION, STREAM_EXTENSION_VERSION};
use crate::error::BuildError;
use crate::lod_scene::{LodScene, check_groups};
use crate::stream::normalize_weights;

/// Reads a glTF or GLB file whose meshes have streams, and decodes them; [`None`] if no mesh has one.
///
/// The result is the full scene, without the extension. A mesh without a stream has a single level.
///
/// # Errors
/// [`GlbStreamReadError`] if the file is damaged, has an unknown version of the extension, or contains a
/// damaged stream. The coarse level, which [`read_scene_bytes`] returns, may be readable nevertheless.
pub fn read_glb_with_stream(
    bytes: &[u8],
    source: &Source<'_>,
) -> Result<Option<LodScene>, GlbStreamReadError> {
    read_glb_with_stream_and_progress(bytes, source, &mut ignore_progress)
}

/// Runs [`read_glb_with_stream`] and reports progress, in bytes or steps of each mesh; the callback can cancel.
///
/// # Errors
/// See [`read_glb_with_stream`]; also [`GlbStreamReadError::Cancelled`] if the callback cancels.
pub fn read_glb_with_stream_and_progress(
    bytes: &[u8],
    source: &Source<'_>,
    progress: &mut ProgressFn<'_>,
) -> Result<Option<LodScene>, GlbStreamReadError> {
    let streams = mesh_data(bytes, source, STREAM_EXTENSION)?;
    if streams.iter().all(Option::is_none) {
        return Ok(None);
    }
    let coarse = read_scene_bytes(bytes, source)?;
    let mut lods = Vec::with_capacity(streams.len());
    for (mesh, (stream, triangles)) in streams.iter().zip(coarse.meshes()).enumerate() {
        // A mesh that shows nothing has kept the accessors of its primitives, and is left as it is.
        let Some(triangles) = triangles else {
            lods.push(None);
            continue;
        };
        lods.push(Some(match stream {
            Some(stream) => decoded(&coarse, mesh, stream, progress)?,
            None => {
                let options = SequenceOptions::default().with_base_triangle_count(usize::MAX);
                let options = LodOptions::default().with_sequence(options);
                let lod = Lod::build_with_progress(triangles, &options, progress);
                lod.map_err(|error| match error {
                    SimplifyError::Cancelled(reason) => GlbStreamReadError::from(reason),
                    error => BuildError::new(mesh, coarse.mesh_name(mesh).to_owned(), error).into(),
                })?
            }
        }));
    }
    Ok(Some(LodScene::from_lods(coarse.without_meshes(), lods)?))
}

fn decoded(
    scene: &Scene,
    mesh: usize,
    data: &MeshData,
    progress: &mut ProgressFn<'_>,
) -> Result<Lod, GlbStreamReadError> {
    let version = data.extension.get("version").unwrap_or(&Value::Null);
    if version.as_u64() != Some(STREAM_EXTENSION_VERSION) {
        return Err(GlbStreamReadError::Version { mesh, found: version.to_string() });
    }
    let in_stream = |error: DecodeError| GlbStreamReadError::Stream { mesh, error };
    let file = striata_stream::open_stream(&data.bytes).map_err(in_stream)?;
    if file.is_truncated() {
        return Err(GlbStreamReadError::Truncated { mesh });
    }
    if !file.has_collapses() {
        return Err(in_stream(DecodeError::NoCollapses));
    }
    check_groups(scene, mesh, file.summary().group_count)?;
    let mut decoder = StreamDecoder::new();
    if decoder.push_with_progress(&data.bytes, progress).map_err(|e| in_stream(e.into()))? < data.bytes.len()
    {
        return Err(Cancelled.into());
    }
    let mut refinable = decoder.refinable_mesh().ok_or(GlbStreamReadError::Truncated { mesh })?;
    refinable.mesh.check().map_err(|error| in_stream(error.into()))?;
    normalize_weights(&mut refinable.mesh);
    let lod = Lod::from_refinable(refinable);
    lod.prepare_with_progress(progress)?;
    Ok(lod)
}
