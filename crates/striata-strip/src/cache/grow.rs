//! Grows strips for a vertex cache, triangle by triangle, with a beam search.
//!
//! Each state of the search can continue straight, with a swap, or with a new strip next to the cached
//! vertices. The best resulting states are kept as long as they differ: states that have drawn the same
//! triangles and end alike count as one, and at most half may begin their last strip with the same step, so
//! that rows that turn back early survive until they pay off. Steps that all states share are final.
//!
//! \[Hop99b\] grows one strip and simulates at each triangle whether to turn back now or somewhat later.
//! Differs: the states of the beam replace the simulation, swaps and starts are decided in the same way,
//! and a state is scored by the open vertices it loses, not by its misses so far.
//!
//! Cost: linear, some 15 microseconds per triangle for 32 states; about 40 bytes per triangle.

use striata::strip::{StripLinks, StripPath, StripSet};
use striata::{Cancelled, Progress, ProgressFn};

use super::adjacency::TriangleAdjacency;
use super::beam_state::{BeamState, DrawStep, Prices, ScoredMove, SearchContext, mixed};
use super::drawn_sets::{COLUMN_COUNT, DrawnSets};
use super::step_tree::StepTree;
use crate::task::StripTask;

/// Beam width (number of states) at effort 1.
const WIDTH: f64 = 32.0;
/// Range of the beam width.
const WIDTHS: std::ops::RangeInclusive<f64> = 4.0..=256.0;
/// Number of best states that may begin a new strip at every step; the others only if they cannot continue.
const STARTER_COUNT: usize = 4;
/// Number of starts that are kept per state.
const START_COUNT: usize = 3;
/// Number of steps between searches for what all states share.
const FINALIZE_INTERVAL: u32 = 32;
/// Number of steps between two calls of the progress callback: some milliseconds.
const STEPS_PER_REPORT: u32 = 1 << 10;
/// Number of final triangles near which a distant start is searched, the last first.
const TRAIL_LENGTH: usize = 256;
/// Largest cache that the search simulates; strips for it also suit larger caches.
const MAX_CACHE_SIZE: usize = 64;

/// Covers the mesh by strips grown for the cache in the options.
///
/// # Errors
/// [`Cancelled`] if the callback cancels.
pub(super) fn grow(
    task: &StripTask<'_>,
    links: &StripLinks<'_>,
    progress: &mut ProgressFn<'_>,
) -> Result<StripSet, Cancelled> {
    let mut search = BeamSearch::new(task, links);
    let mut writer = StepWriter { path: None, links, triangles: task.triangles, out: StripSet::new() };
    for group in task.groups {
        search.begin(group.start as u32..group.end as u32);
        let step_count = search.context.group.clone().filter(|&t| task.is_proper(t)).count() as u32;
        for step_index in 0..step_count {
            if step_index % STEPS_PER_REPORT == 0 {
                let done = group.start as u64 + u64::from(step_index);
                Progress { phase: "strip", done, total: task.triangles.len() as u64 }.report(progress)?;
            }
            search.rank_moves();
            search.advance(step_index);
            if step_index % FINALIZE_INTERVAL == FINALIZE_INTERVAL - 1 || search.is_full() {
                search.finalize(&mut writer);
            }
        }
        search.live_count = 1;
        search.finalize(&mut writer);
        writer.end_strip();
        writer.out.end_group();
    }
    Ok(writer.out)
}

/// Beam search over one mesh.
struct BeamSearch<'a> {
    context: SearchContext<'a>,
    /// The first `live_count` are the states, best first; the others are unused.
    states: Vec<BeamState>,
    nexts: Vec<BeamState>,
    live_count: usize,
    steps: StepTree,
    /// Final triangles in drawing order, except trailing ones without a neighbor that is not final.
    trail: Vec<u32>,
    /// All possible moves: index of the state, and the scored move.
    found: Vec<(usize, ScoredMove)>,
    /// Scores and indices of the entries of `found`, best first.
    ranked: Vec<(f64, u32)>,
    /// Accepted moves: identity of the resulting state, and first step of its last strip.
    accepted: Vec<(u64, u32)>,
}

impl<'a> BeamSearch<'a> {
    fn new(task: &StripTask<'a>, links: &StripLinks<'a>) -> Self {
        let options = task.options;
        let cache_size = options.cache_size.min(MAX_CACHE_SIZE);
        // This order of operations maps an effort that is not a number to the smallest width.
        let width = (WIDTH * options.effort).max(*WIDTHS.start()).min(*WIDTHS.end()) as usize;
        let adjacency = TriangleAdjacency::new(task, links);
        let context = SearchContext {
            drawn_sets: DrawnSets::new(&adjacency),
            adjacency,
            prices: Prices::new(options.cache_weight, cache_size),
            group: 0..0,
        };
        Self {
            context,
            states: vec![BeamState::new(cache_size); width],
            nexts: vec![BeamState::new(cache_size); width],
            live_count: 1,
            steps: StepTree::default(),
            trail: Vec::new(),
            found: Vec::new(),
            ranked: Vec::new(),
            accepted: Vec::new(),
        }
    }

    /// Starts a new group with the best state of the previous one.
    fn begin(&mut self, group: std::ops::Range<u32>) {
        self.states[0].begin_group(group.start);
        self.context.group = group;
        self.live_count = 1;
        self.steps = StepTree::default();
        self.trail.clear();
    }

    /// Whether the next step might run out of columns.
    fn is_full(&self) -> bool {
        self.context.drawn_sets.free_count() < self.states.len()
    }

    /// Finds all possible moves and ranks them.
    fn rank_moves(&mut self) {
        self.found.clear();
        let mut moves = Vec::new();
        for (i, state) in self.states[..self.live_count].iter_mut().enumerate() {
            state.score_crossings(&self.context, &mut moves);
            let crossing_count = moves.len();
            if i < STARTER_COUNT || crossing_count == 0 {
                state.score_starts(&self.context, START_COUNT, &mut moves);
                if moves.len() == crossing_count {
                    let trail = &self.trail[self.trail.len().saturating_sub(TRAIL_LENGTH)..];
                    state.score_far_start(&self.context, trail, &mut moves);
                }
            }
            self.found.extend(moves.drain(..).map(|scored| (i, scored)));
        }
        self.ranked.clear();
        self.ranked.extend(self.found.iter().zip(0..).map(|((_, scored), i)| (scored.score, i)));
        self.ranked.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    }

    /// Applies the best moves that lead to different states.
    fn advance(&mut self, step_index: u32) {
        let max_same_start = self.states.len() / 2;
        self.accepted.clear();
        for &(_, i) in &self.ranked {
            let (parent, scored) = &self.found[i as usize];
            let parent = &self.states[*parent];
            let triangle = scored.step.triangle(&self.context.adjacency);
            let (is_start, strip_start) = match scored.step {
                DrawStep::Start(_) => (1, step_index),
                DrawStep::Cross(_) => (0, parent.strip_start),
            };
            // Future costs depend on what is drawn and where the strip ends, not on how the state got there.
            let identity = mixed(
                (parent.hash ^ mixed(triangle.into())).wrapping_add(2 * u64::from(triangle) + is_start),
            );
            let is_duplicate = self.accepted.iter().any(|&(other, _)| other == identity);
            let same_start_count = self.accepted.iter().filter(|&&(_, start)| start == strip_start).count();
            if is_duplicate || same_start_count >= max_same_start {
                continue;
            }
            let next = &mut self.nexts[self.accepted.len()];
            next.copy_from(parent);
            next.apply(&mut self.context, scored, step_index);
            next.leaf = self.steps.push(parent.leaf, scored.step);
            self.accepted.push((identity, strip_start));
            if self.accepted.len() == self.nexts.len() {
                break;
            }
        }
        self.live_count = self.accepted.len();
        std::mem::swap(&mut self.states, &mut self.nexts);
    }

    /// Passes the steps that all states share to the writer, and drops states if too little is shared.
    fn finalize(&mut self, writer: &mut StepWriter<'_>) {
        loop {
            self.finalize_triangles();
            if self.context.drawn_sets.free_count() >= COLUMN_COUNT / 2 || self.live_count == 1 {
                break;
            }
            self.live_count = self.live_count.div_ceil(2);
        }
        let live = &mut self.states[..self.live_count];
        let mut leaves: Vec<_> = live.iter().map(|state| Some(state.leaf)).collect();
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
        let (cost, isolation) = live[0].account();
        live[..kept_count].iter_mut().for_each(|state| state.subtract_account(cost, isolation));
        self.live_count = kept_count;
        self.finalize_triangles();
        for step in trunk {
            writer.apply(step);
            self.trail.push(step.triangle(&self.context.adjacency));
        }
        while self.trail.pop_if(|&mut t| !has_pending_neighbor(&self.context, t)).is_some() {}
    }

    /// Makes the triangles final that all live states have drawn.
    fn finalize_triangles(&mut self) {
        let live = self.states[..self.live_count].iter_mut();
        let mut drawn: Vec<_> = live.map(|state| &mut state.drawn).collect();
        self.context.drawn_sets.finalize(&self.context.adjacency, &mut drawn);
    }
}

/// Whether a triangle has a neighbor that is not final.
fn has_pending_neighbor(context: &SearchContext<'_>, triangle: u32) -> bool {
    let neighbors = (3 * triangle..3 * triangle + 3).filter_map(|side| context.adjacency.twin(side));
    neighbors.into_iter().any(|twin| !context.drawn_sets.is_final(twin / 3))
}

impl Prices {
    /// Prices fitted to scans and CAD parts over many runs; results change little around these values.
    fn new(weight: f64, cache_size: usize) -> Self {
        let risk = |age: usize| {
            let share = age as f64 / cache_size as f64;
            LOSS_RISK * weight * share * share
        };
        Self { loss: weight, loss_risks: (0..cache_size).map(risk).collect(), isolation: ISOLATION }
    }
}
/// Risk that the oldest open vertex is lost, as a share of the price of a loss.
const LOSS_RISK: f64 = 0.7;
/// Price of an undrawn triangle with zero to three undrawn neighbors, in indices.
const ISOLATION: [f64; 4] = [2.1, 1.35, 0.85, 0.0];

/// Turns steps into strips.
struct StepWriter<'a> {
    path: Option<StripPath>,
    links: &'a StripLinks<'a>,
    triangles: &'a [[u32; 3]],
    out: StripSet,
}

impl StepWriter<'_> {
    fn apply(&mut self, step: DrawStep) {
        match step {
            DrawStep::Start(first) => {
                self.end_strip();
                self.path = Some(StripPath { first, exits: Vec::new() });
            }
            DrawStep::Cross(side) => {
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
