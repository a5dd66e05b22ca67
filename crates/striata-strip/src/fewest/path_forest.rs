//! Strips as splay trees: find, join, cut and reverse in logarithmic time.
//!
//! Every strip is a splay tree \[ST85\] whose order from left to right is that of its triangles. Reversing
//! a strip sets one mark at the root, which is pushed down as nodes are visited. The cost therefore does
//! not depend on the length of strips, which at the end of a search are as long as the mesh. 16 bytes per
//! triangle; every operation takes amortized `O(log n)`.

/// Marks a missing tree node.
const NONE: u32 = u32::MAX;

/// Strips of triangles, as a forest of splay trees.
#[derive(Debug)]
pub(super) struct PathForest {
    nodes: Vec<SplayNode>,
    /// Nodes from the one to be splayed up to its root.
    above: Vec<u32>,
}

/// Node of a splay tree: one triangle of a strip.
#[derive(Clone, Copy, Debug)]
struct SplayNode {
    parent: u32,
    children: [u32; 2],
    is_reversed: bool,
}

impl PathForest {
    /// Creates a forest of `count` triangles, each a strip by itself.
    pub(super) fn new(count: usize) -> Self {
        let alone = SplayNode { parent: NONE, children: [NONE; 2], is_reversed: false };
        Self { nodes: vec![alone; count], above: Vec::new() }
    }

    /// Joins triangles that are single strips into one strip in this order, as a balanced tree.
    pub(super) fn chain(&mut self, triangles: &[u32]) {
        self.balance(triangles);
    }

    /// Builds a balanced tree over these triangles and returns its root.
    fn balance(&mut self, triangles: &[u32]) -> u32 {
        if triangles.is_empty() {
            return NONE;
        }
        let (before, rest) = triangles.split_at(triangles.len() / 2);
        let (middle, after) = (rest[0], &rest[1..]);
        // The recursion is as deep as the logarithm of the strip's length.
        for (k, part) in [before, after].into_iter().enumerate() {
            let child = self.balance(part);
            self.nodes[middle as usize].children[k] = child;
            if child != NONE {
                self.nodes[child as usize].parent = middle;
            }
        }
        middle
    }

    /// Returns on which side of `b` the triangle `a` lies (0 or 1, valid until the next change), or
    /// [`None`] if the two different triangles are in different strips.
    pub(super) fn side_of(&mut self, a: u32, b: u32) -> Option<usize> {
        self.splay(a);
        self.splay(b);
        let mut node = a;
        loop {
            let parent = self.nodes[node as usize].parent;
            if parent == NONE {
                return None;
            }
            if parent == b {
                return Some(usize::from(self.nodes[b as usize].children[1] == node));
            }
            node = parent;
        }
    }

    /// Returns the neighbor of `triangle` on this side along the strip.
    pub(super) fn neighbor(&mut self, triangle: u32, side: usize) -> Option<u32> {
        self.splay(triangle);
        let mut node = self.nodes[triangle as usize].children[side];
        if node == NONE {
            return None;
        }
        loop {
            self.push_down(node);
            match self.nodes[node as usize].children[1 - side] {
                NONE => break,
                inner => node = inner,
            }
        }
        self.splay(node);
        Some(node)
    }

    /// Cuts a strip between two consecutive triangles.
    pub(super) fn cut(&mut self, a: u32, b: u32) {
        let side = self.side_of(a, b);
        debug_assert!(side.is_some(), "triangles {a} and {b} lie in different strips");
        if let Some(side) = side {
            let child = std::mem::replace(&mut self.nodes[b as usize].children[side], NONE);
            self.nodes[child as usize].parent = NONE;
        }
    }

    /// Joins two strips at two of their ends.
    pub(super) fn join(&mut self, a: u32, b: u32) {
        for (end, outer) in [(a, 1), (b, 0)] {
            self.splay(end);
            if self.nodes[end as usize].children[outer] != NONE {
                self.nodes[end as usize].is_reversed ^= true;
                self.push_down(end);
            }
            debug_assert_eq!(self.nodes[end as usize].children[outer], NONE, "triangle {end} is no end");
        }
        self.nodes[a as usize].children[1] = b;
        self.nodes[b as usize].parent = a;
    }

    /// Applies a pending reversal to a node and passes it on to the children.
    fn push_down(&mut self, node: u32) {
        let SplayNode { children, is_reversed, .. } = self.nodes[node as usize];
        if is_reversed {
            self.nodes[node as usize].children = [children[1], children[0]];
            self.nodes[node as usize].is_reversed = false;
            for child in children.into_iter().filter(|&child| child != NONE) {
                self.nodes[child as usize].is_reversed ^= true;
            }
        }
    }

    /// Moves a node to the root of its tree.
    fn splay(&mut self, node: u32) {
        let mut above = std::mem::take(&mut self.above);
        above.clear();
        let mut at = node;
        while at != NONE {
            above.push(at);
            at = self.nodes[at as usize].parent;
        }
        for &at in above.iter().rev() {
            self.push_down(at);
        }
        self.above = above;
        loop {
            let parent = self.nodes[node as usize].parent;
            if parent == NONE {
                return;
            }
            let grandparent = self.nodes[parent as usize].parent;
            if grandparent != NONE {
                let is_straight = self.child_side(grandparent, parent) == self.child_side(parent, node);
                self.rotate(if is_straight { parent } else { node });
            }
            self.rotate(node);
        }
    }

    fn child_side(&self, parent: u32, child: u32) -> usize {
        usize::from(self.nodes[parent as usize].children[1] == child)
    }

    /// Swaps a node with its parent and keeps the order.
    fn rotate(&mut self, node: u32) {
        let parent = self.nodes[node as usize].parent;
        let grandparent = self.nodes[parent as usize].parent;
        let side = self.child_side(parent, node);
        let inner = self.nodes[node as usize].children[1 - side];
        self.nodes[parent as usize].children[side] = inner;
        if inner != NONE {
            self.nodes[inner as usize].parent = parent;
        }
        self.nodes[node as usize].children[1 - side] = parent;
        if grandparent != NONE {
            let side = self.child_side(grandparent, parent);
            self.nodes[grandparent as usize].children[side] = node;
        }
        self.nodes[parent as usize].parent = node;
        self.nodes[node as usize].parent = grandparent;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::Random;

    /// Strips as plain lists.
    struct Lists(Vec<Vec<u32>>);

    impl Lists {
        fn find(&self, triangle: u32) -> (usize, usize) {
            let strip = self.0.iter().position(|list| list.contains(&triangle)).unwrap();
            (strip, self.0[strip].iter().position(|&t| t == triangle).unwrap())
        }
    }

    #[test]
    fn trees_agree_with_lists() {
        let mut random = Random::new(3);
        let mut forest = PathForest::new(40);
        let mut lists = Lists((0..40).map(|t| vec![t]).collect());
        for _ in 0..4000 {
            let (a, b) = (random.below(40), random.below(40));
            if a == b {
                continue;
            }
            let ((s, i), (r, j)) = (lists.find(a), lists.find(b));
            assert_eq!(forest.side_of(a, b).is_some(), s == r);
            let is_end = |list: &Vec<u32>, index: usize| index == 0 || index + 1 == list.len();
            if s != r && is_end(&lists.0[s], i) && is_end(&lists.0[r], j) {
                forest.join(a, b);
                let mut second = std::mem::take(&mut lists.0[r]);
                if j > 0 {
                    second.reverse();
                }
                if i == 0 {
                    lists.0[s].reverse();
                }
                lists.0[s].append(&mut second);
            } else if s == r && i.abs_diff(j) == 1 {
                forest.cut(a, b);
                let tail = lists.0[s].split_off(i.max(j));
                lists.0.push(tail);
            } else if s == r {
                // The neighbor of `b` toward `a`.
                let side = forest.side_of(a, b).unwrap();
                let expected = lists.0[s][if i < j { j - 1 } else { j + 1 }];
                assert_eq!(forest.neighbor(b, side), Some(expected));
            }
        }
    }

    #[test]
    fn a_balanced_chain_is_in_order() {
        let mut forest = PathForest::new(9);
        forest.chain(&[4, 2, 7, 0, 8]);
        let side = forest.side_of(4, 2).unwrap();
        assert_eq!(forest.neighbor(2, 1 - side), Some(7));
        assert_eq!(forest.neighbor(4, side), None);
        assert_eq!(forest.side_of(4, 1), None);
    }
}
