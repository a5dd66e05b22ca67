//! Our streams: whole, and their prefixes.

use std::time::Instant;

use striata::ProgressFn;
use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::simplify::{BatchOptions, build_batches_with_progress};
use striata_stream::{Effort, Precision, SHAPE_STEPS, StreamError, StreamInfo, StreamOptions, encode_stream};

use super::coded::{Coded, quickest, stream_name};
use super::ruler::{RateRow, Ruler};
use striata_command::failure::Failure;
use striata_command::output::Bar;
use striata_command::stream::DecodedStream;

/// Prefixes of a stream that are looked at.
const PREFIXES: i32 = 12;

/// A mesh whose collapses come in batches.
pub(super) struct Streams {
    refinable: RefinableMesh,
    batches: Vec<u32>,
    simplify_secs: f64,
}

/// Bits of the streams that batches are made for; others are coded from the same batches.
const BATCH_BITS: u32 = 12;

impl Streams {
    /// # Errors
    /// Where the mesh does not hang together.
    pub(super) fn build(mesh: &IndexedMesh, bar: &mut Bar) -> Result<Self, Failure> {
        Self::with_progress(mesh, &mut |progress| bar.show(progress))
    }

    fn with_progress(mesh: &IndexedMesh, progress: &mut ProgressFn<'_>) -> Result<Self, Failure> {
        let started = Instant::now();
        let options = StreamOptions::default().with_precision(Precision::Bits(BATCH_BITS));
        let step = options.grid_step(mesh).map_err(StreamError::Grid)?;
        let options = BatchOptions::default().with_shape_step(Some(SHAPE_STEPS * step));
        let made = build_batches_with_progress(mesh, &options, progress)?;
        let simplify_secs = started.elapsed().as_secs_f64();
        Ok(Self { refinable: made.built.refinable, batches: made.batches, simplify_secs })
    }

    /// The mesh, welded, in the order of the collapses.
    pub(super) fn mesh(&self) -> &IndexedMesh {
        &self.refinable.mesh
    }

    fn encode(&self, bits: u32, effort: Effort) -> Result<Vec<u8>, Failure> {
        let options = StreamOptions::default().with_precision(Precision::Bits(bits)).with_effort(effort);
        Ok(encode_stream(&self.refinable, &self.batches, &options)?.bytes)
    }

    /// A whole stream; simplification is in the time of encoding.
    ///
    /// # Errors
    /// Where it cannot be coded, or not decoded.
    pub(super) fn code(&self, bits: u32, effort: Effort) -> Result<Coded, Failure> {
        let started = Instant::now();
        let bytes = self.encode(bits, effort)?;
        let encode_secs = self.simplify_secs + started.elapsed().as_secs_f64();
        let decode_secs = quickest(|| Ok(DecodedStream::read_all(&bytes)?.decode_secs))?;
        let mesh = DecodedStream::read_all(&bytes)?.refinable()?.mesh;
        Ok(Coded { bytes: bytes.len(), mesh, encode_secs, decode_secs })
    }

    /// What prefixes show, from the base mesh to the whole stream in even ratios.
    ///
    /// # Errors
    /// Where it cannot be coded, or not decoded.
    pub(super) fn prefixes(
        &self,
        bits: u32,
        effort: Effort,
        ruler: &Ruler<'_>,
    ) -> Result<Vec<RateRow>, Failure> {
        let bytes = self.encode(bits, effort)?;
        let name = stream_name(effort);
        let base = StreamInfo::read(&bytes)?.map_or(1, |facts| facts.base_bytes) as f64;
        let ratio = bytes.len() as f64 / base;
        let mut rows = Vec::new();
        for i in 0..PREFIXES {
            let length = base * ratio.powf(f64::from(i) / f64::from(PREFIXES - 1));
            let length = (length.round() as usize).clamp(base as usize, bytes.len());
            let shown = DecodedStream::read_all(&bytes[..length])?.refinable()?.mesh;
            rows.extend(ruler.row(&name, length, &shown));
        }
        Ok(rows)
    }
}

/// A level as a stream of its own, at the default effort.
///
/// # Errors
/// Where it cannot be coded, or not decoded.
pub(super) fn code_level(mesh: &IndexedMesh, bits: u32) -> Result<Coded, Failure> {
    Streams::with_progress(mesh, &mut striata::ignore_progress)?.code(bits, Effort::Default)
}
