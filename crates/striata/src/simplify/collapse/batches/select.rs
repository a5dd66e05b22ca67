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
    /// farther a candidate moves back. Copies of a position (see [`keep_cheapest`]) move alike.
    pub(super) fn sort_by_crowding(
        &mut self,
        candidates: &mut [(f32, u32)],
        links: &Links,
        is_copy: &[bool],
    ) {
        for &(_, v) in candidates.iter() {
            self.candidate[v as usize] = self.batch;
        }
        let count = candidates.len() as f32;
        self.keyed.clear();
        let mut rank = 0;
        for (index, &candidate) in candidates.iter().enumerate() {
            if index == 0 || !is_next_copy(candidates[index - 1], candidate, is_copy) {
                rank = index;
            }
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
///
/// `is_copy` marks the positions in the same place as the previous one. If such copies cost the same, all of
/// them are kept or none, so that they are collapsed alike.
pub(super) fn keep_cheapest(candidates: &mut Vec<(f32, u32)>, share: f64, is_copy: &[bool]) {
    let mut count = ((share * candidates.len() as f64).ceil() as usize).max(MIN_CANDIDATES);
    let order = |a: &(f32, u32), b: &(f32, u32)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
    if count < candidates.len() {
        candidates.select_nth_unstable_by(count, order);
        while let Some(&next) = candidates.get(count)
            && is_copy[next.1 as usize]
            && candidates[..count].iter().any(|&last| is_next_copy(last, next, is_copy))
        {
            count += 1;
            if count < candidates.len() {
                candidates[count..].select_nth_unstable_by(0, order);
            }
        }
        candidates.truncate(count);
    }
    candidates.sort_unstable_by(order);
}

/// Whether a candidate is a copy of the one before it at the same cost.
fn is_next_copy(last: (f32, u32), next: (f32, u32), is_copy: &[bool]) -> bool {
    is_copy[next.1 as usize] && last == (next.0, next.1 - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cheapest_share_comes_in_order() {
        let mut candidates: Vec<(f32, u32)> = (0..100).map(|i| (((i * 37) % 50) as f32, i)).collect();
        let mut all = candidates.clone();
        keep_cheapest(&mut candidates, 0.3, &[false; 100]);
        all.sort_by(|a, b| a.partial_cmp(b).expect("costs are numbers"));
        assert_eq!(candidates, all[..30]);
        keep_cheapest(&mut candidates, 0.01, &[false; 100]);
        assert_eq!(candidates, all[..MIN_CANDIDATES], "never fewer than the minimum");
    }

    #[test]
    fn copies_are_kept_together() {
        // Every third position has two copies; those of the first nine cost more than the position itself.
        let cost = |i: u32| (i / 3) as f32 + if i < 9 { 0.1 * i as f32 } else { 0.0 };
        let is_copy: Vec<bool> = (0..90).map(|i| i % 3 > 0).collect();
        let mut candidates: Vec<(f32, u32)> = (0..90).rev().map(|i| (cost(i), i)).collect();
        keep_cheapest(&mut candidates, 0.345, &is_copy);
        assert_eq!(candidates.len(), 33, "the copies of the last one come along");
        let mut candidates: Vec<(f32, u32)> = (0..90).rev().map(|i| (i as f32, i)).collect();
        keep_cheapest(&mut candidates, 0.345, &is_copy);
        assert_eq!(candidates.len(), 32, "at other costs, they do not");
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
        selection.sort_by_crowding(&mut candidates, &links, &[false; 40]);
        let order: Vec<u32> = candidates.iter().map(|c| c.1).collect();
        assert_eq!(order, [2, 3, 1, 39], "two crowded neighbors weigh less than one of four ranks");
        let mut many: Vec<(f32, u32)> = (0..40).map(|v| (v as f32, v)).collect();
        selection.begin();
        selection.sort_by_crowding(&mut many, &links, &[false; 40]);
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
