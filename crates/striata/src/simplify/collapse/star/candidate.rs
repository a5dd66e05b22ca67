//! Geometric tests of one candidate: whether its fan is valid, and how far the old and new surface are apart.

use glam::{DVec3, Vec3};
use wide::f32x8;

use super::Star;
use super::lanes::{LANES, NO_TRIANGLE, Vec3x8, ensure_len, lane_min, load_lanes, slices, vector_starts};
use crate::simplify::collapse::fan;
use crate::simplify::collapse::flat_fold::{TriangleNormal, turns_over};

impl Star {
    /// Squared distance of `v` from the fan that neighbor `k` as the target would leave; `None` if a
    /// triangle would flip or become a sliver.
    pub(in crate::simplify) fn fan_distance_squared(&mut self, k: usize) -> Option<f32> {
        self.mark_vanishing(Some(k));
        let distance_squared = self.distance_squared_from(self.offset(k))?;
        if distance_squared < f32::INFINITY {
            return Some(distance_squared);
        }
        // No triangle is left (the last one of a border): measure the edges that remain of the old triangles.
        let edge = |t: usize| {
            let [a, b] = self.ring.triangle(t).map(|i| self.offset(i));
            fan::distance_squared(self.offset(k), a, b)
        };
        Some((0..self.ring.triangle_count()).map(edge).fold(f32::INFINITY, f32::min))
    }

    /// Squared distance of `v` from its star moved to `to`, which is not a neighbor, so that all
    /// triangles stay; `None` if a triangle would flip or become a sliver.
    pub(in crate::simplify) fn moved_distance_squared(&mut self, to: Vec3) -> Option<f32> {
        self.mark_vanishing(None);
        self.distance_squared_from(to)
    }

    fn distance_squared_from(&self, to: Vec3) -> Option<f32> {
        let u = Vec3x8::splat(to);
        let uu = u.dot(u);
        let star = fan::StarNormal::new(self.mean_normal);
        let [a, b] = self.corners();
        let normals = slices(&self.normals, 0);
        let mut least = f32x8::splat(f32::INFINITY);
        for t in vector_starts(self.ring.triangle_count()) {
            let (a, b) = (Vec3x8::load(a, t), Vec3x8::load(b, t));
            let vanishes = load_lanes(&self.vanishes, t).simd_gt(f32x8::ZERO);
            let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
            let (ua, ub) = (u.dot(a), u.dot(b));
            let old = Vec3x8::load(normals, t);
            let new = a.sub(u).cross(b.sub(u));
            let new_squared = new.dot(new);
            let change = fan::FanChange {
                old_length: old.dot(old).sqrt(),
                new_length: new_squared.sqrt(),
                new_on_old: new.dot(old),
                new_on_mean: new.dot(Vec3x8::splat(self.mean_normal)),
                old_on_mean: old.dot(Vec3x8::splat(self.mean_normal)),
                old_edges: aa + bb + (aa + bb - ab - ab),
                new_edges: (aa + uu - ua - ua) + (bb + uu - ub - ub) + (aa + bb - ab - ab),
            };
            let fan::LaneVerdict { is_allowed, may_turn } = change.verdict(star);
            if !(is_allowed | vanishes).all() || self.any_turns_over(t, may_turn & !vanishes, to) {
                return None;
            }
            // The origin against the triangle (u, a, b); u dot the old normal is the height for all of them.
            let triangle = fan::Products {
                d: [uu - ua, uu - ub, ua - aa, ua - ab, ub - ab, ub - bb],
                corners: [uu, aa, bb],
                height: u.dot(old),
                normal_squared: new_squared,
            };
            let distance_squared =
                vanishes.bitselect(f32x8::splat(f32::INFINITY), triangle.distance_squared());
            least = least.fast_min(distance_squared);
        }
        Some(lane_min(least))
    }

    /// Whether one of the masked triangles from `first` on turns over within a flat surface if the center
    /// moves to `to`.
    fn any_turns_over(&self, first: usize, mask: f32x8, to: Vec3) -> bool {
        let lanes = mask.to_bitmask();
        (0..LANES).filter(|lane| lanes >> lane & 1 != 0).any(|lane| self.turns_over(first + lane, to))
    }

    /// Whether triangle `t` turns over within a flat surface if the center moves to `to`.
    #[cold]
    fn turns_over(&self, t: usize, to: Vec3) -> bool {
        let [a, b] = self.ring.triangle(t).map(|i| self.offset(i).as_dvec3());
        let to = to.as_dvec3();
        let others = (0..self.ring.triangle_count()).filter(|&other| other != t).map(|other| {
            let [a, b] = self.ring.triangle(other).map(|i| self.offset(i).as_dvec3());
            TriangleNormal::new([DVec3::ZERO, a, b])
        });
        turns_over(TriangleNormal::new([DVec3::ZERO, a, b]), TriangleNormal::new([to, a, b]), others)
    }

    /// Squared distance of the point `p` from the fan of the last [`Self::mark_vanishing`], with
    /// neighbor `k` as the target; infinite if no triangle is left.
    pub(in crate::simplify) fn fan_distance_squared_of(&self, k: usize, p: Vec3) -> f32 {
        let [a, b] = self.corners();
        let (u, p) = (Vec3x8::splat(self.offset(k)), Vec3x8::splat(p));
        let mut least = f32x8::splat(f32::INFINITY);
        for t in vector_starts(self.ring.triangle_count()) {
            let (a, b) = (Vec3x8::load(a, t), Vec3x8::load(b, t));
            let vanishes = load_lanes(&self.vanishes, t).simd_gt(f32x8::ZERO);
            let (ua, ub, up, ap, bp) = (a.sub(u), b.sub(u), p.sub(u), p.sub(a), p.sub(b));
            let normal = ua.cross(ub);
            let triangle = fan::Products {
                d: [ua.dot(up), ub.dot(up), ua.dot(ap), ub.dot(ap), ua.dot(bp), ub.dot(bp)],
                corners: [up.dot(up), ap.dot(ap), bp.dot(bp)],
                height: normal.dot(up),
                normal_squared: normal.dot(normal),
            };
            let squared = vanishes.bitselect(f32x8::splat(f32::INFINITY), triangle.distance_squared());
            least = least.fast_min(squared);
        }
        lane_min(least)
    }

    /// Marks the triangles that a collapse to neighbor `k` removes.
    pub(in crate::simplify) fn mark_vanishing(&mut self, k: Option<usize>) {
        let padded = self.ring.triangle_count().next_multiple_of(LANES);
        ensure_len(&mut self.vanishes, padded);
        let mut vanishes = std::mem::take(&mut self.vanishes);
        let (real, rest) = vanishes[..padded].split_at_mut(self.ring.triangle_count());
        real.fill(0.0);
        rest.fill(NO_TRIANGLE);
        if let Some(k) = k {
            self.ring.visit_triangles_at(k, |t| real[t] = 1.0);
        }
        self.vanishes = vanishes;
    }

    /// Largest squared distance of the new edges' midpoints from the old star: how far the fan sticks out.
    ///
    /// The distance of `v` alone does not detect a fan that bridges a valley.
    pub(in crate::simplify) fn protrusion_squared(&mut self, k: usize) -> f32 {
        // A ring of three gets no new edge; non-manifold stars can get one with fewer triangles.
        if self.ring.pairs().is_none() && self.ring.triangle_count() < 4 {
            return 0.0;
        }
        let mut middles = std::mem::take(&mut self.middles);
        let u = self.offset(k);
        middles.clear();
        for i in 0..self.ring.ids.len() {
            if i != k && !self.ring.is_edge(i, k) {
                middles.push((0.5 * (self.offset(i) + u), f32x8::splat(f32::INFINITY)));
            }
        }
        let [a, b] = self.corners();
        let normals = slices(&self.normals, 0);
        for t in vector_starts(self.ring.triangle_count()) {
            let (a, b) = (Vec3x8::load(a, t), Vec3x8::load(b, t));
            let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
            let normal = Vec3x8::load(normals, t);
            let normal_squared = normal.dot(normal);
            let is_none = load_lanes(&self.vanishes, t).simd_gt(f32x8::ONE);
            for (middle, least) in &mut middles {
                // The midpoint against the triangle (v, a, b), with v at the origin.
                let mm = f32x8::splat(middle.length_squared());
                let middle = Vec3x8::splat(*middle);
                let (ma, mb) = (middle.dot(a), middle.dot(b));
                let triangle = fan::Products {
                    d: [ma, mb, ma - aa, mb - ab, ma - ab, mb - bb],
                    corners: [mm, mm - ma - ma + aa, mm - mb - mb + bb],
                    height: middle.dot(normal),
                    normal_squared,
                };
                *least = least
                    .fast_min(is_none.bitselect(f32x8::splat(f32::INFINITY), triangle.distance_squared()));
            }
        }
        let worst = middles.iter().map(|(_, least)| lane_min(*least));
        let worst = worst.fold(0.0, f32::max);
        self.middles = middles;
        worst
    }
}
