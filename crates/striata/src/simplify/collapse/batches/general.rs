//! General batches: collapses of any kind, applied one after another, at non-manifold positions and
//! where the topology changes.
//!
//! Choices that no surface batch can apply wait until there are enough of them for a batch, because a
//! decoder must rebuild its surface after each general batch. A general batch is due when a large part
//! of the cheap choices waits for one, but never soon after another, and whenever the surface batches
//! find almost nothing left to remove.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::simplify::collapse::choice::{Choice, Tier};
use crate::simplify::options::StopReason;

use super::engine::Engine;
use super::surface;

/// A general batch needs at least one waiting choice per this many positions.
const WAITING_SHARE: usize = 32;
/// A surface batch that removes less than one in this many positions is small, which makes a general
/// batch due.
const SMALL_BATCH: usize = 64;
/// A general batch is due once this many quarters of the positions left by the last one remain, or
/// fewer.
const LEFT_QUARTERS: usize = 3;

/// Factor on the share of a batch after the first general one.
const CAUTION: f64 = 0.7;

/// Share of the positions left above which batches grow, up to twice their share at the full mesh.
const COARSE_LEFT: f64 = 0.4;

/// Queue entry, ordered by cost and then by position: costs are not negative, so their bits have the
/// same order.
type Entry = Reverse<(u32, u32)>;

fn entry(cost: f32, v: u32) -> Entry {
    Reverse((cost.max(0.0).to_bits(), v))
}

impl Engine<'_> {
    /// Prepares for collapses that change the topology; call before the first collapse.
    pub(super) fn prepare_general(&mut self) {
        if !self.options.general || !self.relaxation.is_possible() {
            return;
        }
        self.judge.lock_boundary();
        if self.judge.wedges.is_some() {
            // With seams, distances from the original mesh are measured from the first step on.
            self.relax();
        }
    }

    fn relax(&mut self) {
        let record = &self.course.record;
        self.relaxation.begin(&mut self.judge, (&record.removed, &record.targets));
    }

    /// Begins postponed collapses that change the topology; returns false if none were postponed.
    pub(super) fn relax_at_last(&mut self) -> bool {
        if !self.relaxation.is_waiting() || self.course.triangle_count <= self.options.general_floor {
            return false;
        }
        self.relax();
        (0..self.choices.len() as u32).for_each(|v| self.note_change(v));
        true
    }

    /// Returns the cheapest collapse of any kind for a position that no surface batch can remove.
    pub(super) fn general_choice(&mut self, v: u32) -> Option<Choice> {
        if !self.options.general || self.judge.is_fixed(v) {
            return None;
        }
        let is_manifold = self.is_removable[v as usize] && surface::is_manifold(&self.judge.links, v);
        if is_manifold && surface::valence(&self.judge.links, v) > self.options.max_valence {
            // Wait for a surface batch: it will have fewer triangles later.
            return None;
        }
        let choice = self.judge.best_choice(v);
        match choice {
            None if self.relaxation.is_possible() => {
                let record = &self.course.record;
                self.relaxation.consider(&mut self.judge, (&record.removed, &record.targets));
                self.judge.relaxed_choice(v)
            }
            Some(strict) if self.judge.is_nearly_gone(v) => {
                self.judge.ending_choice(v, strict.cost).or(choice)
            }
            _ => choice,
        }
    }

    /// Whether a general batch is due after a surface batch that has removed `taken` positions.
    pub(super) fn is_general_due(&self, taken: usize) -> bool {
        if self.waiting.is_empty() || self.course.triangle_count <= self.options.general_floor {
            return false;
        }
        let left = self.choices.len() - self.course.record.removed.len();
        let is_small = taken < self.options.least_batch.max(left / SMALL_BATCH);
        let are_many = self.waiting.len() * WAITING_SHARE >= left;
        is_small || (are_many && 4 * left <= LEFT_QUARTERS * self.left_after_general)
    }

    /// Factor on the share that a batch may select from: smaller after the first general batch, since
    /// costs vary more in assets, which need those, than in scans; and larger near the full mesh, where
    /// few large batches save bits and levels are hardly distinguishable.
    pub(super) fn boldness(&self) -> f64 {
        let all = self.choices.len();
        let left = (all - self.course.record.removed.len()) as f64 / all.max(1) as f64;
        let bold = 1.0 + ((left - COARSE_LEFT) / (1.0 - COARSE_LEFT)).max(0.0);
        bold * if self.left_after_general < all { CAUTION } else { 1.0 }
    }

    /// Applies one general batch; returns the reason if it must be the last one.
    pub(super) fn general_batch(&mut self) -> Option<StopReason> {
        // The last batch has changed the neighborhoods.
        self.judge_changed();
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
            if !self.still_allows(v, &choice) {
                self.choose(v);
                self.enqueue(v, &mut queue);
                continue;
            }
            let Some(choice) = self.measured(v, choice) else { continue };
            if choice.cost > self.dearest {
                continue;
            }
            let (v, choice) = self.with_absorber(v, choice);
            if let Err(stop_reason) = self.collapse(v, &choice) {
                stopped = Some(stop_reason);
                break;
            }
            self.note_changes(choice.target);
            self.judge_ring(&mut queue);
            if self.is_base_reached() {
                stopped = Some(StopReason::TargetReached);
                break;
            }
            if self.course.triangle_count <= self.options.general_floor {
                break;
            }
        }
        self.left_after_general = self.choices.len() - self.course.record.removed.len();
        stopped
    }

    /// Replaces the choice that lets a part vanish by one that lets another part grow in its place, if
    /// there is one.
    fn with_absorber(&mut self, v: u32, choice: Choice) -> (u32, Choice) {
        let absorber = (choice.tier == Tier::Vanish).then(|| self.judge.absorber(v, choice.target));
        absorber.flatten().unwrap_or((v, choice))
    }

    /// Evaluates the ring of the last collapse again and queues its members that wait for a general
    /// batch.
    fn judge_ring(&mut self, queue: &mut BinaryHeap<Entry>) {
        let ring = std::mem::take(&mut self.course.ring);
        for &w in &ring {
            self.choose(w);
            self.enqueue(w, queue);
        }
        self.course.ring = ring;
    }

    fn enqueue(&self, v: u32, queue: &mut BinaryHeap<Entry>) {
        if let Some(choice) = self.choices[v as usize].filter(|choice| choice.cost <= self.dearest)
            && self.is_general[v as usize]
        {
            queue.push(entry(choice.cost, v));
        }
    }

    fn still_allows(&mut self, v: u32, choice: &Choice) -> bool {
        let judge = &mut self.judge;
        if choice.tier != Tier::Strict {
            return judge.relaxed_stands(v, choice.target, (choice.tier, choice.distance_squared));
        }
        judge.links.entries(v).contains(&choice.target)
            && judge.legality.allows(&judge.links, v, choice.target)
    }
}
