//! Discrete levels, encoded separately and sent one after another, each with half the triangles of the next.

use striata::mesh::{IndexedMesh, replay};
use striata::simplify::{SequenceOptions, build_sequence_with_progress};

use super::coded::Coder;
use super::distance_meter::{DistanceMeter, RateRow};
use striata_command::failure::Failure;
use striata_command::output::Bar;

/// Minimum number of triangles of a level.
const MIN_TRIANGLES: usize = 100;

/// Measures the distance after each level; the bytes of all previous levels are included.
///
/// # Errors
/// If a level cannot be coded.
pub(super) fn measure(
    mesh: &IndexedMesh,
    bits: u32,
    coders: &[(String, Coder<'_>)],
    meter: &DistanceMeter<'_>,
    bar: &mut Bar,
) -> Result<Vec<RateRow>, Failure> {
    let built =
        build_sequence_with_progress(mesh, &SequenceOptions::default(), &mut |progress| bar.show(progress))?;
    let refinable = built.refinable;
    let mut counts: Vec<usize> =
        std::iter::successors(Some(refinable.mesh.triangle_count()), |n| Some(n / 2))
            .take_while(|&n| n >= MIN_TRIANGLES)
            .collect();
    counts.reverse();
    let level = |&count: &usize| replay(&refinable, refinable.sequence.split_count_for_triangles(count));
    let levels: Vec<IndexedMesh> = counts.iter().map(level).collect();
    let mut rows = Vec::new();
    for (name, code) in coders {
        let name = format!("levels, {name}");
        let mut bytes = 0;
        for level in &levels {
            let coded = code(&level.clone().without_unused_vertices(), bits)?;
            bytes += coded.bytes;
            rows.extend(meter.row(&name, bytes, &coded.mesh));
        }
    }
    Ok(rows)
}
