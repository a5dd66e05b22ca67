//! Finds the finest level within a triangle budget, refining the parts with the largest weights first.
//!
//! All steps that a front knows are weighed. Collapsed steps wait in one queue, heaviest first; active
//! steps wait in another, lightest first. The heaviest collapsed step is split as long as the budget
//! allows; if it does not, lighter active steps are collapsed to make room. The weight at which the two
//! queues meet is the smallest threshold whose level fits the budget. A front at a given threshold shows
//! the same level regardless of its history, so the search can start from the level of the last view.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::front::{FanFront, FanUpdate};
use super::{FanScene, Fans};
use crate::view::{Criterion, Part, Verdict};

/// Number of steps that are weighed together.
const BATCH_SIZE: usize = 64;

/// The bit pattern of a weight, which sorts like the non-negative weight itself, and a step.
type Weighed = (u32, u32);

/// State of a search for a budget. The queues may contain steps that are not known any more, and steps twice.
struct BudgetSearch {
    /// Collapsed steps with a weight above 1.
    collapsed: BinaryHeap<Weighed>,
    /// Refined steps that are wanted because of their own weight.
    active: BinaryHeap<Reverse<Weighed>>,
    threshold: f32,
    parts: Vec<Part>,
    verdicts: Vec<Verdict>,
}

impl<C: Criterion + Clone> FanFront<C> {
    /// Moves to the finest level that a criterion wants within `triangle_limit` triangles, using the smallest
    /// threshold (at least 1) whose level fits. Shows the base mesh if even that exceeds the limit. Every
    /// known step is evaluated.
    ///
    /// # Panics
    /// If the front belongs to a different model.
    pub fn update_to_budget(
        &mut self,
        scene: &FanScene<'_>,
        criterion: &C,
        triangle_limit: usize,
    ) -> FanUpdate {
        self.forget_views();
        let mut update = self.begin(scene, 1.0);
        let mut search = BudgetSearch {
            collapsed: BinaryHeap::new(),
            active: BinaryHeap::new(),
            threshold: 1.0,
            parts: Vec::new(),
            verdicts: Vec::new(),
        };
        let known = self.expiries.known();
        self.weigh(scene, (criterion, &mut search), &known, &mut update);
        self.weigh_listed(scene, criterion, &mut search, &mut update);
        self.collapse_unneeded(scene.fans, usize::MAX, &mut update);
        while self.triangle_count > triangle_limit
            && self.collapse_lightest(scene.fans, &mut search, &mut update)
        {}
        while let Some(&(weight, step)) = search.collapsed.peek() {
            if f32::from_bits(weight) <= search.threshold {
                break;
            }
            let is_known = self.expiries.is_known(step);
            if self.instance.is_refined(step) || !is_known {
                search.collapsed.pop();
                if is_known {
                    self.set_wanted(scene.fans, step, true);
                }
                self.weigh_listed(scene, criterion, &mut search, &mut update);
                continue;
            }
            if let Some(count) = self.split_within(scene.fans, step, triangle_limit) {
                update.split_count += count;
                search.collapsed.pop();
                self.weigh_listed(scene, criterion, &mut search, &mut update);
                continue;
            }
            let is_lighter = search.active.peek().is_some_and(|&Reverse((lightest, _))| lightest < weight);
            if !(is_lighter && self.collapse_lightest(scene.fans, &mut search, &mut update)) {
                search.threshold = f32::from_bits(weight);
                break;
            }
        }
        self.listed = Vec::new();
        update.is_complete = true;
        update.threshold = search.threshold;
        update
    }

    /// Weighs all steps that have become known, including those that become known in the process.
    fn weigh_listed(
        &mut self,
        scene: &FanScene<'_>,
        criterion: &C,
        search: &mut BudgetSearch,
        update: &mut FanUpdate,
    ) {
        while !self.listed.is_empty() {
            let listed = std::mem::take(&mut self.listed);
            self.weigh(scene, (criterion, search), &listed, update);
        }
    }

    fn weigh(
        &mut self,
        scene: &FanScene<'_>,
        (criterion, search): (&C, &mut BudgetSearch),
        steps: &[u32],
        update: &mut FanUpdate,
    ) {
        for steps in steps.chunks(BATCH_SIZE) {
            search.parts.clear();
            search.parts.extend(steps.iter().map(|&step| scene.part(step)));
            search.verdicts.clear();
            criterion.weigh_all(&search.parts, &mut search.verdicts);
            update.evaluated_count += steps.len();
            for (at, &step) in steps.iter().enumerate() {
                let weight = search.verdicts[at].weight.max(0.0);
                self.enqueue(scene.fans, search, step, weight);
            }
        }
    }

    /// Enters a step into the queue where it belongs according to its weight, if it is still known.
    fn enqueue(&mut self, fans: &Fans, search: &mut BudgetSearch, step: u32, weight: f32) {
        let is_heavy = weight > search.threshold;
        if !self.expiries.is_known(step) {
            return;
        }
        if self.instance.is_refined(step) {
            self.set_wanted(fans, step, is_heavy);
        } else if !is_heavy {
            self.wanted.remove(step);
        }
        match (is_heavy, !self.instance.is_refined(step)) {
            (true, true) => search.collapsed.push((weight.to_bits(), step)),
            (true, false) => search.active.push(Reverse((weight.to_bits(), step))),
            _ => {}
        }
    }

    /// Collapses the lightest step that is active because of its own weight, and everything that only it
    /// needed. Returns whether there was one.
    fn collapse_lightest(&mut self, fans: &Fans, search: &mut BudgetSearch, update: &mut FanUpdate) -> bool {
        let Some(Reverse((weight, step))) = search.active.pop() else { return false };
        if self.expiries.is_known(step) {
            search.threshold = search.threshold.max(f32::from_bits(weight));
            self.set_wanted(fans, step, false);
            self.collapse_unneeded(fans, usize::MAX, update);
        }
        true
    }

    /// Splits a step with all that it needs, unless that exceeds the budget; returns the number of steps
    /// split.
    fn split_within(&mut self, fans: &Fans, step: u32, triangle_limit: usize) -> Option<usize> {
        let mut split_steps = Vec::new();
        self.instance.split_into(fans, step, &mut split_steps);
        let added: isize = split_steps.iter().map(|&step| fans.added.of(step)).sum();
        split_steps.iter().for_each(|&step| self.instance.collapsed.insert(step));
        (self.triangle_count.saturating_add_signed(added) <= triangle_limit).then(|| {
            self.wanted.insert(step);
            self.split(fans, step, usize::MAX)
        })
    }
}
