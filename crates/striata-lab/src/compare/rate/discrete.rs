//! Levels that are coded by themselves and come one after another, each with half the triangles of the next.

use striata::mesh::{IndexedMesh, replay};
use striata::simplify::{SequenceOptions, build_sequence_with_progress};

use super::coded::Coder;
use super::ruler::{RateRow, Ruler};
use striata_command::failure::Failure;
use striata_command::output::Bar;

/// No level has fewer triangles.
const LEAST_TRIANGLES: usize = 100;

/// What is shown after each level: its bytes and those of all before it count.
///
/// # Errors
/// Where a level cannot be coded.
pub(super) fn measure(
    mesh: &IndexedMesh,
    bits: u32,
    coders: &[(String, Coder<'_>)],
    (ruler, bar): (&Ruler<'_>, &mut Bar),
) -> Result<Vec<RateRow>, Failure> {
    let built =
        build_sequence_with_progress(mesh, &SequenceOptions::default(), &mut |progress| bar.show(progress))?;
    let refinable = built.refinable;
    let mut counts: Vec<usize> =
        std::iter::successors(Some(refinable.mesh.triangle_count()), |n| Some(n / 2))
            .take_while(|&n| n >= LEAST_TRIANGLES)
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
            rows.extend(ruler.row(&name, bytes, &coded.mesh));
        }
    }
    Ok(rows)
}
