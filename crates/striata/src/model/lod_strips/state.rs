//! What one instance of LodStrips owns, and how it moves between levels.

use super::LodStrips;
use super::record::{HAS_DROPS, RecordReader, record_at, record_before};
use super::slot::{Run, drop_run, restore_run};

/// An instance: its level and its current strips. Made by [`LodModel::new_state`](crate::model::LodModel).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LodStripsState {
    split_count: usize,
    /// End of the record of step `split_count - 1` in the arena, where that of step `split_count` begins.
    cursor: usize,
    /// All strips in fixed slots of their full length; see the drawing in the [module](super).
    pub(super) slots: Vec<u32>,
    /// Live indices of each strip.
    pub(super) lengths: Vec<u32>,
    pub(super) changes: Changes,
    /// Kept between steps so that none allocates.
    drops: Vec<Run>,
}

/// Strips that changed since a buffer last followed them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Changes {
    strips: Vec<u32>,
    is_listed: Vec<bool>,
}

impl Changes {
    #[inline]
    fn add(&mut self, strip: usize) {
        if !self.is_listed[strip] {
            self.is_listed[strip] = true;
            self.strips.push(strip as u32);
        }
    }

    /// Empties the list into `strips`.
    pub(super) fn take_into(&mut self, strips: &mut Vec<u32>) {
        strips.clear();
        std::mem::swap(&mut self.strips, strips);
        for &strip in strips.iter() {
            self.is_listed[strip as usize] = false;
        }
    }
}

impl LodStripsState {
    pub(super) fn new(model: &LodStrips<'_>) -> Self {
        let strip_count = model.strip_count();
        Self {
            split_count: model.record_lengths.len(),
            cursor: model.arena.len(),
            slots: model.indices.to_vec(),
            lengths: model.offsets.windows(2).map(|w| w[1] - w[0]).collect(),
            // Room for all, so that no move allocates.
            changes: Changes { strips: Vec::with_capacity(strip_count), is_listed: vec![false; strip_count] },
            drops: Vec::with_capacity(16),
        }
    }

    /// The level it shows.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Bytes that the instance owns.
    pub fn bytes(&self) -> usize {
        4 * (self.slots.len() + self.lengths.len() + self.changes.strips.capacity())
            + self.changes.is_listed.len()
    }

    pub(super) fn move_to(&mut self, model: &LodStrips<'_>, split_count: usize) {
        let step_count = model.record_lengths.len();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        assert!(
            self.slots.len() == model.indices.len() && self.lengths.len() == model.strip_count(),
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
        // Equal states compare equal, whatever way led there.
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
            let (strip, flags) = match last {
                None => reader.first_head(model.head_bytes)?,
                Some(last) => reader.next_head(last)?,
            };
            last = Some(strip);
            let strip = strip as usize;
            let base = model.offsets[strip] as usize;
            let mut length = self.lengths[strip];
            let further = reader.further_place_count(flags)?;
            let slot = &mut self.slots[base..base + length as usize];
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
                    drop_run(&mut slot[..length as usize], run);
                    length -= run.count;
                    anchor = run.first;
                    if !follows {
                        break;
                    }
                }
                self.lengths[strip] = length;
            }
            self.changes.add(strip);
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
            let (strip, flags) = match last {
                None => reader.first_head(model.head_bytes)?,
                Some(last) => reader.next_head(last)?,
            };
            last = Some(strip);
            let strip = strip as usize;
            let base = model.offsets[strip] as usize;
            let further = reader.further_place_count(flags)?;
            let (first_place, first_wedge) = reader.place(0, wedge_count)?;
            // Places count in the strip before its drops: look at the drops first, then come back.
            let mut places = reader;
            for _ in 0..further {
                reader.place(0, wedge_count)?;
            }
            if flags & HAS_DROPS != 0 {
                let length = &mut self.lengths[strip];
                read_runs(&mut reader, first_place, &mut self.drops)?;
                for &run in self.drops.iter().rev() {
                    *length += run.count;
                    restore_run(&mut self.slots[base..base + *length as usize], run);
                }
            }
            let slot = &mut self.slots[base..];
            slot[first_place as usize] = vertices.start + first_wedge;
            let mut place = first_place;
            for _ in 0..further {
                let (next, wedge) = places.place(place + 1, wedge_count)?;
                slot[next as usize] = vertices.start + wedge;
                place = next;
            }
            self.changes.add(strip);
        }
        Some(())
    }
}

#[inline]
fn read_runs(reader: &mut RecordReader<'_>, mut anchor: u32, runs: &mut Vec<Run>) -> Option<()> {
    runs.clear();
    loop {
        let (run, follows) = reader.run(anchor)?;
        anchor = run.first;
        runs.push(run);
        if !follows {
            return Some(());
        }
    }
}
