//! Half-edge collapses for stars that cannot be retriangulated freely: at seams, between groups, where
//! sheets meet.
//!
//! The collapse simplifier determines what may be collapsed, along which edges, and the cost of
//! crossing a seam. If no such collapse is allowed either, `removal_evaluator` tries relaxed ones.

use crate::simplify::collapse::judge::Judge as CollapseJudge;
use crate::simplify::collapse::links::LinkKind;

use super::hole::Features;
use super::judge::{Filling, Judge, MEMORYLESS_SHARE, Verdict, fan_into};

impl Judge<'_> {
    /// Returns the best collapse of `v` and leaves its fan in `floor`.
    pub(super) fn judge_collapses(&mut self, v: u32) -> Option<Verdict> {
        self.collapses.load_costs(v);
        if !self.keep_to_features(v) {
            return None;
        }
        let mut best: Option<Verdict> = None;
        for k in 0..self.collapses.star.ids.len() {
            if self.collapses.star.costs[k] < f32::INFINITY
                && let Some(verdict) = self.judge_collapse(v, k)
                && best.is_none_or(|best| verdict.cost < best.cost)
            {
                best = Some(verdict);
                std::mem::swap(&mut self.floor, &mut self.best_floor);
            }
        }
        std::mem::swap(&mut self.floor, &mut self.best_floor);
        self.place_floor();
        best
    }

    /// Restricts the candidates to neighbors along the star's sharp edges; returns false if these meet
    /// or end at its center.
    fn keep_to_features(&mut self, v: u32) -> bool {
        let kind = self.collapses.links.kind(v);
        let (Some(cosine), LinkKind::Closed | LinkKind::Open) = (self.feature_cosine, kind) else {
            return true;
        };
        let star = &mut self.collapses.star;
        let n = star.ids.len();
        self.hole.load((0..n).map(|i| star.offset(i)), kind == LinkKind::Closed);
        match self.hole.features(cosine) {
            Features::None => {}
            Features::Course(a, b) => {
                (0..n).filter(|&i| i != a && i != b).for_each(|i| star.costs[i] = f32::INFINITY);
            }
            Features::Corner => return false,
        }
        true
    }

    fn judge_collapse(&mut self, v: u32, k: usize) -> Option<Verdict> {
        let Self { collapses, floor, .. } = self;
        let CollapseJudge { star, legality, links, .. } = collapses;
        if !legality.allows(links, v, star.ids[k]) || !collapses.pair(v, k) {
            return None;
        }
        let crossing = collapses.crossing_cost(k);
        let star = &mut collapses.star;
        fan_into(star, k, floor);
        if floor.is_empty() {
            return None;
        }
        let own = star.fan_distance_squared(k)?;
        let protrusion = star.protrusion_squared(k);
        let still = star.costs[k] + star.distance_cost(own + protrusion);
        self.place_floor();
        let (increase, worst) = self.increase();
        let worst = worst.max(protrusion);
        let cost = increase.max(0.0) + MEMORYLESS_SHARE * still + crossing + Self::spike_cost(worst);
        Some(Verdict { cost, filling: Filling::Collapse(k), worst })
    }
}
