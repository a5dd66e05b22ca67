//! Builds the model: follows each strip through its history, then collects the strips that each step changes.

use super::{MAX_STRIP_INDICES, Mts, MtsParts};
use crate::mesh::{CollapseSequence, RefinableMesh};
use crate::model::ModelError;
use crate::model::record_arena::{head_bytes, push_record, write_varint};
use crate::model::step_vertices::StepVertices;
use crate::model::strip_history::{Piece, StripHistory, Touch};
use crate::model::strip_input::{check_strips, sorted_spatially};
use crate::strip::StripSet;

/// Last change of a slot that is never dropped.
pub(super) const NEVER_DROPPED: u8 = u8::MAX;

// Slots, and so changes, must be countable in a byte.
const _: () = assert!(MAX_STRIP_INDICES < NEVER_DROPPED as usize);

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
        let mut lifetimes = Lifetimes::default();
        lifetimes.break_offsets.push(0);
        for (index, strip) in strips.strips().enumerate() {
            lifetimes.push(sequence, index as u32, strip);
        }
        let (arena, record_lengths) = lifetimes.records(sequence.step_count(), strips.strip_count());
        let parts = MtsParts {
            indices: strips.indices().to_vec().into(),
            offsets: strips.offsets().to_vec().into(),
            group_offsets: strips.group_offsets().to_vec().into(),
            lasts: lifetimes.lasts.into(),
            break_offsets: lifetimes.break_offsets.into(),
            breaks: lifetimes.breaks.into(),
            record_lengths: record_lengths.into(),
            arena: arena.into(),
        };
        Ok(Self::unchecked(StepVertices::of_sequence(sequence).into_owned(), parts))
    }
}

/// Lifetimes of the slots and breaks of all strips added so far.
#[derive(Debug, Default)]
struct Lifetimes {
    lasts: Vec<u8>,
    break_offsets: Vec<u32>,
    breaks: Vec<[u8; 2]>,
    /// Pairs of a strip and a step that changes it.
    touches: Vec<(u32, Touch)>,
}

impl Lifetimes {
    /// Adds the history of the next strip.
    fn push(&mut self, sequence: &CollapseSequence, index: u32, strip: &[u32]) {
        let mut history = StripHistory::new(sequence, strip);
        let first = self.lasts.len();
        // A slot counts as dropped until it is seen again after a later change.
        self.lasts.resize(first + strip.len(), 0);
        let mut change = 0;
        let mut breaks = Vec::new();
        self.record_pieces(history.pieces(), first, change, &mut breaks);
        while let Some(touch) = history.coarsen() {
            self.touches.push((index, touch));
            if touch.drops {
                // Each change drops at least one slot, and there are few enough slots for a byte.
                change += 1;
                self.record_pieces(history.pieces(), first, change, &mut breaks);
            }
        }
        for piece in history.pieces() {
            piece.places.iter().for_each(|&slot| self.lasts[first + slot as usize] = NEVER_DROPPED);
        }
        breaks.sort_unstable();
        self.breaks.extend(breaks);
        self.break_offsets.push(self.breaks.len() as u32);
    }

    /// Records the slots and breaks that a strip has after one of its changes.
    fn record_pieces(&mut self, pieces: &[Piece], first: usize, change: u8, breaks: &mut Vec<[u8; 2]>) {
        for (i, piece) in pieces.iter().enumerate() {
            piece.places.iter().for_each(|&slot| self.lasts[first + slot as usize] = change);
            // A break is permanent: pieces are split but never joined.
            let begin = piece.places[0] as u8;
            if i > 0 && breaks.iter().all(|b| b[0] != begin) {
                breaks.push([begin, change]);
            }
        }
    }

    /// Returns the arena of records, which list the strips that each step changes, and the record lengths.
    /// For the layout see [`super::state`].
    fn records(&self, step_count: usize, strip_count: usize) -> (Vec<u8>, Vec<u8>) {
        let mut ends = vec![0u32; step_count + 1];
        for (_, touch) in &self.touches {
            ends[touch.step as usize + 1] += 1;
        }
        for step in 0..step_count {
            ends[step + 1] += ends[step];
        }
        // Touches are sorted by strip, so the strips of each step come out in ascending order.
        let mut heads = vec![0u32; self.touches.len()];
        let mut next = ends.clone();
        for &(strip, touch) in &self.touches {
            let at = &mut next[touch.step as usize];
            heads[*at as usize] = strip << 1 | u32::from(touch.drops);
            *at += 1;
        }
        let head_bytes = head_bytes(strip_count, 1);
        let (mut arena, mut lengths, mut body) = (Vec::new(), Vec::with_capacity(step_count), Vec::new());
        for step in ends.windows(2) {
            body.clear();
            let mut last = None;
            for &head in &heads[step[0] as usize..step[1] as usize] {
                match last {
                    None => body.extend_from_slice(&head.to_le_bytes()[..head_bytes]),
                    Some(last) => write_varint(((head >> 1) - last - 1) << 1 | head & 1, &mut body),
                }
                last = Some(head >> 1);
            }
            push_record(&body, &mut arena, &mut lengths);
        }
        (arena, lengths)
    }
}
