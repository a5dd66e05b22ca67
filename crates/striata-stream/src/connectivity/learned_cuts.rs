//! [`LearnedCuts`]: cuts around vertices with few triangles, for the compact effort, by a log-linear model.
//!
//! Scores are sums over the edges and triangles of a run, so each is the sum of a term for the start of the
//! run, one for its end and one for its length. A run is coded as two symbols, its length and then its start,
//! with shares proportional to the exponentials of the scores. All weights then move along the gradient.

use super::arithmetic::{SCORE_ONE, cross, dot, dot_wide, exponential, log2_wide, mean};
use super::ranked_cuts::MAX_RING;
use crate::entropy::{Coder, Shares, log2_q8};

/// Features of an edge: ranges in one table, which has a weight for end edges and one for inner edges.
const LENGTHS: usize = 17;
const VALENCES: usize = 10;
const HISTORIES: usize = 16;
const HEIGHTS: usize = 12;
/// Table sizes: powers of two, so that masked indices are always in bounds.
const EDGE_WEIGHTS: usize = 64;
const TRIANGLE_WEIGHTS: usize = 32;
/// Features of a triangle: ranges in one table.
const AREAS: usize = 13;
const ANGLES: usize = 16;
const _: () = assert!(LENGTHS + VALENCES + HISTORIES + HEIGHTS <= EDGE_WEIGHTS);
const _: () = assert!(AREAS + ANGLES <= TRIANGLE_WEIGHTS);

/// Initial and final learning rate, in 1/16384.
const FIRST_RATE: i32 = 750;
const LAST_RATE: i32 = 120;
/// Number of bits of an edge vector's components.
const STEP_BITS: i32 = 13;
/// Heights below this are noise from the grid.
const MIN_HEIGHT: i32 = -512;

/// An edge from the split vertex, and the triangle counterclockwise of it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Spoke {
    /// Vector to its far end; zeros if that is virtual.
    pub step: [i32; 3],
    /// Number of triangles around its far end after all splits known so far.
    pub valence: u8,
    /// Four times the age of the far end in batches, up to 3, plus its state: not visited, stays, splits,
    /// new.
    pub history: u8,
    /// Whether its far end is a virtual vertex, which closes a boundary loop.
    pub is_virtual: bool,
    /// Whether the triangle may move to the new vertex.
    pub is_free: bool,
}

/// Table keys of an edge and its triangle, and their scores.
#[derive(Clone, Copy, Debug, Default)]
struct SideScores {
    edge: [u8; 4],
    triangle: [u8; 2],
    /// Scores as an end edge and as an inner edge.
    edge_scores: [i32; 2],
    area_score: i32,
}

/// The log-linear model, with scratch memory.
#[derive(Clone, Debug)]
pub(crate) struct LearnedCuts {
    /// Weights of edges as ends and as inner edges.
    edges: [[i32; 2]; EDGE_WEIGHTS],
    triangles: [i32; TRIANGLE_WEIGHTS],
    /// Weights by triangle count of the vertex and length of the run, and by the number of triangles that
    /// remain.
    counts: [[i32; MAX_RING]; MAX_RING + 1],
    remains: [i32; MAX_RING],
    /// Number of splits learned from, up to a limit.
    splits: i32,
    /// Mean height of the rings of vertices that split.
    height: i32,
    sides: [SideScores; MAX_RING],
    /// For each length, a bit mask of the possible starts.
    starts: [u32; MAX_RING],
    /// Scores of runs, by length and start, and their exponentials.
    scores: [[i32; MAX_RING]; MAX_RING],
    exponentials: [[u32; MAX_RING]; MAX_RING],
    /// Sum of the exponentials for each length; the index is the length minus one.
    by_length: [u32; MAX_RING],
}

/// A coded run, and the ring that it was chosen from.
#[derive(Clone, Copy)]
struct ChosenRun {
    /// Number of triangles around the vertex.
    n: usize,
    /// Number of triangles that it will have after all splits known so far.
    planned: usize,
    /// Maximum length of a run.
    max_length: usize,
    start: usize,
    length: usize,
}

impl LearnedCuts {
    /// Creates an untrained model.
    pub(crate) fn new() -> Self {
        Self {
            edges: [[0; 2]; EDGE_WEIGHTS],
            triangles: [0; TRIANGLE_WEIGHTS],
            counts: [[0; MAX_RING]; MAX_RING + 1],
            remains: [0; MAX_RING],
            splits: 0,
            height: 0,
            sides: [SideScores::default(); MAX_RING],
            starts: [0; MAX_RING],
            scores: [[0; MAX_RING]; MAX_RING],
            exponentials: [[0; MAX_RING]; MAX_RING],
            by_length: [0; MAX_RING],
        }
    }

    /// Codes the start and the length of a cut in a ring of 2 to [`MAX_RING`] edges, around a vertex that
    /// will have `planned` triangles before it splits. Returns `None` if a damaged stream encodes a run
    /// that is not free.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        spokes: &mut [Spoke],
        (planned, max_length): (usize, usize),
        actual: (usize, usize),
    ) -> Option<(usize, usize)> {
        let n = spokes.len();
        let height = self.compute_keys(spokes);
        let max_length = max_length.min(n - 1);
        let best = self.score(spokes, planned, max_length)?;
        let total = self.exponentiate(best, max_length);
        let inverse = (1 << INVERSE_BITS) / u64::from(total);
        let shares = cumulative_shares(&self.by_length, inverse);
        let length = 1 + coder.symbol(actual.1.wrapping_sub(1) & (MAX_RING - 1), &shares);
        if length > max_length || self.starts[length] == 0 {
            return None;
        }
        let starts = self.starts[length];
        let start = if starts & (starts - 1) == 0 {
            starts.trailing_zeros() as usize
        } else {
            let inverse = (1 << INVERSE_BITS) / u64::from(self.by_length[length - 1]);
            coder.symbol(actual.0 & (MAX_RING - 1), &cumulative_shares(&self.exponentials[length], inverse))
        };
        if starts >> start & 1 == 0 {
            return None;
        }
        self.learn(ChosenRun { n, planned, max_length, start, length }, inverse);
        self.height += (height - self.height) >> 5;
        Some((start, length))
    }

    /// Computes the keys of all edges and triangles; returns the mean height.
    fn compute_keys(&mut self, spokes: &mut [Spoke]) -> i32 {
        let n = spokes.len();
        let magnitudes =
            spokes.iter().flat_map(|spoke| spoke.step).fold(0, |magnitudes, x| magnitudes | x.unsigned_abs());
        let shift = (32 - STEP_BITS - magnitudes.leading_zeros() as i32).max(0);
        let (mut normals, mut lengths, mut areas) = ([[0; 3]; MAX_RING], [0; MAX_RING], [0; MAX_RING]);
        let mut tangents = [0; MAX_RING];
        let mut is_obtuse = [false; MAX_RING];
        spokes.iter_mut().for_each(|spoke| spoke.step = spoke.step.map(|x| x >> shift));
        let (mut edge_count, mut triangle_count) = (0, 0);
        for at in 0..n {
            let step = spokes[at].step;
            let next = spokes[next_index(at, n)].step;
            lengths[at] = log2_q8(dot(step, step) as u32);
            edge_count += usize::from(!spokes[at].is_virtual);
            normals[at] = cross(step, next);
            let normal = normals[at].map(i64::from);
            areas[at] = log2_wide(dot_wide(normal, normal) as u64);
            triangle_count += usize::from(areas[at] != 0);
            let cosine = dot(step, next);
            tangents[at] = areas[at] - 2 * log2_q8(cosine.unsigned_abs());
            is_obtuse[at] = cosine < 0;
        }
        let length = mean(lengths[..n].iter().map(|&x| i64::from(x)).sum(), edge_count);
        let area = mean(areas[..n].iter().map(|&x| i64::from(x)).sum(), triangle_count);
        let (mut heights, mut height_count) = (0, 0);
        for at in 0..n {
            let before = if at > 0 { at - 1 } else { n - 1 };
            let next = &spokes[next_index(at, n)];
            let mut height = 0;
            if areas[before] != 0 && !next.is_virtual {
                let volume = dot_wide(normals[before].map(i64::from), next.step.map(i64::from));
                height = 2 * log2_wide(volume.unsigned_abs()) - areas[before] + 512 * shift;
                height = height.max(MIN_HEIGHT);
                heights += i64::from(height);
                height_count += 1;
            }
            self.sides[at].edge = edge_keys(&spokes[at], lengths[at] - length, height - self.height);
            self.sides[at].triangle = triangle_keys(areas[at], areas[at] - area, is_obtuse[at], tangents[at]);
        }
        mean(heights, height_count)
    }

    /// Scores all possible runs; returns the best score, or `None` if no run is possible.
    fn score(&mut self, spokes: &[Spoke], planned: usize, max_length: usize) -> Option<i32> {
        let n = spokes.len();
        // Prefix sums of scores, over two turns around the vertex, as terms of starts and ends.
        let (mut begins, mut ends) = ([0; MAX_RING], [0; 2 * MAX_RING]);
        let mut sum = 0;
        for (side, begin) in self.sides[..n].iter_mut().zip(&mut begins) {
            side.edge_scores = side.edge.iter().fold([0; 2], |[end, inner], &key| {
                let weights = self.edges[usize::from(key) % EDGE_WEIGHTS];
                [end + weights[0], inner + weights[1]]
            });
            side.area_score =
                side.triangle.iter().map(|&key| self.triangles[usize::from(key) % TRIANGLE_WEIGHTS]).sum();
            *begin = side.edge_scores[0] - side.edge_scores[1] - sum;
            sum += side.edge_scores[1] + side.area_score;
        }
        for at in 0..n {
            let [end, _] = self.sides[at].edge_scores;
            // The score up to an end edge; the start's term removes what comes before the run.
            ends[at] = 2 * end - self.sides[at].edge_scores[1] - begins[at];
            ends[at + n] = ends[at] + sum;
        }
        let mut free = spokes.iter().enumerate().fold(0, |free, (at, s)| free | u32::from(s.is_free) << at);
        let mut open =
            spokes.iter().enumerate().fold(0, |open, (at, s)| open | u32::from(s.is_virtual) << at);
        (free, open) = (free | free << n, open | open << n);
        let mut best = i32::MIN;
        let mut starts = free & ((1 << n) - 1);
        for length in 1..=max_length {
            self.starts[length] = starts;
            let whole = self.counts[n][length] + self.remains[remaining_key(planned, length)];
            let mut remaining = starts;
            while remaining != 0 {
                let at = remaining.trailing_zeros() as usize % MAX_RING;
                remaining &= remaining - 1;
                let score = begins[at] + ends[at + length] + whole;
                self.scores[length][at] = score;
                best = best.max(score);
            }
            starts &= free >> length & !(open >> length);
        }
        (best > i32::MIN).then_some(best)
    }

    /// Computes the exponentials of all scores; returns their sum.
    fn exponentiate(&mut self, best: i32, max_length: usize) -> u32 {
        self.by_length = [0; MAX_RING];
        let mut total = 0;
        for length in 1..=max_length {
            let mut remaining = self.starts[length];
            if remaining == 0 {
                continue;
            }
            let exponentials = &mut self.exponentials[length];
            *exponentials = [0; MAX_RING];
            let mut sum = 0;
            while remaining != 0 {
                let at = remaining.trailing_zeros() as usize % MAX_RING;
                remaining &= remaining - 1;
                exponentials[at] = exponential(best - self.scores[length][at]);
                sum += exponentials[at];
            }
            self.by_length[length - 1] = sum;
            total += sum;
        }
        total
    }

    /// Moves all weights along the gradient; `inverse` is the inverse of the sum of all exponentials.
    fn learn(&mut self, chosen: ChosenRun, inverse: u64) {
        let ChosenRun { n, planned, max_length, .. } = chosen;
        let rate = if self.splits < 32 * 42 {
            self.splits += 1;
            (8 * FIRST_RATE / (8 + self.splits / 32)).max(LAST_RATE)
        } else {
            LAST_RATE
        };
        let (mut begins, mut ends) = ([0; MAX_RING], [0; 2 * MAX_RING]);
        for length in 1..=max_length {
            let mut remaining = self.starts[length];
            let mut gradient = 0;
            while remaining != 0 {
                let at = remaining.trailing_zeros() as usize % MAX_RING;
                remaining &= remaining - 1;
                let part =
                    ((u64::from(self.exponentials[length][at]) * inverse) >> (INVERSE_BITS - 16)) as i32;
                begins[at] -= part;
                ends[at + length] -= part;
                gradient -= part;
            }
            if length == chosen.length {
                gradient += 1 << 16;
            }
            let step = (gradient * rate) >> 14;
            adjust(&mut self.counts[n][length], step);
            adjust(&mut self.remains[remaining_key(planned, length)], step);
        }
        begins[chosen.start] += 1 << 16;
        ends[chosen.start + chosen.length] += 1 << 16;
        // Runs that wrap around past the last edge also cover the first triangles.
        let mut covering = ends[n..2 * n].iter().sum::<i32>();
        for (at, side) in self.sides[..n].iter().enumerate() {
            let end = ends[at] + ends[at + n];
            covering += begins[at] - end;
            let steps =
                [begins[at] + end, covering - begins[at], covering].map(|gradient| (gradient * rate) >> 14);
            for &key in &side.edge {
                let weights = &mut self.edges[usize::from(key) % EDGE_WEIGHTS];
                adjust(&mut weights[0], steps[0]);
                adjust(&mut weights[1], steps[1]);
            }
            for &key in &side.triangle {
                adjust(&mut self.triangles[usize::from(key) % TRIANGLE_WEIGHTS], steps[2]);
            }
        }
    }
}

/// Number of fraction bits of inverse sums.
const INVERSE_BITS: u32 = 36;

/// The part of the whole that is divided by weight: 15 bits, less one for each symbol, and less one because
/// an end has to stay below 2^15.
const SHARED_BY_WEIGHT: u32 = (1 << 15) - MAX_RING as u32 - 1;

/// Returns cumulative shares proportional to the weights, plus one for each weight that is not 0; `inverse`
/// is the inverse of the sum of the weights.
#[inline]
fn cumulative_shares(weights: &[u32; MAX_RING], inverse: u64) -> Shares {
    let mut shares = [0; MAX_RING];
    let mut begin = 0;
    for (share, &weight) in shares.iter_mut().zip(weights) {
        *share = begin;
        let part = ((u64::from(weight) * inverse) >> (INVERSE_BITS - 16)) as u32;
        begin += ((part * SHARED_BY_WEIGHT) >> 16) as i16 + i16::from(weight > 0);
    }
    shares
}

#[inline]
fn next_index(at: usize, n: usize) -> usize {
    if at + 1 < n { at + 1 } else { 0 }
}

/// Returns the key for the number of triangles that remain at the vertex.
#[inline]
fn remaining_key(planned: usize, length: usize) -> usize {
    (planned + 2).saturating_sub(length).min(MAX_RING - 1)
}

/// Moves a weight, within its limits.
#[inline]
fn adjust(weight: &mut i32, step: i32) {
    *weight = (*weight + step).clamp(-8 * SCORE_ONE, 8 * SCORE_ONE);
}

/// Returns the keys of an edge; length and height are relative to the mean.
#[inline]
fn edge_keys(spoke: &Spoke, length: i32, height: i32) -> [u8; 4] {
    let length = if spoke.is_virtual { 16 } else { ((length + 8 * 64) >> 6).clamp(0, 15) as usize };
    let bend = ((height + 6 * 192) / 192).clamp(0, HEIGHTS as i32 - 1) as usize;
    [
        length,
        LENGTHS + usize::from(spoke.valence).min(VALENCES - 1),
        LENGTHS + VALENCES + usize::from(spoke.history) % HISTORIES,
        LENGTHS + VALENCES + HISTORIES + bend,
    ]
    .map(|key| key as u8)
}

/// Returns the keys of a triangle; one with zero area is virtual.
#[inline]
fn triangle_keys(area: i32, relative_area: i32, is_obtuse: bool, tangent: i32) -> [u8; 2] {
    if area == 0 {
        return [AREAS as u8 - 1, (AREAS + ANGLES - 1) as u8];
    }
    let angle = match (is_obtuse, tangent) {
        (false, tangent) => ((tangent + 1000) / 167).clamp(0, 11) as u8,
        (true, 974..) => 12,
        (true, 407..) => 13,
        (true, _) => 14,
    };
    [((relative_area + 6 * 96) / 96).clamp(0, 11) as u8, AREAS as u8 + angle]
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};

    fn random_spokes(random: &mut Random) -> Vec<Spoke> {
        let max_component = 1 << random.below(24);
        let spoke = |random: &mut Random| {
            let is_virtual = random.below(12) == 0;
            let step = [(); 3].map(|()| random.below(2 * max_component) as i32 - max_component as i32);
            Spoke {
                step: if is_virtual { [0; 3] } else { step },
                valence: random.below(256) as u8,
                history: random.below(16) as u8,
                is_virtual,
                is_free: random.below(4) > 0,
            }
        };
        (0..2 + random.below(MAX_RING as u32 - 1)).map(|_| spoke(random)).collect()
    }

    /// Whether a run can move to a new vertex, checked edge by edge.
    fn is_free(spokes: &[Spoke], start: usize, length: usize) -> bool {
        let n = spokes.len();
        (0..length)
            .all(|at| spokes[(start + at) % n].is_free && (at == 0 || !spokes[(start + at) % n].is_virtual))
    }

    /// A cut at the edge whose end has the highest valence, most of the time, so that there is something to
    /// learn.
    fn learnable_cut(spokes: &[Spoke], random: &mut Random) -> Option<(usize, usize)> {
        let n = spokes.len();
        let start = (0..n).max_by_key(|&at| spokes[at].valence)?;
        let start = if random.below(8) == 0 { random.below(n as u32) as usize } else { start };
        let length = 1 + random.below(n.min(4) as u32 - 1) as usize;
        is_free(spokes, start, length).then_some((start, length))
    }

    #[test]
    fn cuts_round_trip() {
        let mut random = Random::new(5);
        let (mut writer, mut cuts) = (RangeWriter::new(), LearnedCuts::new());
        let mut message = Vec::new();
        while message.len() < 2000 {
            let spokes = random_spokes(&mut random);
            let Some(cut) = learnable_cut(&spokes, &mut random) else { continue };
            let limits = (random.below(20) as usize, 3 + random.below(20) as usize);
            assert_eq!(cuts.code(&mut writer, &mut spokes.clone(), limits, cut), Some(cut));
            message.push((spokes, limits, cut));
        }
        let bytes = writer.finish().0;
        let (mut reader, mut cuts) = (RangeReader::new(&bytes, true), LearnedCuts::new());
        for (mut spokes, limits, cut) in message {
            assert_eq!(cuts.code(&mut reader, &mut spokes, limits, (0, 1)), Some(cut));
        }
    }

    #[test]
    fn regular_cuts_become_cheap() {
        // Always the two triangles around the one edge whose far end has few triangles.
        let mut random = Random::new(7);
        let (mut writer, mut cuts) = (RangeWriter::new(), LearnedCuts::new());
        for _ in 0..2000 {
            let marked = random.below(6) as usize;
            let mut spokes = [Spoke { is_free: true, valence: 7, ..Spoke::default() }; 6];
            spokes.iter_mut().for_each(|spoke| spoke.step = [1, 2, 3].map(|i| i + random.below(50) as i32));
            spokes[marked].valence = 4;
            let cut = ((marked + 5) % 6, 2);
            assert_eq!(cuts.code(&mut writer, &mut spokes, (6, 8), cut), Some(cut));
        }
        // Untrained, that would be five bits per cut.
        assert!(writer.finish().0.len() * 8 < 2000);
    }

    #[test]
    fn cumulative_shares_increase_for_every_symbol() {
        for weights in
            [[1; MAX_RING], [1 << 20; MAX_RING], std::array::from_fn(|at| 1 << at), [u32::MAX >> 4; MAX_RING]]
        {
            let inverse = (1 << INVERSE_BITS) / weights.iter().map(|&weight| u64::from(weight)).sum::<u64>();
            let shares = cumulative_shares(&weights, inverse);
            assert!(shares[0] == 0 && shares.windows(2).all(|pair| pair[0] < pair[1]), "{shares:?}");
        }
    }

    #[test]
    fn arbitrary_bytes_decode_to_free_runs_or_none() {
        let mut random = Random::new(6);
        let bytes: Vec<u8> = (0..3000).map(|_| random.next_u64() as u8).collect();
        let (mut reader, mut cuts) = (RangeReader::new(&bytes, true), LearnedCuts::new());
        for _ in 0..3000 {
            let mut spokes = random_spokes(&mut random);
            if let Some((start, length)) = cuts.code(&mut reader, &mut spokes, (6, 5), (0, 1)) {
                assert!(length <= 5 && is_free(&spokes, start, length));
            }
        }
    }
}
