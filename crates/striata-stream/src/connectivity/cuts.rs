//! Which run of triangles goes to the new vertex: a log-linear model over all runs that can.
//!
//! The score of a run is the sum of what its two end edges, its inner edges and its triangles bring, each looked up by
//! small features, and of what the run brings as a whole. Probabilities are the exponentials of scores over their sum, and
//! after each split every weight that had a say moves along the gradient of what the split cost. Scores without what a run
//! brings as a whole are running sums, cheap enough to ask of every vertex how well it could split.

use super::patch::{self, Patch};
use super::ring::{Ring, Spoke};
use super::softmax::{Choice, Offer, SCORE_ONE, exponential, log_sum};
use crate::entropy::Coder;

/// Most triangles of a run that the model knows; longer ones are told in another way.
pub(super) const LONGEST: usize = 12;

/// Features of an edge, as places in one table that has weights for ends and for inner edges.
const LENGTHS: usize = 17;
const VALENCES: usize = 10;
const PASTS: usize = 16;
const HEIGHTS: usize = 12;
const EDGE_WEIGHTS: usize = LENGTHS + VALENCES + PASTS + HEIGHTS;
/// Features of a triangle.
const AREAS: usize = 13;
const ANGLES: usize = 16;
const TRIANGLE_WEIGHTS: usize = AREAS + ANGLES;
/// Features of the numbers of triangles, then those of runs as wholes.
const COUNTS: usize = 0;
const REMAINS: usize = patch::VALUES;
const PATCHES: usize = 2 * patch::VALUES;
const RUN_WEIGHTS: usize = PATCHES + patch::FEATURES * patch::VALUES;

/// Runs of less than this, of a million for the best, are not worth a closer look.
const WORTH_A_LOOK: u32 = 9000;
/// How fast weights learn, in 1/16384: at first, and in the end.
const FIRST_RATE: i32 = 750;
const LAST_RATE: i32 = 120;

/// A run that can go to the new vertex.
#[derive(Clone, Copy, Debug)]
struct Run {
    first: u32,
    /// The edge where it ends.
    end: u32,
    length: u32,
    score: i32,
}

/// An edge and the triangle behind it.
#[derive(Clone, Copy, Debug)]
struct Side {
    edge: [u8; 4],
    triangle: [u8; 2],
    /// What the edge brings as an end, what it brings within a run, and what the triangle brings.
    end: i32,
    inner: i32,
    area: i32,
    /// While learning: as the first or last, as the first, and a change of how much runs cover the triangle.
    pushes: [i32; 3],
}

/// The weights of a run as a whole.
#[derive(Clone, Copy, Debug)]
struct Looks {
    run: u32,
    keys: [u16; patch::FEATURES],
}

/// The model, with scratch memory.
#[derive(Clone, Debug)]
pub(super) struct CutModel {
    edges: Vec<[i32; 2]>,
    triangles: Vec<i32>,
    wholes: Vec<i32>,
    choice: Choice,
    /// Splits learned from.
    splits: i32,
    /// Mean height of rings that split.
    height: i32,
    sides: Vec<Side>,
    runs: Vec<Run>,
    looks: Vec<Looks>,
    powers: Vec<u32>,
    total: u64,
    best: i32,
    /// Weights of each length around this vertex.
    counts: [[u16; 2]; LONGEST + 1],
}

impl CutModel {
    pub(super) fn new() -> Self {
        Self {
            edges: vec![[0; 2]; EDGE_WEIGHTS],
            triangles: vec![0; TRIANGLE_WEIGHTS],
            wholes: vec![0; RUN_WEIGHTS],
            choice: Choice::new(),
            splits: 0,
            height: 0,
            sides: Vec::new(),
            runs: Vec::new(),
            looks: Vec::new(),
            powers: Vec::new(),
            total: 0,
            best: 0,
            counts: [[0; 2]; LONGEST + 1],
        }
    }

    /// Scores all runs around a vertex that will have `planned` triangles before it splits.
    pub(super) fn score(&mut self, ring: &Ring, planned: usize, max_patch: usize) {
        let n = ring.spokes.len();
        self.sides.clear();
        for spoke in &ring.spokes {
            let edge = edge_keys(spoke, ring, self.height);
            let triangle = triangle_keys(spoke, ring);
            let (mut end, mut inner) = (0, 0);
            for &key in &edge {
                let weights = self.edges[key as usize];
                end += weights[0];
                inner += weights[1];
            }
            let area = self.triangles[triangle[0] as usize] + self.triangles[triangle[1] as usize];
            self.sides.push(Side { edge, triangle, end, inner, area, pushes: [0; 3] });
        }
        let most = max_patch.min(n.saturating_sub(1)).min(LONGEST);
        let mut by_length = [0; LONGEST + 1];
        for (length, (sum, keys)) in by_length.iter_mut().zip(&mut self.counts).enumerate().take(most + 1) {
            *keys = count_keys(n, planned, length);
            *sum = keys.iter().map(|&key| self.wholes[key as usize]).sum();
        }
        self.runs.clear();
        let sides = &self.sides[..n];
        let spokes = &ring.spokes[..n];
        for first in 0..n {
            let mut score = sides[first].end;
            let mut at = first;
            for (length, &sum) in by_length.iter().enumerate().take(most + 1).skip(1) {
                let spoke = &spokes[at];
                if spoke.is_taken || length > 1 && spoke.is_virtual {
                    break;
                }
                let side = &sides[at];
                score += side.area + if length > 1 { side.inner } else { 0 };
                at = if at + 1 < n { at + 1 } else { 0 };
                let whole = score + sides[at].end + sum;
                self.runs.push(Run {
                    first: first as u32,
                    end: at as u32,
                    length: length as u32,
                    score: whole,
                });
            }
        }
        self.sum_up();
    }

    fn sum_up(&mut self) {
        self.best = self.runs.iter().map(|run| run.score).max().unwrap_or(0);
        let (best, mut total) = (self.best, 0);
        self.powers.clear();
        self.powers.extend(self.runs.iter().map(|run| {
            let power = exponential(best - run.score);
            total += u64::from(power);
            power
        }));
        self.total = total;
    }

    /// Runs that can go to a new vertex.
    pub(super) fn run_count(&self) -> usize {
        self.runs.len()
    }

    /// The natural logarithm of the sum of the exponentials of all scores, in 1/256.
    pub(super) fn log_sum(&self) -> i32 {
        (self.best >> 8) + log_sum(self.total)
    }

    /// Codes which of the runs it is, by the index of its first edge and its length, and learns from it; there must be one.
    /// `looks_closely` says whether runs are judged as wholes too.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        ring: &Ring,
        actual: Option<(usize, usize)>,
        looks_closely: bool,
    ) -> (usize, usize) {
        self.looks.clear();
        if looks_closely {
            self.look_closely(ring);
        }
        let actual = actual
            .and_then(|run| self.runs.iter().position(|r| (r.first as usize, r.length as usize) == run));
        debug_assert!(C::READS || actual.is_some(), "the run that splits off is not one of those that can");
        let guesses = if looks_closely { 3 } else { 1 };
        let offer = Offer { weights: &mut self.powers, total: self.total, guesses };
        let chosen = self.choice.code(coder, offer, actual.unwrap_or(0));
        self.learn(chosen);
        self.height += (ring.height - self.height) >> 5;
        let run = self.runs[chosen];
        (run.first as usize, run.length as usize)
    }

    /// Adds what runs bring as wholes.
    fn look_closely(&mut self, ring: &Ring) {
        let mut whole = [0; 3];
        for spoke in &ring.spokes {
            (0..3).for_each(|a| whole[a] += i64::from(spoke.normal[a]));
        }
        let mut patch = Patch::default();
        for (at, run) in self.runs.iter_mut().enumerate() {
            if run.length == 1 {
                patch = Patch::begin(ring, run.first as usize);
            }
            patch.grow(ring);
            if self.powers[at] < WORTH_A_LOOK {
                continue;
            }
            let mut keys = patch.features(ring, whole).map(|key| key as u16);
            for (feature, key) in keys.iter_mut().enumerate() {
                *key += (PATCHES + feature * patch::VALUES) as u16;
                run.score += self.wholes[*key as usize];
            }
            self.looks.push(Looks { run: at as u32, keys });
        }
        self.sum_up();
    }

    /// Moves all weights along the gradient.
    fn learn(&mut self, chosen: usize) {
        let rate = (8 * FIRST_RATE / (8 + self.splits / 32)).max(LAST_RATE);
        self.splits = (self.splits + 1).min(1 << 20);
        let inverse = (1 << 36) / self.total.max(1);
        let push_of = |powers: &[u32], at: usize| {
            let p = ((u64::from(powers[at]) * inverse) >> 20) as i32;
            if at == chosen { 65536 - p } else { -p }
        };
        for look in &self.looks {
            let push = push_of(&self.powers, look.run as usize);
            look.keys.iter().for_each(|&key| turn(&mut self.wholes[key as usize], push, rate));
        }
        let mut by_length = [0; LONGEST + 1];
        for (at, run) in self.runs.iter().enumerate() {
            let push = push_of(&self.powers, at);
            let (first, end) = (run.first as usize, run.end as usize);
            self.sides[first].pushes[0] += push;
            self.sides[first].pushes[1] += push;
            self.sides[first].pushes[2] += push;
            self.sides[end].pushes[0] += push;
            self.sides[end].pushes[2] -= push;
            // Runs that go past the last edge cover the first triangles from the beginning.
            if end < first {
                self.sides[0].pushes[2] += push;
            }
            by_length[run.length as usize] += push;
        }
        for (push, keys) in by_length.into_iter().zip(&self.counts).filter(|&(push, _)| push != 0) {
            keys.iter().for_each(|&key| turn(&mut self.wholes[key as usize], push, rate));
        }
        let mut cover = 0;
        for side in &self.sides {
            cover += side.pushes[2];
            let inner = cover - side.pushes[1];
            for &key in &side.edge {
                let weights = &mut self.edges[key as usize];
                turn(&mut weights[0], side.pushes[0], rate);
                turn(&mut weights[1], inner, rate);
            }
            side.triangle.iter().for_each(|&key| turn(&mut self.triangles[key as usize], cover, rate));
        }
    }
}

/// Moves a weight.
#[inline]
fn turn(weight: &mut i32, push: i32, rate: i32) {
    *weight = (*weight + ((push * rate) >> 14)).clamp(-8 * SCORE_ONE, 8 * SCORE_ONE);
}

fn edge_keys(spoke: &Spoke, ring: &Ring, height: i32) -> [u8; 4] {
    let length = if spoke.is_virtual {
        16
    } else {
        ((spoke.length - ring.length + 8 * 64) >> 6).clamp(0, 15) as usize
    };
    let bend = ((spoke.height - height + 6 * 192) / 192).clamp(0, HEIGHTS as i32 - 1) as usize;
    [
        length,
        LENGTHS + usize::from(spoke.valence).min(VALENCES - 1),
        LENGTHS + VALENCES + usize::from(spoke.age * 4 + spoke.fate),
        LENGTHS + VALENCES + PASTS + bend,
    ]
    .map(|key| key as u8)
}

fn triangle_keys(spoke: &Spoke, ring: &Ring) -> [u8; 2] {
    if spoke.area == 0 {
        return [AREAS as u8 - 1, (AREAS + ANGLES - 1) as u8];
    }
    let area = ((spoke.area - ring.area + 6 * 96) / 96).clamp(0, 11) as u8;
    let angle = match (spoke.is_blunt, spoke.tangent) {
        (false, tangent) => ((tangent + 1000) / 167).clamp(0, 11) as u8,
        (true, 974..) => 12,
        (true, 407..) => 13,
        (true, _) => 14,
    };
    [area, AREAS as u8 + angle]
}

fn count_keys(n: usize, planned: usize, length: usize) -> [u16; 2] {
    let remain = (planned + 2).saturating_sub(length).min(15);
    [COUNTS + patch::class_of(length) + n.min(15), REMAINS + remain].map(|key| key as u16)
}
