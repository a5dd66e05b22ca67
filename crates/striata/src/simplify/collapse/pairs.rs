//! Pairs of positions that share no edge but lie close together, so that separate parts can merge [GH97].
//!
//! Pairs are found once, on a grid whose cell size is the threshold, and follow the collapses: the
//! partners of a removed position become partners of its target.

use std::collections::BTreeMap;

use super::fan::point;

/// Maximum number of partners of a position at the start; the nearest ones are kept.
const MAX_PARTNERS: usize = 8;
/// Maximum number of positions or list entries examined for one position, so that a generous threshold
/// stays affordable.
const MAX_EXAMINED: usize = 256;
const NONE: u32 = u32::MAX;

/// Candidates for contraction in addition to the neighbors.
#[derive(Debug)]
pub(in crate::simplify) struct Pairs {
    /// First entry in the partner list of every position.
    head: Vec<u32>,
    tail: Vec<u32>,
    /// Partner and index of the next entry.
    entries: Vec<(u32, u32)>,
    /// The position that each position was merged into, with path compression.
    current: Vec<u32>,
}

impl Pairs {
    /// Finds all pairs closer than `threshold` (scaled units) that `is_neighbor` does not connect already.
    pub(in crate::simplify) fn new(
        positions: &[[f32; 4]],
        threshold: f32,
        is_neighbor: impl Fn(u32, u32) -> bool,
    ) -> Self {
        let count = positions.len();
        let mut pairs = Self {
            head: vec![NONE; count],
            tail: vec![NONE; count],
            entries: Vec::new(),
            current: (0..count as u32).collect(),
        };
        let cell = |p: u32| point(positions, p).to_array().map(|x| (x / threshold).floor() as i32);
        let mut cells: BTreeMap<[i32; 3], Vec<u32>> = BTreeMap::new();
        for p in 0..count as u32 {
            cells.entry(cell(p)).or_default().push(p);
        }
        let mut near: Vec<(f32, u32)> = Vec::new();
        for p in 0..count as u32 {
            let [cx, cy, cz] = cell(p);
            near.clear();
            for x in cx - 1..=cx + 1 {
                for y in cy - 1..=cy + 1 {
                    // One range covers the three cells along the last axis.
                    for list in cells.range([x, y, cz - 1]..=[x, y, cz + 1]).map(|(_, list)| list) {
                        let room = MAX_EXAMINED.saturating_sub(near.len());
                        near.extend(
                            list.iter()
                                .filter(|&&q| q != p)
                                .take(room)
                                .map(|&q| ((point(positions, q) - point(positions, p)).length_squared(), q)),
                        );
                    }
                }
            }
            near.retain(|&(squared, q)| squared <= threshold * threshold && !is_neighbor(p, q));
            near.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            for &(_, q) in near.iter().take(MAX_PARTNERS) {
                pairs.push(p, q);
            }
        }
        pairs
    }

    fn push(&mut self, p: u32, partner: u32) {
        let entry = self.entries.len() as u32;
        self.entries.push((partner, NONE));
        if self.head[p as usize] == NONE {
            self.head[p as usize] = entry;
        } else {
            self.entries[self.tail[p as usize] as usize].1 = entry;
        }
        self.tail[p as usize] = entry;
    }

    /// Returns the position that `p` has been merged into.
    fn find(&mut self, mut p: u32) -> u32 {
        while self.current[p as usize] != p {
            let above = self.current[p as usize];
            self.current[p as usize] = self.current[above as usize];
            p = above;
        }
        p
    }

    /// Collects the current partners of `v` into `out`, each once.
    pub(in crate::simplify) fn partners_into(&mut self, v: u32, out: &mut Vec<u32>) {
        out.clear();
        let mut entry = self.head[v as usize];
        for _ in 0..MAX_EXAMINED {
            if entry == NONE || out.len() == 4 * MAX_PARTNERS {
                break;
            }
            let (partner, next) = self.entries[entry as usize];
            let partner = self.find(partner);
            if partner != v && !out.contains(&partner) {
                out.push(partner);
            }
            entry = next;
        }
    }

    /// Merges `v` and its partners into `u`.
    pub(in crate::simplify) fn collapse(&mut self, v: u32, u: u32) {
        self.current[v as usize] = u;
        let (head, tail) = (self.head[v as usize], self.tail[v as usize]);
        if head == NONE {
            return;
        }
        if self.head[u as usize] == NONE {
            self.head[u as usize] = head;
        } else {
            self.entries[self.tail[u as usize] as usize].1 = head;
        }
        self.tail[u as usize] = tail;
        self.head[v as usize] = NONE;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn partners_follow_collapses() {
        let positions: Vec<[f32; 4]> = (0..6).map(|i| [i as f32 * 0.1, 0.0, 0.0, 0.0]).collect();
        let mut pairs = Pairs::new(&positions, 0.15, |p, q| p.abs_diff(q) == 1 && p.min(q) % 2 == 0);
        let mut out = Vec::new();
        pairs.partners_into(1, &mut out);
        assert_eq!(out, [2]);
        pairs.collapse(2, 3);
        pairs.partners_into(1, &mut out);
        assert_eq!(out, [3]);
        pairs.partners_into(3, &mut out);
        assert_eq!(out, [4, 1]);
    }
}
