//! How long the slots of a strip survive, and where the strip breaks, in a few bytes per strip.
//!
//! ```text
//! u8 width of a lifetime, in bits; u8 number of breaks
//! each break      u8 slot that it precedes; u8 change since which the strip breaks there
//! lifetimes       for each slot a bit: 1 if its lifetime is that of the slot before; else 0 and the lifetime
//!                 in `width` bits; lowest bit first, up to a whole byte
//! ```
//!
//! A lifetime is 0 if the slot is never dropped, else 1 + the last change that it survives; the slot before
//! the first one counts as 0. Slots are mostly dropped in pairs, so half of them take one bit.
//!
//! The entries of all strips follow each other; [`PADDING`] zero bytes end the last one.

use super::MAX_STRIP_INDICES;
use crate::model::bits::{Bits, PADDING, field, width_of};
use crate::model::packed_vertices::PackedVertices;
use crate::strip::RESTART;

/// Bytes of an entry before its breaks.
const HEAD_BYTES: usize = 2;

/// Lifetime of a slot that is never dropped.
pub(super) const NEVER_DROPPED: u32 = 0;

// Slots, and so changes, must be countable in a byte.
const _: () = assert!(MAX_STRIP_INDICES < u8::MAX as usize);

/// Appends the entry of a strip.
pub(super) fn write(lifetimes: &[u32], breaks: &[[u8; 2]], out: &mut Vec<u8>) {
    let width = width_of(u64::from(lifetimes.iter().copied().max().unwrap_or(0)) + 1);
    out.extend([width as u8, breaks.len() as u8]);
    out.extend_from_slice(breaks.as_flattened());
    let mut bits = Bits::default();
    let mut last = NEVER_DROPPED;
    for &lifetime in lifetimes {
        if lifetime == last {
            bits.push(1, 1);
        } else {
            bits.push(u64::from(lifetime) << 1, width + 1);
        }
        last = lifetime;
    }
    out.extend_from_slice(bits.as_bytes());
}

/// Ends the entries of all strips.
pub(super) fn finish(out: &mut Vec<u8>) {
    out.extend([0; PADDING]);
}

/// Returns the offset of each strip's entry, or the strip whose entry does not fit into the bytes.
pub(super) fn offsets(bytes: &[u8], lengths: &[u8]) -> Result<Vec<u32>, usize> {
    let mut at = 0;
    let mut offsets = Vec::with_capacity(lengths.len());
    for (strip, &length) in lengths.iter().enumerate() {
        offsets.push(u32::try_from(at).map_err(|_| strip)?);
        let entry = bytes.get(at..).ok_or(strip)?;
        let &[width, break_count] = entry.first_chunk().ok_or(strip)?;
        if u32::from(width) > u8::BITS {
            return Err(strip);
        }
        let start = HEAD_BYTES + 2 * usize::from(break_count);
        let mut lifetimes = Lifetimes { entry, bit: 8 * start, width: width.into(), last: NEVER_DROPPED };
        for _ in 0..length {
            lifetimes.next().ok_or(strip)?;
        }
        at += lifetimes.bit.div_ceil(8);
        if at + PADDING > bytes.len() {
            return Err(strip);
        }
    }
    if at + PADDING == bytes.len() { Ok(offsets) } else { Err(lengths.len()) }
}

/// The lifetimes of a strip's slots, in order; never ends.
struct Lifetimes<'m> {
    entry: &'m [u8],
    bit: usize,
    width: u32,
    last: u32,
}

impl Lifetimes<'_> {
    /// The next lifetime, or `None` if it lies beyond the padding.
    #[inline]
    fn next(&mut self) -> Option<u32> {
        let code = field(self.entry, self.bit, self.width + 1)? as u32;
        let is_new = code & 1 ^ 1;
        // A branch here would be unpredictable.
        self.last = std::hint::select_unpredictable(is_new != 0, code >> 1, self.last);
        self.bit += 1 + (is_new * self.width) as usize;
        Some(self.last)
    }
}

/// The slots of one strip with their lifetimes and breaks.
#[derive(Clone, Copy, Debug)]
pub(super) struct StripSlots<'m> {
    pub indices: &'m PackedVertices<'m>,
    /// Slot of its first index in `indices`.
    pub first: usize,
    pub length: usize,
    /// Its entry and what follows.
    pub entry: &'m [u8],
}

impl<'m> StripSlots<'m> {
    /// Breaks in ascending slot order: the slot that a break precedes, and the change since which it does.
    #[inline]
    pub(super) fn breaks(&self) -> &'m [[u8; 2]] {
        let count = usize::from(self.entry[1]);
        self.entry[HEAD_BYTES..HEAD_BYTES + 2 * count].as_chunks().0
    }

    /// For each slot the last change that it survives; the largest number if it is never dropped.
    #[inline]
    pub(super) fn last_changes(&self) -> impl Iterator<Item = u32> + 'm {
        let bit = 8 * (HEAD_BYTES + 2 * usize::from(self.entry[1]));
        let mut lifetimes =
            Lifetimes { entry: self.entry, bit, width: self.entry[0].into(), last: NEVER_DROPPED };
        (0..self.length).map(move |_| lifetimes.next().unwrap_or(NEVER_DROPPED).wrapping_sub(1))
    }

    /// Writes the indices that are left after `change` changes of the strip; returns their number.
    #[inline]
    pub(super) fn recover(&self, change: u8, slots: &mut [u32], shown: impl Fn(u32) -> u32) -> usize {
        let change = u32::from(change);
        let mut breaks = self.breaks().iter();
        let mut next_break = breaks.next();
        let mut length = 0;
        for (slot, last_change) in self.last_changes().enumerate() {
            let survives = last_change >= change;
            if let Some(&[_, since]) = next_break.filter(|found| usize::from(found[0]) == slot) {
                next_break = breaks.next();
                // Nothing may be left of the piece before. Otherwise the slot of the break follows the
                // restart, so it must survive.
                if u32::from(since) <= change && survives && length > 0 {
                    slots[length] = RESTART;
                    length += 1;
                }
            }
            // Every index is written and then kept or overwritten: a branch here would be unpredictable.
            slots[length] = shown(self.indices.get(self.first + slot));
            length += usize::from(survives);
        }
        length
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_read_back() {
        let strips: [(&[u32], &[[u8; 2]]); 3] =
            [(&[0, 3, 255, 255, 1, 0], &[[2, 1], [4, 9]]), (&[], &[]), (&[0, 0, 0], &[])];
        let mut bytes = Vec::new();
        strips.iter().for_each(|(lifetimes, breaks)| write(lifetimes, breaks, &mut bytes));
        finish(&mut bytes);
        let lengths = strips.map(|(lifetimes, _)| lifetimes.len() as u8);
        let starts = offsets(&bytes, &lengths).unwrap();
        // The first strip takes two single bits and four lifetimes of nine bits.
        assert_eq!(starts, [0, 2 + 4 + 5, 2 + 4 + 5 + 2]);
        let indices = PackedVertices::pack(&[7; 8], 8);
        for ((lifetimes, breaks), start) in strips.iter().zip(starts) {
            let entry = &bytes[start as usize..];
            let slots = StripSlots { indices: &indices, first: 0, length: lifetimes.len(), entry };
            assert_eq!(&slots.breaks(), breaks);
            let expected = lifetimes.iter().map(|&lifetime| lifetime.wrapping_sub(1));
            assert!(slots.last_changes().eq(expected));
        }
        for length in 0..bytes.len() {
            assert!(offsets(&bytes[..length], &lengths).is_err());
        }
        assert_eq!(offsets(&[&bytes[..], &[0]].concat(), &lengths), Err(3));
        bytes[0] = 9;
        assert_eq!(offsets(&bytes, &lengths), Err(0));
    }
}
