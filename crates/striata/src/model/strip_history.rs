//! One strip through all levels: what is left of it after each step that touches it.
//!
//! A strip is a row of places. Coarsening puts targets where removed vertices stand and drops places that have
//! become superfluous (see `superfluous.rs`); where only degenerate triangles lead from one shown triangle
//! to the next, and a new beginning takes fewer indices, the strip breaks into pieces. Places never come
//! back and keep their order, so at every level the strip is a rising selection of its places.
//!
//! ```text
//! places    0 1 2 3 4 5 6 7 8 9         a piece: 0 1 2 5 6 | another: 8 9 ..
//! ```
//!
//! Cost: linear in the places for each step that touches the strip.

use super::superfluous::drop_superfluous;
use crate::mesh::CollapseSequence;

/// Indices that a break must save to be worth its restart.
const LEAST_SAVED: usize = 2;

/// Places of a strip that are drawn in one go, each with the vertex that it shows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Piece {
    /// Places of the strip, rising.
    pub places: Vec<u32>,
    /// What each of them shows.
    pub vertices: Vec<u32>,
}

/// A step that touched the strip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Touch {
    /// The step.
    pub step: u32,
    /// Whether other places are left than before; else only vertices were substituted.
    pub drops: bool,
}

/// A strip that goes from the full mesh down to the base.
#[derive(Debug)]
pub struct StripHistory<'s> {
    sequence: &'s CollapseSequence,
    base_vertex_count: u32,
    pieces: Vec<Piece>,
    changed: Vec<u32>,
    runs: Vec<super::strip_run::Run>,
}

impl<'s> StripHistory<'s> {
    /// Of a strip of the full mesh.
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

    /// What is left, in the strip's order; none of the pieces is empty.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Takes the next step that touches the strip; `None` where no vertex above the base is left in it.
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

    /// Puts targets in a piece where vertices from `first` on stand; false where none does.
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

    /// Breaks a piece wherever that takes fewer indices; what follows becomes pieces behind it.
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

/// Where a piece is worth breaking: the end of what comes before, and the even place where what follows begins.
fn find_break(vertices: &[u32]) -> Option<(usize, usize)> {
    let is_shown = |w: &[u32]| w[0] != w[1] && w[1] != w[2] && w[2] != w[0];
    let mut end = None;
    for (i, _) in vertices.windows(3).enumerate().filter(|(_, w)| is_shown(w)) {
        // Only an even place keeps the winding of what follows.
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
        // 0 1 2 | 7 8 9 behind a stretch: the second begins at an even place, or one early.
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
