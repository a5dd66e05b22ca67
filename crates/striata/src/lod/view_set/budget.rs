//! One frame of a set: which instances are updated, and with how much tolerance.

use super::instance::{DUE, PlacedInstance, factor_at};
use crate::parallel;
use crate::view::ScreenError;

/// The tolerance falls if fewer triangles than this share of the budget are shown.
const LOW_SHARE: f64 = 0.85;

/// Instances follow a lower tolerance as long as fewer triangles than this share of the budget are shown.
const HIGH_SHARE: f64 = 0.95;

/// Largest relaxation, a factor of 2 to the power of 40, and the first one of a set that has a budget.
const MAX_RELAXATION: i32 = 320;
const FIRST_RELAXATION: i32 = 48;

/// Largest step of the search for a tolerance, a factor of 4.
const MAX_SEARCH_STEP: i32 = 16;

/// Urgency from which on an instance is updated early.
const EARLY: f32 = 0.5;

/// Share of the triangles whose instances a frame updates early.
const EARLY_SHARE: usize = 16;

/// Number of instances that are coarsened together while the budget is exceeded.
const BATCH_SIZE: usize = 32;

/// Share of the visible instances that have just appeared, from which on the tolerance is searched for.
const NEW_SHARE: usize = 4;

/// The instances during a frame.
pub(super) struct BudgetedFrame<'a> {
    instances: Vec<&'a mut PlacedInstance>,
    error: &'a ScreenError,
    budget: usize,
    updated_count: usize,
    is_exceeded: bool,
}

impl<'a> BudgetedFrame<'a> {
    pub(super) fn new(instances: Vec<&'a mut PlacedInstance>, error: &'a ScreenError, budget: usize) -> Self {
        Self { instances, error, budget, updated_count: 0, is_exceeded: false }
    }

    pub(super) fn updated_count(&self) -> usize {
        self.updated_count
    }

    /// Error that the instances in the picture may show.
    pub(super) fn pixels(&self) -> f32 {
        let relaxations = self.instances.iter().filter_map(|instance| instance.relaxation());
        let factor = if self.is_exceeded { f32::INFINITY } else { factor_at(relaxations.fold(0, i32::max)) };
        self.error.pixels() * factor
    }

    /// Updates the instances. Takes the relaxation of the frame before, and returns that of this frame.
    pub(super) fn run(&mut self, mut relaxation: i32) -> i32 {
        let error = self.error;
        parallel::for_each(&mut self.instances, |instance| instance.look_at(error));
        let seen_count = self.instances.iter().filter(|instance| instance.is_seen()).count();
        let new_count = self.instances.iter().filter(|instance| instance.is_new()).count();
        let has_budget = self.budget < usize::MAX;
        let is_jump = has_budget && new_count * NEW_SHARE > seen_count;
        let is_relaxed = self.instances.iter().any(|instance| instance.relaxation() > Some(0));
        let is_for_all = is_jump || (!has_budget && is_relaxed);
        relaxation = match has_budget {
            true if is_jump => relaxation.max(FIRST_RELAXATION),
            true => relaxation,
            false => 0,
        };
        self.refine(|instance| instance.urgency >= DUE || (is_for_all && instance.is_seen()), relaxation);
        if is_jump {
            relaxation = self.search_down(relaxation);
        } else {
            relaxation = self.drift(relaxation);
        }
        self.settle(relaxation)
    }

    fn triangle_count(&self) -> usize {
        self.instances.iter().map(|instance| instance.triangle_count()).sum()
    }

    fn share(&self) -> f64 {
        self.triangle_count() as f64 / self.budget.max(1) as f64
    }

    /// Updates all instances that are chosen.
    fn refine(&mut self, is_chosen: impl Fn(&PlacedInstance) -> bool, relaxation: i32) {
        let chosen: Vec<usize> =
            (0..self.instances.len()).filter(|&at| is_chosen(self.instances[at])).collect();
        self.refine_listed(&chosen, relaxation);
    }

    /// Lowers the relaxation until the budget is nearly used. From the coarse side, because an update that shows far too
    /// many triangles would take long.
    fn search_down(&mut self, mut relaxation: i32) -> i32 {
        while relaxation > 0 && self.share() < LOW_SHARE {
            let steps = steps_within(HIGH_SHARE / self.share().max(1e-9));
            relaxation = (relaxation - steps.clamp(1, MAX_SEARCH_STEP)).max(0);
            self.refine(PlacedInstance::is_seen, relaxation);
        }
        relaxation
    }

    /// Updates a few instances early: those that are almost due, and those that are coarser than the budget requires.
    fn drift(&mut self, mut relaxation: i32) -> i32 {
        let is_coarse =
            |instance: &PlacedInstance, relaxation| instance.relaxation().is_some_and(|own| own > relaxation);
        let share = self.share();
        if relaxation > 0 && share < LOW_SHARE && !self.instances.iter().any(|i| is_coarse(i, relaxation)) {
            relaxation -= 1;
        }
        let may_grow = share < HIGH_SHARE;
        let urgency = |instance: &PlacedInstance| {
            instance.urgency.max(if may_grow && is_coarse(instance, relaxation) { EARLY } else { 0.0 })
        };
        let mut candidates: Vec<usize> =
            (0..self.instances.len()).filter(|&at| urgency(self.instances[at]) >= EARLY).collect();
        candidates.sort_by(|&a, &b| {
            let [a, b] = [a, b].map(|at| &*self.instances[at]);
            urgency(b).total_cmp(&urgency(a)).then(b.size_px.total_cmp(&a.size_px))
        });
        let mut rest = (self.triangle_count() / EARLY_SHARE).max(1);
        let count = candidates.iter().take_while(|&&at| {
            let fits = rest > 0;
            rest = rest.saturating_sub(self.instances[at].triangle_count());
            fits
        });
        let count = count.count();
        self.refine_listed(&candidates[..count], relaxation);
        relaxation
    }

    /// Coarsens instances, smallest on the screen first, until the budget is not exceeded.
    fn settle(&mut self, mut relaxation: i32) -> i32 {
        while self.triangle_count() > self.budget {
            if relaxation >= MAX_RELAXATION {
                self.is_exceeded = true;
                self.instances.iter_mut().for_each(|instance| instance.give_up());
                break;
            }
            // Triangles fall more slowly than the tolerance grows, but a step too many costs more than one too few.
            relaxation = (relaxation + steps_within(self.share()) / 2 + 1).min(MAX_RELAXATION);
            self.coarsen(relaxation);
        }
        relaxation
    }

    /// Coarsens instances to a relaxation, one batch after another, until the budget is not exceeded.
    fn coarsen(&mut self, relaxation: i32) {
        let is_finer = |instance: &PlacedInstance| instance.relaxation().is_some_and(|own| own < relaxation);
        let mut order: Vec<usize> =
            (0..self.instances.len()).filter(|&at| is_finer(self.instances[at])).collect();
        order.sort_by(|&a, &b| {
            let [a, b] = [a, b].map(|at| &*self.instances[at]);
            a.relaxation().cmp(&b.relaxation()).then(a.size_px.total_cmp(&b.size_px))
        });
        for batch in order.chunks(BATCH_SIZE) {
            self.refine_listed(batch, relaxation);
            if self.triangle_count() <= self.budget {
                break;
            }
        }
    }

    /// Updates the instances of a list.
    fn refine_listed(&mut self, list: &[usize], relaxation: i32) {
        let mut is_listed = vec![false; self.instances.len()];
        list.iter().for_each(|&at| is_listed[at] = true);
        let chosen = self.instances.iter_mut().zip(is_listed).filter(|(_, is_listed)| *is_listed);
        let mut chosen: Vec<&mut PlacedInstance> = chosen.map(|(instance, _)| &mut **instance).collect();
        self.updated_count += chosen.len();
        parallel::for_each(&mut chosen, |instance| instance.refine(relaxation));
    }
}

/// Returns the largest number of steps of the relaxation whose factor is less than a ratio.
fn steps_within(ratio: f64) -> i32 {
    // Not a logarithm, whose rounding depends on the machine.
    (1..MAX_RELAXATION).take_while(|&steps| f64::from(factor_at(steps)) < ratio).count() as i32
}
