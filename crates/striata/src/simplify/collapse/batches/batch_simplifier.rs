//! The loop over batches: evaluates changed positions, then collapses cheap ones that are far enough apart.
//!
//! Every removable position is evaluated in full, and its cheapest target stored. A batch changes the
//! stars in its rings only, which are evaluated again before the next batch. Elsewhere only the link of
//! a target may have changed, so whether a collapse is still allowed is tested again when its turn
//! comes. If the target has been used in this batch already, or is no longer allowed, the position gets
//! its next best target, provided that this is still cheap enough.
//!
//! A position that no surface batch can remove, because it is not manifold or each of its collapses
//! would change the topology, waits for a general batch (`general.rs`).

use crate::mesh::Welded;
use crate::simplify::collapse::collapse_choice::{CollapseChoice, CollapseKind};
use crate::simplify::collapse::cost_evaluator::CostEvaluator;
use crate::simplify::collapse::executor::CollapseExecutor;
use crate::simplify::collapse::refinement_order::CollapseRecord;
use crate::simplify::collapse::relaxation_schedule::RelaxationSchedule;
use crate::simplify::options::{SimplifyError, StopReason, TopologyRule};
use crate::{Progress, ProgressFn};

use super::batch_bias::BatchBias;
use super::batch_options::BatchOptions;
use super::closed_surface;
use super::copies::marked_copies;
use super::select::{Selection, keep_cheapest};

/// All batches of a mesh.
pub(super) struct BatchOutcome {
    /// The collapses, finest first.
    pub record: CollapseRecord,
    /// Number of collapses applied at the end of each batch.
    pub ends: Vec<u32>,
    pub stop_reason: StopReason,
}

/// Complete state of one simplification in batches.
pub(super) struct BatchSimplifier<'a> {
    pub options: &'a BatchOptions,
    pub evaluator: CostEvaluator<'a>,
    pub executor: CollapseExecutor,
    bias: BatchBias,
    pub schedule: RelaxationSchedule<'a>,
    /// The best target of each position, if there is one; entries of changed positions are out of date.
    pub choices: Vec<Option<CollapseChoice>>,
    /// Positions whose choice only a general batch can apply.
    pub is_general: Vec<bool>,
    /// Positions that a surface batch may remove: manifold after the last general batch, and not locked.
    pub is_removable: Vec<bool>,
    /// Positions whose stars have changed, each once.
    changed: Vec<u32>,
    is_changed: Vec<bool>,
    candidates: Vec<(f32, u32)>,
    /// Choices that wait for a general batch and cost no more than the last batch's candidates.
    pub deferred: Vec<(f32, u32)>,
    /// Largest cost of the last batch's candidates.
    pub max_cost: f32,
    /// Number of positions left after the last general batch.
    pub left_after_general: usize,
    selection: Selection,
    /// Whether each position is a copy of the previous one, in the same place.
    is_copy: Vec<bool>,
    /// Whether the last batch found choices that are no longer allowed.
    was_out_of_date: bool,
    ends: Vec<u32>,
    pub error: f32,
}

impl<'a> BatchSimplifier<'a> {
    pub(super) fn new(welded: &'a Welded, options: &'a BatchOptions) -> Self {
        let evaluator = CostEvaluator::new(welded, &options.sequence);
        let position_count = evaluator.positions.len();
        let rule = if options.general { options.sequence.topology } else { TopologyRule::Keep };
        let mut simplifier = Self {
            options,
            executor: CollapseExecutor::new(welded, &evaluator),
            bias: BatchBias::new(options, evaluator.scale),
            schedule: RelaxationSchedule::new(welded, rule),
            choices: vec![None; position_count],
            is_general: vec![false; position_count],
            is_removable: vec![false; position_count],
            changed: (0..position_count as u32).collect(),
            is_changed: vec![true; position_count],
            candidates: Vec::new(),
            deferred: Vec::new(),
            max_cost: 0.0,
            left_after_general: position_count,
            selection: Selection::new(position_count),
            is_copy: marked_copies(welded),
            was_out_of_date: false,
            ends: Vec::new(),
            error: 0.0,
            evaluator,
        };
        simplifier.find_removable();
        simplifier.prepare_general();
        simplifier
    }

    /// Runs batch after batch until nothing can be removed, the base size is reached, batches get too
    /// small, or the error limit would be exceeded.
    pub(super) fn run(mut self, progress: &mut ProgressFn<'_>) -> Result<BatchOutcome, SimplifyError> {
        let total = self.choices.len() as u64;
        let stop_reason = loop {
            if self.is_base_reached() {
                break StopReason::TargetReached;
            }
            let all = self.choices.len();
            self.bias.fade(all - self.executor.record.removed.len(), all);
            self.update_changed();
            let before = self.executor.record.removed.len();
            let mut stopped = self.surface_batch();
            let removed_count = self.end_batch(before);
            if stopped.is_none() && self.is_general_due(removed_count) {
                let before = self.executor.record.removed.len();
                stopped = self.general_batch();
                if self.end_batch(before) > 0 {
                    self.find_removable();
                }
            }
            if let Some(stop_reason) = stopped {
                break stop_reason;
            }
            let done = self.executor.record.removed.len();
            // Positions that were out of date are evaluated again before a small batch ends the loop.
            if done - before < self.options.min_batch_size.max(1)
                && !self.was_out_of_date
                && !self.begin_postponed()
            {
                break StopReason::BaseReached;
            }
            Progress { phase: "simplify", done: done as u64, total }.report(progress)?;
        };
        Ok(BatchOutcome { record: self.executor.record, ends: self.ends, stop_reason })
    }

    /// Closes a batch that began after `before` collapses; returns its number of collapses.
    fn end_batch(&mut self, before: usize) -> usize {
        let done = self.executor.record.removed.len();
        if done > before {
            self.executor.record.errors.resize(done, self.error);
            self.ends.push(done as u32);
        }
        done - before
    }

    /// Finds the positions that surface batches may remove from now on; positions that change in this
    /// are evaluated again.
    fn find_removable(&mut self) {
        for v in 0..self.is_removable.len() as u32 {
            let is_removable =
                closed_surface::is_manifold(&self.evaluator.links, v) && !self.evaluator.is_fixed(v);
            if std::mem::replace(&mut self.is_removable[v as usize], is_removable) != is_removable {
                self.mark_changed(v);
            }
        }
    }

    pub(super) fn is_base_reached(&self) -> bool {
        self.executor.triangle_count <= self.options.sequence.base_triangle_count
    }

    /// Finds the best targets of all positions whose stars have changed.
    pub(super) fn update_changed(&mut self) {
        let changed = std::mem::take(&mut self.changed);
        for &v in &changed {
            self.is_changed[v as usize] = false;
            self.choose(v);
        }
        self.changed = changed;
        self.changed.clear();
    }

    /// Evaluates a position: its best choice for a surface batch, or otherwise for a general one.
    pub(super) fn choose(&mut self, v: u32) {
        let choice = self.choice_of(v, |_| true);
        self.is_general[v as usize] = choice.is_none();
        self.choices[v as usize] = choice.or_else(|| self.general_choice(v));
    }

    /// Returns the cheapest target of `v` among those that `is_free` accepts.
    fn choice_of(&mut self, v: u32, is_free: impl Fn(u32) -> bool) -> Option<CollapseChoice> {
        if !self.is_removable[v as usize]
            || closed_surface::valence(&self.evaluator.links, v) > self.options.max_valence
            || self.evaluator.is_fixed(v)
        {
            return None;
        }
        let bias = self.bias;
        let mut legality = std::mem::take(&mut self.evaluator.legality);
        let choice = self.evaluator.best_choice_with(v, |links, star| {
            bias.adjust(links, star, v);
            for (cost, &u) in star.costs.iter_mut().zip(&star.ring.ids) {
                if !is_free(u) || !closed_surface::allows(&mut legality, links, v, u) {
                    *cost = f32::INFINITY;
                }
            }
        });
        self.evaluator.legality = legality;
        choice
    }

    /// Applies one surface batch; returns the reason if it must be the last one.
    fn surface_batch(&mut self) -> Option<StopReason> {
        let mut candidates = std::mem::take(&mut self.candidates);
        candidates.clear();
        let costs = self.choices.iter().zip(0..).filter_map(|(choice, v)| Some((choice.as_ref()?.cost, v)));
        candidates.extend(costs);
        keep_cheapest(&mut candidates, self.options.share * self.share_factor(), &self.is_copy);
        self.max_cost = candidates.last().map_or(0.0, |last| last.0);
        self.deferred.clear();
        self.deferred.extend(candidates.extract_if(.., |&mut (_, v)| self.is_general[v as usize]));
        self.selection.begin();
        self.selection.sort_by_crowding(&mut candidates, &self.evaluator.links, &self.is_copy);
        self.was_out_of_date = false;
        let mut stopped = None;
        for &(_, v) in &candidates {
            stopped = self.try_remove(v);
            if stopped.is_some() {
                break;
            }
        }
        self.candidates = candidates;
        stopped
    }

    /// Removes `v` if nothing in the batch conflicts with it and it costs no more than the most
    /// expensive candidate.
    fn try_remove(&mut self, v: u32) -> Option<StopReason> {
        if !self.selection.is_free(v) {
            return None;
        }
        let choice = self.free_choice(v)?;
        let choice = self.with_measured_distance(v, choice).filter(|choice| choice.cost <= self.max_cost)?;
        if let Err(stop_reason) = self.collapse(v, &choice) {
            return Some(stop_reason);
        }
        self.selection.mark_removed(choice.target, &self.executor.ring);
        self.mark_neighbors_changed(choice.target);
        self.is_base_reached().then_some(StopReason::TargetReached)
    }

    /// Applies a choice.
    ///
    /// # Errors
    /// Returns the reason to stop if the error would exceed its limit. The record is then unchanged,
    /// but no further batch may follow.
    pub(super) fn collapse(&mut self, v: u32, choice: &CollapseChoice) -> Result<(), StopReason> {
        let error = self.executor.collapse(&mut self.evaluator, v, choice).min(f64::from(f32::MAX)) as f32;
        if self.options.sequence.max_error.is_some_and(|limit| f64::from(error) > limit) {
            self.executor.drop_last();
            return Err(StopReason::ErrorLimit);
        }
        self.error = self.error.max(error);
        self.choices[v as usize] = None;
        Ok(())
    }

    /// Returns the choice with its distance from the original mesh, if that may exceed the largest
    /// error so far. Costs only include the distance from the current mesh, so this may raise the cost,
    /// which is then stored.
    pub(super) fn with_measured_distance(
        &mut self,
        v: u32,
        mut choice: CollapseChoice,
    ) -> Option<CollapseChoice> {
        if choice.kind != CollapseKind::Strict
            || choice.outward.is_some()
            || !self.evaluator.measures_outward()
        {
            return Some(choice);
        }
        let worst = self.executor.worst_squared();
        let u = choice.target;
        choice.outward = self.evaluator.outward_distance_before(v, u, choice.protrusion_squared, worst);
        let inward = self
            .executor
            .witness_distance_before(&mut self.evaluator, v, u, choice.distance_squared)
            .unwrap_or(0.0);
        let ahead = inward.max(choice.outward.map_or(0.0, |outward| outward * outward));
        if ahead > worst {
            choice.cost += self.evaluator.distance_cost(v, ahead);
            self.choices[v as usize] = Some(choice);
        }
        Some(choice)
    }

    /// Returns the best target of `v` that is still free in this batch.
    fn free_choice(&mut self, v: u32) -> Option<CollapseChoice> {
        let choice = self.choices[v as usize]?;
        let evaluator = &mut self.evaluator;
        let u = choice.target;
        if !closed_surface::allows(&mut evaluator.legality, &evaluator.links, v, u) {
            self.was_out_of_date = true;
            self.mark_changed(v);
        } else if self.selection.is_free_target(u) {
            return Some(choice);
        }
        let selection = std::mem::replace(&mut self.selection, Selection::new(0));
        let choice = self.choice_of(v, |u| selection.is_free_target(u));
        self.selection = selection;
        choice
    }

    /// Marks positions whose stars have changed, and those that the changed quadric of `u` affects.
    pub(super) fn mark_neighbors_changed(&mut self, u: u32) {
        let ring = std::mem::take(&mut self.executor.ring);
        ring.iter().for_each(|&w| self.mark_changed(w));
        self.executor.ring = ring;
        if self.evaluator.rules.target_grows {
            for i in 0..self.evaluator.links.entries(u).len() {
                self.mark_changed(self.evaluator.links.entries(u)[i]);
            }
        }
    }

    pub(super) fn mark_changed(&mut self, v: u32) {
        if !std::mem::replace(&mut self.is_changed[v as usize], true) {
            self.changed.push(v);
        }
    }
}
