//! A set of steps, stored as one bit per step.

/// A set of steps, stored as one bit per step.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StepBits {
    words: Vec<u64>,
}

impl StepBits {
    /// Returns an empty set with room for `step_count` steps.
    pub fn none(step_count: usize) -> Self {
        Self { words: vec![0; step_count.div_ceil(64)] }
    }

    /// Whether a step is in the set.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn has(&self, step: u32) -> bool {
        self.words[step as usize / 64] & 1 << (step % 64) != 0
    }

    /// Adds a step.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn insert(&mut self, step: u32) {
        self.words[step as usize / 64] |= 1 << (step % 64);
    }

    /// Removes a step.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn remove(&mut self, step: u32) {
        self.words[step as usize / 64] &= !(1 << (step % 64));
    }

    /// Returns the last step of the set before `end`.
    pub(in crate::model) fn last_before(&self, end: u32) -> Option<u32> {
        let (mut at, bit) = (end as usize / 64, end % 64);
        let mut word = self.words.get(at).map_or(0, |word| word & ((1 << bit) - 1));
        while word == 0 {
            at = at.checked_sub(1)?;
            word = self.words[at];
        }
        Some(64 * at as u32 + word.ilog2())
    }

    /// Returns the first step of the set at or after `start`.
    #[inline]
    pub fn first_from(&self, start: u32) -> Option<u32> {
        let (mut at, bit) = (start as usize / 64, start % 64);
        let mut word = self.words.get(at)? & u64::MAX << bit;
        while word == 0 {
            at += 1;
            word = *self.words.get(at)?;
        }
        Some(64 * at as u32 + word.trailing_zeros())
    }

    /// Makes the set contain exactly the steps of a range.
    pub(in crate::model) fn set_range(&mut self, range: std::ops::Range<usize>) {
        for (word, first) in self.words.iter_mut().zip((0..).step_by(64)) {
            let [start, end] = [range.start, range.end].map(|step| step.clamp(first, first + 64) - first);
            let below = |step: usize| if step < 64 { (1 << step) - 1 } else { u64::MAX };
            *word = below(end) & !below(start);
        }
    }

    /// Returns the intersection of two sets of equal length.
    pub(in crate::model) fn and(&self, other: &Self) -> Self {
        Self { words: self.words.iter().zip(&other.words).map(|(a, b)| a & b).collect() }
    }

    /// Number of steps in the set.
    pub(in crate::model) fn count(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Returns the bits as words of 64 steps, low bits first. Bits after the last step are 0.
    #[inline]
    pub(in crate::model) fn words(&self) -> &[u64] {
        &self.words
    }

    /// Number of bytes in memory.
    pub(in crate::model) fn bytes(&self) -> usize {
        size_of_val(&self.words[..])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn set_range_replaces_the_whole_set() {
        for (start, end) in
            [(0, 0), (0, 200), (3, 3), (1, 64), (64, 128), (63, 65), (70, 190), (0, 1), (199, 200)]
        {
            let mut bits = StepBits::none(200);
            bits.insert(5);
            bits.set_range(start..end);
            for step in 0..200 {
                assert_eq!(
                    bits.has(step),
                    (start..end).contains(&(step as usize)),
                    "{step} of {start}..{end}"
                );
            }
        }
    }
}
