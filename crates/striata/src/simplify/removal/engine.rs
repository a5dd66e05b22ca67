//! The loop: remove the vertex that costs least, fill its hole, look again at what surrounds it.

use std::ops::ControlFlow;

use crate::mesh::Welded;
use crate::simplify::cover::Cover;
use crate::simplify::heap::IndexedHeap;
use crate::simplify::options::{SimplifyError, StopReason};
use crate::{Cancelled, Progress, ProgressFn};

use super::judge::{Depth, Filling, Judge};
use super::options::{RemovalOptions, Retriangulation};
use super::record::{Faces, RemovalRecord};

/// Removals between two reports of progress.
const REPORT_INTERVAL: u64 = 4096;

/// A cost this much over its key is still taken: looking twice at every vertex would buy next to nothing.
const TOLERANCE: f32 = 1.2;

/// All state of one simplification.
pub(super) struct Engine<'a> {
    options: &'a RemovalOptions,
    welded: &'a Welded,
    judge: Judge<'a>,
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
        let judge = Judge::new(welded, options);
        let is_collapsing = options.retriangulation == Retriangulation::Collapse;
        let targets = is_collapsing.then(|| vec![0; welded.mesh.vertex_count()]);
        Self {
            options,
            welded,
            judge,
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

    /// Removes vertices until none can be, the base is reached or the error limit forbids all that are left.
    pub(super) fn run(
        mut self,
        progress: &mut ProgressFn<'_>,
    ) -> Result<(RemovalRecord, Faces, StopReason), SimplifyError> {
        let total = self.judge.positions.len() as u64;
        let mut keys = Vec::with_capacity(self.judge.positions.len());
        for v in 0..total as u32 {
            keys.push(self.key(v));
        }
        self.heap = IndexedHeap::new(&keys);
        drop(keys);
        let limit = self.options.max_error.unwrap_or(f64::INFINITY);
        let mut is_limited = false;
        while let Some((key, v)) = self.heap.first() {
            if self.triangle_count <= self.options.base_triangle_count {
                return Ok(self.end(StopReason::TargetReached));
            }
            let Some(verdict) = self.judge.judge(v, Depth::Exact) else {
                // What lies around has changed what is allowed.
                self.heap.remove(v);
                continue;
            };
            if self.has_to_wait(v, key, verdict.cost) {
                continue;
            }
            let error = self.propose(v, verdict.filling);
            if f64::from(error) > limit {
                is_limited = true;
                self.heap.remove(v);
                continue;
            }
            // The bound takes the place of what points have seen.
            let bound = self.judge.scaled_squared(error).max(verdict.worst);
            let rise = Judge::spike_cost(bound) - Judge::spike_cost(verdict.worst);
            if self.has_to_wait(v, key.max(verdict.cost), verdict.cost + rise) {
                continue;
            }
            self.remove(v, verdict.filling, error);
            let done = self.record.removed.len() as u64;
            let is_report = done.is_multiple_of(REPORT_INTERVAL);
            if is_report && progress(Progress { phase: "simplify", done, total }) == ControlFlow::Break(()) {
                return Err(Cancelled.into());
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

    /// Puts `v` back where its true cost is well over the key that it came up with; true if others come first then.
    fn has_to_wait(&mut self, v: u32, key: f32, cost: f32) -> bool {
        if cost <= TOLERANCE * key {
            return false;
        }
        self.heap.set(v, cost);
        self.heap.first().is_some_and(|(_, first)| first != v)
    }

    fn end(self, reason: StopReason) -> (RemovalRecord, Faces, StopReason) {
        let corners = self.judge.wedges.into_corners();
        (self.record, Faces { corners, groups: self.judge.groups }, reason)
    }

    fn key(&mut self, v: u32) -> f32 {
        self.judge.judge(v, Depth::Estimate).map_or(f32::INFINITY, |verdict| verdict.cost)
    }

    /// How far the surface that the floor judged last stands for may be from it, mesh units, rounded up.
    fn propose(&mut self, v: u32, filling: Filling) -> f32 {
        let judge = &mut self.judge;
        judge.floor_faces(v, filling, &mut self.floor);
        let first = judge.groups.len() as u32;
        let positions = &self.welded.mesh.positions;
        let place = |corner: u32| positions[corner as usize].map(f64::from);
        self.placed.clear();
        self.placed.extend((first..).zip(&self.floor).map(|(number, face)| (number, face.0.map(place))));
        let bound = self.cover.propose(&judge.star.triangles, &self.placed);
        let nearest = bound as f32;
        let up = if f64::from(nearest) < bound { nearest.next_up() } else { nearest };
        up.min(f32::MAX)
    }

    fn remove(&mut self, v: u32, filling: Filling, error: f32) {
        self.cover.commit();
        let judge = &mut self.judge;
        if let (Some(targets), Filling::Collapse(k)) = (&mut self.record.targets, filling) {
            judge.wedges.pair(&judge.star, v, k);
            judge.wedges.write_targets(v, judge.star.ids[k], targets);
        }
        let first = judge.groups.len() as u32;
        self.filled.clear();
        for (number, &(corners, group)) in (first..).zip(&self.floor) {
            judge.wedges.push(corners);
            judge.groups.push(group);
            self.filled.push((number, corners.map(|c| judge.wedges.position_of(c))));
        }
        judge.points.settle(first, &judge.floor_corners);
        self.ring.clear();
        self.ring.extend_from_slice(&judge.star.ids);
        self.record.removed.push(v);
        self.record.errors.push(error);
        self.record.ceilings.extend_from_slice(&judge.star.triangles);
        self.record.ceiling_ends.push(self.record.ceilings.len() as u32);
        self.record.face_ends.push(judge.groups.len() as u32);
        self.triangle_count -= judge.star.triangle_count() - self.floor.len();
        judge.links.fill(v, &self.filled);
        self.heap.remove(v);
        let ring = std::mem::take(&mut self.ring);
        for &w in &ring {
            let key = self.key(w);
            self.heap.set(w, key);
        }
        self.ring = ring;
    }
}
