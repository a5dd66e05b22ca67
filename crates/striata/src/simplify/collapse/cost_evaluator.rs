//! Evaluates the cost of collapsing a position: a quick provisional cost, or the best target with its full cost.

use crate::mesh::{DisjointSets, Welded};

use super::attributes::AttributeSpace;
use super::collapse_choice::{CollapseChoice, CollapseKind};
use super::costs::{CollapseCost, CostRules};
use super::fan::point;
use super::height_field::HeightField;
use super::legality::Legality;
use super::links::{LinkKind, Links};
use super::pairs::Pairs;
use super::relaxed_state::RelaxedState;
use super::star::Star;
use super::wedges::Wedges;
use crate::simplify::options::{BoundaryRule, SeamRule, SequenceOptions, TopologyRule};
use crate::simplify::scaled_space::ScaledSpace;

/// Cost of merging two parts: this share of their squared distance, times the area that moves.
const PAIR_WEIGHT: f32 = 0.1;

/// A position with more triangles than this stays until enough of its neighbors are gone: evaluating all
/// its targets takes cubic time, again after each collapse of a neighbor.
const MAX_STAR_TRIANGLES: usize = 255;

/// A surface without seams counts as a scan if its connected parts have this many triangles on average. Levels of the
/// bunny, nefertiti and bigtujunga are the same then down to 2 %; those of meshes of a few thousand triangles are not.
const MIN_SCAN_PART_TRIANGLES: usize = 10_000;

/// How far the cost of a candidate has been evaluated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum EvaluationStage {
    /// Only the quadratic cost, a lower bound of the full cost.
    #[default]
    Bound,
    /// The cost includes the distance of the vertex from its fan, which is possible.
    Measured,
    /// The cost also includes the attributes, but not the colors that textures show.
    Attributed,
    /// The collapse is allowed, and the cost is complete.
    Complete,
}

#[derive(Clone, Copy, Debug, Default)]
struct CandidateTarget {
    stage: EvaluationStage,
    quadratic: f32,
    distance_squared: f32,
    protrusion_squared: f32,
    attributes: f32,
}

/// The current mesh and everything needed to evaluate collapse costs on it.
pub(in crate::simplify) struct CostEvaluator<'a> {
    /// Positions relative to the center of the bounds, with the diagonal scaled to 1, padded to a
    /// vector register.
    pub positions: Vec<[f32; 4]>,
    /// Mesh units per scaled unit.
    pub scale: f64,
    pub links: Links,
    pub wedges: Option<Wedges<'a>>,
    pub cost: Box<dyn CollapseCost>,
    pub rules: CostRules,
    pub pairs: Option<Pairs>,
    pub star: Star,
    pub legality: Legality,
    /// Global state for relaxed collapses, once there may be some.
    pub relaxed: Option<RelaxedState<'a>>,
    pub attributes: Option<AttributeSpace>,
    pub is_locked: Vec<bool>,
    /// The test that the mesh stays a height field, if it must.
    pub height_field: Option<HeightField>,
    /// Whether the mesh was cut out of a larger one, at locked positions.
    pub is_cell: bool,
    /// Whether the surface has no seam, and its parts are large: then nothing is near that the stars around a
    /// collapse do not show, and errors need fewer measurements.
    pub is_scan: bool,
    seams: SeamRule,
    locks_boundary: bool,
    partners: Vec<u32>,
    candidates: Vec<CandidateTarget>,
}

impl<'a> CostEvaluator<'a> {
    /// Creates an evaluator for the full mesh.
    pub(in crate::simplify) fn new(welded: &'a Welded, options: &SequenceOptions) -> Self {
        Self::with_cost(welded, options, ScaledSpace::of(&welded.mesh), options.cost.create())
    }

    /// Creates an evaluator for part of a mesh whose diagonal is `scale` mesh units: costs of all parts are in
    /// the same unit.
    pub(in crate::simplify) fn with_scale(welded: &'a Welded, options: &SequenceOptions, scale: f64) -> Self {
        let space = ScaledSpace::with_scale(&welded.mesh, scale);
        Self::with_cost(welded, options, space, options.cost.create())
    }

    pub(in crate::simplify) fn with_cost(
        welded: &'a Welded,
        options: &SequenceOptions,
        space: ScaledSpace,
        cost: Box<dyn CollapseCost>,
    ) -> Self {
        let rules = cost.rules();
        let scale = space.scale;
        let positions = scaled_positions(welded, &space);
        let position_count = positions.len();
        let has_wedges = !welded.positions.is_identity();
        let follows = has_wedges || rules.follows_triangles;
        let links = if has_wedges {
            let of = |t: &[u32; 3]| t.map(|v| welded.positions.position_of(v));
            let triangles: Vec<[u32; 3]> = welded.mesh.triangles.iter().map(of).collect();
            Links::new(position_count, &triangles, follows)
        } else {
            Links::new(position_count, &welded.mesh.triangles, follows)
        };
        let mut evaluator = Self {
            positions,
            scale,
            links,
            wedges: has_wedges.then(|| Wedges::new(&welded.positions, welded.mesh.triangles.clone())),
            cost,
            rules,
            pairs: None,
            star: Star::default(),
            legality: Legality::default(),
            relaxed: None,
            attributes: AttributeSpace::new(welded, options, scale),
            is_locked: locked_positions(welded, &options.locked_vertices, options.group_borders),
            height_field: HeightField::of(welded, options.height_field),
            is_cell: false,
            is_scan: is_scan(welded),
            seams: options.seams,
            locks_boundary: options.boundary == BoundaryRule::Locked,
            partners: Vec::new(),
            candidates: Vec::new(),
        };
        let Self { cost, star, links, positions, .. } = &mut evaluator;
        cost.begin(star, links, positions, welded.mesh.triangle_count());
        if let Some(distance) = options.pair_distance.filter(|&d| d > 0.0) {
            let threshold = ((distance / scale) as f32).clamp(1e-6, 1.0);
            let is_neighbor = |p: u32, q: u32| evaluator.links.entries(p).contains(&q);
            evaluator.pairs = Some(Pairs::new(&evaluator.positions, threshold, is_neighbor));
            evaluator.legality.may_merge = true;
            // With any other rule, relaxed collapses let parts vanish, at a cost.
            evaluator.legality.may_vanish = options.topology == TopologyRule::Keep;
        }
        evaluator
    }

    /// Gathers the star of `v` and computes the quadratic costs of its candidates.
    fn load_star(&mut self, v: u32) {
        self.gather(v);
        self.load_costs(v);
    }

    /// Computes the quadratic costs of the gathered star's candidates, including borders.
    pub(in crate::simplify) fn load_costs(&mut self, v: u32) {
        self.fill_costs(v);
        self.apply_borders(v);
    }

    /// Computes the quadratic costs of the gathered star's candidates, ignoring borders.
    pub(in crate::simplify) fn fill_costs(&mut self, v: u32) {
        self.star.compute_costs();
        self.cost.fill(&mut self.star, &self.positions, v);
    }

    /// Restricts the candidates of the gathered star to the borders on which `v` lies.
    fn apply_borders(&mut self, v: u32) {
        let kind = self.links.kind(v);
        match &self.wedges {
            Some(wedges) if wedges.is_split(v) => {
                let (rule, attributes) = (self.seams, self.attributes.as_ref());
                let seam_between = |star: &Star, s: usize, t: usize| {
                    let (a, b) = (star.center_wedges[s], star.center_wedges[t]);
                    let difference_squared = || match rule {
                        SeamRule::Cross => attributes.map_or(0.0, |space| space.border_squared(a, b)),
                        SeamRule::Keep => f32::INFINITY,
                    };
                    (a != b).then(difference_squared)
                };
                self.star.apply_borders(kind, Some(&seam_between));
            }
            _ => self.star.apply_borders(kind, None),
        }
    }

    /// Loads the wedge of `v` in each triangle of the gathered star.
    fn load_wedges(&mut self, v: u32) {
        if let Some(wedges) = &self.wedges {
            wedges.load_center_wedges(&mut self.star, v);
        }
    }

    /// Gathers the star of `v`, with the wedge of `v` in each triangle.
    pub(in crate::simplify) fn gather(&mut self, v: u32) {
        self.star.gather(&self.links, &self.positions, v);
        self.load_wedges(v);
    }

    /// Gathers the star of `v` and pairs its wedges with those of `u`; returns the index of `u` in the
    /// star if it is a neighbor.
    pub(in crate::simplify) fn gather_and_pair(&mut self, v: u32, u: u32) -> Option<usize> {
        self.gather(v);
        let k = self.star.ring.index_of(u)?;
        self.pair(v, k);
        Some(k)
    }

    /// Pairs the wedges of `v` with those of neighbor `k` of its star; returns false if the seam rule
    /// or a conflict forbids it.
    pub(in crate::simplify) fn pair(&mut self, v: u32, k: usize) -> bool {
        let Self { wedges: Some(wedges), attributes, star, .. } = self else { return true };
        match self.seams {
            SeamRule::Keep => wedges.pair(star, v, k),
            SeamRule::Cross => wedges.pair_across(star, v, k, |a, b| {
                attributes.as_ref().map_or(0.0, |space| space.difference_squared(a, b))
            }),
        }
    }

    /// Locks every position that is on a boundary now, if the options lock boundaries: relaxed
    /// collapses may close boundaries later.
    pub(in crate::simplify) fn lock_boundary(&mut self) {
        for v in (0..self.positions.len() as u32).filter(|_| self.locks_boundary) {
            self.is_locked[v as usize] |= self.links.is_boundary(v);
        }
    }

    /// Whether the surface has no seam and no border of any kind.
    pub(in crate::simplify) fn is_closed_scan(&self) -> bool {
        self.wedges.is_none() && self.is_closed()
    }

    /// Whether the surface has no border of any kind, apart from where it was cut into cells.
    pub(in crate::simplify) fn is_closed(&self) -> bool {
        let is_cut = |p: u32| self.is_cell && self.is_locked[p as usize];
        let is_closed = |p: u32| matches!(self.links.kind(p), LinkKind::Closed | LinkKind::Empty);
        (0..self.positions.len() as u32).all(|p| is_closed(p) || is_cut(p))
    }

    /// Whether `v` has too many triangles to be evaluated.
    pub(in crate::simplify) fn is_hub(&self, v: u32) -> bool {
        self.links.triangle_count(v) > MAX_STAR_TRIANGLES
    }

    /// Whether `v` may not be removed now: because the options lock it, because it has no triangles, or
    /// because it has too many.
    pub(in crate::simplify) fn is_fixed(&self, v: u32) -> bool {
        self.is_locked[v as usize]
            || self.is_hub(v)
            || self.links.kind(v) == LinkKind::Empty
            || (self.locks_boundary && self.links.is_boundary(v))
    }

    /// Provisional cost of collapsing `v`, nearly always below its full cost; infinite if `v` may not be
    /// collapsed at all.
    pub(in crate::simplify) fn provisional_cost(&mut self, v: u32) -> f32 {
        if self.is_fixed(v) {
            return f32::INFINITY;
        }
        self.load_star(v);
        if self.pairs.is_some() && self.has_partner(v) {
            return 0.0;
        }
        let least = self.star.costs.iter().copied().fold(f32::INFINITY, f32::min);
        if least > 0.0 && self.is_nearly_gone(v) {
            // The whole part may vanish in one collapse, at a cost that is not known yet.
            return 0.0;
        }
        self.rules.bound_factor * least
    }

    fn has_partner(&mut self, v: u32) -> bool {
        let Some(pairs) = &mut self.pairs else { return false };
        pairs.partners_into(v, &mut self.partners);
        !self.partners.is_empty()
    }

    /// Returns the cheapest allowed target of `v`.
    ///
    /// Evaluation is best first: the candidate that looks cheapest gets its next, more expensive test,
    /// until the cheapest one has passed all tests.
    pub(in crate::simplify) fn best_choice(&mut self, v: u32) -> Option<CollapseChoice> {
        self.best_choice_with(v, |_, _| {})
    }

    /// Variant of [`Self::best_choice`] that calls `adjust` before any candidate is tested.
    /// `adjust` may raise the costs in the star, which then count as part of the quadratic cost, or set
    /// them to infinity to exclude targets.
    pub(in crate::simplify) fn best_choice_with(
        &mut self,
        v: u32,
        adjust: impl FnOnce(&Links, &mut Star),
    ) -> Option<CollapseChoice> {
        self.load_star(v);
        adjust(&self.links, &mut self.star);
        self.cost.load(&self.star, &self.positions, v);
        self.candidates.clear();
        self.candidates.resize(self.star.ring.ids.len(), CandidateTarget::default());
        let best = loop {
            let Some((k, cost)) = self.star.cheapest() else { break None };
            let candidate = self.candidates[k];
            if candidate.stage == EvaluationStage::Complete {
                let target = self.star.ring.ids[k];
                let CandidateTarget { distance_squared, protrusion_squared, attributes, .. } = candidate;
                break Some(CollapseChoice {
                    kind: CollapseKind::Strict,
                    cost,
                    attributes,
                    target,
                    distance_squared,
                    protrusion_squared,
                    outward: None,
                });
            }
            let refined = match candidate.stage {
                EvaluationStage::Bound => self.measure(v, k),
                EvaluationStage::Measured if self.attributes.is_some() => Some(self.attributed_cost(v, k)),
                _ => self.complete_cost(v, k),
            };
            self.star.costs[k] = refined.unwrap_or(f32::INFINITY);
        };
        if self.pairs.is_some() { self.best_pair(v, best) } else { best }
    }

    /// Tests whether `v` may move to neighbor `k`, and returns its cost with the distance of `v` from the fan.
    fn measure(&mut self, v: u32, k: usize) -> Option<f32> {
        let u = self.star.ring.ids[k];
        // Attributes often exclude more targets than the topology does, whose test takes longer.
        if self.attributes.is_none() && !self.legality.allows(&self.links, v, u) {
            return None;
        }
        if !self.keeps_height_field(v, u) {
            return None;
        }
        if self.pairs.is_some() && !self.leaves_enough(v, u) {
            return None;
        }
        if !self.pair(v, k) {
            return None;
        }
        let distance_squared = match self.star.fan_distance_squared(k) {
            Some(distance_squared) => distance_squared,
            // Parts that may merge may also fold and vanish, at the cost of the whole edge.
            None if self.pairs.is_some() => self.star.offset(k).length_squared(),
            None => return None,
        };
        let quadratic = self.star.costs[k];
        self.candidates[k] = CandidateTarget {
            stage: EvaluationStage::Measured,
            quadratic,
            distance_squared,
            ..CandidateTarget::default()
        };
        let CostRules { counts_fan, surface_share, .. } = self.rules;
        let of_fan = if counts_fan { surface_share * self.star.distance_cost(distance_squared) } else { 0.0 };
        Some(quadratic + of_fan)
    }

    /// Whether collapsing `v`, whose star has been gathered, to `u` leaves a height field if it must.
    pub(in crate::simplify) fn keeps_height_field(&self, v: u32, u: u32) -> bool {
        self.height_field.as_ref().is_none_or(|field| field.allows(&self.star, v, u))
    }

    /// Returns the cost of neighbor `k` as the target with attributes, but without how far the fan sticks out.
    fn attributed_cost(&mut self, v: u32, k: usize) -> f32 {
        self.pair(v, k);
        let attributes = self.attribute_cost(v, k);
        let candidate = &mut self.candidates[k];
        (candidate.stage, candidate.attributes) = (EvaluationStage::Attributed, attributes);
        self.star.costs[k] + attributes
    }

    /// Returns the full cost of neighbor `k` as the target, if it may be the target.
    fn complete_cost(&mut self, v: u32, k: usize) -> Option<f32> {
        if self.attributes.is_some() && !self.legality.allows(&self.links, v, self.star.ring.ids[k]) {
            return None;
        }
        self.candidates[k].stage = EvaluationStage::Complete;
        let CandidateTarget { quadratic, distance_squared, attributes, .. } = self.candidates[k];
        let mut cost = quadratic;
        if self.rules.counts_fan {
            let protrusion_squared = self.star.protrusion_squared(k);
            self.candidates[k].protrusion_squared = protrusion_squared;
            let off = distance_squared + protrusion_squared;
            cost += self.rules.surface_share * self.star.distance_cost(off);
        }
        cost += self.cost.increase(&mut self.star, k, v, distance_squared);
        cost += attributes;
        if self.attributes.as_ref().is_some_and(AttributeSpace::has_colors) {
            self.pair(v, k);
            let colors = self.color_cost(v, k);
            self.candidates[k].attributes += colors;
            cost += colors;
        }
        Some(cost)
    }

    /// Attribute cost of collapsing `v` to neighbor `k`; the wedges must be paired.
    pub(in crate::simplify) fn attribute_cost(&self, v: u32, k: usize) -> f32 {
        let attributes = self.attributes.as_ref();
        attributes.map_or(0.0, |space| space.cost(&self.star, self.wedges.as_ref(), v, k))
    }

    /// Cost of the colors that collapsing `v` to neighbor `k` changes; the wedges must be paired.
    pub(in crate::simplify) fn color_cost(&self, v: u32, k: usize) -> f32 {
        let attributes = self.attributes.as_ref();
        attributes.map_or(0.0, |space| space.color_cost(&self.star, self.wedges.as_ref(), v, k))
    }

    /// Cost of a squared distance over the star of `v`; gathers the star.
    pub(in crate::simplify) fn distance_cost(&mut self, v: u32, squared: f32) -> f32 {
        self.star.gather(&self.links, &self.positions, v);
        self.star.compute_costs();
        self.rules.surface_share * self.star.distance_cost(squared)
    }

    /// Returns the cheapest contraction of `v` with a partner if it is cheaper than `best`, otherwise `best`.
    fn best_pair(&mut self, v: u32, mut best: Option<CollapseChoice>) -> Option<CollapseChoice> {
        if !self.has_partner(v) {
            return best;
        }
        let center = point(&self.positions, v);
        let partners = std::mem::take(&mut self.partners);
        for &target in &partners {
            let to = point(&self.positions, target) - center;
            if self.links.kind(target) == LinkKind::Empty
                || self.links.entries(v).contains(&target)
                || !self.keeps_height_field(v, target)
            {
                continue;
            }
            let distance_squared = self.star.moved_distance_squared(to).unwrap_or(to.length_squared());
            let cost = self.cost.contraction(&self.star, &self.positions, [v, target], distance_squared)
                + PAIR_WEIGHT * self.star.area() * to.length_squared();
            if cost < best.map_or(f32::INFINITY, |b| b.cost) {
                best = Some(CollapseChoice {
                    kind: CollapseKind::Strict,
                    cost,
                    attributes: 0.0,
                    target,
                    distance_squared,
                    protrusion_squared: 0.0,
                    outward: None,
                });
            }
        }
        self.partners = partners;
        best
    }

    /// Maps all wedges of `v`, which no triangle uses, to the first vertex of `u`.
    pub(in crate::simplify) fn write_single_target(&self, v: u32, u: u32, targets: &mut [u32]) {
        match &self.wedges {
            Some(wedges) => wedges.write_single_target(v, u, targets),
            None => targets[v as usize] = u,
        }
    }

    /// Pairs each wedge of `v` with the wedge of `u` nearest to it in attributes, for parts that merge.
    pub(in crate::simplify) fn pair_wedges(&mut self, v: u32, u: u32) {
        let Some(wedges) = &mut self.wedges else { return };
        let attributes = &self.attributes;
        wedges.pair_nearest(v, u, |a, b| {
            attributes.as_ref().map_or(0.0, |space| space.difference_squared(a, b))
        });
    }
}

/// Whether a mesh is a large surface without seams, or several: see [`CostEvaluator::is_scan`].
pub(crate) fn is_scan(welded: &Welded) -> bool {
    welded.positions.is_identity() && has_large_parts(welded, MIN_SCAN_PART_TRIANGLES)
}

/// Whether the connected parts of a mesh have at least this number of triangles on average.
pub(in crate::simplify) fn has_large_parts(welded: &Welded, triangle_count: usize) -> bool {
    let mut part_count = welded.positions.position_count();
    let mut parts = DisjointSets::new(part_count);
    for t in &welded.mesh.triangles {
        let [a, b, c] = t.map(|v| welded.positions.position_of(v));
        part_count -= usize::from(parts.join(a, b)) + usize::from(parts.join(b, c));
    }
    triangle_count * part_count <= welded.mesh.triangle_count()
}

/// Returns which positions must stay: those of locked vertices and those on locked borders between groups.
pub(crate) fn locked_positions(
    welded: &Welded,
    locked_vertices: &[u32],
    group_borders: BoundaryRule,
) -> Vec<bool> {
    let mut is_locked = vec![false; welded.positions.position_count()];
    for &vertex in locked_vertices {
        let position = welded.position_of_source.get(vertex as usize);
        if let Some(is_locked) = position.and_then(|&p| is_locked.get_mut(p as usize)) {
            *is_locked = true;
        }
    }
    if group_borders == BoundaryRule::Locked {
        lock_group_borders(welded, &mut is_locked);
    }
    is_locked
}

/// Locks every position that is used by triangles of more than one group.
fn lock_group_borders(welded: &Welded, is_locked: &mut [bool]) {
    const UNSEEN: u32 = u32::MAX;
    let mut group_of_position = vec![UNSEEN; is_locked.len()];
    for (index, group) in (0..).zip(&welded.mesh.groups) {
        for &vertex in welded.mesh.triangles[group.range()].as_flattened() {
            let position = welded.positions.position_of(vertex) as usize;
            match group_of_position[position] {
                UNSEEN => group_of_position[position] = index,
                seen => is_locked[position] |= seen != index,
            }
        }
    }
}

/// Returns all positions in a space.
fn scaled_positions(welded: &Welded, space: &ScaledSpace) -> Vec<[f32; 4]> {
    let scaled = |p: u32| {
        let position = welded.mesh.positions[welded.positions.first_vertex(p) as usize];
        let [x, y, z] = space.scaled(position).as_vec3().to_array();
        [x, y, z, 0.0]
    };
    (0..welded.positions.position_count() as u32).map(scaled).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{IndexedMesh, shapes, weld};

    #[test]
    fn scans_are_large_parts_without_seams() {
        let is_scan = |mesh: &IndexedMesh| {
            let welded = weld(mesh).expect("the mesh is valid");
            CostEvaluator::new(&welded, &SequenceOptions::default()).is_scan
        };
        let bare = |mesh: IndexedMesh| IndexedMesh { layers: Vec::new(), ..mesh };
        let terrain = bare(shapes::terrain(80, 1));
        assert!(is_scan(&terrain), "an open surface");
        assert!(!is_scan(&bare(shapes::terrain(60, 1))), "too small");
        let mut two = terrain.clone();
        let count = two.positions.len() as u32;
        two.positions.extend(terrain.positions.iter().map(|&[x, y, z]| [x, y, z + 100.0]));
        two.triangles.extend(terrain.triangles.iter().map(|t| t.map(|v| v + count)));
        assert!(is_scan(&two), "two large parts");
        two.positions.extend([[0.0, 0.0, 200.0], [1.0, 0.0, 200.0], [0.0, 1.0, 200.0]]);
        two.triangles.push([2 * count, 2 * count + 1, 2 * count + 2]);
        assert!(!is_scan(&two), "three parts, which are small on average");
    }
}
