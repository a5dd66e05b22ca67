//! Measures the error of a finished level: the distance between it and the original mesh, both ways.
//!
//! A triangle whose corners are all near one triangle of the other surface has no farther point, since the
//! distance from a convex set is convex. Otherwise its corners and its centroid are measured. No point of a
//! triangle is farther away than the distance of its centroid plus its radius; if that exceeds the largest
//! distance so far, the triangle is split into four, recursively, within a budget of about half as many points
//! as original triangles.

use glam::DVec3;

use super::pairs::Pair;
use super::surface::FitSurface;
use crate::mesh::TriangleTree;
use crate::parallel;

/// Maximum depth of recursive splits of a triangle.
const MAX_CUTS: u32 = 5;
/// Minimum number of points that may be measured.
const MIN_BUDGET: usize = 20_000;
/// Number of triangles that are measured by one thread.
const CHUNK: usize = 1 << 13;
/// Number of pairs, the farthest ones, that give a first estimate.
const GUESSES: usize = 64;

/// Search for the point of one surface that is farthest from another.
struct FarthestPointSearch<'a> {
    tree: &'a TriangleTree,
    /// The triangle that was nearest to the last point.
    hint: usize,
    worst: f64,
}

impl FarthestPointSearch<'_> {
    /// Measures a point; returns whether everything within `radius` of it is no farther than the worst
    /// point so far.
    fn visit(&mut self, point: DVec3, radius: f64) -> bool {
        // If the radius is too large to show that, the point itself must still not be farther.
        let enough = if radius < self.worst { self.worst - radius } else { self.worst };
        let distance = self.tree.distance_within(point.to_array(), enough, &mut self.hint);
        if distance.is_finite() {
            self.worst = self.worst.max(distance);
        }
        distance + radius <= self.worst
    }

    /// Whether the hint alone shows that no point of a triangle is farther than the worst point so far.
    fn is_covered(&self, corners: &[DVec3; 3]) -> bool {
        self.tree.is_within(self.hint, corners, self.worst)
    }

    /// Measures a triangle, whose corners have been measured, and its parts if necessary.
    fn visit_triangle(&mut self, corners: [DVec3; 3], cuts: u32) {
        let [a, b, c] = corners;
        let middle = (a + b + c) / 3.0;
        let radius = if cuts == 0 {
            0.0
        } else {
            corners.map(|corner| corner.distance(middle)).into_iter().fold(0.0, f64::max)
        };
        if self.visit(middle, radius) || cuts == 0 || self.is_covered(&corners) {
            return;
        }
        let [x, y, z] = [0.5 * (b + c), 0.5 * (c + a), 0.5 * (a + b)];
        for part in [[a, z, y], [z, b, x], [y, x, c], [x, y, z]] {
            self.visit_triangle(part, cuts - 1);
        }
    }
}

/// Returns the largest distance from points of `from` to `to`, or `worst` if that is larger.
/// `near` gives triangles of `to` near those of `from`, as far as they are known.
fn one_sided_distance(from: &FitSurface, to: &FitSurface, near: &[u32], budget: usize, worst: f64) -> f64 {
    let count = from.corners.len();
    let cuts = (budget / count.max(1)).checked_ilog(4).unwrap_or(0).min(MAX_CUTS);
    // Each vertex is measured with the first triangle that has it.
    let mut first_triangle = vec![u32::MAX; from.vertex_count];
    for (index, triangle) in (0..).zip(&from.triangles) {
        triangle.iter().for_each(|&v| first_triangle[v as usize] = first_triangle[v as usize].min(index));
    }
    let of_chunk = |chunk: usize| {
        let mut search = FarthestPointSearch { tree: &to.tree, hint: 0, worst };
        for (t, &near) in near.iter().enumerate().skip(chunk * CHUNK).take(CHUNK) {
            if near != u32::MAX {
                search.hint = near as usize;
            }
            let corners = from.corners[t];
            if search.is_covered(&corners) {
                continue;
            }
            for (corner, &v) in corners.into_iter().zip(&from.triangles[t]) {
                if first_triangle[v as usize] as usize == t {
                    search.visit(corner, 0.0);
                }
            }
            search.visit_triangle(corners, cuts);
        }
        search.worst
    };
    parallel::map(0..count.div_ceil(CHUNK), of_chunk).into_iter().fold(worst, f64::max)
}

/// Returns the largest distance from points of either surface to the other, in mesh units, given pairs of points
/// of both.
pub(super) fn measured_error(original: &FitSurface, level: &FitSurface, pairs: &[Pair]) -> f64 {
    let budget = MIN_BUDGET.max(original.corners.len() / 2);
    let mut guesses: Vec<(f64, DVec3, DVec3)> = pairs
        .iter()
        .map(|pair| (level.at(pair.level), pair.target))
        .map(|(own, target)| (own.distance_squared(target), own, target))
        .collect();
    if guesses.len() > GUESSES {
        guesses.select_nth_unstable_by(GUESSES, |a, b| b.0.total_cmp(&a.0));
        guesses.truncate(GUESSES);
    }
    // Pairs face the same side, so a distance may be less than that of a pair.
    let outward = guesses.iter().map(|guess| original.tree.distance_to(guess.1.to_array()));
    let inward = guesses.iter().map(|guess| level.tree.distance_to(guess.2.to_array()));
    let worst = outward.chain(inward).fold(0.0, f64::max);
    let mut near_level = vec![u32::MAX; level.corners.len()];
    let mut near_original = vec![u32::MAX; original.corners.len()];
    for pair in pairs {
        near_level[pair.level.triangle as usize] = pair.original.triangle;
        near_original[pair.original.triangle as usize] = pair.level.triangle;
    }
    let (outward, inward) = parallel::join(
        || one_sided_distance(level, original, &near_level, budget, worst),
        || one_sided_distance(original, level, &near_original, budget, worst),
    );
    outward.max(inward)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shapes;

    #[test]
    fn the_farthest_point_is_found_on_either_side() {
        let large = shapes::grid(2, 2);
        let mut tent = large.clone();
        tent.positions[4][2] = 0.5;
        let mut part = large.clone();
        part.triangles.truncate(6);
        let part = part.without_unused_vertices();
        for (a, b, expected) in [(&large, &large, 0.0), (&tent, &large, 0.5), (&part, &large, 1.0)] {
            for (from, to) in [(a, b), (b, a)] {
                let [from, to] = [from, to].map(|mesh| FitSurface::new(mesh).expect("a valid mesh"));
                let found = measured_error(&from, &to, &[]);
                assert!(found <= expected && found >= 0.95 * expected, "{found} but {expected}");
            }
        }
    }
}
