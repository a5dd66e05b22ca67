//! Disjoint sets of small integers (union-find), for finding connected components.
//!
//! The smaller member always becomes the root and paths are halved on the way, so results do not depend on
//! the order of joins. Practically O(1) per call.

/// Disjoint sets over the elements `0..count`.
#[derive(Clone, Debug, Default)]
pub struct DisjointSets {
    parent: Vec<u32>,
}

impl DisjointSets {
    /// Creates `count` sets of one element each.
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect() }
    }

    /// Resets to `count` sets of one element each, reusing memory.
    pub fn reset(&mut self, count: usize) {
        self.parent.clear();
        self.parent.extend(0..count as u32);
    }

    /// The smallest element of the set that contains `element`.
    pub fn root(&mut self, mut element: u32) -> u32 {
        loop {
            let parent = self.parent[element as usize];
            if parent == element {
                return element;
            }
            let grandparent = self.parent[parent as usize];
            self.parent[element as usize] = grandparent;
            element = grandparent;
        }
    }

    /// Merges the sets of two elements; returns false if they were already in the same set.
    pub fn join(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b) as usize] = a.min(b);
        a != b
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn join_reports_whether_sets_were_merged() {
        let mut sets = DisjointSets::new(6);
        assert!(sets.join(5, 3) && sets.join(3, 1) && sets.join(0, 2));
        assert!(!sets.join(1, 5));
        assert_eq!([0, 1, 2, 3, 4, 5].map(|x| sets.root(x)), [0, 1, 0, 1, 4, 1]);
        sets.reset(2);
        assert_eq!(sets.root(1), 1);
    }
}
