//! Batches of any collapses, done one after another: where the mesh is not manifold, and where its topology changes.
//!
//! Choices that no batch of the surface can carry out wait until they are worth a batch of their own: a reader must build its
//! surface anew after each. So general batches come while a good part of what is cheap waits for one, but never soon after
//! each other, and whenever the surface has next to nothing left to give.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::simplify::collapse::choice::{Choice, Tier};
use crate::simplify::options::StopReason;

use super::engine::Engine;
use super::surface;

/// One in so many positions has to wait for a general batch to come.
const WAITING_SHARE: usize = 32;
/// Batches of the surface that take less than one in so many positions leave the rest to a general one.
const SMALL_BATCH: usize = 64;
/// The share of the positions that may be left after one general batch when the next one comes, in quarters.
const LEFT_QUARTERS: usize = 3;

/// The part of its usual share that a batch takes once general ones have come.
const CAUTION: f64 = 0.7;

/// Batches grow towards the full mesh, to twice their share, from where this part of the positions is left.
const COARSE_LEFT: f64 = 0.4;

/// A cost in the order of a queue: costs are not negative, so their bits rise with them.
type Entry = Reverse<(u32, u32)>;

fn entry(cost: f32, v: u32) -> Entry {
    Reverse((cost.max(0.0).to_bits(), v))
}

impl Engine<'_> {
    /// Gets ready for collapses that change the topology, before the first collapse.
    pub(super) fn prepare_general(&mut self) {
        if !self.options.general || !self.relaxation.is_possible() {
            return;
        }
        self.judge.lock_boundary();
        if self.judge.wedges.is_some() {
            // With seams, how far steps lie from the original is measured from the first one on.
            self.relax();
        }
    }

    fn relax(&mut self) {
        let record = &self.course.record;
        self.relaxation.begin(&mut self.judge, (&record.removed, &record.targets));
    }

    /// Lets collapses begin that change the topology, if they had to wait for the end; false if there is nothing new.
    pub(super) fn relax_at_last(&mut self) -> bool {
        if !self.relaxation.is_waiting() || self.course.triangle_count <= self.options.general_floor {
            return false;
        }
        self.relax();
        (0..self.choices.len() as u32).for_each(|v| self.note_change(v));
        true
    }

    /// The cheapest collapse of any kind for a position that no batch of the surface can take.
    pub(super) fn general_choice(&mut self, v: u32) -> Option<Choice> {
        if !self.options.general || self.judge.is_fixed(v) {
            return None;
        }
        let is_manifold = self.is_removable[v as usize] && surface::is_manifold(&self.judge.links, v);
        if is_manifold && surface::valence(&self.judge.links, v) > self.options.max_valence {
            // It will have fewer triangles.
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

    /// Whether a general batch comes next, after a batch of the surface that has taken so many positions.
    pub(super) fn is_general_due(&self, taken: usize) -> bool {
        if self.waiting.is_empty() || self.course.triangle_count <= self.options.general_floor {
            return false;
        }
        let left = self.choices.len() - self.course.record.removed.len();
        let is_small = taken < self.options.least_batch.max(left / SMALL_BATCH);
        let are_many = self.waiting.len() * WAITING_SHARE >= left;
        is_small || (are_many && 4 * left <= LEFT_QUARTERS * self.left_after_general)
    }

    /// What a batch takes of its usual share: less once general ones have come, since the costs of assets, which need them, differ
    /// more than those of scans; and more near the full mesh, where few large batches save bits and levels are hardly
    /// told apart.
    pub(super) fn boldness(&self) -> f64 {
        let all = self.choices.len();
        let left = (all - self.course.record.removed.len()) as f64 / all.max(1) as f64;
        let bold = 1.0 + ((left - COARSE_LEFT) / (1.0 - COARSE_LEFT)).max(0.0);
        bold * if self.left_after_general < all { CAUTION } else { 1.0 }
    }

    /// A general batch; the reason where it is to be the last one.
    pub(super) fn general_batch(&mut self) -> Option<StopReason> {
        // The batch before has changed what is around.
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

    /// What comes instead of a part that vanishes, where another part grows in its place first.
    fn with_absorber(&mut self, v: u32, choice: Choice) -> (u32, Choice) {
        let absorber = (choice.tier == Tier::Vanish).then(|| self.judge.absorber(v, choice.target));
        absorber.flatten().unwrap_or((v, choice))
    }

    /// Judges all around the last collapse anew and puts those that wait for a general batch into its queue.
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
