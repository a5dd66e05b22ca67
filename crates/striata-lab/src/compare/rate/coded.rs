//! Meshes as coders keep them, and how long coding takes.

use std::time::Instant;

use striata::mesh::IndexedMesh;
use striata_stream::Effort;

use striata_command::failure::Failure;
use striata_command::stream::effort_name;

/// How often decoding is repeated at most; the quickest counts.
pub(super) const RUNS: usize = 5;
/// Seconds after which it is not repeated any more.
pub(super) const RUN_SECS: f64 = 2.0;

/// A mesh as some coder keeps it.
pub(super) struct Coded {
    pub(super) bytes: usize,
    /// Decoded again.
    pub(super) mesh: IndexedMesh,
    pub(super) encode_secs: f64,
    pub(super) decode_secs: f64,
}

/// A coder of single meshes: positions on a grid of a number of bits.
pub(super) type Coder<'c> = Box<dyn Fn(&IndexedMesh, u32) -> Result<Coded, Failure> + 'c>;

/// What a stream is called.
pub(super) fn stream_name(effort: Effort) -> String {
    format!("striata {}", effort_name(effort))
}

/// The quickest of some runs, each of which gives its seconds.
///
/// # Errors
/// Where one of them fails.
pub(super) fn quickest(mut run: impl FnMut() -> Result<f64, Failure>) -> Result<f64, Failure> {
    let started = Instant::now();
    let mut least = run()?;
    for _ in 1..RUNS {
        if started.elapsed().as_secs_f64() > RUN_SECS {
            break;
        }
        least = least.min(run()?);
    }
    Ok(least)
}
