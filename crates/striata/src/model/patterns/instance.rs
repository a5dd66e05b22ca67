//! An instance: the set of inserted fragments and the current triangles.
//!
//! Every triangle is in a list: that of the step that would replace it or, if it is part of the full mesh,
//! that of the step that created it. So when a step can be inserted, its list is exactly its floor, and no
//! adjacency has to be maintained. Each list entry stores where in the rule's floor its triangle belongs.
//! The corners of a triangle begin with the youngest, so this identifies its vertices too.

use super::overlaps::Share;
use super::records::Head;
use super::rule::{NONE, first_corner};
use super::rule_table::RuleRef;
use super::{Patterns, pack_floor_location, unpack_floor_location};
use crate::model::step_bits::StepBits;

/// A current triangle, or a free slot.
#[derive(Clone, Copy, Debug)]
struct Slot {
    /// Vertices, youngest first; [`NONE`] in a free slot.
    corners: [u32; 3],
    /// Next triangle of the same list, or next free slot.
    next: u32,
    /// Location in the floor above, see [`pack_floor_location`]; for a triangle of the full mesh, its
    /// index in its ceiling.
    location: u32,
}

/// Smaller arrays are not compacted.
const MIN_COMPACTED: usize = 1024;

/// An instance of the model: a valid set of inserted fragments and the triangles that it shows.
///
/// Two instances are equal if the same fragments are inserted.
#[derive(Clone, Debug)]
pub struct PatternInstance {
    inserted: StepBits,
    split_count: usize,
    /// First triangle of each step's list.
    heads: Vec<u32>,
    slots: Vec<Slot>,
    /// Group of each slot's triangle; empty if the model has only one group.
    groups: Vec<u32>,
    free: u32,
    triangle_count: usize,
    scratch: Scratch,
}

#[derive(Clone, Debug, Default)]
struct Scratch {
    locals: Vec<u32>,
    links: Vec<(u32, u32)>,
    shared: Vec<Shared>,
    waiting: Vec<u32>,
}

/// A ceiling triangle that some fragment can replace, and its location in the floor of that fragment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Shared {
    above: u32,
    half_edge: u32,
    /// Index of the triangle in the ceiling.
    triangle: u32,
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
            heads: vec![NONE; step_count],
            slots: Vec::with_capacity(patterns.base.len()),
            groups: Vec::new(),
            free: NONE,
            triangle_count: 0,
            scratch: Scratch::default(),
        };
        for face in &patterns.base {
            let slot = instance.add_triangle(patterns, face.corners, face.group);
            if face.above != NONE {
                instance.list(face.above, slot, pack_floor_location(face.half_edge, 0));
            }
        }
        instance
    }

    /// Returns an instance that shows the full mesh.
    pub fn full(patterns: &Patterns) -> Self {
        let mut instance = Self::base(patterns);
        for step in 0..patterns.records.step_count as u32 {
            instance.insert_supported(patterns, step);
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
        self.heads.iter_mut().for_each(|head| *head = renumber(*head));
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
        (0..patterns.sharings.link_count(head.sharing))
            .any(|link| self.inserted.has(patterns.records.up(&head, link).0))
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
            let missing = patterns.down(&head).filter(|&below| !self.inserted.has(below));
            waiting.extend(missing);
            if waiting.len() == known {
                waiting.pop();
                self.insert_supported(patterns, step);
                inserted(step);
            }
        }
        self.scratch.waiting = waiting;
    }

    /// Inserts a step whose floor is complete, replacing the floor's triangles by those of the ceiling.
    pub(super) fn insert_supported(&mut self, patterns: &Patterns, step: u32) {
        let head = patterns.records.head(step);
        let rule = patterns.rules.rule(head.rule);
        let mut scratch = std::mem::take(&mut self.scratch);
        scratch.start(patterns, step, &rule);
        let mut slot = std::mem::replace(&mut self.heads[step as usize], NONE);
        while slot != NONE {
            let Slot { corners, next, location, .. } = self.slots[slot as usize];
            let (half_edge, along) = unpack_floor_location(location);
            let half_edge = rule.around(half_edge, along).expect("a run continues around its vertex");
            scratch.set(rotated(rule.floor(half_edge as usize / 3), half_edge % 3), corners);
            self.release(slot);
            slot = next;
        }
        scratch.load_links(patterns, &head);
        for s in 0..rule.ceiling_count() {
            let corners = rule.ceiling(s).map(|local| scratch.locals[local as usize]);
            let slot = self.add_triangle(patterns, corners, rule.group(s));
            let share = patterns.sharings.share(head.sharing, s);
            if share.link == Share::FULL {
                self.list(step, slot, s as u32);
            } else {
                let (above, half_edge) = scratch.links[share.link as usize];
                self.list(above, slot, pack_floor_location(half_edge, share.offset));
            }
        }
        self.scratch = scratch;
        self.inserted.insert(step);
        self.split_count += 1;
    }

    /// Removes a step on which no other depends, replacing the ceiling's triangles by those of the floor.
    pub(super) fn remove_top(&mut self, patterns: &Patterns, step: u32) {
        let head = patterns.records.head(step);
        let rule = patterns.rules.rule(head.rule);
        let mut scratch = std::mem::take(&mut self.scratch);
        self.read_ceiling(patterns, (step, &head), &mut scratch, true);
        for j in 0..rule.floor_count() {
            let corners = rule.floor(j).map(|local| scratch.locals[local as usize]);
            let youngest = corners[0].max(corners[1]).max(corners[2]);
            let corner = corners.iter().position(|&v| v == youngest).unwrap_or(0);
            let group = rule.group(rule.ceiling_count() + j);
            let slot = self.add_triangle(patterns, first_corner(corners, youngest), group);
            self.list(step, slot, pack_floor_location((3 * j + corner) as u32, 0));
        }
        self.scratch = scratch;
        self.inserted.remove(step);
        self.split_count -= 1;
    }

    /// Finds the steps that create the floor of an inserted step on which no other depends: `None` for the
    /// base mesh and if there is no floor. A step may be listed several times.
    pub(super) fn floor_makers_into(&mut self, patterns: &Patterns, step: u32, out: &mut Vec<Option<u32>>) {
        let head = patterns.records.head(step);
        let mut scratch = std::mem::take(&mut self.scratch);
        self.read_ceiling(patterns, (step, &head), &mut scratch, false);
        out.clear();
        let rule = patterns.rules.rule(head.rule);
        if rule.floor_count() == 0 {
            out.push(None);
        }
        for j in 0..rule.floor_count() {
            let [a, b, c] = rule.floor(j).map(|local| scratch.locals[local as usize]);
            let youngest = a.max(b).max(c);
            let is_base = youngest < patterns.vertices.base_vertex_count;
            out.push((!is_base).then(|| patterns.vertices.step_of(youngest) as u32));
        }
        self.scratch = scratch;
    }

    /// Reads the vertices of a complete ceiling from its triangles, and optionally removes these.
    fn read_ceiling(
        &mut self,
        patterns: &Patterns,
        (step, head): (u32, &Head),
        scratch: &mut Scratch,
        remove: bool,
    ) {
        let rule = patterns.rules.rule(head.rule);
        scratch.start(patterns, step, &rule);
        let mut slot = self.heads[step as usize];
        while slot != NONE {
            let Slot { corners, next, location, .. } = self.slots[slot as usize];
            scratch.set(rule.ceiling(location as usize), corners);
            if remove {
                self.release(slot);
            }
            slot = next;
        }
        if remove {
            self.heads[step as usize] = NONE;
        }
        scratch.load_shared(patterns, head);
        let shared = std::mem::take(&mut scratch.shared);
        for own in shared.chunk_by(|a, b| a.above == b.above) {
            self.read_above(patterns, own, remove, |triangle, corners| {
                scratch.set(rule.ceiling(triangle as usize), corners);
            });
        }
        scratch.shared = shared;
    }

    /// Reads those triangles of a ceiling that are in the list of one step above.
    fn read_above(
        &mut self,
        patterns: &Patterns,
        own: &[Shared],
        remove: bool,
        mut visit: impl FnMut(u32, [u32; 3]),
    ) {
        let above = own[0].above;
        let floor = patterns.rules.rule(patterns.records.head(above).rule);
        let (mut slot, mut before) = (self.heads[above as usize], NONE);
        let mut left = own.len();
        while slot != NONE && left > 0 {
            let Slot { corners, next, location, .. } = self.slots[slot as usize];
            let (from, along) = unpack_floor_location(location);
            let at = floor.around(from, along);
            let found = own.binary_search_by_key(&at, |shared| Some(shared.half_edge));
            if let Ok(found) = found {
                visit(own[found].triangle, corners);
                left -= 1;
            }
            if found.is_ok() && remove {
                match before {
                    NONE => self.heads[above as usize] = next,
                    before => self.slots[before as usize].next = next,
                }
                self.release(slot);
            } else {
                before = slot;
            }
            slot = next;
        }
    }

    /// Stores a triangle in a free slot, and returns the slot.
    fn add_triangle(&mut self, patterns: &Patterns, corners: [u32; 3], group: u32) -> u32 {
        self.triangle_count += 1;
        let slot = Slot { corners, next: NONE, location: 0 };
        let at = if self.free == NONE {
            self.slots.push(slot);
            if patterns.group_count > 1 {
                self.groups.push(group);
            }
            return self.slots.len() as u32 - 1;
        } else {
            self.free
        };
        self.free = self.slots[at as usize].next;
        self.slots[at as usize] = slot;
        if patterns.group_count > 1 {
            self.groups[at as usize] = group;
        }
        at
    }

    fn release(&mut self, slot: u32) {
        self.triangle_count -= 1;
        self.slots[slot as usize] = Slot { corners: [NONE; 3], next: self.free, location: 0 };
        self.free = slot;
    }

    /// Adds a triangle to the list of a step.
    #[inline]
    fn list(&mut self, step: u32, slot: u32, location: u32) {
        let head = &mut self.heads[step as usize];
        let entry = &mut self.slots[slot as usize];
        entry.next = std::mem::replace(head, slot);
        entry.location = location;
    }
}

impl Scratch {
    /// Sets the vertices that a step restores and its extra vertices.
    fn start(&mut self, patterns: &Patterns, step: u32, rule: &RuleRef<'_>) {
        self.locals.clear();
        self.locals.extend(patterns.vertices.of_step(step as usize));
        self.locals.resize(rule.local_count(), 0);
        let mut extras = rule.extras().peekable();
        if extras.peek().is_some() {
            for (local, &vertex) in extras.zip(patterns.extras.of_step(step)) {
                self.locals[local as usize] = vertex;
            }
        }
    }

    fn load_links(&mut self, patterns: &Patterns, head: &Head) {
        self.links.clear();
        patterns.links_into(head, &mut self.links);
    }

    /// Finds where the triangles of a ceiling go, sorted, so that each list above is traversed only once.
    fn load_shared(&mut self, patterns: &Patterns, head: &Head) {
        self.load_links(patterns, head);
        self.shared.clear();
        let mut floor_of = (NONE, None);
        for (share, triangle) in patterns.sharings.shares(head.sharing).zip(0..) {
            if share.link == Share::FULL {
                continue;
            }
            let (above, first) = self.links[share.link as usize];
            let floor = match floor_of {
                (step, Some(floor)) if step == above => floor,
                _ => patterns.rules.rule(patterns.records.head(above).rule),
            };
            floor_of = (above, Some(floor));
            let half_edge = floor.around(first, share.offset).expect("a run continues around its vertex");
            self.shared.push(Shared { above, half_edge, triangle });
        }
        self.shared.sort_unstable();
    }

    fn set(&mut self, triangle: [u32; 3], corners: [u32; 3]) {
        for (local, corner) in triangle.into_iter().zip(corners) {
            self.locals[local as usize] = corner;
        }
    }
}

/// Rotates a triangle so that the given corner comes first.
#[inline]
fn rotated([a, b, c]: [u32; 3], corner: u32) -> [u32; 3] {
    match corner {
        0 => [a, b, c],
        1 => [b, c, a],
        _ => [c, a, b],
    }
}
