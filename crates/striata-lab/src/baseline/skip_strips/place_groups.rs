//! Which places of a strip show the same vertex, while its vertices collapse one by one.
//!
//! Groups are united by relabeling the smaller one, so all unions of a strip of `n` places take `n log n` steps,
//! and each looks at the triangles that it may take away.

/// The end of a list of places.
const NONE: u32 = u32::MAX;

/// The places of one strip in groups, and which of its triangles are left.
#[derive(Debug, Default)]
pub(super) struct PlaceGroups {
    group_of: Vec<u32>,
    /// The next place of the same group.
    next: Vec<u32>,
    groups: Vec<Group>,
    /// Whether the triangle that begins at a place has three corners.
    is_shown: Vec<bool>,
    shown_count: usize,
}

#[derive(Clone, Copy, Debug)]
struct Group {
    first: u32,
    last: u32,
    size: u32,
}

impl PlaceGroups {
    /// Begins with a strip whose places show the groups `shown`, numbered from 0 without gaps.
    pub(super) fn begin(&mut self, shown: &[u32], group_count: usize) {
        self.group_of.clear();
        self.group_of.extend_from_slice(shown);
        self.next.clear();
        self.next.resize(shown.len(), NONE);
        self.groups.clear();
        self.groups.resize(group_count, Group { first: NONE, last: NONE, size: 0 });
        for (place, &g) in (0..).zip(shown) {
            let group = &mut self.groups[g as usize];
            if group.size == 0 {
                group.first = place;
            } else {
                self.next[group.last as usize] = place;
            }
            group.last = place;
            group.size += 1;
        }
        self.is_shown.clear();
        self.is_shown.extend(shown.windows(3).map(|w| w[0] != w[1] && w[1] != w[2] && w[2] != w[0]));
        self.shown_count = self.is_shown.iter().filter(|&&is_shown| is_shown).count();
    }

    /// Whether the strip has a triangle left.
    pub(super) fn has_triangles(&self) -> bool {
        self.shown_count > 0
    }

    /// Makes one group of two; returns its number, which is that of one of them.
    pub(super) fn unite(&mut self, a: u32, b: u32) -> u32 {
        let size = |group: u32| self.groups[group as usize].size;
        let (large, small) = if size(a) >= size(b) { (a, b) } else { (b, a) };
        let members = self.groups[small as usize];
        let mut place = members.first;
        while place != NONE {
            self.take_triangles(place as usize, large);
            self.group_of[place as usize] = large;
            place = self.next[place as usize];
        }
        let group = &mut self.groups[large as usize];
        self.next[group.last as usize] = members.first;
        group.last = members.last;
        group.size += members.size;
        large
    }

    /// Takes away the triangles that have a corner at `place` and one in the other group.
    fn take_triangles(&mut self, place: usize, other: u32) {
        let end = (place + 1).min(self.is_shown.len());
        for start in place.saturating_sub(2)..end {
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
    fn triangles_go_when_two_of_their_corners_meet() {
        // Triangles 0 1 2, 1 2 3, 2 3 1 and 3 1 4.
        let mut groups = PlaceGroups::default();
        groups.begin(&[0, 1, 2, 3, 1, 4], 5);
        assert_eq!(groups.is_shown, [true; 4]);
        let kept = groups.unite(4, 1);
        assert_eq!(kept, 1, "the larger one stays");
        assert_eq!(groups.is_shown, [true, true, true, false]);
        groups.unite(0, 3);
        assert_eq!(groups.is_shown, [true, true, true, false]);
        let kept = groups.unite(2, 1);
        assert_eq!(groups.is_shown, [false; 4]);
        assert!(!groups.has_triangles());
        assert_eq!((kept, groups.groups[1].size), (1, 4));
    }

    #[test]
    fn a_strip_may_be_too_short_for_a_triangle() {
        let mut groups = PlaceGroups::default();
        for shown in [&[][..], &[0], &[0, 1]] {
            groups.begin(shown, shown.len());
            assert!(!groups.has_triangles());
        }
        groups.unite(0, 1);
        assert!(!groups.has_triangles());
    }
}
