//! Checking stored arrays: whatever passes cannot make a later walk fail.
//!
//! What is left of a strip has to fit its slot after any of its changes, and every record is read once both ways.

use super::state::{Places, for_each_strip};
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
    check_records(model)?;
    (0..model.strip_count()).try_for_each(|strip| {
        model.places(strip).check().map_err(|reason| ModelError::Strip { strip, reason })
    })
}

impl Places<'_> {
    /// Whether what is left of the strip fits its slot after any change, breaks counted.
    fn check(&self) -> Result<(), &'static str> {
        if !self.breaks.is_sorted_by(|a, b| a[0] < b[0]) {
            return Err("has breaks out of order");
        }
        if self.breaks.last().is_some_and(|b| usize::from(b[0]) >= self.indices.len()) {
            return Err("has a break behind its end");
        }
        // Places only go and breaks only come, so it is fullest where one comes.
        for &[_, change] in self.breaks {
            let (mut length, mut from) = (0, 0);
            for &[place, since] in self.breaks {
                let place = usize::from(place);
                length += self.lasts[from..place].iter().filter(|&&last| last >= change).count();
                from = place;
                length += usize::from(since <= change && self.lasts[place] >= change);
                if length > place {
                    return Err("breaks where nothing was left out");
                }
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
        return Err(ModelError::Length { what: "places of a strip", found, expected: MAX_STRIP_INDICES });
    }
    length("strips with breaks", break_offsets.len(), offsets.len())?;
    length("last changes", lasts.len(), indices.len())
}

/// Reads every record both ways; the changes of each strip can be counted in a byte.
fn check_records(model: &Mts<'_>) -> Result<(), ModelError> {
    let MtsParts { record_lengths, arena, .. } = &model.parts;
    let mut changes = vec![0u8; model.strip_count()];
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
            let change = changes.get_mut(strip as usize);
            fits &= change.is_some_and(|n| n.checked_add(u8::from(drops)).map(|more| *n = more).is_some());
        })
        .ok_or(error("ends too early"))?;
        if !fits {
            return Err(error("changes a strip that is not there, or too often"));
        }
    }
    if cursor != arena.len() {
        return Err(ModelError::Length { what: "record bytes", found: cursor, expected: arena.len() });
    }
    Ok(())
}
