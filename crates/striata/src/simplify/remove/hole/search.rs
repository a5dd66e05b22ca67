//! Finds the best of all triangulations of a hole.
//!
//! Ranges `i..=j` of the ring are triangulated optimally, short ones before long ones (dynamic
//! programming over intervals):
//!
//! ```text
//!            k
//!          /   \          best(i, j) = least over k of  best(i, k) + best(k, j) + cost of triangle (i, k, j)
//!    ...  /     \  ...                 + cost of the new edge (i, j)
//!        i ----- j
//! ```
//!
//! The result is exact if costs add up over triangles and new edges. Distances do: each tracked vertex lies
//! over one triangle, and old and new surface are farthest apart where new edges cross the old spokes. For
//! the smallest largest distance, the larger cost counts instead of the sum.
//!
//! Time O(n^3) for a ring of n; each triangle is evaluated once.

use super::{Hole, HoleCost, RingTriangle, edges_squared, quality};
use crate::simplify::collapse::costs::TrackedVertex;
use crate::simplify::remove::removal_options::HoleCriterion;

impl HoleCost {
    const INFINITE: Self = Self { largest: f32::INFINITY, sum: f32::INFINITY };

    fn of_sum(sum: f32) -> Self {
        Self { largest: 0.0, sum }
    }

    fn and(self, other: Self) -> Self {
        Self { largest: self.largest.max(other.largest), sum: self.sum + other.sum }
    }

    fn and_sum(self, sum: f32) -> Self {
        Self { sum: self.sum + sum, ..self }
    }
}

/// Cost of a squared gap under a new edge, per area of the star.
const GAP_WEIGHT: f32 = 0.2;

impl Hole {
    /// Finds the best triangulation and stores it in `floor`; returns false if there is none.
    pub(in crate::simplify::remove) fn triangulate(
        &mut self,
        points: &[TrackedVertex],
        criterion: HoleCriterion,
        floor: &mut Vec<RingTriangle>,
    ) -> bool {
        floor.clear();
        self.compute_sides(points);
        let n = self.n;
        for i in 0..n - 1 {
            self.best[i][i + 1] = HoleCost::default();
        }
        for span in 2..n {
            for i in 0..n - span {
                self.best[i][i + span] = self.best_between(i, i + span, points, criterion);
            }
        }
        let is_found = self.best[0][n - 1].sum < f32::INFINITY;
        if is_found {
            self.collect(0, n - 1, floor);
        }
        is_found
    }

    fn best_between(
        &mut self,
        i: usize,
        j: usize,
        points: &[TrackedVertex],
        criterion: HoleCriterion,
    ) -> HoleCost {
        if self.allowed[i] & 1 << j == 0 {
            return HoleCost::INFINITE;
        }
        let mut least = HoleCost::INFINITE;
        for k in i + 1..j {
            let parts = self.best[i][k].and(self.best[k][j]);
            // No triangle has a negative cost.
            if parts < least {
                let cost = parts.and(self.triangle_cost([i, k, j], points, criterion));
                if cost < least {
                    least = cost;
                    self.apex[i][j] = k as u8;
                }
            }
        }
        match criterion {
            HoleCriterion::Distance | HoleCriterion::Maximum => least.and_sum(self.edge_cost(i, j)),
            HoleCriterion::Flatness | HoleCriterion::Shape => least,
        }
    }

    fn edge_cost(&self, i: usize, j: usize) -> f32 {
        GAP_WEIGHT * self.area * self.gap_squared[i.min(j)][i.max(j)]
    }

    /// Cost of a triangle; infinite if it is not allowed.
    fn triangle_cost(
        &self,
        corners: [usize; 3],
        points: &[TrackedVertex],
        criterion: HoleCriterion,
    ) -> HoleCost {
        let Some(normal) = self.valid_normal(corners) else { return HoleCost::INFINITE };
        match criterion {
            HoleCriterion::Distance | HoleCriterion::Maximum => {
                let level = normal.dot(self.ring[corners[0]]);
                let (mut sum, mut largest) = (0.0, 0.0f32);
                self.for_each_point_over(corners, points, |point| {
                    let height = normal.dot(point.at) - level;
                    sum += point.weight * height * height;
                    largest = largest.max(height * height);
                });
                let squared = normal.length_squared();
                let largest = if criterion == HoleCriterion::Maximum { largest / squared } else { 0.0 };
                HoleCost { largest, sum: sum / squared }
            }
            HoleCriterion::Flatness => {
                // The area that turns away.
                let facing = self.facing_of(corners).normalize_or_zero();
                HoleCost::of_sum((0.5 * (normal.length() - normal.dot(facing))).max(0.0))
            }
            HoleCriterion::Shape => {
                let edges = edges_squared(corners.map(|i| self.ring[i]));
                HoleCost::of_sum((1.0 / quality(normal.length(), edges) - 1.0).max(0.0))
            }
        }
    }

    fn collect(&self, i: usize, j: usize, floor: &mut Vec<RingTriangle>) {
        if j < i + 2 {
            return;
        }
        let k = usize::from(self.apex[i][j]);
        floor.push([i, k, j].map(|x| x as u8));
        self.collect(i, k, floor);
        self.collect(k, j, floor);
    }

    /// Finds the best fan, as a half-edge collapse leaves it, and stores it in `floor`; returns the
    /// member of the ring at its center.
    pub(in crate::simplify::remove) fn best_fan(
        &mut self,
        points: &[TrackedVertex],
        floor: &mut Vec<RingTriangle>,
    ) -> Option<usize> {
        self.compute_sides(points);
        let n = self.n;
        // On a boundary, only along it.
        let apexes = (0..n).step_by(if self.is_closed { 1 } else { n - 1 });
        let cost = |apex: usize| {
            let others = (0..n).filter(|&i| i != apex);
            if others.clone().any(|i| self.allowed[apex] & 1 << i == 0) {
                return f32::INFINITY;
            }
            let triangles = fan(n, apex).map(|t| self.triangle_cost(t, points, HoleCriterion::Distance).sum);
            triangles.sum::<f32>() + others.map(|i| self.edge_cost(apex, i)).sum::<f32>()
        };
        let best = apexes.map(|apex| (cost(apex), apex)).min_by(|a, b| a.0.total_cmp(&b.0));
        let (_, apex) = best.filter(|(cost, _)| *cost < f32::INFINITY)?;
        floor.clear();
        floor.extend(fan(n, apex).map(|triangle| triangle.map(|i| i as u8)));
        Some(apex)
    }
}

/// Returns the triangles of the fan around one member of a ring of `n`, corners in ascending order.
fn fan(n: usize, apex: usize) -> impl Iterator<Item = [usize; 3]> {
    (1..n - 1).map(move |step| {
        let mut triangle = [apex, (apex + step) % n, (apex + step + 1) % n];
        triangle.sort_unstable();
        triangle
    })
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::mesh::Random;

    /// A ring around the origin, not flat, and points over it.
    fn random_hole(n: usize, random: &mut Random) -> (Hole, Vec<TrackedVertex>) {
        let mut hole = Hole::default();
        let ring: Vec<Vec3> = (0..n)
            .map(|i| {
                let angle = (i as f32 + random.between(-0.3, 0.3)) / n as f32 * std::f32::consts::TAU;
                let radius = random.between(0.7, 1.3);
                Vec3::new(radius * angle.cos(), radius * angle.sin(), random.between(-0.3, 0.3))
            })
            .collect();
        hole.load(ring.into_iter(), true);
        let mut point = |position| TrackedVertex {
            position,
            at: Vec3::from([(); 3].map(|()| random.between(-0.4, 0.4))),
            weight: random.between(0.1, 1.0),
            before: 0.0,
        };
        (hole, (0..70).map(&mut point).collect())
    }

    /// Least cost of all triangulations between `i` and `j`, by exhaustive search.
    fn least_of_all(
        hole: &Hole,
        i: usize,
        j: usize,
        points: &[TrackedVertex],
        criterion: HoleCriterion,
    ) -> HoleCost {
        if j < i + 2 {
            return HoleCost::default();
        }
        let has_edges = matches!(criterion, HoleCriterion::Distance | HoleCriterion::Maximum);
        let edge = if has_edges { hole.edge_cost(i, j) } else { 0.0 };
        let at = |k: usize| {
            least_of_all(hole, i, k, points, criterion)
                .and(least_of_all(hole, k, j, points, criterion))
                .and(hole.triangle_cost([i, k, j], points, criterion))
                .and_sum(edge)
        };
        (i + 1..j).map(at).fold(HoleCost::INFINITE, |least, cost| if cost < least { cost } else { least })
    }

    #[test]
    fn triangulation_cost_matches_exhaustive_search() {
        let mut random = Random::new(5);
        let mut found_count = 0;
        for case in 0..200 {
            let n = 3 + case % 6;
            let (mut hole, points) = random_hole(n, &mut random);
            let criterion = [
                HoleCriterion::Distance,
                HoleCriterion::Flatness,
                HoleCriterion::Shape,
                HoleCriterion::Maximum,
            ][case % 4];
            let mut floor = Vec::new();
            let is_found = hole.triangulate(&points, criterion, &mut floor);
            let least = least_of_all(&hole, 0, n - 1, &points, criterion);
            assert_eq!(is_found, least.sum < f32::INFINITY);
            if is_found {
                found_count += 1;
                assert_eq!(floor.len(), n - 2);
                let found = hole.best[0][n - 1];
                // For the largest distance, the sum only decides among equal parts.
                let pair = match criterion {
                    HoleCriterion::Maximum => (found.largest, least.largest),
                    _ => (found.sum, least.sum),
                };
                assert!((pair.0 - pair.1).abs() <= 1e-4 * pair.1.max(1e-3), "{found:?} {least:?}");
            }
        }
        assert!(found_count > 100, "{found_count}");
    }

    #[test]
    fn each_point_is_over_one_triangle() {
        let mut random = Random::new(9);
        for case in 0..100 {
            let (mut hole, points) = random_hole(4 + case % 6, &mut random);
            let mut floor = Vec::new();
            if !hole.triangulate(&points, HoleCriterion::Distance, &mut floor) {
                continue;
            }
            let mut counts = vec![0; points.len()];
            for triangle in &floor {
                hole.for_each_point_over(triangle.map(usize::from), &points, |p| {
                    counts[p.position as usize] += 1
                });
            }
            // Far from the ring, the directions of different diagonals may disagree.
            let once = counts.iter().filter(|&&count| count == 1).count();
            assert!(once * 20 >= 19 * counts.len(), "{counts:?}");
        }
    }

    #[test]
    fn kept_edge_is_in_every_triangulation() {
        let mut random = Random::new(3);
        for _ in 0..50 {
            let (mut hole, points) = random_hole(8, &mut random);
            hole.keep_edge(6, 1);
            let mut floor = Vec::new();
            if hole.triangulate(&points, HoleCriterion::Shape, &mut floor) {
                assert!(floor.iter().any(|t| t.contains(&1) && t.contains(&6)), "{floor:?}");
            }
        }
    }

    #[test]
    fn a_valley_is_not_bridged() {
        // Four neighbors, two of them low: the new edge must be low, where the removed vertex was.
        let ring = [[1., 0., 0.], [0., 1., 1.], [-1., 0., 0.], [0., -1., 1.]].map(Vec3::from);
        let mut hole = Hole::default();
        hole.load(ring.into_iter(), true);
        let own = TrackedVertex { position: 0, at: Vec3::ZERO, weight: 1.0, before: 0.0 };
        let mut floor = Vec::new();
        assert!(hole.triangulate(&[own], HoleCriterion::Distance, &mut floor));
        assert_eq!(hole.diagonals(&floor).collect::<Vec<_>>(), [(0, 2)]);
        assert_eq!(hole.best_fan(&[own], &mut floor), Some(0));
    }
}
