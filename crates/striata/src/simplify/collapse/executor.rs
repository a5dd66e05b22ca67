//! Applies a collapse to links, wedges and cost history, and records it with its error.

use glam::Vec3;

use crate::mesh::Welded;

use super::collapse_choice::{CollapseChoice, CollapseKind};
use super::cost_evaluator::CostEvaluator;
use super::fan::point;
use super::links::LinkKind;
use super::lost_positions::{HalfEdge, LostPositions};
use super::refinement_order::CollapseRecord;
use super::witness::Witnesses;

/// Protrusions below this share of the edge, both squared, are single-precision noise on flat surfaces.
const PROTRUSION_NOISE: f32 = 1e-5;

/// Once this many positions have been merged into one, a single witness is not enough.
const MIN_FOLLOWERS: usize = 16;

/// Applies collapses and records them.
#[derive(Debug)]
pub(in crate::simplify) struct CollapseExecutor {
    /// Mesh units per scaled unit.
    scale: f64,
    pub witnesses: Witnesses,
    /// Neighbors of the position removed last, each once.
    pub ring: Vec<u32>,
    /// Number of triangles left.
    pub triangle_count: usize,
    /// Number of steps recorded before the last collapse.
    last: usize,
    /// Scratch: positions without triangles, and sample points of removed triangles.
    gone: Vec<u32>,
    points: Vec<Vec3>,
    /// Record of the collapses; the caller appends the errors.
    pub record: CollapseRecord,
}

impl CollapseExecutor {
    /// Creates an executor for a mesh on which nothing has been collapsed yet.
    pub(in crate::simplify) fn new(welded: &Welded, evaluator: &CostEvaluator<'_>) -> Self {
        let follows_rings = !evaluator.is_scan && !evaluator.is_closed_scan();
        Self {
            scale: evaluator.scale,
            witnesses: Witnesses::new(welded.positions.position_count(), follows_rings),
            ring: Vec::new(),
            last: 0,
            gone: Vec::new(),
            points: Vec::new(),
            triangle_count: welded.mesh.triangle_count(),
            record: CollapseRecord {
                targets: vec![0; welded.mesh.vertex_count()],
                ..CollapseRecord::default()
            },
        }
    }

    /// Largest squared error so far, scaled units.
    pub(in crate::simplify) fn worst_squared(&self) -> f32 {
        self.witnesses.worst_squared()
    }

    /// The positions that the last collapse removed.
    pub(in crate::simplify) fn last_removed(&self) -> &[u32] {
        &self.record.removed[self.last..]
    }

    /// Squared distance by which a step moves the surface, scaled units.
    pub(in crate::simplify) fn own_squared(
        &self,
        evaluator: &CostEvaluator<'_>,
        v: u32,
        choice: &CollapseChoice,
    ) -> f32 {
        let protrusion = reported_protrusion(&evaluator.positions, v, choice);
        choice.distance_squared.max(protrusion)
    }

    /// Squared distance of the witness of `v` from the fan that collapsing `v` to the neighbor `u`
    /// would leave; `None` if it cannot exceed the largest error so far. `own` is the squared distance
    /// of `v` itself.
    pub(in crate::simplify) fn witness_distance_before(
        &self,
        evaluator: &mut CostEvaluator<'_>,
        v: u32,
        u: u32,
        own: f32,
    ) -> Option<f32> {
        let place = self.witnesses.possible_worst(&evaluator.positions, v, own)?;
        let CostEvaluator { star, links, positions, .. } = evaluator;
        star.gather(links, positions, v);
        let k = star.ring.index_of(u)?;
        star.mark_vanishing(Some(k));
        let distance_squared = star.fan_distance_squared_of(k, place - point(positions, v));
        distance_squared.is_finite().then_some(distance_squared)
    }

    /// Collapses `v` as `choice` says and removes all positions that lose their last triangle by it;
    /// returns the error after it, mesh units.
    pub(in crate::simplify) fn collapse(
        &mut self,
        evaluator: &mut CostEvaluator<'_>,
        v: u32,
        choice: &CollapseChoice,
    ) -> f64 {
        let u = choice.target;
        self.last = self.record.removed.len();
        let tracked = self.prepare(evaluator, v, u);
        if choice.kind != CollapseKind::Strict {
            self.note_points(evaluator, v);
        }
        let links = &mut evaluator.links;
        self.ring.clear();
        self.ring.extend_from_slice(links.entries(v));
        if links.kind(v) == LinkKind::Edges {
            self.ring.sort_unstable();
            self.ring.dedup();
        }
        let before = links.triangle_count(v) + links.triangle_count(u);
        links.collapse(v, u);
        // Each removed triangle was in both links.
        let removed = (before - links.triangle_count(u)) / 2;
        self.triangle_count -= removed;
        self.record.removed.push(v);
        self.record.removed_triangle_counts.push(removed as u8);
        let lost_positions = evaluator.note_collapse(v, u, removed, &self.ring);
        let is_plain = choice.kind == CollapseKind::Strict
            && lost_positions.as_ref().is_none_or(|d| d.positions.is_empty());
        let mut worst = match tracked {
            Some(worst) if is_plain => worst,
            None if is_plain => self.strict_error(evaluator, v, choice),
            _ => tracked.unwrap_or(0.0),
        };
        if let Some(lost_positions) = lost_positions {
            if !is_plain {
                worst = worst.max(self.relaxed_error(evaluator, v, choice, &lost_positions));
            }
            evaluator.recycle(lost_positions);
        }
        f64::from(worst).sqrt() * self.scale
    }

    /// Squared error after a collapse that preserves the topology.
    fn strict_error(&mut self, evaluator: &mut CostEvaluator<'_>, v: u32, choice: &CollapseChoice) -> f32 {
        let own = choice.distance_squared;
        let mut worst = self.witnesses.collapse(evaluator, HalfEdge { v, u: choice.target }, &self.ring, own);
        if evaluator.has_relaxed() {
            evaluator.followers_into(choice.target, MIN_FOLLOWERS, &mut self.gone);
            worst = self.witnesses.remeasure(evaluator, &self.gone, &[], choice.target);
        }
        let protrusion = reported_protrusion(&evaluator.positions, v, choice);
        if !evaluator.measures_outward() {
            return worst.max(protrusion);
        }
        evaluator.update_outward_bounds(HalfEdge { v, u: choice.target }, &self.ring, choice, worst);
        choice.outward.map_or(worst, |outward| self.witnesses.raise(outward * outward))
    }

    /// Squared error after a collapse that may have removed more than `v`; records the other removed
    /// positions.
    fn relaxed_error(
        &mut self,
        evaluator: &mut CostEvaluator<'_>,
        v: u32,
        choice: &CollapseChoice,
        lost_positions: &LostPositions,
    ) -> f32 {
        let LostPositions { host, positions: lost, points } = lost_positions;
        let Some(host) = *host else { return 0.0 };
        for &p in lost {
            self.record.removed.push(p);
            self.record.removed_triangle_counts.push(0);
            evaluator.write_single_target(p, host, &mut self.record.targets);
        }
        evaluator.mark_relaxed();
        self.gone.clear();
        self.gone.push(v);
        self.gone.push(choice.target);
        self.gone.extend(lost.iter().copied().filter(|&p| p != choice.target));
        self.witnesses.remeasure(evaluator, &self.gone, &self.points, host);
        evaluator.followers_into(host, 0, &mut self.gone);
        let worst = self.witnesses.remeasure(evaluator, &self.gone, points, host);
        if !evaluator.measures_outward() {
            return worst.max(reported_protrusion(&evaluator.positions, v, choice));
        }
        let outward = match choice.kind {
            CollapseKind::Link | CollapseKind::Fold => {
                evaluator.outward_distance_after(v, choice.target, choice, worst)
            }
            CollapseKind::Strict | CollapseKind::Fin | CollapseKind::Remnant | CollapseKind::Vanish => {
                choice.outward
            }
        };
        let choice = CollapseChoice { outward, ..*choice };
        evaluator.update_outward_bounds(HalfEdge { v, u: choice.target }, &self.ring, &choice, worst);
        outward.map_or(worst, |outward| self.witnesses.raise(outward * outward))
    }

    /// Collects sample points of the triangles around `v`, which the collapse removes or folds over.
    fn note_points(&mut self, evaluator: &mut CostEvaluator<'_>, v: u32) {
        let CostEvaluator { star, links, positions, .. } = evaluator;
        star.gather(links, positions, v);
        self.points.clear();
        let [x, y, z, _] = positions[v as usize];
        let center = Vec3::new(x, y, z);
        for t in 0..star.ring.triangle_count() {
            let [a, b] = star.ring.triangle(t).map(|i| star.offset(i));
            self.points.extend([(a + b) / 3.0, 0.5 * a, 0.5 * b].map(|offset| center + offset));
        }
    }

    /// Removes the last collapse from the record; links and wedges stay collapsed.
    pub(in crate::simplify) fn drop_last(&mut self) {
        self.record.removed.truncate(self.last);
        self.record.removed_triangle_counts.truncate(self.last);
    }

    /// Does everything that needs the star of `v` before its collapse: writes targets of its wedges,
    /// updates the cost history. Returns the largest squared distance of the tracked vertices if the
    /// cost tracks them and `u` is a neighbor.
    fn prepare(&mut self, evaluator: &mut CostEvaluator<'_>, v: u32, u: u32) -> Option<f32> {
        if let Some(pairs) = &mut evaluator.pairs {
            pairs.collapse(v, u);
        }
        evaluator.cost.merge(v, u);
        if evaluator.wedges.is_none() && !evaluator.rules.follows_triangles {
            self.record.targets[v as usize] = u;
            return None;
        }
        let neighbor = evaluator.gather_and_pair(v, u);
        if neighbor.is_none() {
            evaluator.pair_wedges(v, u);
        }
        let CostEvaluator { star, positions, wedges, cost, .. } = evaluator;
        match wedges {
            Some(wedges) => {
                wedges.write_targets(v, u, &mut self.record.targets);
                wedges.substitute(star, v, &self.record.targets);
            }
            None => self.record.targets[v as usize] = u,
        }
        cost.collapse(star, positions, v, neighbor?)
    }
}

/// Squared distance by which the new fan of `v` sticks out of its old star, or 0 if it may be rounding.
fn reported_protrusion(positions: &[[f32; 4]], v: u32, choice: &CollapseChoice) -> f32 {
    let [from, to] = [v, choice.target].map(|p| positions[p as usize]);
    let edge_squared: f32 = (0..3).map(|a| (from[a] - to[a]) * (from[a] - to[a])).sum();
    let protrusion = choice.protrusion_squared;
    if protrusion > PROTRUSION_NOISE * edge_squared { protrusion } else { 0.0 }
}
