//! Validates a stored model once, so that later moves can trust its records.
//!
//! All records are applied once, from the full mesh to the base, to a copy of the strips. Every slot and run
//! must lie within the live part of a strip, every replaced vertex must be found at its slot, and it may not
//! be left over anywhere else. A model that passes can be moved up and down without failing, and each of its
//! levels uses only vertices of that level. The strips of each stage are read when the sweep arrives there, as
//! they show the triangles that the stage before it ends with. Takes the time of one full sweep and the memory
//! of one instance.

use std::borrow::Cow;

use super::record::{ARENA_PADDING, Drop, LONG, LongRecord, long_record_before};
use super::stage::{Stage, StageHead};
use super::walks::{self, Ground};
use super::{LodStrips, ModelError};
use crate::model::bits::PADDING;
use crate::model::stored_strips::StoredStrips;
use crate::model::strip_run::drop_run;

const TRUNCATED: &str = "ends too early";

/// Reads the later stages of a model that has only its first, and checks all records.
pub(super) fn read_stages<'a>(
    model: &mut LodStrips<'a>,
    later: &[StageHead],
    walks: Cow<'a, [u8]>,
) -> Result<(), ModelError> {
    check_shape(model, later)?;
    let (mut cursor, mut read) = (model.arena.len() - ARENA_PADDING, 0);
    for place in 0..=later.len() {
        let next = later.get(place);
        let coarsest = next.map_or(0, |next| next.split_count + 1);
        let stage = &model.stages[place];
        let mut sweep = LevelSweep::new(model, stage, cursor);
        let [first, end] = [coarsest, stage.split_count].map(|count| model.vertices.count_at(count) as u32);
        for vertex in (first..end).rev() {
            let step = model.vertices.step_of(vertex);
            sweep.apply(vertex).map_err(|reason| ModelError::Record { step, reason })?;
        }
        cursor = sweep.cursor;
        if let Some(next) = next {
            let ground = sweep.ground(next.split_count);
            let rest = walks.get(read..).unwrap_or_default();
            let (strips, length) = walks::read(ground, &next.strip_counts, rest).map_err(|reason| {
                let place = place + 1;
                ModelError::Listed { what: "stage", place, reason }
            })?;
            let vertex_count = model.vertices.count_at(next.split_count);
            let strips = StoredStrips::pack(&strips, vertex_count);
            let own = match &walks {
                Cow::Borrowed(walks) => walks[read..read + length].into(),
                Cow::Owned(walks) => walks[read..read + length].to_vec().into(),
            };
            read += length;
            model.stages.push(Stage::new(next.split_count, strips, own));
        }
    }
    if cursor != 0 {
        return Err(ModelError::Length { what: "record bytes left", found: cursor, expected: 0 });
    }
    let (found, expected) = (walks.len(), if later.is_empty() { 0 } else { read + PADDING });
    if found != expected {
        return Err(ModelError::Length { what: "bytes of walks", found, expected });
    }
    Ok(())
}

fn check_shape(model: &LodStrips<'_>, later: &[StageHead]) -> Result<(), ModelError> {
    let step_count = model.vertices.step_count();
    model.vertices.check(step_count, &model.targets)?;
    let (found, expected) = (model.heads.len(), model.targets.len());
    if found != expected {
        return Err(ModelError::Length { what: "record heads", found, expected });
    }
    if model.arena.len() < ARENA_PADDING {
        let (found, expected) = (model.arena.len(), ARENA_PADDING);
        return Err(ModelError::Length { what: "record bytes", found, expected });
    }
    check_stages(model, later)
}

/// Checks that stages follow each other from the full mesh down, and that all have the same groups.
fn check_stages(model: &LodStrips<'_>, later: &[StageHead]) -> Result<(), ModelError> {
    let group_count = model.full_strips().group_offsets.len() - 1;
    let mut above = model.vertices.step_count();
    for (place, stage) in later.iter().enumerate() {
        let reason = if stage.split_count >= above {
            "does not begin below the one before it"
        } else if stage.strip_counts.len() != group_count {
            "has other groups than the mesh"
        } else {
            above = stage.split_count;
            continue;
        };
        return Err(ModelError::Listed { what: "stage", place: place + 1, reason });
    }
    Ok(())
}

struct LevelSweep<'m, 'a> {
    model: &'m LodStrips<'a>,
    stage: &'m Stage<'a>,
    slots: Vec<u32>,
    lengths: Vec<u32>,
    /// Number of live indices that refer to each vertex.
    uses: Vec<u32>,
    cursor: usize,
}

impl<'m, 'a> LevelSweep<'m, 'a> {
    /// The strips of a stage at its finest level. Their vertices have been checked against that level.
    fn new(model: &'m LodStrips<'a>, stage: &'m Stage<'a>, cursor: usize) -> Self {
        let slots = stage.strips.indices.to_vec();
        let mut uses = vec![0; model.vertices.count_at(stage.split_count)];
        slots.iter().for_each(|&vertex| uses[vertex as usize] += 1);
        let lengths = stage.strips.lengths.iter().map(|&length| u32::from(length)).collect();
        Self { model, stage, slots, lengths, uses, cursor }
    }

    fn apply(&mut self, vertex: u32) -> Result<(), &'static str> {
        let Self { model, stage, .. } = *self;
        let target = model.targets.get((vertex - model.vertices.base_vertex_count()) as usize);
        if model.head(vertex) == LONG {
            // Both of its ends have been compared.
            let LongRecord { start, edit, .. } =
                long_record_before(&model.arena, self.cursor).ok_or("is truncated or contradicts itself")?;
            self.cursor = start;
            edit.slots.into_iter().try_for_each(|slot| self.substitute(slot, vertex, target))?;
            edit.drops.into_iter().try_for_each(|drop| self.drop(drop))?;
        } else {
            let record = stage.format.record_before(&model.arena, self.cursor, model.head(vertex));
            let record = record.ok_or(TRUNCATED)?;
            self.cursor = record.start;
            let mut reason = TRUNCATED;
            let mut checked = |result: Result<(), &'static str>| result.map_err(|found| reason = found).ok();
            record
                .for_each_slot(|slot| checked(self.substitute(slot, vertex, target)))
                .and_then(|()| record.for_each_drop(|drop| checked(self.drop(drop))))
                .ok_or(reason)?;
        }
        if self.uses[vertex as usize] != 0 {
            return Err("leaves a vertex of the step in a strip");
        }
        Ok(())
    }

    /// The triangles that the next stage begins with, one step below the last level of this one.
    fn ground(&self, split_count: usize) -> Ground {
        let (vertices, targets) = (&self.model.vertices, &self.model.targets);
        let base = vertices.base_vertex_count();
        let vertex_count = vertices.count_at(split_count);
        let after_step = |v: u32| if v < vertex_count as u32 { v } else { targets.get((v - base) as usize) };
        let strips = &self.stage.strips;
        let mut ground = Ground::new(vertex_count);
        for group in 0..strips.group_offsets.len() - 1 {
            for strip in strips.group_strips(group) {
                let first = strips.firsts()[strip] as usize;
                ground.add_strip(&self.slots[first..first + self.lengths[strip] as usize], after_step);
            }
            ground.end_group();
        }
        ground
    }

    fn substitute(&mut self, slot: u32, vertex: u32, target: u32) -> Result<(), &'static str> {
        let firsts = self.stage.strips.firsts();
        let strip = firsts.partition_point(|&first| first <= slot) - 1;
        if strip >= self.lengths.len() || slot - firsts[strip] >= self.lengths[strip] {
            return Err("replaces a vertex beyond the end of a strip");
        }
        let place = &mut self.slots[slot as usize];
        if *place != vertex {
            return Err("replaces a vertex at an index that holds a different one");
        }
        *place = target;
        self.uses[vertex as usize] -= 1;
        self.uses[target as usize] += 1;
        Ok(())
    }

    fn drop(&mut self, drop: Drop) -> Result<(), &'static str> {
        let Drop { strip, run } = drop;
        let Some(&length) = self.lengths.get(strip as usize) else {
            return Err("edits a strip that does not exist");
        };
        if run.count == 0 || run.first + run.count > length {
            return Err("drops a run beyond the end of a strip");
        }
        let first = self.stage.strips.firsts()[strip as usize] as usize;
        let live = &mut self.slots[first..first + length as usize];
        for &v in &live[run.first as usize..(run.first + run.count) as usize] {
            self.uses[v as usize] -= 1;
        }
        drop_run(live, run);
        self.lengths[strip as usize] = length - run.count;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::record::counts_at;
    use super::*;
    use crate::mesh::{RefinableMesh, shapes};
    use crate::model::lod_strips::{LodStripsParts, StageOptions};
    use crate::simplify::{SequenceOptions, build_sequence};
    use crate::strip::stripify;

    fn refinable() -> RefinableMesh {
        build_sequence(&shapes::grid(8, 8), &SequenceOptions::default()).unwrap().refinable
    }

    fn model() -> LodStrips<'static> {
        let refinable = refinable();
        LodStrips::build(&refinable, &stripify(&refinable.mesh).unwrap()).unwrap()
    }

    fn staged() -> LodStrips<'static> {
        let refinable = refinable();
        let strips = stripify(&refinable.mesh).unwrap();
        let stages = |level: &_| Ok::<_, ModelError>(stripify(level).unwrap());
        LodStrips::build_staged(&refinable, &strips, &StageOptions::default(), stages).unwrap()
    }

    fn checked(
        model: LodStrips<'static>,
        damage: impl FnOnce(&mut LodStripsParts<'static>),
    ) -> Result<(), ModelError> {
        let (later, walks) = model.later_stages();
        let LodStrips { vertices, targets, stages, heads, arena, .. } = model;
        let strips = stages.into_iter().next().unwrap().strips;
        let walks = if later.is_empty() { Vec::new() } else { walks }.into();
        let mut parts = LodStripsParts { strips, stages: later, walks, heads, arena };
        damage(&mut parts);
        LodStrips::from_parts(vertices, targets, parts).map(drop)
    }

    #[test]
    fn a_built_model_is_valid() {
        assert_eq!(checked(model(), |_| ()), Ok(()));
        assert!(staged().stages.len() > 1);
        assert_eq!(checked(staged(), |_| ()), Ok(()));
    }

    #[test]
    fn a_step_must_remove_its_vertices_from_every_strip() {
        let whole = model();
        let mut start = 0;
        for step in 0..whole.heads.len() {
            let (_, _, end) =
                counts_at(whole.stages[0].format, &whole.arena, start, whole.heads[step]).unwrap();
            let range = start..end;
            start = end;
            let found = checked(model(), |parts| {
                parts.heads.to_mut()[step] = 0;
                parts.arena.to_mut().drain(range);
            });
            let reason = "leaves a vertex of the step in a strip";
            assert_eq!(found, Err(ModelError::Record { step, reason }));
        }
    }

    #[test]
    fn records_must_fit_their_strips() {
        let last = model().heads.len() - 1;
        let damaged = |damage: fn(&mut [u8], usize)| {
            checked(model(), |parts| {
                let at = parts.arena.len() - ARENA_PADDING;
                damage(parts.arena.to_mut(), at);
            })
        };
        // The last byte of the arena is the count of a drop if the last record has drops.
        let found = damaged(|arena, end| arena[end - 1] = 255);
        assert!(matches!(found, Err(ModelError::Record { step, .. }) if step == last), "{found:?}");
        let found = checked(model(), |parts| parts.heads.to_mut()[last] = 255);
        let reason = "is truncated or contradicts itself";
        assert_eq!(found, Err(ModelError::Record { step: last, reason }));
        let found = checked(model(), |parts| parts.arena.to_mut().truncate(2));
        assert!(matches!(found, Err(ModelError::Length { what: "record bytes", found: 2, .. })), "{found:?}");
        let found = checked(model(), |parts| parts.arena.to_mut().splice(0..0, [0]).for_each(drop));
        assert!(matches!(found, Err(ModelError::Length { what: "record bytes left", found: 1, .. })));
    }

    #[test]
    fn heads_must_match_the_steps() {
        let found = checked(model(), |parts| parts.heads.to_mut().push(0));
        assert!(matches!(found, Err(ModelError::Length { what: "record heads", .. })), "{found:?}");
    }

    #[test]
    fn stages_must_descend_and_have_the_same_groups() {
        let last = staged().stages.len() - 1;
        let of_stage = |place: usize, damage: &dyn Fn(&mut StageHead)| {
            checked(staged(), |parts| damage(&mut parts.stages[place - 1]))
        };
        let not_below = |place| {
            let reason = "does not begin below the one before it";
            Err(ModelError::Listed { what: "stage", place, reason })
        };
        let step_count = staged().vertices.step_count();
        assert_eq!(of_stage(1, &|stage| stage.split_count = step_count), not_below(1));
        assert_eq!(of_stage(last, &|stage| stage.split_count = step_count), not_below(last));
        let reason = "has other groups than the mesh";
        let expected = Err(ModelError::Listed { what: "stage", place: 1, reason });
        assert_eq!(of_stage(1, &|stage| stage.strip_counts.push(0)), expected);
    }

    #[test]
    fn stages_must_show_their_level() {
        let refused = |damage: &dyn Fn(&mut LodStripsParts<'static>)| checked(staged(), damage).unwrap_err();
        let found = refused(&|parts| parts.stages[0].strip_counts[0] -= 1);
        assert!(matches!(found, ModelError::Listed { what: "stage", place: 1, .. }), "{found:?}");
        let found = refused(&|parts| parts.walks.to_mut().push(0));
        assert!(matches!(found, ModelError::Length { what: "bytes of walks", .. }), "{found:?}");
        let found = refused(&|parts| parts.walks.to_mut().clear());
        assert!(matches!(found, ModelError::Listed { what: "stage", place: 1, .. }), "{found:?}");
    }
}
