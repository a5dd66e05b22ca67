//! Our streams: whole, and as prefixes.

use std::time::Instant;

use striata::ProgressFn;
use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::simplify::{BatchOptions, build_batches_with_progress};
use striata_stream::{
    Effort, Precision, SHAPE_STEPS, StreamError, StreamInfo, StreamLevels, StreamOptions, encode_stream,
};

use super::coded::{CodedMesh, fastest, stream_name};
use super::distance_meter::{DistanceMeter, RateRow};
use striata_command::failure::Failure;
use striata_command::output::Bar;

/// Number of prefixes measured per stream.
const PREFIXES: i32 = 12;

/// A mesh with batched collapses, ready to be streamed.
pub(super) struct Streams {
    refinable: RefinableMesh,
    batches: Vec<u32>,
    simplify_secs: f64,
}

/// Bits for which the batches are built; streams of other precisions reuse them.
const BATCH_BITS: u32 = 12;

impl Streams {
    /// Simplifies a mesh in batches.
    ///
    /// # Errors
    /// If the mesh is inconsistent.
    pub(super) fn build(mesh: &IndexedMesh, bar: &mut Bar) -> Result<Self, Failure> {
        Self::with_progress(mesh, &mut |progress| bar.show(progress))
    }

    fn with_progress(mesh: &IndexedMesh, progress: &mut ProgressFn<'_>) -> Result<Self, Failure> {
        let started = Instant::now();
        let options = StreamOptions::default().with_precision(Precision::Bits(BATCH_BITS));
        let step = options.grid_step(mesh).map_err(StreamError::Grid)?;
        let options = BatchOptions::default().with_shape_step(Some(SHAPE_STEPS * step));
        let batched = build_batches_with_progress(mesh, &options, progress)?;
        let simplify_secs = started.elapsed().as_secs_f64();
        Ok(Self { refinable: batched.built.refinable, batches: batched.batches, simplify_secs })
    }

    /// The welded mesh, in collapse order.
    pub(super) fn mesh(&self) -> &IndexedMesh {
        &self.refinable.mesh
    }

    fn encode(&self, bits: u32, effort: Effort) -> Result<Vec<u8>, Failure> {
        let options = StreamOptions::default().with_precision(Precision::Bits(bits)).with_effort(effort);
        Ok(encode_stream(&self.refinable, &self.batches, &options)?.bytes)
    }

    /// Encodes and decodes a whole stream; encoding time includes simplification.
    ///
    /// # Errors
    /// If encoding or decoding fails.
    pub(super) fn code(&self, bits: u32, effort: Effort) -> Result<CodedMesh, Failure> {
        let started = Instant::now();
        let bytes = self.encode(bits, effort)?;
        let encode_secs = self.simplify_secs + started.elapsed().as_secs_f64();
        let decode_secs = fastest(|| {
            let started = Instant::now();
            StreamLevels::decoded(&bytes)?;
            Ok(started.elapsed().as_secs_f64())
        })?;
        let mesh = StreamLevels::decoded(&bytes)?.into_steps()?.into_mesh();
        Ok(CodedMesh { bytes: bytes.len(), mesh, encode_secs, decode_secs })
    }

    /// Measures prefixes, from the base mesh to the whole stream in geometric progression.
    ///
    /// # Errors
    /// If encoding or decoding fails.
    pub(super) fn prefixes(
        &self,
        bits: u32,
        effort: Effort,
        meter: &DistanceMeter<'_>,
    ) -> Result<Vec<RateRow>, Failure> {
        let bytes = self.encode(bits, effort)?;
        let name = stream_name(effort);
        let base = StreamInfo::read(&bytes)?.map_or(1, |facts| facts.base_bytes) as f64;
        let ratio = bytes.len() as f64 / base;
        let mut rows = Vec::new();
        for i in 0..PREFIXES {
            let length = base * ratio.powf(f64::from(i) / f64::from(PREFIXES - 1));
            let length = (length.round() as usize).clamp(base as usize, bytes.len());
            let shown = StreamLevels::decoded(&bytes[..length])?.into_steps()?.into_mesh();
            rows.extend(meter.row(&name, length, &shown));
        }
        Ok(rows)
    }
}

/// Encodes a level as a separate stream, at the compact effort.
///
/// # Errors
/// If encoding or decoding fails.
pub(super) fn code_level(mesh: &IndexedMesh, bits: u32) -> Result<CodedMesh, Failure> {
    Streams::with_progress(mesh, &mut striata::ignore_progress)?.code(bits, Effort::Compact)
}
