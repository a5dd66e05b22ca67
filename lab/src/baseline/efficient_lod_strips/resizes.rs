//! The two patterns of repeated vertices that \[RCRG06\] removes, and how a removal is undone.
//!
//! `aa(a)+` becomes `aa`, and `ab(ab)+` becomes `ab`. A resize removes one repetition, at the position that
//! the record stores. It is undone by repeating what precedes the position, so it stores no vertex.

/// Whether the strips keep their winding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Winding {
    /// `aa(a)+` loses indices two at a time, so that the rest of the strip keeps its winding. An odd
    /// repetition stays.
    #[default]
    Kept,
    /// To the letter of the paper: `aaa` becomes `aa`, which flips all triangles behind it.
    Lost,
}

impl Winding {
    /// Removes the first repetition at or after index `from`; returns its position.
    pub(super) fn remove(self, strip: &mut Vec<u32>, from: usize) -> Option<usize> {
        (from..strip.len()).find_map(|start| {
            let count = self.repeated(&strip[start..])?;
            strip.drain(start + 2..start + 2 + count);
            Some(start + 2)
        })
    }

    /// Number of indices that repeat the first two of `rest`.
    fn repeated(self, rest: &[u32]) -> Option<usize> {
        match *rest {
            [a, b, c, ..] if self == Self::Lost && a == b && b == c => Some(1),
            [a, b, c, d, ..] if a == c && b == d => Some(2),
            _ => None,
        }
    }

    /// Number of indices that a resize at this position removes from a strip without them. The two indices
    /// before the position are still there.
    #[inline]
    fn count_at(self, strip: &[u32], position: usize) -> usize {
        if self == Self::Lost && strip[position - 2] == strip[position - 1] { 1 } else { 2 }
    }

    /// Applies a resize to the first `length` slots of a strip; returns the new length.
    #[inline]
    pub(super) fn apply(self, slots: &mut [u32], length: usize, position: usize) -> usize {
        let count = self.count_at(slots, position);
        slots.copy_within(position + count..length, position);
        length - count
    }

    /// Undoes a resize; returns the new length.
    #[inline]
    pub(super) fn undo(self, slots: &mut [u32], length: usize, position: usize) -> usize {
        let count = self.count_at(slots, position);
        slots.copy_within(position..length, position + count);
        slots.copy_within(position - 2..position - 2 + count, position);
        length + count
    }
}

/// Whether a strip draws anything.
pub(super) fn has_triangle(strip: &[u32]) -> bool {
    strip.windows(3).any(|w| w[0] != w[1] && w[1] != w[2] && w[2] != w[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reduced(winding: Winding, strip: &[u32]) -> (Vec<u32>, Vec<usize>) {
        let (mut strip, mut positions) = (strip.to_vec(), Vec::new());
        while let Some(position) = winding.remove(&mut strip, 0) {
            positions.push(position);
        }
        (strip, positions)
    }

    #[test]
    fn patterns_of_the_paper_are_removed() {
        for winding in [Winding::Kept, Winding::Lost] {
            assert_eq!(reduced(winding, &[0, 1, 2, 1, 2, 1, 2, 3]).0, [0, 1, 2, 3]);
            assert_eq!(reduced(winding, &[0, 1, 2, 2, 2, 2, 3]).0, [0, 1, 2, 2, 3]);
            assert_eq!(reduced(winding, &[0, 0, 1, 2]).0, [0, 0, 1, 2]);
        }
        assert_eq!(reduced(Winding::Kept, &[0, 1, 2, 2, 2, 3]).0, [0, 1, 2, 2, 2, 3]);
        assert_eq!(reduced(Winding::Lost, &[0, 1, 2, 2, 2, 3]).0, [0, 1, 2, 2, 3]);
    }

    #[test]
    fn undoing_resizes_restores_every_short_strip() {
        for code in 0..4u32.pow(7) {
            let strip: Vec<u32> = (0..7).map(|digit| code >> (2 * digit) & 3).collect();
            for winding in [Winding::Kept, Winding::Lost] {
                let (short, positions) = reduced(winding, &strip);
                let (mut slots, mut length) = (strip.clone(), strip.len());
                for &position in &positions {
                    length = winding.apply(&mut slots, length, position);
                }
                assert_eq!(slots[..length], short);
                for &position in positions.iter().rev() {
                    length = winding.undo(&mut slots, length, position);
                }
                assert_eq!(slots, strip);
            }
        }
    }
}
