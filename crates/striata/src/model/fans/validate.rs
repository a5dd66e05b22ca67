//! Whether a stored table can be trusted, in time linear in its bytes.
//!
//! Three things are checked. Each entry is what a build could have written: it ends where the next begins, its nodes and steps
//! are there, and each of its triangles is made by one step or is there always. Each step has one parent. And
//! **a step needs exactly the positions where its floor has corners, and those that wait for it beside**: what it needs is
//! told by its own entries, its floor by those of others, so the two have to agree.
//!
//! That is enough for every set of steps that an instance can come to. A triangle of an entry names a position only if
//! undoing the entry's step undoes that one too; and taking that one takes the entry's step with it, since it waits for it, or
//! for a step between them that has a triangle there. So no triangle is shown with a corner that is not, and as a
//! step is only taken once all of its star is there and undone onto all of its floor, counts of triangles are exact.

use super::table::FanView;
use super::{Fans, listed};
use crate::model::ModelError;

/// Stands for the base in a list of steps.
const BASE: u32 = u32::MAX;

/// # Errors
/// [`ModelError`] naming the first part that no build would make.
pub(super) fn check(fans: &Fans) -> Result<(), ModelError> {
    check_pairs("wait", &fans.waits, fans.step_count, |step, waits_for| step < waits_for)?;
    check_pairs("far target", &fans.far, fans.step_count, |step, target| target < step)?;
    let mut checked = Checked::new(fans);
    checked.read_entries()?;
    checked.check_parents()?;
    checked.check_needs()
}

fn check_pairs(
    what: &'static str,
    pairs: &[[u32; 2]],
    step_count: usize,
    is_sound: impl Fn(u32, u32) -> bool,
) -> Result<(), ModelError> {
    let listed = |place, reason| Err(ModelError::Listed { what, place, reason });
    for (place, &[step, other]) in pairs.iter().enumerate() {
        if step.max(other) as usize >= step_count {
            return listed(place, "names a step that is not there");
        }
        if !is_sound(step, other) {
            return listed(place, "is the wrong way round");
        }
        if place > 0 && pairs[place - 1] >= [step, other] {
            return listed(place, "is out of order");
        }
    }
    Ok(())
}

/// What has been read of a table.
struct Checked<'f> {
    fans: &'f Fans,
    /// The step of each vertex.
    step_of: Vec<u32>,
    /// Whether each step has a parent.
    is_told: Vec<bool>,
    /// How many corners of its floor, and steps that wait for it, each step has in the table.
    corner_counts: Vec<u32>,
    /// Triangles of each step's star without those of its floor.
    removed: Vec<i64>,
}

impl<'f> Checked<'f> {
    fn new(fans: &'f Fans) -> Self {
        let step_count = fans.step_count;
        let mut step_of = vec![BASE; fans.vertices.vertex_count];
        for step in 0..step_count {
            let vertices = fans.vertices.of_step(step);
            step_of[vertices.start as usize..vertices.end as usize].fill(step as u32);
        }
        let (is_told, corner_counts) = (vec![false; step_count], vec![0; step_count]);
        Self { fans, step_of, is_told, corner_counts, removed: vec![0; step_count] }
    }

    /// The step of a vertex and one, or 0 for a vertex of the base.
    fn own_step(&self, vertex: u32) -> u32 {
        self.step_of[vertex as usize].wrapping_add(1)
    }

    /// Reads each entry to its end, and adds up what it says of steps.
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
        let counts = self.removed.iter().zip(&self.fans.removed);
        match { counts }.position(|(&found, &expected)| found != i64::from(expected)) {
            Some(step) => {
                Err(ModelError::Step { step, reason: "takes away another number of triangles than it says" })
            }
            None => Ok(()),
        }
    }

    fn read_fan(&mut self, fan: &FanView<'_>) -> Result<(), &'static str> {
        if fan.group as usize >= self.fans.group_count {
            return Err("is in a group that is not there");
        }
        if fan.distances().any(|distance| distance == 0 || distance > fan.vertex) {
            return Err("has a node that is not older than its vertex");
        }
        check_arcs(fan)?;
        let arc_count = fan.arc_count();
        let own_step = self.step_of[fan.vertex as usize];
        if let Some(removed) = self.removed.get_mut(own_step as usize) {
            *removed += arc_count as i64;
        }
        let mut free = u32::MAX >> (32 - arc_count);
        let mut claim = |mask: u32| {
            let is_free = mask & !free == 0 && mask != 0;
            free &= !mask;
            if is_free { Ok(()) } else { Err("has a triangle that is made twice, or a step that makes none") }
        };
        if fan.always != 0 {
            claim(fan.always)?;
        }
        for [told, mask] in fan.pairs() {
            claim(mask)?;
            // A step and one is never 0, and neither is what is told of a later step than the own.
            let step = u64::from(told >> 1) + u64::from(own_step.wrapping_add(1));
            if told < 2 || step > self.fans.step_count as u64 {
                return Err("has a triangle that is made by a step that is not later, or not there");
            }
            self.read_creator(step as usize - 1, told & 1 != 0, mask, fan)?;
        }
        if free == 0 { Ok(()) } else { Err("has a triangle that is never made") }
    }

    fn read_creator(
        &mut self,
        step: usize,
        is_child: bool,
        mask: u32,
        fan: &FanView<'_>,
    ) -> Result<(), &'static str> {
        if is_child && std::mem::replace(&mut self.is_told[step], true) {
            return Err("has a child that has another parent");
        }
        self.removed[step] -= i64::from(mask.count_ones());
        self.corner_counts[step] += 1 + fan.corners_of(mask).count_ones();
        Ok(())
    }

    /// Every step has a parent: a step that has told it, or the base.
    fn check_parents(&mut self) -> Result<(), ModelError> {
        let mut last = None;
        for (place, &step) in self.fans.orphans.iter().enumerate() {
            let is_rising = last.is_none_or(|last| last < step);
            last = Some(step);
            let is_told = self.is_told.get_mut(step as usize);
            if !is_told.is_some_and(|is_told| is_rising && !std::mem::replace(is_told, true)) {
                let reason = "is out of order, not there, or has a parent";
                return Err(ModelError::Listed { what: "orphan", place, reason });
            }
        }
        match self.is_told.iter().position(|is_told| !is_told) {
            Some(step) => Err(ModelError::Step { step, reason: "has no parent" }),
            None => Ok(()),
        }
    }

    /// What each step needs to be there is what its floor touches and what waits for it.
    fn check_needs(&self) -> Result<(), ModelError> {
        let corners = self.corners();
        let mut marks = Marks { marks: vec![0; self.fans.step_count], step: 0, open_count: 0 };
        for step in 0..self.fans.step_count {
            marks.begin(step);
            self.for_each_needed(step, |needed| marks.need(needed));
            let mut is_sound = true;
            corners.of_step(step).for_each(|corner| is_sound &= corner == BASE || marks.meet(corner));
            if !is_sound {
                let reason = "changes what is at a vertex that it does not need";
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

    /// Steps that have corners of each step's floor, and those that wait for it.
    fn corners(&self) -> Corners {
        let mut counts = self.corner_counts.clone();
        self.fans.waits.iter().for_each(|wait| counts[wait[1] as usize] += 1);
        let mut firsts = Vec::with_capacity(counts.len() + 1);
        firsts.push(0);
        let mut end = 0;
        for count in counts {
            end += count as usize;
            firsts.push(end);
        }
        let mut corners = Corners { next: firsts.clone(), firsts, steps: vec![BASE; end] };
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

/// No triangle of a fan has an edge without length.
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
    /// The nodes that the arcs of a mask have, a bit each.
    fn corners_of(&self, mask: u32) -> u64 {
        let touched = u64::from(mask) | u64::from(mask) << 1;
        let over = touched >> self.node_count;
        (touched | over) & ((1 << self.node_count) - 1)
    }
}

/// Lists of steps, one for each step.
struct Corners {
    firsts: Vec<usize>,
    next: Vec<usize>,
    steps: Vec<u32>,
}

impl Corners {
    fn push(&mut self, step: u32, corner: u32) {
        let at = &mut self.next[step as usize];
        self.steps[*at] = corner;
        *at += 1;
    }

    fn of_step(&self, step: usize) -> impl Iterator<Item = u32> {
        self.steps[self.firsts[step]..self.firsts[step + 1]].iter().copied()
    }
}

/// Which steps one step needs, and which of these have been met.
struct Marks {
    /// Twice the number of the step that needed each last, one more once it has been met, and 2.
    marks: Vec<u32>,
    step: u32,
    /// Steps that are needed and have not been met.
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

    /// Meets a step; false where it is not needed.
    fn meet(&mut self, step: u32) -> bool {
        let mark = &mut self.marks[step as usize];
        if *mark == self.step {
            *mark += 1;
            self.open_count -= 1;
        }
        *mark > self.step
    }
}
