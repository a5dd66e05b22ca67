//! General batches: collapses of any kind, applied one after another, at non-manifold positions and
//! where the topology changes.
//!
//! Choices that no surface batch can apply wait until there are enough of them for a batch, because a
//! decoder must rebuild its surface after each general batch. A general batch is due when a large part
//! of the cheap choices waits for one, but never soon after another, and whenever the surface batches
//! find almost nothing left to remove.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::simplify::collapse::collapse_choice::{CollapseChoice, CollapseKind};
use crate::simplify::options::StopReason;

use super::batch_simplifier::BatchSimplifier;
use super::closed_surface;

/// A general batch needs at least one waiting choice per this many positions.
const DEFERRED_SHARE: usize = 32;
/// A surface batch that removes less than one in this many positions is small, which makes a general
/// batch due.
const SMALL_BATCH: usize = 64;
/// A general batch is due only once at most this many quarters of the positions left by the last general
/// batch remain.
const LEFT_QUARTERS: usize = 3;

/// Factor on the share of a batch after the first general one.
const GENERAL_SHARE_FACTOR: f64 = 0.7;

/// Share of the positions left above which batches grow, up to twice their share at the full mesh.
const GROWTH_THRESHOLD: f64 = 0.4;

/// Queue entry, ordered by cost and then by position: costs are not negative, so their bits have the
/// same order.
type Entry = Reverse<(u32, u32)>;

fn entry(cost: f32, v: u32) -> Entry {
    Reverse((cost.max(0.0).to_bits(), v))
}

impl BatchSimplifier<'_> {
    /// Prepares for collapses that change the topology; call before the first collapse.
    pub(super) fn prepare_general(&mut self) {
        if !self.options.general || !self.schedule.is_possible() {
            return;
        }
        self.evaluator.lock_boundary();
        if self.evaluator.wedges.is_some() {
            // With seams, distances from the original mesh are measured from the first step on.
            self.begin_relaxed();
        }
    }

    fn begin_relaxed(&mut self) {
        let record = &self.executor.record;
        self.schedule.begin(&mut self.evaluator, (&record.removed, &record.targets));
    }

    /// Begins postponed collapses that change the topology; returns false if none were postponed.
    pub(super) fn begin_postponed(&mut self) -> bool {
        if !self.schedule.is_postponed() || self.executor.triangle_count <= self.options.general_floor {
            return false;
        }
        self.begin_relaxed();
        (0..self.choices.len() as u32).for_each(|v| self.mark_changed(v));
        true
    }

    /// Returns the cheapest collapse of any kind for a position that no surface batch can remove.
    pub(super) fn general_choice(&mut self, v: u32) -> Option<CollapseChoice> {
        if !self.options.general || self.evaluator.is_fixed(v) {
            return None;
        }
        let is_manifold =
            self.is_removable[v as usize] && closed_surface::is_manifold(&self.evaluator.links, v);
        if is_manifold && closed_surface::valence(&self.evaluator.links, v) > self.options.max_valence {
            // Wait for a surface batch: it will have fewer triangles later.
            return None;
        }
        let choice = self.evaluator.best_choice(v);
        match choice {
            None if self.schedule.is_possible() => {
                let record = &self.executor.record;
                self.schedule.begin_or_postpone(&mut self.evaluator, (&record.removed, &record.targets));
                self.evaluator.relaxed_choice(v)
            }
            Some(strict) if self.evaluator.is_nearly_gone(v) => {
                self.evaluator.ending_choice(v, strict.cost).or(choice)
            }
            _ => choice,
        }
    }

    /// Whether a general batch is due after a surface batch that has removed `removed_count` positions.
    pub(super) fn is_general_due(&self, removed_count: usize) -> bool {
        if self.deferred.is_empty() || self.executor.triangle_count <= self.options.general_floor {
            return false;
        }
        let left = self.choices.len() - self.executor.record.removed.len();
        let is_small = removed_count < self.options.min_batch_size.max(left / SMALL_BATCH);
        let are_many = self.deferred.len() * DEFERRED_SHARE >= left;
        is_small || (are_many && 4 * left <= LEFT_QUARTERS * self.left_after_general)
    }

    /// Factor on the share that a batch may select from: smaller after the first general batch, since
    /// costs vary more in assets, which need those, than in scans; and larger near the full mesh, where
    /// few large batches save bits and levels are hardly distinguishable.
    pub(super) fn share_factor(&self) -> f64 {
        let all = self.choices.len();
        let left = (all - self.executor.record.removed.len()) as f64 / all.max(1) as f64;
        let factor = 1.0 + ((left - GROWTH_THRESHOLD) / (1.0 - GROWTH_THRESHOLD)).max(0.0);
        factor * if self.left_after_general < all { GENERAL_SHARE_FACTOR } else { 1.0 }
    }

    /// Applies one general batch; returns the reason if it must be the last one.
    pub(super) fn general_batch(&mut self) -> Option<StopReason> {
        // The last batch has changed the neighborhoods.
        self.update_changed();
        let mut queue = BinaryHeap::new();
        (0..self.choices.len() as u32).for_each(|v| self.enqueue(v, &mut queue));
        let mut stopped = None;
        while let Some(Reverse((bits, v))) = queue.pop() {
            let Some(choice) = self.choices[v as usize].filter(|_| self.is_general[v as usize]) else {
                continue;
            };
            if entry(choice.cost, v) != Reverse((bits, v)) {
                continue;
            }
            if !self.is_still_allowed(v, &choice) {
                self.choose(v);
                self.enqueue(v, &mut queue);
                continue;
            }
            let Some(choice) = self.with_measured_distance(v, choice) else { continue };
            if choice.cost > self.max_cost {
                continue;
            }
            let (v, choice) = self.with_absorbing_collapse(v, choice);
            if let Err(stop_reason) = self.collapse(v, &choice) {
                stopped = Some(stop_reason);
                break;
            }
            self.mark_neighbors_changed(choice.target);
            self.update_ring(&mut queue);
            if self.is_base_reached() {
                stopped = Some(StopReason::TargetReached);
                break;
            }
            if self.executor.triangle_count <= self.options.general_floor {
                break;
            }
        }
        self.left_after_general = self.choices.len() - self.executor.record.removed.len();
        stopped
    }

    /// Replaces the choice that lets a part vanish by one that lets another part grow in its place, if
    /// there is one.
    fn with_absorbing_collapse(&mut self, v: u32, choice: CollapseChoice) -> (u32, CollapseChoice) {
        let absorbing_collapse = (choice.kind == CollapseKind::Vanish)
            .then(|| self.evaluator.absorbing_collapse(v, choice.target));
        absorbing_collapse.flatten().unwrap_or((v, choice))
    }

    /// Evaluates the ring of the last collapse again and queues its members that wait for a general batch.
    fn update_ring(&mut self, queue: &mut BinaryHeap<Entry>) {
        let ring = std::mem::take(&mut self.executor.ring);
        for &w in &ring {
            self.choose(w);
            self.enqueue(w, queue);
        }
        self.executor.ring = ring;
    }

    fn enqueue(&self, v: u32, queue: &mut BinaryHeap<Entry>) {
        if let Some(choice) = self.choices[v as usize].filter(|choice| choice.cost <= self.max_cost)
            && self.is_general[v as usize]
        {
            queue.push(entry(choice.cost, v));
        }
    }

    fn is_still_allowed(&mut self, v: u32, choice: &CollapseChoice) -> bool {
        let evaluator = &mut self.evaluator;
        if choice.kind != CollapseKind::Strict {
            return evaluator.is_relaxed_choice_valid(v, choice.target, choice.kind, choice.distance_squared);
        }
        evaluator.links.entries(v).contains(&choice.target)
            && evaluator.legality.allows(&evaluator.links, v, choice.target)
    }
}
