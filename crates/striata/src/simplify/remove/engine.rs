//! The loop: removes the cheapest vertex, fills its hole and updates the costs around it.

use crate::mesh::Welded;
use crate::simplify::certify::Cover;
use crate::simplify::collapse::heap::IndexedHeap;
use crate::simplify::collapse::judge::Judge as CollapseJudge;
use crate::simplify::collapse::relaxation::Relaxation;
use crate::simplify::collapse::wedges::Wedges;
use crate::simplify::options::{SimplifyError, StopReason, TopologyRule};
use crate::{Progress, ProgressFn};

use super::judge::{Depth, Filling, Judge, Reach};
use super::options::{RemovalOptions, Retriangulation};
use super::record::{Faces, Outcome, RemovalRecord};

/// Number of removals between two progress reports.
const REPORT_INTERVAL: u64 = 4096;

/// A cost may exceed its key by this factor; evaluating every vertex twice would gain almost nothing.
const TOLERANCE: f32 = 1.2;

/// Complete state of one simplification.
pub(super) struct Engine<'a> {
    options: &'a RemovalOptions,
    welded: &'a Welded,
    judge: Judge<'a>,
    relaxation: Relaxation<'a>,
    /// Whether some floor was empty, for which the error is only bounded by the size of the mesh.
    has_vanished: bool,
    cover: Cover,
    heap: IndexedHeap,
    triangle_count: usize,
    record: RemovalRecord,
    floor: Vec<([u32; 3], u32)>,
    placed: Vec<(u32, [[f64; 3]; 3])>,
    filled: Vec<(u32, [u32; 3])>,
    ring: Vec<u32>,
}

impl<'a> Engine<'a> {
    pub(super) fn new(welded: &'a Welded, options: &'a RemovalOptions) -> Self {
        let keeps_features = options.feature_angle.is_some();
        let topology = if keeps_features { TopologyRule::Keep } else { options.topology };
        let judge = Judge::new(welded, options);
        let is_collapsing = options.retriangulation == Retriangulation::Collapse;
        let targets = is_collapsing.then(|| vec![0; welded.mesh.vertex_count()]);
        Self {
            options,
            welded,
            judge,
            // Sharp edges stay, whatever the cost.
            relaxation: Relaxation::new(welded, topology),
            has_vanished: false,
            cover: Cover::new(&welded.mesh.positions, &welded.mesh.triangles),
            heap: IndexedHeap::new(&[]),
            triangle_count: welded.mesh.triangle_count(),
            record: RemovalRecord { targets, ..RemovalRecord::default() },
            floor: Vec::new(),
            placed: Vec::new(),
            filled: Vec::new(),
            ring: Vec::new(),
        }
    }

    /// Removes vertices until none can be removed, the base size is reached, or the error limit forbids
    /// all that are left.
    pub(super) fn run(mut self, progress: &mut ProgressFn<'_>) -> Result<Outcome, SimplifyError> {
        let total = self.judge.collapses.positions.len() as u64;
        if self.relaxation.is_possible() {
            self.relaxation.consider(&mut self.judge.collapses, (&[], &[]));
            if self.relaxation.is_waiting() {
                self.relaxation.begin(&mut self.judge.collapses, (&[], &[]));
            } else {
                self.judge.reach = Reach::Relaxed;
            }
        }
        let mut keys = Vec::with_capacity(self.judge.collapses.positions.len());
        for v in 0..total as u32 {
            keys.push(self.key(v));
        }
        self.heap = IndexedHeap::new(&keys);
        drop(keys);
        let limit = self.options.max_error.unwrap_or(f64::INFINITY);
        let mut is_limited = false;
        while let Some((key, v)) = self.next() {
            if self.triangle_count <= self.options.base_triangle_count {
                return Ok(self.end(StopReason::TargetReached));
            }
            let Some(verdict) = self.judge.judge(v, Depth::Exact) else {
                // Changes nearby have made the removal illegal.
                self.heap.remove(v);
                continue;
            };
            if self.has_to_wait(v, key, verdict.cost) {
                continue;
            }
            let error = self.propose(v, verdict.filling);
            let vanishes = self.floor.is_empty();
            if f64::from(error) > limit {
                is_limited = true;
                self.heap.remove(v);
                continue;
            }
            // The proven bound replaces the largest distance of the tracked vertices.
            let known = if vanishes { 0.0 } else { self.judge.scaled_squared(error) };
            let bound = known.max(verdict.worst);
            let rise = Judge::spike_cost(bound) - Judge::spike_cost(verdict.worst);
            if self.has_to_wait(v, key.max(verdict.cost), verdict.cost + rise) {
                continue;
            }
            self.remove(v, verdict.filling, error);
            self.has_vanished |= vanishes;
            let done = self.record.removed.len() as u64;
            if done.is_multiple_of(REPORT_INTERVAL) {
                Progress { phase: "simplify", done, total }.report(progress)?;
            }
        }
        let is_met = self.triangle_count <= self.options.base_triangle_count;
        let reason = match (is_met, is_limited) {
            (true, _) => StopReason::TargetReached,
            (false, true) => StopReason::ErrorLimit,
            (false, false) => StopReason::BaseReached,
        };
        Ok(self.end(reason))
    }

    /// Returns the vertex with the smallest key, and that key; allows more kinds of collapses if none
    /// is left.
    fn next(&mut self) -> Option<(f32, u32)> {
        while self.heap.first().is_none() && self.relaxation.is_possible() {
            self.judge.reach = match self.judge.reach {
                Reach::Strict => Reach::Relaxed,
                Reach::Relaxed => Reach::Hubs,
                Reach::Hubs => break,
            };
            for v in 0..self.judge.collapses.positions.len() as u32 {
                let key = self.key(v);
                self.heap.set(v, key);
            }
        }
        self.heap.first()
    }

    /// Updates the key of `v` if its true cost is well above the key that it came up with; returns
    /// whether another vertex comes first then.
    fn has_to_wait(&mut self, v: u32, key: f32, cost: f32) -> bool {
        if cost <= TOLERANCE * key {
            return false;
        }
        self.heap.set(v, cost);
        self.heap.first().is_some_and(|(_, first)| first != v)
    }

    fn end(mut self, stop_reason: StopReason) -> Outcome {
        let corners = self.judge.collapses.wedges.map(Wedges::into_corners).unwrap_or_default();
        self.record.has_vanished = self.has_vanished;
        Outcome { record: self.record, faces: Faces { corners, groups: self.judge.groups }, stop_reason }
    }

    fn key(&mut self, v: u32) -> f32 {
        self.judge.judge(v, Depth::Estimate).map_or(f32::INFINITY, |verdict| verdict.cost)
    }

    /// Returns a bound, in mesh units and rounded up, on the distance of the surface that the last
    /// evaluated floor represents.
    fn propose(&mut self, v: u32, filling: Filling) -> f32 {
        let judge = &mut self.judge;
        judge.floor_faces(v, filling, &mut self.floor);
        let first = judge.groups.len() as u32;
        let positions = &self.welded.mesh.positions;
        let place = |corner: u32| positions[corner as usize].map(f64::from);
        self.placed.clear();
        self.placed.extend((first..).zip(&self.floor).map(|(number, face)| (number, face.0.map(place))));
        let bound = self.cover.propose(&judge.collapses.star.triangles, &self.placed);
        let nearest = bound as f32;
        let up = if f64::from(nearest) < bound { nearest.next_up() } else { nearest };
        up.min(f32::MAX)
    }

    fn remove(&mut self, v: u32, filling: Filling, error: f32) {
        self.cover.commit();
        let judge = &mut self.judge;
        let nearest = (0..judge.collapses.star.ids.len()).min_by(|&a, &b| {
            let squared = |i| judge.collapses.star.offset(i).length_squared();
            squared(a).total_cmp(&squared(b))
        });
        let k = match filling {
            Filling::Collapse(k) | Filling::Relaxed(k) => k,
            Filling::Free => nearest.unwrap_or(0),
        };
        let target = judge.collapses.star.ids[k];
        if let Some(targets) = &mut self.record.targets {
            judge.collapses.pair(v, k);
            if let Some(wedges) = &judge.collapses.wedges {
                wedges.write_targets(v, target, targets);
            }
        }
        let first = judge.groups.len() as u32;
        self.filled.clear();
        let CollapseJudge { star, wedges, links, .. } = &mut judge.collapses;
        if let Some(wedges) = wedges {
            for (number, &(corners, group)) in (first..).zip(&self.floor) {
                wedges.push(corners);
                judge.groups.push(group);
                self.filled.push((number, corners.map(|c| wedges.position_of(c))));
            }
        }
        judge.points.settle(first, &judge.floor_corners);
        self.ring.clear();
        self.ring.extend_from_slice(&star.ids);
        self.record.ceilings.extend_from_slice(&star.triangles);
        let removed = star.triangle_count() - self.floor.len();
        self.triangle_count -= removed;
        links.fill(v, &self.filled);
        self.record.push(v, error, judge.groups.len() as u32);
        if let Some(departure) = judge.collapses.note_departure(v, target, removed, &self.ring) {
            let place = departure.place.unwrap_or(target);
            for &p in &departure.lost {
                self.record.push(p, error, judge.groups.len() as u32);
                if let Some(targets) = &mut self.record.targets {
                    judge.collapses.write_single_target(p, place, targets);
                }
                self.heap.remove(p);
            }
            judge.collapses.forget(departure);
        }
        self.heap.remove(v);
        let ring = std::mem::take(&mut self.ring);
        for &w in &ring {
            let key = self.key(w);
            self.heap.set(w, key);
        }
        self.ring = ring;
    }
}
