//! Integers of variable size (LEB128), shared by the head and the pages.

/// Appends an integer, seven bits per byte, lowest first.
pub(crate) fn put_varint(bytes: &mut Vec<u8>, mut value: u64) {
    while value >= 128 {
        bytes.push(value as u8 | 128);
        value >>= 7;
    }
    bytes.push(value as u8);
}

/// Takes an integer from the front, or returns `None` if it is cut off or exceeds 64 bits.
pub(crate) fn take_varint(bytes: &mut &[u8]) -> Option<u64> {
    let mut value = 0;
    for shift in (0..64).step_by(7) {
        let (&byte, rest) = bytes.split_first()?;
        *bytes = rest;
        let low = u64::from(byte & 127);
        if shift == 63 && low > 1 {
            return None;
        }
        value |= low << shift;
        if byte < 128 {
            return Some(value);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_round_trip() {
        let numbers = (0..64).flat_map(|shift| [1 << shift, (1 << shift) - 1, u64::MAX >> shift]);
        for number in numbers {
            let mut bytes = Vec::new();
            put_varint(&mut bytes, number);
            assert_eq!(take_varint(&mut bytes.as_slice()), Some(number));
            bytes.pop();
            assert_eq!(take_varint(&mut bytes.as_slice()), None);
        }
    }

    #[test]
    fn integers_beyond_64_bits_are_refused() {
        assert_eq!(take_varint(&mut [255; 12].as_slice()), None);
        assert_eq!(take_varint(&mut [255, 255, 255, 255, 255, 255, 255, 255, 255, 2].as_slice()), None);
    }
}
