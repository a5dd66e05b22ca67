//! Groups the slots of a strip that show the same vertex, while its vertices collapse one by one.
//!
//! Groups are merged by relabeling the smaller one, so all merges of a strip with `n` slots take `n log n`
//! steps. Each step checks the triangles that it may remove.

/// End of a list of slots.
const NONE: u32 = u32::MAX;

/// The slots of one strip in groups, and the triangles that remain.
#[derive(Debug, Default)]
pub(super) struct SlotGroups {
    group_of: Vec<u32>,
    /// The next slot of the same group.
    next: Vec<u32>,
    groups: Vec<Group>,
    /// Whether the triangle that begins at each slot has three distinct corners.
    is_shown: Vec<bool>,
    shown_count: usize,
}

#[derive(Clone, Copy, Debug)]
struct Group {
    first: u32,
    last: u32,
    size: u32,
}

impl SlotGroups {
    /// Starts with a strip whose slots show the groups `shown`, numbered consecutively from 0.
    pub(super) fn begin(&mut self, shown: &[u32], group_count: usize) {
        self.group_of.clear();
        self.group_of.extend_from_slice(shown);
        self.next.clear();
        self.next.resize(shown.len(), NONE);
        self.groups.clear();
        self.groups.resize(group_count, Group { first: NONE, last: NONE, size: 0 });
        for (slot, &g) in (0..).zip(shown) {
            let group = &mut self.groups[g as usize];
            if group.size == 0 {
                group.first = slot;
            } else {
                self.next[group.last as usize] = slot;
            }
            group.last = slot;
            group.size += 1;
        }
        self.is_shown.clear();
        self.is_shown.extend(shown.windows(3).map(|w| w[0] != w[1] && w[1] != w[2] && w[2] != w[0]));
        self.shown_count = self.is_shown.iter().filter(|&&is_shown| is_shown).count();
    }

    /// Whether the strip has any triangle left.
    pub(super) fn has_triangles(&self) -> bool {
        self.shown_count > 0
    }

    /// Merges two groups and returns the index of the result, which is one of the two.
    pub(super) fn merge(&mut self, a: u32, b: u32) -> u32 {
        let size = |group: u32| self.groups[group as usize].size;
        let (large, small) = if size(a) >= size(b) { (a, b) } else { (b, a) };
        let members = self.groups[small as usize];
        let mut slot = members.first;
        while slot != NONE {
            self.remove_triangles(slot as usize, large);
            self.group_of[slot as usize] = large;
            slot = self.next[slot as usize];
        }
        let group = &mut self.groups[large as usize];
        self.next[group.last as usize] = members.first;
        group.last = members.last;
        group.size += members.size;
        large
    }

    /// Removes the triangles that have a corner at `slot` and another in the group `other`.
    fn remove_triangles(&mut self, slot: usize, other: u32) {
        let end = (slot + 1).min(self.is_shown.len());
        for start in slot.saturating_sub(2)..end {
            if self.is_shown[start] && self.group_of[start..start + 3].contains(&other) {
                self.is_shown[start] = false;
                self.shown_count -= 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_vanish_when_two_corners_merge() {
        // Triangles 0 1 2, 1 2 3, 2 3 1 and 3 1 4.
        let mut groups = SlotGroups::default();
        groups.begin(&[0, 1, 2, 3, 1, 4], 5);
        assert_eq!(groups.is_shown, [true; 4]);
        let kept = groups.merge(4, 1);
        assert_eq!(kept, 1, "the larger one stays");
        assert_eq!(groups.is_shown, [true, true, true, false]);
        groups.merge(0, 3);
        assert_eq!(groups.is_shown, [true, true, true, false]);
        let kept = groups.merge(2, 1);
        assert_eq!(groups.is_shown, [false; 4]);
        assert!(!groups.has_triangles());
        assert_eq!((kept, groups.groups[1].size), (1, 4));
    }

    #[test]
    fn strip_may_be_too_short_for_a_triangle() {
        let mut groups = SlotGroups::default();
        for shown in [&[][..], &[0], &[0, 1]] {
            groups.begin(shown, shown.len());
            assert!(!groups.has_triangles());
        }
        groups.merge(0, 1);
        assert!(!groups.has_triangles());
    }
}
