//! Which positions a batch takes: the cheapest share in order, as long as they keep out of each other's way.

/// What a batch has taken so far.
#[derive(Debug)]
pub(super) struct Selection {
    batch: u32,
    /// The batch in which a position was last on the ring of a removed one, and must therefore stay.
    ring: Vec<u32>,
    /// The batch in which a position was last a target.
    target: Vec<u32>,
}

impl Selection {
    pub(super) fn new(position_count: usize) -> Self {
        Self { batch: 0, ring: vec![0; position_count], target: vec![0; position_count] }
    }

    /// Forgets what the last batch took.
    pub(super) fn begin(&mut self) {
        self.batch += 1;
    }

    /// True where `v` is no neighbour of a position that is already removed, and no target.
    #[inline]
    pub(super) fn is_free(&self, v: u32) -> bool {
        self.ring[v as usize] != self.batch
    }

    /// True where no other position of the batch goes to `u`.
    #[inline]
    pub(super) fn is_free_target(&self, u: u32) -> bool {
        self.target[u as usize] != self.batch
    }

    /// Takes a position to `u`, one of its neighbours in `ring`.
    pub(super) fn take(&mut self, u: u32, ring: &[u32]) {
        for &w in ring {
            self.ring[w as usize] = self.batch;
        }
        self.target[u as usize] = self.batch;
    }
}

/// Fewest positions that a batch chooses from: a share of a few positions would be next to none.
const LEAST_CANDIDATES: usize = 24;

/// Leaves the cheapest `share` of the candidates, cheapest first; equal costs by number.
pub(super) fn keep_cheapest(candidates: &mut Vec<(f32, u32)>, share: f64) {
    let count = ((share * candidates.len() as f64).ceil() as usize).max(LEAST_CANDIDATES);
    let order = |a: &(f32, u32), b: &(f32, u32)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
    if count < candidates.len() {
        candidates.select_nth_unstable_by(count, order);
        candidates.truncate(count);
    }
    candidates.sort_unstable_by(order);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cheapest_share_comes_in_order() {
        let mut candidates: Vec<(f32, u32)> = (0..100).map(|i| (((i * 37) % 50) as f32, i)).collect();
        let mut all = candidates.clone();
        keep_cheapest(&mut candidates, 0.3);
        all.sort_by(|a, b| a.partial_cmp(b).expect("costs are numbers"));
        assert_eq!(candidates, all[..30]);
        keep_cheapest(&mut candidates, 0.01);
        assert_eq!(candidates, all[..LEAST_CANDIDATES], "never next to none");
    }

    #[test]
    fn taken_positions_keep_their_neighbours_until_the_next_batch() {
        let mut selection = Selection::new(6);
        selection.begin();
        selection.take(1, &[1, 2, 3]);
        assert!((1..4).all(|v| !selection.is_free(v)) && selection.is_free(4));
        assert!(!selection.is_free_target(1) && selection.is_free_target(2));
        selection.begin();
        assert!((0..6).all(|v| selection.is_free(v) && selection.is_free_target(v)));
    }
}
