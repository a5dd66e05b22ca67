//! Rules: the shape of a fragment, independent of its vertices \[KG98\].
//!
//! The vertices of a fragment are numbered locally: first those that the step restores, then the others. A
//! rule lists the triangles of the ceiling and the floor in these local indices. Fragments that differ
//! only by a rotation share a rule; mirror images do not, because triangles are oriented.

/// Marks a missing half-edge.
pub(super) const NONE: u32 = u32::MAX;

/// The triangles of a fragment in local vertex indices.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub(in crate::model) struct Rule {
    /// Number of vertices that the step restores; they have the first local indices.
    pub own_count: u32,
    /// Number of local vertices.
    pub local_count: u32,
    /// Triangles of the ceiling, each with its youngest corner first.
    pub ceiling: Vec<[u32; 3]>,
    pub floor: Vec<[u32; 3]>,
    /// Group of each ceiling triangle; empty if the model has only one group.
    pub ceiling_groups: Vec<u32>,
    pub floor_groups: Vec<u32>,
    /// Local vertices that are missing from the ceiling or the floor; each fragment lists them explicitly.
    pub extras: Vec<u32>,
    /// For corner `c` of floor triangle `j`, at `3 j + c`: the corner of the same vertex in the next
    /// triangle around it.
    pub next_around: Vec<u32>,
    /// Half-edges by their code: first those to which `next_around` does not lead, then those to which it
    /// leads from these, and so on. A run usually begins at one of the first.
    pub starts: Vec<u32>,
}

impl Rule {
    /// Derives the remaining fields from the triangles.
    pub(super) fn completed(mut self) -> Self {
        // Own vertices are left out, because a damaged file could claim any number of them.
        let mut shown = vec![0u8; (self.local_count - self.own_count) as usize];
        for (bit, triangles) in [(1, &self.ceiling), (2, &self.floor)] {
            for index in triangles.iter().flatten().filter_map(|local| local.checked_sub(self.own_count)) {
                shown[index as usize] |= bit;
            }
        }
        let is_extra = |&local: &u32| shown[(local - self.own_count) as usize] != 3;
        self.extras = (self.own_count..self.local_count).filter(is_extra).collect();
        self.next_around = next_around(&self.floor);
        self.starts = starts(&self.next_around);
        self
    }
}

/// Orders half-edges by how many others precede them around their vertex; those around a vertex inside the
/// floor, which are all preceded by others, come last.
fn starts(next_around: &[u32]) -> Vec<u32> {
    let count = next_around.len();
    let mut is_led_to = vec![false; count];
    next_around.iter().filter(|&&next| next != NONE).for_each(|&next| is_led_to[next as usize] = true);
    let mut depths = vec![count; count];
    for first in (0..count).filter(|&half_edge| !is_led_to[half_edge]) {
        let (mut at, mut depth) = (first, 0);
        while depths[at] == count {
            depths[at] = depth;
            depth += 1;
            at = match next_around[at] {
                NONE => break,
                next => next as usize,
            };
        }
    }
    let mut starts: Vec<u32> = (0..count as u32).collect();
    starts.sort_by_key(|&half_edge| depths[half_edge as usize]);
    starts
}

/// For each corner of a floor, finds the corner of the same vertex in the next triangle around it, if it
/// is unique.
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

/// Rotates a triangle so that the given corner comes first.
pub(super) fn first_corner([a, b, c]: [u32; 3], first: u32) -> [u32; 3] {
    if a == first {
        [a, b, c]
    } else if b == first {
        [b, c, a]
    } else {
        [c, a, b]
    }
}
