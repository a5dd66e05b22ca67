//! From a sequence in batch order to compressed chunks.

use super::super::entropy::RangeWriter;
use super::base::Base;
use super::cutting::{Closed, close};
use super::refiner::{Refiner, Terms};
use super::shown::{ShownDown, groups_of_triangles};
use super::splits::{StepDefect, collapse_all};
use super::surface::Undo;
use super::truth::{Points, Truth, base_of};
use crate::mesh::RefinableMesh;

/// Splits of a chunk: what is checked, and can be asked for, at once.
const CHUNK_SPLITS: usize = 4096;
/// Splits of the first chunk: the first picture should not have to wait.
const FIRST_SPLITS: usize = 256;

/// A stretch of the stream with a checksum of its own.
#[derive(Clone, Debug)]
pub(super) struct Chunk {
    /// Range-coded.
    pub(super) bytes: Vec<u8>,
    /// Splits of this and all chunks before it.
    pub(super) split_count: u32,
}

/// A mesh as chunks.
#[derive(Clone, Debug)]
pub(super) struct Chunks {
    /// The base, then splits.
    pub(super) chunks: Vec<Chunk>,
    /// Most triangles that a new vertex takes over.
    pub(super) max_patch: u32,
    /// Steps of the sequence in the order of the stream.
    pub(super) order: Vec<u32>,
    /// Bits by part.
    pub(super) spent: [f64; 4],
}

/// Why a sequence is not one of batches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BatchDefect {
    /// A step is no vertex split of a surface.
    #[error("step {step} cannot be coded: {defect}")]
    Step {
        /// The step, coarse to fine.
        step: usize,
        /// What is wrong.
        defect: StepDefect,
    },
    /// The splits of a batch are not independent of each other.
    #[error("the steps of batch {batch} depend on each other")]
    Dependent {
        /// The batch, coarse to fine from 0.
        batch: usize,
    },
    /// Batches do not cover the steps in order.
    #[error("the batches do not rise from 0 to the {step_count} steps")]
    Cover {
        /// Steps of the sequence.
        step_count: usize,
    },
}

/// The positions of a mesh as a closed surface.
pub(super) fn close_positions(refinable: &RefinableMesh) -> Closed {
    let positions = refinable.sequence.positions();
    let triangles: Vec<[u32; 3]> =
        refinable.mesh.triangles.iter().map(|t| t.map(|v| positions.position_of(v))).collect();
    close(&triangles, positions.position_count())
}

/// Codes a sequence on the closed surface of its positions; the patch of the terms is found here.
pub(super) fn encode_chunks(
    mut closed: Closed,
    refinable: &RefinableMesh,
    batches: &[u32],
    (points, terms): (&Points, &Terms),
) -> Result<Chunks, BatchDefect> {
    let has_more = !refinable.sequence.positions().is_identity() || refinable.mesh.groups.len() > 1;
    let mut shown = has_more.then(|| ShownDown::new(&refinable.mesh, &closed.surface));
    let undo = collapse_all(&mut closed, refinable, shown.as_mut())
        .map_err(|(step, defect)| BatchDefect::Step { step, defect })?;
    let shown = shown.map(|shown| shown.into_up(&undo, groups_of_triangles(&refinable.mesh)));
    let (base, truth) = base_of(&closed, &undo, batches, (points, shown));
    write(&undo, base, truth, terms)
}

/// # Errors
/// Where batches do not rise from 0 to the number of steps.
pub(super) fn check_batches(batches: &[u32], step_count: usize) -> Result<(), BatchDefect> {
    let rises = batches.windows(2).all(|w| w[0] < w[1]);
    if rises && batches.first() == Some(&0) && batches.last().map(|&n| n as usize) == Some(step_count) {
        return Ok(());
    }
    Err(BatchDefect::Cover { step_count })
}

fn write(undo: &[Undo], base: Base, mut truth: Truth<'_>, terms: &Terms) -> Result<Chunks, BatchDefect> {
    let max_patch = undo.iter().map(|u| u.cut.length).max().unwrap_or(0);
    let terms = Terms { max_patch, ..terms.clone() };
    let mut spent = [0.0; 4];
    let mut chunks = Vec::new();
    let mut writer = RangeWriter::new();
    // A surface that was collapsed to is closed.
    let mut refiner =
        Refiner::begin(&mut writer, base, &terms, &truth).expect("collapses keep a surface closed");
    push(&mut chunks, writer, 0, &mut spent);
    while truth.order.len() < undo.len() {
        let mut writer = RangeWriter::new();
        code_chunk(&mut refiner, &mut writer, &mut truth, undo.len())?;
        push(&mut chunks, writer, truth.order.len(), &mut spent);
    }
    Ok(Chunks { chunks, max_patch, order: truth.order, spent })
}

fn push(chunks: &mut Vec<Chunk>, writer: RangeWriter, split_count: usize, spent: &mut [f64; 4]) {
    let (bytes, bits) = writer.finish();
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

#[cfg(test)]
mod tests {
    use super::super::Effort;
    use super::super::grid::PositionGrid;
    use super::super::refiner::{Ended, Unknown};
    use super::*;
    use crate::codec::entropy::RangeReader;
    use crate::mesh::{IndexedMesh, Random, replay, shapes};
    use crate::simplify::{SequenceOptions, build_sequence};

    /// Triangles with the smallest corner first, sorted.
    fn canonical(triangles: impl Iterator<Item = [u32; 3]>) -> Vec<[u32; 3]> {
        let turned = triangles.map(|t| {
            let first = (0..3).min_by_key(|&i| t[i]).unwrap_or(0);
            [t[first], t[(first + 1) % 3], t[(first + 2) % 3]]
        });
        let mut sorted: Vec<_> = turned.collect();
        sorted.sort_unstable();
        sorted
    }

    /// Reads chunks as far as they go; a check after each.
    fn read(chunks: &Chunks, terms: &Terms, mut check: impl FnMut(&Refiner, usize)) -> Refiner {
        let mut reader = RangeReader::new(&chunks.chunks[0].bytes, true);
        let terms = Terms { max_patch: chunks.max_patch, ..terms.clone() };
        let mut refiner = Refiner::begin(&mut reader, Base::default(), &terms, &Unknown).unwrap();
        let mut done = 0;
        check(&refiner, 0);
        for chunk in &chunks.chunks[1..] {
            let mut reader = RangeReader::new(&chunk.bytes, true);
            while done < chunk.split_count as usize {
                let most = chunk.split_count as usize - done;
                assert_eq!(refiner.stretch(&mut reader, &mut Unknown, most), Ok(Ended::Whole));
                done = refiner.growth.targets.len();
                check(&refiner, done);
            }
        }
        refiner
    }

    fn round_trip(mesh: &IndexedMesh) {
        let built = build_sequence(mesh, &SequenceOptions::default(), &mut crate::ignore_progress).unwrap();
        let refinable = &built.refinable;
        let sequence = &refinable.sequence;
        // One step a batch: nothing is asked of their order.
        let batches: Vec<u32> = (0..=sequence.step_count() as u32).collect();
        let mut random = Random::new(5);
        let places: Vec<[i32; 3]> = (0..sequence.positions().position_count())
            .map(|_| std::array::from_fn(|_| random.below(4096) as i32))
            .collect();
        let points = Points { exact: vec![[0.0; 3]; places.len()], places };
        let grid = PositionGrid { origin: [0.0; 3], step: 1.0, bits: 12 };
        for effort in [Effort::Fast, Effort::Default, Effort::Small] {
            let terms = Terms {
                effort,
                grid,
                is_exact: false,
                max_patch: 0,
                position_count: points.places.len() as u32,
            };
            let chunks =
                encode_chunks(close_positions(refinable), refinable, &batches, (&points, &terms)).unwrap();
            // Places are all different with near certainty, so triangles can be compared by them.
            let base = sequence.base_position_count();
            let mut seen = 0;
            let refiner = read(&chunks, &terms, |refiner, done| {
                seen += 1;
                let _ = (refiner, done);
            });
            assert!(seen > 1);
            let position = |v: u32| {
                let v = v as usize;
                if v < base { v as u32 } else { base as u32 + chunks.order[v - base] }
            };
            let found = canonical(refiner.growth.triangles.iter().map(|t| t.map(position)));
            let positions = sequence.positions();
            let full = replay(refinable, sequence.step_count());
            let expected = canonical(full.triangles.iter().map(|t| t.map(|v| positions.position_of(v))));
            assert_eq!(found, expected);
            for (step, &at) in chunks.order.iter().enumerate() {
                let target = position(refiner.growth.targets[step]);
                let vertex = sequence.step_vertices(at as usize).start;
                assert_eq!(target, positions.position_of(sequence.target(vertex)));
            }
        }
    }

    #[test]
    fn what_is_written_is_read() {
        for mesh in [shapes::torus(24, 12, 1.0, 0.4), shapes::grid(17, 12), shapes::icosphere(3, 1.0)] {
            round_trip(&mesh);
        }
    }
}
