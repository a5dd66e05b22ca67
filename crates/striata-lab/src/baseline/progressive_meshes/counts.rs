//! Small numbers in as few bytes as they take.

use std::ops::Range;

/// A count of this or more stands among the long ones.
const LONG: u8 = u8::MAX;

/// A count for each of many things: a byte, for the few that do not fit a pair of words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Counts {
    short: Vec<u8>,
    /// Which thing and its count, sorted.
    long: Vec<(u32, u32)>,
}

impl Counts {
    pub(super) fn of(counts: &[u32]) -> Self {
        let short = |&count: &u32| u8::try_from(count).unwrap_or(LONG);
        let is_long = |&(_, count): &(u32, u32)| count >= u32::from(LONG);
        Self {
            short: counts.iter().map(short).collect(),
            long: (0..).zip(counts.iter().copied()).filter(is_long).collect(),
        }
    }

    #[inline]
    pub(super) fn get(&self, thing: usize) -> usize {
        match self.short[thing] {
            LONG => self.long_count(thing),
            count => usize::from(count),
        }
    }

    #[cold]
    fn long_count(&self, thing: usize) -> usize {
        self.long[self.long.partition_point(|&(other, _)| (other as usize) < thing)].1 as usize
    }

    pub(super) fn bytes(&self) -> usize {
        self.short.len() + size_of_val(&self.long[..])
    }
}

/// The group of each of many triangles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum GroupNumbers {
    /// There is but one group.
    One,
    /// At most 256 groups.
    Narrow(Vec<u8>),
    /// More.
    Wide(Vec<u32>),
}

impl GroupNumbers {
    pub(super) fn of(groups: impl Iterator<Item = u32>, group_count: usize) -> Self {
        match group_count {
            0..=1 => Self::One,
            2..=256 => Self::Narrow(groups.map(|group| group as u8).collect()),
            _ => Self::Wide(groups.collect()),
        }
    }

    /// Numbers held.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::One => 0,
            Self::Narrow(groups) => groups.len(),
            Self::Wide(groups) => groups.len(),
        }
    }

    /// Tells the groups of some of the triangles.
    #[inline]
    pub(super) fn for_each(&self, triangles: Range<usize>, mut tell: impl FnMut(usize)) {
        match self {
            Self::One => {}
            Self::Narrow(groups) => groups[triangles].iter().for_each(|&group| tell(usize::from(group))),
            Self::Wide(groups) => groups[triangles].iter().for_each(|&group| tell(group as usize)),
        }
    }

    pub(super) fn bytes(&self) -> usize {
        match self {
            Self::One => 0,
            Self::Narrow(groups) => groups.len(),
            Self::Wide(groups) => 4 * groups.len(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_counts_stand_apart() {
        let all = [0, 254, 255, 3, 256, 70_000, 1, u32::MAX];
        let counts = Counts::of(&all);
        assert_eq!(counts.bytes(), 8 + 4 * 8);
        for (thing, &count) in all.iter().enumerate() {
            assert_eq!(counts.get(thing), count as usize);
        }
    }

    #[test]
    fn group_numbers_are_as_wide_as_they_must_be() {
        assert_eq!(GroupNumbers::of([0; 9].into_iter(), 1).bytes(), 0);
        assert_eq!(GroupNumbers::of([0, 255].into_iter(), 256), GroupNumbers::Narrow(vec![0, 255]));
        assert_eq!(GroupNumbers::of([0, 256].into_iter(), 257), GroupNumbers::Wide(vec![0, 256]));
    }
}
