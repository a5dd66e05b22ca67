//! Accumulated quadrics [GH97]: every position sums the planes of all triangles that were merged into it.

use glam::DVec3;

use super::collapse_cost::{CollapseCost, CostRules, LOCAL};
use crate::simplify::collapse::fan::point;
use crate::simplify::collapse::links::Links;
use crate::simplify::collapse::star::Star;

/// The quadric of each position.
#[derive(Debug, Default)]
pub(super) struct Accumulated {
    quadrics: Vec<Quadric>,
}

impl CollapseCost for Accumulated {
    fn rules(&self) -> CostRules {
        // The quadrics are the full cost.
        CostRules { counts_fan: false, bound_factor: 1.0, is_local: false, target_grows: true, ..LOCAL }
    }

    fn begin(&mut self, star: &mut Star, links: &Links, positions: &[[f32; 4]], _triangle_count: usize) {
        let quadric = |v: u32| {
            star.gather(links, positions, v);
            let center = point(positions, v).as_dvec3();
            let mut sum = Quadric::default();
            for t in 0..star.ring.triangle_count() {
                let [a, b] = star.ring.triangle(t).map(|i| center + star.offset(i).as_dvec3());
                sum.add(&Quadric::of_triangle([center, a, b]));
            }
            sum
        };
        self.quadrics = (0..positions.len() as u32).map(quadric).collect();
    }

    fn fill(&self, star: &mut Star, positions: &[[f32; 4]], v: u32) {
        for (cost, &u) in star.costs.iter_mut().zip(&star.ring.ids) {
            *cost = self.cost(positions, v, u);
        }
    }

    fn contraction(&self, _star: &Star, positions: &[[f32; 4]], [v, u]: [u32; 2], _squared: f32) -> f32 {
        self.cost(positions, v, u)
    }

    fn merge(&mut self, v: u32, u: u32) {
        let own = self.quadrics[v as usize];
        self.quadrics[u as usize].add(&own);
    }
}

impl Accumulated {
    fn cost(&self, positions: &[[f32; 4]], v: u32, u: u32) -> f32 {
        let at: DVec3 = point(positions, u).as_dvec3();
        (self.quadrics[v as usize].at(at) + self.quadrics[u as usize].at(at)) as f32
    }
}

/// Sum of squared, area-weighted distances from planes, as a quadratic function of a point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Quadric {
    /// Quadratic part: xx, yy, zz, xy, xz, yz.
    a: [f64; 6],
    /// Linear part, halved.
    b: DVec3,
    /// Constant part.
    c: f64,
}

impl Quadric {
    /// Quadric of one triangle: the squared distance from its plane, times its area.
    fn of_triangle([p, q, r]: [DVec3; 3]) -> Self {
        let normal = (q - p).cross(r - p);
        let length = normal.length();
        if length == 0.0 {
            return Self::default();
        }
        // The area is half the length, and the squared length normalizes the normal in both factors.
        let scale = 0.5 / length;
        let d = -normal.dot(p);
        let DVec3 { x, y, z } = normal;
        Self {
            a: [x * x, y * y, z * z, x * y, x * z, y * z].map(|term| scale * term),
            b: scale * d * normal,
            c: scale * d * d,
        }
    }

    fn add(&mut self, other: &Self) {
        for (x, y) in self.a.iter_mut().zip(other.a) {
            *x += y;
        }
        self.b += other.b;
        self.c += other.c;
    }

    /// Value at a point, clamped to 0 against rounding.
    fn at(&self, p: DVec3) -> f64 {
        let [xx, yy, zz, xy, xz, yz] = self.a;
        let DVec3 { x, y, z } = p;
        let quadratic = xx * x * x + yy * y * y + zz * z * z + 2.0 * (xy * x * y + xz * x * z + yz * y * z);
        (quadratic + 2.0 * self.b.dot(p) + self.c).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn value_is_area_times_squared_distance() {
        let q = Quadric::of_triangle([DVec3::ZERO, DVec3::X * 2.0, DVec3::Y * 3.0]);
        assert!((q.at(DVec3::new(5.0, -7.0, 2.0)) - 12.0).abs() < 1e-12);
        let mut twice = q;
        twice.add(&q);
        assert!((twice.at(DVec3::Z) - 6.0).abs() < 1e-12);
    }
}
