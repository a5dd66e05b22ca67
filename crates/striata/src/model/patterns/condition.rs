//! Selective refinement: the coarsest set of fragments that satisfies a condition (section 3.4 of \[KG98\]).
//!
//! A condition says of an overlap whether its triangles are too coarse. Of all sets of fragments that stand, and in which no
//! triangle is too coarse, one is contained in all others: if two sets stand and are fine enough, so is what they have in
//! common. [`PatternInstance::adapt`] finds it by going up from the base, over what is too coarse and over what that stands on.

use super::{PatternInstance, PatternScene, Patterns};
use crate::model::step_bits::StepBits;
use crate::view::Criterion;

/// The triangles that one fragment makes and another replaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overlap {
    /// The fragment whose ceiling they are in; none: they are of the base, or the upper fragment has no floor, and is
    /// asked for so that it can come at all.
    pub lower: Option<u32>,
    /// The fragment whose floor they are in.
    pub upper: u32,
}

/// Says what is too coarse. Any function of an overlap is a condition; one of fragments looks at `upper` alone.
pub trait Condition {
    /// Whether the triangles of an overlap must not be shown, so that the upper fragment has to be inserted.
    fn is_too_coarse(&self, overlap: Overlap) -> bool;
}

impl<F: Fn(Overlap) -> bool> Condition for F {
    fn is_too_coarse(&self, overlap: Overlap) -> bool {
        self(overlap)
    }
}

/// A criterion of views as a condition: fragments that it wants.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a, C> {
    scene: PatternScene<'a>,
    criterion: &'a C,
}

impl<'a, C: Criterion> Wanted<'a, C> {
    /// What a criterion wants of a scene.
    pub fn new(scene: PatternScene<'a>, criterion: &'a C) -> Self {
        Self { scene, criterion }
    }
}

impl<C: Criterion> Condition for Wanted<'_, C> {
    fn is_too_coarse(&self, overlap: Overlap) -> bool {
        self.criterion.weigh(&self.scene.part(overlap.upper)).should_refine()
    }
}

/// What an instance did to satisfy a condition.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PatternChange {
    /// Fragments that were inserted.
    pub inserted: usize,
    /// Fragments that were removed.
    pub removed: usize,
}

impl PatternInstance {
    /// Goes to the smallest set that satisfies a condition, whatever is there before.
    ///
    /// # Panics
    /// If the instance is of another model.
    pub fn adapt(&mut self, patterns: &Patterns, condition: &impl Condition) -> PatternChange {
        self.check(patterns);
        let mut change = PatternChange::default();
        let mut wanted = StepBits::none(patterns.fragment_count());
        for above in patterns.above_base() {
            if !wanted.has(above) && condition.is_too_coarse(Overlap { lower: None, upper: above }) {
                wanted.insert(above);
            }
        }
        // By number: records are read as they stand in memory, and what a fragment stands on is mostly there.
        let mut waiting = Vec::new();
        let mut next = 0;
        while let Some(step) = wanted.first_from(next) {
            next = step + 1;
            waiting.push(step);
            while let Some(step) = waiting.pop() {
                let head = patterns.records.head(step);
                for below in patterns.down(&head) {
                    if !wanted.has(below) {
                        wanted.insert(below);
                        waiting.push(below);
                    }
                }
                if !self.is_refined(step) {
                    self.lay_foundation(patterns, step, |_| change.inserted += 1);
                }
                for link in 0..patterns.ways.link_count(head.way) {
                    let (upper, _) = patterns.records.up(&head, link);
                    if !wanted.has(upper) && condition.is_too_coarse(Overlap { lower: Some(step), upper }) {
                        wanted.insert(upper);
                        if upper < next {
                            waiting.push(upper);
                        }
                    }
                }
            }
        }
        // Whatever stands on a fragment is younger, so it has gone before.
        let mut end = patterns.fragment_count() as u32;
        while let Some(step) = self.last_inserted_before(end) {
            if !wanted.has(step) {
                self.remove_top(patterns, step);
                change.removed += 1;
            }
            end = step;
        }
        self.tidy();
        change
    }

    /// Removes fragments, the youngest first, on which nothing stands and below which nothing is too coarse, until none is
    /// left: the first half of the paper's algorithm. Returns how many.
    ///
    /// Fragments that hold each other stay: one that is wanted only by triangles which themselves are not needed.
    /// With a condition that never calls a triangle too coarse unless those that it replaced are, there are none.
    ///
    /// # Panics
    /// If the instance is of another model.
    pub fn coarsen(&mut self, patterns: &Patterns, condition: &impl Condition) -> usize {
        self.check(patterns);
        let before = self.split_count();
        let mut end = patterns.fragment_count() as u32;
        let mut makers = Vec::new();
        while let Some(step) = self.last_inserted_before(end) {
            end = step;
            if self.is_covered(patterns, step) {
                continue;
            }
            self.floor_makers_into(patterns, step, &mut makers);
            let is_wanted = |&lower: &Option<u32>| condition.is_too_coarse(Overlap { lower, upper: step });
            if !makers.iter().any(is_wanted) {
                self.remove_top(patterns, step);
            }
        }
        self.tidy();
        before - self.split_count()
    }

    /// Inserts fragments, and what they stand on, until no triangle that is there is too coarse: the second half of the paper's
    /// algorithm. Returns how many.
    ///
    /// # Panics
    /// If the instance is of another model.
    pub fn refine(&mut self, patterns: &Patterns, condition: &impl Condition) -> usize {
        self.check(patterns);
        let before = self.split_count();
        let too_coarse = |lower, upper| condition.is_too_coarse(Overlap { lower, upper });
        let mut waiting: Vec<u32> = patterns.above_base().filter(|&step| too_coarse(None, step)).collect();
        let mut end = patterns.fragment_count() as u32;
        while let Some(step) = self.last_inserted_before(end) {
            end = step;
            patterns.for_each_above(step, |above| {
                if !self.is_refined(above) && too_coarse(Some(step), above) {
                    waiting.push(above);
                }
            });
        }
        let mut fresh = Vec::new();
        while let Some(step) = waiting.pop() {
            self.lay_foundation(patterns, step, |step| fresh.push(step));
            for step in fresh.drain(..) {
                patterns.for_each_above(step, |above| {
                    if !self.is_refined(above) && too_coarse(Some(step), above) {
                        waiting.push(above);
                    }
                });
            }
        }
        self.split_count() - before
    }
}

impl Patterns {
    /// Fragments whose floor has triangles of the base, some of them several times, and those that have no floor.
    fn above_base(&self) -> impl Iterator<Item = u32> + use<'_> {
        let of_base = self.base.iter().map(|face| face.above).filter(|&above| above != super::rule::NONE);
        of_base.chain(self.unfounded.iter().copied())
    }
}
