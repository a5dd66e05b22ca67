//! The vertex cache of one partial answer, and how much is still to be drawn around each cached vertex.

use striata::mesh::NO_TWIN as NO_VERTEX;

/// A first-in first-out cache.
#[derive(Clone)]
pub(super) struct Cached {
    vertices: Vec<u32>,
    /// Undrawn triangles around each.
    opens: Vec<u32>,
    /// The entry that goes next.
    oldest: usize,
}

impl Cached {
    /// An empty cache.
    pub(super) fn new(size: usize) -> Self {
        Self { vertices: vec![NO_VERTEX; size], opens: vec![0; size], oldest: 0 }
    }

    pub(super) fn size(&self) -> usize {
        self.vertices.len()
    }

    /// Does as `clone_from`, without asking for sizes.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.vertices.copy_from_slice(&other.vertices);
        self.opens.copy_from_slice(&other.opens);
        self.oldest = other.oldest;
    }

    #[inline]
    pub(super) fn slot(&self, v: u32) -> Option<usize> {
        // Without an early end the comparisons go side by side; slots count from 1 here.
        let found = self.vertices.iter().zip(1u32..).fold(
            0,
            |found, (&cached, slot)| {
                if cached == v { slot } else { found }
            },
        );
        (found > 0).then(|| found as usize - 1)
    }

    /// Misses since an entry came in.
    #[inline]
    pub(super) fn age(&self, slot: usize) -> usize {
        let beyond = if slot < self.oldest { 0 } else { self.size() };
        self.oldest + beyond - slot - 1
    }

    /// Undrawn triangles around an entry.
    #[inline]
    pub(super) fn open(&self, slot: usize) -> u32 {
        self.opens[slot]
    }

    /// Entries with undrawn triangles around them, the oldest first: vertex and age.
    pub(super) fn open_vertices(&self) -> impl Iterator<Item = (u32, usize)> {
        let slots = (self.oldest..self.size()).chain(0..self.oldest);
        let by_age = slots.zip((0..self.size()).rev());
        by_age.filter(|&(slot, _)| self.opens[slot] > 0).map(|(slot, age)| (self.vertices[slot], age))
    }

    /// A triangle with these corners has been drawn.
    pub(super) fn draw(&mut self, corners: [u32; 3]) {
        for v in corners {
            if let Some(slot) = self.slot(v) {
                self.opens[slot] -= 1;
            }
        }
    }

    /// A vertex comes in, and the oldest goes.
    pub(super) fn push(&mut self, v: u32, open: u32) {
        self.vertices[self.oldest] = v;
        self.opens[self.oldest] = open;
        self.oldest = if self.oldest + 1 == self.size() { 0 } else { self.oldest + 1 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_oldest_goes_first() {
        let mut cached = Cached::new(3);
        for (v, open) in [(7, 1), (8, 0), (9, 2), (5, 3)] {
            cached.push(v, open);
        }
        assert_eq!(cached.slot(7), None);
        assert_eq!(cached.open_vertices().collect::<Vec<_>>(), [(9, 1), (5, 0)]);
        assert_eq!([8, 9, 5].map(|v| cached.age(cached.slot(v).unwrap())), [2, 1, 0]);
        cached.draw([9, 5, 7]);
        assert_eq!([9, 5].map(|v| cached.open(cached.slot(v).unwrap())), [1, 2]);
    }
}
