//! Encodes the batches of a sequence as compressed chunks.
//!
//! A chunk has one error, that of the level before it. The first chunks are small, so that a picture appears early.

use striata::mesh::RefinableMesh;
use striata::{Progress, ProgressFn};

use crate::base::coder::BaseLimits;
use crate::base::mesh::Base;
use crate::entropy::{PART_COUNT, RangeWriter};
use crate::format::header::{min_chunk_bytes, min_total_bytes};
use crate::refine::growth::GrowingMesh;
use crate::refine::parameters::StreamParameters;
use crate::refine::refiner::MeshRefiner;
use crate::writer::defect::BatchDefect;
use crate::writer::defect::StreamError;
use crate::writer::descent::Descent;
use crate::writer::reference_mesh::{ReferenceMesh, VertexData, base_of};

/// Maximum number of splits per chunk, the unit of checksums and of requests.
const CHUNK_SPLITS: usize = 4096;
/// Number of splits in the first chunk, so that a first picture appears quickly.
const FIRST_SPLITS: usize = 256;

/// A part of the stream with its own checksum.
#[derive(Clone, Debug)]
pub(crate) struct Chunk {
    /// Range-coded data.
    pub bytes: Vec<u8>,
    /// Number of splits up to the end of this chunk.
    pub split_count: u32,
}

/// All chunks of a mesh.
#[derive(Clone, Debug)]
pub(crate) struct Chunks {
    /// The first chunk contains the base, the others splits.
    pub chunks: Vec<Chunk>,
    /// Maximum number of triangles that move to a new vertex.
    pub max_patch: u32,
    /// Whether the stream has general batches.
    pub has_general: bool,
    /// Steps of the sequence, in stream order.
    pub order: Vec<u32>,
    /// Positions of the base, in stream order.
    pub base_positions: Vec<u32>,
    /// Vertices of the mesh, in stream order; empty if each position has one vertex.
    pub source_vertex: Vec<u32>,
    /// Bits spent on each part, in the order of [`Part`](crate::entropy::Part).
    pub spent: [f64; PART_COUNT],
}

/// Encodes a sequence after its descent to the base.
pub(crate) fn encode_chunks(
    refinable: &RefinableMesh,
    (descent, batches): (&Descent, &[u32]),
    (points, parameters): (&VertexData, &StreamParameters),
    progress: &mut ProgressFn<'_>,
) -> Result<Chunks, StreamError> {
    let (base, reference) = base_of(descent, batches, points, refinable);
    let parameters = StreamParameters {
        max_patch: descent.max_patch(),
        has_general: descent.has_general(),
        ..parameters.clone()
    };
    write(base, reference, &parameters, refinable.sequence.step_count(), progress)
}

/// Checks that batch boundaries rise from 0 to the number of steps.
///
/// # Errors
/// [`BatchDefect::Cover`] if they do not.
pub(crate) fn check_batches(batches: &[u32], step_count: usize) -> Result<(), BatchDefect> {
    let rises = batches.windows(2).all(|w| w[0] < w[1]);
    if rises && batches.first() == Some(&0) && batches.last().map(|&n| n as usize) == Some(step_count) {
        return Ok(());
    }
    Err(BatchDefect::Cover { step_count })
}

/// Encodes the base and then all chunks.
fn write(
    base: Base,
    mut reference: ReferenceMesh<'_>,
    parameters: &StreamParameters,
    step_count: usize,
    progress: &mut ProgressFn<'_>,
) -> Result<Chunks, StreamError> {
    let limits = BaseLimits {
        triangle_count: base.triangles.len() as u32,
        position_count: base.grid_points.len() as u32,
        extra_wedges: u32::MAX,
    };
    let parameters = StreamParameters { base: limits, ..parameters.clone() };
    let mut spent = [0.0; PART_COUNT];
    let mut chunks = Vec::new();
    let mut writer = RangeWriter::new();
    // Collapses keep a surface closed, so its base is always valid.
    let mut refiner = MeshRefiner::begin(&mut writer, &base, &parameters, &mut reference)
        .unwrap_or_else(|defect| panic!("collapses keep a surface closed: {defect}"));
    push(&mut chunks, writer, &refiner.level.growth, base.triangles.len(), &mut spent);
    while reference.order.len() < step_count {
        // The descent was the first half of the work.
        let (done, total) = ((step_count + reference.order.len()) as u64, 2 * step_count as u64);
        Progress { phase: "encode", done, total }.report(progress)?;
        let mut writer = RangeWriter::new();
        code_chunk(&mut refiner, &mut writer, &mut reference, step_count)?;
        push(&mut chunks, writer, &refiner.level.growth, 0, &mut spent);
    }
    let ReferenceMesh { order, source_vertex, base_positions, .. } = reference;
    let StreamParameters { max_patch, has_general, .. } = parameters;
    Ok(Chunks { chunks, max_patch, has_general, order, base_positions, source_vertex, spent })
}

/// Finishes a chunk and pads it to the number of bytes that a reader requires for its contents.
fn push(
    chunks: &mut Vec<Chunk>,
    writer: RangeWriter,
    growth: &GrowingMesh,
    base_triangles: usize,
    spent: &mut [f64; PART_COUNT],
) {
    let (mut bytes, bits) = writer.finish();
    let split_count = growth.added.len();
    let splits = split_count - chunks.last().map_or(0, |chunk| chunk.split_count as usize);
    // A reader treats missing bytes as zeros, so appending zeros changes nothing.
    let coded_bytes: usize = chunks.iter().map(|chunk| chunk.bytes.len()).sum();
    let least = min_total_bytes(growth.excess_count()).saturating_sub(coded_bytes);
    bytes.resize(bytes.len().max(least).max(min_chunk_bytes(splits, base_triangles)), 0);
    spent.iter_mut().zip(bits).for_each(|(sum, bits)| *sum += bits);
    chunks.push(Chunk { bytes, split_count: split_count as u32 });
}

/// Number of steps at the end of the chunk after `done` steps, of which the first chunk has `first`. Early chunks are
/// small, so that the picture improves often.
pub(crate) fn chunk_end(done: usize, step_count: usize, first: usize) -> usize {
    (done + (done / 2).clamp(first, CHUNK_SPLITS)).min(step_count)
}

/// Encodes the splits of one chunk.
fn code_chunk(
    refiner: &mut MeshRefiner,
    writer: &mut RangeWriter,
    reference: &mut ReferenceMesh<'_>,
    step_count: usize,
) -> Result<(), BatchDefect> {
    let done = reference.order.len();
    let end = chunk_end(done, step_count, FIRST_SPLITS);
    while reference.order.len() < end {
        let result = refiner.stretch(writer, reference, end - reference.order.len());
        let is_dependent = !refiner.is_in_batch() && !reference.is_batch_done();
        if result.is_err() || is_dependent {
            return Err(BatchDefect::Dependent { batch: refiner.batch() as usize - 1 });
        }
    }
    Ok(())
}
