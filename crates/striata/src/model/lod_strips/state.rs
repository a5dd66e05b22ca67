//! State of one LodStrips instance: its level and current strips, and how it moves between levels.

use super::LodStrips;
use super::changes::Changes;
use super::record::{ARENA_PADDING, Drop};
use super::stage::Stage;
use crate::model::strip_run::{drop_run, restore_run};

/// An instance of the model: its level and its current strips. Created by
/// [`LodModel::new_state`](crate::model::LodModel::new_state).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LodStripsState {
    split_count: usize,
    /// Arena offset between the records of the last refined vertex and of the next one.
    cursor: usize,
    /// The strips of the current stage last; before them, those of each finer stage at its coarsest level.
    stages: Vec<LiveStrips>,
    pub(super) changes: Changes,
}

/// The strips of one stage.
#[derive(Clone, Debug, PartialEq, Eq)]
struct LiveStrips {
    /// Slots of all strips at their full lengths; see the drawing in the [module](super).
    slots: Vec<u32>,
    /// Number of live indices of each strip.
    lengths: Vec<u8>,
}

impl LiveStrips {
    /// The strips of a stage at its finest level.
    fn new(stage: &Stage<'_>) -> Self {
        Self { slots: stage.strips.indices.to_vec(), lengths: stage.strips.lengths.to_vec() }
    }

    /// Writes a vertex to a slot.
    #[inline]
    fn substitute(&mut self, slot: u32, vertex: u32) -> Option<()> {
        *self.slots.get_mut(slot as usize)? = vertex;
        Some(())
    }

    /// Drops a run of live indices.
    #[inline]
    fn drop(&mut self, firsts: &[u32], drop: Drop) -> Option<()> {
        let (first, length) = (*firsts.get(drop.strip as usize)?, self.lengths.get_mut(drop.strip as usize)?);
        let live = self.slots.get_mut(first as usize..first as usize + usize::from(*length))?;
        drop_run(live, drop.run);
        *length -= drop.run.count as u8;
        Some(())
    }

    /// Restores a dropped run.
    #[inline]
    fn restore(&mut self, firsts: &[u32], drop: Drop) -> Option<()> {
        let (first, length) = (*firsts.get(drop.strip as usize)?, self.lengths.get_mut(drop.strip as usize)?);
        *length += drop.run.count as u8;
        let live = self.slots.get_mut(first as usize..first as usize + usize::from(*length))?;
        restore_run(live, drop.run);
        Some(())
    }
}

impl LodStripsState {
    pub(super) fn new(model: &LodStrips<'_>) -> Self {
        let most_slots = model.stage_index_counts().max().unwrap_or(0);
        Self {
            split_count: model.vertices.step_count(),
            cursor: model.arena.len() - ARENA_PADDING,
            stages: vec![LiveStrips::new(&model.stages[0])],
            changes: Changes::none(most_slots),
        }
    }

    /// Returns the level that the instance shows.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Index of the stage whose strips the instance shows, 0 the finest.
    pub fn stage(&self) -> usize {
        self.stages.len() - 1
    }

    /// Number of bytes that the instance owns. It grows with each stage that the instance enters on its way
    /// to the base, and shrinks again on its way back.
    pub fn bytes(&self) -> usize {
        let of_stage = |strips: &LiveStrips| 4 * strips.slots.len() + strips.lengths.len();
        self.stages.iter().map(of_stage).sum::<usize>() + self.changes.bytes()
    }

    /// Returns the live indices of a strip of the current stage.
    #[inline]
    pub(super) fn live(&self, stage: &Stage<'_>, strip: usize) -> &[u32] {
        let current = &self.stages[self.stages.len() - 1];
        let first = stage.strips.firsts()[strip] as usize;
        &current.slots[first..first + usize::from(current.lengths[strip])]
    }

    /// Lists the strips of the current stage that may have changed since the last call, and returns whether
    /// the stage itself is a new one, so that all have.
    pub(super) fn take_changed_into(&mut self, model: &LodStrips<'_>, strips: &mut Vec<u32>) -> bool {
        let is_new_stage = self.changes.is_new_stage;
        self.changes.take_strips_into(&model.stages[self.stage()], strips);
        is_new_stage
    }

    pub(super) fn move_to(&mut self, model: &LodStrips<'_>, split_count: usize) {
        let step_count = model.vertices.step_count();
        assert!(split_count <= step_count, "split count {split_count} of {step_count}");
        let stage = model.stages.get(self.stage());
        assert!(
            stage.is_some_and(|stage| self.stages[self.stage()].slots.len() == stage.strips.slot_count()),
            "the state belongs to a different model"
        );
        while self.split_count > split_count {
            let last = split_count.max(model.coarsest_of_stage(self.stage()));
            let done = self.coarsen(model, last);
            debug_assert!(done.is_some(), "a checked record ended early");
            if self.split_count > split_count {
                self.enter_coarser_stage(model);
            }
        }
        while self.split_count < split_count {
            let finest = model.stages[self.stage()].split_count;
            let done = self.refine(model, split_count.min(finest));
            debug_assert!(done.is_some(), "a checked record ended early");
            if self.split_count < split_count {
                self.return_to_finer_stage();
            }
        }
    }

    /// Applies the records of all vertices down to a level of the current stage: substitutes, then drops.
    /// `None` would mean that a record was not validated.
    fn coarsen(&mut self, model: &LodStrips<'_>, split_count: usize) -> Option<()> {
        let [first, end] = [split_count, self.split_count].map(|count| model.vertices.count_at(count) as u32);
        self.split_count = split_count;
        let stage = model.stages.get(self.stages.len() - 1)?;
        let (strips, changes) = (self.stages.last_mut()?, &mut self.changes);
        let (firsts, base) = (stage.strips.firsts(), model.vertices.base_vertex_count());
        for vertex in (first..end).rev() {
            let record = stage.format.record_before(&model.arena, self.cursor, model.head(vertex))?;
            self.cursor = record.start();
            let target = model.targets.get((vertex - base) as usize);
            record.for_each_slot(|slot| {
                changes.mark(slot);
                strips.substitute(slot, target)
            })?;
            record.for_each_drop(|drop| strips.drop(firsts, drop))?;
        }
        Some(())
    }

    /// Undoes the records of all vertices up to a level of the current stage: restores the dropped runs, then
    /// the vertices.
    fn refine(&mut self, model: &LodStrips<'_>, split_count: usize) -> Option<()> {
        let [first, end] = [self.split_count, split_count].map(|count| model.vertices.count_at(count) as u32);
        self.split_count = split_count;
        let stage = model.stages.get(self.stages.len() - 1)?;
        let (strips, changes) = (self.stages.last_mut()?, &mut self.changes);
        let firsts = stage.strips.firsts();
        for vertex in first..end {
            let record = stage.format.record_at(&model.arena, self.cursor, model.head(vertex))?;
            self.cursor = record.end();
            record.for_each_drop_reversed(|drop| strips.restore(firsts, drop))?;
            record.for_each_slot(|slot| {
                changes.mark(slot);
                strips.substitute(slot, vertex)
            })?;
        }
        Some(())
    }

    /// Collapses the step below the current stage: the next stage shows what is left with its own strips.
    fn enter_coarser_stage(&mut self, model: &LodStrips<'_>) {
        self.split_count -= 1;
        self.stages.push(LiveStrips::new(&model.stages[self.stages.len()]));
        self.changes.enter_stage();
    }

    /// Refines the step above the current stage: the finer stage has waited at its coarsest level.
    fn return_to_finer_stage(&mut self) {
        self.split_count += 1;
        self.stages.pop();
        self.changes.enter_stage();
    }
}
