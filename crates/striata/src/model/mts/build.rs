//! Builds the model: follows each strip through its history, then collects the strips that each step changes.

use super::lifetimes::{self, NEVER_DROPPED};
use super::record::{ChangedStrip, MtsRecordFormat};
use super::{MAX_STRIP_INDICES, Mts, MtsParts};
use crate::mesh::{CollapseSequence, RefinableMesh};
use crate::model::ModelError;
use crate::model::bits::Bits;
use crate::model::packed_vertices::PackedVertices;
use crate::model::step_vertices::StepVertices;
use crate::model::stored_strips::StoredStrips;
use crate::model::strip_history::{Piece, StripHistory, Touch};
use crate::model::strip_input::{check_strips, sorted_spatially};
use crate::strip::StripSet;

impl Mts<'static> {
    /// Builds the model from strips of the full mesh; strips longer than [`MAX_STRIP_INDICES`] are cut.
    ///
    /// # Errors
    /// [`ModelError`] if the strips do not belong to the mesh: different groups, different triangle
    /// counts, or vertices that do not exist.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, ModelError> {
        check_strips(&refinable.mesh, strips)?;
        let strips = sorted_spatially(&strips.cut(MAX_STRIP_INDICES), &refinable.mesh.positions);
        let sequence = &refinable.sequence;
        let vertex_count = refinable.mesh.vertex_count();
        let mut histories = Histories::default();
        for (index, strip) in strips.strips().enumerate() {
            histories.push(sequence, index as u32, strip);
        }
        lifetimes::finish(&mut histories.lifetimes);
        let (heads, arena) = histories.records(sequence.step_count(), strips.strip_count());
        let parts = MtsParts {
            strips: StoredStrips::pack(&strips, vertex_count),
            lifetimes: histories.lifetimes.into(),
            heads: heads.into(),
            arena: arena.into(),
        };
        let vertices = StepVertices::of_sequence(sequence).without_targets();
        let targets = PackedVertices::pack(sequence.targets(), vertex_count);
        Self::unchecked(vertices, targets, parts)
    }
}

/// Histories of all strips added so far.
#[derive(Debug, Default)]
struct Histories {
    /// Entries of all strips; see [`lifetimes`].
    lifetimes: Vec<u8>,
    /// Pairs of a strip and a step that changes it.
    touches: Vec<(u32, Touch)>,
}

impl Histories {
    /// Adds the history of the next strip.
    fn push(&mut self, sequence: &CollapseSequence, index: u32, strip: &[u32]) {
        let mut history = StripHistory::new(sequence, strip);
        // A slot counts as dropped until it is seen again after a later change.
        let mut slots = SlotLifetimes { lifetimes: vec![1; strip.len()], breaks: Vec::new() };
        let mut change = 0;
        slots.note(history.pieces(), change);
        while let Some(touch) = history.coarsen() {
            self.touches.push((index, touch));
            if touch.drops {
                // Each change drops at least one slot, and there are few enough slots for a byte.
                change += 1;
                slots.note(history.pieces(), change);
            }
        }
        for piece in history.pieces() {
            piece.places.iter().for_each(|&slot| slots.lifetimes[slot as usize] = NEVER_DROPPED);
        }
        slots.breaks.sort_unstable();
        lifetimes::write(&slots.lifetimes, &slots.breaks, &mut self.lifetimes);
    }

    /// Returns the heads and the arena of the records, which list the strips that each step changes.
    fn records(&self, step_count: usize, strip_count: usize) -> (Vec<u8>, Vec<u8>) {
        let mut ends = vec![0u32; step_count + 1];
        for (_, touch) in &self.touches {
            ends[touch.step as usize + 1] += 1;
        }
        for step in 0..step_count {
            ends[step + 1] += ends[step];
        }
        // Touches are sorted by strip, so the strips of each step come out in ascending order.
        let mut changed: Vec<ChangedStrip> = vec![(0, false); self.touches.len()];
        let mut next = ends.clone();
        for &(strip, touch) in &self.touches {
            let at = &mut next[touch.step as usize];
            changed[*at as usize] = (strip, touch.drops);
            *at += 1;
        }
        let format = MtsRecordFormat::new(strip_count);
        let mut bits = Bits::default();
        let of_step = |w: &[u32]| format.write(&changed[w[0] as usize..w[1] as usize], &mut bits);
        let heads = ends.windows(2).map(of_step).collect();
        (heads, bits.into_padded())
    }
}

/// Lifetimes and breaks of one strip.
struct SlotLifetimes {
    lifetimes: Vec<u32>,
    breaks: Vec<[u8; 2]>,
}

impl SlotLifetimes {
    /// Records the slots and breaks that the strip has after one of its changes.
    fn note(&mut self, pieces: &[Piece], change: u8) {
        for (i, piece) in pieces.iter().enumerate() {
            let lifetime = u32::from(change) + 1;
            piece.places.iter().for_each(|&slot| self.lifetimes[slot as usize] = lifetime);
            // A break is permanent: pieces are split but never joined.
            let begin = piece.places[0] as u8;
            if i > 0 && self.breaks.iter().all(|b| b[0] != begin) {
                self.breaks.push([begin, change]);
            }
        }
    }
}
