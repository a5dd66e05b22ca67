//! Half-edge collapses, for stars that cannot be filled freely: at seams, between groups, where sheets meet.
//!
//! What may be collapsed, and along which edges, is what the collapse simplifier allows if it keeps seams and topology: the
//! bounds that removals promise hold for such steps only.

use crate::simplify::links::LinkKind;
use crate::simplify::star::Star;

use super::hole::Features;
use super::judge::{Filling, Judge, Verdict};

/// Share of the memoryless cost beside the distances of what was removed before.
const MEMORYLESS_SHARE: f32 = 0.2;

impl Judge<'_> {
    /// The best collapse of `v`; its fan is then in `floor`.
    pub(super) fn judge_collapses(&mut self, v: u32) -> Option<Verdict> {
        self.load_costs(v);
        if !self.keep_to_features(v) {
            return None;
        }
        let mut best: Option<Verdict> = None;
        for k in 0..self.star.ids.len() {
            if self.star.costs[k] < f32::INFINITY
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

    /// Fills the star with the memoryless costs of its neighbours, infinite off the borders that it is on.
    fn load_costs(&mut self, v: u32) {
        self.star.compute_costs();
        let kind = self.links.kind(v);
        let wedges = &self.wedges;
        if !wedges.is_split(v) {
            return self.star.apply_borders(kind, None);
        }
        let seam_between = |star: &Star, s: usize, t: usize| {
            let is_seam = wedges.shown(star.triangles[s], v) != wedges.shown(star.triangles[t], v);
            is_seam.then_some(f32::INFINITY)
        };
        self.star.apply_borders(kind, Some(&seam_between));
    }

    /// Leaves only neighbours along the sharp edges of the star; false where those meet in it.
    fn keep_to_features(&mut self, v: u32) -> bool {
        let kind = self.links.kind(v);
        let (Some(cosine), LinkKind::Closed | LinkKind::Open) = (self.feature_cosine, kind) else {
            return true;
        };
        let star = &mut self.star;
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
        let Self { star, wedges, legality, links, floor, .. } = self;
        if !legality.allows(links, v, star.ids[k]) || !wedges.pair(star, v, k) {
            return None;
        }
        floor.clear();
        let kept = (0..star.triangle_count()).map(|t| star.triangle(t)).filter(|pair| !pair.contains(&k));
        floor.extend(kept.map(|[a, b]| [k, a, b].map(|i| i as u8)));
        if floor.is_empty() {
            return None;
        }
        let own = star.fan_distance_squared(k)?;
        let protrusion = star.protrusion_squared(k);
        let still = star.costs[k] + star.distance_cost(own + protrusion);
        self.place_floor();
        let (increase, worst) = self.increase();
        let worst = worst.max(protrusion);
        let cost = increase.max(0.0) + MEMORYLESS_SHARE * still + Self::spike_cost(worst);
        Some(Verdict { cost, filling: Filling::Collapse(k), worst })
    }
}
