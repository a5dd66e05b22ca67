//! Exchanges a floor and a ceiling of an instance: inserts and removes single fragments.

use super::instance::{InstanceScratch, PatternInstance, PatternSlot, SharedTriangle};
use super::overlaps::{CeilingShare, MAX_RUN, Sharing, run_location};
use super::records::{StepHead, UpLink};
use super::rule::{NONE, first_corner};
use super::rule_table::{Number, RuleRef, RuleView, of_rule};
use super::{Overlap, Patterns};

/// Marks a location that is a half-edge; others consist of the code of a run and an offset along it.
const IS_HALF_EDGE: u32 = 1 << 31;

/// Largest number of local vertices and of slots of a floor that fit into buffers on the stack.
const FEW: usize = 16;

const FREE_SLOT: PatternSlot = PatternSlot { corners: [NONE; 3], next: NONE, location: 0 };

/// The vertices of a fragment by local index.
trait Locals {
    fn get(&self, local: u32) -> u32;
    fn set(&mut self, local: u32, vertex: u32);
}

/// At most 16 vertices, on the stack.
struct FewLocals([u32; FEW]);

impl Locals for FewLocals {
    #[inline(always)]
    fn get(&self, local: u32) -> u32 {
        // The remainder spares a check of the bounds.
        self.0[local as usize % FEW]
    }

    #[inline(always)]
    fn set(&mut self, local: u32, vertex: u32) {
        self.0[local as usize % FEW] = vertex;
    }
}

impl Locals for Vec<u32> {
    fn get(&self, local: u32) -> u32 {
        self[local as usize]
    }

    fn set(&mut self, local: u32, vertex: u32) {
        self[local as usize] = vertex;
    }
}

/// Slots of a floor, which the triangles of the ceiling use again.
struct FreedSlots {
    few: [u32; FEW],
    count: usize,
}

/// Returns the half-edge of a location.
#[inline]
fn half_edge_of<N: Number>(rule: &RuleView<'_, N>, location: u32) -> u32 {
    if location & IS_HALF_EDGE != 0 {
        return location ^ IS_HALF_EDGE;
    }
    rule.locate(location / MAX_RUN, location % MAX_RUN).expect("a run continues around its vertex")
}

/// A step and its record.
struct HeadedStep<'a> {
    /// Number of the step.
    pub step: u32,
    /// Its record.
    pub head: &'a StepHead,
}

impl PatternInstance {
    /// Inserts a step whose floor is complete, replacing the floor's triangles by those of the ceiling. Calls
    /// `visit` with each link up, some of them twice.
    #[inline]
    pub(super) fn insert_founded(
        &mut self,
        patterns: &Patterns,
        step: u32,
        head: &StepHead,
        visit: impl FnMut(UpLink),
    ) {
        let (rule, sharing) = patterns.kinds.get(head.kind);
        let sharing = patterns.sharings.get(sharing);
        match patterns.rules.rule(rule) {
            RuleRef::Narrow(rule) if rule.local_count() <= FEW => {
                let locals = &mut FewLocals([0; FEW]);
                self.replace_floor(patterns, (step, head), (&rule, sharing, locals), visit);
            }
            rule => self.replace_large_floor(patterns, (step, head), (rule, sharing), visit),
        }
        self.inserted.insert(step);
        self.split_count += 1;
    }

    /// Exchanges a floor and a ceiling with many vertices.
    #[cold]
    fn replace_large_floor(
        &mut self,
        patterns: &Patterns,
        of_step: (u32, &StepHead),
        (rule, sharing): (RuleRef<'_>, Sharing<'_>),
        visit: impl FnMut(UpLink),
    ) {
        let locals = &mut vec![0; of_rule!(rule, rule => rule.local_count())];
        match rule {
            RuleRef::Narrow(rule) => self.replace_floor(patterns, of_step, (&rule, sharing, locals), visit),
            RuleRef::Wide(rule) => self.replace_floor(patterns, of_step, (&rule, sharing, locals), visit),
        }
    }

    #[inline(always)]
    fn replace_floor<N: Number, L: Locals>(
        &mut self,
        patterns: &Patterns,
        (step, head): (u32, &StepHead),
        (rule, sharing, locals): (&RuleView<'_, N>, Sharing<'_>, &mut L),
        mut visit: impl FnMut(UpLink),
    ) {
        set_known(patterns, step, head, rule, locals);
        let freed = self.take_floor(step, rule, locals);
        let is_grouped = patterns.group_count > 1;
        let ceiling = rule.ceilings();
        // Triangles of the full mesh stay in the list of the step.
        let mut own = NONE;
        sharing.for_each_run(ceiling.len(), |run, CeilingShare { link, offset }| {
            let is_full = link == CeilingShare::FULL;
            let (above, mut location) = if is_full {
                (step, run.start as u32)
            } else {
                let up = patterns.records.up(head, link);
                visit(up);
                (up.above, run_location(up.code, offset))
            };
            let list = &mut self.heads[above as usize];
            let mut next = if is_full { own } else { list.wrapping_sub(1) };
            for s in run {
                let at = if s < freed.count { freed.few[s % FEW] } else { self.free_slot(is_grouped) };
                let [a, b, c] = ceiling[s];
                let corners = [locals.get(a.get()), locals.get(b.get()), locals.get(c.get())];
                self.slots[at as usize] = PatternSlot { corners, next, location };
                if is_grouped {
                    self.groups[at as usize] = rule.group(s);
                }
                next = at;
                location += 1;
            }
            if is_full {
                own = next;
            } else {
                self.heads[above as usize] = next.wrapping_add(1);
            }
        });
        self.heads[step as usize] = own.wrapping_add(1);
        self.triangle_count += ceiling.len();
        self.triangle_count -= rule.floor_count();
        for &slot in &freed.few[ceiling.len().min(freed.count)..freed.count] {
            self.release(slot);
        }
    }

    /// Reads the vertices of a floor, and returns the slots of its triangles, except for many of them.
    #[inline(always)]
    fn take_floor<N: Number, L: Locals>(
        &mut self,
        step: u32,
        rule: &RuleView<'_, N>,
        locals: &mut L,
    ) -> FreedSlots {
        let mut freed = FreedSlots { few: [0; FEW], count: 0 };
        let floor = rule.floors();
        let mut at = self.heads[step as usize].wrapping_sub(1);
        while at != NONE {
            let PatternSlot { corners, next, location } = self.slots[at as usize];
            let half_edge = half_edge_of(rule, location);
            let [a, b, c] = rotated(floor[half_edge as usize / 3], half_edge % 3);
            locals.set(a.get(), corners[0]);
            locals.set(b.get(), corners[1]);
            locals.set(c.get(), corners[2]);
            if freed.count < FEW {
                freed.few[freed.count] = at;
                freed.count += 1;
            } else {
                self.release(at);
            }
            at = next;
        }
        freed
    }

    /// Returns a slot that is free.
    #[inline]
    fn free_slot(&mut self, is_grouped: bool) -> u32 {
        let free = self.free;
        if free != NONE {
            self.free = self.slots[free as usize].next;
            return free;
        }
        self.slots.push(FREE_SLOT);
        if is_grouped {
            self.groups.push(0);
        }
        self.slots.len() as u32 - 1
    }

    /// Removes a step on which no other depends, replacing the ceiling's triangles by those of the floor.
    pub(super) fn remove_top(&mut self, patterns: &Patterns, step: u32) {
        let head = patterns.records.head(step);
        let rule = patterns.rule_of(&head);
        let mut scratch = std::mem::take(&mut self.scratch);
        self.read_ceiling(patterns, HeadedStep { step, head: &head }, &mut scratch, true);
        of_rule!(rule, rule => self.show_floor(patterns, step, &rule, &scratch.locals));
        self.scratch = scratch;
        self.inserted.remove(step);
        self.split_count -= 1;
    }

    fn show_floor<N: Number>(
        &mut self,
        patterns: &Patterns,
        step: u32,
        rule: &RuleView<'_, N>,
        locals: &[u32],
    ) {
        for j in 0..rule.floor_count() {
            let corners = vertices_of(locals, rule.floor(j));
            let youngest = corners[0].max(corners[1]).max(corners[2]);
            let corner = corners.iter().position(|&v| v == youngest).unwrap_or(0);
            let group = rule.group(rule.ceiling_count() + j);
            let slot = self.add_triangle(patterns, first_corner(corners, youngest), group);
            self.list(step, slot, (3 * j + corner) as u32 | IS_HALF_EDGE);
        }
    }

    /// Finds the overlaps in the floor of an inserted step on which no other depends, which may be listed
    /// several times. `base` contains those of the base mesh, sorted by the step above.
    pub(super) fn floor_overlaps_into(
        &mut self,
        patterns: &Patterns,
        step: u32,
        base: &[Overlap],
        out: &mut Vec<Overlap>,
    ) {
        let of_base = base.partition_point(|overlap| overlap.upper < step);
        out.clear();
        out.extend(base[of_base..].iter().take_while(|overlap| overlap.upper == step));
        let head = patterns.records.head(step);
        let mut scratch = std::mem::take(&mut self.scratch);
        self.read_ceiling(patterns, HeadedStep { step, head: &head }, &mut scratch, false);
        of_rule!(patterns.rule_of(&head), rule => for j in 0..rule.floor_count() {
            let [a, b, c] = vertices_of(&scratch.locals, rule.floor(j));
            let youngest = a.max(b).max(c);
            if youngest >= patterns.vertices.base_vertex_count {
                let lower = patterns.vertices.step_of(youngest) as u32;
                let ups = patterns.records.head(lower);
                let ups = patterns.records.ups(&ups).filter(|up| up.above == step);
                out.extend(ups.map(|up| patterns.overlap(Some(lower), up)));
            }
        });
        self.scratch = scratch;
    }

    /// Reads the vertices of a complete ceiling from its triangles, and optionally removes these.
    fn read_ceiling(
        &mut self,
        patterns: &Patterns,
        HeadedStep { step, head }: HeadedStep<'_>,
        scratch: &mut InstanceScratch,
        remove: bool,
    ) {
        let (rule, sharing) = patterns.kinds.get(head.kind);
        let rule = patterns.rules.rule(rule);
        of_rule!(rule, rule => {
            scratch.locals.clear();
            scratch.locals.resize(rule.local_count(), 0);
            set_known(patterns, step, head, &rule, &mut scratch.locals);
        });
        let ceiling = |s: u32| of_rule!(rule, rule => rule.ceiling(s as usize));
        let mut slot = self.heads[step as usize].wrapping_sub(1);
        while slot != NONE {
            let PatternSlot { corners, next, location } = self.slots[slot as usize];
            set_corners(&mut scratch.locals, ceiling(location), corners);
            if remove {
                self.triangle_count -= 1;
                self.release(slot);
            }
            slot = next;
        }
        if remove {
            self.heads[step as usize] = 0;
        }
        scratch.load_shared(patterns, head, patterns.sharings.get(sharing), rule.ceiling_count());
        let shared = std::mem::take(&mut scratch.shared);
        for own in shared.chunk_by(|a, b| a.above == b.above) {
            self.read_above(patterns, own, remove, |triangle, corners| {
                set_corners(&mut scratch.locals, ceiling(triangle), corners);
            });
        }
        scratch.shared = shared;
    }

    /// Reads those triangles of a ceiling that are in the list of one step above.
    fn read_above(
        &mut self,
        patterns: &Patterns,
        own: &[SharedTriangle],
        remove: bool,
        mut visit: impl FnMut(u32, [u32; 3]),
    ) {
        let above = own[0].above;
        let floor = patterns.rule_of(&patterns.records.head(above));
        let (mut slot, mut before) = (self.heads[above as usize].wrapping_sub(1), NONE);
        let mut left = own.len();
        while slot != NONE && left > 0 {
            let PatternSlot { corners, next, location } = self.slots[slot as usize];
            let at = of_rule!(floor, floor => half_edge_of(&floor, location));
            let found = own.binary_search_by_key(&at, |shared| shared.half_edge);
            if let Ok(found) = found {
                visit(own[found].triangle, corners);
                left -= 1;
            }
            if found.is_ok() && remove {
                match before {
                    NONE => self.heads[above as usize] = next.wrapping_add(1),
                    before => self.slots[before as usize].next = next,
                }
                self.triangle_count -= 1;
                self.release(slot);
            } else {
                before = slot;
            }
            slot = next;
        }
    }

    /// Stores a triangle in a free slot, and returns the slot.
    pub(super) fn add_triangle(&mut self, patterns: &Patterns, corners: [u32; 3], group: u32) -> u32 {
        let is_grouped = patterns.group_count > 1;
        let at = self.free_slot(is_grouped);
        self.slots[at as usize] = PatternSlot { corners, next: NONE, location: 0 };
        if is_grouped {
            self.groups[at as usize] = group;
        }
        self.triangle_count += 1;
        at
    }

    /// Marks a slot as free; whoever calls this counts the triangles.
    fn release(&mut self, slot: u32) {
        self.slots[slot as usize] = PatternSlot { next: self.free, ..FREE_SLOT };
        self.free = slot;
    }

    /// Adds a triangle to the list of a step.
    #[inline]
    pub(super) fn list(&mut self, step: u32, slot: u32, location: u32) {
        let head = &mut self.heads[step as usize];
        let entry = &mut self.slots[slot as usize];
        entry.next = std::mem::replace(head, slot + 1).wrapping_sub(1);
        entry.location = location;
    }
}

impl InstanceScratch {
    /// Finds where the triangles of a ceiling go, sorted, so that each list above is traversed only once.
    fn load_shared(&mut self, patterns: &Patterns, head: &StepHead, sharing: Sharing<'_>, count: usize) {
        self.links.clear();
        self.links.extend(patterns.records.ups(head));
        self.shared.clear();
        sharing.for_each_run(count, |run, CeilingShare { link, offset }| {
            if link == CeilingShare::FULL {
                return;
            }
            let UpLink { above, code, .. } = self.links[link as usize];
            let rule = patterns.rule_of(&patterns.records.head(above));
            for (triangle, offset) in run.zip(offset..) {
                let half_edge = rule.locate(code, offset).expect("a run continues around its vertex");
                self.shared.push(SharedTriangle { above, half_edge, triangle: triangle as u32 });
            }
        });
        self.shared.sort_unstable();
    }
}

/// Sets the vertices that a step restores, and those that it lists.
#[inline]
fn set_known<N: Number>(
    patterns: &Patterns,
    step: u32,
    head: &StepHead,
    rule: &RuleView<'_, N>,
    locals: &mut impl Locals,
) {
    let own = patterns.vertices.of_step(step as usize);
    let first = own.start;
    (0..).zip(own).for_each(|(local, vertex)| locals.set(local, vertex));
    if head.extra_count > 0 {
        for (local, distance) in rule.extras().zip(patterns.records.extras(head)) {
            locals.set(local, first - 1 - distance);
        }
    }
}

#[inline]
fn set_corners(locals: &mut [u32], triangle: [u32; 3], corners: [u32; 3]) {
    for k in 0..3 {
        locals[triangle[k] as usize] = corners[k];
    }
}

/// Returns the vertices of a triangle in local indices. (`array::map` is not always inlined.)
#[inline]
pub(super) fn vertices_of(locals: &[u32], [a, b, c]: [u32; 3]) -> [u32; 3] {
    [locals[a as usize], locals[b as usize], locals[c as usize]]
}

/// Rotates a triangle so that the given corner comes first.
#[inline]
pub(super) fn rotated<T>([a, b, c]: [T; 3], corner: u32) -> [T; 3] {
    match corner {
        0 => [a, b, c],
        1 => [b, c, a],
        _ => [c, a, b],
    }
}
