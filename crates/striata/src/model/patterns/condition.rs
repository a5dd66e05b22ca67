//! Selective refinement: the coarsest set of fragments that satisfies a condition (section 3.4 of \[KG98\]).
//!
//! A condition decides whether the triangles of an overlap are too coarse. Among all valid sets of
//! fragments without triangles that are too coarse, one is contained in all others: if two sets are valid
//! and fine enough, so is their intersection. [`PatternInstance::adapt`] finds it by working upward from
//! the base, through fragments that replace triangles that are too coarse, and their dependencies.

use super::{PatternInstance, PatternScene, Patterns};
use crate::model::step_bits::StepBits;
use crate::view::Criterion;

/// The triangles that one fragment creates and another one replaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overlap {
    /// Fragment whose ceiling contains the triangles. `None` if they belong to the base mesh, or if the
    /// upper fragment has no floor; such a fragment is evaluated too, because nothing else could cause it
    /// to be inserted.
    pub lower: Option<u32>,
    /// Fragment whose floor contains the triangles.
    pub upper: u32,
}

/// Decides which overlaps are too coarse. Any function of an overlap is a condition; to select fragments,
/// consider only `upper`.
pub trait Condition {
    /// Whether the triangles of an overlap are too coarse, so that the upper fragment must be inserted.
    fn is_too_coarse(&self, overlap: Overlap) -> bool;
}

impl<F: Fn(Overlap) -> bool> Condition for F {
    fn is_too_coarse(&self, overlap: Overlap) -> bool {
        self(overlap)
    }
}

/// A condition derived from a view criterion: an overlap is too coarse if the criterion wants its upper
/// fragment.
#[derive(Clone, Copy, Debug)]
pub struct CriterionCondition<'a, C> {
    scene: PatternScene<'a>,
    criterion: &'a C,
}

impl<'a, C: Criterion> CriterionCondition<'a, C> {
    /// Combines a scene with a view criterion.
    pub fn new(scene: PatternScene<'a>, criterion: &'a C) -> Self {
        Self { scene, criterion }
    }
}

impl<C: Criterion> Condition for CriterionCondition<'_, C> {
    fn is_too_coarse(&self, overlap: Overlap) -> bool {
        self.criterion.weigh(&self.scene.part(overlap.upper)).should_refine()
    }
}

/// Summary of what an instance changed to satisfy a condition.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PatternChange {
    /// Number of fragments inserted.
    pub inserted: usize,
    /// Number of fragments removed.
    pub removed: usize,
}

impl PatternInstance {
    /// Moves to the smallest valid set that satisfies a condition, regardless of the current set.
    ///
    /// # Panics
    /// If the instance belongs to a different model.
    pub fn adapt(&mut self, patterns: &Patterns, condition: &impl Condition) -> PatternChange {
        self.check(patterns);
        let mut change = PatternChange::default();
        let mut wanted = StepBits::none(patterns.fragment_count());
        for above in patterns.above_base() {
            if !wanted.has(above) && condition.is_too_coarse(Overlap { lower: None, upper: above }) {
                wanted.insert(above);
            }
        }
        // In ascending order, records are read sequentially, and most dependencies are already inserted.
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
                for link in 0..patterns.sharings.link_count(head.sharing) {
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
        // Fragments that depend on this one are younger, so they have been removed before.
        let mut end = patterns.fragment_count() as u32;
        while let Some(step) = self.last_inserted_before(end) {
            if !wanted.has(step) {
                self.remove_top(patterns, step);
                change.removed += 1;
            }
            end = step;
        }
        self.compact();
        change
    }

    /// Removes fragments on which no other depends and whose floor is not too coarse, youngest first, until
    /// there is none left: the first half of the paper's algorithm. Returns the number of fragments removed.
    ///
    /// Fragments that keep each other alive remain: those that are only wanted because of triangles that
    /// are not needed themselves. There are none if the condition never rejects a triangle without also
    /// rejecting those that it replaced.
    ///
    /// # Panics
    /// If the instance belongs to a different model.
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
        self.compact();
        before - self.split_count()
    }

    /// Inserts fragments, and those that they depend on, until no current triangle is too coarse: the
    /// second half of the paper's algorithm. Returns the number of fragments inserted.
    ///
    /// # Panics
    /// If the instance belongs to a different model.
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
    /// Returns fragments whose floor contains base triangles, possibly repeated, and those without a floor.
    fn above_base(&self) -> impl Iterator<Item = u32> + use<'_> {
        let of_base = self.base.iter().map(|face| face.above).filter(|&above| above != super::rule::NONE);
        of_base.chain(self.floorless.iter().copied())
    }
}
