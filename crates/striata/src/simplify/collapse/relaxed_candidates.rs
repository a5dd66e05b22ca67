//! Relaxed collapses: the candidates of a position that has no strict collapse.
//!
//! Every neighbor is a candidate, whatever borders, links and normals forbid; violations increase the
//! cost instead:
//!
//! | kind | effect | cost |
//! | --- | --- | --- |
//! | link | no flip, but sheets may touch or a border recede | 4 times, with the squared edge as swept area |
//! | fold | a triangle flips | as if the surface moved by the whole edge |
//! | fin | all triangles of the position vanish, its target keeps others | distance from those others |
//! | vanish | all triangles of both ends vanish | distance of the part from the rest of the mesh |
//!
//! The last triangles of the mesh stay, and each locked position keeps a triangle.

use glam::Vec3;

use super::collapse_choice::{CollapseChoice, CollapseKind};
use super::cost_evaluator::CostEvaluator;
use super::fan::{nearest, point};
use super::legality::MAX_REMOVED;
use super::links::{LinkEdge, LinkKind, Links};
use super::parts::{MeasuringContext, VanishingEstimate, vanishing_cost};

/// Cost factor of a collapse that breaks the link condition or moves a vertex off its border.
const LINK_FACTOR: f32 = 4.0;
/// Weight of the fourth power of the edge length in that cost.
const EDGE_WEIGHT: f32 = 4.0;
/// Weight of the squared difference of unit normals between a fin and the remaining triangles.
const FIN_NORMAL_WEIGHT: f32 = 1e-4;
/// Parts of up to this many triangles may vanish even if they could lose single triangles.
const NEARLY_GONE_TRIANGLES: usize = 4;
/// Upper limit of all costs, so that even the worst candidate remains finite.
const MAX_COST: f32 = 1e30;

/// A triangle that becomes a fin.
struct FinOfTriangle {
    /// The triangle.
    pub own: u32,
    /// Its normal, with twice its area as length.
    pub doubled: Vec3,
}

impl CostEvaluator<'_> {
    /// Returns the cheapest collapse of `v` to any neighbor. Call it for positions without a strict
    /// target, immediately after [`Self::best_choice`].
    pub(in crate::simplify) fn relaxed_choice(&mut self, v: u32) -> Option<CollapseChoice> {
        let mut order = std::mem::take(&mut self.relaxed.as_mut()?.order);
        self.fill_costs(v);
        order.clear();
        order.extend(0..self.star.ring.ids.len() as u32);
        let length_squared = |k: &u32| self.star.offset(*k as usize).length_squared();
        order.sort_by(|a, b| length_squared(a).total_cmp(&length_squared(b)));
        let mut best: Option<CollapseChoice> = None;
        for &k in &order {
            let limit = best.map_or(f32::INFINITY, |choice| choice.cost);
            if let Some(choice) = self.relaxed_candidate(v, k as usize, limit)
                && choice.cost < limit
            {
                best = Some(choice);
            }
        }
        if let Some(relaxed) = &mut self.relaxed {
            relaxed.order = order;
        }
        best
    }

    /// Whether the part of `v` has so few triangles left that one collapse may remove all of them.
    pub(in crate::simplify) fn is_nearly_gone(&self, v: u32) -> bool {
        self.relaxed.as_ref().is_some_and(|relaxed| {
            relaxed.is_foliage
                && relaxed.parts.triangle_count(relaxed.parts.part_of(v)) <= NEARLY_GONE_TRIANGLES
        })
    }

    /// Returns a collapse of `v` that removes all triangles of its part, if it is cheaper than `limit`.
    /// Call it immediately after [`Self::best_choice`]. Reducing a foliage card to a single triangle
    /// may look worse than removing it.
    pub(in crate::simplify) fn ending_choice(&mut self, v: u32, limit: f32) -> Option<CollapseChoice> {
        self.fill_costs(v);
        for k in 0..self.star.ring.ids.len() {
            let takes_all =
                (0..self.star.ring.triangle_count()).all(|t| self.star.ring.triangle(t).contains(&k));
            if takes_all
                && let Some(choice) = self.relaxed_candidate(v, k, limit)
                && choice.kind == CollapseKind::Vanish
                && choice.cost < limit
            {
                return Some(choice);
            }
        }
        None
    }

    /// Whether a stored relaxed choice may still be applied at its cost.
    pub(in crate::simplify) fn is_relaxed_choice_valid(
        &self,
        v: u32,
        u: u32,
        kind: CollapseKind,
        distance_squared: f32,
    ) -> bool {
        let Some(relaxed) = &self.relaxed else { return false };
        let entries = self.links.entries(v);
        if !entries.contains(&u) {
            return false;
        }
        let removed = shared_triangles(&self.links, v, u);
        let own = self.links.triangle_count(v);
        let kept = own + self.links.triangle_count(u) - 2 * removed;
        let is_vanishing = kept == 0;
        if removed >= relaxed.triangle_count
            || is_vanishing != matches!(kind, CollapseKind::Remnant | CollapseKind::Vanish)
            || self.strands_locked(v, u, kept)
        {
            return false;
        }
        let part = relaxed.parts.part_of(v);
        let is_last = relaxed.parts.triangle_count(part) == removed;
        match kind {
            CollapseKind::Remnant => !is_last,
            // The remaining surface may be farther away than when the cost was computed.
            CollapseKind::Vanish => {
                is_last && relaxed.parts.has_valid_estimate(part, relaxed.generation, distance_squared)
            }
            CollapseKind::Strict | CollapseKind::Link | CollapseKind::Fold | CollapseKind::Fin => true,
        }
    }

    /// Whether a collapse leaves a triangle to the mesh and to each locked position.
    pub(in crate::simplify) fn leaves_enough(&self, v: u32, u: u32) -> bool {
        let removed = shared_triangles(&self.links, v, u);
        let kept = self.links.triangle_count(v) + self.links.triangle_count(u) - 2 * removed;
        let is_last = self.relaxed.as_ref().is_some_and(|relaxed| removed >= relaxed.triangle_count);
        !is_last && !self.strands_locked(v, u, kept)
    }

    /// Whether a locked position would lose its last triangle.
    fn strands_locked(&self, v: u32, u: u32, kept: usize) -> bool {
        if !self.relaxed.as_ref().is_some_and(|relaxed| relaxed.has_locks) {
            return false;
        }
        let is_locked = |p: u32| self.is_locked[p as usize];
        (is_locked(u) && kept == 0)
            || self.links.entries(v).iter().any(|&x| {
                x != u && is_locked(x) && {
                    let mut edges = Vec::new();
                    self.links.edges_into(x, &mut edges);
                    edges.iter().all(|e| (e.a == v && e.b == u) || (e.a == u && e.b == v))
                }
            })
    }

    fn relaxed_candidate(&mut self, v: u32, k: usize, limit: f32) -> Option<CollapseChoice> {
        let u = self.star.ring.ids[k];
        let count = self.star.ring.triangle_count();
        let removed = (0..count).filter(|&t| self.star.ring.triangle(t).contains(&k)).count();
        let kept = count + self.links.triangle_count(u) - 2 * removed;
        let left = self.relaxed.as_ref()?.triangle_count;
        if removed > MAX_REMOVED || removed >= left || self.strands_locked(v, u, kept) {
            return None;
        }
        if !self.keeps_height_field(v, u) || !self.pair(v, k) {
            return None;
        }
        if kept == 0 {
            return self.vanishing_choice(v, k, removed);
        }
        let choice = if removed == count { self.fin_choice(v, k)? } else { self.fan_choice(v, k, limit)? };
        let increase = self.cost.increase(&mut self.star, k, v, choice.distance_squared);
        Some(CollapseChoice { cost: (choice.cost + increase).min(MAX_COST), ..choice })
    }

    /// Returns the candidate that leaves a fan, whether or not triangles flip; `None` if it costs at
    /// least `limit`.
    fn fan_choice(&mut self, v: u32, k: usize, limit: f32) -> Option<CollapseChoice> {
        let quadratic = self.star.costs[k];
        let length_squared = self.star.offset(k).length_squared();
        let share = self.rules.surface_share;
        let distance_cost = |star: &super::star::Star, squared: f32| share * star.distance_cost(squared);
        let fan = self.star.fan_distance_squared(k);
        let (kind, distance_squared, start) = match fan {
            Some(distance_squared) => {
                let edge = EDGE_WEIGHT * length_squared * length_squared;
                let start = quadratic + share * edge + distance_cost(&self.star, distance_squared);
                (CollapseKind::Link, distance_squared, LINK_FACTOR * start)
            }
            None => (CollapseKind::Fold, length_squared, quadratic),
        };
        if start >= limit {
            return None;
        }
        let mut attributes = self.attribute_cost(v, k);
        let start = start + attributes;
        let least = if kind == CollapseKind::Link { LINK_FACTOR } else { 1.0 };
        if start + least * distance_cost(&self.star, distance_squared) >= limit {
            return None;
        }
        let colors = self.color_cost(v, k);
        attributes += colors;
        let start = start + colors;
        let protrusion_squared = self.star.protrusion_squared(k);
        let cost = start + least * distance_cost(&self.star, distance_squared + protrusion_squared);
        Some(CollapseChoice {
            cost,
            attributes,
            target: self.star.ring.ids[k],
            distance_squared,
            protrusion_squared,
            kind,
            outward: None,
        })
    }

    /// Returns the candidate that removes all triangles of `v` and leaves others at `u`.
    fn fin_choice(&mut self, v: u32, k: usize) -> Option<CollapseChoice> {
        let u = self.star.ring.ids[k];
        let mut edges = std::mem::take(&mut self.relaxed.as_mut()?.edges);
        self.links.sampled_edges_into(u, &mut edges);
        edges.retain(|e| e.a != v && e.b != v);
        let (mut sum, mut area_sum, mut least) = (0.0, 0.0, f32::INFINITY);
        for t in 0..self.star.ring.triangle_count() {
            let [i, j] = self.star.ring.triangle(t).map(|i| self.star.offset(i));
            let doubled = i.cross(j);
            let area = doubled.length() + f32::MIN_POSITIVE;
            let own = if self.wedges.is_some() { self.star.center_wedges[t] } else { v };
            let (value, distance_squared) = self.fin_distance(v, u, FinOfTriangle { own, doubled }, &edges);
            sum += area * value;
            area_sum += area;
            least = least.min(distance_squared);
        }
        if let Some(relaxed) = &mut self.relaxed {
            relaxed.edges = edges;
        }
        let cost = self.rules.surface_share * vanishing_cost(self.star.area(), sum / area_sum);
        Some(CollapseChoice {
            cost,
            attributes: 0.0,
            target: u,
            distance_squared: least,
            protrusion_squared: 0.0,
            kind: CollapseKind::Fin,
            outward: None,
        })
    }

    /// Finds the replacement for `v` among the triangles of `u` with these opposite edges. Returns the
    /// least squared distance including differences of attributes and normals, and the least plain
    /// squared distance.
    fn fin_distance(
        &self,
        v: u32,
        u: u32,
        FinOfTriangle { own, doubled }: FinOfTriangle,
        edges: &[LinkEdge],
    ) -> (f32, f32) {
        let at = |p: u32| point(&self.positions, p) - point(&self.positions, v);
        let normal = doubled.normalize_or_zero();
        let (mut best, mut least) = (f32::INFINITY, f32::INFINITY);
        for e in edges {
            let [a, b, c] = [u, e.a, e.b].map(at);
            let weights = nearest(a, b, c);
            let distance_squared = (a * weights[0] + b * weights[1] + c * weights[2]).length_squared();
            let other = (b - a).cross(c - a).normalize_or_zero();
            let attributes = self.attributes.as_ref().map_or(0.0, |space| {
                let corners = match &self.wedges {
                    None => [u, e.a, e.b],
                    Some(wedges) => [u, e.a, e.b].map(|p| wedges.vertex_at(e.triangle, p)),
                };
                space.interpolation_error(own, corners, weights)
            });
            let turned = FIN_NORMAL_WEIGHT * other.distance_squared(normal);
            best = best.min(distance_squared + turned + attributes);
            least = least.min(distance_squared);
        }
        (best, least)
    }

    /// Returns the candidate that removes all triangles of both ends.
    fn vanishing_choice(&mut self, v: u32, k: usize, removed: usize) -> Option<CollapseChoice> {
        let relaxed = self.relaxed.as_ref()?;
        let part = relaxed.parts.part_of(v);
        let is_last = relaxed.parts.triangle_count(part) == removed;
        let (cost, distance_squared) = if !is_last {
            self.remnant_cost(v, part, removed)
        } else {
            if relaxed.keeps_parts {
                return None;
            }
            let estimate = self.estimate(part)?;
            (estimate.cost, estimate.distance_squared())
        };
        let cost = (self.rules.surface_share * cost).min(MAX_COST);
        let target = self.star.ring.ids[k];
        Some(CollapseChoice {
            cost,
            attributes: 0.0,
            target,
            distance_squared,
            protrusion_squared: 0.0,
            kind: if is_last { CollapseKind::Vanish } else { CollapseKind::Remnant },
            outward: None,
        })
    }

    /// Cost and squared distance if all triangles of `v` and of a neighbor vanish, but the part keeps others.
    fn remnant_cost(&mut self, v: u32, part: u32, removed: usize) -> (f32, f32) {
        let longest = self.star.longest_edge_squared();
        let Self { relaxed: Some(relaxed), links, wedges, positions, star, .. } = self else {
            return (0.0, 0.0);
        };
        let is_alone = (0..star.ring.ids.len()).all(|i| {
            let count =
                (0..star.ring.triangle_count()).filter(|&t| star.ring.triangle(t).contains(&i)).count();
            links.triangle_count(star.ring.ids[i]) == count
        });
        if !is_alone {
            // The third corners have other triangles and stay where they are.
            return (vanishing_cost(star.area(), longest), longest);
        }
        relaxed.refresh(links, wedges.as_ref(), positions);
        let from = point(positions, v);
        let is_other = |p: u32| p != v && !star.ring.ids.contains(&p);
        let unknown = (f32::INFINITY, v);
        let (distance_squared, _) = relaxed.nearest_star((links, positions), from, (unknown, 0.0), is_other);
        let (area, reach) = relaxed.parts.share(part);
        let extent = distance_squared.sqrt() + longest.sqrt() + reach;
        let area = star.area().max(removed as f32 * area);
        (vanishing_cost(area, extent * extent), distance_squared)
    }

    /// Estimates what happens if a part vanishes.
    pub(in crate::simplify) fn estimate(&mut self, part: u32) -> Option<&VanishingEstimate> {
        let Self { relaxed: Some(relaxed), links, wedges, positions, attributes, .. } = self else {
            return None;
        };
        relaxed.refresh(links, wedges.as_ref(), positions);
        let context = MeasuringContext {
            welded: relaxed.welded,
            positions,
            attributes: attributes.as_ref(),
            snapshot: &relaxed.snapshot,
            generation: relaxed.generation,
        };
        relaxed.parts.estimate(part, &context)
    }
}

/// Number of triangles that `v` and its neighbor `u` share.
fn shared_triangles(links: &Links, v: u32, u: u32) -> usize {
    let entries = links.entries(v);
    match links.kind(v) {
        LinkKind::Empty => 0,
        LinkKind::Closed => 2,
        LinkKind::Open => {
            2 - usize::from(entries.first() == Some(&u)) - usize::from(entries.last() == Some(&u))
        }
        LinkKind::Edges => entries.iter().filter(|&&w| w == u).count(),
    }
}
