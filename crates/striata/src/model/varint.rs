//! Variable-length numbers in byte arenas. A varint has 7 bits per byte, low bits first.

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
}
