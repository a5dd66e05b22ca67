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
/// Number of zero bytes after the last record, so that any number can be read with one 32-bit load.
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
    pub(super) strip: u32,
    pub(super) run: Run,
}

/// Everything that the collapse of a vertex changes in the strips.
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Edit {
    /// Slots of the vertex before any drop, ascending.
    pub(super) slots: Vec<u32>,
    /// In the order in which they are dropped.
    pub(super) drops: Vec<Drop>,
}

/// Number of bytes, at least 2, for numbers below `count`.
fn bytes_for(count: usize) -> usize {
    let bits = usize::BITS - count.saturating_sub(1).leading_zeros();
    (bits as usize).div_ceil(8).clamp(2, 4)
}

/// Reads a number of at most four bytes.
#[inline]
fn read(bytes: &[u8], at: usize, width: usize) -> Option<u32> {
    let word = u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?);
    Some(word & (u32::MAX >> (32 - 8 * width as u32)))
}

impl RecordFormat {
    pub(super) fn new(slot_count: usize, strip_count: usize) -> Self {
        Self { slot_bytes: bytes_for(slot_count), strip_bytes: bytes_for(strip_count) }
    }

    /// Bytes of a short record and of its substitutions.
    #[inline]
    fn short_bytes(self, head: u8) -> (usize, usize) {
        let (substitutions, drops) = counts(head);
        let of_slots = if substitutions == 0 { 0 } else { self.slot_bytes + 2 * (substitutions - 1) };
        (of_slots + drops * (self.strip_bytes + RUN_BYTES), of_slots)
    }

    /// Finds the record that begins at `start`; `None` if it exceeds the arena.
    #[inline]
    pub(super) fn record_at(self, arena: &[u8], start: usize, head: u8) -> Option<Record<'_>> {
        if head == LONG {
            let length = read(arena, start, 4)? as usize;
            return self.long_record(arena, start, start.checked_add(length)?);
        }
        let (length, of_slots) = self.short_bytes(head);
        Some(Record { format: self, arena, start, drops_at: start + of_slots, end: start + length, head })
    }

    /// Finds the record that ends at `end`; `None` if it exceeds the arena.
    #[inline]
    pub(super) fn record_before(self, arena: &[u8], end: usize, head: u8) -> Option<Record<'_>> {
        if head == LONG {
            let length = read(arena, end.checked_sub(4)?, 4)? as usize;
            return self.long_record(arena, end.checked_sub(length)?, end);
        }
        let (length, of_slots) = self.short_bytes(head);
        let start = end.checked_sub(length)?;
        Some(Record { format: self, arena, start, drops_at: start + of_slots, end, head })
    }

    #[cold]
    fn long_record(self, arena: &[u8], start: usize, end: usize) -> Option<Record<'_>> {
        let rest = end.checked_sub(start)?.checked_sub(LONG_FRAME_BYTES)?;
        if end + ARENA_PADDING > arena.len() {
            return None;
        }
        let substitutions = read(arena, start + 4, 4)? as usize;
        let of_drops = rest.checked_sub(substitutions.checked_mul(4)?)?;
        if !of_drops.is_multiple_of(LONG_DROP_BYTES) || read(arena, end - 4, 4)? as usize != end - start {
            return None;
        }
        let drops_at = start + 8 + 4 * substitutions;
        Some(Record { format: self, arena, start, drops_at, end, head: LONG })
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

/// A record in the arena.
#[derive(Clone, Copy, Debug)]
pub(super) struct Record<'m> {
    format: RecordFormat,
    arena: &'m [u8],
    start: usize,
    drops_at: usize,
    end: usize,
    head: u8,
}

impl Record<'_> {
    /// Offset of its first byte in the arena.
    #[inline]
    pub(super) fn start(&self) -> usize {
        self.start
    }

    /// Offset of the byte after its last.
    #[inline]
    pub(super) fn end(&self) -> usize {
        self.end
    }

    /// Number of substitutions and drops.
    pub(super) fn counts(&self) -> (usize, usize) {
        match self.head {
            LONG => {
                let of_drops = self.end - 4 - self.drops_at;
                ((self.drops_at - self.start - 8) / 4, of_drops / LONG_DROP_BYTES)
            }
            head => counts(head),
        }
    }

    /// Calls `substitute` with each slot, ascending. Returns `None` if a number exceeds the arena, or if
    /// `substitute` does.
    #[inline]
    pub(super) fn for_each_slot(&self, mut substitute: impl FnMut(u32) -> Option<()>) -> Option<()> {
        let Self { arena, start, head, .. } = *self;
        if head == LONG {
            return (start + 8..self.drops_at).step_by(4).try_for_each(|at| substitute(read(arena, at, 4)?));
        }
        let (count, _) = counts(head);
        if count == 0 {
            return Some(());
        }
        let width = self.format.slot_bytes;
        let mut slot = read(arena, start, width)?;
        substitute(slot)?;
        let first = start + width;
        for at in (first..self.drops_at).step_by(2) {
            slot = slot.checked_add(read(arena, at, 2)?)?;
            substitute(slot)?;
        }
        Some(())
    }

    /// Calls `edit` with each drop, in the order in which they are dropped.
    #[inline]
    pub(super) fn for_each_drop(&self, mut edit: impl FnMut(Drop) -> Option<()>) -> Option<()> {
        let (mut at, end, width) = self.drop_range();
        while at < end {
            edit(self.drop_at(at, width)?)?;
            at += width + RUN_BYTES;
        }
        Some(())
    }

    /// Calls `edit` with each drop, the last one first.
    #[inline]
    pub(super) fn for_each_drop_reversed(&self, mut edit: impl FnMut(Drop) -> Option<()>) -> Option<()> {
        let (start, mut at, width) = self.drop_range();
        while at > start {
            at -= width + RUN_BYTES;
            edit(self.drop_at(at, width)?)?;
        }
        Some(())
    }

    #[inline]
    fn drop_range(&self) -> (usize, usize, usize) {
        match self.head {
            LONG => (self.drops_at, self.end - 4, 4),
            _ => (self.drops_at, self.end, self.format.strip_bytes),
        }
    }

    #[inline]
    fn drop_at(&self, at: usize, width: usize) -> Option<Drop> {
        let strip = read(self.arena, at, width)?;
        let run = read(self.arena, at + width, RUN_BYTES)?;
        Some(Drop { strip, run: Run { first: run & 0xff, count: run >> 8 } })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drop(strip: u32, first: u32, count: u32) -> Drop {
        Drop { strip, run: Run { first, count } }
    }

    fn read_back(record: Record<'_>) -> Edit {
        let mut edit = Edit::default();
        record.for_each_slot(|slot| Some(edit.slots.push(slot))).unwrap();
        record.for_each_drop(|drop| Some(edit.drops.push(drop))).unwrap();
        let mut reversed = Vec::new();
        record.for_each_drop_reversed(|drop| Some(reversed.push(drop))).unwrap();
        reversed.reverse();
        assert_eq!(reversed, edit.drops);
        assert_eq!(record.counts(), (edit.slots.len(), edit.drops.len()));
        edit
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
            let end = arena.len();
            arena.extend([0; ARENA_PADDING]);
            let mut at = 0;
            for (edit, &head) in edits.iter().zip(&heads) {
                let record = format.record_at(&arena, at, head).unwrap();
                assert_eq!(&read_back(record), edit);
                at = record.end();
            }
            assert_eq!(at, end);
            for (edit, &head) in edits.iter().zip(&heads).rev() {
                let record = format.record_before(&arena, at, head).unwrap();
                assert_eq!(&read_back(record), edit);
                at = record.start();
            }
            assert_eq!(at, 0);
            assert_eq!((heads[4], heads[5] == LONG), (LONG, last > u32::from(u16::MAX)));
        }
    }

    #[test]
    fn truncated_records_are_noticed() {
        let format = RecordFormat::new(100, 10);
        let mut arena = Vec::new();
        let edit = Edit { slots: (0..40).collect(), drops: vec![drop(1, 2, 3)] };
        let head = format.write(&edit, &mut arena);
        let end = arena.len();
        arena.extend([0; ARENA_PADDING]);
        for length in 0..end {
            assert!(format.record_at(&arena[..length], 0, head).is_none());
            assert!(format.record_before(&arena[..length], end, head).is_none());
        }
        assert!(format.record_before(&arena, 3, head).is_none());
        assert!(format.record_before(&arena, 3, 1 | 1 << DROPS_SHIFT).is_none());
        let short = format.record_at(&arena[..5], 0, 3).unwrap();
        assert_eq!(short.for_each_slot(|_| Some(())), None);
    }
}
