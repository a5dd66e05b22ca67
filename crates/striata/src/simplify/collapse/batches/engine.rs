//! The loop over batches: evaluates changed positions, then collapses cheap ones that are far enough
//! apart.
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
use crate::simplify::collapse::choice::{Choice, Tier};
use crate::simplify::collapse::course::Course;
use crate::simplify::collapse::finish::Record;
use crate::simplify::collapse::judge::{Judge, Memory};
use crate::simplify::collapse::relaxation::Relaxation;
use crate::simplify::options::{SimplifyError, StopReason, TopologyRule};
use crate::{Progress, ProgressFn};

use super::options::BatchOptions;
use super::select::{Selection, keep_cheapest};
use super::surface;
use super::taste::Taste;

/// All batches of a mesh.
pub(super) struct Outcome {
    /// The collapses, finest first.
    pub(super) record: Record,
    /// Number of collapses applied at the end of each batch.
    pub(super) ends: Vec<u32>,
    pub(super) stop_reason: StopReason,
}

/// Complete state of one simplification in batches.
pub(super) struct Engine<'a> {
    pub(super) options: &'a BatchOptions,
    pub(super) judge: Judge<'a>,
    pub(super) course: Course,
    taste: Taste,
    pub(super) relaxation: Relaxation<'a>,
    /// The best target of each position, if there is one; entries of changed positions are out of date.
    pub(super) choices: Vec<Option<Choice>>,
    /// Positions whose choice only a general batch can apply.
    pub(super) is_general: Vec<bool>,
    /// Positions that a surface batch may remove: manifold after the last general batch, and not
    /// locked.
    pub(super) is_removable: Vec<bool>,
    /// Positions whose stars have changed, each once.
    changed: Vec<u32>,
    is_changed: Vec<bool>,
    candidates: Vec<(f32, u32)>,
    /// Choices that wait for a general batch and cost no more than the last batch's candidates.
    pub(super) waiting: Vec<(f32, u32)>,
    /// Largest cost of the last batch's candidates.
    pub(super) dearest: f32,
    /// Number of positions left after the last general batch.
    pub(super) left_after_general: usize,
    selection: Selection,
    /// Whether the last batch found choices that are no longer allowed.
    was_out_of_date: bool,
    ends: Vec<u32>,
    pub(super) error: f32,
}

impl<'a> Engine<'a> {
    pub(super) fn new(welded: &'a Welded, options: &'a BatchOptions) -> Self {
        let judge = Judge::new(welded, &options.sequence);
        let position_count = judge.positions.len();
        let rule = if options.general { options.sequence.topology } else { TopologyRule::Keep };
        let mut engine = Self {
            options,
            course: Course::new(welded, &judge),
            taste: Taste::new(options, judge.scale),
            relaxation: Relaxation::new(welded, rule),
            choices: vec![None; position_count],
            is_general: vec![false; position_count],
            is_removable: vec![false; position_count],
            changed: (0..position_count as u32).collect(),
            is_changed: vec![true; position_count],
            candidates: Vec::new(),
            waiting: Vec::new(),
            dearest: 0.0,
            left_after_general: position_count,
            selection: Selection::new(position_count),
            was_out_of_date: false,
            ends: Vec::new(),
            error: 0.0,
            judge,
        };
        engine.find_removable();
        engine.prepare_general();
        engine
    }

    /// Runs batch after batch until nothing can be removed, the base size is reached, batches get too
    /// small, or the error limit would be exceeded.
    pub(super) fn run(mut self, progress: &mut ProgressFn<'_>) -> Result<Outcome, SimplifyError> {
        let total = self.choices.len() as u64;
        let stop_reason = loop {
            if self.is_base_reached() {
                break StopReason::TargetReached;
            }
            let all = self.choices.len();
            self.taste.fade(all - self.course.record.removed.len(), all);
            self.judge_changed();
            let before = self.course.record.removed.len();
            let mut stopped = self.do_batch();
            let taken = self.end_batch(before);
            if stopped.is_none() && self.is_general_due(taken) {
                let before = self.course.record.removed.len();
                stopped = self.general_batch();
                if self.end_batch(before) > 0 {
                    self.find_removable();
                }
            }
            if let Some(stop_reason) = stopped {
                break stop_reason;
            }
            let done = self.course.record.removed.len();
            // Positions that were out of date are evaluated again before a small batch ends the loop.
            if done - before < self.options.least_batch.max(1)
                && !self.was_out_of_date
                && !self.relax_at_last()
            {
                break StopReason::BaseReached;
            }
            Progress { phase: "simplify", done: done as u64, total }.report(progress)?;
        };
        Ok(Outcome { record: self.course.record, ends: self.ends, stop_reason })
    }

    /// Closes a batch that began after `before` collapses; returns its number of collapses.
    fn end_batch(&mut self, before: usize) -> usize {
        let done = self.course.record.removed.len();
        if done > before {
            self.course.record.errors.resize(done, self.error);
            self.ends.push(done as u32);
        }
        done - before
    }

    /// Finds the positions that surface batches may remove from now on; positions that change in this
    /// are evaluated again.
    fn find_removable(&mut self) {
        for v in 0..self.is_removable.len() as u32 {
            let is_removable = surface::is_manifold(&self.judge.links, v) && !self.judge.is_fixed(v);
            if std::mem::replace(&mut self.is_removable[v as usize], is_removable) != is_removable {
                self.note_change(v);
            }
        }
    }

    pub(super) fn is_base_reached(&self) -> bool {
        self.course.triangle_count <= self.options.sequence.base_triangle_count
    }

    /// Finds the best targets of all positions whose stars have changed.
    pub(super) fn judge_changed(&mut self) {
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
    fn choice_of(&mut self, v: u32, is_free: impl Fn(u32) -> bool) -> Option<Choice> {
        if !self.is_removable[v as usize]
            || surface::valence(&self.judge.links, v) > self.options.max_valence
            || self.judge.is_fixed(v)
        {
            return None;
        }
        let taste = self.taste;
        let mut legality = std::mem::take(&mut self.judge.legality);
        let choice = self.judge.best_choice_with(v, |links, star| {
            taste.adjust(links, star, v);
            for (cost, &u) in star.costs.iter_mut().zip(&star.ids) {
                if !is_free(u) || !surface::allows(&mut legality, links, v, u) {
                    *cost = f32::INFINITY;
                }
            }
        });
        self.judge.legality = legality;
        choice
    }

    /// Applies one surface batch; returns the reason if it must be the last one.
    fn do_batch(&mut self) -> Option<StopReason> {
        let mut candidates = std::mem::take(&mut self.candidates);
        candidates.clear();
        let costs = self.choices.iter().zip(0..).filter_map(|(choice, v)| Some((choice.as_ref()?.cost, v)));
        candidates.extend(costs);
        keep_cheapest(&mut candidates, self.options.share * self.boldness());
        self.dearest = candidates.last().map_or(0.0, |last| last.0);
        self.waiting.clear();
        self.waiting.extend(candidates.extract_if(.., |&mut (_, v)| self.is_general[v as usize]));
        self.selection.begin();
        self.selection.bring_forward_lonely(&mut candidates, &self.judge.links);
        self.was_out_of_date = false;
        let mut stopped = None;
        for &(_, v) in &candidates {
            stopped = self.take(v);
            if stopped.is_some() {
                break;
            }
        }
        self.candidates = candidates;
        stopped
    }

    /// Removes `v` if nothing in the batch conflicts with it and it costs no more than the most
    /// expensive candidate.
    fn take(&mut self, v: u32) -> Option<StopReason> {
        if !self.selection.is_free(v) {
            return None;
        }
        let choice = self.choice_in_batch(v)?;
        let choice = self.measured(v, choice).filter(|choice| choice.cost <= self.dearest)?;
        if let Err(stop_reason) = self.collapse(v, &choice) {
            return Some(stop_reason);
        }
        self.selection.take(choice.target, &self.course.ring);
        self.note_changes(choice.target);
        self.is_base_reached().then_some(StopReason::TargetReached)
    }

    /// Applies a choice.
    ///
    /// # Errors
    /// Returns the reason to stop if the error would exceed its limit. The record is then unchanged,
    /// but no further batch may follow.
    pub(super) fn collapse(&mut self, v: u32, choice: &Choice) -> Result<(), StopReason> {
        let error = self.course.collapse(&mut self.judge, v, choice).min(f64::from(f32::MAX)) as f32;
        if self.options.sequence.max_error.is_some_and(|limit| f64::from(error) > limit) {
            self.course.forget_last();
            return Err(StopReason::ErrorLimit);
        }
        self.error = self.error.max(error);
        self.choices[v as usize] = None;
        Ok(())
    }

    /// Returns the choice with its distance from the original mesh, if that may exceed the largest
    /// error so far. Costs only include the distance from the current mesh, so this may raise the cost,
    /// which is then stored.
    pub(super) fn measured(&mut self, v: u32, mut choice: Choice) -> Option<Choice> {
        if choice.tier != Tier::Strict || choice.outward.is_some() || !self.judge.is_measured_outward() {
            return Some(choice);
        }
        let worst = self.course.worst();
        let edge = (v, choice.target);
        choice.outward = self.judge.outward_ahead(edge, choice.protrusion_squared, worst);
        let inward = self.course.witness_ahead(&mut self.judge, edge, choice.distance_squared).unwrap_or(0.0);
        let ahead = inward.max(choice.outward.map_or(0.0, |outward| outward * outward));
        if ahead > worst {
            choice.cost += self.judge.distance_cost(v, ahead);
            self.choices[v as usize] = Some(choice);
        }
        Some(choice)
    }

    /// Returns the best target of `v` that is still free in this batch.
    fn choice_in_batch(&mut self, v: u32) -> Option<Choice> {
        let choice = self.choices[v as usize]?;
        let judge = &mut self.judge;
        let u = choice.target;
        if !surface::allows(&mut judge.legality, &judge.links, v, u) {
            self.was_out_of_date = true;
            self.note_change(v);
        } else if self.selection.is_free_target(u) {
            return Some(choice);
        }
        let selection = std::mem::replace(&mut self.selection, Selection::new(0));
        let choice = self.choice_of(v, |u| selection.is_free_target(u));
        self.selection = selection;
        choice
    }

    /// Marks positions whose stars have changed, and those that the changed quadric of `u` affects.
    pub(super) fn note_changes(&mut self, u: u32) {
        let ring = std::mem::take(&mut self.course.ring);
        ring.iter().for_each(|&w| self.note_change(w));
        self.course.ring = ring;
        if matches!(self.judge.memory, Memory::Accumulated(_)) {
            for i in 0..self.judge.links.entries(u).len() {
                self.note_change(self.judge.links.entries(u)[i]);
            }
        }
    }

    pub(super) fn note_change(&mut self, v: u32) {
        if !std::mem::replace(&mut self.is_changed[v as usize], true) {
            self.changed.push(v);
        }
    }
}
