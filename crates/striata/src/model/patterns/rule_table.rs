//! All rules of a model in one array, using bytes for rules with small numbers.

use super::rule::{NONE, Rule};

/// All rules of a model.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::model) struct RuleTable {
    entries: Vec<RuleEntry>,
    narrow: Vec<u8>,
    wide: Vec<u32>,
    /// Whether each triangle has a group.
    is_grouped: bool,
}

/// Counts of a rule, and the start of its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct RuleEntry {
    first: u32,
    own_count: u32,
    local_count: u32,
    ceiling_count: u32,
    floor_count: u32,
    extra_count: u32,
    is_wide: bool,
}

/// A rule in the table, with numbers of one size.
#[derive(Clone, Copy, Debug)]
pub(super) enum RuleRef<'a> {
    Narrow(RuleView<'a, u8>),
    Wide(RuleView<'a, u32>),
}

/// View of a rule in the table. Its numbers are, in order: triangles of the ceiling, triangles of the
/// floor, the next corner around each corner of the floor, the half-edge of each code, extra vertices, and
/// groups of the ceiling and floor triangles.
#[derive(Clone, Copy, Debug)]
pub(super) struct RuleView<'a, N> {
    entry: RuleEntry,
    numbers: &'a [N],
    is_grouped: bool,
}

/// The numbers of a rule: bytes, if they are small enough.
pub(super) trait Number: Copy {
    /// Marks a missing corner.
    const MISSING: Self;

    fn get(self) -> u32;
}

impl Number for u8 {
    const MISSING: Self = Self::MAX;

    #[inline]
    fn get(self) -> u32 {
        u32::from(self)
    }
}

impl Number for u32 {
    const MISSING: Self = NONE;

    #[inline]
    fn get(self) -> u32 {
        self
    }
}

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
            triangles.chain(&rule.next_around).chain(&rule.starts).chain(&rule.extras).chain(groups).copied()
        };
        self.is_grouped |= !rule.ceiling_groups.is_empty() || !rule.floor_groups.is_empty();
        // With that many corners, the index of one would equal the mark of a missing one.
        let missing = u32::from(u8::MISSING);
        let is_wide = 3 * rule.floor.len() > missing as usize || numbers().any(|n| n != NONE && n >= missing);
        let first = if is_wide { self.wide.len() } else { self.narrow.len() };
        self.entries.push(RuleEntry {
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
            self.narrow.extend(numbers().map(|n| u8::try_from(n).unwrap_or(u8::MISSING)));
        }
    }

    /// Number of rules.
    pub(super) fn len(&self) -> usize {
        self.entries.len()
    }

    #[inline]
    pub(super) fn rule(&self, number: u32) -> RuleRef<'_> {
        let entry = self.entries[number as usize];
        let (first, is_grouped) = (entry.first as usize, self.is_grouped);
        match entry.is_wide {
            false => RuleRef::Narrow(RuleView { entry, numbers: &self.narrow[first..], is_grouped }),
            true => RuleRef::Wide(RuleView { entry, numbers: &self.wide[first..], is_grouped }),
        }
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = RuleRef<'_>> {
        (0..self.len() as u32).map(|number| self.rule(number))
    }

    pub(super) fn bytes(&self) -> usize {
        size_of_val(&self.entries[..]) + size_of_val(&self.narrow[..]) + size_of_val(&self.wide[..])
    }
}

/// Evaluates an expression for a rule, whatever the size of its numbers.
macro_rules! of_rule {
    ($rule:expr, $view:ident => $value:expr) => {
        match $rule {
            $crate::model::patterns::rule_table::RuleRef::Narrow($view) => $value,
            $crate::model::patterns::rule_table::RuleRef::Wide($view) => $value,
        }
    };
}

impl RuleRef<'_> {
    /// Copies the rule out of the table, without the derived fields.
    pub(super) fn to_rule(self) -> Rule {
        of_rule!(self, rule => rule.to_rule())
    }

    #[inline]
    pub(super) fn ceiling_count(&self) -> usize {
        of_rule!(self, rule => rule.ceiling_count())
    }

    #[inline]
    pub(super) fn floor_count(&self) -> usize {
        of_rule!(self, rule => rule.floor_count())
    }

    /// Returns the corner of the same vertex in the next triangle around it, if it exists.
    pub(super) fn next_around(&self, half_edge: u32) -> Option<u32> {
        of_rule!(self, rule => rule.around(half_edge, 1))
    }

    /// Returns the half-edge at which a run begins, and goes `count` triangles further around its vertex;
    /// `None` if either does not exist.
    #[inline]
    pub(super) fn locate(&self, code: u32, count: u32) -> Option<u32> {
        of_rule!(self, rule => rule.locate(code, count))
    }
}

impl<N: Number> RuleView<'_, N> {
    fn to_rule(self) -> Rule {
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
    #[inline]
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

    /// Number of vertices that each fragment lists explicitly.
    #[inline]
    pub(super) fn extra_count(&self) -> usize {
        self.entry.extra_count as usize
    }

    #[inline]
    fn triangle(&self, index: usize) -> [u32; 3] {
        let [a, b, c] = self.numbers[3 * index..].first_chunk().expect("a triangle has three corners");
        [a.get(), b.get(), c.get()]
    }

    /// Returns the triangles of the ceiling in local vertex indices.
    #[inline]
    pub(super) fn ceilings(&self) -> &[[N; 3]] {
        self.numbers[..3 * self.ceiling_count()].as_chunks().0
    }

    /// Returns the triangles of the floor in local vertex indices.
    #[inline]
    pub(super) fn floors(&self) -> &[[N; 3]] {
        self.numbers[3 * self.ceiling_count()..self.after_triangles()].as_chunks().0
    }

    /// Returns a triangle of the ceiling in local vertex indices.
    #[inline]
    pub(super) fn ceiling(&self, triangle: usize) -> [u32; 3] {
        self.triangle(triangle)
    }

    /// Returns a triangle of the floor in local vertex indices.
    #[inline]
    pub(super) fn floor(&self, triangle: usize) -> [u32; 3] {
        self.triangle(self.ceiling_count() + triangle)
    }

    /// First number after the triangles.
    #[inline]
    fn after_triangles(&self) -> usize {
        3 * (self.ceiling_count() + self.floor_count())
    }

    /// Returns the corner of the same vertex `count` triangles further around it, if it exists.
    #[inline]
    pub(super) fn around(&self, half_edge: u32, count: u32) -> Option<u32> {
        let first = self.after_triangles();
        (0..count).try_fold(half_edge, |at, _| {
            let next = self.numbers[first + at as usize].get();
            (next != N::MISSING.get()).then_some(next)
        })
    }

    /// Returns the half-edge at which a run begins, and goes `count` triangles further around its vertex;
    /// `None` if either does not exist.
    #[inline]
    pub(super) fn locate(&self, code: u32, count: u32) -> Option<u32> {
        if code as usize >= 3 * self.floor_count() {
            return None;
        }
        let first = self.after_triangles() + 3 * self.floor_count();
        self.around(self.numbers[first + code as usize].get(), count)
    }

    /// Returns the local vertices that are missing from the ceiling or the floor.
    #[inline]
    pub(super) fn extras(&self) -> impl Iterator<Item = u32> + '_ {
        let first = self.after_triangles() + 6 * self.floor_count();
        self.numbers[first..first + self.extra_count()].iter().map(|number| number.get())
    }

    /// Returns the group of a ceiling triangle, or of a floor triangle if the index exceeds those of the
    /// ceiling.
    #[inline]
    pub(super) fn group(&self, triangle: usize) -> u32 {
        if !self.is_grouped {
            return 0;
        }
        let first = self.after_triangles() + 6 * self.floor_count() + self.extra_count();
        self.numbers[first + triangle].get()
    }
}

pub(super) use of_rule;

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

    #[test]
    fn runs_begin_at_corners_without_a_predecessor_first() {
        // A fan from vertex 0; half-edges 0, 3 and 6 are its corners there.
        let floor = vec![[0, 1, 2], [0, 2, 3], [0, 3, 4]];
        let table = RuleTable::pack([Rule { local_count: 5, floor, ..Rule::default() }]);
        let rule = table.rule(0);
        let located: Vec<u32> = (0..9).filter_map(|code| rule.locate(code, 0)).collect();
        assert_eq!(located, [0, 1, 4, 7, 8, 2, 3, 5, 6], "five vertices, then what follows around them");
        assert_eq!((rule.locate(0, 2), rule.locate(0, 3), rule.locate(9, 0)), (Some(6), None, None));
    }
}
