//! A packed array of bit fields up to 57 bits wide.

/// Spare bytes at the end, so that any field can be read with one 64-bit load.
pub(in crate::model) const PADDING: usize = 8;
/// Widest field that fits into a 64-bit load at any bit offset within a byte.
pub(in crate::model) const MAX_WIDTH: u32 = 57;

/// A packed array of bit fields up to 57 bits wide, lowest bit first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bits {
    bytes: Vec<u8>,
    /// Number of bits in use.
    len: usize,
}

impl Default for Bits {
    fn default() -> Self {
        Self { bytes: vec![0; PADDING], len: 0 }
    }
}

impl Bits {
    /// Wraps bytes that contain exactly `len` bits. Returns `None` if the number of bytes does not match,
    /// or if a bit after the last is set.
    pub fn from_bytes(bytes: &[u8], len: usize) -> Option<Self> {
        if bytes.len() != len.div_ceil(8) {
            return None;
        }
        let used = len % 8;
        if used > 0 && bytes[bytes.len() - 1] >> used != 0 {
            return None;
        }
        let mut padded = Vec::with_capacity(bytes.len() + PADDING);
        padded.extend_from_slice(bytes);
        padded.resize(bytes.len() + PADDING, 0);
        Some(Self { bytes: padded, len })
    }

    /// Returns the bytes in use, without padding.
    pub fn as_bytes(&self) -> &[u8] {
        &self.bytes[..self.bytes.len() - PADDING]
    }

    /// Whether there are no bits.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// Number of bits.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Appends the low `width` bits of a number; `width` is at most 57, and all higher bits must be zero.
    pub fn push(&mut self, number: u64, width: u32) {
        debug_assert!(
            width <= MAX_WIDTH && (width == 64 || number >> width == 0),
            "{number} in {width} bits"
        );
        let (byte, shift) = (self.len / 8, self.len % 8);
        self.len += width as usize;
        self.bytes.resize(self.len.div_ceil(8) + PADDING, 0);
        let mut word = self.word(byte);
        word |= number << shift;
        self.bytes[byte..byte + 8].copy_from_slice(&word.to_le_bytes());
    }

    /// Returns the field of `width` bits (at most 57) that begins at bit `at`.
    ///
    /// # Panics
    /// If `at` lies beyond the padding.
    #[inline]
    pub fn get(&self, at: usize, width: u32) -> u64 {
        self.word(at / 8) >> (at % 8) & ((1 << width) - 1)
    }

    #[inline]
    fn word(&self, byte: usize) -> u64 {
        u64::from_le_bytes(*self.bytes[byte..].first_chunk().expect("bits are padded"))
    }

    /// Number of bytes in memory, including padding.
    pub fn bytes(&self) -> usize {
        self.bytes.len()
    }

    /// Returns the bytes in use and the padding.
    pub(in crate::model) fn into_padded(self) -> Vec<u8> {
        self.bytes
    }
}

/// Returns the field of `width` bits (at most 57) that begins at bit `at` of padded bytes; `None` if it lies
/// beyond the padding.
#[inline]
pub(in crate::model) fn field(padded: &[u8], at: usize, width: u32) -> Option<u64> {
    let word = u64::from_le_bytes(*padded.get(at / 8..)?.first_chunk()?);
    Some(word >> (at % 8) & ((1 << width) - 1))
}

/// Returns the number of bits needed for values below `count`.
#[inline]
pub(in crate::model) fn width_of(count: u64) -> u32 {
    u64::BITS - count.saturating_sub(1).leading_zeros()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Random;

    #[test]
    fn numbers_are_read_as_they_were_written() {
        let mut random = Random::new(3);
        let numbers: Vec<(u64, u32)> = (0..500)
            .map(|_| {
                let width = random.below(MAX_WIDTH + 1);
                ((random.unit() * (1u64 << width) as f64) as u64, width)
            })
            .collect();
        let mut bits = Bits::default();
        for &(number, width) in &numbers {
            bits.push(number, width);
        }
        let again = Bits::from_bytes(bits.as_bytes(), bits.len()).unwrap();
        assert_eq!(again, bits);
        let mut at = 0;
        for (number, width) in numbers {
            assert_eq!(again.get(at, width), number);
            at += width as usize;
        }
        assert_eq!(at, bits.len());
    }

    #[test]
    fn widths_hold_their_numbers() {
        assert_eq!([0, 1, 2, 3, 4, 5, 256, 257].map(width_of), [0, 0, 1, 2, 2, 3, 8, 9]);
    }

    #[test]
    fn bits_behind_the_last_are_refused() {
        assert!(Bits::from_bytes(&[0b111], 3).is_some());
        assert!(Bits::from_bytes(&[0b1111], 3).is_none());
        assert!(Bits::from_bytes(&[0], 9).is_none());
        assert!(Bits::from_bytes(&[0, 0], 8).is_none());
    }
}
