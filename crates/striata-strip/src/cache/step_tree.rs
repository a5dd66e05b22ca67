//! Tree of the steps of all search states, whose common trunk is final.

use super::beam_state::{DrawStep, ROOT};

/// Number of steps in which states may differ; beyond it, those that diverged earliest from the best are
/// dropped.
const MAX_DEPTH: usize = 384;

/// Step and its predecessor.
#[derive(Clone, Copy)]
struct StepNode {
    parent: u32,
    step: DrawStep,
}

/// Steps of all states, each with its predecessor.
#[derive(Default)]
pub(super) struct StepTree {
    nodes: Vec<StepNode>,
}

impl StepTree {
    /// Adds a step after `parent` and returns its node.
    pub(super) fn push(&mut self, parent: u32, step: DrawStep) -> u32 {
        self.nodes.push(StepNode { parent, step });
        self.nodes.len() as u32 - 1
    }

    /// Returns the nodes from the root to a leaf.
    fn path(&self, leaf: u32) -> Vec<u32> {
        let parent = |&node: &u32| Some(self.nodes[node as usize].parent).filter(|&parent| parent != ROOT);
        let mut path: Vec<u32> =
            std::iter::successors(Some(leaf).filter(|&leaf| leaf != ROOT), parent).collect();
        path.reverse();
        path
    }

    /// Moves the steps that all leaves share to `trunk` and renumbers the leaves; the first leaf is the best.
    ///
    /// Leaves that diverged too early from the best one become [`None`].
    pub(super) fn cut_trunk(&mut self, leaves: &mut [Option<u32>], trunk: &mut Vec<DrawStep>) {
        let Some(Some(best)) = leaves.first().copied() else { return };
        let path = self.path(best);
        let mut index_on_path = vec![usize::MAX; self.nodes.len()];
        for (index, &node) in path.iter().enumerate() {
            index_on_path[node as usize] = index;
        }
        let min_shared_count = if path.len() > MAX_DEPTH { path.len() - MAX_DEPTH / 2 } else { 0 };
        let mut shared_count = path.len();
        for leaf in leaves.iter_mut() {
            let count = leaf.map_or(0, |leaf| self.shared_count(leaf, &index_on_path));
            if count < min_shared_count {
                *leaf = None;
            } else {
                shared_count = shared_count.min(count);
            }
        }
        trunk.extend(path[..shared_count].iter().map(|&node| self.nodes[node as usize].step));
        let mut renumbered = vec![ROOT; self.nodes.len()];
        let mut remaining = Self::default();
        for leaf in leaves.iter_mut().flatten() {
            let branch = self.path(*leaf);
            let mut parent = ROOT;
            for &node in &branch[shared_count..] {
                if renumbered[node as usize] == ROOT {
                    renumbered[node as usize] = remaining.push(parent, self.nodes[node as usize].step);
                }
                parent = renumbered[node as usize];
            }
            *leaf = parent;
        }
        *self = remaining;
    }

    /// Number of steps that a leaf's path shares with the best one's.
    fn shared_count(&self, leaf: u32, index_on_path: &[usize]) -> usize {
        let mut node = leaf;
        while node != ROOT && index_on_path[node as usize] == usize::MAX {
            node = self.nodes[node as usize].parent;
        }
        if node == ROOT { 0 } else { index_on_path[node as usize] + 1 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_trunk_is_cut_off_once() {
        let mut steps = StepTree::default();
        let a = steps.push(ROOT, DrawStep::Start(0));
        let b = steps.push(a, DrawStep::Cross(1));
        let left = steps.push(b, DrawStep::Cross(2));
        let right = steps.push(b, DrawStep::Cross(3));
        let mut leaves = [Some(left), Some(right)];
        let mut trunk = Vec::new();
        steps.cut_trunk(&mut leaves, &mut trunk);
        assert_eq!(trunk, [DrawStep::Start(0), DrawStep::Cross(1)]);
        let mut leaves = [leaves[1]];
        steps.cut_trunk(&mut leaves, &mut trunk);
        assert_eq!(trunk, [DrawStep::Start(0), DrawStep::Cross(1), DrawStep::Cross(3)]);
        assert_eq!(leaves, [Some(ROOT)]);
        steps.cut_trunk(&mut leaves, &mut trunk);
        assert_eq!(trunk.len(), 3);
    }

    #[test]
    fn leaves_that_diverged_early_are_dropped() {
        let mut steps = StepTree::default();
        let mut grow = |mut leaf, count| {
            for side in 0..count {
                leaf = steps.push(leaf, DrawStep::Cross(side));
            }
            leaf
        };
        let trunk_end = grow(ROOT, 100);
        let best = grow(trunk_end, 400);
        let near = grow(best, 1);
        let far = grow(trunk_end, 401);
        let mut leaves = [Some(near), Some(far), Some(best)];
        let mut trunk = Vec::new();
        steps.cut_trunk(&mut leaves, &mut trunk);
        assert_eq!((trunk.len(), leaves[1], leaves[2]), (500, None, Some(ROOT)));
        assert_eq!(steps.nodes.len(), 1);
    }
}
