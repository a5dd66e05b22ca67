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
//! Borders (boundaries, seams, edges with three triangles) keep their course: a vertex on one merges along it only, an
//! inner vertex merges into it without moving it, and where borders meet or end, the vertex stays in place.
//!
//! Differs: always memoryless; attributes do not count in the cost, and pairs without an edge are never merged.
//! Time O(n log n), about 300 bytes a vertex.

mod blend;
mod course;
mod drift;
mod form;
mod goal;
mod hood;
mod seams;

use std::ops::ControlFlow;

use glam::DVec3;

use crate::mesh::{IndexedMesh, Welded};
use crate::{Cancelled, Progress, ProgressFn};

use super::heap::IndexedHeap;
use super::legality::Legality;
use super::links::Links;
use super::options::{BoundaryRule, SequenceOptions, Simplified, SimplifyError, SimplifyOptions, StopReason};
use course::{Course, first_cost, places};
use drift::Drift;
use form::{EdgeForm, Form};
use goal::{Counts, Goal};
use hood::Hood;
use seams::Seams;

/// No edge chosen yet: the key is a lower bound.
const UNDECIDED: u32 = u32::MAX;
/// Weight of the squared distances of both ends from the new triangles, times the area: 1 % of RMS for maxima that
/// are a fifth less, since planes alone do not see that a thin spike is lost.
const DISTANCE_WEIGHT: f64 = 0.1;

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
    let goal = Goal::new(options, merger.counts());
    let stop_reason = merger.run(&goal, progress)?;
    let error = merger.error;
    Ok(Simplified { mesh: merger.finish(), error, stop_reason })
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
}

const NO_CHOICE: Choice = Choice { other: UNDECIDED, other_version: 0, is_kept: false, place: DVec3::ZERO };

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
    is_locked: Vec<bool>,
    links: Links,
    seams: Option<Seams<'a>>,
    known: Vec<Known>,
    choices: Vec<Choice>,
    heap: IndexedHeap,
    legality: Legality,
    drift: Drift,
    hood: Hood,
    other_hood: Hood,
    costs: Vec<f32>,
    ring: Vec<u32>,
    pairs: Vec<(u32, u32)>,
    /// For every vertex, the one it merged into, or itself.
    targets: Vec<u32>,
    layers: Vec<crate::mesh::AttributeLayer>,
    triangle_count: usize,
    vertex_count: usize,
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
        let has_wedges = !welded.positions.is_identity();
        let links = if has_wedges {
            let of = |t: &[u32; 3]| t.map(|v| welded.positions.position_of(v));
            let triangles: Vec<[u32; 3]> = mesh.triangles.iter().map(of).collect();
            Links::new(position_count, &triangles, true)
        } else {
            Links::new(position_count, &mesh.triangles, false)
        };
        Self {
            welded,
            frame,
            is_moved: vec![false; position_count],
            is_locked: locked_positions(welded, &links, options),
            links,
            seams: has_wedges.then(|| Seams::new(welded, &positions)),
            known: vec![Known::default(); position_count],
            choices: vec![NO_CHOICE; position_count],
            heap: IndexedHeap::new(&[]),
            legality: Legality::default(),
            drift: Drift::new(positions.clone()),
            positions,
            hood: Hood::default(),
            other_hood: Hood::default(),
            costs: Vec::new(),
            ring: Vec::new(),
            pairs: Vec::new(),
            targets: (0..mesh.vertex_count() as u32).collect(),
            layers: mesh.layers.clone(),
            triangle_count: mesh.triangle_count(),
            vertex_count: mesh.vertex_count(),
            removed_count: 0,
            error: 0.0,
        }
    }

    fn counts(&self) -> Counts {
        Counts {
            triangles: self.triangle_count,
            vertices: self.vertex_count,
            removable: self.is_locked.iter().filter(|is_locked| !**is_locked).count(),
        }
    }

    /// Collapses the cheapest edge until the goal is reached or nothing is left to do.
    fn run(&mut self, goal: &Goal, progress: &mut ProgressFn<'_>) -> Result<StopReason, SimplifyError> {
        if let Some(reason) = goal.reached(self.triangle_count, self.vertex_count, 0) {
            return Ok(reason);
        }
        let position_count = self.positions.len() as u32;
        (0..position_count).for_each(|v| self.renew(v));
        let keys: Vec<f32> = (0..position_count).map(|v| self.lower_bound(v)).collect();
        self.heap = IndexedHeap::new(&keys);
        drop(keys);
        let total = goal.removals.min(self.positions.len()) as u64;
        while let Some((key, v)) = self.heap.first() {
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

    /// True where `v` has a choice that still stands; else it has none any more.
    fn is_decided(&mut self, v: u32) -> bool {
        let choice = self.choices[v as usize];
        if choice.other == UNDECIDED {
            return false;
        }
        let is_fresh = self.known[choice.other as usize].version == choice.other_version;
        let (removed, kept) = if choice.is_kept { (choice.other, v) } else { (v, choice.other) };
        // Links beyond the two stars may have changed what is allowed.
        let stands = is_fresh && self.legality.allows(&self.links, removed, kept);
        if !stands {
            self.choices[v as usize] = NO_CHOICE;
        }
        stands
    }

    fn gather(&mut self, v: u32) {
        gather_into(&mut self.hood, (&self.links, &self.positions, self.seams.as_ref()), v);
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
        self.costs.iter().copied().fold(f32::INFINITY, f32::min)
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
        let locked = [v, u].map(|p| self.is_locked[p as usize]);
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
            if let Some(found) = self.judge(v, i).filter(|(cost, _)| *cost < limit) {
                best = Some(found);
            }
        }
        match best {
            None => self.heap.remove(v),
            Some((cost, choice)) => {
                self.choices[v as usize] = choice;
                if cost > bound {
                    self.heap.set(v, cost);
                }
            }
        }
    }

    /// The first place for the vertex of an edge that passes all tests, and its cost.
    fn judge(&mut self, v: u32, i: usize) -> Option<(f32, Choice)> {
        let course = self.course(v, i);
        let u = self.hood.ids[i];
        let edge = self.edge_form(v, i);
        let offset = self.hood.offsets[i];
        gather_into(&mut self.other_hood, (&self.links, &self.positions, self.seams.as_ref()), u);
        let both_move = course == Course::Free;
        for (local, is_kept) in places(&edge, course, offset).into_iter().flatten() {
            let (removed, kept) = if is_kept { (u, v) } else { (v, u) };
            if !self.legality.allows(&self.links, removed, kept)
                || self.seams.as_mut().is_some_and(|s| !s.allow(&self.links, (removed, kept), both_move))
            {
                if both_move {
                    return None;
                }
                continue;
            }
            let place = self.hood.centre + local;
            let mean = edge.normal();
            if self.hood.may_move(place, u, mean) && self.other_hood.may_move(place, v, mean) {
                let left = self.hood.distance_squared(place, u) + self.other_hood.distance_squared(place, v);
                let cost = edge.cost(local) + DISTANCE_WEIGHT * edge.area() * left;
                let other_version = self.known[u as usize].version;
                return Some((cost as f32, Choice { other: u, other_version, is_kept, place }));
            }
        }
        None
    }

    /// Does what was chosen for `v` and looks again at all around it; false, with nothing done, where
    /// the error would exceed the limit.
    fn collapse(&mut self, v: u32, limit: f64) -> bool {
        let Choice { other, is_kept, place, .. } = self.choices[v as usize];
        let (removed, kept) = if is_kept { (other, v) } else { (v, other) };
        self.ring.clear();
        for p in [removed, kept] {
            self.ring.extend(self.links.entries(p).iter().filter(|&&w| w != removed && w != kept));
        }
        self.ring.sort_unstable();
        self.ring.dedup();
        self.ring.push(kept);
        let share = self.share_of(removed, kept, place);
        let undone = self.positions[kept as usize];
        self.merge_vertices(removed, kept);
        let count = |links: &Links, p| links.triangle_count(p);
        let before = count(&self.links, removed) + count(&self.links, kept);
        self.links.collapse(removed, kept);
        self.positions[kept as usize] = place;
        let worst = self.drift.collapse(&self.links, &self.positions, removed, kept);
        let error = self.error.max(f64::from(worst).sqrt() * self.frame.scale);
        if error > limit {
            self.positions[kept as usize] = undone;
            self.welded.positions.wedges(removed).for_each(|w| self.targets[w as usize] = w);
            return false;
        }
        self.error = error;
        // Each vanished triangle stood in both links.
        self.triangle_count -= (before - count(&self.links, kept)) / 2;
        self.vertex_count -= self.welded.positions.wedges(removed).len();
        self.removed_count += 1;
        if place != undone {
            self.is_moved[kept as usize] = true;
            self.seams.iter_mut().for_each(|seams| seams.place(kept, place));
        }
        self.pairs.iter().for_each(|&(from, to)| blend::blend(&mut self.layers, from, to, share));
        self.heap.remove(removed);
        self.look_again();
        true
    }

    /// How far along the edge from `kept` to `removed` the new place lies, 0 to 1.
    fn share_of(&self, removed: u32, kept: u32, place: DVec3) -> f64 {
        let from = self.positions[kept as usize];
        let along = self.positions[removed as usize] - from;
        let share = (place - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
        share.clamp(0.0, 1.0)
    }

    /// Writes the targets of the removed vertices and, into `pairs`, whose attributes mix.
    fn merge_vertices(&mut self, removed: u32, kept: u32) {
        self.pairs.clear();
        match &mut self.seams {
            Some(seams) => seams.merge(&self.links, (removed, kept), &mut self.targets, &mut self.pairs),
            None => {
                self.targets[removed as usize] = kept;
                self.pairs.push((removed, kept));
            }
        }
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
fn gather_into(hood: &mut Hood, (links, positions, seams): (&Links, &[DVec3], Option<&Seams<'_>>), v: u32) {
    match seams {
        Some(seams) if seams.wedges.is_split(v) => {
            let is_seam = |s, t| seams.wedges.shown(s, v) != seams.wedges.shown(t, v);
            hood.gather(links, positions, v, Some(&is_seam));
        }
        _ => hood.gather(links, positions, v, None),
    }
}

/// Positions that may neither move nor go.
fn locked_positions(welded: &Welded, links: &Links, options: &SequenceOptions) -> Vec<bool> {
    let mut is_locked =
        crate::simplify::judge::locked_positions(welded, &options.locked_vertices, options.group_borders);
    if options.boundary == BoundaryRule::Locked {
        for (p, is_locked) in (0..).zip(&mut is_locked) {
            *is_locked |= links.is_boundary(p);
        }
    }
    is_locked
}
