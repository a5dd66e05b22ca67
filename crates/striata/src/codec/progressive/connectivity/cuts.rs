//! Which run of triangles goes to the new vertex: a log-linear model over all runs that can.
//!
//! The score of a run is the sum of what its two end edges, its inner edges and its triangles bring, each looked up by
//! small features; so all runs around a vertex are scored by running sums. Probabilities are the exponentials of scores over
//! their sum, and after each split every weight that had a say moves along the gradient of what the split cost \[Mah05\].

use super::super::super::entropy::Coder;
use super::super::surface::Cut;
use super::ring::{Ring, Spoke, dot, log2_wide};
use super::softmax::{Choice, SCORE_ONE, exponential, log_sum};

/// A run that can go to the new vertex.
#[derive(Clone, Copy, Debug)]
struct Run {
    first: u32,
    length: u32,
    score: i32,
}

/// Tables of the model, one behind the other.
const LENGTHS: usize = 17;
const VALENCES: usize = 10;
const AGES: usize = 4;
const FATES: usize = 4;
const HEIGHTS: usize = 12;
const EDGE: usize = LENGTHS + VALENCES + AGES + FATES + HEIGHTS;
const ENDS: usize = 0;
const INNER: usize = EDGE;
const AREAS: usize = 2 * EDGE;
const AREA_STEPS: usize = 13;
const ANGLES: usize = AREAS + AREA_STEPS;
const ANGLE_STEPS: usize = 16;
const COUNTS: usize = ANGLES + ANGLE_STEPS;
const COUNT_STEPS: usize = 16 * 8;
const REMAINS: usize = COUNTS + COUNT_STEPS;
const REMAIN_STEPS: usize = 16;
const CENTRES: usize = REMAINS + REMAIN_STEPS;
const CENTRE_STEPS: usize = 8 * 16;
const SHARES: usize = CENTRES + CENTRE_STEPS;
const SHARE_STEPS: usize = 8 * 16;
const OWNERS: usize = SHARES + SHARE_STEPS;
const OWNER_STEPS: usize = 8;
const WEIGHTS: usize = OWNERS + OWNER_STEPS;

/// The features of an edge as places in [`ENDS`] or [`INNER`].
type EdgeKeys = [u8; 5];

/// The model, with scratch memory.
#[derive(Clone, Debug)]
pub(super) struct CutModel {
    weights: Vec<i32>,
    choice: Choice,
    runs: Vec<Run>,
    powers: Vec<u32>,
    total: u64,
    best: i32,
    edges: Vec<EdgeKeys>,
    triangles: Vec<[u8; 2]>,
    /// Scores of each edge as an end and as an inner one, and of each triangle.
    parts: Vec<[i32; 3]>,
    splits: u32,
    /// Mean logarithm of heights.
    height: i32,
    /// The valence of the vertex with all splits known so far.
    planned: usize,
    gradient: Vec<[i32; 3]>,
    pairs: Vec<[u16; 3]>,
}

impl CutModel {
    pub(super) fn new() -> Self {
        Self {
            weights: vec![0; WEIGHTS],
            choice: Choice::new(),
            runs: Vec::new(),
            powers: Vec::new(),
            total: 0,
            best: 0,
            edges: Vec::new(),
            triangles: Vec::new(),
            parts: Vec::new(),
            splits: 0,
            height: 0,
            planned: 6,
            gradient: Vec::new(),
            pairs: Vec::new(),
        }
    }

    /// Scores all runs around a vertex.
    pub(super) fn score(&mut self, ring: &Ring, planned: usize, max_patch: u32) {
        let n = ring.spokes.len();
        self.planned = planned;
        self.edges.clear();
        self.triangles.clear();
        self.parts.clear();
        for spoke in &ring.spokes {
            let edge = edge_keys(spoke, ring, self.height);
            let triangle = triangle_keys(spoke, ring);
            let sum = |base: usize| edge.iter().map(|&k| self.weights[base + k as usize]).sum::<i32>();
            self.parts.push([
                sum(ENDS),
                sum(INNER),
                self.weights[AREAS + triangle[0] as usize] + self.weights[ANGLES + triangle[1] as usize],
            ]);
            self.edges.push(edge);
            self.triangles.push(triangle);
        }
        self.runs.clear();
        let most = (max_patch as usize).min(n.saturating_sub(1));
        for i in 0..n {
            let mut score = self.parts[i][0];
            let mut j = i;
            for length in 1..=most {
                let spoke = &ring.spokes[j];
                if spoke.is_taken || length > 1 && spoke.is_virtual {
                    break;
                }
                score += self.parts[j][2];
                if length > 1 {
                    score += self.parts[j][1];
                }
                j = if j + 1 < n { j + 1 } else { 0 };
                let [count, remain] = count_keys(n, planned, length);
                let whole = score + self.parts[j][0] + self.weights[count] + self.weights[remain];
                self.runs.push(Run { first: i as u32, length: length as u32, score: whole });
            }
        }
        self.sum_up();
    }

    fn sum_up(&mut self) {
        self.best = self.runs.iter().map(|run| run.score).max().unwrap_or(0);
        self.powers.clear();
        self.powers.extend(self.runs.iter().map(|run| exponential(self.best - run.score)));
        self.total = self.powers.iter().map(|&p| u64::from(p)).sum();
    }

    /// Runs that can go to a new vertex.
    pub(super) fn run_count(&self) -> usize {
        self.runs.len()
    }

    /// The natural logarithm of the sum of the exponentials of all scores, in 1/256.
    pub(super) fn log_sum(&self) -> i32 {
        (self.best >> 8) + log_sum(self.total)
    }

    /// Codes which of the runs it is, and learns from it; there must be one.
    pub(super) fn code<C: Coder>(
        &mut self,
        coder: &mut C,
        ring: &Ring,
        corners: &[u32],
        actual: Option<Cut>,
    ) -> Cut {
        self.pair_up(ring);
        let actual = actual.and_then(|cut| {
            self.runs.iter().position(|run| {
                corners[run.first as usize] == cut.first && run.length == cut.length
            })
        });
        debug_assert!(C::READS || actual.is_some(), "the run that splits off is not one of those that can");
        let chosen = self.choice.code(coder, &mut self.powers, self.total, actual.unwrap_or(0));
        self.learn(chosen);
        self.height += (ring.height - self.height) >> 5;
        let run = self.runs[chosen];
        Cut { first: corners[run.first as usize], length: run.length }
    }

    /// Adds what depends on both ends of a run.
    fn pair_up(&mut self, ring: &Ring) {
        let n = ring.spokes.len();
        self.pairs.clear();
        let mut whole = [0i64; 3];
        for spoke in &ring.spokes {
            (0..3).for_each(|a| whole[a] += spoke.normal[a]);
        }
        let (mut steps, mut squares, mut normal) = ([0i64; 3], 0i64, [0i64; 3]);
        for run in &mut self.runs {
            let i = run.first as usize;
            if run.length == 1 {
                let step = ring.spokes[i].step.map(i64::from);
                (steps, squares, normal) = (step, dot(step, step), [0; 3]);
            }
            let j = (i + run.length as usize) % n;
            let before = if j == 0 { n - 1 } else { j - 1 };
            let step = ring.spokes[j].step.map(i64::from);
            (0..3).for_each(|a| {
                steps[a] += step[a];
                normal[a] += ring.spokes[before].normal[a];
            });
            squares += dot(step, step);
            let l = (run.length as usize).min(7);
            let is_open = ring.spokes[i].is_virtual || ring.spokes[j].is_virtual;
            let centre = if is_open {
                15
            } else {
                let centre = log2_wide(dot(steps, steps) as u64)
                    - log2_wide((i64::from(run.length) + 2) as u64 * squares as u64);
                ((centre + 15 * 64) / 64).clamp(0, 14) as usize
            };
            let rest: [i64; 3] = std::array::from_fn(|a| whole[a] - normal[a]);
            let outside = (n as u32).saturating_sub(run.length).max(1);
            let share = log2_wide(dot(normal, normal) as u64)
                - log2_wide(dot(rest, rest) as u64)
                - 2 * (log2_wide(u64::from(run.length) + 2) - log2_wide(u64::from(outside)));
            let share = ((share + 8 * 96) / 96).clamp(0, 15) as usize;
            let owner = owner_key(run, ring);
            let keys = [CENTRES + l * 16 + centre, SHARES + l * 16 + share, OWNERS + owner];
            run.score += keys.iter().map(|&k| self.weights[k]).sum::<i32>();
            self.pairs.push(keys.map(|k| k as u16));
        }
        self.sum_up();
    }

    /// Moves all weights along the gradient.
    fn learn(&mut self, chosen: usize) {
        let n = self.edges.len();
        self.splits += 1;
        let rate = (6000 / (8 + self.splits.min(1 << 16) / 16)).max(120) as i32;
        let step = |push: i32| ((i64::from(push) * i64::from(rate)) >> 14) as i32;
        // Ends, inner edges and triangles: what was expected of each, less what came, in 1/65536.
        self.gradient.clear();
        self.gradient.resize(n, [0; 3]);
        let mut taken = 0;
        for (at, run) in self.runs.iter().enumerate() {
            let power = u64::from(self.powers[at]);
            let p = ((power << 16) / self.total.max(1)) as i32;
            let push = if at == chosen { 65536 - p } else { -p };
            taken += p;
            let (i, l) = (run.first as usize, run.length as usize);
            let j = (i + l) % n;
            self.gradient[i][0] += push;
            self.gradient[j][0] += push;
            self.gradient[i][2] += push;
            self.gradient[j][2] -= push;
            // Runs that go past the last edge cover the first ones from the beginning.
            self.gradient[i][1] += push;
            if i + l > n || (i + l == n && false) {
                self.gradient[0][2] += push;
            }
            if i + l == n {
                self.gradient[0][2] += push;
            }
            let [count, remain] = count_keys(n, self.planned, l);
            for key in [count, remain].into_iter().chain(self.pairs[at].map(usize::from)) {
                self.weights[key] += step(push);
            }
        }
        let _ = taken;
        let mut cover = 0;
        for i in 0..n {
            cover += self.gradient[i][2];
            let [end, starts, _] = self.gradient[i];
            let inner = cover - starts;
            for &key in &self.edges[i] {
                self.weights[ENDS + key as usize] += step(end);
                self.weights[INNER + key as usize] += step(inner);
            }
            let [area, angle] = self.triangles[i];
            self.weights[AREAS + area as usize] += step(cover);
            self.weights[ANGLES + angle as usize] += step(cover);
        }
        for weight in &mut self.weights {
            *weight = (*weight).clamp(-8 * SCORE_ONE, 8 * SCORE_ONE);
        }
    }
}

fn edge_keys(spoke: &Spoke, ring: &Ring, height: i32) -> EdgeKeys {
    let length = if spoke.is_virtual {
        16
    } else {
        ((spoke.length - ring.length + 8 * 64) >> 6).clamp(0, 15)
    };
    let bend = ((spoke.height - height + 6 * 192) / 192).clamp(0, 11);
    let mut keys = [length as usize, spoke.valence.min(9), spoke.age, spoke.fate, bend as usize];
    keys[1] += LENGTHS;
    keys[2] += LENGTHS + VALENCES;
    keys[3] += LENGTHS + VALENCES + AGES;
    keys[4] += LENGTHS + VALENCES + AGES + FATES;
    keys.map(|k| k as u8)
}

fn triangle_keys(spoke: &Spoke, ring: &Ring) -> [u8; 2] {
    if spoke.area == 0 {
        return [12, 15];
    }
    let area = ((spoke.area - ring.area + 6 * 96) / 96).clamp(0, 11);
    let angle = if !spoke.is_blunt {
        ((spoke.tangent + 1000) / 167).clamp(0, 11)
    } else if spoke.tangent > 973 {
        12
    } else if spoke.tangent > 406 {
        13
    } else {
        14
    };
    [area as u8, angle as u8]
}

fn count_keys(n: usize, planned: usize, length: usize) -> [usize; 2] {
    let remain = (planned + 2).saturating_sub(length).min(15);
    [COUNTS + n.min(15) * 8 + length.min(7), REMAINS + remain]
}

/// How many of the other vertices that might have had a patch of one or two triangles were asked, and had nothing.
fn owner_key(run: &Run, ring: &Ring) -> usize {
    let n = ring.spokes.len();
    let at = |k: usize| ring.spokes[(run.first as usize + k) % n];
    match run.length {
        1 => 1 + usize::from(at(0).fate == 1) + usize::from(at(1).fate == 1),
        2 => 4 + usize::from(at(1).fate == 1),
        _ => 0,
    }
}
