//! Variable-length records of all steps in one byte arena, which can be walked in both directions.
//!
//! A separate array stores the length of each record in one byte. A record of 255 bytes or more stores its
//! length at both of its ends instead. A varint has 7 bits per byte, low bits first.

/// Marks a record of 255 bytes or more, which stores its length in 4 bytes at both ends.
pub(super) const LONG_RECORD: u8 = u8::MAX;

/// Size of the first strip index in a record, including `flag_bits` bits of flags, in bytes.
pub(super) fn head_bytes(strip_count: usize, flag_bits: u32) -> usize {
    let largest = ((strip_count.saturating_sub(1) as u64 + 1) << flag_bits) - 1;
    (64 - largest.leading_zeros() as usize).div_ceil(8).min(4)
}

/// Reads a little-endian number of `count` bytes and advances the slice.
#[inline]
pub(super) fn read_fixed(bytes: &mut &[u8], count: usize) -> Option<u32> {
    let (head, rest) = bytes.split_at_checked(count)?;
    *bytes = rest;
    Some(head.iter().rev().fold(0, |value, &byte| value << 8 | u32::from(byte)))
}

/// Appends a varint.
pub(crate) fn write_varint(mut value: u32, out: &mut Vec<u8>) {
    while value >= 0x80 {
        out.push(value as u8 | 0x80);
        value >>= 7;
    }
    out.push(value as u8);
}

/// Reads a varint and advances the slice; `None` if it is truncated or exceeds 32 bits.
#[inline]
pub(crate) fn read_varint(bytes: &mut &[u8]) -> Option<u32> {
    let (&first, mut rest) = bytes.split_first()?;
    let mut value = u32::from(first & 0x7f);
    if first >= 0x80 {
        let mut shift = 7;
        loop {
            let (&byte, after) = rest.split_first()?;
            rest = after;
            let bits = u32::from(byte & 0x7f);
            // The fifth byte has room for 4 bits.
            if shift > 28 || (shift == 28 && bits > 0xf) {
                return None;
            }
            value |= bits << shift;
            if byte < 0x80 {
                break;
            }
            shift += 7;
        }
    }
    *bytes = rest;
    Some(value)
}

/// Returns the body of the record that begins at `start`, and its end.
#[inline]
pub(super) fn record_at(arena: &[u8], start: usize, length: u8) -> Option<(&[u8], usize)> {
    if length < LONG_RECORD {
        let end = start + usize::from(length);
        return Some((arena.get(start..end)?, end));
    }
    let length = long_length(arena.get(start..start.checked_add(4)?)?)?;
    let end = start.checked_add(length)?;
    Some((arena.get(start + 4..end)?.get(..length - 8)?, end))
}

/// Returns the body of the record that ends at `end`, and its start.
#[inline]
pub(super) fn record_before(arena: &[u8], end: usize, length: u8) -> Option<(&[u8], usize)> {
    if length < LONG_RECORD {
        let start = end.checked_sub(usize::from(length))?;
        return Some((arena.get(start..end)?, start));
    }
    let length = long_length(arena.get(end.checked_sub(4)?..end)?)?;
    let start = end.checked_sub(length)?;
    Some((arena.get(start + 4..end - 4)?, start))
}

/// Returns the length stored at one end of a long record, including both length fields.
fn long_length(bytes: &[u8]) -> Option<usize> {
    let length = u32::from_le_bytes(bytes.try_into().ok()?) as usize;
    (length >= 8).then_some(length)
}

/// Appends the record of the next step.
pub(super) fn push_record(body: &[u8], arena: &mut Vec<u8>, record_lengths: &mut Vec<u8>) {
    if body.len() < usize::from(LONG_RECORD) {
        record_lengths.push(body.len() as u8);
        arena.extend_from_slice(body);
    } else {
        let ends = (body.len() as u32 + 8).to_le_bytes();
        record_lengths.push(LONG_RECORD);
        arena.extend(ends);
        arena.extend_from_slice(body);
        arena.extend(ends);
    }
}

/// Converts records written from the full mesh down to the base into an arena that is read from the base
/// up. Returns the arena and the record lengths.
pub(super) fn in_refinement_order(reversed: &[u8], lengths: &[usize]) -> (Vec<u8>, Vec<u8>) {
    let mut arena = Vec::with_capacity(reversed.len());
    let mut record_lengths = Vec::with_capacity(lengths.len());
    let mut end = reversed.len();
    for &length in lengths.iter().rev() {
        let body = &reversed[end - length..end];
        end -= length;
        push_record(body, &mut arena, &mut record_lengths);
    }
    (arena, record_lengths)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn varints_over_32_bits_are_rejected() {
        for bytes in [&[0xff, 0xff, 0xff, 0xff, 0x1f][..], &[0x80, 0x80, 0x80, 0x80, 0x80, 0x00], &[0x80]] {
            assert_eq!(read_varint(&mut &*bytes), None);
        }
        assert_eq!(read_varint(&mut &[0xff, 0xff, 0xff, 0xff, 0x0f][..]), Some(u32::MAX));
    }

    #[test]
    fn long_records_are_found_from_both_ends() {
        let mut arena = vec![1, 2, 3];
        let length = 308u32.to_le_bytes();
        arena.extend(length);
        arena.extend([7; 300]);
        arena.extend(length);
        let body = &[7; 300][..];
        assert_eq!(record_at(&arena, 3, LONG_RECORD), Some((body, 311)));
        assert_eq!(record_before(&arena, 311, LONG_RECORD), Some((body, 3)));
        assert_eq!(record_before(&arena, 310, LONG_RECORD), None);
        assert_eq!(record_at(&arena, 0, 3), Some((&[1, 2, 3][..], 3)));
    }

    #[test]
    fn records_of_any_length_are_found_from_both_ends() {
        let bodies: Vec<Vec<u8>> =
            [0, 1, 254, 255, 256, 70_000].map(|length| vec![length as u8; length]).into();
        let (mut arena, mut lengths) = (Vec::new(), Vec::new());
        bodies.iter().for_each(|body| push_record(body, &mut arena, &mut lengths));
        let mut start = 0;
        for (body, &length) in bodies.iter().zip(&lengths) {
            let (found, end) = record_at(&arena, start, length).expect("written just now");
            assert_eq!(found, body);
            assert_eq!(record_before(&arena, end, length), Some((&body[..], start)));
            start = end;
        }
        assert_eq!(start, arena.len());
    }
}
