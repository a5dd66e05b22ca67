//! Half-edge collapses for stars that cannot be retriangulated freely: at seams, between groups, where
//! sheets meet.
//!
//! The collapse simplifier determines what may be collapsed, along which edges, and the cost of
//! crossing a seam. If no such collapse is allowed either, `removal_evaluator` tries relaxed ones.

use crate::simplify::collapse::cost_evaluator::CostEvaluator;
use crate::simplify::collapse::links::LinkKind;

use super::hole::Features;
use super::removal_evaluator::{Filling, MEMORYLESS_SHARE, RemovalCandidate, RemovalEvaluator, fan_into};
use super::removal_options::RemovalOrder;

impl RemovalEvaluator<'_> {
    /// Returns the best collapse of `v` and leaves its fan in `floor`.
    pub(super) fn evaluate_collapses(&mut self, v: u32) -> Option<RemovalCandidate> {
        self.collapse_evaluator.load_costs(v);
        if !self.restrict_to_features(v) {
            return None;
        }
        let mut best: Option<RemovalCandidate> = None;
        for k in 0..self.collapse_evaluator.star.ring.ids.len() {
            if self.collapse_evaluator.star.costs[k] < f32::INFINITY
                && let Some(candidate) = self.evaluate_collapse(v, k)
                && best.is_none_or(|best| candidate.cost < best.cost)
            {
                best = Some(candidate);
                std::mem::swap(&mut self.floor, &mut self.best_floor);
            }
        }
        std::mem::swap(&mut self.floor, &mut self.best_floor);
        self.update_floor_corners();
        best
    }

    /// Restricts the candidates to neighbors along the star's sharp edges; returns false if these meet
    /// or end at its center.
    fn restrict_to_features(&mut self, v: u32) -> bool {
        let kind = self.collapse_evaluator.links.kind(v);
        let (Some(cosine), LinkKind::Closed | LinkKind::Open) = (self.feature_cosine, kind) else {
            return true;
        };
        let star = &mut self.collapse_evaluator.star;
        let n = star.ring.ids.len();
        self.hole.load((0..n).map(|i| star.offset(i)), kind == LinkKind::Closed);
        match self.hole.features(cosine) {
            Features::None => {}
            Features::Crease(a, b) => {
                (0..n).filter(|&i| i != a && i != b).for_each(|i| star.costs[i] = f32::INFINITY);
            }
            Features::Corner => return false,
        }
        true
    }

    fn evaluate_collapse(&mut self, v: u32, k: usize) -> Option<RemovalCandidate> {
        let Self { collapse_evaluator, floor, .. } = self;
        let CostEvaluator { star, legality, links, .. } = collapse_evaluator;
        let u = star.ring.ids[k];
        if !legality.allows(links, v, u)
            || !collapse_evaluator.keeps_height_field(v, u)
            || !collapse_evaluator.pair(v, k)
        {
            return None;
        }
        let crossing = collapse_evaluator.crossing_cost(k);
        let star = &mut collapse_evaluator.star;
        fan_into(star, k, floor);
        if floor.is_empty() {
            return None;
        }
        let own = star.fan_distance_squared(k)?;
        let protrusion = star.protrusion_squared(k);
        let surface_cost = star.costs[k] + star.distance_cost(own + protrusion);
        self.update_floor_corners();
        let (increase, one_sided) = self.increase();
        let worst = one_sided.max(protrusion);
        let cost = match self.options.order {
            RemovalOrder::Mixed => {
                increase.max(0.0) + MEMORYLESS_SHARE * surface_cost + crossing + Self::spike_cost(worst)
            }
            // Attributes have no place in the published order; crossing a seam counts as a distance.
            RemovalOrder::Hausdorff => {
                one_sided + crossing / self.collapse_evaluator.star.area().max(f32::MIN_POSITIVE)
            }
        };
        Some(RemovalCandidate { cost, filling: Filling::Collapse(k), worst })
    }
}
