//! The loop over batches: judge what has changed, take what is cheap and far enough apart, do it.
//!
//! Every position that may go is judged in full, and its cheapest target kept. A batch changes the stars of its
//! rings only: they are judged again before the next one. Elsewhere only the link of a target may have changed, so
//! whether a collapse is allowed is looked at again when it is its turn; a position whose target is taken already, or no
//! longer allowed, gets its next best one if that is still among the cheap.

use std::ops::ControlFlow;

use crate::mesh::Welded;
use crate::simplify::course::Course;
use crate::simplify::engine::scaled_positions;
use crate::simplify::finish::Record;
use crate::simplify::judge::{Choice, Judge, Memory};
use crate::simplify::options::{SimplifyError, StopReason};
use crate::{Cancelled, Progress, ProgressFn};

use super::options::BatchOptions;
use super::select::{Selection, keep_cheapest};
use super::surface;
use super::taste::Taste;

/// All batches of a mesh.
pub(super) struct Outcome {
    /// The collapses, finest first.
    pub(super) record: Record,
    /// Collapses done when each batch ended.
    pub(super) ends: Vec<u32>,
    pub(super) stop_reason: StopReason,
}

/// All state of one simplification in batches.
pub(super) struct Engine<'a> {
    options: &'a BatchOptions,
    judge: Judge<'a>,
    course: Course,
    taste: Taste,
    /// The best target of each position, where there is one; those of positions to be judged again are out of date.
    choices: Vec<Option<Choice>>,
    /// Positions that may be removed at all: manifold in the full mesh, not locked.
    is_removable: Vec<bool>,
    /// Positions whose stars have changed, each once.
    changed: Vec<u32>,
    is_changed: Vec<bool>,
    candidates: Vec<(f32, u32)>,
    selection: Selection,
    /// Whether the last batch met choices that are no longer allowed.
    was_out_of_date: bool,
    ends: Vec<u32>,
    error: f32,
}

impl<'a> Engine<'a> {
    pub(super) fn new(welded: &'a Welded, options: &'a BatchOptions) -> Self {
        let scaled = scaled_positions(welded);
        let (position_count, scale) = (scaled.0.len(), scaled.1);
        let judge = Judge::new(welded, &options.sequence, scaled);
        let removable = |v: u32| surface::is_manifold(&judge.links, v) && !judge.is_fixed(v);
        let is_removable = (0..position_count as u32).map(removable).collect();
        Self {
            options,
            course: Course::new(welded, scale, judge.is_closed_scan()),
            taste: Taste::new(options, scale),
            choices: vec![None; position_count],
            is_removable,
            changed: (0..position_count as u32).collect(),
            is_changed: vec![true; position_count],
            candidates: Vec::new(),
            selection: Selection::new(position_count),
            was_out_of_date: false,
            ends: Vec::new(),
            error: 0.0,
            judge,
        }
    }

    /// Batch after batch until nothing can be removed, the base is reached, batches get too small or an error limit forbids
    /// to go on.
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
            let stopped = self.do_batch();
            let done = self.course.record.removed.len();
            if done > before {
                self.course.record.errors.resize(done, self.error);
                self.ends.push(done as u32);
            }
            if let Some(stop_reason) = stopped {
                break stop_reason;
            }
            // Positions that were found out of date are judged again before that says anything.
            if done - before < self.options.least_batch.max(1) && !self.was_out_of_date {
                break StopReason::BaseReached;
            }
            let report = Progress { phase: "simplify", done: done as u64, total };
            if progress(report) == ControlFlow::Break(()) {
                return Err(Cancelled.into());
            }
        };
        Ok(Outcome { record: self.course.record, ends: self.ends, stop_reason })
    }

    fn is_base_reached(&self) -> bool {
        self.course.triangle_count <= self.options.sequence.base_triangle_count
    }

    /// Finds the best targets of all whose stars have changed.
    fn judge_changed(&mut self) {
        let changed = std::mem::take(&mut self.changed);
        for &v in &changed {
            self.is_changed[v as usize] = false;
            self.choices[v as usize] = self.choice_of(v, |_| true);
        }
        self.changed = changed;
        self.changed.clear();
    }

    /// The cheapest target of `v` among those that `is_free` admits.
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

    /// One batch; the reason where it is to be the last one.
    fn do_batch(&mut self) -> Option<StopReason> {
        let mut candidates = std::mem::take(&mut self.candidates);
        candidates.clear();
        let costs = self.choices.iter().zip(0..).filter_map(|(choice, v)| Some((choice.as_ref()?.cost, v)));
        candidates.extend(costs);
        keep_cheapest(&mut candidates, self.options.share);
        let dearest = candidates.last().map_or(0.0, |last| last.0);
        self.selection.begin();
        self.selection.bring_forward_lonely(&mut candidates, &self.judge.links);
        self.was_out_of_date = false;
        let mut stopped = None;
        for &(_, v) in &candidates {
            stopped = self.take(v, dearest);
            if stopped.is_some() {
                break;
            }
        }
        self.candidates = candidates;
        stopped
    }

    /// Removes `v` if nothing of the batch stands against it and it costs no more than `dearest`.
    fn take(&mut self, v: u32, dearest: f32) -> Option<StopReason> {
        if !self.selection.is_free(v) {
            return None;
        }
        let choice = self.choice_in_batch(v).filter(|choice| choice.cost <= dearest)?;
        let error = self.course.collapse(&mut self.judge, v, &choice).min(f64::from(f32::MAX)) as f32;
        if self.options.sequence.max_error.is_some_and(|limit| f64::from(error) > limit) {
            self.course.forget_last();
            return Some(StopReason::ErrorLimit);
        }
        self.error = self.error.max(error);
        self.choices[v as usize] = None;
        self.selection.take(choice.target, &self.course.ring);
        self.note_changes(choice.target);
        self.is_base_reached().then_some(StopReason::TargetReached)
    }

    /// The best target of `v` that the batch leaves free.
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

    /// Notes whose star has changed, and who sees the quadric of `u` grow.
    fn note_changes(&mut self, u: u32) {
        let ring = std::mem::take(&mut self.course.ring);
        ring.iter().for_each(|&w| self.note_change(w));
        self.course.ring = ring;
        if matches!(self.judge.memory, Memory::Accumulated(_)) {
            for i in 0..self.judge.links.entries(u).len() {
                self.note_change(self.judge.links.entries(u)[i]);
            }
        }
    }

    fn note_change(&mut self, v: u32) {
        if !std::mem::replace(&mut self.is_changed[v as usize], true) {
            self.changed.push(v);
        }
    }
}
