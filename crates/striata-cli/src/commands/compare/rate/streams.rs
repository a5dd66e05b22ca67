//! Our streams: whole, and their prefixes.

use std::time::Instant;

use striata::codec::progressive::{Effort, Precision, StreamFacts, StreamOptions, encode_stream};
use striata::mesh::{IndexedMesh, RefinableMesh};
use striata::simplify::{BatchOptions, build_batches};

use super::{Coded, RUNS, RateRow, Ruler, median, stream_name};
use crate::failure::Failure;
use crate::output::Bar;
use crate::stream::Received;

/// Prefixes of a stream that are looked at.
const PREFIXES: i32 = 12;

/// A mesh whose collapses come in batches.
pub(super) struct Streams {
    refinable: RefinableMesh,
    batches: Vec<u32>,
}

impl Streams {
    /// # Errors
    /// Where the mesh does not hang together.
    pub(super) fn build(mesh: &IndexedMesh, bar: &mut Bar) -> Result<Self, Failure> {
        let made = build_batches(mesh, &BatchOptions::default(), &mut |progress| bar.show(progress))?;
        Ok(Self { refinable: made.built.refinable, batches: made.batches })
    }

    /// The mesh, welded, in the order of the collapses.
    pub(super) fn mesh(&self) -> &IndexedMesh {
        &self.refinable.mesh
    }

    fn encode(&self, bits: u32, effort: Effort) -> Result<Vec<u8>, Failure> {
        let options = StreamOptions::default().with_precision(Precision::Bits(bits)).with_effort(effort);
        Ok(encode_stream(&self.refinable, &self.batches, &options)?.bytes)
    }

    /// A whole stream. Building the collapses is not in its time.
    ///
    /// # Errors
    /// Where it cannot be coded, or not decoded.
    pub(super) fn code(&self, bits: u32, effort: Effort) -> Result<Coded, Failure> {
        let started = Instant::now();
        let bytes = self.encode(bits, effort)?;
        let encode_secs = started.elapsed().as_secs_f64();
        let decode = |_| Ok(Received::read_all(&bytes)?.decode_secs);
        let decode_secs = median((0..RUNS).map(decode).collect::<Result<_, Failure>>()?);
        let mesh = Received::read_all(&bytes)?.refinable()?.mesh;
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
        let base = StreamFacts::read(&bytes)?.map_or(1, |facts| facts.base_bytes) as f64;
        let ratio = bytes.len() as f64 / base;
        let mut rows = Vec::new();
        for i in 0..PREFIXES {
            let length = base * ratio.powf(f64::from(i) / f64::from(PREFIXES - 1));
            let length = (length.round() as usize).clamp(base as usize, bytes.len());
            let shown = Received::read_all(&bytes[..length])?.refinable()?.mesh;
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
    let made = build_batches(mesh, &BatchOptions::default(), &mut striata::ignore_progress)?;
    Streams { refinable: made.built.refinable, batches: made.batches }.code(bits, Effort::Default)
}
