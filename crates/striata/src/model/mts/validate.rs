//! Validates stored arrays, so that later moves neither fail nor miss a strip that has to be rebuilt.
//!
//! After each of its changes, what is left of a strip must fit into its slots. Every record is read in
//! both directions. Each slot is followed through its chain of targets for as long as it survives: the
//! step of every vertex that it shows must list the slot's strip.

use super::state::{StripSlots, for_each_strip};
use super::{MAX_STRIP_INDICES, Mts, MtsParts};
use crate::model::record_arena::{record_at, record_before};
use crate::model::{ModelError, StripModel};
use crate::strip::check_offsets;

pub(super) fn check(model: &Mts<'_>) -> Result<(), ModelError> {
    check_shape(model)?;
    model.vertices.check(model.parts.record_lengths.len())?;
    let vertex_count = model.vertices.vertex_count;
    for strip in 0..model.strip_count() {
        let range = model.parts.offsets[strip] as usize..model.parts.offsets[strip + 1] as usize;
        if let Some(&vertex) = model.parts.indices[range].iter().find(|&&v| v as usize >= vertex_count) {
            return Err(ModelError::Vertex { strip, vertex, vertex_count });
        }
    }
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
        if !self.breaks.is_sorted_by(|a, b| a[0] < b[0]) {
            return Err("has breaks out of order");
        }
        if self.breaks.last().is_some_and(|b| usize::from(b[0]) >= self.indices.len()) {
            return Err("has a break beyond its end");
        }
        // Slots only disappear and breaks only appear, so the strip is fullest just after a break appears.
        for &[_, change] in self.breaks {
            let (mut length, mut from) = (0, 0);
            for &[slot, since] in self.breaks {
                let slot = usize::from(slot);
                length += self.lasts[from..slot].iter().filter(|&&last| last >= change).count();
                from = slot;
                length += usize::from(since <= change && self.lasts[slot] >= change);
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
        for (&index, &last) in self.indices.iter().zip(self.lasts) {
            let mut vertex = index;
            while vertex >= vertices.base_vertex_count {
                let step = vertices.step_of(vertex) as u32;
                let at = touches.partition_point(|touch| touch.0 < step);
                let change = touches.get(at).map_or(0, |touch| touch.1);
                if last < change {
                    break;
                }
                if touches.get(at).is_none_or(|touch| touch.0 != step) {
                    return Err("is not listed by a step that removes one of its vertices");
                }
                vertex = vertices.target(vertex);
            }
        }
        Ok(())
    }
}

fn check_shape(model: &Mts<'_>) -> Result<(), ModelError> {
    let MtsParts { indices, offsets, group_offsets, lasts, break_offsets, breaks, .. } = &model.parts;
    check_offsets("strip", offsets, indices.len())?;
    check_offsets("group", group_offsets, offsets.len().saturating_sub(1))?;
    check_offsets("break", break_offsets, breaks.len())?;
    let length = |what, found, expected| {
        if found == expected { Ok(()) } else { Err(ModelError::Length { what, found, expected }) }
    };
    if let Some(found) = offsets.windows(2).map(|w| (w[1] - w[0]) as usize).find(|&n| n > MAX_STRIP_INDICES) {
        return Err(ModelError::Length { what: "slots of a strip", found, expected: MAX_STRIP_INDICES });
    }
    length("strips with breaks", break_offsets.len(), offsets.len())?;
    length("last changes", lasts.len(), indices.len())
}

/// Visits the step, the strip and whether it loses slots, for all records; the lengths at both ends must
/// agree.
fn for_each_record(model: &Mts<'_>, mut visit: impl FnMut(u32, usize, bool)) -> Result<(), ModelError> {
    let MtsParts { record_lengths, arena, .. } = &model.parts;
    let strip_count = model.strip_count();
    let mut cursor = 0;
    for (step, &length) in record_lengths.iter().enumerate() {
        let error = |reason| ModelError::Record { step, reason };
        let (body, end) = record_at(arena, cursor, length).ok_or(error("ends too early"))?;
        if record_before(arena, end, length) != Some((body, cursor)) {
            return Err(error("has different lengths at its ends"));
        }
        cursor = end;
        let mut fits = true;
        for_each_strip(body, model.head_bytes, |strip, drops| {
            if (strip as usize) < strip_count {
                visit(step as u32, strip as usize, drops);
            } else {
                fits = false;
            }
        })
        .ok_or(error("ends too early"))?;
        if !fits {
            return Err(error("changes a strip that does not exist"));
        }
    }
    if cursor != arena.len() {
        return Err(ModelError::Length { what: "record bytes", found: cursor, expected: arena.len() });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{IndexedMesh, shapes};
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
        let Mts { vertices, mut parts, .. } = model;
        damage(&mut parts);
        Mts::from_parts(vertices, parts).map(drop)
    }

    #[test]
    fn a_built_model_is_valid() {
        assert_eq!(checked(model(), |_| ()), Ok(()));
    }

    #[test]
    fn a_step_must_list_every_strip_that_shows_its_vertices() {
        let step_count = model().parts.record_lengths.len();
        for step in 0..step_count {
            let found = checked(model(), |parts| {
                let start: usize = parts.record_lengths[..step].iter().map(|&n| usize::from(n)).sum();
                let length = usize::from(std::mem::take(&mut parts.record_lengths.to_mut()[step]));
                assert!(length > 0, "on a grid each step changes a strip");
                parts.arena.to_mut().drain(start..start + length);
            });
            // Which strip keeps the stale slot depends on the step.
            assert!(
                matches!(found, Err(ModelError::Strip { reason, .. }) if reason.contains("not listed")),
                "step {step}: {found:?}"
            );
        }
    }

    #[test]
    fn breaks_must_lie_in_their_strip_where_slots_are_dropped() {
        let with_breaks = |at: &[[u8; 2]]| {
            checked(model(), |parts| {
                parts.breaks = at.to_vec().into();
                let strip_count = parts.offsets.len() - 1;
                parts.break_offsets = std::iter::once(0).chain(vec![at.len() as u32; strip_count]).collect();
            })
        };
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
    fn strip_lengths_and_change_counts_must_fit_into_a_byte() {
        let too_long = checked(model(), |parts| {
            let slot_count = parts.indices.len() as u32;
            assert!(slot_count as usize > MAX_STRIP_INDICES);
            parts.offsets = vec![0, slot_count].into();
            parts.group_offsets = vec![0, 1].into();
            parts.break_offsets = vec![0, 0].into();
            parts.breaks = Vec::new().into();
        });
        assert!(matches!(too_long, Err(ModelError::Length { what: "slots of a strip", .. })), "{too_long:?}");
        let found = checked(model_of(&shapes::grid(20, 20)), |parts| {
            let step_count = parts.record_lengths.len();
            assert!(step_count > usize::from(u8::MAX));
            // Each step drops slots of the first strip only.
            parts.record_lengths.to_mut().fill(1);
            parts.arena = vec![1; step_count].into();
        });
        assert_eq!(found, Err(ModelError::Strip { strip: 0, reason: "changes too often" }));
    }
}
