//! The loop: collapses the cheapest edge and updates the costs around it.

mod choice;
mod choose;
mod rest;

use glam::DVec3;

use crate::mesh::{AttributeLayer, Welded};
use crate::simplify::collapse::choice::Tier;
use crate::simplify::collapse::heap::IndexedHeap;
use crate::simplify::collapse::judge::Judge;
use crate::simplify::collapse::relaxation::Relaxation;
use crate::simplify::options::{CollapseCost, SeamRule, SequenceOptions, SimplifyError, StopReason};
use crate::{Progress, ProgressFn};

use super::blend;
use super::drift::Drift;
use super::form::Form;
use super::frame::Frame;
use super::goal::{Counts, Goal};
use super::hood::Hood;
use super::seams::merge_wedges;
use choice::{Choice, NO_CHOICE, UNDECIDED};

/// Data about a position and its star.
#[derive(Clone, Copy, Debug, Default)]
struct Known {
    form: Form,
    /// Incremented whenever the star changes.
    version: u32,
    border_count: u32,
}

/// Complete state of one simplification.
pub(super) struct Merger<'a> {
    welded: &'a Welded,
    pub(super) frame: Frame,
    positions: Vec<DVec3>,
    is_moved: Vec<bool>,
    judge: Judge<'a>,
    seams: SeamRule,
    relaxation: Relaxation<'a>,
    known: Vec<Known>,
    choices: Vec<Choice>,
    heap: IndexedHeap,
    drift: Drift,
    hood: Hood,
    other_hood: Hood,
    costs: Vec<f32>,
    ring: Vec<u32>,
    /// Neighbors of the position removed last, each once.
    removed_ring: Vec<u32>,
    /// Positions whose witnesses must be measured again, and further originals to measure.
    gone: Vec<u32>,
    followers: Vec<u32>,
    pairs: Vec<(u32, u32)>,
    /// The vertex that each vertex was merged into, or itself.
    targets: Vec<u32>,
    layers: Vec<AttributeLayer>,
    triangle_count: usize,
    vertex_count: usize,
    removed: Vec<u32>,
    /// Number of positions removed so far.
    pub(super) removed_count: usize,
    pub(super) error: f64,
}

impl<'a> Merger<'a> {
    pub(super) fn new(welded: &'a Welded, options: &SequenceOptions) -> Self {
        let mesh = &welded.mesh;
        let frame = Frame::of(mesh);
        let position_count = welded.positions.position_count();
        let place = |p| frame.enter(mesh.positions[welded.positions.first_vertex(p) as usize]);
        let positions: Vec<DVec3> = (0..position_count as u32).map(place).collect();
        let options =
            SequenceOptions { cost: CollapseCost::Memoryless, pair_distance: None, ..options.clone() };
        let mut judge = Judge::new(welded, &options);
        judge.lock_boundary();
        Self {
            welded,
            frame,
            is_moved: vec![false; position_count],
            judge,
            seams: options.seams,
            relaxation: Relaxation::new(welded, options.topology),
            known: vec![Known::default(); position_count],
            choices: vec![NO_CHOICE; position_count],
            heap: IndexedHeap::new(&[]),
            drift: Drift::new(positions.clone()),
            positions,
            hood: Hood::default(),
            other_hood: Hood::default(),
            costs: Vec::new(),
            ring: Vec::new(),
            removed_ring: Vec::new(),
            gone: Vec::new(),
            followers: Vec::new(),
            pairs: Vec::new(),
            targets: (0..mesh.vertex_count() as u32).collect(),
            layers: mesh.layers.clone(),
            triangle_count: mesh.triangle_count(),
            vertex_count: mesh.vertex_count(),
            removed: Vec::new(),
            removed_count: 0,
            error: 0.0,
        }
    }

    pub(super) fn counts(&self) -> Counts {
        Counts {
            triangles: self.triangle_count,
            vertices: self.vertex_count,
            removable: self.judge.is_locked.iter().filter(|is_locked| !**is_locked).count(),
        }
    }

    /// Collapses the cheapest edge until the target is reached or no collapse is left.
    pub(super) fn run(
        &mut self,
        goal: &Goal,
        progress: &mut ProgressFn<'_>,
    ) -> Result<StopReason, SimplifyError> {
        if let Some(reason) = goal.reached(self.triangle_count, self.vertex_count, 0) {
            return Ok(reason);
        }
        if self.relaxation.is_possible() && self.judge.wedges.is_some() {
            self.relaxation.begin(&mut self.judge, (&self.removed, &self.targets));
        }
        let position_count = self.positions.len() as u32;
        (0..position_count).for_each(|v| self.renew(v));
        let keys: Vec<f32> = (0..position_count).map(|v| self.lower_bound(v)).collect();
        self.heap = IndexedHeap::new(&keys);
        drop(keys);
        let total = goal.removals.min(self.positions.len()) as u64;
        while let Some((key, v)) = self.next() {
            if let Some(reason) = goal.reached(self.triangle_count, self.vertex_count, self.removed_count) {
                return Ok(reason);
            }
            if !self.is_decided(v) {
                self.decide(v, key);
                continue;
            }
            if !self.collapse(v, goal.limit) {
                return Ok(goal.at_limit);
            }
            let done = self.removed_count as u64;
            if done.is_multiple_of(4096) {
                Progress { phase: "simplify", done, total }.report(progress)?;
            }
        }
        Ok(goal.reached(self.triangle_count, self.vertex_count, self.removed_count).unwrap_or(goal.at_base))
    }

    /// Returns the position with the smallest key, and that key; begins relaxed collapses if they had
    /// to wait for the last strict one.
    fn next(&mut self) -> Option<(f32, u32)> {
        if self.heap.first().is_none() && self.relaxation.is_waiting() {
            self.relaxation.begin(&mut self.judge, (&self.removed, &self.targets));
            for v in 0..self.positions.len() as u32 {
                self.choices[v as usize] = NO_CHOICE;
                let bound = self.lower_bound(v);
                self.heap.set(v, bound);
            }
        }
        self.heap.first()
    }

    /// Whether `v` has a choice that is still valid; otherwise clears its choice.
    fn is_decided(&mut self, v: u32) -> bool {
        let choice = self.choices[v as usize];
        if choice.other == UNDECIDED {
            return false;
        }
        let is_fresh = self.known[choice.other as usize].version == choice.other_version;
        let (removed, kept) = if choice.is_kept { (choice.other, v) } else { (v, choice.other) };
        // Changes in links outside the two stars may have changed what is allowed.
        let Judge { legality, links, .. } = &mut self.judge;
        let stands = is_fresh
            && match choice.tier {
                Tier::Strict => legality.allows(links, removed, kept),
                tier => self.judge.relaxed_stands(removed, kept, (tier, choice.distance_squared)),
            };
        if !stands {
            self.choices[v as usize] = NO_CHOICE;
        }
        stands
    }

    /// Recomputes the star of `v` after a change.
    fn renew(&mut self, v: u32) {
        self.gather(v);
        let known = &mut self.known[v as usize];
        known.form = self.hood.form();
        known.border_count = self.hood.borders.len() as u32;
        known.version += 1;
        self.choices[v as usize] = NO_CHOICE;
    }

    /// Applies the choice of `v` and updates the positions around it. If the error would exceed the
    /// limit, restores positions and targets and returns false.
    fn collapse(&mut self, v: u32, limit: f64) -> bool {
        let Choice { other, is_kept, place, tier, distance_squared, .. } = self.choices[v as usize];
        let (removed, kept) = if is_kept { (other, v) } else { (v, other) };
        self.removed_ring.clear();
        self.removed_ring.extend_from_slice(self.judge.links.entries(removed));
        self.ring.clear();
        for p in [removed, kept] {
            self.ring.extend(self.judge.links.entries(p).iter().filter(|&&w| w != removed && w != kept));
        }
        for ring in [&mut self.ring, &mut self.removed_ring] {
            ring.sort_unstable();
            ring.dedup();
        }
        self.ring.push(kept);
        let share = self.share_of(removed, kept, place);
        let undone = self.positions[kept as usize];
        merge_wedges(&mut self.judge, (removed, kept), &mut self.targets, &mut self.pairs);
        let count = |judge: &Judge<'_>, p| judge.links.triangle_count(p);
        let before = count(&self.judge, removed) + count(&self.judge, kept);
        self.judge.links.collapse(removed, kept);
        self.place(kept, place);
        // Each removed triangle was in both links.
        let removed_triangles = (before - count(&self.judge, kept)) / 2;
        let worst = self.settle((removed, kept), tier, removed_triangles).max(distance_squared);
        let error = self.error.max(f64::from(worst).sqrt() * self.frame.scale);
        if error > limit {
            self.place(kept, undone);
            self.welded.positions.wedges(removed).for_each(|w| self.targets[w as usize] = w);
            return false;
        }
        self.error = error;
        self.triangle_count -= removed_triangles;
        for &p in self.gone.iter().filter(|&&p| p != kept || self.judge.links.triangle_count(kept) == 0) {
            self.vertex_count -= self.welded.positions.wedges(p).len();
            self.removed_count += 1;
            self.heap.remove(p);
        }
        self.removed.push(removed);
        self.is_moved[kept as usize] |= place != undone;
        self.pairs.iter().for_each(|&(from, to)| blend::blend(&mut self.layers, from, to, share));
        self.look_again();
        true
    }

    fn place(&mut self, p: u32, place: DVec3) {
        self.positions[p as usize] = place;
        let [x, y, z] = place.as_vec3().to_array();
        self.judge.positions[p as usize] = [x, y, z, 0.0];
    }

    /// Measures the witnesses at the ends of a collapsed edge again; returns the largest squared
    /// distance. Leaves the removed position, the kept one and all that lost their last triangle in
    /// `gone`.
    fn settle(&mut self, (removed, kept): (u32, u32), tier: Tier, removed_triangles: usize) -> f32 {
        let departure = self.judge.note_departure(removed, kept, removed_triangles, &self.removed_ring);
        self.gone.clear();
        self.gone.extend([removed, kept]);
        self.followers.clear();
        let mut place = kept;
        let mut is_plain = tier == Tier::Strict;
        if let Some(departure) = departure {
            self.gone.extend(departure.lost.iter().filter(|&&p| p != kept));
            is_plain &= departure.lost.is_empty();
            place = departure.place.unwrap_or(kept);
            self.judge.forget(departure);
        }
        if !is_plain {
            self.judge.note_relaxed();
            self.judge.followers_into(place, 0, &mut self.followers);
            self.followers.extend_from_slice(&self.gone);
        }
        let worst = (self.error / self.frame.scale).powi(2) as f32;
        let around = (&mut self.judge, self.positions.as_slice());
        self.drift.settle_all(around, (&self.gone, &self.followers), place, worst)
    }

    fn look_again(&mut self) {
        let ring = std::mem::take(&mut self.ring);
        ring.iter().for_each(|&w| self.renew(w));
        for &w in &ring {
            let bound = self.lower_bound(w);
            self.heap.set(w, bound);
        }
        self.ring = ring;
    }
}
