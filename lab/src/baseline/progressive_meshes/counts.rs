//! Compact storage of small integers: counts in a byte each, group indices as narrow as possible.

use std::ops::Range;

/// Counts of this value or more are stored in the table of long ones.
const LONG: u8 = u8::MAX;

/// An array of counts: one byte each, and an index-value pair for each of the few that do not fit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct PackedCounts {
    short: Vec<u8>,
    /// Index and value of each long count, sorted.
    long: Vec<(u32, u32)>,
}

impl PackedCounts {
    pub(super) fn of(counts: &[u32]) -> Self {
        let short = |&count: &u32| u8::try_from(count).unwrap_or(LONG);
        let is_long = |&(_, count): &(u32, u32)| count >= u32::from(LONG);
        Self {
            short: counts.iter().map(short).collect(),
            long: (0..).zip(counts.iter().copied()).filter(is_long).collect(),
        }
    }

    #[inline]
    pub(super) fn get(&self, index: usize) -> usize {
        match self.short[index] {
            LONG => self.long_count(index),
            count => usize::from(count),
        }
    }

    #[cold]
    fn long_count(&self, index: usize) -> usize {
        self.long[self.long.partition_point(|&(other, _)| (other as usize) < index)].1 as usize
    }

    pub(super) fn bytes(&self) -> usize {
        self.short.len() + size_of_val(&self.long[..])
    }
}

/// The group of each of an array of triangles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum GroupIndices {
    /// There is only one group.
    One,
    /// At most 256 groups.
    Narrow(Vec<u8>),
    /// More than 256 groups.
    Wide(Vec<u32>),
}

impl GroupIndices {
    pub(super) fn of(groups: impl Iterator<Item = u32>, group_count: usize) -> Self {
        match group_count {
            0..=1 => Self::One,
            2..=256 => Self::Narrow(groups.map(|group| group as u8).collect()),
            _ => Self::Wide(groups.collect()),
        }
    }

    /// Number of stored indices.
    pub(super) fn len(&self) -> usize {
        match self {
            Self::One => 0,
            Self::Narrow(groups) => groups.len(),
            Self::Wide(groups) => groups.len(),
        }
    }

    /// Calls `visit` with the group of each triangle in a range.
    #[inline]
    pub(super) fn for_each(&self, triangles: Range<usize>, mut visit: impl FnMut(usize)) {
        match self {
            Self::One => {}
            Self::Narrow(groups) => groups[triangles].iter().for_each(|&group| visit(usize::from(group))),
            Self::Wide(groups) => groups[triangles].iter().for_each(|&group| visit(group as usize)),
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
    fn long_counts_are_stored_separately() {
        let all = [0, 254, 255, 3, 256, 70_000, 1, u32::MAX];
        let counts = PackedCounts::of(&all);
        assert_eq!(counts.bytes(), 8 + 4 * 8);
        for (index, &count) in all.iter().enumerate() {
            assert_eq!(counts.get(index), count as usize);
        }
    }

    #[test]
    fn group_indices_are_as_narrow_as_possible() {
        assert_eq!(GroupIndices::of([0; 9].into_iter(), 1).bytes(), 0);
        assert_eq!(GroupIndices::of([0, 255].into_iter(), 256), GroupIndices::Narrow(vec![0, 255]));
        assert_eq!(GroupIndices::of([0, 256].into_iter(), 257), GroupIndices::Wide(vec![0, 256]));
    }
}
