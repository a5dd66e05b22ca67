//! Disjoint sets of small integers: which things hang together?
//!
//! The smaller number always becomes the root and paths are halved on the way, so results do not
//! depend on the order of joins. Practically O(1) a call.

/// Sets over `0..count`, each thing alone at first.
#[derive(Clone, Debug, Default)]
pub struct DisjointSets {
    parent: Vec<u32>,
}

impl DisjointSets {
    /// The sets of `count` things, each alone.
    pub fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).collect() }
    }

    /// Every thing alone again, `count` of them; memory is reused.
    pub fn reset(&mut self, count: usize) {
        self.parent.clear();
        self.parent.extend(0..count as u32);
    }

    /// The smallest member of the set.
    pub fn root(&mut self, mut thing: u32) -> u32 {
        loop {
            let parent = self.parent[thing as usize];
            if parent == thing {
                return thing;
            }
            let grandparent = self.parent[parent as usize];
            self.parent[thing as usize] = grandparent;
            thing = grandparent;
        }
    }

    /// Makes one set of two; false where they were one already.
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
    fn joins_count_once() {
        let mut sets = DisjointSets::new(6);
        assert!(sets.join(5, 3) && sets.join(3, 1) && sets.join(0, 2));
        assert!(!sets.join(1, 5));
        assert_eq!([0, 1, 2, 3, 4, 5].map(|x| sets.root(x)), [0, 1, 0, 1, 4, 1]);
        sets.reset(2);
        assert_eq!(sets.root(1), 1);
    }
}
