//! Rules: what a fragment looks like, whatever vertices it joins \[KG98\].
//!
//! Vertices of a fragment have local numbers: those that the step restores first, then the others. A rule lists the triangles of
//! the ceiling and those of the floor by local numbers. Fragments that differ only by a rotation share a rule; mirror
//! images do not, since triangles are oriented.

/// Stands for no half-edge.
pub(super) const NONE: u32 = u32::MAX;

/// The triangles of a fragment in local numbers.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(in crate::model) struct Rule {
    /// Vertices that the step restores: the first local numbers.
    pub(super) own_count: u32,
    /// All local numbers.
    pub(super) local_count: u32,
    /// Each with its youngest corner first.
    pub(super) ceiling: Vec<[u32; 3]>,
    pub(super) floor: Vec<[u32; 3]>,
    /// Groups of the ceiling's triangles; empty in a model of one group.
    pub(super) ceiling_groups: Vec<u32>,
    pub(super) floor_groups: Vec<u32>,
    /// Local numbers that the ceiling and the floor do not both show: they are listed for each fragment.
    pub(super) extras: Vec<u32>,
    /// For corner `c` of floor triangle `j`, at `3 j + c`: the same vertex's corner in the next triangle around it.
    pub(super) next_around: Vec<u32>,
}

impl Rule {
    /// Completes a rule that has its triangles.
    pub(super) fn completed(mut self) -> Self {
        // Behind the own ones alone: of these a damaged file may claim any number.
        let mut shown = vec![0u8; (self.local_count - self.own_count) as usize];
        for (bit, triangles) in [(1, &self.ceiling), (2, &self.floor)] {
            for place in triangles.iter().flatten().filter_map(|local| local.checked_sub(self.own_count)) {
                shown[place as usize] |= bit;
            }
        }
        let is_extra = |&local: &u32| shown[(local - self.own_count) as usize] != 3;
        self.extras = (self.own_count..self.local_count).filter(is_extra).collect();
        self.next_around = next_around(&self.floor);
        self
    }
}

/// For each corner of a floor the corner of the same vertex in the next triangle around it, if there is exactly one.
fn next_around(floor: &[[u32; 3]]) -> Vec<u32> {
    let corner = |h: usize| floor[h / 3][h % 3];
    let after = |h: usize| floor[h / 3][(h + 1 - h / 3 * 3) % 3];
    let before = |h: usize| floor[h / 3][(h + 2 - h / 3 * 3) % 3];
    let mut starts: Vec<(u32, u32, usize)> = (0..3 * floor.len()).map(|h| (corner(h), after(h), h)).collect();
    starts.sort_unstable();
    let next = |h: usize| {
        let wanted = (corner(h), before(h));
        let at = starts.partition_point(|s| (s.0, s.1) < wanted);
        let mut equal = starts[at..].iter().take_while(|s| (s.0, s.1) == wanted);
        match (equal.next(), equal.next()) {
            (Some(one), None) => one.2 as u32,
            _ => NONE,
        }
    };
    (0..3 * floor.len()).map(next).collect()
}

/// A triangle turned so that a corner comes first.
pub(super) fn first_corner([a, b, c]: [u32; 3], first: u32) -> [u32; 3] {
    if a == first {
        [a, b, c]
    } else if b == first {
        [b, c, a]
    } else {
        [c, a, b]
    }
}
