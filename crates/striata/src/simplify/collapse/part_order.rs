//! Keys by which the steps of many parts of a mesh merge into one sequence.
//!
//! A step depends on the last step that changed a triangle at its position. Its key is therefore at least the key of
//! that one; and it is at least the largest cost at which any step has left the queue of the part before, because that
//! is when the step would have been applied. Steps sorted by key, and by part and order within it if keys are equal,
//! form a valid sequence, which is nearly that of one queue for all parts.

use super::executor::CollapseExecutor;

/// The keys of a part.
#[derive(Debug, Default)]
pub(in crate::simplify) struct PartOrder {
    /// For each position, the key of the last step that changed a triangle at it.
    pub latest: Vec<f32>,
    /// Key of each step.
    pub keys: Vec<f32>,
    /// The largest cost so far.
    reached: f32,
}

impl PartOrder {
    pub(in crate::simplify) fn new(latest: Vec<f32>) -> Self {
        Self { latest, keys: Vec::new(), reached: 0.0 }
    }

    /// Computes the keys of the positions that the last collapse removed, which left the queue at this cost.
    pub(in crate::simplify) fn note(&mut self, executor: &CollapseExecutor, cost: f32) {
        self.reached = self.reached.max(cost);
        let mut key = self.reached;
        for &v in executor.last_removed() {
            key = key.max(self.latest[v as usize]);
            self.keys.push(key);
            // Every position of the mesh of a part has one vertex. The target need not be a neighbor.
            let target = executor.record.targets[v as usize];
            for &w in executor.ring.iter().chain([&target]) {
                let latest = &mut self.latest[w as usize];
                *latest = latest.max(key);
            }
        }
    }
}
