//! One state of the beam search: which triangles are drawn, what the cache contains, and what the next
//! triangle costs.
//!
//! Every vertex must be loaded once; only repeated loads can be saved. A miss is therefore charged when a
//! vertex is **lost**, that is pushed out of the cache while triangles around it are still undrawn. States
//! are compared when they have drawn equally many triangles, by what they have paid and what they will
//! probably pay:
//!
//! * The longer an **open** vertex (one with undrawn triangles) has been in the cache, the more likely it is
//!   to be lost.
//! * The fewer undrawn neighbors an undrawn triangle has, the more likely it is to end a strip. This price
//!   (`isolation`) grows with every link between drawn and undrawn triangles, so states with short borders
//!   win, which keeps the rows of strips compact.

use striata::mesh::Random;
use striata::strip::{next_side, prev_side};

use super::adjacency::TriangleAdjacency;
use super::beam_cache::BeamCache;
use super::drawn_sets::{DrawnBits, DrawnSets};

/// Leaf of a state that has taken no step yet.
pub(super) const ROOT: u32 = u32::MAX;

/// Prices that the search adds up, in indices.
pub(super) struct Prices {
    /// Price of a lost vertex.
    pub loss: f64,
    /// Price of an open vertex in the cache, by its age in misses.
    pub loss_risks: Vec<f64>,
    /// Price of an undrawn triangle, by its number of undrawn neighbors.
    pub isolation: [f64; 4],
}

/// Indices of a new strip beyond one per triangle: two, and the restart.
const START_PRICE: f64 = 3.0;
/// Number of cached vertices around which strips may start, the oldest first.
const START_VERTEX_COUNT: usize = 4;
/// Undrawn triangles that are tried around one of these vertices; the hub of a large fan has any number.
const START_TRY_COUNT: usize = 12;
/// Triangles that are examined to find them.
const START_LOOK_COUNT: usize = 64;

/// Data that all states share.
pub(super) struct SearchContext<'a> {
    pub adjacency: TriangleAdjacency<'a>,
    pub drawn_sets: DrawnSets,
    pub prices: Prices,
    /// Triangles that may be drawn now: those of the current group.
    pub group: std::ops::Range<u32>,
}

/// Drawing of one more triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DrawStep {
    /// A new strip begins with this triangle.
    Start(u32),
    /// The strip continues across this side.
    Cross(u32),
}

impl DrawStep {
    /// Returns the triangle that the step draws.
    #[inline]
    pub(super) fn triangle(self, adjacency: &TriangleAdjacency<'_>) -> u32 {
        match self {
            Self::Start(triangle) => triangle,
            Self::Cross(side) => adjacency.twin(side).expect("strips cross links") / 3,
        }
    }
}

/// A step and the vertices it sends to the GPU.
#[derive(Clone, Copy, Debug)]
struct DrawMove {
    step: DrawStep,
    /// Vertices that the step sends, and how many of the three are used.
    sent: ([u32; 3], usize),
    /// Number of indices beyond one.
    index_price: f64,
}

impl DrawMove {
    fn sent(&self) -> &[u32] {
        &self.sent.0[..self.sent.1]
    }
}

/// A possible next move, and the prices of the state after it.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScoredMove {
    pub step: DrawStep,
    candidate: DrawMove,
    cost: f64,
    isolation: f64,
    /// Sum of what is paid and what will probably be paid; less is better.
    pub score: f64,
}

/// End of the strip that a state is extending.
#[derive(Clone, Copy, Debug)]
enum StripHead {
    Nothing,
    /// A strip of one triangle: it may continue across any side.
    Single(u32),
    /// The side by which the last triangle was entered, and whether leaving by the next side needs no swap.
    Entered(u32, bool),
}

/// One state of the beam search: a partial covering of the mesh by strips.
#[derive(Clone)]
pub(super) struct BeamState {
    pub drawn: DrawnBits,
    /// Hash of the set of drawn triangles.
    pub hash: u64,
    /// Index of the step with which the last strip began.
    pub strip_start: u32,
    /// Last step, as a node of the step tree.
    pub leaf: u32,
    cached: BeamCache,
    head: StripHead,
    cost: f64,
    isolation: f64,
    pub score: f64,
    /// No triangle of the group before this one is undrawn.
    first_undrawn: u32,
}

impl BeamState {
    pub(super) fn new(cache_size: usize) -> Self {
        Self {
            drawn: DrawnBits::default(),
            hash: 0,
            strip_start: 0,
            leaf: ROOT,
            cached: BeamCache::new(cache_size),
            head: StripHead::Nothing,
            cost: 0.0,
            isolation: 0.0,
            score: 0.0,
            first_undrawn: 0,
        }
    }

    /// Ends the strip and continues with the triangles from `first` on; the cache is kept.
    pub(super) fn begin_group(&mut self, first: u32) {
        let cached = std::mem::replace(&mut self.cached, BeamCache::new(0));
        *self = Self { cached, first_undrawn: first, ..Self::new(0) };
    }

    /// Copies another state without allocating.
    pub(super) fn copy_from(&mut self, other: &Self) {
        self.cached.copy_from(&other.cached);
        (self.drawn, self.hash, self.head) = (other.drawn, other.hash, other.head);
        (self.strip_start, self.leaf) = (other.strip_start, other.leaf);
        (self.cost, self.isolation, self.score) = (other.cost, other.isolation, other.score);
        self.first_undrawn = other.first_undrawn;
    }

    /// Subtracts the costs of another state, so that the numbers stay small.
    pub(super) fn subtract_account(&mut self, cost: f64, isolation: f64) {
        self.cost -= cost;
        self.isolation -= isolation;
        self.score -= cost + isolation;
    }

    /// Returns the cost paid so far and the isolation price of the remaining triangles.
    pub(super) fn account(&self) -> (f64, f64) {
        (self.cost, self.isolation)
    }

    /// Returns the triangle beyond a side if it is undrawn.
    #[inline]
    fn undrawn_beyond(&self, context: &SearchContext<'_>, side: u32) -> Option<u32> {
        let triangle = context.adjacency.twin(side)? / 3;
        (!context.drawn_sets.is_drawn(&self.drawn, triangle)).then_some(triangle)
    }

    /// Iterates over the undrawn neighbors of a triangle.
    #[inline]
    fn undrawn_neighbors(&self, context: &SearchContext<'_>, triangle: u32) -> impl Iterator<Item = u32> {
        (3 * triangle..3 * triangle + 3).filter_map(|side| self.undrawn_beyond(context, side))
    }

    /// Appends the moves that continue the last strip.
    pub(super) fn score_crossings(&self, context: &SearchContext<'_>, out: &mut Vec<ScoredMove>) {
        let forecast = self.forecast(context);
        let mut add = |side: u32, is_swap: bool| {
            if self.undrawn_beyond(context, side).is_some() {
                out.push(self.score_move(context, &forecast, self.crossing(context, side, is_swap)));
            }
        };
        match self.head {
            StripHead::Nothing => {}
            StripHead::Single(triangle) => (3 * triangle..3 * triangle + 3).for_each(|side| add(side, false)),
            StripHead::Entered(side, turns_next) => {
                add(next_side(side), !turns_next);
                add(prev_side(side), turns_next);
            }
        }
    }

    /// Appends the `count` best starts of a new strip, at triangles around cached vertices.
    pub(super) fn score_starts(&self, context: &SearchContext<'_>, count: usize, out: &mut Vec<ScoredMove>) {
        let first = out.len();
        let forecast = self.forecast(context);
        for (v, _) in self.cached.open_vertices().take(START_VERTEX_COUNT) {
            let around =
                context.drawn_sets.pending_around(&context.adjacency, v).iter().take(START_LOOK_COUNT);
            let is_open =
                |t: &u32| context.group.contains(t) && !context.drawn_sets.is_drawn(&self.drawn, *t);
            for t in around.copied().filter(is_open).take(START_TRY_COUNT) {
                if out[first..].iter().all(|other| other.step != DrawStep::Start(t)) {
                    out.push(self.score_start(context, &forecast, t));
                }
            }
        }
        out[first..].sort_by(|a, b| a.score.total_cmp(&b.score));
        out.truncate(first + count);
    }

    /// Appends a start away from the cache: next to the triangles drawn last, or at the first undrawn
    /// triangle.
    pub(super) fn score_far_start(
        &mut self,
        context: &SearchContext<'_>,
        trail: &[u32],
        out: &mut Vec<ScoredMove>,
    ) {
        let near = trail.iter().rev().find_map(|&t| self.undrawn_neighbors(context, t).next());
        let found = near.or_else(|| {
            let open = (self.first_undrawn..context.group.end)
                .find(|&t| context.adjacency.is_proper(t) && !context.drawn_sets.is_drawn(&self.drawn, t));
            self.first_undrawn = open.unwrap_or(context.group.end);
            open
        });
        if let Some(t) = found {
            out.push(self.score_start(context, &self.forecast(context), t));
        }
    }

    /// Scores the start of a new strip at a triangle.
    fn score_start(
        &self,
        context: &SearchContext<'_>,
        forecast: &CacheForecast,
        triangle: u32,
    ) -> ScoredMove {
        let sent = (context.adjacency.triangles[triangle as usize], 3);
        self.score_move(
            context,
            forecast,
            DrawMove { step: DrawStep::Start(triangle), sent, index_price: START_PRICE },
        )
    }

    /// Returns the move across a side; it sends the new corner, preceded by the repeated vertex if it is a
    /// swap.
    fn crossing(&self, context: &SearchContext<'_>, side: u32, is_swap: bool) -> DrawMove {
        let adjacency = &context.adjacency;
        let apex = adjacency.twin(side).map_or(0, |entered| adjacency.apex(entered));
        let mut candidate = DrawMove { step: DrawStep::Cross(side), sent: ([apex; 3], 1), index_price: 0.0 };
        if let (StripHead::Entered(entered, _), true) = (self.head, is_swap) {
            // The swap repeats the older end of the side: not the corner that came with this triangle.
            let is_newer = adjacency.corner(side) == adjacency.apex(entered);
            let older = adjacency.corner(if is_newer { next_side(side) } else { side });
            (candidate.sent, candidate.index_price) = (([older, apex, apex], 2), 1.0);
        }
        candidate
    }

    /// Sums up the prices of the cached vertices after zero to three misses.
    fn forecast(&self, context: &SearchContext<'_>) -> CacheForecast {
        let mut forecast = CacheForecast::default();
        for (_, age) in self.cached.open_vertices() {
            for (misses, (paid, likely)) in forecast.0.iter_mut().enumerate() {
                match context.prices.loss_risks.get(age + misses) {
                    Some(risk) => *likely += risk,
                    None => *paid += context.prices.loss,
                }
            }
        }
        forecast
    }

    /// Computes the prices of the state after a move.
    fn score_move(
        &self,
        context: &SearchContext<'_>,
        forecast: &CacheForecast,
        candidate: DrawMove,
    ) -> ScoredMove {
        let step = candidate.step;
        let triangle = step.triangle(&context.adjacency);
        let isolation = self.isolation + self.isolation_change(context, triangle);
        let slots = context.adjacency.triangles[triangle as usize].map(|v| (v, self.cached.slot(v)));
        // All vertices sent are corners of the triangle, including the one that a swap repeats.
        let is_cached = |v: u32| slots.iter().any(|&(corner, slot)| corner == v && slot.is_some());
        let misses = candidate.sent().iter().filter(|&&v| !is_cached(v)).count();
        let (mut paid, mut likely) = forecast.0[misses];
        // A vertex that this triangle closes can neither be lost nor be at risk.
        for slot in slots.iter().filter_map(|&(_, slot)| slot).filter(|&slot| self.cached.open(slot) == 1) {
            match context.prices.loss_risks.get(self.cached.age(slot) + misses) {
                Some(risk) => likely -= risk,
                None => paid -= context.prices.loss,
            }
        }
        let cost = self.cost + candidate.index_price + paid;
        ScoredMove { step, candidate, cost, isolation, score: cost + isolation + likely }
    }

    /// Returns by how much drawing a triangle changes the isolation price.
    fn isolation_change(&self, context: &SearchContext<'_>, triangle: u32) -> f64 {
        let price = |count: usize| context.prices.isolation[count];
        let mut change = 0.0;
        let mut count = 0;
        for neighbor in self.undrawn_neighbors(context, triangle) {
            count += 1;
            let others = self.undrawn_neighbors(context, neighbor).count();
            change += price(others - 1) - price(others);
        }
        change - price(count)
    }

    /// Applies a move that was scored for this state.
    pub(super) fn apply(&mut self, context: &mut SearchContext<'_>, scored: &ScoredMove, step_index: u32) {
        let triangle = scored.step.triangle(&context.adjacency);
        self.head = match (scored.step, self.head) {
            (DrawStep::Start(_), _) => {
                self.strip_start = step_index;
                StripHead::Single(triangle)
            }
            // Turns alternate if nothing is swapped.
            (DrawStep::Cross(side), StripHead::Entered(before, _)) => {
                StripHead::Entered(context.adjacency.twin(side).unwrap_or(side), side != next_side(before))
            }
            // The first turn of a strip to the previous side is free.
            (DrawStep::Cross(side), _) => {
                StripHead::Entered(context.adjacency.twin(side).unwrap_or(side), false)
            }
        };
        (self.cost, self.isolation, self.score) = (scored.cost, scored.isolation, scored.score);
        self.hash ^= mixed(triangle.into());
        context.drawn_sets.draw(&mut self.drawn, triangle);
        self.cached.draw(context.adjacency.triangles[triangle as usize]);
        for &v in scored.candidate.sent() {
            if self.cached.slot(v).is_none() {
                self.cached.push(v, context.drawn_sets.open_count(&context.adjacency, &self.drawn, v));
            }
        }
    }
}

/// Paid losses and probable losses of the cached vertices after zero to three misses.
#[derive(Default)]
struct CacheForecast([(f64, f64); 4]);

/// Mixes the bits of a number (splitmix64).
pub(super) fn mixed(number: u64) -> u64 {
    Random::new(number).next_u64()
}
