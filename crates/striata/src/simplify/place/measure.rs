//! Measures the error of a finished level: the distance between it and the original mesh, both ways.
//!
//! All vertices are measured, then the centroids of all triangles. No point of a triangle is farther
//! away than the distance of its centroid plus its radius; if that exceeds the largest distance so far,
//! the triangle is split into four, recursively, within a budget of about twice as many points as
//! original triangles.

use glam::DVec3;

use crate::mesh::{IndexedMesh, TriangleTree};

/// Maximum depth of recursive splits of a triangle.
const MAX_CUTS: u32 = 5;
/// Minimum number of points that may be measured.
const MIN_BUDGET: usize = 60_000;

/// Search for the point of one surface that is farthest from another.
struct FarthestPointSearch {
    tree: TriangleTree,
    /// The triangle that was nearest to the last point.
    hint: usize,
    worst: f64,
}

impl FarthestPointSearch {
    /// Measures a point; returns whether everything within `radius` of it is no farther than the worst
    /// point so far.
    fn visit(&mut self, point: DVec3, radius: f64) -> bool {
        let distance =
            self.tree.distance_within(point.to_array(), (self.worst - radius).max(0.0), &mut self.hint);
        if distance.is_finite() {
            self.worst = self.worst.max(distance);
        }
        distance + radius <= self.worst
    }

    /// Measures a triangle, and its parts if necessary.
    fn visit_triangle(&mut self, [a, b, c]: [DVec3; 3], cuts: u32) {
        let middle = (a + b + c) / 3.0;
        let radius = [a, b, c].iter().map(|corner| corner.distance(middle)).fold(0.0, f64::max);
        if self.visit(middle, radius) || cuts == 0 {
            return;
        }
        let [x, y, z] = [0.5 * (b + c), 0.5 * (c + a), 0.5 * (a + b)];
        for part in [[a, z, y], [z, b, x], [y, x, c], [x, y, z]] {
            self.visit_triangle(part, cuts - 1);
        }
    }
}

/// Returns the largest distance from points of `from` to `to`, or `worst` if that is larger.
fn one_sided_distance(from: &IndexedMesh, to: &IndexedMesh, budget: usize, worst: f64) -> f64 {
    let Ok(tree) = TriangleTree::new(to) else { return worst };
    let mut search = FarthestPointSearch { tree, hint: 0, worst };
    let position = |v: u32| DVec3::from(from.positions[v as usize].map(f64::from));
    for v in 0..from.vertex_count() as u32 {
        search.visit(position(v), 0.0);
    }
    let cuts = (budget / from.triangle_count().max(1)).checked_ilog(4).unwrap_or(0).min(MAX_CUTS);
    for t in &from.triangles {
        search.visit_triangle(t.map(position), cuts);
    }
    search.worst
}

/// Returns the largest distance from points of either mesh to the other, in mesh units. The meshes must
/// not have unused vertices.
pub(super) fn measured_error(original: &IndexedMesh, level: &IndexedMesh) -> f64 {
    let budget = MIN_BUDGET.max(2 * original.triangle_count());
    let outward = one_sided_distance(level, original, budget, 0.0);
    one_sided_distance(original, level, budget, outward)
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
                let found = measured_error(from, to);
                assert!(found <= expected && found >= 0.95 * expected, "{found} but {expected}");
            }
        }
    }
}
