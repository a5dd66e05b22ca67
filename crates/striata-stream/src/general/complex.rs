//! [`Complex`]: triangles indexed by position, updated step by step.
//!
//! A general step may apply anywhere: at edges of many triangles, at a position that two parts share, at
//! one without triangles. The only assumption here is that each triangle has three positions.

use crate::topology::surface::NONE;

/// Linked lists of the corners at each position. Corner `i` of triangle `t` is `3 t + i`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Complex {
    /// First corner at each position, or `NONE`.
    first: Vec<u32>,
    /// For each corner, the next corner at the same position, or `NONE`.
    next: Vec<u32>,
    /// Position of each corner.
    positions: Vec<u32>,
}

impl Complex {
    /// Builds the lists for triangles over `position_count` positions.
    pub(crate) fn new(triangles: &[[u32; 3]], position_count: usize) -> Self {
        let mut complex = Self { first: vec![NONE; position_count], ..Self::default() };
        complex.next.reserve(3 * triangles.len());
        complex.positions.reserve(3 * triangles.len());
        triangles.iter().for_each(|&t| complex.push_triangle(t));
        complex
    }

    /// Returns the number of positions.
    pub(crate) fn position_count(&self) -> usize {
        self.first.len()
    }

    /// Returns the positions of a triangle.
    pub(crate) fn triangle(&self, triangle: u32) -> [u32; 3] {
        let at = 3 * triangle as usize;
        [self.positions[at], self.positions[at + 1], self.positions[at + 2]]
    }

    /// Returns the positions of all triangles.
    pub(crate) fn triangles(&self) -> Vec<[u32; 3]> {
        self.positions.as_chunks::<3>().0.to_vec()
    }

    /// Appends a position without triangles.
    pub(crate) fn push_position(&mut self) {
        self.first.push(NONE);
    }

    /// Appends a triangle.
    pub(crate) fn push_triangle(&mut self, positions: [u32; 3]) {
        for position in positions {
            let corner = self.positions.len() as u32;
            self.positions.push(position);
            self.next.push(std::mem::replace(&mut self.first[position as usize], corner));
        }
    }

    /// Returns the corners at a position.
    pub(crate) fn corners(&self, position: u32) -> impl Iterator<Item = u32> + '_ {
        let begin = Some(self.first[position as usize]).filter(|&corner| corner != NONE);
        std::iter::successors(begin, |&corner| {
            Some(self.next[corner as usize]).filter(|&corner| corner != NONE)
        })
    }

    /// Returns the other two positions of a corner's triangle, in winding order.
    pub(crate) fn edge(&self, corner: u32) -> [u32; 2] {
        let (t, i) = (corner / 3 * 3, corner % 3);
        [(i + 1) % 3, (i + 2) % 3].map(|j| self.positions[(t + j) as usize])
    }

    /// Moves the corners `moved`, given in the order of [`Self::corners`], from position `from` to the last
    /// position.
    pub(crate) fn move_to_last(&mut self, from: u32, moved: &[u32]) {
        let to = self.first.len() as u32 - 1;
        let mut rest = moved.iter().copied().peekable();
        let mut here = self.first[from as usize];
        let mut lasts = [NONE; 2];
        let mut firsts = [NONE, self.first[to as usize]];
        while here != NONE {
            let after = self.next[here as usize];
            let side = usize::from(rest.next_if_eq(&here).is_some());
            if side == 1 {
                self.positions[here as usize] = to;
            }
            match lasts[side] {
                NONE => firsts[side] = here,
                last => self.next[last as usize] = here,
            }
            lasts[side] = here;
            self.next[here as usize] = NONE;
            here = after;
        }
        [self.first[from as usize], self.first[to as usize]] = firsts;
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;

    #[test]
    fn corner_lists_follow_every_change() {
        let mut random = Random::new(5);
        let mut triangles = vec![[0, 1, 2], [0, 2, 3], [0, 1, 2], [2, 1, 3]];
        let mut complex = Complex::new(&triangles, 4);
        for _ in 0..200 {
            let from = random.below(complex.position_count() as u32);
            let moved: Vec<u32> = complex.corners(from).filter(|_| random.below(3) == 0).collect();
            complex.push_position();
            let to = complex.position_count() as u32 - 1;
            complex.move_to_last(from, &moved);
            moved.iter().for_each(|&c| triangles[c as usize / 3][c as usize % 3] = to);
            let new = [to, from, random.below(to)];
            if new[1] != new[2] {
                complex.push_triangle(new);
                triangles.push(new);
            }
            assert_eq!(complex.triangles(), triangles);
            for p in 0..=to {
                let mut found: Vec<u32> = complex.corners(p).collect();
                found.sort_unstable();
                let expected: Vec<u32> = (0..3 * triangles.len() as u32)
                    .filter(|&c| triangles[c as usize / 3][c as usize % 3] == p)
                    .collect();
                assert_eq!(found, expected);
                for c in found {
                    let t = complex.triangle(c / 3);
                    assert_eq!(complex.edge(c), [t[(c as usize + 1) % 3], t[(c as usize + 2) % 3]]);
                }
            }
        }
    }
}
