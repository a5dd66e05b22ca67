//! From a sequence in batch order to compressed chunks.

use striata::mesh::RefinableMesh;

use crate::base::coder::BaseLimits;
use crate::base::mesh::Base;
use crate::entropy::{PART_COUNT, RangeWriter};
use crate::format::head::{least_bytes, least_bytes_in_all};
use crate::refine::growth::Growth;
use crate::refine::parameters::StreamParameters;
use crate::refine::refiner::Refiner;
use crate::writer::defect::BatchDefect;
use crate::writer::descent::Descent;
use crate::writer::truth::{Points, Truth, base_of};

/// Splits of a chunk: what is checked, and can be asked for, at once.
const CHUNK_SPLITS: usize = 4096;
/// Splits of the first chunk: the first picture should not have to wait.
const FIRST_SPLITS: usize = 256;

/// A stretch of the stream with a checksum of its own.
#[derive(Clone, Debug)]
pub(crate) struct Chunk {
    /// Range-coded.
    pub(crate) bytes: Vec<u8>,
    /// Splits of this and all chunks before it.
    pub(crate) split_count: u32,
}

/// A mesh as chunks.
#[derive(Clone, Debug)]
pub(crate) struct Chunks {
    /// The base, then splits.
    pub(crate) chunks: Vec<Chunk>,
    /// Most triangles that a new vertex takes over.
    pub(crate) max_patch: u32,
    /// Whether there are general batches.
    pub(crate) has_general: bool,
    /// Steps of the sequence in the order of the stream.
    pub(crate) order: Vec<u32>,
    /// Positions of the base in the order of the stream.
    pub(crate) base_positions: Vec<u32>,
    /// Vertices of the mesh in the order of the stream; empty where each position is one.
    pub(crate) source_vertex: Vec<u32>,
    /// Bits by part, in the order of [`Part`](crate::entropy::Part).
    pub(crate) spent: [f64; PART_COUNT],
}

/// Codes a sequence whose way down is known.
pub(crate) fn encode_chunks(
    refinable: &RefinableMesh,
    (descent, batches): (&Descent, &[u32]),
    (points, parameters): (&Points, &StreamParameters),
) -> Result<Chunks, BatchDefect> {
    let (base, truth) = base_of(descent, batches, points, refinable);
    let parameters = StreamParameters {
        max_patch: descent.max_patch(),
        has_general: descent.has_general(),
        ..parameters.clone()
    };
    write(base, truth, (&parameters, refinable.sequence.step_count()))
}

/// # Errors
/// Where batches do not rise from 0 to the number of steps.
pub(crate) fn check_batches(batches: &[u32], step_count: usize) -> Result<(), BatchDefect> {
    let rises = batches.windows(2).all(|w| w[0] < w[1]);
    if rises && batches.first() == Some(&0) && batches.last().map(|&n| n as usize) == Some(step_count) {
        return Ok(());
    }
    Err(BatchDefect::Cover { step_count })
}

fn write(
    base: Base,
    mut truth: Truth<'_>,
    (parameters, step_count): (&StreamParameters, usize),
) -> Result<Chunks, BatchDefect> {
    let limits = BaseLimits {
        triangle_count: base.triangles.len() as u32,
        position_count: base.places.len() as u32,
        wedges_beyond: u32::MAX,
    };
    let parameters = StreamParameters { base: limits, ..parameters.clone() };
    let mut spent = [0.0; PART_COUNT];
    let mut chunks = Vec::new();
    let mut writer = RangeWriter::new();
    // A surface that was collapsed to is closed.
    let mut refiner = Refiner::begin(&mut writer, &base, &parameters, &mut truth)
        .unwrap_or_else(|defect| panic!("collapses keep a surface closed: {defect}"));
    push(&mut chunks, writer, (&refiner.level.growth, base.triangles.len()), &mut spent);
    while truth.order.len() < step_count {
        let mut writer = RangeWriter::new();
        code_chunk(&mut refiner, &mut writer, &mut truth, step_count)?;
        push(&mut chunks, writer, (&refiner.level.growth, 0), &mut spent);
    }
    let Truth { order, source_vertex, base_positions, .. } = truth;
    let StreamParameters { max_patch, has_general, .. } = parameters;
    Ok(Chunks { chunks, max_patch, has_general, order, base_positions, source_vertex, spent })
}

fn push(
    chunks: &mut Vec<Chunk>,
    writer: RangeWriter,
    (growth, base_triangles): (&Growth, usize),
    spent: &mut [f64; PART_COUNT],
) {
    let (mut bytes, bits) = writer.finish();
    let split_count = growth.added.len();
    let splits = split_count - chunks.last().map_or(0, |chunk| chunk.split_count as usize);
    // The reader takes what is beyond the end for zeros, so zeros change nothing.
    let told: usize = chunks.iter().map(|chunk| chunk.bytes.len()).sum();
    let least = least_bytes_in_all(growth.beyond()).saturating_sub(told);
    bytes.resize(bytes.len().max(least).max(least_bytes(splits, base_triangles)), 0);
    spent.iter_mut().zip(bits).for_each(|(sum, bits)| *sum += bits);
    chunks.push(Chunk { bytes, split_count: split_count as u32 });
}

fn code_chunk(
    refiner: &mut Refiner,
    writer: &mut RangeWriter,
    truth: &mut Truth<'_>,
    step_count: usize,
) -> Result<(), BatchDefect> {
    let done = truth.order.len();
    // Early chunks are small, so that pictures come often.
    let end = (done + (done / 2).clamp(FIRST_SPLITS, CHUNK_SPLITS)).min(step_count);
    while truth.order.len() < end {
        let result = refiner.stretch(writer, truth, end - truth.order.len());
        let is_dependent = !refiner.is_in_batch() && !truth.is_settled();
        if result.is_err() || is_dependent {
            return Err(BatchDefect::Dependent { batch: refiner.batch() as usize - 1 });
        }
    }
    Ok(())
}
