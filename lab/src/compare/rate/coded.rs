//! Encoded meshes and their coding times.

use std::time::Instant;

use striata::mesh::IndexedMesh;
use striata_stream::Effort;

use striata_command::failure::Failure;
use striata_command::stream::effort_name;

/// Maximum number of decoding runs; the fastest one counts.
pub(super) const RUNS: usize = 5;
/// Decoding is not repeated after this many seconds.
const RUN_SECS: f64 = 2.0;

/// The result of encoding and decoding a mesh.
pub(super) struct CodedMesh {
    pub bytes: usize,
    /// The decoded mesh.
    pub mesh: IndexedMesh,
    pub encode_secs: f64,
    pub decode_secs: f64,
}

/// A coder of single meshes, with positions on a grid of the given number of bits.
pub(super) type Coder<'c> = Box<dyn Fn(&IndexedMesh, u32) -> Result<CodedMesh, Failure> + 'c>;

/// Name of a stream in the report.
pub(super) fn stream_name(effort: Effort) -> String {
    format!("striata {}", effort_name(effort))
}

/// The fastest of several runs, each of which returns its seconds.
///
/// # Errors
/// If a run fails.
pub(super) fn fastest(mut run: impl FnMut() -> Result<f64, Failure>) -> Result<f64, Failure> {
    let started = Instant::now();
    let mut best = run()?;
    for _ in 1..RUNS {
        if started.elapsed().as_secs_f64() > RUN_SECS {
            break;
        }
        best = best.min(run()?);
    }
    Ok(best)
}
