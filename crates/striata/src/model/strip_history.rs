//! Follows one strip through all levels and reports what is left after each step that changes it.
//!
//! A strip is a row of slots. Coarsening replaces removed vertices by their targets and drops slots that
//! have become superfluous (see `superfluous.rs`). If only degenerate triangles connect one visible
//! triangle to the next, and a restart takes fewer indices, the strip breaks into pieces. Slots never come
//! back and keep their order, so at every level the strip is an ascending subset of its slots.
//!
//! ```text
//! slots     0 1 2 3 4 5 6 7 8 9         a piece: 0 1 2 5 6 | another: 8 9 ..
//! ```
//!
//! Cost: linear in the number of slots for each step that changes the strip.

use super::superfluous::drop_superfluous;
use crate::mesh::CollapseSequence;

/// Minimum number of indices that a break must save to be worth its restart.
const LEAST_SAVED: usize = 2;

/// A run of slots that is drawn without a restart, and the vertex that each slot shows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Piece {
    /// Slots of the strip, ascending.
    pub places: Vec<u32>,
    /// Vertex shown by each slot.
    pub vertices: Vec<u32>,
}

/// A step that changed the strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Touch {
    /// Index of the step.
    pub step: u32,
    /// Whether slots were dropped or the strip broke; otherwise only vertices were replaced.
    pub drops: bool,
}

/// A strip that is followed from the full mesh down to the base.
#[derive(Debug)]
pub struct StripHistory<'s> {
    sequence: &'s CollapseSequence,
    base_vertex_count: u32,
    /// Scratch: indices of the current piece whose vertex has been replaced.
    pieces: Vec<Piece>,
    changed: Vec<u32>,
    /// Scratch: runs dropped from the current piece.
    runs: Vec<super::strip_run::Run>,
}

impl<'s> StripHistory<'s> {
    /// Starts with a strip of the full mesh.
    pub fn new(sequence: &'s CollapseSequence, strip: &[u32]) -> Self {
        let whole = Piece { places: (0..strip.len() as u32).collect(), vertices: strip.to_vec() };
        Self {
            sequence,
            base_vertex_count: sequence.base_vertex_count() as u32,
            pieces: if strip.is_empty() { Vec::new() } else { vec![whole] },
            changed: Vec::new(),
            runs: Vec::new(),
        }
    }

    /// Returns the remaining pieces in the strip's order; none is empty.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Applies the next step that changes the strip. Returns `None` if only base vertices are left in it.
    pub fn coarsen(&mut self) -> Option<Touch> {
        let newest = self.pieces.iter().flat_map(|piece| &piece.vertices).copied().max()?;
        if newest < self.base_vertex_count {
            return None;
        }
        let position = self.sequence.positions().position_of(newest);
        let step = position as usize - self.sequence.base_position_count();
        let vertices = self.sequence.step_vertices(step);
        let place_count = |pieces: &[Piece]| pieces.iter().map(|piece| piece.places.len()).sum::<usize>();
        let before = (self.pieces.len(), place_count(&self.pieces));
        let mut at = 0;
        while at < self.pieces.len() {
            if self.substitute(at, vertices.start) {
                self.reduce(at);
                self.break_up(at);
            }
            at += 1;
        }
        self.pieces.retain(|piece| !piece.places.is_empty());
        let after = (self.pieces.len(), place_count(&self.pieces));
        Some(Touch { step: step as u32, drops: before != after })
    }

    /// Replaces the vertices of a piece from `first` on by their targets. Returns whether there were any.
    fn substitute(&mut self, piece: usize, first: u32) -> bool {
        self.changed.clear();
        for (i, vertex) in self.pieces[piece].vertices.iter_mut().enumerate() {
            if *vertex >= first {
                *vertex = self.sequence.target(*vertex);
                self.changed.push(i as u32);
            }
        }
        !self.changed.is_empty()
    }

    fn reduce(&mut self, piece: usize) {
        let Piece { places, vertices } = &mut self.pieces[piece];
        self.runs.clear();
        let length = drop_superfluous(vertices, &mut self.changed, &mut self.runs);
        vertices.truncate(length);
        for run in &self.runs {
            places.drain(run.first as usize..(run.first + run.count) as usize);
        }
        debug_assert_eq!(places.len(), length);
    }

    /// Breaks a piece wherever that takes fewer indices, and inserts the remainder as new pieces behind it.
    fn break_up(&mut self, piece: usize) {
        let mut at = piece;
        while let Some((end, next)) = find_break(&self.pieces[at].vertices) {
            let left = &mut self.pieces[at];
            let right =
                Piece { places: left.places.split_off(next), vertices: left.vertices.split_off(next) };
            left.places.truncate(end);
            left.vertices.truncate(end);
            at += 1;
            self.pieces.insert(at, right);
        }
    }
}

/// Finds where a piece is worth breaking: the end of the first part, and the even index where the second
/// begins.
fn find_break(vertices: &[u32]) -> Option<(usize, usize)> {
    let is_shown = |w: &[u32]| w[0] != w[1] && w[1] != w[2] && w[2] != w[0];
    let mut end = None;
    for (i, _) in vertices.windows(3).enumerate().filter(|(_, w)| is_shown(w)) {
        // Only an even index keeps the winding of what follows.
        let next = i & !1;
        match end {
            Some(end) if next >= end + LEAST_SAVED => return Some((end, next)),
            _ => end = Some(i + 3),
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{PositionIndex, SequenceParts};

    #[test]
    fn a_break_keeps_the_winding_and_saves_indices() {
        assert_eq!(find_break(&[0, 1, 2, 3, 4]), None);
        // Triangles 0 1 2 and 7 8 9 with degenerate ones between: the second begins at an even index, or
        // one earlier.
        assert_eq!(find_break(&[0, 1, 2, 2, 2, 7, 7, 8, 9]), Some((3, 6)));
        assert_eq!(find_break(&[0, 1, 2, 2, 7, 7, 8, 9]), None);
        assert_eq!(find_break(&[0, 1, 2, 2, 2, 2, 7, 7, 8, 9]), Some((3, 6)));
        assert_eq!(find_break(&[0, 1, 2, 2, 7, 8, 9]), None);
    }

    #[test]
    fn a_history_ends_at_the_base() {
        // 4 -> 3, then 3 -> 2: the strip loses its triangles from the far end.
        let sequence = CollapseSequence::from_parts(SequenceParts {
            positions: PositionIndex::identity(5),
            base_position_count: 3,
            targets: vec![2, 3],
            errors: vec![1.0, 0.5],
            removed_triangle_counts: vec![1, 1],
            triangle_count: 3,
        })
        .unwrap();
        let mut history = StripHistory::new(&sequence, &[0, 1, 2, 3, 4]);
        assert_eq!(history.coarsen(), Some(Touch { step: 1, drops: true }));
        assert_eq!(history.pieces()[0].vertices, [0, 1, 2, 3]);
        assert_eq!(history.coarsen(), Some(Touch { step: 0, drops: true }));
        assert_eq!(history.pieces()[0].places, [0, 1, 2]);
        assert_eq!(history.coarsen(), None);
    }
}
