//! Foliage: when a leaf vanishes, a neighbor grows to make up for its area.
//!
//! A cloud of small parts that loses them one by one also loses their area, and a tree becomes bare. If
//! small parts make up most of the mesh, a corner of the nearest part is therefore first contracted
//! with a corner of the vanishing one:
//!
//! ```text
//!  a---b   v---x          a--------v---x          a--------v
//!  | H |   | P |    ->    |    H   | P |    ->    |    H  /
//!  c---h   y---u          c-------`u---y          c------u
//! ```
//!
//! The neighbor grows by about the area that the part covered. The part's own triangles then lie close
//! to it, so that they vanish next. Compare stochastic simplification of aggregate detail \[CHPR07\],
//! which enlarges the remaining elements; here no vertex is invented.

use glam::Vec3;

use super::collapse_choice::{CollapseChoice, CollapseKind};
use super::cost_evaluator::CostEvaluator;
use super::links::LinkEdge;
use super::parts::LostCover;
use super::relaxed_state::MAX_LEAF_TRIANGLES;

/// Least cosine of the angle by which a grown triangle may turn.
const MIN_COSINE: f32 = 0.3;
/// Weight of the squared longest edge against the missing or excess area.
const LENGTH_WEIGHT: f32 = 0.1;

impl CostEvaluator<'_> {
    /// Returns the contraction that makes up for the vanishing part with the edge from `v` to `u`: a
    /// corner of the nearest part, and the choice to collapse it to `v` or `u`.
    pub(in crate::simplify) fn absorbing_collapse(
        &mut self,
        v: u32,
        u: u32,
    ) -> Option<(u32, CollapseChoice)> {
        let relaxed = self.relaxed.as_ref().filter(|relaxed| relaxed.is_foliage)?;
        let LostCover { cover, host, is_covered } = relaxed.parts.lost_cover(relaxed.parts.part_of(v))?;
        let host = relaxed.find_current(host);
        let part = relaxed.parts.part_of(host);
        if is_covered || relaxed.parts.triangle_count(part) > MAX_LEAF_TRIANGLES {
            return None;
        }
        let target_area = cover + relaxed.parts.cover(part);
        let mut corners = self.links.entries(host).to_vec();
        corners.push(host);
        corners.sort_unstable();
        corners.dedup();
        let gain = target_area - self.area_around(&corners);
        let mut best: Option<(f32, u32, u32)> = None;
        let mut edges: Vec<LinkEdge> = Vec::new();
        for h in corners {
            if self.is_fixed(h) || h == v || h == u {
                continue;
            }
            self.links.edges_into(h, &mut edges);
            for to in [u, v] {
                if let Some(score) = self.growth(h, to, &edges, gain)
                    && best.is_none_or(|(least, ..)| score < least)
                {
                    best = Some((score, h, to));
                }
            }
        }
        let (_, h, to) = best?;
        let moved = self.at(h).distance_squared(self.at(to));
        let choice = CollapseChoice {
            attributes: 0.0,
            kind: CollapseKind::Fold,
            cost: 0.0,
            target: to,
            distance_squared: moved,
            protrusion_squared: moved,
            outward: None,
        };
        self.star.gather(&self.links, &self.positions, h);
        self.keeps_height_field(h, to).then_some((h, choice))
    }

    /// Area of the triangles around some positions; triangles shared by several of them count once.
    fn area_around(&self, corners: &[u32]) -> f32 {
        let mut sum = 0.0;
        let mut edges: Vec<LinkEdge> = Vec::new();
        for &p in corners {
            self.links.edges_into(p, &mut edges);
            let is_first = |q: u32| q > p || corners.binary_search(&q).is_err();
            for e in edges.iter().filter(|e| is_first(e.a) && is_first(e.b)) {
                let [p, a, b] = [p, e.a, e.b].map(|p| self.at(p));
                sum += 0.5 * (a - p).cross(b - p).length();
            }
        }
        sum
    }

    /// Penalty for moving `h`, whose triangles have these opposite edges, to `to` if the part should
    /// gain the area `gain`; `None` if a triangle would turn or the area would shrink.
    fn growth(&self, h: u32, to: u32, edges: &[LinkEdge], gain: f32) -> Option<f32> {
        let (mut before, mut after, mut longest) = (0.0, 0.0, 0.0f32);
        let [from, to_at] = [h, to].map(|p| self.at(p));
        for e in edges {
            let [a, b] = [e.a, e.b].map(|p| self.at(p));
            if e.a == to || e.b == to {
                return None;
            }
            let [old, new] = [from, to_at].map(|p| (a - p).cross(b - p));
            if new.dot(old) < MIN_COSINE * new.length() * old.length() {
                return None;
            }
            before += 0.5 * old.length();
            after += 0.5 * new.length();
            longest = longest.max(a.distance_squared(to_at)).max(b.distance_squared(to_at));
        }
        (after > before).then(|| (after - before - gain).abs() + LENGTH_WEIGHT * longest)
    }

    fn at(&self, p: u32) -> Vec3 {
        let [x, y, z, _] = self.positions[p as usize];
        Vec3::new(x, y, z)
    }
}
