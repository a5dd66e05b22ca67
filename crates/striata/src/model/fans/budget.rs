//! The greatest detail that a number of triangles allows: the parts that weigh most, in their order.
//!
//! Everything in a front's list is weighed. What is missing waits by its weight, the largest first; what is there by its own, the
//! smallest first. The largest that is missing is put in as long as there is room; where there is none, the smallest that is
//! there makes it, if it weighs less. Where the two meet is the least threshold whose level fits, and a level of one
//! threshold is what a front shows anyway: so nothing is left of the way, and it starts where the last view ended.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::front::{FanFront, FanUpdate};
use super::{FanScene, Fans};
use crate::view::{Criterion, Part, Verdict};

/// A weight, as a number that is ordered as weights are, and a place in the list.
type Weighed = (u32, u32);

/// What a search for a budget looks at.
struct Search {
    /// Steps that are taken and weigh more than 1.
    missing: BinaryHeap<Weighed>,
    /// Steps that are there because of their weight.
    there: BinaryHeap<Reverse<Weighed>>,
    /// Weights of the list.
    weights: Vec<f32>,
    threshold: f32,
    parts: Vec<Part>,
    verdicts: Vec<Verdict>,
}

impl<C: Criterion + Clone> FanFront<C> {
    /// Goes to the finest level of what a criterion wants that has no more triangles than `triangle_limit`: of all thresholds
    /// over 1 the least whose level fits. Where even the base has more, that is shown. Weighs everything that is there.
    ///
    /// # Panics
    /// If the front is of another model.
    pub fn update_to_budget(
        &mut self,
        scene: &FanScene<'_>,
        criterion: &C,
        triangle_limit: usize,
    ) -> FanUpdate {
        self.forget_views();
        let mut update = self.begin(scene, 1.0);
        let mut search = Search {
            missing: BinaryHeap::new(),
            there: BinaryHeap::new(),
            weights: Vec::new(),
            threshold: 1.0,
            parts: Vec::new(),
            verdicts: Vec::new(),
        };
        self.weigh_new(scene, criterion, &mut search, &mut update);
        self.take_unneeded(scene.fans, usize::MAX, &mut update);
        while self.triangle_count > triangle_limit && self.take_lightest(scene.fans, &mut search, &mut update)
        {
        }
        while let Some(&(weight, at)) = search.missing.peek() {
            let step = self.steps[at as usize];
            if f32::from_bits(weight) <= search.threshold {
                break;
            }
            if self.instance.is_refined(step) {
                self.hear(scene.fans, step, true);
                search.missing.pop();
                self.weigh_new(scene, criterion, &mut search, &mut update);
                continue;
            }
            if let Some(count) = self.split_within(scene.fans, step, triangle_limit) {
                update.split_count += count;
                search.missing.pop();
                self.weigh_new(scene, criterion, &mut search, &mut update);
                continue;
            }
            let is_lighter = search.there.peek().is_some_and(|&Reverse((lightest, _))| lightest < weight);
            if !(is_lighter && self.take_lightest(scene.fans, &mut search, &mut update)) {
                search.threshold = f32::from_bits(weight);
                break;
            }
        }
        update.is_settled = true;
        update.threshold = search.threshold;
        update
    }

    /// Weighs what has come to the list, and what comes to it by that.
    fn weigh_new(
        &mut self,
        scene: &FanScene<'_>,
        criterion: &C,
        search: &mut Search,
        update: &mut FanUpdate,
    ) {
        while search.weights.len() < self.steps.len() {
            let first = search.weights.len();
            search.parts.clear();
            search.parts.extend(self.steps[first..].iter().map(|&step| scene.part(step)));
            search.verdicts.clear();
            criterion.weigh_all(&search.parts, &mut search.verdicts);
            update.asked_count += search.parts.len();
            for at in first..self.steps.len().min(first + search.parts.len()) {
                let weight = search.verdicts[at - first].weight.max(0.0);
                search.weights.push(weight);
                self.place_in(scene.fans, search, at as u32, weight);
            }
        }
    }

    /// Puts a step of the list where its weight has it.
    fn place_in(&mut self, fans: &Fans, search: &mut Search, at: u32, weight: f32) {
        let step = self.steps[at as usize];
        let is_heavy = weight > search.threshold;
        if self.instance.is_refined(step) {
            self.hear(fans, step, is_heavy);
        } else if !is_heavy {
            self.wanted.remove(step);
        }
        match (is_heavy, !self.instance.is_refined(step)) {
            (true, true) => search.missing.push((weight.to_bits(), at)),
            (true, false) => search.there.push(Reverse((weight.to_bits(), at))),
            _ => {}
        }
    }

    /// Takes what weighs least of all that is there because of its weight, and what only that needed; whether there is such.
    fn take_lightest(&mut self, fans: &Fans, search: &mut Search, update: &mut FanUpdate) -> bool {
        let Some(Reverse((weight, at))) = search.there.pop() else { return false };
        search.threshold = search.threshold.max(f32::from_bits(weight));
        self.hear(fans, self.steps[at as usize], false);
        self.take_unneeded(fans, usize::MAX, update);
        true
    }

    /// Undoes a step with what it needs, unless there are then too many triangles; returns how many steps that were.
    fn split_within(&mut self, fans: &Fans, step: u32, triangle_limit: usize) -> Option<usize> {
        let mut undone = Vec::new();
        self.instance.split_into(fans, step, &mut undone);
        let added: usize = undone.iter().map(|&step| usize::from(fans.removed[step as usize])).sum();
        undone.iter().for_each(|&step| self.instance.taken.insert(step));
        (self.triangle_count + added <= triangle_limit).then(|| {
            self.wanted.insert(step);
            self.split(fans, step, usize::MAX)
        })
    }
}
