//! What one instance of LodStrips owns, and how it moves between levels.

use super::LodStrips;
use super::record::{HAS_DROPS, RecordReader};
use crate::model::StripModel;
use crate::model::record_arena::{record_at, record_before};
use crate::model::strip_run::{Run, drop_run, restore_run};

/// An instance: its level and its current strips. Made by [`LodModel::new_state`](crate::model::LodModel).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LodStripsState {
    split_count: usize,
    /// End of the record of step `split_count - 1` in the arena, where that of step `split_count` begins.
    cursor: usize,
    /// All strips in fixed slots of their full length; see the drawing in the [module](super).
    pub(super) slots: Vec<u32>,
    pub(super) strips: Vec<LiveStrip>,
    /// Strips that changed since a buffer last followed them, each once.
    changed: Vec<u32>,
    /// Kept between steps so that none allocates.
    drops: Vec<Run>,
}

/// One strip of an instance; all that a step needs of it lies together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LiveStrip {
    /// Where its slot begins.
    pub(super) first: u32,
    /// Live indices.
    pub(super) length: u32,
    is_changed: bool,
}

impl LodStripsState {
    pub(super) fn new(model: &LodStrips<'_>) -> Self {
        let strip = |w: &[u32]| LiveStrip { first: w[0], length: w[1] - w[0], is_changed: false };
        Self {
            split_count: model.record_lengths.len(),
            cursor: model.arena.len(),
            slots: model.indices.to_vec(),
            strips: model.offsets.windows(2).map(strip).collect(),
            // Room for all, so that no move allocates.
            changed: Vec::with_capacity(model.strip_count()),
            drops: Vec::with_capacity(16),
        }
    }

    /// The level it shows.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Bytes that the instance owns.
    pub fn bytes(&self) -> usize {
        4 * (self.slots.len() + self.changed.capacity()) + size_of_val(&self.strips[..])
    }

    /// What a strip shows now.
    pub(super) fn live(&self, strip: usize) -> &[u32] {
        let LiveStrip { first, length, .. } = self.strips[strip];
        &self.slots[first as usize..(first + length) as usize]
    }

    /// Empties the list of changed strips into `strips`.
    pub(super) fn take_changed_into(&mut self, strips: &mut Vec<u32>) {
        strips.clear();
        std::mem::swap(&mut self.changed, strips);
        for &strip in strips.iter() {
            self.strips[strip as usize].is_changed = false;
        }
        // The lists change places: both must have room for all.
        self.changed.reserve(self.strips.len());
    }

    pub(super) fn move_to(&mut self, model: &LodStrips<'_>, split_count: usize) {
        let step_count = model.record_lengths.len();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert!(
            self.slots.len() == model.indices.len() && self.strips.len() == model.strip_count(),
            "the state belongs to another model"
        );
        while self.split_count > split_count {
            let done = self.coarsen(model);
            debug_assert!(done.is_some(), "a checked record ended early");
        }
        while self.split_count < split_count {
            let done = self.refine(model);
            debug_assert!(done.is_some(), "a checked record ended early");
        }
        // States at a level are equal, whatever way led there, once buffers have followed.
        self.drops.clear();
    }

    /// Applies the record of the step below: substitute, then drop. `None` would mean an unchecked record.
    fn coarsen(&mut self, model: &LodStrips<'_>) -> Option<()> {
        self.split_count -= 1;
        let step = self.split_count;
        let (body, start) = record_before(&model.arena, self.cursor, model.record_lengths[step])?;
        self.cursor = start;
        let vertices = model.vertices.of_step(step);
        let wedge_count = vertices.end - vertices.start;
        let target = model.vertices.target(vertices.start);
        let mut reader = RecordReader::new(body);
        let mut last = None;
        while !reader.is_empty() {
            let (strip, flags) = reader.head(last, model.head_bytes)?;
            last = Some(strip);
            let live = &mut self.strips[strip as usize];
            if !std::mem::replace(&mut live.is_changed, true) {
                self.changed.push(strip);
            }
            let further = reader.further_place_count(flags)?;
            let slot = &mut self.slots[live.first as usize..(live.first + live.length) as usize];
            let (first_place, wedge) = reader.place(0, wedge_count)?;
            slot[first_place as usize] =
                if wedge == 0 { target } else { model.vertices.target(vertices.start + wedge) };
            let mut place = first_place;
            for _ in 0..further {
                let (next, wedge) = reader.place(place + 1, wedge_count)?;
                slot[next as usize] = model.vertices.target(vertices.start + wedge);
                place = next;
            }
            if flags & HAS_DROPS != 0 {
                let mut anchor = first_place;
                loop {
                    let (run, follows) = reader.run(anchor)?;
                    drop_run(&mut slot[..live.length as usize], run);
                    live.length -= run.count;
                    anchor = run.first;
                    if !follows {
                        break;
                    }
                }
            }
        }
        Some(())
    }

    /// Undoes the record of the step above: restore what was dropped, then the step's vertices.
    fn refine(&mut self, model: &LodStrips<'_>) -> Option<()> {
        let step = self.split_count;
        let (body, end) = record_at(&model.arena, self.cursor, model.record_lengths[step])?;
        self.split_count += 1;
        self.cursor = end;
        let vertices = model.vertices.of_step(step);
        let wedge_count = vertices.end - vertices.start;
        let mut reader = RecordReader::new(body);
        let mut last = None;
        while !reader.is_empty() {
            let (strip, flags) = reader.head(last, model.head_bytes)?;
            last = Some(strip);
            let live = &mut self.strips[strip as usize];
            if !std::mem::replace(&mut live.is_changed, true) {
                self.changed.push(strip);
            }
            let further = reader.further_place_count(flags)?;
            let (first_place, first_wedge) = reader.place(0, wedge_count)?;
            // Places count in the strip before its drops: look at the drops first, then come back.
            let mut places = reader;
            for _ in 0..further {
                reader.place(0, wedge_count)?;
            }
            if flags & HAS_DROPS != 0 {
                let slot = &mut self.slots[live.first as usize..];
                let (run, follows) = reader.run(first_place)?;
                if follows {
                    read_runs(&mut reader, run, &mut self.drops)?;
                    for &run in self.drops.iter().rev() {
                        live.length += run.count;
                        restore_run(&mut slot[..live.length as usize], run);
                    }
                }
                live.length += run.count;
                restore_run(&mut slot[..live.length as usize], run);
            }
            let slot = &mut self.slots[live.first as usize..];
            slot[first_place as usize] = vertices.start + first_wedge;
            let mut place = first_place;
            for _ in 0..further {
                let (next, wedge) = places.place(place + 1, wedge_count)?;
                slot[next as usize] = vertices.start + wedge;
                place = next;
            }
        }
        Some(())
    }
}

/// Reads the runs behind `first`.
fn read_runs(reader: &mut RecordReader<'_>, first: Run, runs: &mut Vec<Run>) -> Option<()> {
    runs.clear();
    let mut anchor = first.first;
    loop {
        let (run, follows) = reader.run(anchor)?;
        anchor = run.first;
        runs.push(run);
        if !follows {
            return Some(());
        }
    }
}
