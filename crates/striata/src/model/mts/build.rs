//! Building the graphs: each strip goes down its history on its own, then the steps learn which strips they change.

use super::arcs::{Arc, REST};
use super::{MAX_STRIP_INDICES, Mts, MtsParts};
use crate::mesh::{CollapseSequence, RefinableMesh};
use crate::model::ModelError;
use crate::model::record_arena::{head_bytes, push_record, write_varint};
use crate::model::step_vertices::StepVertices;
use crate::model::strip_history::{Piece, StripHistory, Touch};
use crate::model::strip_input::{check_strips, sorted_by_place};
use crate::strip::StripSet;

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
        let mut graphs = Graphs::default();
        graphs.arc_offsets.push(0);
        for (number, strip) in strips.strips().enumerate() {
            graphs.push(sequence, number as u32, strip);
        }
        let (arena, record_lengths) = graphs.records(sequence.step_count(), strips.strip_count());
        let parts = MtsParts {
            indices: strips.indices().to_vec().into(),
            offsets: strips.offsets().to_vec().into(),
            group_offsets: strips.group_offsets().to_vec().into(),
            arc_offsets: graphs.arc_offsets.into(),
            rows: graphs.rows.into(),
            arcs: graphs.arcs.into(),
            record_lengths: record_lengths.into(),
            arena: arena.into(),
        };
        Ok(Self::unchecked(StepVertices::of_sequence(sequence).into_owned(), parts))
    }
}

/// The graphs of all strips so far.
#[derive(Debug, Default)]
struct Graphs {
    arc_offsets: Vec<u32>,
    rows: Vec<u16>,
    arcs: Vec<u32>,
    /// The strips that were touched, each with what touched it.
    touches: Vec<(u32, Touch)>,
    /// Rows of one strip, the beginnings first; kept from strip to strip.
    open: Vec<Vec<Arc>>,
}

impl Graphs {
    fn push(&mut self, sequence: &CollapseSequence, number: u32, strip: &[u32]) {
        let mut history = StripHistory::new(sequence, strip);
        self.open.iter_mut().for_each(Vec::clear);
        self.open.resize(self.open.len().max(strip.len() + 1), Vec::new());
        self.take(history.pieces(), 0);
        let mut change = 0;
        while let Some(touch) = history.coarsen() {
            self.touches.push((number, touch));
            if touch.drops {
                change += 1;
                self.take(history.pieces(), change);
            }
        }
        self.close(strip.len());
    }

    /// Takes what the strip is from one of its changes on.
    fn take(&mut self, pieces: &[Piece], change: u16) {
        // The row before the first place holds the beginnings.
        let mut at = 0;
        for (i, piece) in pieces.iter().enumerate() {
            for (j, &place) in piece.places.iter().enumerate() {
                let row = place as usize + 1;
                self.lead(at, Arc::new((row - at) as u32, i > 0 && j == 0), change);
                at = row;
            }
        }
        self.lead(at, Arc::END, change);
    }

    /// From `change` on the row leads where the arc says.
    fn lead(&mut self, row: usize, arc: Arc, change: u16) {
        let row = &mut self.open[row];
        match row.last_mut() {
            Some(last) if last.until(0) == arc.until(0) => return,
            // Arcs that no longer held before, while the place was gone from the strip, do no harm: nobody came by.
            Some(last) => *last = last.until(change - 1),
            None => {}
        }
        row.push(arc.until(REST));
    }

    /// Appends the rows of a strip with so many places.
    fn close(&mut self, place_count: usize) {
        let first = self.arcs.len();
        for row in &self.open[..=place_count] {
            self.rows.push((self.arcs.len() - first) as u16);
            if !matches!(row[..], [arc] if arc.until(0) == Arc::NEXT.until(0)) {
                self.arcs.extend(row.iter().map(|arc| arc.0));
            }
        }
        self.rows.push((self.arcs.len() - first) as u16);
        self.arc_offsets.push(self.arcs.len() as u32);
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
