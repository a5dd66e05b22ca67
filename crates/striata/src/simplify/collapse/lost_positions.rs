//! Consequences of a collapse that may change the topology: which positions lose their last triangle,
//! what replaces them, and how far the new surface is from the original.

use glam::Vec3;

use super::collapse_choice::CollapseChoice;
use super::cost_evaluator::CostEvaluator;
use super::fan::point;
use super::links::LinkKind;
use super::parts::MeasuringContext;
use super::relaxed_state::find;
use super::walk::NearestStar;

/// Maximum number of merged positions that are measured again individually.
const MAX_FOLLOWERS: usize = 24;

/// Positions that lose their last triangle in a collapse, and the position that replaces them.
pub(in crate::simplify) struct LostPositions {
    /// Remaining position that the lost positions are merged into; `None` if nothing is left.
    pub host: Option<u32>,
    /// Positions that have no triangles any more, besides the collapsed one.
    pub positions: Vec<u32>,
    /// Sample points of a part that has vanished.
    pub points: Vec<Vec3>,
}

/// A collapse of a position to another.
pub(in crate::simplify) struct HalfEdge {
    /// The position that is removed.
    pub v: u32,
    /// The position that stays.
    pub u: u32,
}

impl CostEvaluator<'_> {
    /// Records that a relaxed collapse has been applied.
    pub(in crate::simplify) fn mark_relaxed(&mut self) {
        if let Some(relaxed) = &mut self.relaxed {
            relaxed.has_relaxed = true;
        }
    }

    /// Whether steps are also measured from the new surface to the original mesh: if there are seams, or once
    /// a relaxed collapse has been applied. Scans skip this, which would take a third of their time.
    pub(in crate::simplify) fn measures_outward(&self) -> bool {
        let Some(relaxed) = &self.relaxed else { return false };
        self.wedges.is_some() || (relaxed.has_relaxed && !relaxed.begins_last && !self.is_scan)
    }

    /// Whether nearest points are searched in the whole mesh: if there are seams, or once a relaxed
    /// collapse has been applied.
    pub(in crate::simplify) fn searches_whole_mesh(&self) -> bool {
        self.relaxed.is_some() && (self.wedges.is_some() || self.has_relaxed())
    }

    /// Whether a relaxed collapse has been applied.
    pub(in crate::simplify) fn has_relaxed(&self) -> bool {
        self.relaxed.as_ref().is_some_and(|relaxed| relaxed.has_relaxed)
    }

    /// Collects positions that were merged into `u`, evenly spread, if there are at least `least` of them.
    pub(in crate::simplify) fn followers_into(&self, u: u32, least: usize, out: &mut Vec<u32>) {
        out.clear();
        let Some(relaxed) = &self.relaxed else { return };
        let count = relaxed.follower_count[u as usize] as usize;
        if count < least {
            return;
        }
        let stride = count.div_ceil(MAX_FOLLOWERS);
        let mut at = u;
        for i in 0..count {
            at = relaxed.next[at as usize];
            if i % stride == 0 && at != u {
                out.push(at);
            }
        }
    }

    /// Finds the surface nearest to a point whose own triangles may be gone; see
    /// [`RelaxedState::nearest_star`].
    pub(in crate::simplify) fn nearest_star(
        &mut self,
        from: Vec3,
        known: NearestStar,
        enough: f32,
    ) -> NearestStar {
        if !self.searches_whole_mesh() {
            return known;
        }
        let Self { relaxed: Some(relaxed), links, wedges, positions, .. } = self else { return known };
        if known.0 <= enough {
            return known;
        }
        relaxed.refresh(links, wedges.as_ref(), positions);
        relaxed.nearest_star((links, positions), from, (known, enough), |_| true)
    }

    /// Distance from the original mesh of the triangles that collapsing `v` to its neighbor `u` would
    /// leave, if it may exceed the largest error so far; `worst` is the square of that error.
    pub(in crate::simplify) fn outward_distance_before(
        &mut self,
        v: u32,
        u: u32,
        protrusion: f32,
        worst: f32,
    ) -> Option<f32> {
        let Self { relaxed: Some(relaxed), links, positions, .. } = self else { return None };
        let bound = relaxed.outward.bound_after(v, protrusion, worst, positions.len());
        if bound * bound <= worst {
            return None;
        }
        links.edges_into(v, &mut relaxed.edges);
        relaxed.edges.retain(|e| e.a != u && e.b != u);
        Some(relaxed.outward.measure((relaxed.welded, positions), (u, &relaxed.edges), worst))
    }

    /// Updates the bounds for the distance of the new fan, left by the collapse of `v` to `u`, from the
    /// original mesh.
    pub(in crate::simplify) fn update_outward_bounds(
        &mut self,
        HalfEdge { v, u }: HalfEdge,
        ring: &[u32],
        choice: &CollapseChoice,
        worst: f32,
    ) {
        let Self { relaxed: Some(relaxed), positions, .. } = self else { return };
        let bound = match choice.outward {
            Some(measured) => measured,
            None => relaxed.outward.bound_after(v, choice.protrusion_bound_squared(), worst, positions.len()),
        };
        relaxed.outward.note(u, ring, bound);
    }

    /// Largest distance from the original mesh of the triangles around `u` after `v` was collapsed to
    /// it, if it may exceed the largest error so far; `worst` is the square of that error.
    pub(in crate::simplify) fn outward_distance_after(
        &mut self,
        v: u32,
        u: u32,
        choice: &CollapseChoice,
        worst: f32,
    ) -> Option<f32> {
        let Self { relaxed: Some(relaxed), links, positions, .. } = self else { return None };
        let bound = relaxed.outward.bound_after(v, choice.protrusion_bound_squared(), worst, positions.len());
        if bound * bound <= worst {
            return None;
        }
        links.sampled_edges_into(u, &mut relaxed.edges);
        Some(relaxed.outward.measure((relaxed.welded, positions), (u, &relaxed.edges), worst))
    }

    /// Updates the global state after a collapse and returns the positions that lost all triangles;
    /// `ring` contains the former neighbors of `v`.
    pub(in crate::simplify) fn note_collapse(
        &mut self,
        v: u32,
        u: u32,
        removed: usize,
        ring: &[u32],
    ) -> Option<LostPositions> {
        let relaxed = self.relaxed.as_mut()?;
        relaxed.parts.collapse(v, u, removed);
        relaxed.triangle_count -= removed;
        relaxed.follow(v, u);
        let mut lost = std::mem::take(&mut relaxed.lost);
        lost.clear();
        let is_lost = |p: u32| self.links.kind(p) == LinkKind::Empty;
        lost.extend(ring.iter().copied().filter(|&p| is_lost(p)));
        if is_lost(u) && !lost.contains(&u) {
            lost.push(u);
        }
        let mut lost_positions = LostPositions { host: Some(u), positions: lost, points: Vec::new() };
        if lost_positions.positions.contains(&u) {
            lost_positions.host = ring.iter().copied().find(|&p| !is_lost(p));
            let part = relaxed.parts.part_of(u);
            if relaxed.parts.triangle_count(part) == 0 {
                self.note_part_vanished(part, &mut lost_positions);
            }
        }
        if lost_positions.host.is_none_or(|p| self.links.kind(p) == LinkKind::Empty) {
            // The part fell apart before, or its replacement vanished with it. Search the whole mesh, even if
            // this is the first collapse that changes the topology.
            self.mark_relaxed();
            let (distance_squared, host) =
                self.nearest_star(point(&self.positions, u), (f32::INFINITY, u), 0.0);
            lost_positions.host = (distance_squared < f32::INFINITY).then_some(host);
        }
        if let (Some(relaxed), Some(host)) = (&mut self.relaxed, lost_positions.host) {
            lost_positions.positions.iter().for_each(|&p| relaxed.follow(p, host));
        }
        Some(lost_positions)
    }

    /// Records that a part has vanished.
    fn note_part_vanished(&mut self, part: u32, lost_positions: &mut LostPositions) {
        self.estimate(part);
        let Self { relaxed: Some(relaxed), positions, attributes, .. } = self else { return };
        let context = MeasuringContext {
            welded: relaxed.welded,
            positions,
            attributes: attributes.as_ref(),
            snapshot: &relaxed.snapshot,
            generation: relaxed.generation,
        };
        if let Some(estimate) = relaxed.parts.vanish(part, &context) {
            relaxed.parts.corners_into(part, relaxed.welded, positions, &mut lost_positions.points);
            lost_positions.host = Some(find(&mut relaxed.current, estimate.host));
        }
    }

    /// Returns the buffers of the result for reuse.
    pub(in crate::simplify) fn recycle(&mut self, lost_positions: LostPositions) {
        if let Some(relaxed) = &mut self.relaxed {
            relaxed.lost = lost_positions.positions;
        }
    }
}
