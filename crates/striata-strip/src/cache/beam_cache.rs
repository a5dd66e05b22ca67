//! Vertex cache of one search state, with the number of undrawn triangles around each cached vertex.

use striata::mesh::NO_TWIN as NO_VERTEX;

/// First-in first-out cache that counts undrawn triangles.
#[derive(Clone)]
pub(super) struct BeamCache {
    vertices: Vec<u32>,
    /// Number of undrawn triangles around each entry.
    opens: Vec<u32>,
    /// Entry that is replaced next.
    oldest: usize,
}

impl BeamCache {
    /// An empty cache.
    pub(super) fn new(size: usize) -> Self {
        Self { vertices: vec![NO_VERTEX; size], opens: vec![0; size], oldest: 0 }
    }

    /// Returns the number of entries.
    pub(super) fn size(&self) -> usize {
        self.vertices.len()
    }

    /// Copies another cache of the same size, without the size checks of `clone_from`.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.vertices.copy_from_slice(&other.vertices);
        self.opens.copy_from_slice(&other.opens);
        self.oldest = other.oldest;
    }

    /// Returns the slot of a vertex, if it is cached.
    #[inline]
    pub(super) fn slot(&self, v: u32) -> Option<usize> {
        // Without an early exit the comparisons are vectorized; slots count from 1 here.
        let found = self.vertices.iter().zip(1u32..).fold(
            0,
            |found, (&cached, slot)| {
                if cached == v { slot } else { found }
            },
        );
        (found > 0).then(|| found as usize - 1)
    }

    /// Number of misses since an entry came in.
    #[inline]
    pub(super) fn age(&self, slot: usize) -> usize {
        let beyond = if slot < self.oldest { 0 } else { self.size() };
        self.oldest + beyond - slot - 1
    }

    /// Number of undrawn triangles around an entry.
    #[inline]
    pub(super) fn open(&self, slot: usize) -> u32 {
        self.opens[slot]
    }

    /// Iterates over the entries with undrawn triangles, the oldest first: vertex and age.
    pub(super) fn open_vertices(&self) -> impl Iterator<Item = (u32, usize)> {
        let slots = (self.oldest..self.size()).chain(0..self.oldest);
        let by_age = slots.zip((0..self.size()).rev());
        by_age.filter(|&(slot, _)| self.opens[slot] > 0).map(|(slot, age)| (self.vertices[slot], age))
    }

    /// Records that a triangle with these corners has been drawn.
    pub(super) fn draw(&mut self, corners: [u32; 3]) {
        for v in corners {
            if let Some(slot) = self.slot(v) {
                self.opens[slot] -= 1;
            }
        }
    }

    /// Adds a vertex in place of the oldest one.
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
    fn the_oldest_entry_is_replaced_first() {
        let mut cached = BeamCache::new(3);
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
