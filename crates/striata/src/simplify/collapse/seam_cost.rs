//! Attribute cost of wedges that cross a seam, without the other attribute costs.

use super::cost_evaluator::CostEvaluator;

/// Mean square over a triangle of the linear function that is 1 at one corner and 0 at the others.
const CORNER_SHARE: f32 = 1.0 / 6.0;

impl CostEvaluator<'_> {
    /// Cost of the gathered star's wedges that cross a seam to wedges of neighbor `k`. The wedges must
    /// be paired.
    pub(in crate::simplify) fn crossing_cost(&self, k: usize) -> f32 {
        let Self { star, wedges: Some(wedges), attributes: Some(attributes), .. } = self else { return 0.0 };
        let mut cost = 0.0;
        for t in 0..star.ring.triangle_count() {
            let [i, j] = star.ring.triangle(t);
            let wedge = star.center_wedges[t];
            if i != k && j != k && wedges.crosses(wedge) {
                let (u, a, b) = (star.offset(k), star.offset(i), star.offset(j));
                let areas = [a.cross(b), (a - u).cross(b - u)].map(|normal| 0.5 * normal.length());
                let squared = attributes.crossing_squared(wedge, wedges.paired(wedge, star.ring.ids[k]));
                cost += areas[0].max(areas[1]) * squared;
            }
        }
        CORNER_SHARE * cost
    }
}
