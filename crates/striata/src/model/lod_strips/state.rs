//! State of one LodStrips instance: its level and current strips, and how it moves between levels.

use std::ops::Range;

use super::LodStrips;
use super::changes::SlotChanges;
use super::record::{ARENA_PADDING, Drop, LONG, LongRecord, long_record_at, long_record_before};
use super::stage::Stage;
use crate::model::strip_run::{drop_run, restore_run};

/// An instance of the model: its level and its current strips. Created by
/// [`LodModel::new_state`](crate::model::LodModel::new_state).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LodStripsState {
    split_count: usize,
    /// Number of vertices of the level.
    vertex_count: u32,
    /// Arena offset between the records of the last refined vertex and of the next one.
    cursor: usize,
    /// The split counts that the current stage can show.
    levels: Range<usize>,
    current: StageStrips,
    /// The strips of each finer stage, at its coarsest level.
    finer: Vec<StageStrips>,
    pub(super) changes: SlotChanges,
}

/// The strips of one stage.
#[derive(Clone, Debug, PartialEq, Eq)]
struct StageStrips {
    /// Slots of all strips at their full lengths; see the drawing in the [module](super).
    slots: Vec<u32>,
    /// Number of live indices of each strip.
    lengths: Vec<u8>,
}

impl StageStrips {
    /// The strips of a stage at its finest level.
    fn new(stage: &Stage<'_>) -> Self {
        Self { slots: stage.strips.indices.to_vec(), lengths: stage.strips.lengths.to_vec() }
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
            vertex_count: model.vertices.vertex_count() as u32,
            cursor: model.arena.len() - ARENA_PADDING,
            levels: model.levels_of_stage(0),
            current: StageStrips::new(&model.stages[0]),
            finer: Vec::new(),
            changes: SlotChanges::none(most_slots),
        }
    }

    /// Returns the level that the instance shows.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Index of the stage whose strips the instance shows, 0 the finest.
    pub fn stage(&self) -> usize {
        self.finer.len()
    }

    /// Number of bytes that the instance owns. It grows with each stage that the instance enters on its way
    /// to the base, and shrinks again on its way back.
    pub fn bytes(&self) -> usize {
        let of_stage = |strips: &StageStrips| 4 * strips.slots.len() + strips.lengths.len();
        self.finer.iter().map(of_stage).sum::<usize>() + of_stage(&self.current) + self.changes.bytes()
    }

    /// Returns the live indices of a strip of the current stage.
    #[inline]
    pub(super) fn live(&self, stage: &Stage<'_>, strip: usize) -> &[u32] {
        let first = stage.strips.firsts()[strip] as usize;
        &self.current.slots[first..first + usize::from(self.current.lengths[strip])]
    }

    /// Lists the strips of the current stage that may have changed since the last call, and returns whether
    /// the stage itself is a new one, so that all have.
    pub(super) fn take_changed_into(&mut self, model: &LodStrips<'_>, strips: &mut Vec<u32>) -> bool {
        let is_new_stage = self.changes.is_new_stage;
        self.changes.take_strips_into(&model.stages[self.stage()], strips);
        is_new_stage
    }

    #[inline]
    pub(super) fn move_to(&mut self, model: &LodStrips<'_>, split_count: usize) {
        let vertex_count = model.vertices.count_at(split_count) as u32;
        if split_count < self.levels.start || split_count >= self.levels.end {
            self.change_stage(model, split_count);
        }
        self.move_within_stage(model, split_count, vertex_count);
    }

    /// Moves to a level of the current stage, which has this many vertices.
    #[inline]
    fn move_within_stage(&mut self, model: &LodStrips<'_>, split_count: usize, vertex_count: u32) {
        self.split_count = split_count;
        let done = if vertex_count < self.vertex_count {
            self.coarsen(model, vertex_count)
        } else {
            self.refine(model, vertex_count)
        };
        debug_assert!(done.is_some(), "a checked record ended early");
    }

    /// The stage whose strips the instance shows.
    #[inline]
    fn stage_of<'m, 'a>(&self, model: &'m LodStrips<'a>) -> &'m Stage<'a> {
        let stage = &model.stages[self.finer.len()];
        assert!(
            stage.strips.slot_count() == self.current.slots.len(),
            "the state belongs to a different model"
        );
        stage
    }

    /// Applies the records of all vertices down to a level of the current stage: substitutes, then drops.
    /// `None` would mean that a record was not validated.
    #[inline(never)]
    fn coarsen(&mut self, model: &LodStrips<'_>, vertex_count: u32) -> Option<()> {
        let stage = self.stage_of(model);
        let base = model.vertices.base_vertex_count();
        while self.vertex_count > vertex_count {
            self.vertex_count -= 1;
            let at = (self.vertex_count - base) as usize;
            let (head, target) = (*model.heads.get(at)?, model.targets.get(at));
            if head == LONG {
                self.coarsen_long(model, stage, target)?;
                continue;
            }
            let record = stage.format.record_before(&model.arena, self.cursor, head)?;
            self.cursor = record.start;
            record.for_each_slot(|slot| self.substitute(slot, target))?;
            record.for_each_drop(|drop| self.current.drop(stage.strips.firsts(), drop))?;
        }
        Some(())
    }

    #[cold]
    fn coarsen_long(&mut self, model: &LodStrips<'_>, stage: &Stage<'_>, target: u32) -> Option<()> {
        let LongRecord { start, edit, .. } = long_record_before(&model.arena, self.cursor)?;
        self.cursor = start;
        edit.slots.into_iter().try_for_each(|slot| self.substitute(slot, target))?;
        edit.drops.into_iter().try_for_each(|drop| self.current.drop(stage.strips.firsts(), drop))
    }

    /// Undoes the records of all vertices up to a level of the current stage: restores the dropped runs, then
    /// the vertices.
    #[inline(never)]
    fn refine(&mut self, model: &LodStrips<'_>, vertex_count: u32) -> Option<()> {
        let stage = self.stage_of(model);
        let base = model.vertices.base_vertex_count();
        while self.vertex_count < vertex_count {
            let vertex = self.vertex_count;
            self.vertex_count += 1;
            let head = *model.heads.get((vertex - base) as usize)?;
            if head == LONG {
                self.refine_long(model, stage, vertex)?;
                continue;
            }
            let record = stage.format.record_at(&model.arena, self.cursor, head)?;
            self.cursor = record.end;
            record.for_each_drop_reversed(|drop| self.current.restore(stage.strips.firsts(), drop))?;
            record.for_each_slot(|slot| self.substitute(slot, vertex))?;
        }
        Some(())
    }

    #[cold]
    fn refine_long(&mut self, model: &LodStrips<'_>, stage: &Stage<'_>, vertex: u32) -> Option<()> {
        let LongRecord { end, edit, .. } = long_record_at(&model.arena, self.cursor)?;
        self.cursor = end;
        let mut drops = edit.drops.into_iter().rev();
        drops.try_for_each(|drop| self.current.restore(stage.strips.firsts(), drop))?;
        edit.slots.into_iter().try_for_each(|slot| self.substitute(slot, vertex))
    }

    /// Writes a vertex to a slot.
    #[inline]
    fn substitute(&mut self, slot: u32, vertex: u32) -> Option<()> {
        self.changes.mark(slot);
        *self.current.slots.get_mut(slot as usize)? = vertex;
        Some(())
    }

    /// Enters the stage that shows a level.
    #[cold]
    fn change_stage(&mut self, model: &LodStrips<'_>, split_count: usize) {
        while split_count < self.levels.start {
            self.move_to_level_of_stage(model, self.levels.start);
            self.enter_coarser_stage(model);
        }
        while split_count >= self.levels.end {
            self.move_to_level_of_stage(model, self.levels.end - 1);
            self.return_to_finer_stage(model);
        }
    }

    fn move_to_level_of_stage(&mut self, model: &LodStrips<'_>, split_count: usize) {
        self.move_within_stage(model, split_count, model.vertices.count_at(split_count) as u32);
    }

    /// Collapses the step below the current stage: the next stage shows what is left with its own strips.
    fn enter_coarser_stage(&mut self, model: &LodStrips<'_>) {
        let next = StageStrips::new(&model.stages[self.stage() + 1]);
        self.finer.push(std::mem::replace(&mut self.current, next));
        self.enter_level(model, self.split_count - 1);
    }

    /// Refines the step above the current stage: the finer stage has waited at its coarsest level.
    fn return_to_finer_stage(&mut self, model: &LodStrips<'_>) {
        if let Some(finer) = self.finer.pop() {
            self.current = finer;
            self.enter_level(model, self.split_count + 1);
        }
    }

    /// Notes the level at which the instance has entered its current stage.
    fn enter_level(&mut self, model: &LodStrips<'_>, split_count: usize) {
        self.split_count = split_count;
        self.vertex_count = model.vertices.count_at(split_count) as u32;
        self.levels = model.levels_of_stage(self.stage());
        self.changes.enter_stage();
    }
}
