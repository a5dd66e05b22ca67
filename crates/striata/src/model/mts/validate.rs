//! Checking stored arrays: whatever passes cannot make a later walk fail.
//!
//! Every strip is short enough, and is walked at each of its changes, so that arcs are known to lead on inside the strip and to fit its slot,
//! and every record is read once, so that changes are known to be within what was walked.

use super::state::for_each_strip;
use super::{MAX_STRIP_INDICES, Mts, MtsParts};
use crate::model::ModelError;
use crate::model::StripModel;
use crate::model::record_arena::{record_at, record_before};
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
    let changes = check_records(model)?;
    let mut slot = Vec::new();
    for (strip, &last) in changes.iter().enumerate() {
        let graph = model.graph(strip);
        // Each change drops a place or breaks behind one; more would only cost time.
        if usize::from(last) > 2 * graph.indices.len() {
            return Err(ModelError::Graph { strip, reason: "cannot change any more", change: last.into() });
        }
        if let Some(row) = graph.rows.windows(2).position(|w| w[0] > w[1]) {
            return Err(ModelError::Graph { strip, reason: "has rows out of order", change: row });
        }
        slot.resize(graph.indices.len(), 0);
        for change in 0..=last {
            if graph.recover(change, &mut slot, |vertex| vertex).is_none() {
                return Err(ModelError::Graph { strip, reason: "does not end", change: change.into() });
            }
        }
    }
    Ok(())
}

fn check_shape(model: &Mts<'_>) -> Result<(), ModelError> {
    let MtsParts { indices, offsets, group_offsets, arc_offsets, rows, arcs, .. } = &model.parts;
    check_offsets("strip", offsets, indices.len())?;
    check_offsets("group", group_offsets, offsets.len().saturating_sub(1))?;
    check_offsets("arc", arc_offsets, arcs.len())?;
    let length = |what, found, expected| {
        if found == expected { Ok(()) } else { Err(ModelError::Length { what, found, expected }) }
    };
    length("strips of arcs", arc_offsets.len(), offsets.len())?;
    if let Some(found) = offsets.windows(2).map(|w| (w[1] - w[0]) as usize).find(|&n| n > MAX_STRIP_INDICES) {
        return Err(ModelError::Length { what: "places of a strip", found, expected: MAX_STRIP_INDICES });
    }
    length("rows", rows.len(), indices.len() + 2 * model.strip_count())
}

/// Reads every record both ways; returns how often each strip changes.
fn check_records(model: &Mts<'_>) -> Result<Vec<u16>, ModelError> {
    let MtsParts { record_lengths, arena, .. } = &model.parts;
    let mut changes = vec![0u16; model.strip_count()];
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
            fits &= change.is_some_and(|n| n.checked_add(u16::from(drops)).map(|more| *n = more).is_some());
        })
        .ok_or(error("ends too early"))?;
        if !fits {
            return Err(error("changes a strip that is not there, or too often"));
        }
    }
    if cursor != arena.len() {
        return Err(ModelError::Length { what: "record bytes", found: cursor, expected: arena.len() });
    }
    Ok(changes)
}
