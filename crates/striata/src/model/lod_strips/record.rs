//! The byte layout of a record: where a vertex is replaced, and which runs of indices are dropped.
//!
//! Each vertex above the base has a record, for the strips of the stage in which it collapses. A **head** of
//! one byte, in an array of its own, holds both counts and therefore the length, so the arena can be walked
//! in both directions:
//!
//! ```text
//! head            substitutions | drops << 5, or 255 for a long record
//! record          first slot, in as many bytes as the slots of the stage need, at least 2
//!                 each further slot: distance from the last, u16
//!                 each drop: strip, in as many bytes as the strips of the stage need, at least 2;
//!                            u8 first index, u8 count
//! long record     u32 length, u32 number of substitutions
//!                 each slot: u32;  each drop: u32 strip, u8 first index, u8 count
//!                 u32 length again
//! ```
//!
//! A substitution names a slot of the instance and no strip, so applying it is a single store. Only drops
//! need to know where their strip begins and ends.

use crate::model::strip_run::Run;

/// Head of a long record.
pub(super) const LONG: u8 = u8::MAX;
/// Number of zero bytes after the last record, so that a drop can be read with one 64-bit load.
pub(super) const ARENA_PADDING: usize = 4;
/// Most substitutions of a short record.
const MAX_SUBSTITUTIONS: usize = 31;
/// Most drops of a short record; with 7 a head could be [`LONG`].
const MAX_DROPS: usize = 6;
/// Shift of the number of drops in a head.
const DROPS_SHIFT: u32 = 5;
/// Bytes of a drop besides its strip.
const RUN_BYTES: usize = 2;
/// Bytes of a drop in a long record.
const LONG_DROP_BYTES: usize = 4 + RUN_BYTES;
/// Bytes of a long record without its entries.
const LONG_FRAME_BYTES: usize = 12;

/// Widths of the numbers in the records of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct RecordFormat {
    /// Bytes of the first slot, 2 to 4.
    slot_bytes: usize,
    /// Bytes of a strip, 2 to 4.
    strip_bytes: usize,
}

/// A run of live indices that a record drops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Drop {
    pub strip: u32,
    pub run: Run,
}

/// Everything that the collapse of a vertex changes in the strips.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Edit {
    /// Slots of the vertex before any drop, ascending.
    pub slots: Vec<u32>,
    /// In the order in which they are dropped.
    pub drops: Vec<Drop>,
}

/// Number of bytes, at least 2, for numbers below `count`.
fn bytes_for(count: usize) -> usize {
    let bits = usize::BITS - count.saturating_sub(1).leading_zeros();
    (bits as usize).div_ceil(8).clamp(2, 4)
}

/// Reads a number of four bytes.
fn read(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?))
}

impl RecordFormat {
    pub(super) fn new(slot_count: usize, strip_count: usize) -> Self {
        Self { slot_bytes: bytes_for(slot_count), strip_bytes: bytes_for(strip_count) }
    }

    /// Bytes of the substitutions and of the drops of a short record.
    #[inline]
    fn short_bytes(self, head: u8) -> (usize, usize) {
        let (substitutions, drops) = counts(head);
        let of_slots = (self.slot_bytes + 2 * substitutions).wrapping_sub(2);
        (if substitutions == 0 { 0 } else { of_slots }, drops * (self.strip_bytes + RUN_BYTES))
    }

    /// Finds the short record that begins at `start`; `None` if it exceeds the arena.
    #[inline]
    pub(super) fn record_at(self, arena: &[u8], start: usize, head: u8) -> Option<StripRecord<'_>> {
        let (of_slots, of_drops) = self.short_bytes(head);
        self.record(arena, start, of_slots, of_drops)
    }

    /// Finds the short record that ends at `end`; `None` if it exceeds the arena.
    #[inline]
    pub(super) fn record_before(self, arena: &[u8], end: usize, head: u8) -> Option<StripRecord<'_>> {
        let (of_slots, of_drops) = self.short_bytes(head);
        self.record(arena, end.checked_sub(of_slots + of_drops)?, of_slots, of_drops)
    }

    #[inline]
    fn record(self, arena: &[u8], start: usize, of_slots: usize, of_drops: usize) -> Option<StripRecord<'_>> {
        let end = start + of_slots + of_drops;
        // The padding lets every number be read with one load.
        let (slots, drops) = arena.get(start..end + ARENA_PADDING)?.split_at_checked(of_slots)?;
        Some(StripRecord { start, end, slots, drops, format: self })
    }

    /// Appends the record of an edit and returns its head.
    pub(super) fn write(self, edit: &Edit, out: &mut Vec<u8>) -> u8 {
        let Edit { slots, drops } = edit;
        let are_near = slots.windows(2).all(|w| w[1] - w[0] <= u32::from(u16::MAX));
        if slots.len() > MAX_SUBSTITUTIONS || drops.len() > MAX_DROPS || !are_near {
            write_long(edit, out);
            return LONG;
        }
        let mut last = None;
        for &slot in slots {
            match last {
                None => out.extend_from_slice(&slot.to_le_bytes()[..self.slot_bytes]),
                Some(last) => out.extend(((slot - last) as u16).to_le_bytes()),
            }
            last = Some(slot);
        }
        for drop in drops {
            out.extend_from_slice(&drop.strip.to_le_bytes()[..self.strip_bytes]);
            out.extend([drop.run.first as u8, drop.run.count as u8]);
        }
        slots.len() as u8 | (drops.len() as u8) << DROPS_SHIFT
    }
}

/// Finds the long record that begins at `start`; `None` if it exceeds the arena or contradicts itself.
#[cold]
pub(super) fn long_record_at(arena: &[u8], start: usize) -> Option<LongRecord> {
    let length = read(arena, start)? as usize;
    long_record(arena, start, start.checked_add(length)?)
}

/// Finds the long record that ends at `end`; `None` if it exceeds the arena or contradicts itself.
#[cold]
pub(super) fn long_record_before(arena: &[u8], end: usize) -> Option<LongRecord> {
    let length = read(arena, end.checked_sub(4)?)? as usize;
    long_record(arena, end.checked_sub(length)?, end)
}

fn long_record(arena: &[u8], start: usize, end: usize) -> Option<LongRecord> {
    let rest = end.checked_sub(start)?.checked_sub(LONG_FRAME_BYTES)?;
    let of_slots = (read(arena, start.checked_add(4)?)? as usize).checked_mul(4)?;
    let of_drops = rest.checked_sub(of_slots)?;
    let length = (end - start) as u32;
    let lengths_agree = read(arena, start)? == length && read(arena, end - 4)? == length;
    if !lengths_agree || !of_drops.is_multiple_of(LONG_DROP_BYTES) {
        return None;
    }
    let (slots, drops) = arena.get(start + 8..end - 4)?.split_at_checked(of_slots)?;
    let drop = |bytes: &[u8; LONG_DROP_BYTES]| {
        let &[a, b, c, d, first, count] = bytes;
        let run = Run { first: first.into(), count: count.into() };
        Drop { strip: u32::from_le_bytes([a, b, c, d]), run }
    };
    let edit = Edit {
        slots: slots.as_chunks().0.iter().map(|&word| u32::from_le_bytes(word)).collect(),
        drops: drops.as_chunks().0.iter().map(drop).collect(),
    };
    Some(LongRecord { start, end, edit })
}

fn write_long(edit: &Edit, out: &mut Vec<u8>) {
    let length = LONG_FRAME_BYTES + 4 * edit.slots.len() + LONG_DROP_BYTES * edit.drops.len();
    let length = (length as u32).to_le_bytes();
    out.extend(length);
    out.extend((edit.slots.len() as u32).to_le_bytes());
    edit.slots.iter().for_each(|slot| out.extend(slot.to_le_bytes()));
    for drop in &edit.drops {
        out.extend(drop.strip.to_le_bytes());
        out.extend([drop.run.first as u8, drop.run.count as u8]);
    }
    out.extend(length);
}

/// Number of substitutions and drops of a short record.
#[inline]
fn counts(head: u8) -> (usize, usize) {
    (usize::from(head) & MAX_SUBSTITUTIONS, usize::from(head) >> DROPS_SHIFT)
}

/// A long record. There are few, so it is copied out of the arena.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct LongRecord {
    /// Offset of its first byte in the arena.
    pub start: usize,
    /// Offset of the byte after its last.
    pub end: usize,
    pub edit: Edit,
}

/// A short record in the arena.
#[derive(Clone, Copy, Debug)]
pub(super) struct StripRecord<'m> {
    /// Offset of its first byte in the arena.
    pub start: usize,
    /// Offset of the byte after its last.
    pub end: usize,
    /// Bytes of the substitutions.
    slots: &'m [u8],
    /// Bytes of the drops, and [`ARENA_PADDING`] more.
    drops: &'m [u8],
    format: RecordFormat,
}

impl StripRecord<'_> {
    /// Calls `substitute` with each slot, ascending. Returns `None` if `substitute` does, or if a slot has
    /// more than 32 bits.
    #[inline]
    pub(super) fn for_each_slot(&self, mut substitute: impl FnMut(u32) -> Option<()>) -> Option<()> {
        let width = self.format.slot_bytes;
        let Some((first, gaps)) = self.slots.split_at_checked(width) else { return Some(()) };
        let mut slot = u32::from(u16::from_le_bytes(*first.first_chunk()?));
        for (&byte, shift) in first[2..].iter().zip([16, 24]) {
            slot |= u32::from(byte) << shift;
        }
        substitute(slot)?;
        for &gap in gaps.as_chunks().0 {
            slot = slot.checked_add(u32::from(u16::from_le_bytes(gap)))?;
            substitute(slot)?;
        }
        Some(())
    }

    /// Calls `edit` with each drop, in the order in which they are dropped.
    #[inline]
    pub(super) fn for_each_drop(&self, mut edit: impl FnMut(Drop) -> Option<()>) -> Option<()> {
        let bytes = self.format.strip_bytes + RUN_BYTES;
        let mut rest = self.drops;
        while rest.len() > ARENA_PADDING {
            edit(self.drop_at(rest)?)?;
            rest = rest.get(bytes..)?;
        }
        Some(())
    }

    /// Calls `edit` with each drop, the last one first.
    #[inline]
    pub(super) fn for_each_drop_reversed(&self, mut edit: impl FnMut(Drop) -> Option<()>) -> Option<()> {
        let bytes = self.format.strip_bytes + RUN_BYTES;
        let mut at = self.drops.len() - ARENA_PADDING;
        while at > 0 {
            at = at.checked_sub(bytes)?;
            edit(self.drop_at(self.drops.get(at..)?)?)?;
        }
        Some(())
    }

    /// Reads the drop at the beginning of `bytes`.
    #[inline]
    fn drop_at(&self, bytes: &[u8]) -> Option<Drop> {
        let word = u64::from_le_bytes(*bytes.first_chunk()?);
        let bits = 8 * self.format.strip_bytes as u32;
        let run = (word >> bits) as u32;
        let strip = word as u32 & (u32::MAX >> (u32::BITS - bits));
        Some(Drop { strip, run: Run { first: run & 0xff, count: run >> 8 & 0xff } })
    }
}

/// Number of substitutions and drops of the record that begins at `start`, and its end.
pub(super) fn counts_at(
    format: RecordFormat,
    arena: &[u8],
    start: usize,
    head: u8,
) -> Option<(usize, usize, usize)> {
    if head == LONG {
        let LongRecord { edit, end, .. } = long_record_at(arena, start)?;
        return Some((edit.slots.len(), edit.drops.len(), end));
    }
    let (substitutions, drops) = counts(head);
    Some((substitutions, drops, format.record_at(arena, start, head)?.end))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drop(strip: u32, first: u32, count: u32) -> Drop {
        Drop { strip, run: Run { first, count } }
    }

    fn read_back(record: StripRecord<'_>) -> Edit {
        let mut edit = Edit::default();
        record
            .for_each_slot(|slot| {
                edit.slots.push(slot);
                Some(())
            })
            .unwrap();
        record
            .for_each_drop(|drop| {
                edit.drops.push(drop);
                Some(())
            })
            .unwrap();
        let mut reversed = Vec::new();
        record
            .for_each_drop_reversed(|drop| {
                reversed.push(drop);
                Some(())
            })
            .unwrap();
        reversed.reverse();
        assert_eq!(reversed, edit.drops);
        edit
    }

    /// Reads the record after `start` or the one before `end`; returns the edit and both ends.
    fn read_either(
        format: RecordFormat,
        arena: &[u8],
        from: Result<usize, usize>,
        head: u8,
    ) -> Option<(usize, usize, Edit)> {
        if head == LONG {
            let record = match from {
                Ok(start) => long_record_at(arena, start),
                Err(end) => long_record_before(arena, end),
            };
            return record.map(|LongRecord { start, end, edit }| (start, end, edit));
        }
        let record = match from {
            Ok(start) => format.record_at(arena, start, head),
            Err(end) => format.record_before(arena, end, head),
        };
        record.map(|record| (record.start, record.end, read_back(record)))
    }

    #[test]
    fn records_read_back_from_both_ends() {
        for (slot_count, strip_count) in [(900, 9), (70_000, 70_000), (1 << 25, 1 << 25)] {
            let format = RecordFormat::new(slot_count, strip_count);
            let last = slot_count as u32 - 1;
            let edits = [
                Edit::default(),
                Edit { slots: vec![last - 7, last], drops: vec![] },
                Edit { slots: vec![5], drops: vec![drop(8, 127, 1), drop(strip_count as u32 - 1, 0, 128)] },
                Edit { slots: (0..31).collect(), drops: vec![drop(1, 2, 3); 6] },
                Edit { slots: (0..32).collect(), drops: vec![drop(1, 2, 3); 7] },
                Edit { slots: vec![0, last], drops: vec![drop(1, 2, 3)] },
            ];
            let mut arena = Vec::new();
            let heads: Vec<u8> = edits.iter().map(|edit| format.write(edit, &mut arena)).collect();
            let length = arena.len();
            arena.extend([0; ARENA_PADDING]);
            let mut at = 0;
            for (expected, &head) in edits.iter().zip(&heads) {
                let (start, end, edit) = read_either(format, &arena, Ok(at), head).unwrap();
                assert_eq!((start, &edit), (at, expected));
                assert_eq!(read_either(format, &arena, Err(end), head), Some((start, end, edit)));
                let counts = (expected.slots.len(), expected.drops.len(), end);
                assert_eq!(counts_at(format, &arena, at, head), Some(counts));
                at = end;
            }
            assert_eq!(at, length);
            assert_eq!((heads[4], heads[5] == LONG), (LONG, last > u32::from(u16::MAX)));
        }
    }

    #[test]
    fn truncated_records_are_noticed() {
        let format = RecordFormat::new(100, 10);
        let mut arena = Vec::new();
        let edit = Edit { slots: (0..40).collect(), drops: vec![drop(1, 2, 3)] };
        assert_eq!(format.write(&edit, &mut arena), LONG);
        let end = arena.len();
        for length in 0..end {
            assert_eq!(long_record_at(&arena[..length], 0), None);
            assert_eq!(long_record_before(&arena[..length], end), None);
        }
        for wrong in [0, 4, end - 4] {
            let mut arena = arena.clone();
            arena[wrong] ^= 1;
            assert_eq!(long_record_at(&arena, 0), None);
        }
        assert!(format.record_before(&arena, 3, 1 | 1 << DROPS_SHIFT).is_none());
        assert!(format.record_at(&arena[..5 + ARENA_PADDING], 0, 3).is_none());
    }
}
