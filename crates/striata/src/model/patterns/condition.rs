//! Selective refinement: the coarsest set of fragments that satisfies a condition (section 3.4 of \[KG98\]).
//!
//! A condition decides whether the triangles of an overlap are too coarse. Among all valid sets of
//! fragments without triangles that are too coarse, one is contained in all others: if two sets are valid
//! and fine enough, so is their intersection. [`PatternInstance::adapt`] finds it by working upward from
//! the base, through fragments that replace triangles that are too coarse, and their dependencies.

use super::records::UpLink;
use super::rule::NONE;
use super::{PatternInstance, PatternScene, Patterns};
use crate::model::step_bits::StepBits;
use crate::view::{Criterion, Part};

/// Triangles that one fragment creates and another one replaces. If these two overlap in several places,
/// each is an overlap of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// Fragment whose ceiling contains the triangles. `None` if they belong to the base mesh, or if the
    /// upper fragment has no floor; such a fragment is evaluated too, because nothing else could cause it
    /// to be inserted.
    pub lower: Option<u32>,
    /// Fragment whose floor contains the triangles.
    pub upper: u32,
    /// How far the triangles are from what they stand for, in mesh units. If the model does not store errors
    /// of overlaps, the error of the whole floor; if it has no bounds either, infinity.
    pub error: f32,
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
/// fragment, judged by the bounds of the fragment and the error of the overlap.
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
        let part = Part { error: overlap.error, ..self.scene.part(overlap.upper) };
        self.criterion.weigh(&part).should_refine()
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
        for overlap in patterns.base_overlaps() {
            if !wanted.has(overlap.upper) && condition.is_too_coarse(overlap) {
                wanted.insert(overlap.upper);
            }
        }
        // In ascending order, records are read sequentially, and most dependencies are already inserted.
        let mut heads = patterns.records.cursor();
        let mut waiting = Vec::new();
        let mut next = 0;
        while let Some(step) = wanted.first_from(next) {
            next = step + 1;
            waiting.push(step);
            while let Some(step) = waiting.pop() {
                let head = heads.head(step);
                let mut is_founded = true;
                for below in patterns.records.downs(&head) {
                    is_founded &= self.is_refined(below);
                    if !wanted.has(below) {
                        wanted.insert(below);
                        waiting.push(below);
                    }
                }
                let mut visit = |up: UpLink| {
                    if !wanted.has(up.above) && condition.is_too_coarse(patterns.overlap(Some(step), up)) {
                        wanted.insert(up.above);
                        if up.above < next {
                            waiting.push(up.above);
                        }
                    }
                };
                if is_founded && !self.is_refined(step) {
                    self.insert_founded(patterns, step, &head, visit);
                    change.inserted += 1;
                    continue;
                }
                patterns.records.ups(&head).for_each(&mut visit);
                if !is_founded {
                    self.lay_foundation(patterns, step, |_| change.inserted += 1);
                }
            }
        }
        // Everything wanted has been inserted, so there may be nothing to remove.
        if self.split_count() > wanted.count() {
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
        }
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
        let mut base: Vec<Overlap> = patterns.base_overlaps().collect();
        base.sort_by_key(|overlap| overlap.upper);
        let mut floor = Vec::new();
        while let Some(step) = self.last_inserted_before(end) {
            end = step;
            if self.is_covered(patterns, step) {
                continue;
            }
            self.floor_overlaps_into(patterns, step, &base, &mut floor);
            if !floor.iter().any(|&overlap| condition.is_too_coarse(overlap)) {
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
        let mut waiting: Vec<u32> = Vec::new();
        self.for_each_shown_overlap(patterns, |overlap| {
            if condition.is_too_coarse(overlap) {
                waiting.push(overlap.upper);
            }
        });
        let mut fresh = Vec::new();
        while let Some(step) = waiting.pop() {
            self.lay_foundation(patterns, step, |step| fresh.push(step));
            for step in fresh.drain(..) {
                let head = patterns.records.head(step);
                for up in patterns.records.ups(&head) {
                    let overlap = patterns.overlap(Some(step), up);
                    if !self.is_refined(up.above) && condition.is_too_coarse(overlap) {
                        waiting.push(up.above);
                    }
                }
            }
        }
        self.split_count() - before
    }

    /// Calls `visit` with the overlaps of all triangles shown, except for those of the full mesh, and with
    /// fragments without a floor that are not inserted.
    pub(super) fn for_each_shown_overlap(&self, patterns: &Patterns, mut visit: impl FnMut(Overlap)) {
        self.check(patterns);
        let is_shown = |overlap: &Overlap| !self.is_refined(overlap.upper);
        patterns.base_overlaps().filter(is_shown).for_each(&mut visit);
        let mut end = patterns.fragment_count() as u32;
        while let Some(step) = self.last_inserted_before(end) {
            end = step;
            let head = patterns.records.head(step);
            for up in patterns.records.ups(&head).filter(|up| !self.is_refined(up.above)) {
                visit(patterns.overlap(Some(step), up));
            }
        }
    }
}

impl Patterns {
    /// Returns the overlaps of the base mesh, and those of fragments without a floor.
    fn base_overlaps(&self) -> impl Iterator<Item = Overlap> + use<'_> {
        let of_base = self.base.iter().filter(|face| face.above != NONE);
        let of_base = of_base.map(|face| UpLink { above: face.above, code: face.code, error: face.error });
        let floorless = self.floorless.iter().map(|&upper| {
            let error = self.bounds.as_ref().map_or(f32::INFINITY, |bounds| bounds.error(upper));
            Overlap { lower: None, upper, error }
        });
        of_base.map(|up| self.overlap(None, up)).chain(floorless)
    }
}
