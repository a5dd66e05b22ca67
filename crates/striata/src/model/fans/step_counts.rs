//! How many triangles each step adds, in one byte per step.

/// Marks a count that does not fit into a byte.
const LARGE: i8 = i8::MIN;

/// Number of triangles that each step adds when it is refined; negative if its floor has more than its star.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct StepCounts {
    small: Box<[i8]>,
    /// Steps with counts that do not fit, ascending, and their counts.
    large: Vec<(u32, i32)>,
}

impl StepCounts {
    /// Stores counts by step.
    pub(super) fn new(counts: impl Iterator<Item = i32>) -> Self {
        let mut large = Vec::new();
        let small = (0..).zip(counts).map(|(step, count)| match i8::try_from(count) {
            Ok(small) if small != LARGE => small,
            _ => {
                large.push((step, count));
                LARGE
            }
        });
        Self { small: small.collect(), large }
    }

    /// Returns the count of a step.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub(super) fn of(&self, step: u32) -> isize {
        match self.small[step as usize] {
            LARGE => self.large_count(step),
            small => small as isize,
        }
    }

    #[cold]
    fn large_count(&self, step: u32) -> isize {
        let found = self.large.binary_search_by_key(&step, |&(step, _)| step);
        found.map_or(0, |at| self.large[at].1 as isize)
    }

    /// Number of bytes in memory.
    pub(super) fn bytes(&self) -> usize {
        self.small.len() + size_of_val(&self.large[..])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_of_any_size_are_kept() {
        let counts = [2, 0, -3, 127, 128, -127, -128, 70_000, -70_000, 1];
        let kept = StepCounts::new(counts.into_iter());
        for (step, &count) in (0..).zip(&counts) {
            assert_eq!(kept.of(step), count as isize);
        }
        assert_eq!(kept.large.len(), 4);
    }
}
