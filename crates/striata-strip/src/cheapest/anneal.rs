//! Simulated annealing of strips: one link at a time, costs known at once.
//!
//! A move takes a link. A solid one is cut; a dashed one is joined, and a triangle that then has three solid
//! links lets one of the older two go. Moves that cost nothing or save are kept, others with a chance that falls
//! as the search cools. Whether a loop closes is asked last, as it alone is not local.
//! Sweeps pass all triangles in turn; where a strip ends, moves are cheap and more of them are tried.
//! Some 50 to 100 ns a move while the mesh fits into cache.

use striata::mesh::{NO_TWIN, Random};

use super::state::{INDEX, State};
use crate::task::SpentFn;

/// Triangles that a sweep passes between questions about the budget.
const BATCH: u64 = 4096;
/// Further moves at a triangle where a strip ends. On the bunny in equal time, indices a triangle are 1.132 without
/// them, 1.124 with three, 1.123 with eight, 1.126 with twenty.
const MOVES_AT_END: u64 = 5;
/// Temperatures of a search's beginning and end, in indices. Flat around the best: 0.6 to 1.0 and 0.1 to 0.2 differ by
/// no more than 0.003 indices a triangle on the bunny.
pub(super) const HOT_TO_COLD: [f64; 2] = [0.7, 0.2];
/// The same for strips that are good already.
pub(super) const COLD: [f64; 2] = [0.2, 0.15];
/// What two new ends can gain at most by meeting others.
const MAX_GAIN: i32 = 2 * INDEX;
/// Costs from here on are never paid.
const MAX_COST: usize = 64;

/// A search under way.
pub(super) struct Annealer<'s> {
    state: &'s mut State,
    random: Random,
    /// Chance of paying a cost, of `u32::MAX`.
    chances: [u32; MAX_COST],
    move_count: u64,
}

impl<'s> Annealer<'s> {
    /// A search that changes these strips.
    pub(super) fn new(state: &'s mut State, seed: u64) -> Self {
        Self { state, random: Random::new(seed), chances: [0; MAX_COST], move_count: 0 }
    }

    /// Improves strips until the budget is spent: by how much the cost has changed.
    pub(super) fn anneal(&mut self, temperatures: [f64; 2], spent: &mut SpentFn<'_>) -> i64 {
        let [first, last] = temperatures;
        let count = self.state.triangle_count();
        let (mut triangle, mut change) = (0, 0);
        if !self.state.can_move() {
            return 0;
        }
        loop {
            let share = spent(self.move_count);
            if share >= 1.0 {
                return change;
            }
            self.set_temperature(first + (last - first) * share);
            for _ in 0..BATCH {
                change += i64::from(self.visit(triangle));
                triangle = if triangle + 1 == count { 0 } else { triangle + 1 };
            }
        }
    }

    /// Temperature in indices.
    fn set_temperature(&mut self, temperature: f64) {
        let factor = exp_minus(1.0 / (temperature * f64::from(INDEX)));
        let mut chance = 1.0;
        for slot in &mut self.chances {
            *slot = (chance * f64::from(u32::MAX)) as u32;
            chance *= factor;
        }
    }

    /// The highest cost that is paid for this fate.
    #[inline]
    fn allowance(&self, fate: u32) -> i32 {
        self.chances.iter().skip(1).take_while(|&&chance| fate < chance).count() as i32
    }

    /// Tries moves at a triangle: the change of cost.
    fn visit(&mut self, triangle: u32) -> i32 {
        let mut change = self.try_move(triangle);
        self.move_count += 1;
        if self.state.solid(triangle << 2).count_ones() < 2 {
            for _ in 0..MOVES_AT_END {
                change += self.try_move(triangle);
            }
            self.move_count += MOVES_AT_END;
        }
        change
    }

    /// Takes one of a triangle's links and turns it over if that is cheap enough.
    fn try_move(&mut self, triangle: u32) -> i32 {
        let bits = self.random.next_u64();
        let k = ((bits & 0xFFFF) as u32 * 3) >> 16;
        let side = (triangle << 2) | k;
        let twin = self.state.twin(side);
        if twin == NO_TWIN {
            return 0;
        }
        let allowance = self.allowance((bits >> 32) as u32);
        if self.state.is_solid(side) {
            return self.try_cut(side, allowance);
        }
        // The older links of both triangles, one of which goes where there are two.
        let older = |side: u32, bit: u64| match self.state.solid(side).count_ones() {
            2 if bits & bit != 0 => State::next(side),
            2 => State::prev(side),
            _ => NO_TWIN,
        };
        self.try_join(side, [older(side, 1 << 16), older(twin, 1 << 17)], allowance)
    }

    fn try_cut(&mut self, side: u32, allowance: i32) -> i32 {
        if 3 * INDEX - INDEX * self.state.swaps_at(side) - MAX_GAIN > allowance {
            return 0;
        }
        let cost = self.state.cut(side);
        if cost <= allowance {
            return cost;
        }
        self.state.join(side);
        0
    }

    fn try_join(&mut self, side: u32, cuts: [u32; 2], allowance: i32) -> i32 {
        if cuts.iter().all(|&cut| cut != NO_TWIN) {
            // What the move costs at least can often be told without making it. (Two triangles with two links
            // between them have but one to let go.)
            let swaps = self.state.swaps_at(cuts[0]) + self.state.swaps_at(cuts[1]);
            if 3 * INDEX - INDEX * swaps - MAX_GAIN > allowance || self.state.twin(cuts[0]) == cuts[1] {
                return 0;
            }
        }
        let cuts = || cuts.into_iter().filter(|&cut| cut != NO_TWIN);
        let cut_cost: i32 = cuts().map(|cut| self.state.cut(cut)).sum();
        let cost = cut_cost + self.state.join(side);
        self.state.cut(side);
        if cost <= allowance && !self.state.closes_loop(side) {
            self.state.join(side);
            return cost;
        }
        for cut in cuts() {
            self.state.join(cut);
        }
        0
    }
}

/// `exp(-x)` for `x >= 0` by the same few operations on every machine.
fn exp_minus(x: f64) -> f64 {
    let x = x / 1024.0;
    let mut power = 1.0 / (1.0 + x * (1.0 + x * (0.5 + x / 6.0)));
    for _ in 0..10 {
        power *= power;
    }
    power
}
