//! One level with vertices placed freely: edge collapses whose new vertex lies where it costs least.
//!
//! An edge costs the squared distances of its new vertex from the planes of the *current* triangles around both ends,
//! weighted by area; the place is the least of them that keeps the volume [LT98], [Hop99]. Nothing is remembered, so
//! errors do not add up to a bias, and the volume keeps the surface from shrinking. Levels are not nested: vertices
//! move at every step, so this gives one mesh and no sequence.
//!
//! ```text
//!     r1 --- r2                r1 --- r2
//!    /  \   /  \              /   \  /   \      A half-edge collapse v -> u in the links,
//!   s -- u v -- r3     ->    s --- x --- r3     then u moves to x. Links are those of the
//!    \  /   \  /              \   /  \   /      subset mode, and so is what they allow.
//!     r5 --- r4                r5 --- r4
//! ```
//!
//! The queue holds a position's cheapest edge, by the form alone; flips, links, seams and the distance of the old
//! vertices from the new triangles are looked at when it reaches the top. An edge that has changed is known to the end that
//! was looked at last, so the order is strict though the other end may hold an older cost.
//!
//! Borders (boundaries, edges with three triangles, seams that must stay) keep their course: a vertex on one merges along it only,
//! an inner vertex merges into it without moving it, and where borders meet or end, the vertex stays in place. Seams that may be
//! crossed are no borders; leaving their course and crossing them has a price (`seams`).
//!
//! A position without any such collapse gets a **relaxed** one, unless the topology must stay: the half-edge collapse that the
//! subset mode would choose there, with its target in place, so that every target is reached. Both kinds share one queue, since
//! their costs are squared distances over areas alike.
//!
//! The links, wedges and positions are those of a [`Judge`], which sees the current mesh in single precision.
//!
//! The loop stops at a limit of the error by an estimate from followed vertices (`drift`). The error of the finished level is measured against
//! the original, both ways; if it exceeds the limit, everything is done again with a smaller one.
//!
//! Differs: always memoryless; attributes count only at seams and in relaxed collapses, and pairs without an edge are never merged.
//! Time O(n log n), about 400 bytes a vertex.

mod blend;
mod course;
mod drift;
mod form;
mod goal;
mod hood;
mod measure;
mod seams;

use std::ops::ControlFlow;

use glam::DVec3;

use crate::mesh::{IndexedMesh, Welded};
use crate::{Cancelled, Progress, ProgressFn};

use crate::simplify::collapse::engine::scaled_positions;
use crate::simplify::collapse::heap::IndexedHeap;
use crate::simplify::collapse::judge::{self, Judge, Tier};
use crate::simplify::collapse::relaxation::Relaxation;
use crate::simplify::options::{
    CollapseCost, SeamRule, SequenceOptions, Simplified, SimplifyError, SimplifyOptions, StopReason,
};
use course::{Course, first_cost, places};
use drift::Drift;
use form::{EdgeForm, Form};
use goal::{Counts, Goal};
use hood::Hood;
use measure::measured_error;
use seams::{Crossings, Merge, merge_wedges, seam_weight};

/// No edge chosen yet: the key is a lower bound.
const UNDECIDED: u32 = u32::MAX;
/// Weight of the squared distances of both ends from the new triangles, times the area: 1 % of RMS for maxima that
/// are a fifth less, since planes alone do not see that a thin spike is lost.
const DISTANCE_WEIGHT: f64 = 0.1;
/// Area, in squared distances, that lost ends count for beyond the area of their stars: on meshes of thin parts, RMS falls by a fifth
/// down to 10 % of the triangles, and on scans hardly anything changes.
const SPIKE_WEIGHT: f64 = 32.0;
/// Times that a level beyond the error limit is made again, each time with a smaller limit.
const MAX_RETRIES: usize = 8;
/// Share of the diagonal that single precision leaves of a distance of 0.
const NOISE: f64 = 1e-6;

/// Simplifies to one level with vertices anywhere; the options must be in range.
///
/// # Errors
/// [`SimplifyError`] where the callback cancels, or vertices without a common edge are to be merged.
pub(super) fn simplify_optimal(
    welded: &Welded,
    options: &SimplifyOptions,
    progress: &mut ProgressFn<'_>,
) -> Result<Simplified, SimplifyError> {
    if let Some(distance) = options.sequence.pair_distance {
        let expected = "none where vertices are placed freely";
        return Err(SimplifyError::Option { option: "pair_distance", value: distance.to_string(), expected });
    }
    let mut merger = Merger::new(welded, &options.sequence);
    let mut goal = Goal::new(options, merger.counts());
    let limit = goal.limit;
    for retry in 0.. {
        let stop_reason = merger.run(&goal, progress)?;
        let (estimated, scale, removed_count) = (merger.error, merger.frame.scale, merger.removed_count);
        let mesh = merger.finish();
        let error = if removed_count > 0 { measured_error(&welded.mesh, &mesh) } else { 0.0 };
        if error <= limit + NOISE * scale {
            return Ok(Simplified { mesh, error: error.min(limit), stop_reason });
        }
        if goal.limit == 0.0 {
            break;
        }
        let smaller = estimated.min(goal.limit) * (0.9 * limit / error);
        goal.limit = if retry < MAX_RETRIES { smaller } else { 0.0 };
        merger = Merger::new(welded, &options.sequence);
    }
    Ok(Simplified { mesh: welded.mesh.clone(), error: 0.0, stop_reason: goal.at_limit })
}

/// How the loop sees the mesh: the centre of its bounds and their diagonal.
#[derive(Clone, Copy, Debug)]
struct Frame {
    centre: DVec3,
    scale: f64,
}

impl Frame {
    fn of(mesh: &IndexedMesh) -> Self {
        let Some(bounds) = mesh.bounds() else { return Self { centre: DVec3::ZERO, scale: 1.0 } };
        let [min, max] = [bounds.min, bounds.max].map(|p| DVec3::from(p.map(f64::from)));
        let scale = if bounds.diagonal() > 0.0 { bounds.diagonal() } else { 1.0 };
        Self { centre: 0.5 * (min + max), scale }
    }

    fn enter(&self, p: [f32; 3]) -> DVec3 {
        (DVec3::from(p.map(f64::from)) - self.centre) / self.scale
    }

    fn leave(&self, p: DVec3) -> [f32; 3] {
        let limit = f64::from(f32::MAX);
        (p * self.scale + self.centre).to_array().map(|x| x.clamp(-limit, limit) as f32)
    }
}

/// A collapse that was judged in full.
#[derive(Clone, Copy, Debug)]
struct Choice {
    other: u32,
    other_version: u32,
    /// True where the other end is removed and this one kept.
    is_kept: bool,
    place: DVec3,
    tier: Tier,
    /// Squared distance that a relaxed collapse leaves.
    distance_squared: f32,
}

const NO_CHOICE: Choice = Choice {
    other: UNDECIDED,
    other_version: 0,
    is_kept: false,
    place: DVec3::ZERO,
    tier: Tier::Strict,
    distance_squared: 0.0,
};

/// What is known of a position and its star.
#[derive(Clone, Copy, Debug, Default)]
struct Known {
    form: Form,
    /// Rises whenever the star changes.
    version: u32,
    border_count: u32,
}

/// All state of one simplification.
struct Merger<'a> {
    welded: &'a Welded,
    frame: Frame,
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
    /// Positions whose witnesses settle anew, and others that do.
    gone: Vec<u32>,
    followers: Vec<u32>,
    pairs: Vec<(u32, u32)>,
    /// For every vertex, the one it merged into, or itself.
    targets: Vec<u32>,
    layers: Vec<crate::mesh::AttributeLayer>,
    triangle_count: usize,
    vertex_count: usize,
    removed: Vec<u32>,
    /// Positions that are not there any more.
    removed_count: usize,
    error: f64,
}

impl<'a> Merger<'a> {
    fn new(welded: &'a Welded, options: &SequenceOptions) -> Self {
        let mesh = &welded.mesh;
        let frame = Frame::of(mesh);
        let position_count = welded.positions.position_count();
        let place = |p| frame.enter(mesh.positions[welded.positions.first_vertex(p) as usize]);
        let positions: Vec<DVec3> = (0..position_count as u32).map(place).collect();
        let options =
            SequenceOptions { cost: CollapseCost::Memoryless, pair_distance: None, ..options.clone() };
        let mut judge = Judge::new(welded, &options, scaled_positions(welded));
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

    fn counts(&self) -> Counts {
        Counts {
            triangles: self.triangle_count,
            vertices: self.vertex_count,
            removable: self.judge.is_locked.iter().filter(|is_locked| !**is_locked).count(),
        }
    }

    /// Collapses the cheapest edge until the goal is reached or nothing is left to do.
    fn run(&mut self, goal: &Goal, progress: &mut ProgressFn<'_>) -> Result<StopReason, SimplifyError> {
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
            if done.is_multiple_of(4096)
                && progress(Progress { phase: "simplify", done, total }) == ControlFlow::Break(())
            {
                return Err(Cancelled.into());
            }
        }
        Ok(goal.reached(self.triangle_count, self.vertex_count, self.removed_count).unwrap_or(goal.at_base))
    }

    /// The position that comes next, and its key; lets relaxed collapses begin if they had to wait for the end.
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

    /// True where `v` has a choice that still stands; else it has none any more.
    fn is_decided(&mut self, v: u32) -> bool {
        let choice = self.choices[v as usize];
        if choice.other == UNDECIDED {
            return false;
        }
        let is_fresh = self.known[choice.other as usize].version == choice.other_version;
        let (removed, kept) = if choice.is_kept { (choice.other, v) } else { (v, choice.other) };
        // Links beyond the two stars may have changed what is allowed.
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

    fn gather(&mut self, v: u32) {
        gather_into(&mut self.hood, (&self.judge, &self.positions, self.seams), v);
    }

    /// Computes the star of `v` anew after a change.
    fn renew(&mut self, v: u32) {
        self.gather(v);
        let known = &mut self.known[v as usize];
        known.form = self.hood.form();
        known.border_count = self.hood.borders.len() as u32;
        known.version += 1;
        self.choices[v as usize] = NO_CHOICE;
    }

    /// The least that collapsing an edge of `v` can cost; infinite where none may be collapsed.
    fn lower_bound(&mut self, v: u32) -> f32 {
        self.gather(v);
        self.fill_costs(v);
        let least = self.costs.iter().copied().fold(f32::INFINITY, f32::min);
        if least < f32::INFINITY || !self.relaxation.is_possible() || self.judge.is_fixed(v) {
            return least;
        }
        self.judge.gather(v);
        self.judge.fill_costs(v);
        self.judge.star.costs.iter().copied().fold(f32::INFINITY, f32::min)
    }

    /// Costs of all edges of the gathered `v`, by the forms alone.
    fn fill_costs(&mut self, v: u32) {
        self.costs.clear();
        for i in 0..self.hood.ids.len() {
            let cost = match self.course(v, i) {
                Course::Nowhere => f64::INFINITY,
                course => first_cost(&self.edge_form(v, i), course, self.hood.offsets[i]),
            };
            self.costs.push(cost as f32);
        }
    }

    fn edge_form(&self, v: u32, i: usize) -> EdgeForm {
        let other = &self.known[self.hood.ids[i] as usize].form;
        EdgeForm::new(&self.known[v as usize].form, other, self.hood.shared(i), self.hood.offsets[i])
    }

    /// Where the edge from the gathered `v` to its neighbour `i` may put its vertex.
    fn course(&self, v: u32, i: usize) -> Course {
        let u = self.hood.ids[i];
        let borders = [v, u].map(|p| self.known[p as usize].border_count);
        let locked = [v, u].map(|p| self.judge.is_locked[p as usize]);
        let stays = if self.hood.is_border(i) {
            // Where borders meet or end, the vertex holds them in place.
            [0, 1].map(|end| locked[end] || borders[end] != 2)
        } else {
            if borders[0] > 0 && borders[1] > 0 {
                return Course::Nowhere;
            }
            [0, 1].map(|end| locked[end] || borders[end] > 0)
        };
        match (stays, locked) {
            (_, [true, true]) => Course::Nowhere,
            ([false, false], _) => Course::Free,
            ([true, false], _) => Course::Here,
            ([false, true], _) => Course::There,
            // Only an end that is locked must be the one that stays.
            ([true, true], [true, false]) if self.hood.is_border(i) => Course::Here,
            ([true, true], [false, true]) if self.hood.is_border(i) => Course::There,
            ([true, true], [false, false]) => Course::Ends,
            _ => Course::Nowhere,
        }
    }

    /// Judges the edges of `v` in full and puts it back with its true cost, or takes it out where none is allowed.
    fn decide(&mut self, v: u32, bound: f32) {
        self.gather(v);
        self.fill_costs(v);
        let mut best: Option<(f32, Choice)> = None;
        loop {
            let limit = best.map_or(f32::INFINITY, |(cost, _)| cost);
            let least = self.costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
            let Some(i) = least.filter(|(_, cost)| **cost < limit).map(|(i, _)| i) else { break };
            self.costs[i] = f32::INFINITY;
            if let Some(found) = self.judge(v, i, limit).filter(|(cost, _)| *cost < limit) {
                best = Some(found);
            }
        }
        match best.or_else(|| self.relaxed(v)) {
            None => self.heap.remove(v),
            Some((cost, choice)) => {
                self.choices[v as usize] = choice;
                if cost > bound {
                    self.heap.set(v, cost);
                }
            }
        }
    }

    /// The relaxed collapse of `v`, if it may have one now, and its cost.
    fn relaxed(&mut self, v: u32) -> Option<(f32, Choice)> {
        if self.judge.is_fixed(v) {
            return None;
        }
        self.relaxation.consider(&mut self.judge, (&self.removed, &self.targets));
        self.judge.gather(v);
        let judge::Choice { tier, cost, target, distance_squared, .. } = self.judge.relaxed_choice(v)?;
        let (place, other_version) = (self.positions[target as usize], self.known[target as usize].version);
        Some((cost, Choice { other: target, other_version, is_kept: false, place, tier, distance_squared }))
    }

    /// The first place for the vertex of an edge that passes all tests, or the cheapest if seams are crossed; and its cost.
    fn judge(&mut self, v: u32, i: usize, limit: f32) -> Option<(f32, Choice)> {
        let course = self.course(v, i);
        let u = self.hood.ids[i];
        let edge = self.edge_form(v, i);
        let offset = self.hood.offsets[i];
        gather_into(&mut self.other_hood, (&self.judge, &self.positions, self.seams), u);
        let both_move = course == Course::Free;
        let mut crossings = Crossings::default();
        let mut best: Option<(f32, Choice)> = None;
        for (local, is_kept) in places(&edge, course, offset).into_iter().flatten() {
            let (removed, kept) = if is_kept { (u, v) } else { (v, u) };
            // Ends stay where they are, without any rounding.
            let is_end = local == if is_kept { DVec3::ZERO } else { offset };
            let place = if is_end { self.positions[kept as usize] } else { self.hood.centre + local };
            let merge = Merge { removed, kept, share: self.share_of(removed, kept, place) };
            if edge.cost(local) as f32 >= best.map_or(limit, |(least, _)| least) {
                continue;
            }
            let Judge { legality, links, .. } = &mut self.judge;
            let is_allowed = legality.allows(links, removed, kept);
            if !is_allowed && both_move {
                break;
            }
            let seams = (&mut self.judge, self.seams);
            let crossing = if is_allowed { crossings.cost(seams, (merge, v), both_move) } else { None };
            let Some(crossing) = crossing else {
                if both_move && self.seams == SeamRule::Keep {
                    break;
                }
                continue;
            };
            let mean = edge.normal();
            if self.hood.may_move(place, u, mean) && self.other_hood.may_move(place, v, mean) {
                let left = self.hood.distance_squared(place, u) + self.other_hood.distance_squared(place, v);
                let distance_cost = DISTANCE_WEIGHT * (edge.area() + SPIKE_WEIGHT * left) * left;
                let cost = (edge.cost(local) + distance_cost + crossing) as f32;
                if best.is_none_or(|(least, _)| cost < least) {
                    let other_version = self.known[u as usize].version;
                    best = Some((cost, Choice { other: u, other_version, is_kept, place, ..NO_CHOICE }));
                }
                if crossing == 0.0 {
                    break;
                }
            }
        }
        best
    }

    /// Does what was chosen for `v` and looks again at all around it; false, with nothing done, where
    /// the error would exceed the limit.
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
        // Each vanished triangle stood in both links.
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

    /// Settles what stood for the original at the ends of an edge that was collapsed; the largest squared distance. Leaves the
    /// removed position, the kept one and all that have lost their last triangle in `gone`.
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

    /// How far along the edge from `kept` to `removed` the new place lies, 0 to 1.
    fn share_of(&self, removed: u32, kept: u32, place: DVec3) -> f64 {
        let from = self.positions[kept as usize];
        let along = self.positions[removed as usize] - from;
        let share = (place - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
        share.clamp(0.0, 1.0)
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

    /// The mesh that is left.
    fn finish(mut self) -> IndexedMesh {
        let positions = &self.welded.positions;
        for v in 0..self.targets.len() {
            let mut root = self.targets[v];
            while self.targets[root as usize] != root {
                root = self.targets[root as usize];
            }
            let mut p = v;
            while p as u32 != root {
                p = std::mem::replace(&mut self.targets[p], root) as usize;
            }
        }
        let source = &self.welded.mesh;
        let mut mesh = IndexedMesh {
            positions: source.positions.clone(),
            triangles: Vec::with_capacity(self.triangle_count),
            layers: self.layers,
            groups: source.groups.clone(),
            appearance: source.appearance.clone(),
        };
        for (v, place) in mesh.positions.iter_mut().enumerate() {
            let p = positions.position_of(v as u32) as usize;
            if self.is_moved[p] {
                *place = self.frame.leave(self.positions[p]);
            }
        }
        let targets = &self.targets;
        let left = |t: &[u32; 3]| {
            let corners = t.map(|v| targets[v as usize]);
            let [a, b, c] = corners.map(|v| positions.position_of(v));
            (a != b && b != c && c != a).then_some(corners)
        };
        if source.groups.is_empty() {
            mesh.triangles.extend(source.triangles.iter().filter_map(left));
        }
        for group in &mut mesh.groups {
            let first = mesh.triangles.len();
            mesh.triangles.extend(source.triangles[group.range()].iter().filter_map(left));
            (group.first, group.count) = (first as u32, (mesh.triangles.len() - first) as u32);
        }
        mesh.without_unused_vertices()
    }
}

/// Gathers the star of `v` with its seams.
fn gather_into(hood: &mut Hood, (judge, positions, seams): (&Judge<'_>, &[DVec3], SeamRule), v: u32) {
    if judge.wedges.as_ref().is_some_and(|wedges| wedges.is_split(v)) {
        let weight = |triangles: [u32; 2], along: DVec3| seam_weight(judge, seams, (v, triangles), along);
        hood.gather(&judge.links, positions, v, Some(&weight));
    } else {
        hood.gather(&judge.links, positions, v, None);
    }
}
