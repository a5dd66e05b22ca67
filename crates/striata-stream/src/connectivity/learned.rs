//! Cuts around vertices of few triangles, for effort default: the log-linear model of `cuts.rs`, in the form that takes the
//! least time.
//!
//! Scores are sums over edges and triangles of a run, so each is a part for where the run begins, a part for where it ends and
//! a part for its length. A run is told by two symbols, its length and then its beginning, both with the shares that the
//! exponentials of scores come to. All weights then move along the gradient.

use super::quick_cuts::MOST;
use super::ring::{cross, dot, dot_wide, log2_wide, mean};
use super::softmax::{SCORE_ONE, exponential};
use crate::entropy::{Coder, QuickShares, log2_q8};

/// Features of an edge, as places in one table that has weights for ends and for inner edges.
const LENGTHS: usize = 17;
const VALENCES: usize = 10;
const PASTS: usize = 16;
const HEIGHTS: usize = 12;
/// Weights of edges and of triangles: powers of two, so that no place is beyond them.
const EDGE_WEIGHTS: usize = 64;
const TRIANGLE_WEIGHTS: usize = 32;
/// Features of a triangle.
const AREAS: usize = 13;
const ANGLES: usize = 16;
const _: () = assert!(LENGTHS + VALENCES + PASTS + HEIGHTS <= EDGE_WEIGHTS);
const _: () = assert!(AREAS + ANGLES <= TRIANGLE_WEIGHTS);

/// How fast weights learn, in 1/16384: at first, and in the end.
const FIRST_RATE: i32 = 750;
const LAST_RATE: i32 = 120;
/// Bits of a step.
const STEP_BITS: i32 = 13;
/// Heights below this are noise of the grid.
const LEAST_HEIGHT: i32 = -512;

/// An edge from the vertex that splits, and the triangle behind it, counter-clockwise.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Spoke {
    /// To its end; zeros if that is virtual.
    pub(crate) step: [i32; 3],
    /// Triangles around its end, once all splits that are known are done.
    pub(crate) valence: u8,
    /// Four times the age of its end in batches, up to 3, and what became of it: not asked, stays, splits, new.
    pub(crate) past: u8,
    /// Whether its end stands for a boundary loop.
    pub(crate) is_virtual: bool,
    /// Whether the triangle may go to the new vertex.
    pub(crate) is_free: bool,
}

/// What one edge and the triangle behind it are looked up by, and what they bring.
#[derive(Clone, Copy, Debug, Default)]
struct Side {
    edge: [u8; 4],
    triangle: [u8; 2],
    /// What the edge brings as an end and what it brings within a run.
    edge_scores: [i32; 2],
    area_score: i32,
}

/// The model, with scratch memory.
#[derive(Clone, Debug)]
pub(crate) struct LearnedCuts {
    /// As an end, and within a run.
    edges: [[i32; 2]; EDGE_WEIGHTS],
    triangles: [i32; TRIANGLE_WEIGHTS],
    /// By triangles around the vertex and length, and by triangles that stay.
    counts: [[i32; MOST]; MOST + 1],
    remains: [i32; MOST],
    /// Splits learned from.
    splits: i32,
    /// Mean height of rings that split.
    height: i32,
    sides: [Side; MOST],
    /// Where runs of each length begin, a bit each.
    starts: [u32; MOST],
    /// By length, then by beginning: the score of a run, then its exponential.
    scores: [[i32; MOST]; MOST],
    powers: [[u32; MOST]; MOST],
    /// Sum of all exponentials of runs of a length less one.
    by_length: [u32; MOST],
}

/// A cut that was chosen.
#[derive(Clone, Copy)]
struct Choice {
    /// Triangles around the vertex.
    n: usize,
    /// Those that it will have with all splits that are known.
    planned: usize,
    /// The most that a cut may take.
    most: usize,
    start: usize,
    length: usize,
}

impl LearnedCuts {
    /// Nothing learned.
    pub(crate) fn new() -> Self {
        Self {
            edges: [[0; 2]; EDGE_WEIGHTS],
            triangles: [0; TRIANGLE_WEIGHTS],
            counts: [[0; MOST]; MOST + 1],
            remains: [0; MOST],
            splits: 0,
            height: 0,
            sides: [Side::default(); MOST],
            starts: [0; MOST],
            scores: [[0; MOST]; MOST],
            powers: [[0; MOST]; MOST],
            by_length: [0; MOST],
        }
    }

    /// Codes where the run of a cut begins and its length, among at most [`MOST`] edges and two at least, around a vertex that
    /// will have `planned` triangles before it splits; none where a damaged stream tells of a run that is not free.
    pub(crate) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        spokes: &mut [Spoke],
        (planned, max_length): (usize, usize),
        meant: (usize, usize),
    ) -> Option<(usize, usize)> {
        let n = spokes.len();
        let height = self.measure(spokes);
        let most = max_length.min(n - 1);
        let best = self.score(spokes, planned, most)?;
        let total = self.raise(best, most);
        let inverse = (1 << INVERSE_LOG) / u64::from(total);
        let shares = shares_of(&self.by_length, inverse);
        let length = 1 + coder.quick_symbol(meant.1.wrapping_sub(1) & (MOST - 1), &shares);
        if length > most || self.starts[length] == 0 {
            return None;
        }
        let starts = self.starts[length];
        let start = if starts & (starts - 1) == 0 {
            starts.trailing_zeros() as usize
        } else {
            let inverse = (1 << INVERSE_LOG) / u64::from(self.by_length[length - 1]);
            coder.quick_symbol(meant.0 & (MOST - 1), &shares_of(&self.powers[length], inverse))
        };
        if starts >> start & 1 == 0 {
            return None;
        }
        self.learn(Choice { n, planned, most, start, length }, inverse);
        self.height += (height - self.height) >> 5;
        Some((start, length))
    }

    /// Finds by what the weights of all edges and triangles are looked up; returns the mean height.
    fn measure(&mut self, spokes: &mut [Spoke]) -> i32 {
        let n = spokes.len();
        let reach = spokes.iter().flat_map(|spoke| spoke.step).fold(0, |reach, x| reach | x.unsigned_abs());
        let shift = (32 - STEP_BITS - reach.leading_zeros() as i32).max(0);
        let (mut normals, mut lengths, mut areas) = ([[0; 3]; MOST], [0; MOST], [0; MOST]);
        let mut tangents = [0; MOST];
        let mut is_blunt = [false; MOST];
        spokes.iter_mut().for_each(|spoke| spoke.step = spoke.step.map(|x| x >> shift));
        let (mut edge_count, mut triangle_count) = (0, 0);
        for at in 0..n {
            let step = spokes[at].step;
            let behind = spokes[after(at, n)].step;
            lengths[at] = log2_q8(dot(step, step) as u32);
            edge_count += usize::from(!spokes[at].is_virtual);
            normals[at] = cross(step, behind);
            let normal = normals[at].map(i64::from);
            areas[at] = log2_wide(dot_wide(normal, normal) as u64);
            triangle_count += usize::from(areas[at] != 0);
            let cosine = dot(step, behind);
            tangents[at] = areas[at] - 2 * log2_q8(cosine.unsigned_abs());
            is_blunt[at] = cosine < 0;
        }
        let length = mean(lengths[..n].iter().map(|&x| i64::from(x)).sum(), edge_count);
        let area = mean(areas[..n].iter().map(|&x| i64::from(x)).sum(), triangle_count);
        let (mut heights, mut height_count) = (0, 0);
        for at in 0..n {
            let before = if at > 0 { at - 1 } else { n - 1 };
            let behind = &spokes[after(at, n)];
            let mut height = 0;
            if areas[before] != 0 && !behind.is_virtual {
                let volume = dot_wide(normals[before].map(i64::from), behind.step.map(i64::from));
                height = 2 * log2_wide(volume.unsigned_abs()) - areas[before] + 512 * shift;
                height = height.max(LEAST_HEIGHT);
                heights += i64::from(height);
                height_count += 1;
            }
            self.sides[at].edge = edge_keys(&spokes[at], lengths[at] - length, height - self.height);
            self.sides[at].triangle =
                triangle_keys(areas[at], areas[at] - area, (is_blunt[at], tangents[at]));
        }
        mean(heights, height_count)
    }

    /// Scores all runs that can go to the new vertex; returns the best score, if there is any.
    fn score(&mut self, spokes: &[Spoke], planned: usize, most: usize) -> Option<i32> {
        let n = spokes.len();
        // What a run from the first edge to each one brings, twice around.
        let (mut begins, mut ends) = ([0; MOST], [0; 2 * MOST]);
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
            // A run's part before its end: what was not taken away where it began.
            ends[at] = 2 * end - self.sides[at].edge_scores[1] - begins[at];
            ends[at + n] = ends[at] + sum;
        }
        let mut free = spokes.iter().enumerate().fold(0, |free, (at, s)| free | u32::from(s.is_free) << at);
        let mut open =
            spokes.iter().enumerate().fold(0, |open, (at, s)| open | u32::from(s.is_virtual) << at);
        (free, open) = (free | free << n, open | open << n);
        let mut best = i32::MIN;
        let mut starts = free & ((1 << n) - 1);
        for length in 1..=most {
            self.starts[length] = starts;
            let whole = self.counts[n][length] + self.remains[remain(planned, length)];
            let mut left = starts;
            while left != 0 {
                let at = left.trailing_zeros() as usize % MOST;
                left &= left - 1;
                let score = begins[at] + ends[at + length] + whole;
                self.scores[length][at] = score;
                best = best.max(score);
            }
            starts &= free >> length & !(open >> length);
        }
        (best > i32::MIN).then_some(best)
    }

    /// Makes exponentials of scores; returns the sum of them all.
    fn raise(&mut self, best: i32, most: usize) -> u32 {
        self.by_length = [0; MOST];
        let mut total = 0;
        for length in 1..=most {
            let mut left = self.starts[length];
            if left == 0 {
                continue;
            }
            let powers = &mut self.powers[length];
            *powers = [0; MOST];
            let mut sum = 0;
            while left != 0 {
                let at = left.trailing_zeros() as usize % MOST;
                left &= left - 1;
                powers[at] = exponential(best - self.scores[length][at]);
                sum += powers[at];
            }
            self.by_length[length - 1] = sum;
            total += sum;
        }
        total
    }

    /// Moves all weights along the gradient; `inverse` is that of the sum of all exponentials.
    fn learn(&mut self, chosen: Choice, inverse: u64) {
        let Choice { n, planned, most, .. } = chosen;
        let rate = if self.splits < 32 * 42 {
            self.splits += 1;
            (8 * FIRST_RATE / (8 + self.splits / 32)).max(LAST_RATE)
        } else {
            LAST_RATE
        };
        let (mut begins, mut ends) = ([0; MOST], [0; 2 * MOST]);
        for length in 1..=most {
            let mut left = self.starts[length];
            let mut pushes = 0;
            while left != 0 {
                let at = left.trailing_zeros() as usize % MOST;
                left &= left - 1;
                let part = ((u64::from(self.powers[length][at]) * inverse) >> (INVERSE_LOG - 16)) as i32;
                begins[at] -= part;
                ends[at + length] -= part;
                pushes -= part;
            }
            if length == chosen.length {
                pushes += 1 << 16;
            }
            let step = (pushes * rate) >> 14;
            turn(&mut self.counts[n][length], step);
            turn(&mut self.remains[remain(planned, length)], step);
        }
        begins[chosen.start] += 1 << 16;
        ends[chosen.start + chosen.length] += 1 << 16;
        // Runs that go past the last edge cover the first triangles from the beginning.
        let mut cover = ends[n..2 * n].iter().sum::<i32>();
        for (at, side) in self.sides[..n].iter().enumerate() {
            let end = ends[at] + ends[at + n];
            cover += begins[at] - end;
            let steps = [begins[at] + end, cover - begins[at], cover].map(|push| (push * rate) >> 14);
            for &key in &side.edge {
                let weights = &mut self.edges[usize::from(key) % EDGE_WEIGHTS];
                turn(&mut weights[0], steps[0]);
                turn(&mut weights[1], steps[1]);
            }
            for &key in &side.triangle {
                turn(&mut self.triangles[usize::from(key) % TRIANGLE_WEIGHTS], steps[2]);
            }
        }
    }
}

/// Inverses of sums are in one part of 2 to this.
const INVERSE_LOG: u32 = 36;

/// What is shared by weight: 15 bits, less one for each symbol, and less one since an end stays below 2^15.
const SHARED: u32 = (1 << 15) - MOST as u32 - 1;

/// Where shares begin that are proportional to weights, up to one more for each that is not 0; `inverse` is that of their sum.
#[inline]
fn shares_of(weights: &[u32; MOST], inverse: u64) -> QuickShares {
    let mut shares = [0; MOST];
    let mut begin = 0;
    for (share, &weight) in shares.iter_mut().zip(weights) {
        *share = begin;
        let part = ((u64::from(weight) * inverse) >> (INVERSE_LOG - 16)) as u32;
        begin += ((part * SHARED) >> 16) as i16 + i16::from(weight > 0);
    }
    shares
}

#[inline]
fn after(at: usize, n: usize) -> usize {
    if at + 1 < n { at + 1 } else { 0 }
}

/// Triangles that stay, as a place among weights.
#[inline]
fn remain(planned: usize, length: usize) -> usize {
    (planned + 2).saturating_sub(length).min(MOST - 1)
}

/// Moves a weight.
#[inline]
fn turn(weight: &mut i32, step: i32) {
    *weight = (*weight + step).clamp(-8 * SCORE_ONE, 8 * SCORE_ONE);
}

/// By what an edge is looked up: its length and its height are against what is usual.
#[inline]
fn edge_keys(spoke: &Spoke, length: i32, height: i32) -> [u8; 4] {
    let length = if spoke.is_virtual { 16 } else { ((length + 8 * 64) >> 6).clamp(0, 15) as usize };
    let bend = ((height + 6 * 192) / 192).clamp(0, HEIGHTS as i32 - 1) as usize;
    [
        length,
        LENGTHS + usize::from(spoke.valence).min(VALENCES - 1),
        LENGTHS + VALENCES + usize::from(spoke.past) % PASTS,
        LENGTHS + VALENCES + PASTS + bend,
    ]
    .map(|key| key as u8)
}

/// By what a triangle is looked up; one of no area is virtual.
#[inline]
fn triangle_keys(area: i32, against: i32, (is_blunt, tangent): (bool, i32)) -> [u8; 2] {
    if area == 0 {
        return [AREAS as u8 - 1, (AREAS + ANGLES - 1) as u8];
    }
    let angle = match (is_blunt, tangent) {
        (false, tangent) => ((tangent + 1000) / 167).clamp(0, 11) as u8,
        (true, 974..) => 12,
        (true, 407..) => 13,
        (true, _) => 14,
    };
    [((against + 6 * 96) / 96).clamp(0, 11) as u8, AREAS as u8 + angle]
}

#[cfg(test)]
mod tests {
    use striata::mesh::Random;

    use super::*;
    use crate::entropy::{RangeReader, RangeWriter};

    fn random_spokes(random: &mut Random) -> Vec<Spoke> {
        let reach = 1 << random.below(24);
        let spoke = |random: &mut Random| {
            let is_virtual = random.below(12) == 0;
            let step = [(); 3].map(|()| random.below(2 * reach) as i32 - reach as i32);
            Spoke {
                step: if is_virtual { [0; 3] } else { step },
                valence: random.below(256) as u8,
                past: random.below(16) as u8,
                is_virtual,
                is_free: random.below(4) > 0,
            }
        };
        (0..2 + random.below(MOST as u32 - 1)).map(|_| spoke(random)).collect()
    }

    /// Whether a run can go to a new vertex, edge by edge.
    fn is_free(spokes: &[Spoke], start: usize, length: usize) -> bool {
        let n = spokes.len();
        (0..length)
            .all(|at| spokes[(start + at) % n].is_free && (at == 0 || !spokes[(start + at) % n].is_virtual))
    }

    /// Where the most triangles stay at a few edges, so that there is something to learn.
    fn cut_of(spokes: &[Spoke], random: &mut Random) -> Option<(usize, usize)> {
        let n = spokes.len();
        let start = (0..n).max_by_key(|&at| spokes[at].valence)?;
        let start = if random.below(8) == 0 { random.below(n as u32) as usize } else { start };
        let length = 1 + random.below(n.min(4) as u32 - 1) as usize;
        is_free(spokes, start, length).then_some((start, length))
    }

    #[test]
    fn cuts_come_back() {
        let mut random = Random::new(5);
        let (mut writer, mut cuts) = (RangeWriter::new(), LearnedCuts::new());
        let mut message = Vec::new();
        while message.len() < 2000 {
            let spokes = random_spokes(&mut random);
            let Some(cut) = cut_of(&spokes, &mut random) else { continue };
            let known = (random.below(20) as usize, 3 + random.below(20) as usize);
            assert_eq!(cuts.code(&mut writer, &mut spokes.clone(), known, cut), Some(cut));
            message.push((spokes, known, cut));
        }
        let bytes = writer.finish().0;
        let (mut reader, mut cuts) = (RangeReader::new(&bytes, true), LearnedCuts::new());
        for (mut spokes, known, cut) in message {
            assert_eq!(cuts.code(&mut reader, &mut spokes, known, (0, 1)), Some(cut));
        }
    }

    #[test]
    fn what_is_usual_becomes_cheap() {
        // Always the two triangles around the one edge whose end has few triangles.
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
        // Nothing known, that would be five bits each.
        assert!(writer.finish().0.len() * 8 < 2000);
    }

    #[test]
    fn shares_rise_and_leave_none_out() {
        for weights in [[1; MOST], [1 << 20; MOST], std::array::from_fn(|at| 1 << at), [u32::MAX >> 4; MOST]]
        {
            let inverse = (1 << INVERSE_LOG) / weights.iter().map(|&weight| u64::from(weight)).sum::<u64>();
            let shares = shares_of(&weights, inverse);
            assert!(shares[0] == 0 && shares.windows(2).all(|pair| pair[0] < pair[1]), "{shares:?}");
        }
    }

    #[test]
    fn any_bytes_give_free_runs_or_none() {
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
