//! Selects the positions of a batch: the cheapest share, in order of cost, without conflicts.

use crate::simplify::collapse::links::Links;

/// How far each neighbor that is also a candidate moves a candidate back, as a share of all candidates.
/// This makes batches a few percent larger, so that fewer vertices need a split flag; a larger weight
/// increases the error for almost no gain.
const CROWD_WEIGHT: f32 = 0.1;

/// Positions selected for the current batch.
#[derive(Debug)]
pub(super) struct Selection {
    batch: u32,
    /// The batch in which each position was last in the ring of a removed one, and therefore had to stay.
    ring: Vec<u32>,
    /// The batch in which each position was last a target.
    target: Vec<u32>,
    /// The batch in which each position was last a candidate.
    candidate: Vec<u32>,
    keyed: Vec<(f32, (f32, u32))>,
}

impl Selection {
    pub(super) fn new(position_count: usize) -> Self {
        let [ring, target, candidate] = [(); 3].map(|()| vec![0; position_count]);
        Self { batch: 0, ring, target, candidate, keyed: Vec::new() }
    }

    /// Starts a new batch.
    pub(super) fn begin(&mut self) {
        self.batch += 1;
    }

    /// Reorders candidates, which are sorted by cost: the more of its neighbors are candidates, the
    /// farther a candidate moves back.
    pub(super) fn sort_by_crowding(&mut self, candidates: &mut [(f32, u32)], links: &Links) {
        for &(_, v) in candidates.iter() {
            self.candidate[v as usize] = self.batch;
        }
        let count = candidates.len() as f32;
        self.keyed.clear();
        for (rank, &candidate) in candidates.iter().enumerate() {
            let ring = links.entries(candidate.1);
            let crowd = ring.iter().filter(|&&w| self.candidate[w as usize] == self.batch).count();
            self.keyed.push((rank as f32 / count + CROWD_WEIGHT * crowd as f32, candidate));
        }
        // Stable: equal keys stay in order of cost.
        self.keyed.sort_by(|a, b| a.0.total_cmp(&b.0));
        for (slot, &(_, candidate)) in candidates.iter_mut().zip(&self.keyed) {
            *slot = candidate;
        }
    }

    /// Whether `v` may be removed: it is neither a neighbor of a removed position nor a target.
    #[inline]
    pub(super) fn is_free(&self, v: u32) -> bool {
        self.ring[v as usize] != self.batch
    }

    /// Whether no other position of the batch has been collapsed to `u`.
    #[inline]
    pub(super) fn is_free_target(&self, u: u32) -> bool {
        self.target[u as usize] != self.batch
    }

    /// Marks the target `u` and the `ring` of a removed position.
    pub(super) fn mark_removed(&mut self, u: u32, ring: &[u32]) {
        for &w in ring {
            self.ring[w as usize] = self.batch;
        }
        self.target[u as usize] = self.batch;
    }
}

/// Minimum number of positions that a batch selects from, since a share of a few positions would be
/// almost none.
const MIN_CANDIDATES: usize = 24;

/// Keeps the cheapest `share` of the candidates, sorted by cost; ties are sorted by index.
pub(super) fn keep_cheapest(candidates: &mut Vec<(f32, u32)>, share: f64) {
    let count = ((share * candidates.len() as f64).ceil() as usize).max(MIN_CANDIDATES);
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
        assert_eq!(candidates, all[..MIN_CANDIDATES], "never fewer than the minimum");
    }

    #[test]
    fn crowded_candidates_come_later() {
        // A strip 0 1 2 .. 39, in which 2 has the neighbors 0 1 3 4.
        let strip: Vec<[u32; 3]> =
            (0..38).map(|i| if i % 2 == 0 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] }).collect();
        let links = Links::new(40, &strip, false);
        let mut selection = Selection::new(40);
        selection.begin();
        let mut candidates = vec![(0.5, 2), (0.6, 3), (0.7, 1), (0.8, 39)];
        selection.sort_by_crowding(&mut candidates, &links);
        let order: Vec<u32> = candidates.iter().map(|c| c.1).collect();
        assert_eq!(order, [2, 3, 1, 39], "two crowded neighbors weigh less than one of four ranks");
        let mut many: Vec<(f32, u32)> = (0..40).map(|v| (v as f32, v)).collect();
        selection.begin();
        selection.sort_by_crowding(&mut many, &links);
        assert_eq!(many[0].1, 0);
        assert!(
            many.iter().position(|c| c.1 == 39) < many.iter().position(|c| c.1 == 37),
            "39 has two neighbors, 37 four"
        );
    }

    #[test]
    fn removed_positions_block_their_neighbors_until_the_next_batch() {
        let mut selection = Selection::new(6);
        selection.begin();
        selection.mark_removed(1, &[1, 2, 3]);
        assert!((1..4).all(|v| !selection.is_free(v)) && selection.is_free(4));
        assert!(!selection.is_free_target(1) && selection.is_free_target(2));
        selection.begin();
        assert!((0..6).all(|v| selection.is_free(v) && selection.is_free_target(v)));
    }
}
