//! [`CutModel`]: which run of triangles moves to the new vertex, by a log-linear model over all possible
//! runs.
//!
//! The score of a run is the sum of weights for its two end edges, its inner edges, its triangles and its
//! length, each looked up by small features, and of weights for features of the run as a whole.
//! The probability of a run is the exponential of its score over the sum of all exponentials (softmax).
//! After each split, every weight involved moves along the gradient of the coding cost. Scores without the
//! whole-run features are running sums, cheap enough to evaluate how well any vertex could split.

use super::patch::{self, Patch};
use super::ring::{Ring, RingSpoke};
use super::softmax::{Candidates, ChoiceModel, SCORE_ONE, exponential, log_sum};
use crate::entropy::Coder;

/// Maximum length of the runs that this model covers; longer ones are coded separately.
pub(super) const MAX_RUN: usize = 12;

/// Features of an edge: ranges in one table, which has a weight for end edges and one for inner edges.
const LENGTHS: usize = 17;
const VALENCES: usize = 10;
const HISTORIES: usize = 16;
const HEIGHTS: usize = 12;
const EDGE_WEIGHTS: usize = LENGTHS + VALENCES + HISTORIES + HEIGHTS;
/// Features of a triangle: ranges in one table.
const AREAS: usize = 13;
const ANGLES: usize = 16;
const TRIANGLE_WEIGHTS: usize = AREAS + ANGLES;
/// Offsets in the table of weights per run: by triangle counts, by triangles that remain, by whole-run
/// features.
const COUNTS: usize = 0;
const REMAINS: usize = patch::VALUES;
const PATCHES: usize = 2 * patch::VALUES;
const RUN_WEIGHTS: usize = PATCHES + patch::FEATURES * patch::VALUES;

/// Runs whose exponential is below this, compared with about a million for the best run, get no whole-run
/// features.
const MIN_EXAMINED: u32 = 9000;
/// Initial and final learning rate, in 1/16384.
const FIRST_RATE: i32 = 750;
const LAST_RATE: i32 = 120;

/// A run of triangles that can move to the new vertex.
#[derive(Clone, Copy, Debug)]
struct MovableRun {
    first: u32,
    /// Index of the edge at its end.
    end: u32,
    length: u32,
    score: i32,
}

/// An edge and the triangle counterclockwise of it.
#[derive(Clone, Copy, Debug)]
struct CutSide {
    edge: [u8; 4],
    triangle: [u8; 2],
    /// Scores of the edge as an end and as an inner edge, and of the triangle.
    end: i32,
    inner: i32,
    area: i32,
    /// Gradient sums while learning: over runs that start or end at this edge; over runs that start here; and
    /// the change, from the previous triangle to this one, of the sum over runs that cover the triangle.
    gradients: [i32; 3],
}

/// Whole-run features of a run.
#[derive(Clone, Copy, Debug)]
struct RunFeatures {
    run: u32,
    keys: [u16; patch::FEATURES],
}

/// The log-linear model, with scratch memory.
#[derive(Clone, Debug)]
pub(super) struct CutModel {
    edges: Vec<[i32; 2]>,
    triangles: Vec<i32>,
    run_weights: Vec<i32>,
    choice: ChoiceModel,
    /// Number of splits learned from, up to a limit.
    splits: i32,
    /// Mean height of the rings of vertices that split.
    height: i32,
    sides: Vec<CutSide>,
    runs: Vec<MovableRun>,
    run_features: Vec<RunFeatures>,
    exponentials: Vec<u32>,
    total: u64,
    best: i32,
    /// For each length, the keys of its weights around the current vertex.
    counts: [[u16; 2]; MAX_RUN + 1],
}

impl CutModel {
    pub(super) fn new() -> Self {
        Self {
            edges: vec![[0; 2]; EDGE_WEIGHTS],
            triangles: vec![0; TRIANGLE_WEIGHTS],
            run_weights: vec![0; RUN_WEIGHTS],
            choice: ChoiceModel::new(),
            splits: 0,
            height: 0,
            sides: Vec::new(),
            runs: Vec::new(),
            run_features: Vec::new(),
            exponentials: Vec::new(),
            total: 0,
            best: 0,
            counts: [[0; 2]; MAX_RUN + 1],
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
            self.sides.push(CutSide { edge, triangle, end, inner, area, gradients: [0; 3] });
        }
        let max_length = max_patch.min(n.saturating_sub(1)).min(MAX_RUN);
        let mut by_length = [0; MAX_RUN + 1];
        for (length, (sum, keys)) in
            by_length.iter_mut().zip(&mut self.counts).enumerate().take(max_length + 1)
        {
            *keys = count_keys(n, planned, length);
            *sum = keys.iter().map(|&key| self.run_weights[key as usize]).sum();
        }
        self.runs.clear();
        let sides = &self.sides[..n];
        let spokes = &ring.spokes[..n];
        for first in 0..n {
            let mut score = sides[first].end;
            let mut at = first;
            for (length, &sum) in by_length.iter().enumerate().take(max_length + 1).skip(1) {
                let spoke = &spokes[at];
                if spoke.is_claimed || length > 1 && spoke.is_virtual {
                    break;
                }
                let side = &sides[at];
                score += side.area + if length > 1 { side.inner } else { 0 };
                at = if at + 1 < n { at + 1 } else { 0 };
                let whole = score + sides[at].end + sum;
                self.runs.push(MovableRun {
                    first: first as u32,
                    end: at as u32,
                    length: length as u32,
                    score: whole,
                });
            }
        }
        self.exponentiate();
    }

    fn exponentiate(&mut self) {
        self.best = self.runs.iter().map(|run| run.score).max().unwrap_or(0);
        let (best, mut total) = (self.best, 0);
        self.exponentials.clear();
        self.exponentials.extend(self.runs.iter().map(|run| {
            let exponential_of_run = exponential(best - run.score);
            total += u64::from(exponential_of_run);
            exponential_of_run
        }));
        self.total = total;
    }

    /// Returns the number of runs that can move to a new vertex.
    pub(super) fn run_count(&self) -> usize {
        self.runs.len()
    }

    /// Returns the natural logarithm of the sum of the exponentials of all scores, in 1/256.
    pub(super) fn log_sum(&self) -> i32 {
        (self.best >> 8) + log_sum(self.total)
    }

    /// Codes one of the runs, given by the index of its first edge and its length, and learns from it.
    /// There must be at least one run.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        ring: &Ring,
        actual: Option<(usize, usize)>,
    ) -> (usize, usize) {
        self.add_run_features(ring);
        let actual = actual
            .and_then(|run| self.runs.iter().position(|r| (r.first as usize, r.length as usize) == run));
        debug_assert!(C::READS || actual.is_some(), "the run of the cut is not one of the possible runs");
        let candidates = Candidates { weights: &mut self.exponentials, total: self.total };
        let chosen = self.choice.code(coder, candidates, actual.unwrap_or(0));
        self.learn(chosen);
        self.height += (ring.height - self.height) >> 5;
        let run = self.runs[chosen];
        (run.first as usize, run.length as usize)
    }

    /// Adds the scores of whole-run features.
    fn add_run_features(&mut self, ring: &Ring) {
        self.run_features.clear();
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
            if self.exponentials[at] < MIN_EXAMINED {
                continue;
            }
            let mut keys = patch.features(ring, whole).map(|key| key as u16);
            for (feature, key) in keys.iter_mut().enumerate() {
                *key += (PATCHES + feature * patch::VALUES) as u16;
                run.score += self.run_weights[*key as usize];
            }
            self.run_features.push(RunFeatures { run: at as u32, keys });
        }
        self.exponentiate();
    }

    /// Moves all weights along the gradient.
    fn learn(&mut self, chosen: usize) {
        let rate = (8 * FIRST_RATE / (8 + self.splits / 32)).max(LAST_RATE);
        self.splits = (self.splits + 1).min(1 << 20);
        let inverse = (1 << 36) / self.total.max(1);
        let gradient_of = |exponentials: &[u32], at: usize| {
            let p = ((u64::from(exponentials[at]) * inverse) >> 20) as i32;
            if at == chosen { 65536 - p } else { -p }
        };
        for features in &self.run_features {
            let gradient = gradient_of(&self.exponentials, features.run as usize);
            features.keys.iter().for_each(|&key| adjust(&mut self.run_weights[key as usize], gradient, rate));
        }
        let mut by_length = [0; MAX_RUN + 1];
        for (at, run) in self.runs.iter().enumerate() {
            let gradient = gradient_of(&self.exponentials, at);
            let (first, end) = (run.first as usize, run.end as usize);
            self.sides[first].gradients[0] += gradient;
            self.sides[first].gradients[1] += gradient;
            self.sides[first].gradients[2] += gradient;
            self.sides[end].gradients[0] += gradient;
            self.sides[end].gradients[2] -= gradient;
            // Runs that wrap around past the last edge also cover the first triangles.
            if end < first {
                self.sides[0].gradients[2] += gradient;
            }
            by_length[run.length as usize] += gradient;
        }
        for (gradient, keys) in by_length.into_iter().zip(&self.counts).filter(|&(gradient, _)| gradient != 0)
        {
            keys.iter().for_each(|&key| adjust(&mut self.run_weights[key as usize], gradient, rate));
        }
        let mut covering = 0;
        for side in &self.sides {
            covering += side.gradients[2];
            let inner = covering - side.gradients[1];
            for &key in &side.edge {
                let weights = &mut self.edges[key as usize];
                adjust(&mut weights[0], side.gradients[0], rate);
                adjust(&mut weights[1], inner, rate);
            }
            side.triangle.iter().for_each(|&key| adjust(&mut self.triangles[key as usize], covering, rate));
        }
    }
}

/// Moves a weight, within its limits.
#[inline]
fn adjust(weight: &mut i32, gradient: i32, rate: i32) {
    *weight = (*weight + ((gradient * rate) >> 14)).clamp(-8 * SCORE_ONE, 8 * SCORE_ONE);
}

fn edge_keys(spoke: &RingSpoke, ring: &Ring, height: i32) -> [u8; 4] {
    let length = if spoke.is_virtual {
        16
    } else {
        ((spoke.length - ring.length + 8 * 64) >> 6).clamp(0, 15) as usize
    };
    let bend = ((spoke.height - height + 6 * 192) / 192).clamp(0, HEIGHTS as i32 - 1) as usize;
    [
        length,
        LENGTHS + usize::from(spoke.valence).min(VALENCES - 1),
        LENGTHS + VALENCES + usize::from(spoke.age * 4 + spoke.state),
        LENGTHS + VALENCES + HISTORIES + bend,
    ]
    .map(|key| key as u8)
}

fn triangle_keys(spoke: &RingSpoke, ring: &Ring) -> [u8; 2] {
    if spoke.area == 0 {
        return [AREAS as u8 - 1, (AREAS + ANGLES - 1) as u8];
    }
    let area = ((spoke.area - ring.area + 6 * 96) / 96).clamp(0, 11) as u8;
    let angle = match (spoke.is_obtuse, spoke.tangent) {
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
