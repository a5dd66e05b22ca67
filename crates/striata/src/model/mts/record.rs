//! The bit layout of the records that list the strips which a step changes.
//!
//! Each step has a **head** of one byte, from which the length of its record follows, so the records can be
//! walked in both directions without lengths of their own. Strips are listed in ascending order, each with a
//! flag: whether it loses slots, or only shows other vertices.
//!
//! ```text
//! head            number of strips | width << 4, or 255 for a long record
//! record          first strip, in as many bits as the largest one needs; flag
//!                 each further strip: gap to the last one, minus 1, in `width` bits; flag
//! long record     u32 number of strips; each strip: as many bits as the largest one needs; flag;
//!                 u32 number of strips again
//! ```

use crate::model::bits::{Bits, field, width_of};

/// Head of a long record.
pub(super) const LONG: u8 = u8::MAX;
/// Most strips of a short record.
const MAX_STRIPS: usize = 14;
/// Largest width of a gap, in bits.
const MAX_GAP_WIDTH: u32 = 15;
/// Bits of the number of strips in a long record.
const COUNT_BITS: u32 = 32;

/// A strip that a step changes, and whether the strip loses slots.
pub(super) type ChangedStrip = (u32, bool);

/// Layout of the records of a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MtsRecordFormat {
    /// Bits of a strip.
    strip_width: u32,
}

/// A record in the arena.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MtsRecord {
    /// First bit and the bit after the last.
    pub start: usize,
    pub end: usize,
    head: u8,
}

impl MtsRecordFormat {
    pub(super) fn new(strip_count: usize) -> Self {
        Self { strip_width: width_of(strip_count as u64) }
    }

    /// Bits of a short record.
    #[inline]
    fn short_bits(self, head: u8) -> usize {
        let (count, width) = (usize::from(head & 0xf), usize::from(head >> 4));
        if count == 0 { 0 } else { self.strip_width as usize + 1 + (count - 1) * (width + 1) }
    }

    fn long_bits(self, count: u64) -> Option<usize> {
        (count as usize).checked_mul(self.strip_width as usize + 1)?.checked_add(2 * COUNT_BITS as usize)
    }

    /// Finds the record that begins at bit `start`.
    #[inline]
    pub(super) fn record_at(self, arena: &[u8], start: usize, head: u8) -> Option<MtsRecord> {
        let bits = match head {
            LONG => self.long_bits(field(arena, start, COUNT_BITS)?)?,
            _ => self.short_bits(head),
        };
        Some(MtsRecord { start, end: start.checked_add(bits)?, head })
    }

    /// Finds the record that ends before bit `end`.
    #[inline]
    pub(super) fn record_before(self, arena: &[u8], end: usize, head: u8) -> Option<MtsRecord> {
        let bits = match head {
            LONG => self.long_bits(field(arena, end.checked_sub(COUNT_BITS as usize)?, COUNT_BITS)?)?,
            _ => self.short_bits(head),
        };
        Some(MtsRecord { start: end.checked_sub(bits)?, end, head })
    }

    /// Calls `visit` with each strip of a record. Returns `None` if the record exceeds the arena.
    #[inline]
    pub(super) fn for_each_strip(
        self,
        arena: &[u8],
        record: MtsRecord,
        mut visit: impl FnMut(u32, bool),
    ) -> Option<()> {
        let MtsRecord { start, end, head } = record;
        if head == LONG {
            let entries = start + COUNT_BITS as usize..end - COUNT_BITS as usize;
            for at in entries.step_by(self.strip_width as usize + 1) {
                let entry = field(arena, at, self.strip_width + 1)?;
                visit((entry >> 1) as u32, entry & 1 != 0);
            }
            return Some(());
        }
        if start == end {
            return Some(());
        }
        let entry = field(arena, start, self.strip_width + 1)?;
        let mut strip = (entry >> 1) as u32;
        visit(strip, entry & 1 != 0);
        let width = u32::from(head >> 4) + 1;
        for at in (start + self.strip_width as usize + 1..end).step_by(width as usize) {
            let entry = field(arena, at, width)?;
            strip = strip.checked_add((entry >> 1) as u32 + 1)?;
            visit(strip, entry & 1 != 0);
        }
        Some(())
    }

    /// Appends the record of a step, whose strips ascend, and returns its head.
    pub(super) fn write(self, strips: &[ChangedStrip], out: &mut Bits) -> u8 {
        let gaps = strips.windows(2).map(|w| u64::from(w[1].0 - w[0].0 - 1));
        let width = width_of(gaps.max().map_or(0, |gap| gap + 1));
        if strips.len() > MAX_STRIPS || width > MAX_GAP_WIDTH {
            self.write_long(strips, out);
            return LONG;
        }
        let mut last = None;
        for &(strip, drops) in strips {
            let (value, width) = match last {
                None => (strip, self.strip_width),
                Some(last) => (strip - last - 1, width),
            };
            out.push(u64::from(value) << 1 | u64::from(drops), width + 1);
            last = Some(strip);
        }
        strips.len() as u8 | (width as u8) << 4
    }

    fn write_long(self, strips: &[ChangedStrip], out: &mut Bits) {
        out.push(strips.len() as u64, COUNT_BITS);
        for &(strip, drops) in strips {
            out.push(u64::from(strip) << 1 | u64::from(drops), self.strip_width + 1);
        }
        out.push(strips.len() as u64, COUNT_BITS);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn records_read_back_from_both_ends() {
        let many: Vec<ChangedStrip> = (0..40).map(|i| (7 * i, i % 3 == 0)).collect();
        let records: [&[ChangedStrip]; 6] = [
            &[],
            &[(0, true)],
            &[(99_999, false)],
            &[(5, false), (6, true), (900, true)],
            &[(0, true), (70_000, false)],
            &many,
        ];
        let format = MtsRecordFormat::new(100_000);
        let mut bits = Bits::default();
        let heads: Vec<u8> = records.iter().map(|strips| format.write(strips, &mut bits)).collect();
        assert_eq!(heads.iter().filter(|&&head| head == LONG).count(), 2);
        let (end, arena) = (bits.len(), bits.into_padded());
        let mut at = 0;
        for (&expected, &head) in records.iter().zip(&heads) {
            let record = format.record_at(&arena, at, head).unwrap();
            assert_eq!(format.record_before(&arena, record.end, head), Some(record));
            let mut found = Vec::new();
            format.for_each_strip(&arena, record, |strip, drops| found.push((strip, drops))).unwrap();
            assert_eq!(found, expected);
            at = record.end;
        }
        assert_eq!(at, end);
    }

    #[test]
    fn a_single_strip_needs_no_bits() {
        let format = MtsRecordFormat::new(1);
        let mut bits = Bits::default();
        assert_eq!(format.write(&[(0, true)], &mut bits), 1);
        assert_eq!(bits.len(), 1);
    }
}
