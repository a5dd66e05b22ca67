//! Numbers of two to four bytes.

/// A number of a record.
pub(in super::super) trait RecordNumber: Copy + Default {
    /// Largest number that can be stored.
    const MAX: u32;

    /// Stores a number that is not larger than [`MAX`](Self::MAX).
    fn store(number: u32) -> Self;

    /// Returns the number.
    fn load(self) -> u32;
}

/// A number of three bytes, low byte first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(in super::super) struct U24([u8; 3]);

impl RecordNumber for u16 {
    const MAX: u32 = u16::MAX as u32;

    #[inline(always)]
    fn store(number: u32) -> Self {
        number as u16
    }

    #[inline(always)]
    fn load(self) -> u32 {
        u32::from(self)
    }
}

impl RecordNumber for U24 {
    const MAX: u32 = (1 << 24) - 1;

    #[inline(always)]
    fn store(number: u32) -> Self {
        let [a, b, c, _] = number.to_le_bytes();
        Self([a, b, c])
    }

    #[inline(always)]
    fn load(self) -> u32 {
        let [a, b, c] = self.0;
        u32::from_le_bytes([a, b, c, 0])
    }
}

impl RecordNumber for u32 {
    const MAX: u32 = u32::MAX;

    #[inline(always)]
    fn store(number: u32) -> Self {
        number
    }

    #[inline(always)]
    fn load(self) -> u32 {
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn survives<N: RecordNumber>() {
        for number in [0, 1, 255, 256, 65_535, 65_536, 1 << 23, N::MAX].map(|number| number.min(N::MAX)) {
            assert_eq!(N::store(number).load(), number);
        }
    }

    #[test]
    fn numbers_up_to_the_largest_are_kept() {
        survives::<u16>();
        survives::<U24>();
        survives::<u32>();
    }
}
