//! The main loop: applies the cheapest collapse and updates the costs around it.
//!
//! The queue has one entry per position, with the cost of its best target. A collapse changes the cost
//! of the removed position's ring only, and each member of that ring first gets a **provisional cost**: the
//! quadratic form alone, without the flip, link and distance tests, times the factor by which the full
//! cost nearly always exceeds it, and most of what attributes cost before. The tests are done when a position reaches the top; if its full cost
//! is higher than the next key, it goes back. The order is therefore by full cost, except for the
//! rare position whose full cost is below its provisional cost, at a fraction of the work.
//!
//! A **strict** target is one that preserves the topology. A position without one gets a relaxed target
//! instead, and is queued at the cost of that. On a closed surface of a few parts, relaxed collapses begin
//! only after the last strict one.
//!
//! Time O(n log n); memory 87 to 91 bytes per triangle in addition to a large loaded mesh
//! (docs/results/simplification.md).

use crate::mesh::Welded;
use crate::{Progress, ProgressFn};

use super::attributes::AttributeSpace;
use super::collapse_choice::{CollapseChoice, CollapseKind};
use super::cost_evaluator::CostEvaluator;
use super::executor::CollapseExecutor;
use super::heap::IndexedHeap;
use super::links::LinkKind;
use super::part_order::PartOrder;
use super::refinement_order::{CollapseRecord, StepCost};
use super::relaxation_schedule::RelaxationSchedule;
use super::witness::Witnesses;
use crate::simplify::options::{SequenceOptions, SimplifyError, StopReason};

/// The new fan is known to be close enough to the original mesh without being measured.
const UNMEASURED: f32 = -1.0;
/// Share of what attributes cost in a choice that they will at least cost in the next one, which nearly always has a
/// larger star. With a larger share, fewer positions are evaluated again, but more are collapsed late.
const ATTRIBUTE_SHARE: f32 = 0.5;
/// Upper limit of that, with which keys stay finite.
const MAX_ATTRIBUTE_COST: f32 = 1e30;
/// Number of collapses between two progress reports.
const REPORT_INTERVAL: u64 = 4096;

/// The part of a [`CollapseChoice`] that is kept until its turn comes.
#[derive(Clone, Copy)]
struct StoredChoice {
    target: u32,
    kind: CollapseKind,
    distance_squared: f32,
    protrusion_squared: f32,
    /// Distance of the new fan from the original mesh; `UNMEASURED` if it is known to be small, `NAN` if not yet
    /// checked.
    outward: f32,
}

impl StoredChoice {
    fn choice(self) -> CollapseChoice {
        CollapseChoice {
            cost: 0.0,
            attributes: 0.0,
            target: self.target,
            kind: self.kind,
            distance_squared: self.distance_squared,
            protrusion_squared: self.protrusion_squared,
            outward: Some(self.outward).filter(|&outward| outward >= 0.0),
        }
    }
}

/// Complete state of one simplification.
pub(in crate::simplify) struct Simplifier<'a> {
    options: &'a SequenceOptions,
    evaluator: CostEvaluator<'a>,
    heap: IndexedHeap,
    /// The choice of each position; `None` if its key in the heap is a provisional cost.
    choices: Vec<Option<StoredChoice>>,
    /// Cost of attributes in the last choice of each position; empty if there are none.
    attribute_costs: Vec<f32>,
    schedule: RelaxationSchedule<'a>,
    executor: CollapseExecutor,
    /// The order of the steps among those of other parts, if the mesh is a part of a level.
    order: Option<PartOrder>,
}

/// State of the whole mesh at the positions of a part.
pub(in crate::simplify) struct PartOfMesh {
    /// Diagonal of the mesh, mesh units.
    pub scale: f64,
    /// Whether the part was cut out of a larger mesh, whose positions along the cut are locked.
    pub is_cut: bool,
    /// Keys as in [`PartOrder`].
    pub latest: Vec<f32>,
    /// Attributes of its positions, each of which has one vertex.
    pub attributes: Option<AttributeSpace>,
}

/// Result of [`Simplifier::run_part`].
pub(in crate::simplify) struct SimplifiedPart {
    /// The errors are what each step contributes: its own one if that is the largest so far in the part, or 0.
    pub record: CollapseRecord,
    pub stop_reason: StopReason,
    pub order: PartOrder,
    pub witnesses: Witnesses,
}

impl<'a> Simplifier<'a> {
    pub(in crate::simplify) fn new(welded: &'a Welded, options: &'a SequenceOptions) -> Self {
        Self::with_evaluator(welded, options, CostEvaluator::new(welded, options))
    }

    /// Creates a simplifier for a cell of a mesh whose diagonal is `scale` mesh units; it records costs.
    pub(in crate::simplify) fn of_cell(welded: &'a Welded, options: &'a SequenceOptions, scale: f64) -> Self {
        let mut evaluator = CostEvaluator::with_scale(welded, options, scale);
        evaluator.is_cell = true;
        Self::with_evaluator(welded, options, evaluator)
    }

    /// Creates a simplifier for a part of a level, to be [run as such](Self::run_part).
    pub(in crate::simplify) fn of_part(
        welded: &'a Welded,
        options: &'a SequenceOptions,
        PartOfMesh { scale, is_cut, latest, attributes }: PartOfMesh,
    ) -> Self {
        let mut evaluator = CostEvaluator::with_scale(welded, options, scale);
        (evaluator.is_cell, evaluator.attributes) = (is_cut, attributes);
        let mut simplifier = Self::with_evaluator(welded, options, evaluator);
        simplifier.order = Some(PartOrder::new(latest));
        simplifier
    }

    /// The witnesses, to add those of finer levels.
    pub(in crate::simplify) fn witnesses_mut(&mut self) -> &mut Witnesses {
        &mut self.executor.witnesses
    }

    pub(in crate::simplify) fn with_evaluator(
        welded: &'a Welded,
        options: &'a SequenceOptions,
        evaluator: CostEvaluator<'a>,
    ) -> Self {
        let position_count = evaluator.positions.len();
        let executor = CollapseExecutor::new(welded, &evaluator);
        let attributed_count = if evaluator.attributes.is_some() { position_count } else { 0 };
        Self {
            options,
            evaluator,
            heap: IndexedHeap::new(&[]),
            choices: vec![None; position_count],
            attribute_costs: vec![0.0; attributed_count],
            schedule: RelaxationSchedule::new(welded, options.topology),
            executor,
            order: None,
        }
    }

    /// Collapses until no collapse is possible, the base size is reached, or the error limit would be
    /// exceeded.
    pub(in crate::simplify) fn run(
        mut self,
        progress: &mut ProgressFn<'_>,
    ) -> Result<(CollapseRecord, StopReason), SimplifyError> {
        let stop_reason = self.collapse_all(progress)?;
        Ok((self.executor.record, stop_reason))
    }

    /// Simplifies a part of a level. It ends with the first step that exceeds the error limit.
    pub(in crate::simplify) fn run_part(
        mut self,
        progress: &mut ProgressFn<'_>,
    ) -> Result<SimplifiedPart, SimplifyError> {
        let stop_reason = self.collapse_all(progress)?;
        let CollapseExecutor { record, witnesses, .. } = self.executor;
        Ok(SimplifiedPart { record, stop_reason, order: self.order.unwrap_or_default(), witnesses })
    }

    fn collapse_all(&mut self, progress: &mut ProgressFn<'_>) -> Result<StopReason, SimplifyError> {
        self.fill_queue();
        let total = self.choices.len() as u64;
        let limit = self.options.max_error.unwrap_or(f64::INFINITY);
        let mut error = 0.0f32;
        let mut collapse_count = 0u64;
        while let Some((key, v)) = self.peek() {
            if self.executor.triangle_count <= self.options.base_triangle_count {
                return Ok(StopReason::TargetReached);
            }
            // If the neighborhood of the target has changed, another target is needed.
            let Some(stored) = self.choices[v as usize].filter(|&choice| self.is_still_allowed(v, choice))
            else {
                self.choices[v as usize] = None;
                self.decide(v, key);
                continue;
            };
            let Some(stored) = self.unless_farther(v, stored, key) else { continue };
            let (mut v, mut choice) = (v, stored.choice());
            if choice.kind == CollapseKind::Vanish
                && let Some(absorbing) = self.evaluator.absorbing_collapse(v, choice.target)
            {
                // The vanishing position is evaluated again after this.
                (v, choice) = absorbing;
            }
            let cost = StepCost {
                cost: key,
                distance_squared: self.executor.own_squared(&self.evaluator, v, &choice),
            };
            // Rounded the way it will be reported, so that the limit applies to the reported value.
            let known = self.executor.worst_squared();
            let collapse_error = self.collapse(v, &choice).min(f64::from(f32::MAX)) as f32;
            if let Some(order) = &mut self.order {
                let is_larger = f64::from(collapse_error) > f64::from(known).sqrt() * self.evaluator.scale;
                order.note(&self.executor, key);
                let record = &mut self.executor.record;
                record.errors.push(if is_larger { collapse_error } else { 0.0 });
                record.errors.resize(record.removed.len(), 0.0);
                if is_larger && f64::from(collapse_error) > limit {
                    return Ok(StopReason::ErrorLimit);
                }
            } else if f64::from(collapse_error) > limit {
                self.executor.drop_last();
                return Ok(StopReason::ErrorLimit);
            } else {
                error = error.max(collapse_error);
                let done = self.executor.record.removed.len();
                self.executor.record.errors.resize(done, error);
                if self.evaluator.is_cell {
                    self.executor.record.costs.resize(done, cost);
                }
            }
            collapse_count += 1;
            if collapse_count.is_multiple_of(REPORT_INTERVAL) {
                let done = self.executor.record.removed.len() as u64;
                Progress { phase: "simplify", done, total }.report(progress)?;
            }
        }
        let is_met = self.executor.triangle_count <= self.options.base_triangle_count;
        Ok(if is_met { StopReason::TargetReached } else { StopReason::BaseReached })
    }

    /// Begins, and computes the first key of every position.
    fn fill_queue(&mut self) {
        if self.schedule.is_possible() || self.evaluator.pairs.is_some() {
            self.evaluator.lock_boundary();
        }
        if self.evaluator.pairs.is_some() || (self.schedule.is_possible() && self.evaluator.wedges.is_some())
        {
            // Even strict collapses may remove whole parts, or move the surface farther than their
            // stars show.
            self.begin_relaxed();
        }
        let keys: Vec<f32> =
            (0..self.choices.len() as u32).map(|v| self.evaluator.provisional_cost(v)).collect();
        self.heap = IndexedHeap::new(&keys);
        drop(keys);
    }

    /// Returns the position with the smallest key, and that key; begins relaxed collapses if they had
    /// to wait for the last strict one.
    fn peek(&mut self) -> Option<(f32, u32)> {
        if self.heap.first().is_none() && self.schedule.is_postponed() {
            self.begin_relaxed();
            for v in 0..self.choices.len() as u32 {
                self.set_provisional(v);
            }
        }
        self.heap.first()
    }

    /// Begins relaxed collapses.
    fn begin_relaxed(&mut self) {
        let record = &self.executor.record;
        self.schedule.begin(&mut self.evaluator, (&record.removed, &record.targets));
    }

    /// Evaluates `v` in full and updates its key to the true cost, or removes `v` from the heap if no
    /// target is allowed.
    fn decide(&mut self, v: u32, bound: f32) {
        let mut choice = self.evaluator.best_choice(v);
        if choice.is_none() && self.schedule.is_possible() {
            let record = &self.executor.record;
            self.schedule.begin_or_postpone(&mut self.evaluator, (&record.removed, &record.targets));
            choice = self.evaluator.relaxed_choice(v);
        } else if let Some(strict) = choice
            && self.evaluator.is_nearly_gone(v)
        {
            choice = self.evaluator.ending_choice(v, strict.cost).or(choice);
        }
        match choice {
            None => self.heap.remove(v),
            Some(choice) => {
                if let Some(attributes) = self.attribute_costs.get_mut(v as usize) {
                    // Not `clamp`: strange values may cost what is no number.
                    let cost = choice.attributes.max(0.0);
                    *attributes = cost.min(MAX_ATTRIBUTE_COST);
                }
                self.choices[v as usize] = Some(StoredChoice {
                    target: choice.target,
                    kind: choice.kind,
                    distance_squared: choice.distance_squared,
                    protrusion_squared: choice.protrusion_squared,
                    outward: f32::NAN,
                });
                if choice.cost > bound {
                    self.heap.set(v, choice.cost);
                }
            }
        }
    }

    /// Puts `v` back with a higher cost if its collapse turns out to lie farther from the original mesh
    /// than anything so far, or returns the choice. Its cost only includes the distance from the current
    /// mesh. This is done once for each choice.
    fn unless_farther(&mut self, v: u32, mut stored: StoredChoice, key: f32) -> Option<StoredChoice> {
        let is_open = stored.kind == CollapseKind::Strict && stored.outward.is_nan();
        if !is_open || !self.evaluator.measures_outward() {
            return Some(stored);
        }
        let worst = self.executor.worst_squared();
        let StoredChoice { target: u, protrusion_squared, distance_squared: own, .. } = stored;
        let outward =
            self.evaluator.outward_distance_before(v, u, protrusion_squared, worst).unwrap_or(UNMEASURED);
        stored.outward = outward;
        self.choices[v as usize] = Some(stored);
        let inward = self.executor.witness_distance_before(&mut self.evaluator, v, u, own).unwrap_or(0.0);
        let ahead = inward.max(outward.max(0.0) * outward);
        if ahead > worst {
            self.heap.set(v, key + self.evaluator.distance_cost(v, ahead));
            return None;
        }
        Some(stored)
    }

    fn is_still_allowed(&mut self, v: u32, stored: StoredChoice) -> bool {
        let StoredChoice { target: u, kind, distance_squared, .. } = stored;
        let evaluator = &mut self.evaluator;
        if kind != CollapseKind::Strict {
            return evaluator.is_relaxed_choice_valid(v, u, kind, distance_squared);
        }
        if evaluator.links.entries(v).contains(&u) {
            return evaluator.legality.allows(&evaluator.links, v, u)
                && (evaluator.pairs.is_none() || evaluator.leaves_enough(v, u));
        }
        // A contraction of two parts only needs both to exist, and to be still separate.
        evaluator.pairs.is_some() && evaluator.links.kind(u) != LinkKind::Empty
    }

    /// Collapses `v` and gives the neighbors new bounds; returns the error after it, mesh units.
    fn collapse(&mut self, v: u32, choice: &CollapseChoice) -> f64 {
        let error = self.executor.collapse(&mut self.evaluator, v, choice);
        self.heap.remove(v);
        self.update_neighbors(choice.target);
        error
    }

    /// Drops the choice of `v` and gives it a provisional cost.
    fn set_provisional(&mut self, v: u32) {
        self.choices[v as usize] = None;
        let attributes = self.attribute_costs.get(v as usize).copied().unwrap_or(0.0);
        let key = self.evaluator.provisional_cost(v) + ATTRIBUTE_SHARE * attributes;
        self.heap.set(v, key);
    }

    /// Computes provisional costs for all positions whose star or target has changed.
    fn update_neighbors(&mut self, u: u32) {
        let ring = std::mem::take(&mut self.executor.ring);
        ring.iter().for_each(|&w| self.set_provisional(w));
        self.executor.ring = ring;
        if self.evaluator.rules.target_grows {
            // Collapsing to u now costs more than the stored cost.
            for &w in self.evaluator.links.entries(u) {
                self.choices[w as usize].take_if(|choice| choice.target == u);
            }
        }
        if !self.executor.ring.contains(&u) {
            // A contraction of two parts: u was not a neighbor of v.
            self.set_provisional(u);
        }
    }
}
