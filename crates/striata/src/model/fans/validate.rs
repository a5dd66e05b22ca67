//! Validates a stored table in time linear in its size.
//!
//! Three properties are checked. First, every entry is well-formed: it ends where the next one begins, its
//! nodes and steps exist, and each of its triangles is created by exactly one step or is permanent.
//! Second, each step has exactly one parent. Third, **the positions that a split needs are exactly those
//! touched by its floor or listed as waiting for the step**: the former follow from the step's own
//! entries, the latter from the entries of others, so the two must agree.
//!
//! This is sufficient for every set of steps that an instance can reach. A triangle of an entry uses a
//! position only if splitting the entry's step also splits that position's step. Conversely, collapsing
//! that position's step also collapses the entry's step, because it waits for it, or for a step in between
//! that has a triangle there. So no visible triangle has an inactive corner. And since a step is collapsed
//! only when its whole star is active, and split only when its whole floor is, triangle counts are exact.

use super::step_counts::StepCounts;
use super::table::FanView;
use super::{Fans, listed};
use crate::model::ModelError;

/// Marks the base in a list of steps.
const BASE: u32 = u32::MAX;

/// Validates a table and counts the triangles that each step adds. If the steps are collapses, `removed` has the
/// counts that they should have.
///
/// # Errors
/// [`ModelError`] naming the first part that no build would produce.
pub(super) fn check(fans: &Fans, removed: Option<&[u8]>) -> Result<StepCounts, ModelError> {
    check_pairs("wait", &fans.waits, fans.step_count, |step, waits_for| step < waits_for)?;
    check_pairs("far target", &fans.far, fans.step_count, |step, target| target < step)?;
    let mut validator = Validator::new(fans);
    validator.read_entries()?;
    if let Some(removed) = removed {
        validator.check_counts(removed)?;
    }
    validator.check_parents()?;
    validator.check_needs()?;
    Ok(StepCounts::new(validator.added.into_iter()))
}

fn check_pairs(
    what: &'static str,
    pairs: &[[u32; 2]],
    step_count: usize,
    is_valid: impl Fn(u32, u32) -> bool,
) -> Result<(), ModelError> {
    let listed = |place, reason| Err(ModelError::Listed { what, place, reason });
    for (place, &[step, other]) in pairs.iter().enumerate() {
        if step.max(other) as usize >= step_count {
            return listed(place, "names a step that does not exist");
        }
        if !is_valid(step, other) {
            return listed(place, "has its steps in the wrong order");
        }
        if place > 0 && pairs[place - 1] >= [step, other] {
            return listed(place, "is out of order");
        }
    }
    Ok(())
}

/// Facts gathered from the part of the table that has been read so far.
struct Validator<'f> {
    fans: &'f Fans,
    /// Step of each vertex.
    step_of: Vec<u32>,
    /// Whether each step has been listed as a child.
    is_listed: Vec<bool>,
    /// For each step, the number of corners of its floor and of steps that wait for it, as found in the
    /// table.
    corner_counts: Vec<u32>,
    /// For each step, the triangle count of its star minus that of its floor.
    added: Vec<i32>,
}

impl<'f> Validator<'f> {
    fn new(fans: &'f Fans) -> Self {
        let step_count = fans.step_count;
        let mut step_of = vec![BASE; fans.vertices.vertex_count];
        for step in 0..step_count {
            let vertices = fans.vertices.of_step(step);
            step_of[vertices.start as usize..vertices.end as usize].fill(step as u32);
        }
        let (is_listed, corner_counts) = (vec![false; step_count], vec![0; step_count]);
        Self { fans, step_of, is_listed, corner_counts, added: vec![0; step_count] }
    }

    /// Returns the step of a vertex plus 1, or 0 for a base vertex.
    fn own_step(&self, vertex: u32) -> u32 {
        self.step_of[vertex as usize].wrapping_add(1)
    }

    /// Decodes every entry to its end, and accumulates what it says about steps.
    fn read_entries(&mut self) -> Result<(), ModelError> {
        let table = &self.fans.table;
        let byte_count = table.arrays().entries.len();
        for vertex in 0..self.fans.vertices.vertex_count as u32 {
            let at = vertex as usize;
            let (mut end, entry_end) = (table.start(at), table.start(at + 1));
            for fan in table.entry(vertex, self.own_step(vertex)) {
                // Entries do not overlap, so nothing is read twice.
                match fan.bytes_after().map(|after| byte_count - after) {
                    Some(fan_end) if fan_end <= entry_end => end = fan_end,
                    _ => return Err(ModelError::Entry { vertex: at, reason: "reaches into the next one" }),
                }
                self.read_fan(&fan).map_err(|reason| ModelError::Entry { vertex: at, reason })?;
            }
            if end != entry_end {
                return Err(ModelError::Entry { vertex: at, reason: "ends before the next one begins" });
            }
        }
        Ok(())
    }

    /// Checks that each step removes as many triangles as stored.
    fn check_counts(&self, removed: &[u8]) -> Result<(), ModelError> {
        let mut counts = self.added.iter().zip(removed);
        match counts.position(|(&found, &expected)| found != i32::from(expected)) {
            Some(step) => {
                Err(ModelError::Step { step, reason: "removes a different number of triangles than stored" })
            }
            None => Ok(()),
        }
    }

    fn read_fan(&mut self, fan: &FanView<'_>) -> Result<(), &'static str> {
        if fan.group as usize >= self.fans.group_count {
            return Err("is in a group that does not exist");
        }
        if fan.distances().any(|distance| distance == 0 || distance > fan.vertex) {
            return Err("has a node that is not older than its vertex");
        }
        check_arcs(fan)?;
        let arc_count = fan.arc_count();
        let own_step = self.step_of[fan.vertex as usize];
        if let Some(added) = self.added.get_mut(own_step as usize) {
            *added += arc_count as i32;
        }
        let mut free = u32::MAX >> (32 - arc_count);
        let mut claim = |mask: u32| {
            let is_free = mask & !free == 0 && mask != 0;
            free &= !mask;
            if is_free {
                Ok(())
            } else {
                Err("has a triangle that is created twice, or a step that creates none")
            }
        };
        if fan.permanent != 0 {
            claim(fan.permanent)?;
        }
        for [number, mask] in fan.pairs() {
            claim(mask)?;
            // The own step plus 1 is 0 for the base. A number below 2 would name the own step or, for a
            // base vertex, none.
            let step = u64::from(number >> 1) + u64::from(own_step.wrapping_add(1));
            if number < 2 || step > self.fans.step_count as u64 {
                return Err("has a triangle created by a step that is not later or does not exist");
            }
            self.read_creator(step as usize - 1, number & 1 != 0, mask, fan)?;
        }
        if free == 0 { Ok(()) } else { Err("has a triangle that is never created") }
    }

    fn read_creator(
        &mut self,
        step: usize,
        is_child: bool,
        mask: u32,
        fan: &FanView<'_>,
    ) -> Result<(), &'static str> {
        if is_child && std::mem::replace(&mut self.is_listed[step], true) {
            return Err("has a child that already has a parent");
        }
        self.added[step] -= mask.count_ones() as i32;
        self.corner_counts[step] += 1 + fan.corners_of(mask).count_ones();
        Ok(())
    }

    /// Checks that every step has a parent: either a step whose entry lists it, or the base.
    fn check_parents(&mut self) -> Result<(), ModelError> {
        let mut last = None;
        for (place, &step) in self.fans.orphans.iter().enumerate() {
            let is_rising = last.is_none_or(|last| last < step);
            last = Some(step);
            let is_listed = self.is_listed.get_mut(step as usize);
            if !is_listed.is_some_and(|is_listed| is_rising && !std::mem::replace(is_listed, true)) {
                let reason = "is out of order, does not exist, or already has a parent";
                return Err(ModelError::Listed { what: "orphan", place, reason });
            }
        }
        match self.is_listed.iter().position(|is_listed| !is_listed) {
            Some(step) => Err(ModelError::Step { step, reason: "has no parent" }),
            None => Ok(()),
        }
    }

    /// Checks that each step needs exactly the positions that its floor touches and those that wait for it.
    fn check_needs(&self) -> Result<(), ModelError> {
        let corners = self.corners();
        let mut marks = Marks { marks: vec![0; self.fans.step_count], step: 0, open_count: 0 };
        for step in 0..self.fans.step_count {
            marks.begin(step);
            self.for_each_needed(step, |needed| marks.need(needed));
            let mut is_valid = true;
            corners.of_step(step).for_each(|corner| is_valid &= corner == BASE || marks.find(corner));
            if !is_valid {
                let reason = "changes triangles at a vertex that it does not need";
                return Err(ModelError::Step { step, reason });
            }
            if marks.open_count > 0 {
                let reason = "needs a vertex that does not wait for it";
                return Err(ModelError::Step { step, reason });
            }
        }
        Ok(())
    }

    fn for_each_needed(&self, step: usize, mut visit: impl FnMut(u32)) {
        for vertex in self.fans.vertices.of_step(step) {
            for fan in self.fans.step_entry(vertex, step as u32) {
                let steps = fan.nodes().map(|node| self.step_of[node as usize]);
                steps.filter(|&other| other != BASE && other as usize != step).for_each(&mut visit);
            }
        }
        listed(&self.fans.far, step as u32).for_each(visit);
    }

    /// Collects for each step the steps whose vertices its floor touches, and those that wait for it.
    fn corners(&self) -> StepLists {
        let mut counts = self.corner_counts.clone();
        self.fans.waits.iter().for_each(|wait| counts[wait[1] as usize] += 1);
        let mut firsts = Vec::with_capacity(counts.len() + 1);
        firsts.push(0);
        let mut end = 0;
        for count in counts {
            end += count as usize;
            firsts.push(end);
        }
        let mut corners = StepLists { next: firsts.clone(), firsts, steps: vec![BASE; end] };
        for vertex in 0..self.fans.vertices.vertex_count as u32 {
            for fan in self.fans.table.entry(vertex, self.own_step(vertex)) {
                for creator in fan.creators() {
                    corners.push(creator.step, self.step_of[vertex as usize]);
                    let touched = fan.corners_of(creator.mask);
                    for (_, node) in fan.nodes().enumerate().filter(|(i, _)| touched & 1 << i != 0) {
                        corners.push(creator.step, self.step_of[node as usize]);
                    }
                }
            }
        }
        self.fans.waits.iter().for_each(|&[waiting, step]| corners.push(step, waiting));
        corners
    }
}

/// Checks that no triangle of a fan has an edge between equal vertices.
fn check_arcs(fan: &FanView<'_>) -> Result<(), &'static str> {
    let mut distances = fan.distances();
    let first = distances.next();
    let mut last = first;
    for distance in distances {
        if last.replace(distance) == Some(distance) {
            return Err("has a node next to itself");
        }
    }
    if fan.is_closed && last == first { Err("has a node next to itself") } else { Ok(()) }
}

impl FanView<'_> {
    /// Returns a bit mask of the nodes that the arcs of a mask touch.
    fn corners_of(&self, mask: u32) -> u64 {
        let touched = u64::from(mask) | u64::from(mask) << 1;
        let over = touched >> self.node_count;
        (touched | over) & ((1 << self.node_count) - 1)
    }
}

/// One list of steps for each step.
struct StepLists {
    firsts: Vec<usize>,
    next: Vec<usize>,
    steps: Vec<u32>,
}

impl StepLists {
    fn push(&mut self, step: u32, corner: u32) {
        let at = &mut self.next[step as usize];
        self.steps[*at] = corner;
        *at += 1;
    }

    fn of_step(&self, step: usize) -> impl Iterator<Item = u32> {
        self.steps[self.firsts[step]..self.firsts[step + 1]].iter().copied()
    }
}

/// The set of steps needed by the current step, and which of them have been found.
struct Marks {
    /// For each step, `2 * step + 2` of the last step that needed it, plus 1 once it has been found.
    marks: Vec<u32>,
    step: u32,
    /// Number of needed steps not found yet.
    open_count: usize,
}

impl Marks {
    fn begin(&mut self, step: usize) {
        (self.step, self.open_count) = (2 * step as u32 + 2, 0);
    }

    fn need(&mut self, step: u32) {
        let mark = &mut self.marks[step as usize];
        if *mark < self.step {
            *mark = self.step;
            self.open_count += 1;
        }
    }

    /// Marks a step as found; returns whether it is needed.
    fn find(&mut self, step: u32) -> bool {
        let mark = &mut self.marks[step as usize];
        if *mark == self.step {
            *mark += 1;
            self.open_count -= 1;
        }
        *mark > self.step
    }
}
