//! The loop: take the cheapest collapse, do it, look again at what it touched.
//!
//! The queue holds one entry a position, the cost of its best target. After a collapse only the ring of the removed
//! position changes cost, and each of its members gets a **lower bound** first: the quadratic form alone, without
//! flip, link and distance tests, times what the full cost nearly always is of it. Those tests are made when a
//! position reaches the top; if its full cost is higher than the next bound it goes back. The order is therefore strict
//! but for the rare position whose full cost is less than its bound, for a fraction of the work.
//!
//! A position that has no **strict** target, one that keeps the topology, gets a relaxed one at its price instead. On a closed
//! surface of a few parts relaxed collapses begin only after the last strict one.
//!
//! Time O(n log n); 87 to 91 bytes a triangle on top of a large loaded mesh (docs/results.md).

use crate::mesh::Welded;
use crate::{Progress, ProgressFn};

use super::choice::{Choice, Tier};
use super::course::Course;
use super::finish::Record;
use super::heap::IndexedHeap;
use super::judge::{Judge, Memory};
use super::links::LinkKind;
use super::relaxation::Relaxation;
use crate::simplify::options::{SequenceOptions, SimplifyError, StopReason};

/// No target chosen yet: the key is a lower bound.
const UNDECIDED: u32 = u32::MAX;
/// What a choice leaves is near enough to the original mesh, as far as is known without measuring.
const UNMEASURED: f32 = -1.0;
/// Collapses between two reports of progress.
const REPORT_INTERVAL: u64 = 4096;

/// All state of one simplification.
pub(in crate::simplify) struct Engine<'a> {
    options: &'a SequenceOptions,
    judge: Judge<'a>,
    heap: IndexedHeap,
    target: Vec<u32>,
    tier: Vec<Tier>,
    distance_squared: Vec<f32>,
    protrusion_squared: Vec<f32>,
    /// Distance from the original mesh of what the choice leaves; `UNMEASURED` if it is small, `NAN` if nobody has looked yet.
    outward: Vec<f32>,
    relaxation: Relaxation<'a>,
    course: Course,
}

impl<'a> Engine<'a> {
    pub(in crate::simplify) fn new(welded: &'a Welded, options: &'a SequenceOptions) -> Self {
        let judge = Judge::new(welded, options);
        let position_count = judge.positions.len();
        let course = Course::new(welded, &judge);
        Self {
            options,
            judge,
            heap: IndexedHeap::new(&[]),
            target: vec![UNDECIDED; position_count],
            tier: vec![Tier::Strict; position_count],
            distance_squared: vec![0.0; position_count],
            protrusion_squared: vec![0.0; position_count],
            outward: vec![f32::NAN; position_count],
            relaxation: Relaxation::new(welded, options.topology),
            course,
        }
    }

    /// Collapses until nothing can be, the base is reached or an error limit forbids to go on.
    pub(in crate::simplify) fn run(
        mut self,
        progress: &mut ProgressFn<'_>,
    ) -> Result<(Record, StopReason), SimplifyError> {
        let total = self.target.len() as u64;
        if self.relaxation.is_possible() || self.judge.pairs.is_some() {
            self.judge.lock_boundary();
        }
        if self.judge.pairs.is_some() || (self.relaxation.is_possible() && self.judge.wedges.is_some()) {
            // Even strict collapses may take whole parts, or move the surface by more than their stars tell.
            self.relax();
        }
        let keys: Vec<f32> = (0..total as u32).map(|v| self.judge.lower_bound(v)).collect();
        self.heap = IndexedHeap::new(&keys);
        drop(keys);
        let limit = self.options.max_error.unwrap_or(f64::INFINITY);
        let mut error = 0.0f32;
        let mut collapse_count = 0u64;
        while let Some((key, v)) = self.next() {
            if self.course.triangle_count <= self.options.base_triangle_count {
                return Ok((self.course.record, StopReason::TargetReached));
            }
            if self.target[v as usize] == UNDECIDED {
                self.decide(v, key);
                continue;
            }
            let (mut v, mut u) = (v, self.target[v as usize]);
            if !self.is_still_allowed(v, u) {
                // The target's surroundings have changed: look for another one.
                self.target[v as usize] = UNDECIDED;
                self.decide(v, key);
                continue;
            }
            if self.is_postponed(v, u, key) {
                continue;
            }
            if self.tier[v as usize] == Tier::Vanish
                && let Some((corner, choice)) = self.judge.absorber(v, u)
            {
                // What vanishes next is looked at anew after that.
                self.choose(corner, &choice);
                (v, u) = (corner, choice.target);
            }
            // As it will be reported, rounded and all, so that the limit holds for what is reported.
            let collapse_error = self.collapse(v, u).min(f64::from(f32::MAX)) as f32;
            if f64::from(collapse_error) > limit {
                self.course.forget_last();
                return Ok((self.course.record, StopReason::ErrorLimit));
            }
            error = error.max(collapse_error);
            let done = self.course.record.removed.len();
            self.course.record.errors.resize(done, error);
            collapse_count += 1;
            if collapse_count.is_multiple_of(REPORT_INTERVAL) {
                Progress { phase: "simplify", done: done as u64, total }.report(progress)?;
            }
        }
        let is_met = self.course.triangle_count <= self.options.base_triangle_count;
        Ok((self.course.record, if is_met { StopReason::TargetReached } else { StopReason::BaseReached }))
    }

    /// The position that comes next, and its key; lets relaxed collapses begin if they had to wait for the end.
    fn next(&mut self) -> Option<(f32, u32)> {
        if self.heap.first().is_none() && self.relaxation.is_waiting() {
            self.relax();
            for v in 0..self.target.len() as u32 {
                self.target[v as usize] = UNDECIDED;
                let bound = self.judge.lower_bound(v);
                self.heap.set(v, bound);
            }
        }
        self.heap.first()
    }

    /// Lets relaxed collapses begin.
    fn relax(&mut self) {
        let record = &self.course.record;
        self.relaxation.begin(&mut self.judge, (&record.removed, &record.targets));
    }

    /// Judges `v` in full and puts it back with its true cost, or takes it out where no target is allowed.
    fn decide(&mut self, v: u32, bound: f32) {
        let mut choice = self.judge.best_choice(v);
        if choice.is_none() && self.relaxation.is_possible() {
            let record = &self.course.record;
            self.relaxation.consider(&mut self.judge, (&record.removed, &record.targets));
            choice = self.judge.relaxed_choice(v);
        } else if let Some(strict) = choice
            && self.judge.is_nearly_gone(v)
        {
            choice = self.judge.ending_choice(v, strict.cost).or(choice);
        }
        match choice {
            None => self.heap.remove(v),
            Some(choice) => {
                self.choose(v, &choice);
                if choice.cost > bound {
                    self.heap.set(v, choice.cost);
                }
            }
        }
    }

    /// Puts `v` back with a higher cost if its collapse to `u` is found to lie farther from the original mesh than anything so far:
    /// its cost has only seen how far it lies from the current one. That happens once for each choice.
    fn is_postponed(&mut self, v: u32, u: u32, key: f32) -> bool {
        let is_open = self.tier[v as usize] == Tier::Strict && self.outward[v as usize].is_nan();
        if !is_open || !self.judge.is_measured_outward() {
            return false;
        }
        let worst = self.course.worst();
        let protrusion = self.protrusion_squared[v as usize];
        let outward = self.judge.outward_ahead((v, u), protrusion, worst).unwrap_or(UNMEASURED);
        self.outward[v as usize] = outward;
        let own = self.distance_squared[v as usize];
        let inward = self.course.witness_ahead(&mut self.judge, (v, u), own).unwrap_or(0.0);
        let ahead = inward.max(outward.max(0.0) * outward);
        if ahead > worst {
            self.heap.set(v, key + self.judge.distance_cost(v, ahead));
        }
        ahead > worst
    }

    fn is_still_allowed(&mut self, v: u32, u: u32) -> bool {
        let choice = self.choice(v);
        let tier = choice.tier;
        let judge = &mut self.judge;
        if tier != Tier::Strict {
            return judge.relaxed_stands(v, u, (tier, choice.distance_squared));
        }
        if judge.links.entries(v).contains(&u) {
            return judge.legality.allows(&judge.links, v, u)
                && (judge.pairs.is_none() || judge.leaves_enough(v, u));
        }
        // A contraction of two parts only needs both to be there, and still apart.
        judge.pairs.is_some() && judge.links.kind(u) != LinkKind::Empty
    }

    /// Notes what is decided for `v`.
    fn choose(&mut self, v: u32, choice: &Choice) {
        let v = v as usize;
        self.target[v] = choice.target;
        self.tier[v] = choice.tier;
        self.distance_squared[v] = choice.distance_squared;
        self.protrusion_squared[v] = choice.protrusion_squared;
        self.outward[v] = f32::NAN;
    }

    /// What was decided for `v`.
    fn choice(&self, v: u32) -> Choice {
        let v = v as usize;
        Choice {
            cost: 0.0,
            target: self.target[v],
            tier: self.tier[v],
            distance_squared: self.distance_squared[v],
            protrusion_squared: self.protrusion_squared[v],
            outward: Some(self.outward[v]).filter(|&outward| outward >= 0.0),
        }
    }

    /// Removes `v` into `u` and gives the neighbors new bounds; returns the error after it, mesh units.
    fn collapse(&mut self, v: u32, u: u32) -> f64 {
        let choice = self.choice(v);
        let error = self.course.collapse(&mut self.judge, v, &choice);
        self.heap.remove(v);
        self.update_neighbors(u);
        error
    }

    /// New bounds for all whose star or whose target has changed.
    fn update_neighbors(&mut self, u: u32) {
        let ring = std::mem::take(&mut self.course.ring);
        for &w in &ring {
            self.target[w as usize] = UNDECIDED;
            let bound = self.judge.lower_bound(w);
            self.heap.set(w, bound);
        }
        self.course.ring = ring;
        if matches!(self.judge.memory, Memory::Accumulated(_)) {
            // The quadric of u has grown: collapsing to it now costs more than it seemed.
            for &w in self.judge.links.entries(u) {
                if self.target[w as usize] == u {
                    self.target[w as usize] = UNDECIDED;
                }
            }
        }
        if !self.course.ring.contains(&u) {
            // A contraction of two parts: u was no neighbor.
            self.target[u as usize] = UNDECIDED;
            let bound = self.judge.lower_bound(u);
            self.heap.set(u, bound);
        }
    }
}
