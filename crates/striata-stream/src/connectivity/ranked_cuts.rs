//! [`RankedCuts`]: cuts around vertices with few triangles, coded as two symbols: the length of the run,
//! and its rank among the free runs of that length.
//!
//! Runs are ranked by the lengths of their edges, inner ones counting twice, since vertices are missing where
//! edges are long; and by how few triangles the vertices at their ends have, since each gets one more.

use crate::entropy::{AdaptiveSymbol, Coder};

/// Maximum number of triangles in a ring.
pub(crate) const MAX_RING: usize = 16;
/// Final learning rate of the symbols, as a negative power of two.
const LAST_SHIFT: u32 = 7;

/// An edge from the split vertex, and the triangle counterclockwise of it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RankedEdge {
    /// Squared length.
    pub square: i64,
    /// Six minus the number of triangles around its far end; 0 if that is virtual.
    pub missing_triangles: i8,
    /// Whether its far end is a virtual vertex, which closes a boundary loop.
    pub is_virtual: bool,
    /// Whether the triangle may move to the new vertex.
    pub is_free: bool,
}

/// Models of lengths and ranks.
#[derive(Clone, Debug)]
pub(crate) struct RankedCuts {
    /// By number of triangles around the vertex, and how many of them are free.
    lengths: Vec<AdaptiveSymbol>,
    /// By number of candidate runs, and their length.
    ranks: Vec<AdaptiveSymbol>,
}

impl RankedCuts {
    /// Creates an untrained model.
    pub(crate) fn new() -> Self {
        let all = 0..MAX_RING * MAX_RING;
        Self {
            lengths: all.clone().map(|at| AdaptiveSymbol::new((at / MAX_RING).max(1))).collect(),
            ranks: all.map(|at| AdaptiveSymbol::new(at / MAX_RING + 1)).collect(),
        }
    }

    /// Codes the start and the length of a cut in a ring of 2 to [`MAX_RING`] edges. Returns `None` if a
    /// damaged stream encodes a run that is not free.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        edges: &[RankedEdge],
        max_length: usize,
        actual: (usize, usize),
    ) -> Option<(usize, usize)> {
        let n = edges.len();
        let [free, open] = masks(edges);
        let context = (n - 1) * MAX_RING + (free.count_ones() as usize).min(MAX_RING - 1);
        let length =
            1 + self.lengths[context].code(coder, actual.1.wrapping_sub(1) & (MAX_RING - 1), LAST_SHIFT);
        if length > max_length.min(n - 1) {
            return None;
        }
        let mut starts = free_starts(n, [free, open], length);
        let count = starts.count_ones() as usize;
        let scores = scores(edges, length);
        let rank_of = |start: usize| {
            let is_ahead = |at: &usize| starts >> at & 1 != 0 && (scores[*at], *at) > (scores[start], start);
            (0..n).filter(is_ahead).count()
        };
        let actual = if C::READS { 0 } else { rank_of(actual.0) };
        let rank = match count {
            0 => return None,
            1 => 0,
            _ => self.ranks[(count - 1) * MAX_RING + length - 1].code(coder, actual, LAST_SHIFT),
        };
        if rank >= count {
            return None;
        }
        for _ in 0..rank {
            starts &= !(1 << best(starts, &scores));
        }
        Some((best(starts, &scores), length))
    }
}

/// Returns bit masks of the free triangles, and of the edges whose far ends are virtual.
fn masks(edges: &[RankedEdge]) -> [u32; 2] {
    edges.iter().enumerate().fold([0, 0], |[free, open], (at, edge)| {
        [free | u32::from(edge.is_free) << at, open | u32::from(edge.is_virtual) << at]
    })
}

/// Returns a bit mask of the possible starts of runs: all triangles are free, and no inner edge's far end
/// is virtual.
fn free_starts(n: usize, [free, open]: [u32; 2], length: usize) -> u32 {
    // Twice around, so that runs can wrap.
    let [free, open] = [free | free << n, open | open << n];
    let mut starts = free;
    for at in 1..length {
        starts &= free >> at & !(open >> at);
    }
    starts & ((1 << n) - 1)
}

/// Returns the score of the run that starts at each edge.
#[inline]
fn scores(edges: &[RankedEdge], length: usize) -> [i64; MAX_RING] {
    let n = edges.len();
    let wrap = |at: usize| if at < n { at } else { at - n };
    let sum: i64 = edges.iter().map(|edge| edge.square).sum();
    let inverse = INVERSES[n.min(MAX_RING)];
    let unit = if sum < 1 << 40 { (sum * inverse) >> 16 } else { (sum >> 16) * inverse };
    let mut inner: i64 = edges[1..length].iter().map(|edge| edge.square).sum();
    let mut ends = [0; MAX_RING];
    for (end, edge) in ends.iter_mut().zip(edges) {
        *end = 2 * edge.square + ((3 * unit * i64::from(edge.missing_triangles)) >> 1);
    }
    let mut scores = [0; MAX_RING];
    for (at, score) in scores[..n].iter_mut().enumerate() {
        let end = wrap(at + length);
        *score = ends[at] + ends[end] + 4 * inner;
        inner += edges[end].square - edges[wrap(at + 1)].square;
    }
    scores
}

/// 65536 divided by each number of edges.
const INVERSES: [i64; MAX_RING + 1] = {
    let mut table = [0; MAX_RING + 1];
    let mut n = 1;
    while n <= MAX_RING {
        table[n] = 65_536 / n as i64;
        n += 1;
    }
    table
};

/// Returns the start with the highest score; of equal ones, the last.
fn best(mut starts: u32, scores: &[i64; MAX_RING]) -> usize {
    let (mut best, mut best_score) = (0, i64::MIN);
    while starts != 0 {
        let at = starts.trailing_zeros() as usize % MAX_RING;
        starts &= starts - 1;
        if scores[at] >= best_score {
            (best, best_score) = (at, scores[at]);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};

    fn random_edges(random: &mut Random) -> Vec<RankedEdge> {
        let edge = |random: &mut Random| RankedEdge {
            square: i64::from(random.below(1000)) << (10 * random.below(5)),
            missing_triangles: random.below(9) as i8 - 4,
            is_virtual: random.below(12) == 0,
            is_free: random.below(4) > 0,
        };
        (0..2 + random.below(MAX_RING as u32 - 1)).map(|_| edge(random)).collect()
    }

    /// Whether a run can move to a new vertex, checked edge by edge.
    fn is_free(edges: &[RankedEdge], start: usize, length: usize) -> bool {
        let n = edges.len();
        (0..length)
            .all(|at| edges[(start + at) % n].is_free && (at == 0 || !edges[(start + at) % n].is_virtual))
    }

    #[test]
    fn free_runs_are_found_and_scored() {
        let mut random = Random::new(4);
        for _ in 0..300 {
            let edges = random_edges(&mut random);
            let n = edges.len();
            for length in 1..n {
                let starts = free_starts(n, masks(&edges), length);
                let scores = scores(&edges, length);
                let unit = edges.iter().map(|edge| edge.square).sum::<i64>() as f64 / n as f64;
                for start in 0..n {
                    assert_eq!(starts >> start & 1 != 0, is_free(&edges, start, length));
                    let inner: i64 = (1..length).map(|at| edges[(start + at) % n].square).sum();
                    let ends = [start, (start + length) % n].map(|at| edges[at]);
                    let of_end = |edge: RankedEdge| {
                        2.0 * edge.square as f64 + 1.5 * unit * f64::from(edge.missing_triangles)
                    };
                    let expected = 4.0 * inner as f64 + ends.map(of_end).iter().sum::<f64>();
                    let difference = (scores[start] as f64 - expected).abs();
                    assert!(difference < 40.0 + 4e-3 * unit, "{} for {expected}", scores[start]);
                }
            }
        }
    }

    #[test]
    fn cuts_round_trip() {
        let mut random = Random::new(5);
        let (mut writer, mut cuts) = (RangeWriter::new(), RankedCuts::new());
        let mut message = Vec::new();
        while message.len() < 2000 {
            let edges = random_edges(&mut random);
            let n = edges.len();
            let (start, length) = (random.below(n as u32) as usize, 1 + random.below(n as u32 - 1) as usize);
            if is_free(&edges, start, length) {
                assert_eq!(cuts.code(&mut writer, &edges, MAX_RING, (start, length)), Some((start, length)));
                message.push((edges, (start, length)));
            }
        }
        let bytes = writer.finish().0;
        let (mut reader, mut cuts) = (RangeReader::new(&bytes, true), RankedCuts::new());
        for (edges, run) in message {
            assert_eq!(cuts.code(&mut reader, &edges, MAX_RING, (0, 1)), Some(run));
        }
    }

    #[test]
    fn arbitrary_bytes_decode_to_free_runs_or_none() {
        let mut random = Random::new(6);
        let bytes: Vec<u8> = (0..3000).map(|_| random.next_u64() as u8).collect();
        let (mut reader, mut cuts) = (RangeReader::new(&bytes, true), RankedCuts::new());
        for _ in 0..3000 {
            let edges = random_edges(&mut random);
            if let Some((start, length)) = cuts.code(&mut reader, &edges, 5, (0, 1)) {
                assert!(length <= 5 && is_free(&edges, start, length));
            }
        }
    }
}
