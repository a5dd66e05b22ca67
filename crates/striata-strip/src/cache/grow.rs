//! Grows strips for a vertex cache triangle by triangle, many partial answers beside each other.
//!
//! A beam search. Each answer can go on straight, with a swap, or with a new strip beside what is cached; the best of all
//! that arise are kept, as long as they differ: answers that have drawn the same triangles are one, and at most half
//! begin their last strip with the same step, so that the rows that turned back early live to show their worth. The
//! steps that all answers share are final.
//! \[Hop99b\] grows one strip and simulates at each triangle whether to turn back now or somewhat later. Differs:
//! the looks ahead are the answers themselves, swaps and starts are decided in the same way, and an answer is judged by the
//! open vertices it loses and not by the misses so far.
//!
//! Cost: linear, some 15 microseconds a triangle for 32 answers; about 40 bytes a triangle.

use striata::strip::{StripLinks, StripPath, StripSet};

use super::answer::{Answer, Judgment, Prices, Scene, Step, mixed};
use super::covered::{COLUMN_COUNT, Covered};
use super::steps::Steps;
use super::surface::Surface;
use crate::task::Task;

/// Answers that are kept, for an effort of 1.
const WIDTH: f64 = 32.0;
const WIDTHS: std::ops::RangeInclusive<f64> = 4.0..=256.0;
/// Of the best answers so many may begin a new strip at every step; the others where they cannot go on.
const STARTER_COUNT: usize = 4;
/// Starts that are kept of one answer.
const START_COUNT: usize = 3;
/// Steps after which is looked for what all answers share.
const SETTLE_STEPS: u32 = 32;
/// Settled triangles beside which a far start is looked for, the last first.
const TRAIL_LENGTH: usize = 256;
/// The search takes no larger cache into account: a larger one forgives more.
const MAX_CACHE_SIZE: usize = 64;

/// Covers the mesh by strips grown for the cache of the options.
pub(super) fn grow(task: &Task<'_>, links: &StripLinks<'_>) -> StripSet {
    let mut search = Search::new(task, links);
    let mut writer = Writer { path: None, links, triangles: task.triangles, out: StripSet::new() };
    for group in task.groups {
        search.begin(group.start as u32..group.end as u32);
        let step_count = search.scene.group.clone().filter(|&t| task.is_proper(t)).count() as u32;
        for step_index in 0..step_count {
            search.judge();
            search.choose(step_index);
            if step_index % SETTLE_STEPS == SETTLE_STEPS - 1 || search.is_full() {
                search.settle(&mut writer);
            }
        }
        search.live_count = 1;
        search.settle(&mut writer);
        writer.end_strip();
        writer.out.end_group();
    }
    writer.out
}

struct Search<'a> {
    scene: Scene<'a>,
    /// The first `live_count` are the answers, best first; the others are room.
    answers: Vec<Answer>,
    nexts: Vec<Answer>,
    live_count: usize,
    steps: Steps,
    /// Settled triangles in the order of drawing, without those at the end that have no unsettled neighbor.
    trail: Vec<u32>,
    /// All ways on: answer and judgment.
    found: Vec<(usize, Judgment)>,
    /// Of `found`, scores and places, best first.
    ranked: Vec<(f64, u32)>,
    /// Of the ways on that are taken: what tells answers apart, and the first step of the last strip.
    taken: Vec<(u64, u32)>,
}

impl<'a> Search<'a> {
    fn new(task: &Task<'a>, links: &StripLinks<'a>) -> Self {
        let options = task.options;
        let cache_size = options.cache_size.min(MAX_CACHE_SIZE);
        // In this order no effort at all is taken for the least.
        let width = (WIDTH * options.effort).max(*WIDTHS.start()).min(*WIDTHS.end()) as usize;
        let surface = Surface::new(task, links);
        let scene = Scene {
            covered: Covered::new(&surface),
            surface,
            prices: Prices::new(options.cache_weight, cache_size),
            group: 0..0,
        };
        Self {
            scene,
            answers: vec![Answer::new(cache_size); width],
            nexts: vec![Answer::new(cache_size); width],
            live_count: 1,
            steps: Steps::default(),
            trail: Vec::new(),
            found: Vec::new(),
            ranked: Vec::new(),
            taken: Vec::new(),
        }
    }

    fn begin(&mut self, group: std::ops::Range<u32>) {
        self.answers[0].begin_group(group.start);
        self.scene.group = group;
        self.live_count = 1;
        self.steps = Steps::default();
        self.trail.clear();
    }

    /// Whether the next step might run out of columns.
    fn is_full(&self) -> bool {
        self.scene.covered.free_count() < self.answers.len()
    }

    /// Finds all ways on.
    fn judge(&mut self) {
        self.found.clear();
        let mut ways = Vec::new();
        for (i, answer) in self.answers[..self.live_count].iter_mut().enumerate() {
            answer.judge_crossings(&self.scene, &mut ways);
            let crossing_count = ways.len();
            if i < STARTER_COUNT || crossing_count == 0 {
                answer.judge_starts(&self.scene, START_COUNT, &mut ways);
                if ways.len() == crossing_count {
                    let trail = &self.trail[self.trail.len().saturating_sub(TRAIL_LENGTH)..];
                    answer.judge_far_start(&self.scene, trail, &mut ways);
                }
            }
            self.found.extend(ways.drain(..).map(|judgment| (i, judgment)));
        }
        self.ranked.clear();
        self.ranked.extend(self.found.iter().zip(0..).map(|((_, judgment), i)| (judgment.score, i)));
        self.ranked.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    }

    /// Takes the best ways on that differ.
    fn choose(&mut self, step_index: u32) {
        let max_alike = self.answers.len() / 2;
        self.taken.clear();
        for &(_, i) in &self.ranked {
            let (parent, judgment) = &self.found[i as usize];
            let parent = &self.answers[*parent];
            let triangle = judgment.step.triangle(&self.scene.surface);
            let (is_start, strip_start) = match judgment.step {
                Step::Start(_) => (1, step_index),
                Step::Cross(_) => (0, parent.strip_start),
            };
            // What was drawn and where the strip ends decide what is to come; how it came to that does not.
            let identity = mixed(
                (parent.hash ^ mixed(triangle.into())).wrapping_add(2 * u64::from(triangle) + is_start),
            );
            let is_known = self.taken.iter().any(|&(other, _)| other == identity);
            let alike_count = self.taken.iter().filter(|&&(_, start)| start == strip_start).count();
            if is_known || alike_count >= max_alike {
                continue;
            }
            let next = &mut self.nexts[self.taken.len()];
            next.copy_from(parent);
            next.take(&mut self.scene, judgment, step_index);
            next.leaf = self.steps.push(parent.leaf, judgment.step);
            self.taken.push((identity, strip_start));
            if self.taken.len() == self.nexts.len() {
                break;
            }
        }
        self.live_count = self.taken.len();
        std::mem::swap(&mut self.answers, &mut self.nexts);
    }

    /// Hands what all answers share to the writer, and drops answers where too little is shared.
    fn settle(&mut self, writer: &mut Writer<'_>) {
        loop {
            self.settle_triangles();
            if self.scene.covered.free_count() >= COLUMN_COUNT / 2 || self.live_count == 1 {
                break;
            }
            self.live_count = self.live_count.div_ceil(2);
        }
        let live = &mut self.answers[..self.live_count];
        let mut leaves: Vec<_> = live.iter().map(|answer| Some(answer.leaf)).collect();
        let mut trunk = Vec::new();
        self.steps.cut_trunk(&mut leaves, &mut trunk);
        let mut kept_count = 0;
        for (i, leaf) in leaves.into_iter().enumerate() {
            if let Some(leaf) = leaf {
                live.swap(kept_count, i);
                live[kept_count].leaf = leaf;
                kept_count += 1;
            }
        }
        let paid = live[0].account();
        live[..kept_count].iter_mut().for_each(|answer| answer.pay_from(paid));
        self.live_count = kept_count;
        self.settle_triangles();
        for step in trunk {
            writer.take(step);
            self.trail.push(step.triangle(&self.scene.surface));
        }
        while self.trail.pop_if(|&mut t| !has_unsettled_neighbor(&self.scene, t)).is_some() {}
    }

    fn settle_triangles(&mut self) {
        let live = self.answers[..self.live_count].iter_mut();
        let mut drawn: Vec<_> = live.map(|answer| &mut answer.drawn).collect();
        self.scene.covered.settle(&self.scene.surface, &mut drawn);
    }
}

fn has_unsettled_neighbor(scene: &Scene<'_>, triangle: u32) -> bool {
    let beside = (3 * triangle..3 * triangle + 3).filter_map(|side| scene.surface.twin(side));
    beside.into_iter().any(|twin| !scene.covered.is_settled(twin / 3))
}

impl Prices {
    /// Fitted to scans and parts by runs over many values; flat around these.
    fn new(weight: f64, cache_size: usize) -> Self {
        let risk = |age: usize| {
            let share = age as f64 / cache_size as f64;
            RISK * weight * share * share
        };
        Self { loss: weight, risks: (0..cache_size).map(risk).collect(), poverty: POVERTY }
    }
}
const RISK: f64 = 0.7;
const POVERTY: [f64; 4] = [2.1, 1.35, 0.85, 0.0];

/// Makes strips of steps.
struct Writer<'a> {
    path: Option<StripPath>,
    links: &'a StripLinks<'a>,
    triangles: &'a [[u32; 3]],
    out: StripSet,
}

impl Writer<'_> {
    fn take(&mut self, step: Step) {
        match step {
            Step::Start(first) => {
                self.end_strip();
                self.path = Some(StripPath { first, exits: Vec::new() });
            }
            Step::Cross(side) => {
                if let Some(path) = &mut self.path {
                    path.exits.push(side);
                }
            }
        }
    }

    fn end_strip(&mut self) {
        if let Some(path) = self.path.take() {
            let mut indices = Vec::new();
            path.write(self.triangles, self.links, false, &mut indices);
            self.out.push(&indices);
        }
    }
}
