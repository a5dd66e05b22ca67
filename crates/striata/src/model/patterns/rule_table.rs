//! All rules of a model in one array, using bytes for rules with small numbers.

use super::rule::Rule;

/// All rules of a model.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::model) struct RuleTable {
    entries: Vec<Entry>,
    narrow: Vec<u8>,
    wide: Vec<u32>,
    /// Whether each triangle has a group.
    is_grouped: bool,
}

/// Counts of a rule, and the start of its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Entry {
    first: u32,
    own_count: u32,
    local_count: u32,
    ceiling_count: u32,
    floor_count: u32,
    extra_count: u32,
    is_wide: bool,
}

/// View of a rule in the table. Its numbers are, in order: triangles of the ceiling, triangles of the
/// floor, the next corner around each corner of the floor, extra vertices, and groups of the ceiling and
/// floor triangles.
#[derive(Clone, Copy, Debug)]
pub(super) struct RuleRef<'a> {
    entry: Entry,
    numbers: Numbers<'a>,
    is_grouped: bool,
}

#[derive(Clone, Copy, Debug)]
enum Numbers<'a> {
    Narrow(&'a [u8]),
    Wide(&'a [u32]),
}

/// Marks a missing corner in a narrow rule.
const NARROW_NONE: u8 = u8::MAX;

impl RuleTable {
    /// Packs rules, deriving the fields that do not come from a file.
    pub(super) fn pack(rules: impl IntoIterator<Item = Rule>) -> Self {
        let mut table = Self::default();
        for rule in rules.into_iter().map(Rule::completed) {
            table.push(&rule);
        }
        table
    }

    fn push(&mut self, rule: &Rule) {
        let numbers = || {
            let triangles = rule.ceiling.iter().chain(&rule.floor).flatten();
            let groups = rule.ceiling_groups.iter().chain(&rule.floor_groups);
            triangles.chain(&rule.next_around).chain(&rule.extras).chain(groups).copied()
        };
        self.is_grouped |= !rule.ceiling_groups.is_empty() || !rule.floor_groups.is_empty();
        // With that many corners, the index of one would equal `NARROW_NONE`.
        let is_wide = 3 * rule.floor.len() > usize::from(NARROW_NONE)
            || numbers().any(|n| n != super::rule::NONE && n >= u32::from(NARROW_NONE));
        let first = if is_wide { self.wide.len() } else { self.narrow.len() };
        self.entries.push(Entry {
            first: first as u32,
            own_count: rule.own_count,
            local_count: rule.local_count,
            ceiling_count: rule.ceiling.len() as u32,
            floor_count: rule.floor.len() as u32,
            extra_count: rule.extras.len() as u32,
            is_wide,
        });
        if is_wide {
            self.wide.extend(numbers());
        } else {
            self.narrow.extend(numbers().map(|n| u8::try_from(n).unwrap_or(NARROW_NONE)));
        }
    }

    /// Number of rules.
    pub(super) fn len(&self) -> usize {
        self.entries.len()
    }

    #[inline]
    pub(super) fn rule(&self, number: u32) -> RuleRef<'_> {
        let entry = self.entries[number as usize];
        let first = entry.first as usize;
        let numbers = match entry.is_wide {
            false => Numbers::Narrow(&self.narrow[first..]),
            true => Numbers::Wide(&self.wide[first..]),
        };
        RuleRef { entry, numbers, is_grouped: self.is_grouped }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = RuleRef<'_>> {
        (0..self.len() as u32).map(|number| self.rule(number))
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.entries[..]) + size_of_val(&self.narrow[..]) + size_of_val(&self.wide[..])
    }
}

impl RuleRef<'_> {
    #[inline]
    fn number(&self, at: usize) -> u32 {
        match self.numbers {
            Numbers::Narrow(numbers) => u32::from(numbers[at]),
            Numbers::Wide(numbers) => numbers[at],
        }
    }

    #[inline]
    fn triangle(&self, at: usize) -> [u32; 3] {
        match self.numbers {
            Numbers::Narrow(numbers) => {
                let [a, b, c] = *numbers[at..].first_chunk().expect("a triangle has three corners");
                [u32::from(a), u32::from(b), u32::from(c)]
            }
            Numbers::Wide(numbers) => *numbers[at..].first_chunk().expect("a triangle has three corners"),
        }
    }

    /// Copies the rule out of the table, without the derived fields.
    pub(super) fn to_rule(self) -> Rule {
        let (ceiling, floor) = (self.ceiling_count(), self.floor_count());
        let groups = |range: std::ops::Range<usize>| range.map(|triangle| self.group(triangle)).collect();
        Rule {
            own_count: self.entry.own_count,
            local_count: self.entry.local_count,
            ceiling: (0..ceiling).map(|s| self.ceiling(s)).collect(),
            floor: (0..floor).map(|j| self.floor(j)).collect(),
            ceiling_groups: if self.is_grouped { groups(0..ceiling) } else { Vec::new() },
            floor_groups: if self.is_grouped { groups(ceiling..ceiling + floor) } else { Vec::new() },
            ..Rule::default()
        }
    }

    /// Number of vertices that the step restores; they have the first local indices.
    pub(super) fn own_count(&self) -> usize {
        self.entry.own_count as usize
    }

    /// Number of local vertices.
    #[inline]
    pub(super) fn local_count(&self) -> usize {
        self.entry.local_count as usize
    }

    #[inline]
    pub(super) fn ceiling_count(&self) -> usize {
        self.entry.ceiling_count as usize
    }

    #[inline]
    pub(super) fn floor_count(&self) -> usize {
        self.entry.floor_count as usize
    }

    /// Returns a triangle of the ceiling, with its youngest corner first.
    #[inline]
    pub(super) fn ceiling(&self, s: usize) -> [u32; 3] {
        self.triangle(3 * s)
    }

    /// Returns a triangle of the floor.
    #[inline]
    pub(super) fn floor(&self, j: usize) -> [u32; 3] {
        self.triangle(3 * (self.ceiling_count() + j))
    }

    /// Returns the corner of the same vertex in the next triangle around it, if there is exactly one.
    #[inline]
    pub(super) fn next_around(&self, half_edge: u32) -> Option<u32> {
        let next = self.number(3 * (self.ceiling_count() + self.floor_count()) + half_edge as usize);
        (next < 3 * self.entry.floor_count).then_some(next)
    }

    /// Returns the corner of the same vertex `count` triangles further around it, if it exists.
    #[inline]
    pub(super) fn around(&self, half_edge: u32, count: u32) -> Option<u32> {
        (0..count).try_fold(half_edge, |at, _| self.next_around(at))
    }

    /// Returns the local vertices that are missing from the ceiling or the floor.
    #[inline]
    pub(super) fn extras(&self) -> impl Iterator<Item = u32> + '_ {
        let first = 3 * (self.ceiling_count() + 2 * self.floor_count());
        (first..first + self.entry.extra_count as usize).map(|at| self.number(at))
    }

    /// Returns the group of a ceiling triangle, or of a floor triangle if the index exceeds those of the
    /// ceiling.
    #[inline]
    pub(super) fn group(&self, triangle: usize) -> u32 {
        if !self.is_grouped {
            return 0;
        }
        let first = 3 * (self.ceiling_count() + 2 * self.floor_count()) + self.entry.extra_count as usize;
        self.number(first + triangle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn duplicate_triangles_have_no_next_corner() {
        for count in [2, 85, 86, 300] {
            let rule = Rule { local_count: 3, floor: vec![[0, 1, 2]; count], ..Rule::default() };
            let table = RuleTable::pack([rule]);
            let rule = table.rule(0);
            assert!((0..3 * count as u32).all(|half_edge| rule.next_around(half_edge).is_none()), "{count}");
        }
    }
}
