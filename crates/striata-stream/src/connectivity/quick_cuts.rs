//! Cuts around vertices of few triangles, as two symbols: how long the run is, and which of the free runs of that length.
//!
//! Runs are ranked by the lengths of their edges, inner ones counting twice, since a vertex is missing where edges are long;
//! and by how few triangles lie around the vertices at their ends, which get one more.

use crate::entropy::{Coder, QuickSymbol};

/// Rings have at most so many triangles here.
pub(crate) const MOST: usize = 16;
/// How slowly symbols are learned in the end.
const LAST_SHIFT: u32 = 7;

/// An edge from the vertex that splits, and the triangle behind it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Edge {
    /// Its squared length.
    pub(crate) square: i64,
    /// How many triangles less than six lie around its end; 0 if that is virtual.
    pub(crate) few: i8,
    /// Whether its end stands for a boundary loop.
    pub(crate) is_virtual: bool,
    /// Whether the triangle counter-clockwise of it may go to the new vertex.
    pub(crate) is_free: bool,
}

/// Models of lengths and ranks.
#[derive(Clone, Debug)]
pub(crate) struct QuickCuts {
    /// By triangles around the vertex, and how many of them are free.
    lengths: Vec<QuickSymbol>,
    /// By runs to choose from, and their length.
    ranks: Vec<QuickSymbol>,
}

impl QuickCuts {
    /// Nothing learned.
    pub(crate) fn new() -> Self {
        let all = 0..MOST * MOST;
        Self {
            lengths: all.clone().map(|at| QuickSymbol::new((at / MOST).max(1))).collect(),
            ranks: all.map(|at| QuickSymbol::new(at / MOST + 1)).collect(),
        }
    }

    /// Codes where the run of a cut begins and its length, among at most [`MOST`] edges and two at least; none where a damaged
    /// stream tells of a run that is not free.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        edges: &[Edge],
        max_length: usize,
        meant: (usize, usize),
    ) -> Option<(usize, usize)> {
        let n = edges.len();
        let [free, open] = masks(edges);
        let context = (n - 1) * MOST + (free.count_ones() as usize).min(MOST - 1);
        let length = 1 + self.lengths[context].code(coder, meant.1.wrapping_sub(1) & (MOST - 1), LAST_SHIFT);
        if length > max_length.min(n - 1) {
            return None;
        }
        let mut starts = free_starts(n, [free, open], length);
        let count = starts.count_ones() as usize;
        let scores = scores(edges, length);
        let before = |start: usize| {
            let is_before = |at: &usize| starts >> at & 1 != 0 && (scores[*at], *at) > (scores[start], start);
            (0..n).filter(is_before).count()
        };
        let meant = if C::READS { 0 } else { before(meant.0) };
        let rank = match count {
            0 => return None,
            1 => 0,
            _ => self.ranks[(count - 1) * MOST + length - 1].code(coder, meant, LAST_SHIFT),
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

/// The triangles that are free, and the edges whose ends are virtual, a bit each.
fn masks(edges: &[Edge]) -> [u32; 2] {
    edges.iter().enumerate().fold([0, 0], |[free, open], (at, edge)| {
        [free | u32::from(edge.is_free) << at, open | u32::from(edge.is_virtual) << at]
    })
}

/// Where runs of a length can begin, a bit each: all triangles are free, and no inner edge's end is virtual.
fn free_starts(n: usize, [free, open]: [u32; 2], length: usize) -> u32 {
    // Twice around, so that runs go on at the beginning.
    let [free, open] = [free | free << n, open | open << n];
    let mut starts = free;
    for at in 1..length {
        starts &= free >> at & !(open >> at);
    }
    starts & ((1 << n) - 1)
}

/// What each run of a length comes to.
#[inline]
fn scores(edges: &[Edge], length: usize) -> [i64; MOST] {
    let n = edges.len();
    let wrap = |at: usize| if at < n { at } else { at - n };
    let sum: i64 = edges.iter().map(|edge| edge.square).sum();
    let inverse = INVERSES[n.min(MOST)];
    let unit = if sum < 1 << 40 { (sum * inverse) >> 16 } else { (sum >> 16) * inverse };
    let mut inner: i64 = edges[1..length].iter().map(|edge| edge.square).sum();
    let mut ends = [0; MOST];
    for (end, edge) in ends.iter_mut().zip(edges) {
        *end = 2 * edge.square + ((3 * unit * i64::from(edge.few)) >> 1);
    }
    let mut scores = [0; MOST];
    for (at, score) in scores[..n].iter_mut().enumerate() {
        let end = wrap(at + length);
        *score = ends[at] + ends[end] + 4 * inner;
        inner += edges[end].square - edges[wrap(at + 1)].square;
    }
    scores
}

/// 65536 by each number.
const INVERSES: [i64; MOST + 1] = {
    let mut table = [0; MOST + 1];
    let mut n = 1;
    while n <= MOST {
        table[n] = 65_536 / n as i64;
        n += 1;
    }
    table
};

/// The run of those that begin at these places that comes to most.
fn best(mut starts: u32, scores: &[i64; MOST]) -> usize {
    let (mut best, mut most) = (0, i64::MIN);
    while starts != 0 {
        let at = starts.trailing_zeros() as usize % MOST;
        starts &= starts - 1;
        if scores[at] >= most {
            (best, most) = (at, scores[at]);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};

    fn random_edges(random: &mut Random) -> Vec<Edge> {
        let edge = |random: &mut Random| Edge {
            square: i64::from(random.below(1000)) << (10 * random.below(5)),
            few: random.below(9) as i8 - 4,
            is_virtual: random.below(12) == 0,
            is_free: random.below(4) > 0,
        };
        (0..2 + random.below(MOST as u32 - 1)).map(|_| edge(random)).collect()
    }

    /// Whether a run can go to a new vertex, edge by edge.
    fn is_free(edges: &[Edge], start: usize, length: usize) -> bool {
        let n = edges.len();
        (0..length)
            .all(|at| edges[(start + at) % n].is_free && (at == 0 || !edges[(start + at) % n].is_virtual))
    }

    #[test]
    fn runs_are_found_and_scored() {
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
                    let of_end = |edge: Edge| 2.0 * edge.square as f64 + 1.5 * unit * f64::from(edge.few);
                    let expected = 4.0 * inner as f64 + ends.map(of_end).iter().sum::<f64>();
                    let off = (scores[start] as f64 - expected).abs();
                    assert!(off < 40.0 + 4e-3 * unit, "{} for {expected}", scores[start]);
                }
            }
        }
    }

    #[test]
    fn cuts_come_back() {
        let mut random = Random::new(5);
        let (mut writer, mut cuts) = (RangeWriter::new(), QuickCuts::new());
        let mut message = Vec::new();
        while message.len() < 2000 {
            let edges = random_edges(&mut random);
            let n = edges.len();
            let (start, length) = (random.below(n as u32) as usize, 1 + random.below(n as u32 - 1) as usize);
            if is_free(&edges, start, length) {
                assert_eq!(cuts.code(&mut writer, &edges, MOST, (start, length)), Some((start, length)));
                message.push((edges, (start, length)));
            }
        }
        let bytes = writer.finish().0;
        let (mut reader, mut cuts) = (RangeReader::new(&bytes, true), QuickCuts::new());
        for (edges, run) in message {
            assert_eq!(cuts.code(&mut reader, &edges, MOST, (0, 1)), Some(run));
        }
    }

    #[test]
    fn any_bytes_give_free_runs_or_none() {
        let mut random = Random::new(6);
        let bytes: Vec<u8> = (0..3000).map(|_| random.next_u64() as u8).collect();
        let (mut reader, mut cuts) = (RangeReader::new(&bytes, true), QuickCuts::new());
        for _ in 0..3000 {
            let edges = random_edges(&mut random);
            if let Some((start, length)) = cuts.code(&mut reader, &edges, 5, (0, 1)) {
                assert!(length <= 5 && is_free(&edges, start, length));
            }
        }
    }
}
