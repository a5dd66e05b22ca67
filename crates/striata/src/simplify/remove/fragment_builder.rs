//! The loop: removes the cheapest vertex, fills its hole and updates the costs around it.

use crate::mesh::Welded;
use crate::simplify::certify::Cover;
use crate::simplify::collapse::cost_evaluator::CostEvaluator;
use crate::simplify::collapse::heap::IndexedHeap;
use crate::simplify::collapse::relaxation_schedule::RelaxationSchedule;
use crate::simplify::collapse::wedges::Wedges;
use crate::simplify::options::{SimplifyError, StopReason, TopologyRule};
use crate::{Progress, ProgressFn};

use super::removal_evaluator::{
    CollapsePhase, Filling, RemovalCandidate, RemovalEvaluator, RemovalPrecision,
};
use super::removal_options::{RemovalOptions, RemovalOrder, Retriangulation};
use super::removal_record::{Faces, RemovalOutcome, RemovalRecord};

/// Number of removals between two progress reports.
const REPORT_INTERVAL: u64 = 4096;

/// In mixed order, a cost may exceed its key by this factor; evaluating every vertex twice would gain almost
/// nothing.
const COST_TOLERANCE: f32 = 1.2;

/// Complete state of one simplification.
pub(super) struct FragmentBuilder<'a> {
    options: &'a RemovalOptions,
    welded: &'a Welded,
    evaluator: RemovalEvaluator<'a>,
    schedule: RelaxationSchedule<'a>,
    /// Whether some floor was empty, for which the error is only bounded by the size of the mesh.
    has_vanished: bool,
    cover: Cover,
    heap: IndexedHeap,
    triangle_count: usize,
    record: RemovalRecord,
    floor: Vec<([u32; 3], u32)>,
    floor_triangles: Vec<(u32, [[f64; 3]; 3])>,
    filled: Vec<(u32, [u32; 3])>,
    ring: Vec<u32>,
}

impl<'a> FragmentBuilder<'a> {
    pub(super) fn new(welded: &'a Welded, options: &'a RemovalOptions) -> Self {
        let keeps_features = options.feature_angle.is_some();
        let topology = if keeps_features { TopologyRule::Keep } else { options.topology };
        let evaluator = RemovalEvaluator::new(welded, options);
        let is_collapsing = options.retriangulation == Retriangulation::Collapse;
        let targets = is_collapsing.then(|| vec![0; welded.mesh.vertex_count()]);
        Self {
            options,
            welded,
            evaluator,
            // Sharp edges stay, whatever the cost.
            schedule: RelaxationSchedule::new(welded, topology),
            has_vanished: false,
            cover: Cover::new(&welded.mesh.positions, &welded.mesh.triangles),
            heap: IndexedHeap::new(&[]),
            triangle_count: welded.mesh.triangle_count(),
            record: RemovalRecord { targets, ..RemovalRecord::default() },
            floor: Vec::new(),
            floor_triangles: Vec::new(),
            filled: Vec::new(),
            ring: Vec::new(),
        }
    }

    /// Removes vertices until none can be removed, the base size is reached, or the error limit forbids
    /// all that are left.
    pub(super) fn run(mut self, progress: &mut ProgressFn<'_>) -> Result<RemovalOutcome, SimplifyError> {
        let total = self.evaluator.collapse_evaluator.positions.len() as u64;
        if self.schedule.is_possible() {
            self.schedule.begin_or_postpone(&mut self.evaluator.collapse_evaluator, (&[], &[]));
            if self.schedule.is_postponed() {
                self.schedule.begin(&mut self.evaluator.collapse_evaluator, (&[], &[]));
            } else {
                self.evaluator.phase = CollapsePhase::Relaxed;
            }
        }
        let mut keys = Vec::with_capacity(self.evaluator.collapse_evaluator.positions.len());
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
            let Some(candidate) = self.evaluator.evaluate(v, RemovalPrecision::Exact) else {
                // Changes nearby have made the removal illegal.
                self.heap.remove(v);
                continue;
            };
            if self.requeue_if_costlier(v, key, candidate.cost) {
                continue;
            }
            let error = self.propose(v, candidate.filling);
            let vanishes = self.floor.is_empty();
            if f64::from(error) > limit {
                is_limited = true;
                self.heap.remove(v);
                continue;
            }
            // The proven bound replaces the largest distance of the tracked vertices.
            let known = if vanishes { 0.0 } else { self.evaluator.scaled_squared(error) };
            if self.requeue_if_costlier(v, key.max(candidate.cost), self.proven_cost(candidate, known)) {
                continue;
            }
            self.remove(v, candidate.filling, error);
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
        while self.heap.first().is_none() && self.schedule.is_possible() {
            self.evaluator.phase = match self.evaluator.phase {
                CollapsePhase::Strict => CollapsePhase::Relaxed,
                CollapsePhase::Relaxed => CollapsePhase::Hubs,
                CollapsePhase::Hubs => break,
            };
            for v in 0..self.evaluator.collapse_evaluator.positions.len() as u32 {
                let key = self.key(v);
                self.heap.set(v, key);
            }
        }
        self.heap.first()
    }

    /// Returns the cost of a removal with a proven bound on the squared distance, scaled units.
    fn proven_cost(&self, candidate: RemovalCandidate, bound: f32) -> f32 {
        match self.options.order {
            RemovalOrder::Mixed => {
                let spike = RemovalEvaluator::spike_cost;
                candidate.cost + spike(bound.max(candidate.worst)) - spike(candidate.worst)
            }
            RemovalOrder::Hausdorff => bound.max(candidate.cost),
        }
    }

    /// Updates the key of `v` if its true cost is well above the key that it came up with; returns
    /// whether another vertex comes first then.
    fn requeue_if_costlier(&mut self, v: u32, key: f32, cost: f32) -> bool {
        let tolerance = match self.options.order {
            RemovalOrder::Mixed => COST_TOLERANCE,
            RemovalOrder::Hausdorff => 1.0,
        };
        if cost <= tolerance * key {
            return false;
        }
        self.heap.set(v, cost);
        self.heap.first().is_some_and(|(_, first)| first != v)
    }

    fn end(mut self, stop_reason: StopReason) -> RemovalOutcome {
        let corners = self.evaluator.collapse_evaluator.wedges.map(Wedges::into_corners).unwrap_or_default();
        self.record.has_vanished = self.has_vanished;
        RemovalOutcome {
            record: self.record,
            faces: Faces { corners, groups: self.evaluator.groups },
            stop_reason,
        }
    }

    fn key(&mut self, v: u32) -> f32 {
        self.evaluator
            .evaluate(v, RemovalPrecision::Estimate)
            .map_or(f32::INFINITY, |candidate| candidate.cost)
    }

    /// Returns a bound, in mesh units and rounded up, on the distance of the surface that the last
    /// evaluated floor represents.
    fn propose(&mut self, v: u32, filling: Filling) -> f32 {
        let evaluator = &mut self.evaluator;
        evaluator.floor_faces(v, filling, &mut self.floor);
        let first = evaluator.groups.len() as u32;
        let positions = &self.welded.mesh.positions;
        let to_f64 = |corner: u32| positions[corner as usize].map(f64::from);
        self.floor_triangles.clear();
        self.floor_triangles
            .extend((first..).zip(&self.floor).map(|(face_index, face)| (face_index, face.0.map(to_f64))));
        let bound =
            self.cover.propose(&evaluator.collapse_evaluator.star.ring.triangles, &self.floor_triangles);
        let nearest = bound as f32;
        let up = if f64::from(nearest) < bound { nearest.next_up() } else { nearest };
        up.min(f32::MAX)
    }

    fn remove(&mut self, v: u32, filling: Filling, error: f32) {
        self.cover.commit();
        let evaluator = &mut self.evaluator;
        let nearest = (0..evaluator.collapse_evaluator.star.ring.ids.len()).min_by(|&a, &b| {
            let squared = |i| evaluator.collapse_evaluator.star.offset(i).length_squared();
            squared(a).total_cmp(&squared(b))
        });
        let k = match filling {
            Filling::Collapse(k) | Filling::Relaxed(k) => k,
            Filling::Free => nearest.unwrap_or(0),
        };
        let target = evaluator.collapse_evaluator.star.ring.ids[k];
        if let Some(targets) = &mut self.record.targets {
            evaluator.collapse_evaluator.pair(v, k);
            if let Some(wedges) = &evaluator.collapse_evaluator.wedges {
                wedges.write_targets(v, target, targets);
            }
        }
        let first = evaluator.groups.len() as u32;
        self.filled.clear();
        let CostEvaluator { star, wedges, links, .. } = &mut evaluator.collapse_evaluator;
        if let Some(wedges) = wedges {
            for (face_index, &(corners, group)) in (first..).zip(&self.floor) {
                wedges.push(corners);
                evaluator.groups.push(group);
                self.filled.push((face_index, corners.map(|c| wedges.position_of(c))));
            }
        }
        evaluator.points.assign_loaded(first, &evaluator.floor_corners);
        self.ring.clear();
        self.ring.extend_from_slice(&star.ring.ids);
        self.record.ceilings.extend_from_slice(&star.ring.triangles);
        let removed = star.ring.triangle_count() - self.floor.len();
        self.triangle_count -= removed;
        links.fill(v, &self.filled);
        self.record.push(v, error, evaluator.groups.len() as u32);
        if let Some(lost_positions) =
            evaluator.collapse_evaluator.note_collapse(v, target, removed, &self.ring)
        {
            let host = lost_positions.host.unwrap_or(target);
            for &p in &lost_positions.positions {
                self.record.push(p, error, evaluator.groups.len() as u32);
                if let Some(targets) = &mut self.record.targets {
                    evaluator.collapse_evaluator.write_single_target(p, host, targets);
                }
                self.heap.remove(p);
            }
            evaluator.collapse_evaluator.recycle(lost_positions);
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
