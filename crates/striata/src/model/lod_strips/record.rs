//! The byte layout of a step's record, which lists the edits of each strip.
//!
//! A record is a list of edits, one per strip, in ascending order of strip indices:
//!
//! ```text
//! head           strip << 2 | flags             fixed width for the first strip of a record;
//!                (gap to the last - 1) << 2 | flags   a varint for later strips;
//!                                               flag 1: several substitutions, flag 2: has drops
//! count          number of substitutions - 2    varint, only with flag 1
//! substitutions  gap * wedges + wedge           varints; the first gap from 0, others from the last + 1
//! drops          zigzag(first - anchor) << 2 | kind   varints, only with flag 2;
//!                                               kind 1: another drop follows, kind 2: a length follows
//! length         length of the run              varint, only with kind 2; otherwise the length is 2
//! ```
//!
//! The first head is wide enough for the largest strip index. The anchor of the first drop is the index of
//! the first substitution; that of a later drop is the first index of the drop before it. `wedges` is the
//! number of vertices of the step, and `wedge` selects the one that is replaced. A varint has 7 bits per
//! byte, low bits first.

use crate::model::record_arena::{read_fixed, read_varint, write_varint};
use crate::model::strip_run::Run;

/// Number of flag bits next to each strip index in a record.
pub(super) const FLAG_BITS: u32 = 2;
pub(super) const HAS_SEVERAL_SUBSTITUTIONS: u32 = 1;
pub(super) const HAS_DROPS: u32 = 2;
const DROP_FOLLOWS: u32 = 1;
const COUNT_FOLLOWS: u32 = 2;

/// The edit of one strip by one step.
#[derive(Debug, Default)]
pub(super) struct Edit {
    pub(super) strip: u32,
    /// Live indices that are replaced, before any drop, in ascending order; each with the wedge found there.
    pub(super) substitutions: Vec<(u32, u32)>,
    pub(super) drops: Vec<Run>,
}

/// Number of edits in all records of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct EditCounts {
    /// Number of edited strips; a strip counts once for every record that edits it.
    pub strips: usize,
    /// Number of indices that are replaced.
    pub places: usize,
    /// Number of runs that are dropped.
    pub drops: usize,
}

impl EditCounts {
    /// Adds the edits of one record. Returns `None` if the record is malformed.
    pub(super) fn add(&mut self, body: &[u8], head_bytes: usize, wedge_count: u32) -> Option<()> {
        let mut reader = RecordReader::new(body);
        let mut last = None;
        while !reader.is_empty() {
            let (strip, flags) = reader.head(last, head_bytes)?;
            last = Some(strip);
            let further = reader.further_substitution_count(flags)?;
            for _ in 0..=further {
                reader.substitution(0, wedge_count)?;
            }
            self.strips += 1;
            self.places += further as usize + 1;
            let mut follows = flags & HAS_DROPS != 0;
            while follows {
                follows = reader.run(0)?.1;
                self.drops += 1;
            }
        }
        Some(())
    }
}

/// Appends the record of a step, given its edits in ascending order of strips.
pub(super) fn write_record<'e>(
    edits: impl IntoIterator<Item = &'e Edit>,
    wedge_count: u32,
    head_bytes: usize,
    out: &mut Vec<u8>,
) {
    let mut last_strip = None;
    for edit in edits {
        let several = if edit.substitutions.len() > 1 { HAS_SEVERAL_SUBSTITUTIONS } else { 0 };
        let flags = several | if edit.drops.is_empty() { 0 } else { HAS_DROPS };
        match last_strip {
            None => out.extend_from_slice(&(edit.strip << 2 | flags).to_le_bytes()[..head_bytes]),
            Some(last) => write_varint((edit.strip - last - 1) << 2 | flags, out),
        }
        last_strip = Some(edit.strip);
        if several != 0 {
            write_varint(edit.substitutions.len() as u32 - 2, out);
        }
        let mut from = 0;
        for &(index, wedge) in &edit.substitutions {
            write_varint((index - from) * wedge_count + wedge, out);
            from = index + 1;
        }
        let mut anchor = edit.substitutions.first().map_or(0, |s| s.0);
        for (i, run) in edit.drops.iter().enumerate() {
            let follows = if i + 1 < edit.drops.len() { DROP_FOLLOWS } else { 0 };
            let counted = if run.count == 2 { 0 } else { COUNT_FOLLOWS };
            write_varint(zigzag(run.first as i32 - anchor as i32) << 2 | counted | follows, out);
            if counted != 0 {
                write_varint(run.count, out);
            }
            anchor = run.first;
        }
    }
}

/// Maps signed to unsigned numbers so that those near zero stay small: 0, -1, 1, -2 become 0, 1, 2, 3.
fn zigzag(value: i32) -> u32 {
    (value << 1 ^ value >> 31) as u32
}

/// Reads a record piece by piece. All methods return `None` if the record is truncated or a number is too
/// large.
#[derive(Clone, Copy)]
pub(super) struct RecordReader<'r> {
    bytes: &'r [u8],
}

impl<'r> RecordReader<'r> {
    pub(super) fn new(bytes: &'r [u8]) -> Self {
        Self { bytes }
    }

    #[inline]
    pub(super) fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    /// Reads the next strip and its flags; `last` is the preceding strip of the record, if any.
    #[inline]
    pub(super) fn head(&mut self, last: Option<u32>, head_bytes: usize) -> Option<(u32, u32)> {
        match last {
            None => self.first_head(head_bytes),
            Some(last) => self.next_head(last),
        }
    }

    /// Reads the first strip of a record and its flags.
    #[inline]
    pub(super) fn first_head(&mut self, head_bytes: usize) -> Option<(u32, u32)> {
        let value = read_fixed(&mut self.bytes, head_bytes)?;
        Some((value >> 2, value & 3))
    }

    /// Reads a later strip of a record and its flags.
    #[inline]
    pub(super) fn next_head(&mut self, last: u32) -> Option<(u32, u32)> {
        let value = self.varint()?;
        Some((last.checked_add(value >> 2)?.checked_add(1)?, value & 3))
    }

    /// Reads the number of substitutions after the first.
    #[inline]
    pub(super) fn further_substitution_count(&mut self, flags: u32) -> Option<u32> {
        if flags & HAS_SEVERAL_SUBSTITUTIONS == 0 { Some(0) } else { self.varint()?.checked_add(1) }
    }

    /// Reads a substitution: the index that is replaced, at or after `from`, and the wedge found there.
    #[inline]
    pub(super) fn substitution(&mut self, from: u32, wedge_count: u32) -> Option<(u32, u32)> {
        let value = self.varint()?;
        let (gap, wedge) =
            if wedge_count == 1 { (value, 0) } else { (value / wedge_count, value % wedge_count) };
        Some((from.checked_add(gap)?, wedge))
    }

    /// Reads a dropped run, and whether another one follows.
    #[inline]
    pub(super) fn run(&mut self, anchor: u32) -> Option<(Run, bool)> {
        let value = self.varint()?;
        let code = value >> 2;
        let first = anchor.wrapping_add_signed((code >> 1) as i32 ^ -((code & 1) as i32));
        let count = if value & COUNT_FOLLOWS == 0 { 2 } else { self.varint()? };
        Some((Run { first, count }, value & DROP_FOLLOWS != 0))
    }

    #[inline]
    fn varint(&mut self) -> Option<u32> {
        read_varint(&mut self.bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::record_arena::head_bytes;

    #[test]
    fn a_record_reads_back() {
        let edits = [
            Edit { strip: 700, substitutions: vec![(3, 1), (4, 0), (900, 2)], drops: vec![] },
            Edit {
                strip: 703,
                substitutions: vec![(17, 2)],
                drops: vec![Run { first: 15, count: 2 }, Run { first: 40, count: 300 }],
            },
        ];
        let mut bytes = Vec::new();
        write_record(&edits, 3, head_bytes(1000, FLAG_BITS), &mut bytes);
        let mut reader = RecordReader::new(&bytes);
        assert_eq!(reader.first_head(2), Some((700, HAS_SEVERAL_SUBSTITUTIONS)));
        assert_eq!(reader.further_substitution_count(1), Some(2));
        assert_eq!(reader.substitution(0, 3), Some((3, 1)));
        assert_eq!(reader.substitution(4, 3), Some((4, 0)));
        assert_eq!(reader.substitution(5, 3), Some((900, 2)));
        assert_eq!(reader.next_head(700), Some((703, HAS_DROPS)));
        assert_eq!(reader.further_substitution_count(2), Some(0));
        assert_eq!(reader.substitution(0, 3), Some((17, 2)));
        assert_eq!(reader.run(17), Some((Run { first: 15, count: 2 }, true)));
        assert_eq!(reader.run(15), Some((Run { first: 40, count: 300 }, false)));
        assert!(reader.is_empty());
        assert_eq!(reader.run(0), None);
        let mut counts = EditCounts::default();
        assert_eq!(counts.add(&bytes, 2, 3), Some(()));
        assert_eq!(counts, EditCounts { strips: 2, places: 4, drops: 2 });
    }
}
