//! An instance: the set of inserted fragments and the current triangles.
//!
//! Every triangle is in a list: that of the step that would replace it or, if it is part of the full mesh,
//! that of the step that created it. So when a step can be inserted, its list is exactly its floor, and no
//! adjacency has to be maintained. Each list entry stores where in the rule's floor its triangle belongs.
//! The corners of a triangle begin with the youngest, so this identifies its vertices too.

use super::Patterns;
use super::overlaps::run_location;
use super::records::UpLink;
use super::rule::NONE;
use crate::model::step_bits::StepBits;

/// A current triangle, or a free slot.
#[derive(Clone, Copy, Debug)]
pub(super) struct PatternSlot {
    /// Vertices, youngest first; [`NONE`] in a free slot.
    pub corners: [u32; 3],
    /// Next triangle of the same list, or next free slot.
    pub next: u32,
    /// Location in the floor above, or index in the ceiling for a triangle of the full mesh.
    pub location: u32,
}

/// Smaller arrays are not compacted.
const MIN_COMPACTED: usize = 1024;

/// An instance of the model: a valid set of inserted fragments and the triangles that it shows.
///
/// Two instances are equal if the same fragments are inserted.
#[derive(Clone, Debug)]
pub struct PatternInstance {
    pub(super) inserted: StepBits,
    pub(super) split_count: usize,
    /// First triangle of each step's list, plus 1; 0 for an empty list. Zeros need no initialization.
    pub(super) heads: Vec<u32>,
    pub(super) slots: Vec<PatternSlot>,
    /// Group of each slot's triangle; empty if the model has only one group.
    pub(super) groups: Vec<u32>,
    pub(super) free: u32,
    pub(super) triangle_count: usize,
    pub(super) scratch: InstanceScratch,
}

#[derive(Clone, Debug, Default)]
pub(super) struct InstanceScratch {
    pub locals: Vec<u32>,
    pub links: Vec<UpLink>,
    pub shared: Vec<SharedTriangle>,
    pub waiting: Vec<u32>,
}

/// A ceiling triangle that some fragment can replace, and its location in the floor of that fragment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct SharedTriangle {
    pub above: u32,
    pub half_edge: u32,
    /// Index of the triangle in the ceiling.
    pub triangle: u32,
}

impl PartialEq for PatternInstance {
    fn eq(&self, other: &Self) -> bool {
        self.inserted == other.inserted
    }
}

impl Eq for PatternInstance {}

impl PatternInstance {
    /// Returns an instance that shows the base mesh.
    pub fn base(patterns: &Patterns) -> Self {
        let step_count = patterns.records.step_count;
        let mut instance = Self {
            inserted: StepBits::none(step_count),
            split_count: 0,
            heads: vec![0; step_count],
            slots: Vec::with_capacity(patterns.base.len()),
            groups: Vec::new(),
            free: NONE,
            triangle_count: 0,
            scratch: InstanceScratch::default(),
        };
        for face in &patterns.base {
            let slot = instance.add_triangle(patterns, face.corners, face.group);
            if face.above != NONE {
                instance.list(face.above, slot, run_location(face.code, 0));
            }
        }
        instance
    }

    /// Returns an instance that shows the full mesh.
    pub fn full(patterns: &Patterns) -> Self {
        let mut instance = Self::base(patterns);
        for step in 0..patterns.records.step_count as u32 {
            instance.insert_next(patterns, step);
        }
        instance
    }

    /// Whether a fragment is inserted, that is, the position that its step restores is active.
    ///
    /// # Panics
    /// If the step does not exist.
    #[inline]
    pub fn is_refined(&self, step: u32) -> bool {
        self.inserted.has(step)
    }

    /// Number of inserted fragments.
    pub fn split_count(&self) -> usize {
        self.split_count
    }

    /// Number of current triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangle_count
    }

    /// Number of bytes that the instance owns.
    pub fn bytes(&self) -> usize {
        self.inserted.bytes()
            + size_of_val(&self.heads[..])
            + size_of_val(&self.slots[..])
            + size_of_val(&self.groups[..])
    }

    /// Inserts a fragment and everything that it depends on; returns the number of fragments inserted.
    /// This is `lay_foundation` of \[KG98\] without recursion.
    ///
    /// # Panics
    /// If the step does not exist, or the instance belongs to a different model.
    pub fn insert(&mut self, patterns: &Patterns, step: u32) -> usize {
        self.check(patterns);
        let before = self.split_count;
        self.lay_foundation(patterns, step, |_| ());
        self.split_count - before
    }

    /// Removes a fragment and everything that depends on it; returns the number of fragments removed.
    ///
    /// # Panics
    /// If the step does not exist, or the instance belongs to a different model.
    pub fn remove(&mut self, patterns: &Patterns, step: u32) -> usize {
        self.check(patterns);
        let before = self.split_count;
        let mut waiting = vec![step];
        while let Some(&step) = waiting.last() {
            if !self.inserted.has(step) {
                waiting.pop();
                continue;
            }
            let known = waiting.len();
            patterns.for_each_above(step, |above| {
                if self.inserted.has(above) {
                    waiting.push(above);
                }
            });
            if waiting.len() == known {
                waiting.pop();
                self.remove_top(patterns, step);
            }
        }
        self.compact();
        before - self.split_count
    }

    /// Appends the current triangles, in unspecified order.
    pub fn triangles_into(&self, out: &mut Vec<[u32; 3]>) {
        out.reserve(self.triangle_count);
        out.extend(self.slots.iter().map(|slot| slot.corners).filter(|corners| corners[0] != NONE));
    }

    /// Appends the current triangles of one group.
    pub fn group_triangles_into(&self, group: u32, out: &mut Vec<[u32; 3]>) {
        if self.groups.is_empty() {
            if group == 0 {
                self.triangles_into(out);
            }
            return;
        }
        let of_group = self
            .slots
            .iter()
            .zip(&self.groups)
            .filter(|(slot, own)| slot.corners[0] != NONE && **own == group);
        out.extend(of_group.map(|(slot, _)| slot.corners));
    }

    /// Compacts the slots and releases memory once most slots are free.
    pub(super) fn compact(&mut self) {
        if self.slots.len() < MIN_COMPACTED || self.triangle_count > self.slots.len() / 4 {
            return;
        }
        let mut moved = vec![NONE; self.slots.len()];
        let mut live = 0;
        for (to, slot) in moved.iter_mut().zip(&self.slots) {
            if slot.corners[0] != NONE {
                *to = live;
                live += 1;
            }
        }
        let renumber = |slot: u32| if slot == NONE { NONE } else { moved[slot as usize] };
        self.heads.iter_mut().filter(|head| **head != 0).for_each(|head| *head = renumber(*head - 1) + 1);
        let mut from = moved.iter();
        if !self.groups.is_empty() {
            self.groups.retain(|_| *from.next().expect("a group for each slot") != NONE);
            self.groups.shrink_to_fit();
        }
        self.slots.retain_mut(|slot| {
            slot.next = renumber(slot.next);
            slot.corners[0] != NONE
        });
        self.slots.shrink_to_fit();
        self.free = NONE;
    }

    pub(super) fn check(&self, patterns: &Patterns) {
        assert_eq!(
            self.heads.len(),
            patterns.records.step_count,
            "the instance belongs to a different model"
        );
    }

    /// Returns the last inserted step before `end`.
    pub(super) fn last_inserted_before(&self, end: u32) -> Option<u32> {
        self.inserted.last_before(end)
    }

    /// Whether any fragment that depends on a step is inserted.
    pub(super) fn is_covered(&self, patterns: &Patterns, step: u32) -> bool {
        let head = patterns.records.head(step);
        patterns.records.ups(&head).any(|up| self.inserted.has(up.above))
    }

    /// Inserts a step and everything that it depends on; calls `inserted` for each inserted step.
    pub(super) fn lay_foundation(&mut self, patterns: &Patterns, step: u32, mut inserted: impl FnMut(u32)) {
        let mut waiting = std::mem::take(&mut self.scratch.waiting);
        waiting.push(step);
        while let Some(&step) = waiting.last() {
            if self.inserted.has(step) {
                waiting.pop();
                continue;
            }
            let known = waiting.len();
            let head = patterns.records.head(step);
            waiting.extend(patterns.records.downs(&head).filter(|&below| !self.inserted.has(below)));
            if waiting.len() == known {
                waiting.pop();
                self.insert_founded(patterns, step, &head, |_| ());
                inserted(step);
            }
        }
        self.scratch.waiting = waiting;
    }

    /// Inserts a step whose floor is complete.
    pub(super) fn insert_next(&mut self, patterns: &Patterns, step: u32) {
        let head = patterns.records.head(step);
        self.insert_founded(patterns, step, &head, |_| ());
    }
}
