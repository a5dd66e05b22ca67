//! Building: each strip goes down its history on its own, then the steps learn which strips they change.

use super::{MAX_STRIP_INDICES, Mts, MtsParts};
use crate::mesh::{CollapseSequence, RefinableMesh};
use crate::model::ModelError;
use crate::model::record_arena::{head_bytes, push_record, write_varint};
use crate::model::step_vertices::StepVertices;
use crate::model::strip_history::{Piece, StripHistory, Touch};
use crate::model::strip_input::{check_strips, sorted_by_place};
use crate::strip::StripSet;

/// The last change of a place that never goes.
pub(super) const NEVER: u8 = u8::MAX;

// Places, and with them changes, are numbered in bytes.
const _: () = assert!(MAX_STRIP_INDICES < NEVER as usize);

impl Mts<'static> {
    /// Builds the model from strips of the full mesh; strips longer than [`MAX_STRIP_INDICES`] are cut.
    ///
    /// # Errors
    /// [`ModelError`] where the strips are not those of the mesh: other groups, other numbers of
    /// triangles, vertices that are not there.
    pub fn build(refinable: &RefinableMesh, strips: &StripSet) -> Result<Self, ModelError> {
        check_strips(&refinable.mesh, strips)?;
        let strips = sorted_by_place(&strips.cut(MAX_STRIP_INDICES), &refinable.mesh.positions);
        let sequence = &refinable.sequence;
        let mut lifetimes = Lifetimes::default();
        lifetimes.break_offsets.push(0);
        for (number, strip) in strips.strips().enumerate() {
            lifetimes.push(sequence, number as u32, strip);
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

/// What is known of all strips so far.
#[derive(Debug, Default)]
struct Lifetimes {
    lasts: Vec<u8>,
    break_offsets: Vec<u32>,
    breaks: Vec<[u8; 2]>,
    /// The strips that were touched, each with what touched it.
    touches: Vec<(u32, Touch)>,
}

impl Lifetimes {
    fn push(&mut self, sequence: &CollapseSequence, number: u32, strip: &[u32]) {
        let mut history = StripHistory::new(sequence, strip);
        let first = self.lasts.len();
        // Until it is seen again a place is gone.
        self.lasts.resize(first + strip.len(), 0);
        let mut change = 0;
        let mut breaks = Vec::new();
        self.take(history.pieces(), first, change, &mut breaks);
        while let Some(touch) = history.coarsen() {
            self.touches.push((number, touch));
            if touch.drops {
                // Each change drops a place, and there are few enough places.
                change += 1;
                self.take(history.pieces(), first, change, &mut breaks);
            }
        }
        for piece in history.pieces() {
            piece.places.iter().for_each(|&place| self.lasts[first + place as usize] = NEVER);
        }
        breaks.sort_unstable();
        self.breaks.extend(breaks);
        self.break_offsets.push(self.breaks.len() as u32);
    }

    /// Takes what the strip is after one of its changes.
    fn take(&mut self, pieces: &[Piece], first: usize, change: u8, breaks: &mut Vec<[u8; 2]>) {
        for (i, piece) in pieces.iter().enumerate() {
            piece.places.iter().for_each(|&place| self.lasts[first + place as usize] = change);
            // Where a piece begins one begins for good: pieces are cut but never joined.
            let begin = piece.places[0] as u8;
            if i > 0 && breaks.iter().all(|b| b[0] != begin) {
                breaks.push([begin, change]);
            }
        }
    }

    /// For each step which strips it changes, and their lengths: see [`super::state`].
    fn records(&self, step_count: usize, strip_count: usize) -> (Vec<u8>, Vec<u8>) {
        let mut ends = vec![0u32; step_count + 1];
        for (_, touch) in &self.touches {
            ends[touch.step as usize + 1] += 1;
        }
        for step in 0..step_count {
            ends[step + 1] += ends[step];
        }
        // Strips come in order, so those of each step do.
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
