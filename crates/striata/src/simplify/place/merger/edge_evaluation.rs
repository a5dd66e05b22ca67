//! Evaluates the edges of a position: their order, and the position of the new vertex.

use glam::DVec3;

use super::EdgeChoice;
use super::Merger;
use crate::simplify::collapse::collapse_choice::{CollapseChoice, CollapseKind};
use crate::simplify::collapse::cost_evaluator::CostEvaluator;
use crate::simplify::options::SeamRule;
use crate::simplify::place::neighborhood::PositionStar;
use crate::simplify::place::quadratic_form::EdgeForm;
use crate::simplify::place::seams::{Merge, SeamCosts, seam_weight};

/// Weight of the squared distances of both ends from the new triangles, times the area. It costs 1 % of
/// RMS and reduces maxima by a fifth, since planes alone do not detect the loss of a thin spike.
const DISTANCE_WEIGHT: f64 = 0.1;
/// Area, as a multiple of the squared distance, that lost ends count for in addition to the area of
/// their stars. On meshes of thin parts, it reduces RMS by a fifth down to 10 % of the triangles; on
/// scans it changes almost nothing.
const SPIKE_WEIGHT: f64 = 32.0;

/// Rule for placing the new vertex of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum EdgePlacement {
    Free,
    /// At the end from which the edge is evaluated.
    FirstEnd,
    /// At the other end.
    SecondEnd,
    /// At either end.
    EitherEnd,
    Forbidden,
}

/// Cost of the first candidate position.
fn first_candidate_cost(edge: &EdgeForm, placement: EdgePlacement, tip: DVec3) -> f64 {
    let position = match placement {
        EdgePlacement::Free => edge.volume_preserving().or_else(|| edge.cheapest()).unwrap_or(0.5 * tip),
        EdgePlacement::FirstEnd => DVec3::ZERO,
        EdgePlacement::SecondEnd => tip,
        EdgePlacement::EitherEnd => return edge.cost(DVec3::ZERO).min(edge.cost(tip)),
        EdgePlacement::Forbidden => return f64::INFINITY,
    };
    edge.cost(position)
}

/// Returns candidate positions for the new vertex, relative to the edge's first end and best first,
/// each with whether the first end is the one kept.
fn candidate_positions(edge: &EdgeForm, placement: EdgePlacement, tip: DVec3) -> [Option<(DVec3, bool)>; 5] {
    let (first_end, second_end) = ((DVec3::ZERO, true), (tip, false));
    let ends = if edge.cost(first_end.0) <= edge.cost(second_end.0) {
        [first_end, second_end]
    } else {
        [second_end, first_end]
    };
    match placement {
        EdgePlacement::Free => [
            edge.volume_preserving().map(|position| (position, false)),
            edge.cheapest().map(|position| (position, false)),
            Some((0.5 * tip, false)),
            Some((ends[0].0, false)),
            Some((ends[1].0, false)),
        ],
        EdgePlacement::FirstEnd => [Some(first_end), None, None, None, None],
        EdgePlacement::SecondEnd => [Some(second_end), None, None, None, None],
        EdgePlacement::EitherEnd => [Some(ends[0]), Some(ends[1]), None, None, None],
        EdgePlacement::Forbidden => [None; 5],
    }
}

impl Merger<'_> {
    pub(super) fn gather(&mut self, v: u32) {
        gather_into(&mut self.neighborhood, &self.evaluator, &self.positions, self.seams, v);
    }

    /// Lower bound of the cost of collapsing an edge of `v`; infinite if no edge may be collapsed.
    pub(super) fn provisional_cost(&mut self, v: u32) -> f32 {
        if self.evaluator.is_hub(v) {
            return f32::INFINITY;
        }
        self.gather(v);
        self.fill_costs(v);
        let least = self.costs.iter().copied().fold(f32::INFINITY, f32::min);
        if least < f32::INFINITY || !self.schedule.is_possible() || self.evaluator.is_fixed(v) {
            return least;
        }
        self.evaluator.gather(v);
        self.evaluator.fill_costs(v);
        self.evaluator.star.costs.iter().copied().fold(f32::INFINITY, f32::min)
    }

    /// Computes the costs of all edges of the gathered `v` from the quadratic forms alone.
    pub(super) fn fill_costs(&mut self, v: u32) {
        self.costs.clear();
        for i in 0..self.neighborhood.ring.ids.len() {
            let cost = match self.placement(v, i) {
                EdgePlacement::Forbidden => f64::INFINITY,
                placement => {
                    first_candidate_cost(&self.edge_form(v, i), placement, self.neighborhood.offsets[i])
                }
            };
            self.costs.push(cost as f32);
        }
    }

    fn edge_form(&self, v: u32, i: usize) -> EdgeForm {
        let other = &self.stars[self.neighborhood.ring.ids[i] as usize].form;
        EdgeForm::new(
            &self.stars[v as usize].form,
            other,
            self.neighborhood.shared(i),
            self.neighborhood.offsets[i],
        )
    }

    /// Returns the rule for placing the new vertex of the edge from the gathered `v` to its neighbor `i`.
    fn placement(&self, v: u32, i: usize) -> EdgePlacement {
        let u = self.neighborhood.ring.ids[i];
        if self.evaluator.is_hub(u) {
            return EdgePlacement::Forbidden;
        }
        let borders = [v, u].map(|p| self.stars[p as usize].border_count);
        let locked = [v, u].map(|p| self.evaluator.is_locked[p as usize]);
        let stays = if self.neighborhood.is_border(i) {
            // A vertex at which borders meet or end must stay in place.
            [0, 1].map(|end| locked[end] || borders[end] != 2)
        } else {
            if borders[0] > 0 && borders[1] > 0 {
                return EdgePlacement::Forbidden;
            }
            [0, 1].map(|end| locked[end] || borders[end] > 0)
        };
        match (stays, locked) {
            (_, [true, true]) => EdgePlacement::Forbidden,
            ([false, false], _) => EdgePlacement::Free,
            ([true, false], _) => EdgePlacement::FirstEnd,
            ([false, true], _) => EdgePlacement::SecondEnd,
            // On a border, only a locked end must be the one that stays.
            ([true, true], [true, false]) if self.neighborhood.is_border(i) => EdgePlacement::FirstEnd,
            ([true, true], [false, true]) if self.neighborhood.is_border(i) => EdgePlacement::SecondEnd,
            ([true, true], [false, false]) => EdgePlacement::EitherEnd,
            _ => EdgePlacement::Forbidden,
        }
    }

    /// Evaluates the edges of `v` in full and updates its key to the true cost, or removes `v` from the
    /// heap if no collapse is allowed.
    pub(super) fn decide(&mut self, v: u32, bound: f32) {
        self.gather(v);
        self.fill_costs(v);
        let mut best: Option<(f32, EdgeChoice)> = None;
        loop {
            let limit = best.map_or(f32::INFINITY, |(cost, _)| cost);
            let least = self.costs.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
            let Some(i) = least.filter(|(_, cost)| **cost < limit).map(|(i, _)| i) else { break };
            self.costs[i] = f32::INFINITY;
            if let Some(found) = self.evaluate_edge(v, i, limit).filter(|(cost, _)| *cost < limit) {
                best = Some(found);
            }
        }
        match best.or_else(|| self.relaxed(v)) {
            None => self.heap.remove(v),
            Some((cost, choice)) => {
                self.choices[v as usize] = Some(choice);
                if cost > bound {
                    self.heap.set(v, cost);
                }
            }
        }
    }

    /// Returns the relaxed collapse of `v` and its cost, if `v` may have one now.
    fn relaxed(&mut self, v: u32) -> Option<(f32, EdgeChoice)> {
        if self.evaluator.is_fixed(v) {
            return None;
        }
        self.schedule.begin_or_postpone(&mut self.evaluator, (&self.removed, &self.targets));
        self.evaluator.gather(v);
        let CollapseChoice { kind, cost, target, distance_squared, .. } = self.evaluator.relaxed_choice(v)?;
        let (position, other_version) =
            (self.positions[target as usize], self.stars[target as usize].version);
        Some((
            cost,
            EdgeChoice { other: target, other_version, is_kept: false, position, kind, distance_squared },
        ))
    }

    /// Returns the first position for the new vertex that passes all tests, or the cheapest one if
    /// seams are crossed, and its cost.
    pub(super) fn evaluate_edge(&mut self, v: u32, i: usize, limit: f32) -> Option<(f32, EdgeChoice)> {
        let placement = self.placement(v, i);
        let u = self.neighborhood.ring.ids[i];
        let edge = self.edge_form(v, i);
        let offset = self.neighborhood.offsets[i];
        gather_into(&mut self.other_neighborhood, &self.evaluator, &self.positions, self.seams, u);
        let both_move = placement == EdgePlacement::Free;
        let mut seam_costs = SeamCosts::default();
        let mut best: Option<(f32, EdgeChoice)> = None;
        for (local, is_kept) in candidate_positions(&edge, placement, offset).into_iter().flatten() {
            let (removed, kept) = if is_kept { (u, v) } else { (v, u) };
            // Ends stay exactly where they are, without rounding.
            let is_end = local == if is_kept { DVec3::ZERO } else { offset };
            let position =
                if is_end { self.positions[kept as usize] } else { self.neighborhood.center + local };
            let merge = Merge { removed, kept, share: self.edge_share(removed, kept, position) };
            if edge.cost(local) as f32 >= best.map_or(limit, |(least, _)| least) {
                continue;
            }
            let CostEvaluator { legality, links, .. } = &mut self.evaluator;
            let is_allowed = legality.allows(links, removed, kept);
            if !is_allowed && both_move {
                break;
            }
            let seams = (&mut self.evaluator, self.seams);
            let crossing = if is_allowed { seam_costs.cost(seams, (merge, v), both_move) } else { None };
            let Some(crossing) = crossing else {
                if both_move && self.seams == SeamRule::Keep {
                    break;
                }
                continue;
            };
            let mean = edge.normal();
            if self.neighborhood.may_move(position, u, mean)
                && self.other_neighborhood.may_move(position, v, mean)
                && self.keeps_height_field(v, u, is_end.then_some(kept), position)
            {
                let left = self.neighborhood.distance_squared(position, u)
                    + self.other_neighborhood.distance_squared(position, v);
                let distance_cost = DISTANCE_WEIGHT * (edge.area() + SPIKE_WEIGHT * left) * left;
                let cost = (edge.cost(local) + distance_cost + crossing) as f32;
                if best.is_none_or(|(least, _)| cost < least) {
                    let other_version = self.stars[u as usize].version;
                    let kind = CollapseKind::Strict;
                    let choice = EdgeChoice {
                        other: u,
                        other_version,
                        is_kept,
                        position,
                        kind,
                        distance_squared: 0.0,
                    };
                    best = Some((cost, choice));
                }
                if crossing == 0.0 {
                    break;
                }
            }
        }
        best
    }

    /// Whether merging `v` and `u` at a position, or at the end that stays where it is, leaves a height field if it
    /// must.
    fn keeps_height_field(&self, v: u32, u: u32, end: Option<u32>, position: DVec3) -> bool {
        self.evaluator.height_field.as_ref().is_none_or(|field| {
            let place = end.map_or_else(|| self.plan_of(position), |end| field.at(end));
            self.neighborhood.keeps_height_field(field, v, u, place)
                && self.other_neighborhood.keeps_height_field(field, u, v, place)
        })
    }

    /// Place of a position in plan, mesh units.
    pub(super) fn plan_of(&self, position: DVec3) -> [f32; 2] {
        let [x, y, _] = self.space.unscaled(position);
        [x, y]
    }

    /// Returns the place of `position` along the edge, from 0 at `kept` to 1 at `removed`.
    pub(super) fn edge_share(&self, removed: u32, kept: u32, position: DVec3) -> f64 {
        let from = self.positions[kept as usize];
        let along = self.positions[removed as usize] - from;
        let share = (position - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
        share.clamp(0.0, 1.0)
    }
}

/// Gathers the star of `v` with its seams.
fn gather_into(
    neighborhood: &mut PositionStar,
    evaluator: &CostEvaluator<'_>,
    positions: &[DVec3],
    seams: SeamRule,
    v: u32,
) {
    if evaluator.wedges.as_ref().is_some_and(|wedges| wedges.is_split(v)) {
        let weight = |triangles: [u32; 2], along: DVec3| seam_weight(evaluator, seams, v, triangles, along);
        neighborhood.gather(&evaluator.links, positions, v, Some(&weight));
    } else {
        neighborhood.gather(&evaluator.links, positions, v, None);
    }
}
