//! The writer: encodes every mesh, then distributes all bytes over packets.

use std::collections::HashMap;

use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::simplify::{BatchOptions, BuiltBatches, SimplifyError};
use striata::{Cancelled, Progress, ProgressFn, ignore_progress};
use striata_io::Scene;
use striata_stream::{
    Precision, SHAPE_STEPS, StreamError, StreamInfo, StreamOptions, encode_stream_with_progress,
};

use super::SceneStreamOptions;
use super::animation::round_animations;
use super::buffer::{pack, parts_of};
use super::error::SceneEncodeError;
use super::head::{MeshEntry, SceneHead};
use super::images::prepare;
use super::layout::{Body, SceneStreamSizes};
use super::mesh_stream::MeshStream;
use super::packet::{HEADER_BYTES, PacketKind, begin, end, put_packet};
use super::precision::{MeshPrecision, longest_side, mesh_precisions, scene_tolerance};
use crate::copies::Copies;
use crate::levels::{MeshWeight, step_errors};
use crate::mesh_jobs::{MeshFailure, for_each_distinct};
use crate::mesh_simplifier::{MeshSimplifier, stage};

/// A scene as a stream.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct EncodedScene {
    /// Bytes of the stream.
    pub bytes: Vec<u8>,
    /// Bytes of each part of the stream.
    pub sizes: SceneStreamSizes,
}

/// Encodes a scene as a progressive stream.
///
/// # Errors
/// [`SceneEncodeError`] with the mesh that cannot be simplified or encoded.
pub fn encode_scene(scene: &Scene, options: &SceneStreamOptions) -> Result<EncodedScene, SceneEncodeError> {
    encode_scene_with_progress(scene, options, &mut ignore_progress)
}

/// Runs [`encode_scene`] and reports progress in triangles; the callback can cancel.
///
/// # Errors
/// See [`encode_scene`]; also if the callback cancels.
pub fn encode_scene_with_progress(
    scene: &Scene,
    options: &SceneStreamOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<EncodedScene, SceneEncodeError> {
    let mut meshes = encode_meshes(scene, options, progress)?;
    let (entries, sources) = share(&mut meshes);
    let total: u64 = scene.meshes().iter().flatten().map(|mesh| mesh.triangle_count() as u64).sum();
    // Images are not measured in triangles, so their progress is that all meshes are done.
    let mut previews = |_| progress(Progress { phase: "previews", done: total, total });
    let images = prepare(scene, options.preview_side, &mut previews)
        .map_err(|Cancelled| SceneEncodeError::Cancelled)?;
    let tolerance = scene_tolerance(scene, options.stream.precision).zip(longest_side(scene));
    let (document, buffer) = match tolerance {
        Some((tolerance, side)) => round_animations(scene, tolerance, side),
        None => (scene.document().clone(), scene.buffer().to_vec()),
    };
    let ranges = parts_of(&document, buffer.len());
    let parts = ranges.each_ref().map(|part| pack(&document, &buffer, part));
    let mut head = SceneHead {
        document,
        metadata: options.stream.metadata.clone(),
        base_bytes: 0,
        preview_bytes: 0,
        buffer: ranges,
        meshes: entries,
        sources,
        images: images.iter().map(|image| image.entry.clone()).collect(),
    };
    let body = Body::new(scene, &meshes, &images, &parts);
    (head.base_bytes, head.preview_bytes) = (body.base_end as u64, body.preview_end as u64);
    let document = head.to_bytes();
    check_length("the document", document.len())?;
    let mut bytes = Vec::new();
    begin(head.version(), &mut bytes);
    put_packet(PacketKind::Document, 0, &document, &mut bytes);
    let start = bytes.len();
    bytes.extend_from_slice(&body.packets.bytes);
    end(&mut bytes);
    let packet_bytes = body.packets.head_bytes + start - document.len();
    debug_assert!(packet_bytes >= HEADER_BYTES, "the header of the stream counts");
    let sizes = SceneStreamSizes {
        document_bytes: document.len(),
        packet_bytes,
        drawable_at: start + body.base_end,
        textured_at: start + body.preview_end,
        ..body.packets.sizes
    };
    Ok(EncodedScene { bytes, sizes })
}

/// Removes streams that are equal to those of earlier meshes; returns the entries of all meshes, and the mesh whose
/// stream each has.
fn share(meshes: &mut [Option<MeshStream>]) -> (Vec<Option<MeshEntry>>, Vec<usize>) {
    let mut entries: Vec<_> = meshes.iter().map(|mesh| mesh.as_ref().map(MeshStream::entry)).collect();
    let mut first_of: HashMap<&[u8], usize> = HashMap::new();
    let (mut copies, mut sources) = (Copies::default(), Vec::with_capacity(meshes.len()));
    for (mesh, stream) in meshes.iter().enumerate() {
        let Some(MeshStream { bytes, info, .. }) = stream else {
            sources.push(mesh);
            continue;
        };
        let first = *first_of.entry(bytes).or_insert(mesh);
        let is_own = first == mesh || !copies.add(info.vertex_count, info.triangle_count);
        sources.push(if is_own { mesh } else { first });
    }
    for (mesh, &source) in sources.iter().enumerate().filter(|&(mesh, &source)| mesh != source) {
        if let (Some(entry), Some(stream)) = (&mut entries[mesh], meshes[mesh].take()) {
            entry.bytes = 0;
            // Its refinement improves all meshes that have it.
            if let Some(first) = &mut meshes[source] {
                first.scale = first.scale.max(stream.scale);
                first.weight += stream.weight;
            }
        }
    }
    (entries, sources)
}

fn check_length(what: &'static str, length: usize) -> Result<(), SceneEncodeError> {
    match u32::try_from(length) {
        Ok(_) => Ok(()),
        Err(_) => Err(SceneEncodeError::TooLong { what, length }),
    }
}

/// Simplifies and encodes all meshes.
fn encode_meshes(
    scene: &Scene,
    options: &SceneStreamOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<Option<MeshStream>>, SceneEncodeError> {
    let simplifier = MeshSimplifier::new(scene);
    let precisions = mesh_precisions(scene, &options.stream);
    let (weights, diagonal) = (MeshWeight::of_scene(scene), scene.diagonal());
    let own_options = |index: usize| precisions[index].as_ref().map(|precision| &precision.options);
    let is_alike = |[first, index]: [usize; 2]| {
        own_options(first) == own_options(index)
            && simplifier.is_simplified_alike([first, index], &options.batches.sequence)
    };
    let encode = |index: usize, mesh: &IndexedMesh, progress: &mut ProgressFn<'_>| {
        let Some(MeshPrecision { options: own, scale }) = &precisions[index] else { return Ok(None) };
        let diagonal = if *scale > 0.0 { diagonal / scale } else { 0.0 };
        let settings = StreamSettings { options: own, batches: &options.batches };
        encode_mesh(&simplifier, NumberedMesh { index, mesh, diagonal }, settings, progress).map(Some)
    };
    let encoded = for_each_distinct(scene.meshes(), is_alike, encode, progress);
    let streams = encoded.map_err(|MeshFailure { mesh, error }| MeshFault::in_mesh(error, mesh))?;
    let weighted = |(index, stream): (usize, Option<Option<MeshStream>>)| {
        let (stream, weight) = (stream.flatten()?, weights[index]);
        let scale = precisions[index].as_ref().map_or(0.0, |precision| precision.scale);
        let weight = weight.instance_count as f64 * weight.importance.powi(2) * scale.powi(4);
        Some(MeshStream { scale, weight, ..stream })
    };
    Ok(streams.into_iter().enumerate().map(weighted).collect())
}

/// Error of encoding a mesh: from simplifying it, or from its stream.
enum MeshFault {
    Simplify(SimplifyError),
    Stream(StreamError),
}

impl From<Cancelled> for MeshFault {
    fn from(cancelled: Cancelled) -> Self {
        Self::Simplify(cancelled.into())
    }
}

impl MeshFault {
    fn in_mesh(self, mesh: usize) -> SceneEncodeError {
        match self {
            Self::Simplify(SimplifyError::Cancelled(_)) | Self::Stream(StreamError::Cancelled(_)) => {
                SceneEncodeError::Cancelled
            }
            Self::Simplify(source) => SceneEncodeError::Simplify { mesh, source },
            Self::Stream(source) => SceneEncodeError::Stream { mesh, source },
        }
    }
}

/// A mesh of a scene, and its number there.
struct NumberedMesh<'a> {
    /// Number of the mesh.
    pub index: usize,
    /// The mesh.
    pub mesh: &'a IndexedMesh,
    /// Diagonal of the scene, mesh units.
    pub diagonal: f64,
}

/// How the steps of a mesh are found and coded.
struct StreamSettings<'a> {
    /// How they are coded.
    pub options: &'a StreamOptions,
    /// How they are found.
    pub batches: &'a BatchOptions,
}

fn encode_mesh(
    simplifier: &MeshSimplifier<'_>,
    NumberedMesh { index, mesh, diagonal }: NumberedMesh<'_>,
    StreamSettings { options, batches }: StreamSettings<'_>,
    progress: &mut ProgressFn<'_>,
) -> Result<MeshStream, MeshFault> {
    let mut batches = batches.clone();
    if batches.shape_step.is_none() && options.precision != Precision::Lossless {
        let step = options.grid_step(mesh).map_err(|error| MeshFault::Stream(error.into()))?;
        batches.shape_step = Some(SHAPE_STEPS * step);
    }
    let built = simplifier.batches(index, mesh, &batches, &mut stage(progress, 0, 2));
    let BuiltBatches { mut built, batches, .. } = built.map_err(MeshFault::Simplify)?;
    // Packets follow the chunks of a stream, and scenes have no data of triangles.
    built.refinable.mesh.triangle_layers.clear();
    let encoding = &mut stage(progress, 1, 2);
    let stream = encode_stream_with_progress(&built.refinable, &batches, options, encoding);
    let stream = stream.map_err(MeshFault::Stream)?;
    // A stream that was just written has a valid header.
    let info = StreamInfo::read(&stream.bytes).ok().flatten().unwrap_or_default();
    let RefinableMesh { mesh, sequence } = &built.refinable;
    let steps = step_errors(mesh, sequence, diagonal);
    let ends = info.chunks.iter().map(|chunk| chunk.split_count.min(steps.len()));
    let gain =
        |(before, after): (usize, usize)| steps[steps.len() - after..steps.len() - before].iter().sum();
    let gains = ends.clone().zip(ends.skip(1)).map(gain).collect();
    Ok(MeshStream { bytes: stream.bytes, info, scale: 0.0, gains, weight: 0.0 })
}
