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

    /// Adds a step if a condition holds.
    #[inline(always)]
    pub(in crate::model) fn insert_if(&mut self, step: u32, condition: bool) {
        self.words[step as usize / 64] |= u64::from(condition) << (step % 64);
    }

    /// Moves steps of the set at or after that of `start`'s word to a list, in ascending order, until the list has
    /// at least `count` steps or the set is empty. Returns whether the list has any.
    #[inline]
    pub(in crate::model) fn take_from(&mut self, start: u32, count: usize, list: &mut Vec<u32>) -> bool {
        for (at, word) in self.words.iter_mut().enumerate().skip(start as usize / 64) {
            let mut bits = std::mem::take(word);
            while bits != 0 {
                list.push(64 * at as u32 + bits.trailing_zeros());
                bits &= bits - 1;
            }
            if list.len() >= count {
                break;
            }
        }
        !list.is_empty()
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

    /// Returns the last step before `end` that is not in the set; `end` is at most the number of steps.
    #[inline]
    pub(in crate::model) fn last_absent_before(&self, end: u32) -> Option<u32> {
        let (mut at, bit) = (end as usize / 64, end % 64);
        let mut word = self.words.get(at).map_or(0, |word| !word & ((1 << bit) - 1));
        while word == 0 {
            at = at.checked_sub(1)?;
            word = !self.words[at];
        }
        Some(64 * at as u32 + word.ilog2())
    }

    /// Returns the first step at or after `start` that is in this set and in another one of equal length.
    #[inline]
    pub(in crate::model) fn first_common_from(&self, other: &Self, start: u32) -> Option<u32> {
        let (first, bit) = (start as usize / 64, start % 64);
        let mut mask = u64::MAX << bit;
        for (at, (a, b)) in self.words.iter().zip(&other.words).enumerate().skip(first) {
            let word = a & b & mask;
            if word != 0 {
                return Some(64 * at as u32 + word.trailing_zeros());
            }
            mask = u64::MAX;
        }
        None
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
    fn absent_and_common_steps_are_found() {
        let (mut a, mut b) = (StepBits::none(200), StepBits::none(200));
        for step in [0, 5, 63, 64, 130, 199] {
            a.insert(step);
            if step % 2 == 0 {
                b.insert(step);
            }
        }
        for start in 0..200 {
            assert_eq!(a.first_common_from(&b, start), [0, 64, 130].into_iter().find(|&step| step >= start));
            assert_eq!(a.last_absent_before(start), (0..start).rev().find(|&step| !a.has(step)));
        }
        assert_eq!(a.last_absent_before(200), Some(198));
    }

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
