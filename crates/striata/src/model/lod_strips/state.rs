//! State of one LodStrips instance: its level and current strips, and how it moves between levels.

use super::LodStrips;
use super::record::{HAS_DROPS, RecordReader};
use crate::model::StripModel;
use crate::model::record_arena::{record_at, record_before};
use crate::model::strip_run::{Run, drop_run, restore_run};

/// An instance of the model: its level and its current strips. Created by
/// [`LodModel::new_state`](crate::model::LodModel::new_state).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LodStripsState {
    split_count: usize,
    /// Arena offset between the records of steps `split_count - 1` and `split_count`.
    cursor: usize,
    /// Slots of all strips at their full lengths; see the drawing in the [module](super).
    pub(super) slots: Vec<u32>,
    pub(super) strips: Vec<LiveStrip>,
    /// Strips that changed since a buffer last synchronized, without duplicates.
    changed: Vec<u32>,
    /// Scratch, kept so that no step allocates.
    drops: Vec<Run>,
}

/// One strip of an instance. Everything that a step needs of it is in one struct, for locality.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LiveStrip {
    /// Index of its first slot.
    pub(super) first: u32,
    /// Number of live indices.
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

    /// Returns the level that the instance shows.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Number of bytes that the instance owns.
    pub fn bytes(&self) -> usize {
        4 * (self.slots.len() + self.changed.capacity()) + size_of_val(&self.strips[..])
    }

    /// Returns the live indices of a strip.
    pub(super) fn live(&self, strip: usize) -> &[u32] {
        let LiveStrip { first, length, .. } = self.strips[strip];
        &self.slots[first as usize..(first + length) as usize]
    }

    /// Moves the list of changed strips into `strips` and clears it here.
    pub(super) fn take_changed_into(&mut self, strips: &mut Vec<u32>) {
        strips.clear();
        std::mem::swap(&mut self.changed, strips);
        for &strip in strips.iter() {
            self.strips[strip as usize].is_changed = false;
        }
        // The two lists have been swapped, so both need room for all strips.
        self.changed.reserve(self.strips.len());
    }

    pub(super) fn move_to(&mut self, model: &LodStrips<'_>, split_count: usize) {
        let step_count = model.record_lengths.len();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert!(
            self.slots.len() == model.indices.len() && self.strips.len() == model.strip_count(),
            "the state belongs to a different model"
        );
        while self.split_count > split_count {
            let done = self.coarsen(model);
            debug_assert!(done.is_some(), "a checked record ended early");
        }
        while self.split_count < split_count {
            let done = self.refine(model);
            debug_assert!(done.is_some(), "a checked record ended early");
        }
        // Leaves no trace of the path, so that states of one level are equal once buffers have synchronized.
        self.drops.clear();
    }

    /// Applies the record of the step before: substitutes, then drops. `None` would mean that the record
    /// was not validated.
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
            let further = reader.further_substitution_count(flags)?;
            let slots = &mut self.slots[live.first as usize..(live.first + live.length) as usize];
            let (first_index, wedge) = reader.substitution(0, wedge_count)?;
            slots[first_index as usize] =
                if wedge == 0 { target } else { model.vertices.target(vertices.start + wedge) };
            let mut index = first_index;
            for _ in 0..further {
                let (next, wedge) = reader.substitution(index + 1, wedge_count)?;
                slots[next as usize] = model.vertices.target(vertices.start + wedge);
                index = next;
            }
            if flags & HAS_DROPS != 0 {
                let mut anchor = first_index;
                loop {
                    let (run, follows) = reader.run(anchor)?;
                    drop_run(&mut slots[..live.length as usize], run);
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

    /// Undoes the record of the next step: restores the dropped runs, then the step's vertices.
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
            let further = reader.further_substitution_count(flags)?;
            let (first_index, first_wedge) = reader.substitution(0, wedge_count)?;
            // Substitutions refer to the strip before its drops: skip them, restore the drops, then come
            // back.
            let mut substitutions = reader;
            for _ in 0..further {
                reader.substitution(0, wedge_count)?;
            }
            if flags & HAS_DROPS != 0 {
                let slots = &mut self.slots[live.first as usize..];
                let (run, follows) = reader.run(first_index)?;
                if follows {
                    read_runs(&mut reader, run, &mut self.drops)?;
                    for &run in self.drops.iter().rev() {
                        live.length += run.count;
                        restore_run(&mut slots[..live.length as usize], run);
                    }
                }
                live.length += run.count;
                restore_run(&mut slots[..live.length as usize], run);
            }
            let slots = &mut self.slots[live.first as usize..];
            slots[first_index as usize] = vertices.start + first_wedge;
            let mut index = first_index;
            for _ in 0..further {
                let (next, wedge) = substitutions.substitution(index + 1, wedge_count)?;
                slots[next as usize] = vertices.start + wedge;
                index = next;
            }
        }
        Some(())
    }
}

/// Reads the runs after `first` into `runs`.
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
