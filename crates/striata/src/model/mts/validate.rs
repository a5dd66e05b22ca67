//! Validates stored arrays, so that later moves neither fail nor miss a strip that has to be rebuilt.
//!
//! After each of its changes, what is left of a strip must fit into its slots. Every record is read in
//! both directions. Each slot is followed through its chain of targets for as long as it survives: the
//! step of every vertex that it shows must list the slot's strip.

use super::lifetimes::StripSlots;
use super::{Mts, MtsParts};
use crate::model::bits::PADDING;
use crate::model::{ModelError, StripModel};

pub(super) fn check(model: &Mts<'_>) -> Result<(), ModelError> {
    check_shape(model)?;
    let touches = Touches::of(model)?;
    (0..model.strip_count()).try_for_each(|strip| {
        let slots = model.strip_slots(strip);
        let fits = slots.check().and_then(|()| slots.check_touches(model, touches.of_strip(strip)));
        fits.map_err(|reason| ModelError::Strip { strip, reason })
    })
}

/// For each strip, the steps that change it in ascending order, each with the strip's change count after it.
struct Touches {
    /// Index of the first touch of each strip, followed by the number of touches.
    firsts: Vec<usize>,
    touches: Vec<(u32, u8)>,
}

impl Touches {
    /// Reads every record in both directions.
    fn of(model: &Mts<'_>) -> Result<Self, ModelError> {
        let mut firsts = vec![0; model.strip_count() + 1];
        for_each_record(model, |_, strip, _| firsts[strip + 1] += 1)?;
        for strip in 0..model.strip_count() {
            firsts[strip + 1] += firsts[strip];
        }
        let mut touches = vec![(0, 0); firsts[model.strip_count()]];
        let mut next = firsts.clone();
        for_each_record(model, |step, strip, drops| {
            touches[next[strip]] = (step, u8::from(drops));
            next[strip] += 1;
        })?;
        for (strip, w) in firsts.windows(2).enumerate() {
            let mut change = 0u8;
            for touch in touches[w[0]..w[1]].iter_mut().rev() {
                let reason = "changes too often";
                change = change.checked_add(touch.1).ok_or(ModelError::Strip { strip, reason })?;
                touch.1 = change;
            }
        }
        Ok(Self { firsts, touches })
    }

    fn of_strip(&self, strip: usize) -> &[(u32, u8)] {
        &self.touches[self.firsts[strip]..self.firsts[strip + 1]]
    }
}

impl StripSlots<'_> {
    /// Checks that what is left of the strip, including restarts, fits into its slots after every change.
    fn check(&self) -> Result<(), &'static str> {
        let breaks = self.breaks();
        if !breaks.is_sorted_by(|a, b| a[0] < b[0]) {
            return Err("has breaks out of order");
        }
        if breaks.last().is_some_and(|b| usize::from(b[0]) >= self.length) {
            return Err("has a break beyond its end");
        }
        let last_changes: Vec<u32> = self.last_changes().collect();
        let survives = |slot: usize, change: u8| last_changes[slot] >= u32::from(change);
        // Slots only disappear and breaks only appear, so the strip is fullest just after a break appears.
        for &[_, change] in breaks {
            let (mut length, mut from) = (0, 0);
            for &[slot, since] in breaks {
                let slot = usize::from(slot);
                length += (from..slot).filter(|&slot| survives(slot, change)).count();
                from = slot;
                length += usize::from(since <= change && survives(slot, change));
                if length > slot {
                    return Err("has a break where no slot has been dropped");
                }
            }
        }
        Ok(())
    }
}

impl StripSlots<'_> {
    /// Checks that the strip is rebuilt at every step that removes a vertex shown by one of its slots.
    fn check_touches(&self, model: &Mts<'_>, touches: &[(u32, u8)]) -> Result<(), &'static str> {
        let vertices = &model.vertices;
        for (slot, last) in self.last_changes().enumerate() {
            let mut vertex = self.indices.get(self.first + slot);
            while vertex >= vertices.base_vertex_count() {
                let step = vertices.step_of(vertex) as u32;
                let at = touches.partition_point(|touch| touch.0 < step);
                let change = touches.get(at).map_or(0, |touch| u32::from(touch.1));
                if last < change {
                    break;
                }
                if touches.get(at).is_none_or(|touch| touch.0 != step) {
                    return Err("is not listed by a step that removes one of its vertices");
                }
                vertex = model.target(vertex);
            }
        }
        Ok(())
    }
}

fn check_shape(model: &Mts<'_>) -> Result<(), ModelError> {
    let MtsParts { heads, arena, .. } = &model.parts;
    model.vertices.check(heads.len(), &model.targets)?;
    let (what, found, expected) = ("record bytes", arena.len(), model.record_bits.div_ceil(8) + PADDING);
    if found == expected { Ok(()) } else { Err(ModelError::Length { what, found, expected }) }
}

/// Visits the step, the strip and whether it loses slots, for all records; each must also be found from its
/// end.
fn for_each_record(model: &Mts<'_>, mut visit: impl FnMut(u32, usize, bool)) -> Result<(), ModelError> {
    let MtsParts { heads, arena, .. } = &model.parts;
    let strip_count = model.strip_count();
    let mut cursor = 0;
    for (step, &head) in heads.iter().enumerate() {
        let error = |reason| ModelError::Record { step, reason };
        let record = model.format.record_at(arena, cursor, head).ok_or(error("ends too early"))?;
        if model.format.record_before(arena, record.end, head) != Some(record) {
            return Err(error("has different lengths at its ends"));
        }
        cursor = record.end;
        let mut fits = true;
        let visited = model.format.for_each_strip(arena, record, |strip, drops| {
            if (strip as usize) < strip_count {
                visit(step as u32, strip as usize, drops);
            } else {
                fits = false;
            }
        });
        visited.ok_or(error("ends too early"))?;
        if !fits {
            return Err(error("changes a strip that does not exist"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::lifetimes;
    use super::super::record::{ChangedStrip, MtsRecordFormat};
    use super::*;
    use crate::mesh::{IndexedMesh, shapes};
    use crate::model::bits::Bits;
    use crate::simplify::{SequenceOptions, build_sequence};
    use crate::strip::stripify;

    fn model() -> Mts<'static> {
        model_of(&shapes::grid(8, 8))
    }

    fn model_of(mesh: &IndexedMesh) -> Mts<'static> {
        let built = build_sequence(mesh, &SequenceOptions::default()).unwrap();
        let strips = stripify(&built.refinable.mesh).unwrap();
        Mts::build(&built.refinable, &strips).unwrap()
    }

    fn checked(model: Mts<'static>, damage: impl FnOnce(&mut MtsParts<'static>)) -> Result<(), ModelError> {
        let Mts { vertices, targets, mut parts, .. } = model;
        damage(&mut parts);
        Mts::from_parts(vertices, targets, parts).map(drop)
    }

    /// The strips that each step changes.
    fn changed_strips(model: &Mts<'_>) -> Vec<Vec<ChangedStrip>> {
        let mut steps = vec![Vec::new(); model.parts.heads.len()];
        for_each_record(model, |step, strip, drops| steps[step as usize].push((strip as u32, drops)))
            .unwrap();
        steps
    }

    /// Writes the records of all steps anew.
    fn set_changed_strips(parts: &mut MtsParts<'static>, steps: &[Vec<ChangedStrip>]) {
        let format = MtsRecordFormat::new(parts.strips.strip_count());
        let mut bits = Bits::default();
        parts.heads = steps.iter().map(|strips| format.write(strips, &mut bits)).collect();
        parts.arena = bits.into_padded().into();
    }

    /// Replaces the breaks of every strip.
    fn set_breaks(parts: &mut MtsParts<'static>, breaks: &[[u8; 2]], model: &Mts<'_>) {
        let mut bytes = Vec::new();
        for strip in 0..model.strip_count() {
            let slots = model.strip_slots(strip);
            let lifetimes: Vec<u32> = slots.last_changes().map(|last| last.wrapping_add(1)).collect();
            lifetimes::write(&lifetimes, breaks, &mut bytes);
        }
        lifetimes::finish(&mut bytes);
        parts.lifetimes = bytes.into();
    }

    #[test]
    fn a_built_model_is_valid() {
        assert_eq!(checked(model(), |_| ()), Ok(()));
        let (whole, steps) = (model(), changed_strips(&model()));
        checked(model(), |parts| {
            set_changed_strips(parts, &steps);
            assert_eq!(*parts, whole.parts);
        })
        .unwrap();
    }

    #[test]
    fn a_step_must_list_every_strip_that_shows_its_vertices() {
        let steps = changed_strips(&model());
        for step in 0..steps.len() {
            let mut fewer = steps.clone();
            assert!(!std::mem::take(&mut fewer[step]).is_empty(), "on a grid each step changes a strip");
            let found = checked(model(), |parts| set_changed_strips(parts, &fewer));
            // Which strip keeps the stale slot depends on the step.
            assert!(
                matches!(found, Err(ModelError::Strip { reason, .. }) if reason.contains("not listed")),
                "step {step}: {found:?}"
            );
        }
    }

    #[test]
    fn records_must_end_where_the_arena_ends() {
        let found = checked(model(), |parts| parts.arena = parts.arena[1..].to_vec().into());
        assert!(matches!(found, Err(ModelError::Record { .. } | ModelError::Length { .. })), "{found:?}");
        let found = checked(model(), |parts| parts.arena = [&parts.arena[..], &[0]].concat().into());
        assert!(matches!(found, Err(ModelError::Length { what: "record bytes", .. })), "{found:?}");
        let found = checked(model(), |parts| parts.heads.to_mut()[0] = 255);
        assert!(matches!(found, Err(ModelError::Record { step: 0, .. } | ModelError::Length { .. })));
        let found = checked(model(), |parts| parts.lifetimes = parts.lifetimes[1..].to_vec().into());
        assert!(matches!(found, Err(ModelError::Strip { reason: "has no room for its lifetimes", .. })));
    }

    #[test]
    fn breaks_must_lie_in_their_strip_where_slots_are_dropped() {
        let whole = model();
        let with_breaks = |at: &[[u8; 2]]| checked(model(), |parts| set_breaks(parts, at, &whole));
        let reason = |found| match found {
            Err(ModelError::Strip { strip: 0, reason }) => reason,
            other => panic!("{other:?}"),
        };
        assert_eq!(reason(with_breaks(&[[200, 0]])), "has a break beyond its end");
        assert_eq!(reason(with_breaks(&[[2, 0]])), "has a break where no slot has been dropped");
        for breaks in [[[3, 9], [2, 9]], [[2, 9], [2, 9]]] {
            assert_eq!(reason(with_breaks(&breaks)), "has breaks out of order");
        }
    }

    #[test]
    fn change_counts_must_fit_into_a_byte() {
        let whole = model_of(&shapes::grid(20, 20));
        let step_count = whole.parts.heads.len();
        assert!(step_count > usize::from(u8::MAX));
        // Each step drops slots of the first strip only.
        let found = checked(whole, |parts| set_changed_strips(parts, &vec![vec![(0, true)]; step_count]));
        assert_eq!(found, Err(ModelError::Strip { strip: 0, reason: "changes too often" }));
    }
}
