//! Evaluates the cost of removing a vertex, and finds the best way to fill its hole.
//!
//! The cost has three parts. The first is the increase of the squared distances of all vertices removed
//! so far, weighted by the areas that they represent: it keeps the result close to the original
//! surface. The second is the gap between the old and the new surface, since one-sided distances of
//! points do not detect a surface that sticks out. The third is the largest distance alone, the
//! Hausdorff distance by which \[KLS96\] orders removals; it dominates if it is large. In strict order,
//! the cost is that distance alone, measured from the original to the new surface.

use crate::mesh::Welded;
use crate::simplify::collapse::collapse_choice::CollapseChoice;
use crate::simplify::collapse::cost_evaluator::CostEvaluator;
use crate::simplify::collapse::costs::{RemovedVertices, nearest};
use crate::simplify::collapse::links::{LinkKind, Links};
use crate::simplify::collapse::star::Star;
use crate::simplify::collapse::wedges::Wedges;
use crate::simplify::options::SequenceOptions;

use glam::Vec3;

use super::hole::{Features, Hole, RingTriangle};
use super::removal_options::{RemovalOptions, RemovalOrder, Retriangulation};

/// Weight of the squared distance of the removed vertex, and of squared gaps, over the area of the
/// star, relative to distances of previously removed vertices.
const GAP_AREA_WEIGHT: f32 = 0.1;
/// Weight of the squared area between the old and the new path of a boundary.
const BORDER_WEIGHT: f32 = 0.8;
/// Weight of the largest squared distance, itself squared, relative to squared distances over areas.
/// With values from 30 to 100, maxima fall by a fifth and RMS rises by one to four percent; without it,
/// maxima are half as large again.
const SPIKE_WEIGHT: f32 = 60.0;
const NONE: u32 = u32::MAX;

/// Limit on the number of neighbors that a position may reach by new edges: hubs cost quadratic time.
const MAX_VALENCE: usize = 40;

/// Share of the memoryless cost of a collapse, relative to distances of previously removed vertices.
pub(super) const MEMORYLESS_SHARE: f32 = 0.2;

/// Maximum number of triangles around a vertex for relaxed collapses: indices into a star are bytes.
const MAX_HUB_TRIANGLES: usize = 127;

/// Collapses that are tried for a vertex whose hole cannot be filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum CollapsePhase {
    /// Collapses that preserve the topology.
    Strict,
    /// Relaxed ones as well.
    Relaxed,
    /// Also relaxed ones of vertices above the degree limit.
    Hubs,
}

/// How precisely a removal is evaluated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum RemovalPrecision {
    /// An approximate cost, for the order of vertices that are not yet due.
    Estimate,
    Exact,
}

/// How the hole is filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Filling {
    /// With triangles of the ring.
    Free,
    /// By moving the removed vertex to a neighbor, given as an index into the star.
    Collapse(usize),
    /// By moving the removed vertex to a neighbor without preserving the topology or the path of borders.
    Relaxed(usize),
}

/// A possible removal; its triangles are in the evaluator's `floor`.
#[derive(Clone, Copy, Debug)]
pub(super) struct RemovalCandidate {
    pub cost: f32,
    pub filling: Filling,
    /// Largest squared distance that the cost includes.
    pub worst: f32,
}

/// The current mesh and everything needed to evaluate removals on it.
pub(super) struct RemovalEvaluator<'a> {
    pub options: &'a RemovalOptions,
    /// Positions, links, wedges and the star, and costs of relaxed collapses.
    pub collapse_evaluator: CostEvaluator<'a>,
    /// Collapses that are tried if no other removal is allowed.
    pub phase: CollapsePhase,
    /// Group of each face.
    pub groups: Vec<u32>,
    pub points: RemovedVertices,
    pub hole: Hole,
    /// Cosine of the angle between normals beyond which an edge is a feature.
    pub feature_cosine: Option<f32>,
    has_wedges: bool,
    /// Whether the star loaded last has one vertex at each position and lies in one group.
    is_plain: bool,
    /// The vertices of the ring, if `is_plain`.
    ring_vertices: Vec<u32>,
    /// Triangles that fill the hole, as indices into the star.
    pub floor: Vec<RingTriangle>,
    /// Corners of the floor's triangles, relative to the removed vertex.
    pub floor_corners: Vec<[Vec3; 3]>,
    pub best_floor: Vec<RingTriangle>,
}

impl<'a> RemovalEvaluator<'a> {
    pub(super) fn new(welded: &'a Welded, options: &'a RemovalOptions) -> Self {
        let has_wedges = !welded.positions.is_identity();
        let rules = SequenceOptions {
            boundary: options.boundary,
            group_borders: options.group_borders,
            seams: options.seams,
            topology: options.topology,
            height_field: options.height_field,
            locked_vertices: options.locked_vertices.clone(),
            ..SequenceOptions::default()
        };
        let mut collapse_evaluator = CostEvaluator::new(welded, &rules);
        let position_count = collapse_evaluator.positions.len();
        if !has_wedges {
            // Triangle indices are needed even without wedges.
            collapse_evaluator.links = Links::new(position_count, &welded.mesh.triangles, true);
            collapse_evaluator.wedges = Some(Wedges::new(&welded.positions, welded.mesh.triangles.clone()));
        }
        collapse_evaluator.lock_boundary();
        let mut groups = vec![0; welded.mesh.triangle_count()];
        for (group_index, group) in welded.mesh.groups.iter().enumerate() {
            groups[group.range()].fill(group_index as u32);
        }
        let CostEvaluator { star, links, positions, .. } = &mut collapse_evaluator;
        let points = RemovedVertices::new(star, links, positions, welded.mesh.triangle_count());
        Self {
            options,
            collapse_evaluator,
            phase: CollapsePhase::Strict,
            groups,
            points,
            hole: Hole::default(),
            feature_cosine: options.feature_angle.map(|angle| cosine(angle) as f32),
            has_wedges,
            is_plain: false,
            ring_vertices: Vec::new(),
            floor: Vec::new(),
            floor_corners: Vec::new(),
            best_floor: Vec::new(),
        }
    }

    /// Finds the best way to fill the hole that `v` would leave, and leaves its triangles in `floor`.
    pub(super) fn evaluate(&mut self, v: u32, precision: RemovalPrecision) -> Option<RemovalCandidate> {
        let degree = self.collapse_evaluator.links.triangle_count(v);
        if self.collapse_evaluator.is_fixed(v) || degree == 0 || degree > MAX_HUB_TRIANGLES {
            return None;
        }
        self.collapse_evaluator.gather(v);
        let CostEvaluator { links, star, positions, .. } = &self.collapse_evaluator;
        let is_ring = matches!(links.kind(v), LinkKind::Closed | LinkKind::Open);
        let degree_limit = self.options.degree_limit;
        // A triangle and its opposite copy count as one.
        let is_hub = degree > degree_limit && !(degree <= 2 * degree_limit && star.ring.is_two_sided());
        if is_hub && self.phase < CollapsePhase::Hubs {
            return None;
        }
        self.points.load(&star.ring.triangles, positions, v);
        let strict = if is_hub {
            None
        } else {
            self.is_plain = is_ring && degree > 1 && self.find_ring_vertices();
            if self.is_plain { self.evaluate_ring(v, precision) } else { self.evaluate_collapses(v) }
        };
        if strict.is_none() && self.phase > CollapsePhase::Strict { self.evaluate_relaxed(v) } else { strict }
    }

    /// Returns the best relaxed collapse of `v` and leaves its fan in `floor`.
    fn evaluate_relaxed(&mut self, v: u32) -> Option<RemovalCandidate> {
        self.is_plain = false;
        self.collapse_evaluator.gather(v);
        let choice = self.collapse_evaluator.relaxed_choice(v)?;
        let CollapseChoice { cost, target, distance_squared, protrusion_squared, .. } = choice;
        let Self { collapse_evaluator: CostEvaluator { star, .. }, floor, .. } = self;
        let k = star.ring.index_of(target)?;
        fan_into(star, k, floor);
        self.update_floor_corners();
        let (increase, one_sided) = self.increase();
        let one_sided = one_sided.max(distance_squared);
        let worst = one_sided.max(protrusion_squared);
        let cost = match self.options.order {
            RemovalOrder::Mixed => increase.max(0.0) + MEMORYLESS_SHARE * cost + Self::spike_cost(worst),
            RemovalOrder::Hausdorff => one_sided,
        };
        Some(RemovalCandidate { cost, filling: Filling::Relaxed(k), worst })
    }

    /// Returns the square of a distance, converted from mesh units to scaled units.
    pub(super) fn scaled_squared(&self, distance: f32) -> f32 {
        let scaled = (f64::from(distance) / self.collapse_evaluator.scale) as f32;
        scaled * scaled
    }

    /// Whether the star, a ring, has one vertex at each of its positions and lies in one group.
    fn find_ring_vertices(&mut self) -> bool {
        let Self {
            collapse_evaluator: CostEvaluator { star, wedges: Some(wedges), .. },
            ring_vertices,
            groups,
            ..
        } = self
        else {
            return false;
        };
        let group = groups[star.ring.triangles[0] as usize];
        if star.ring.triangles.iter().any(|&t| groups[t as usize] != group) {
            return false;
        }
        ring_vertices.clear();
        if !self.has_wedges {
            ring_vertices.extend_from_slice(&star.ring.ids);
            return true;
        }
        ring_vertices.resize(star.ring.ids.len(), NONE);
        let mut center = NONE;
        let agrees = |known: &mut u32, vertex: u32| {
            let is_same = *known == NONE || *known == vertex;
            *known = vertex;
            is_same
        };
        (0..star.ring.triangle_count()).all(|t| {
            let [a, b] = star.ring.triangle(t);
            let triangle = star.ring.triangles[t];
            let [x, y] = [a, b].map(|i| wedges.vertex_at(triangle, star.ring.ids[i]));
            let own = wedges.corners(triangle).into_iter().find(|&c| c != x && c != y).unwrap_or(x);
            agrees(&mut center, own) && agrees(&mut ring_vertices[a], x) && agrees(&mut ring_vertices[b], y)
        })
    }

    fn evaluate_ring(&mut self, v: u32, precision: RemovalPrecision) -> Option<RemovalCandidate> {
        if !self.load_hole(v) || !self.keep_features() {
            return None;
        }
        let Self { hole, points, floor, .. } = self;
        let filling = match self.options.retriangulation {
            Retriangulation::Free => {
                let is_found = hole.triangulate(&points.loaded, self.options.criterion, floor);
                is_found.then_some(Filling::Free)?
            }
            Retriangulation::Collapse => Filling::Collapse(hole.best_fan(&points.loaded, floor)?),
        };
        self.update_floor_corners();
        let (gap_sum, gap_squared) = self.hole.gaps_squared(&self.floor);
        let area = self.hole.area();
        let mut surface_cost = self.volume_cost() + self.border_cost();
        let (increase, one_sided, protrusion) = match precision {
            RemovalPrecision::Estimate => {
                surface_cost += GAP_AREA_WEIGHT * area * gap_sum;
                let (increase, one_sided) = self.increase_estimate();
                (increase, one_sided, gap_squared)
            }
            RemovalPrecision::Exact => {
                let (own, _) = nearest(self.floor_corners.iter().map(|&corners| (corners, ())), Vec3::ZERO)?;
                let protrusion = gap_squared.max(self.hole.protrusion_squared(&self.floor));
                surface_cost += GAP_AREA_WEIGHT * area * (own + gap_sum.max(protrusion));
                let (increase, one_sided) = self.increase();
                (increase, one_sided, protrusion)
            }
        };
        let worst = one_sided.max(protrusion);
        let cost = match self.options.order {
            RemovalOrder::Mixed => increase.max(0.0) + surface_cost + Self::spike_cost(worst),
            RemovalOrder::Hausdorff => one_sided,
        };
        Some(RemovalCandidate { cost, filling, worst })
    }

    /// Loads the ring of `v` and the new edges that it may get; returns false if it cannot have a floor.
    fn load_hole(&mut self, v: u32) -> bool {
        let CostEvaluator { links, star, height_field, .. } = &self.collapse_evaluator;
        let is_closed = links.kind(v) == LinkKind::Closed;
        let n = star.ring.ids.len();
        self.hole.load((0..n).map(|i| star.offset(i)), is_closed);
        if let Some(field) = height_field {
            self.hole.keep_facing(field.facing(star, v), star.ring.ids.iter().map(|&p| field.at(p)));
        }
        if is_closed && n == 3 {
            // The removal would fold a tetrahedron flat.
            let [a, b, c] = [0, 1, 2].map(|i| star.ring.ids[i]);
            return !self.has_triangle(a, b, c);
        }
        for i in 0..n {
            let entries = links.entries(star.ring.ids[i]);
            let is_full = entries.len() > MAX_VALENCE;
            for j in 0..n {
                let is_old = j.abs_diff(i) <= 1 || (is_closed && j.abs_diff(i) == n - 1);
                if !is_old && (is_full || entries.contains(&star.ring.ids[j])) {
                    self.hole.forbid(i, j);
                }
            }
        }
        true
    }

    fn has_triangle(&self, a: u32, b: u32, c: u32) -> bool {
        let links = &self.collapse_evaluator.links;
        let entries = links.entries(a);
        let n = entries.len();
        let is_pair = |i: usize| {
            let pair = (entries[i], entries[if i + 1 == n { 0 } else { i + 1 }]);
            pair == (b, c) || pair == (c, b)
        };
        match links.kind(a) {
            LinkKind::Empty => false,
            LinkKind::Closed => (0..n).any(is_pair),
            LinkKind::Open => (0..n - 1).any(is_pair),
            LinkKind::Edges => (0..n).step_by(2).any(is_pair),
        }
    }

    /// Preserves the star's sharp edges; returns false if they meet or end at its center.
    fn keep_features(&mut self) -> bool {
        let Some(cosine) = self.feature_cosine else { return true };
        match self.hole.features(cosine) {
            Features::None => true,
            Features::Crease(a, b) => {
                self.hole.keep_edge(a, b);
                true
            }
            Features::Corner => false,
        }
    }

    /// Updates `floor_corners` from `floor`.
    pub(super) fn update_floor_corners(&mut self) {
        let Self { collapse_evaluator: CostEvaluator { star, .. }, floor, floor_corners, .. } = self;
        floor_corners.clear();
        floor_corners.extend(floor.iter().map(|t| t.map(|i| star.offset(usize::from(i)))));
    }

    /// Squared volume between the old and the new surface, over the area.
    fn volume_cost(&self) -> f32 {
        let six_volumes: f32 = self.floor_corners.iter().map(|[a, b, c]| a.dot(b.cross(*c))).sum();
        six_volumes * six_volumes / (36.0 * self.hole.area().max(f32::MIN_POSITIVE))
    }

    /// Squared area between the old and the new path of the boundary.
    fn border_cost(&self) -> f32 {
        let star = &self.collapse_evaluator.star;
        let n = star.ring.ids.len();
        if star.ring.triangle_count() == n {
            return 0.0;
        }
        BORDER_WEIGHT * self.hole.at(0).cross(self.hole.at(n - 1)).length_squared()
    }

    /// Returns how much the current floor increases the loaded vertices' weighted squared distances,
    /// and the largest squared distance.
    pub(super) fn increase(&self) -> (f32, f32) {
        let mut sum = 0.0;
        let mut worst = 0.0f32;
        for point in &self.points.loaded {
            let corners = self.floor_corners.iter().map(|&corners| (corners, ()));
            let Some((squared, ())) = nearest(corners, point.at) else { break };
            sum += point.weight * (squared - point.before);
            worst = worst.max(squared);
        }
        (sum, worst)
    }

    /// Estimates [`Self::increase`] from heights above the triangles that the vertices lie over: fast,
    /// and seldom larger.
    fn increase_estimate(&self) -> (f32, f32) {
        let points = &self.points.loaded;
        let before: f32 = points.iter().map(|point| point.weight * point.before).sum();
        let (sum, worst) = self.hole.point_heights(&self.floor, points);
        (sum - before, worst)
    }

    /// Cost of the largest squared distance, independent of the area: the part that orders by Hausdorff
    /// distance.
    pub(super) fn spike_cost(worst: f32) -> f32 {
        SPIKE_WEIGHT * worst * worst
    }

    /// Collects the vertices of the floor's faces and their groups, after the last evaluation.
    pub(super) fn floor_faces(&mut self, v: u32, filling: Filling, out: &mut Vec<([u32; 3], u32)>) {
        out.clear();
        let Self { collapse_evaluator, groups, floor, ring_vertices, .. } = self;
        if self.is_plain {
            let group = groups[collapse_evaluator.star.ring.triangles[0] as usize];
            out.extend(floor.iter().map(|t| (t.map(|i| ring_vertices[i as usize]), group)));
            return;
        }
        let (Filling::Collapse(k) | Filling::Relaxed(k)) = filling else { return };
        collapse_evaluator.pair(v, k);
        let CostEvaluator { star, wedges: Some(wedges), .. } = collapse_evaluator else { return };
        for t in 0..star.ring.triangle_count() {
            if star.ring.triangle(t).contains(&k) {
                continue;
            }
            let triangle = star.ring.triangles[t];
            let own = wedges.vertex_at(triangle, v);
            let to = wedges.paired(own, star.ring.ids[k]);
            let corners = wedges.corners(triangle).map(|c| if c == own { to } else { c });
            out.push((corners, groups[triangle as usize]));
        }
    }
}

/// Collects the triangles that stay if the center of a star moves to its neighbor `k`, as indices into
/// the star.
pub(super) fn fan_into(star: &Star, k: usize, floor: &mut Vec<RingTriangle>) {
    floor.clear();
    let kept =
        (0..star.ring.triangle_count()).map(|t| star.ring.triangle(t)).filter(|pair| !pair.contains(&k));
    floor.extend(kept.map(|[a, b]| [k, a, b].map(|i| i as u8)));
}

/// Cosine of an angle of at most half a turn, with the same bits on every machine, unlike the
/// platform's cosine.
fn cosine(angle: f64) -> f64 {
    let angle = angle.min(std::f64::consts::PI);
    // With the angle halved twice, the series needs few terms.
    let quarter = 0.25 * angle;
    let series =
        |x: f64| (1..10).rev().fold(1.0, |sum, k| 1.0 - sum * x * x / f64::from(2 * k * (2 * k - 1)));
    let doubled = |c: f64| 2.0 * c * c - 1.0;
    doubled(doubled(series(quarter)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cosine_matches_std() {
        for i in 0..=32 {
            let angle = f64::from(i) / 32.0 * std::f64::consts::PI;
            assert!((cosine(angle) - angle.cos()).abs() < 1e-13, "{angle}");
        }
    }
}
