//! The writer: encodes every mesh, then distributes all bytes over packets.

use striata::mesh::IndexedMesh;
use striata::simplify::{BatchOptions, SimplifyError, build_batches_with_progress};
use striata::{Progress, ProgressFn, ignore_progress};
use striata_io::Scene;
use striata_stream::{
    ChunkInfo, Precision, SHAPE_STEPS, StreamError, StreamInfo, StreamOptions, encode_stream,
};

use super::SceneStreamOptions;
use super::animation::round_animations;
use super::buffer::{pack, parts_of};
use super::error::SceneEncodeError;
use super::head::{MeshEntry, PART_COUNT, SceneHead};
use super::images::{PreparedImage, prepare};
use super::packet::{HEADER_BYTES, PacketKind, begin, end, put_packet};
use super::precision::{MeshPrecision, longest_side, mesh_precisions, scene_tolerance};
use super::schedule::{ANIMATION_ERROR, Item, MeshCosts, WholeCosts, schedule};

/// Largest packet of refinement that is made of several chunks, bytes: small packets can be used sooner, large
/// ones have less overhead.
const JOINED_BYTES: usize = 8192;

/// Largest piece of an image, bytes.
const IMAGE_PIECE_BYTES: usize = 1 << 16;

/// A scene as a stream.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct EncodedScene {
    /// Bytes of the stream.
    pub bytes: Vec<u8>,
    /// What the bytes are spent on.
    pub sizes: SceneStreamSizes,
}

/// Bytes of each part of a stream; together they are the whole stream.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct SceneStreamSizes {
    /// Document and table.
    pub document_bytes: usize,
    /// Base meshes, with the headers of their streams.
    pub base_bytes: usize,
    /// Refinement of the meshes.
    pub refinement_bytes: usize,
    /// Animations, skins, points and lines.
    pub buffer_bytes: usize,
    /// Previews of images.
    pub preview_bytes: usize,
    /// Images.
    pub image_bytes: usize,
    /// Header of the stream, and headers of the packets.
    pub packet_bytes: usize,
    /// Length of the prefix that shows every mesh.
    pub drawable_at: usize,
    /// Length of the prefix that shows every mesh, with previews of all images.
    pub textured_at: usize,
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
    let meshes = encode_meshes(scene, options, progress)?;
    let images = prepare(scene, options.preview_side);
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
        meshes: meshes.iter().map(|mesh| mesh.as_ref().map(MeshStream::entry)).collect(),
        images: images.iter().map(|image| image.entry.clone()).collect(),
    };
    let body = Body::new(scene, &meshes, &images, &parts);
    (head.base_bytes, head.preview_bytes) = (body.base_end as u64, body.preview_end as u64);
    let document = head.to_bytes();
    check_length("the document", document.len())?;
    let mut bytes = Vec::new();
    begin(&mut bytes);
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

fn check_length(what: &'static str, length: usize) -> Result<(), SceneEncodeError> {
    match u32::try_from(length) {
        Ok(_) => Ok(()),
        Err(_) => Err(SceneEncodeError::TooLong { what, length }),
    }
}

/// The stream of a mesh.
struct MeshStream {
    bytes: Vec<u8>,
    info: StreamInfo,
    /// Factor from mesh units to scene units, 0 if the mesh is not shown.
    scale: f64,
}

impl MeshStream {
    fn entry(&self) -> MeshEntry {
        MeshEntry {
            bytes: self.bytes.len() as u64,
            vertex_count: self.info.vertex_count as u32,
            triangle_count: self.info.triangle_count as u32,
            step_count: self.info.step_count as u32,
            group_count: self.info.group_count as u32,
            error: self.info.error_max,
            scale: self.scale,
        }
    }

    /// Chunks after the one that contains the base.
    fn refinement(&self) -> &[ChunkInfo] {
        self.info.chunks.get(1..).unwrap_or(&[])
    }

    fn costs(&self) -> MeshCosts {
        MeshCosts {
            bytes: self.refinement().iter().map(|chunk| chunk.bytes).collect(),
            errors: self.refinement().iter().map(|chunk| f64::from(chunk.error) * self.scale).collect(),
        }
    }
}

/// Simplifies and encodes all meshes.
fn encode_meshes(
    scene: &Scene,
    options: &SceneStreamOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<Vec<Option<MeshStream>>, SceneEncodeError> {
    let total: usize = scene.meshes().iter().flatten().map(IndexedMesh::triangle_count).sum();
    let (mut done, mut streams) = (0u64, Vec::new());
    let precisions = mesh_precisions(scene, &options.stream);
    for (index, (mesh, precision)) in scene.meshes().iter().zip(precisions).enumerate() {
        let Some((mesh, MeshPrecision { options: own, scale })) = mesh.as_ref().zip(precision) else {
            streams.push(None);
            continue;
        };
        let mut within = |part: Progress| {
            let own = mesh.triangle_count() as u64;
            let share = part.done.min(part.total).saturating_mul(own) / part.total.max(1);
            progress(Progress { phase: part.phase, done: done + share, total: total as u64 })
        };
        let (bytes, info) =
            encode_mesh(mesh, (&own, &options.batches), &mut within).map_err(|error| error.in_mesh(index))?;
        streams.push(Some(MeshStream { bytes, info, scale }));
        done += mesh.triangle_count() as u64;
        if progress(Progress { phase: "encode", done, total: total as u64 }).is_break() {
            return Err(SceneEncodeError::Cancelled);
        }
    }
    Ok(streams)
}

/// What failed while a mesh was encoded.
enum MeshFault {
    Simplify(SimplifyError),
    Stream(StreamError),
}

impl MeshFault {
    fn in_mesh(self, mesh: usize) -> SceneEncodeError {
        match self {
            Self::Simplify(source) => SceneEncodeError::Simplify { mesh, source },
            Self::Stream(source) => SceneEncodeError::Stream { mesh, source },
        }
    }
}

fn encode_mesh(
    mesh: &IndexedMesh,
    (options, batches): (&StreamOptions, &BatchOptions),
    progress: &mut ProgressFn<'_>,
) -> Result<(Vec<u8>, StreamInfo), MeshFault> {
    let mut batches = batches.clone();
    if batches.shape_step.is_none() && options.precision != Precision::Lossless {
        let step = options.grid_step(mesh).map_err(|error| MeshFault::Stream(error.into()))?;
        batches.shape_step = Some(SHAPE_STEPS * step);
    }
    let built = build_batches_with_progress(mesh, &batches, progress).map_err(MeshFault::Simplify)?;
    let stream = encode_stream(&built.built.refinable, &built.batches, options).map_err(MeshFault::Stream)?;
    // A stream that was just written has a valid header.
    let info = StreamInfo::read(&stream.bytes).ok().flatten().unwrap_or_default();
    Ok((stream.bytes, info))
}

/// Packets in the order of the stream, with a count of what they contain.
#[derive(Default)]
struct Packets {
    bytes: Vec<u8>,
    head_bytes: usize,
    sizes: SceneStreamSizes,
}

impl Packets {
    fn put(&mut self, kind: PacketKind, index: usize, payload: &[u8]) {
        let start = self.bytes.len();
        put_packet(kind, index, payload, &mut self.bytes);
        self.head_bytes += self.bytes.len() - start - payload.len();
        let sum = match kind {
            PacketKind::Document => &mut self.sizes.document_bytes,
            PacketKind::Mesh => &mut self.sizes.refinement_bytes,
            PacketKind::Buffer => &mut self.sizes.buffer_bytes,
            PacketKind::Preview => &mut self.sizes.preview_bytes,
            PacketKind::Image => &mut self.sizes.image_bytes,
        };
        *sum += payload.len();
    }

    fn put_image(&mut self, image: usize, bytes: &[u8]) {
        bytes.chunks(IMAGE_PIECE_BYTES).for_each(|piece| self.put(PacketKind::Image, image, piece));
    }
}

/// All packets after the document.
struct Body {
    packets: Packets,
    /// Length of the packets until every mesh can be drawn.
    base_end: usize,
    /// Length of the packets until all previews are there.
    preview_end: usize,
}

impl Body {
    fn new(
        scene: &Scene,
        meshes: &[Option<MeshStream>],
        images: &[PreparedImage],
        parts: &[Vec<u8>; PART_COUNT],
    ) -> Self {
        let mut packets = Packets::default();
        let put_part =
            |packets: &mut Packets, part: usize| packets.put(PacketKind::Buffer, part, &parts[part]);
        put_part(&mut packets, 0);
        for (index, mesh) in meshes.iter().enumerate() {
            let Some(mesh) = mesh else { continue };
            packets.put(PacketKind::Mesh, index, &mesh.bytes[..mesh.info.base_bytes as usize]);
        }
        packets.sizes.base_bytes = std::mem::take(&mut packets.sizes.refinement_bytes);
        let base_end = packets.bytes.len();
        put_previews(&mut packets, scene, images);
        let preview_end = packets.bytes.len();
        put_refinement(&mut packets, (scene, meshes), images, &parts[1]);
        Self { packets, base_end, preview_end }
    }
}

/// Puts previews, and images that are hardly larger than a preview: the ones that cover most per byte first.
fn put_previews(packets: &mut Packets, scene: &Scene, images: &[PreparedImage]) {
    let mut early: Vec<usize> = (0..images.len()).collect();
    early.retain(|&image| images[image].is_early || !images[image].preview.is_empty());
    early.sort_by(|&a, &b| images[b].early_value().total_cmp(&images[a].early_value()));
    for image in early {
        if images[image].is_early {
            packets.put_image(image, &scene.images()[image].bytes);
        } else {
            packets.put(PacketKind::Preview, image, &images[image].preview);
        }
    }
}

/// Puts the rest of all meshes, the images and the animations, in the order of the schedule.
fn put_refinement(
    packets: &mut Packets,
    (scene, meshes): (&Scene, &[Option<MeshStream>]),
    images: &[PreparedImage],
    animations: &[u8],
) {
    let costs: Vec<MeshCosts> =
        meshes.iter().map(|mesh| mesh.as_ref().map(MeshStream::costs).unwrap_or_default()).collect();
    let late = images.iter().enumerate().filter(|(_, image)| !image.is_early && image.entry.bytes > 0);
    let diagonal = scene.diagonal();
    let mut others: Vec<_> = late.map(|(index, image)| image.costs(index, diagonal)).collect();
    others.push(WholeCosts {
        item: Item::Animations,
        bytes: animations.len() as u64,
        error: ANIMATION_ERROR * diagonal,
    });
    let mut sent: Vec<usize> =
        meshes.iter().map(|mesh| mesh.as_ref().map_or(0, |mesh| mesh.info.base_bytes as usize)).collect();
    for item in schedule(&costs, &others) {
        match item {
            Item::Animations => packets.put(PacketKind::Buffer, 1, animations),
            Item::Image(image) => packets.put_image(image, &scene.images()[image].bytes),
            Item::Chunks { mesh, chunks } => {
                let Some(stream) = &meshes[mesh] else { continue };
                let lengths = stream.refinement()[chunks].iter().map(|chunk| chunk.bytes as usize);
                for length in joined(lengths) {
                    let end = sent[mesh] + length;
                    packets.put(PacketKind::Mesh, mesh, &stream.bytes[sent[mesh]..end]);
                    sent[mesh] = end;
                }
            }
        }
    }
}

/// Joins neighboring lengths as long as their sum stays small.
fn joined(lengths: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut joined: Vec<usize> = Vec::new();
    for length in lengths {
        match joined.last_mut() {
            Some(last) if *last + length <= JOINED_BYTES => *last += length,
            _ => joined.push(length),
        }
    }
    joined
}
