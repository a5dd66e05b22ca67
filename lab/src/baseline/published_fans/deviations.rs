//! How far the surface is from the original while a vertex is simplified: across the surface and along it.
//!
//! As in \[Hop97\], points of the original surface follow its simplification: each belongs to the triangle that is
//! nearest to it. The points are the vertices. When a vertex is simplified, its own point and those of its triangles
//! are projected to the triangles that fill the hole, which gives a vector for each.

use glam::DVec3;
use striata::mesh::{FragmentSequence, FragmentedMesh, RefinableMesh};

/// Bounds of the error vectors of a step, relative to the normal of its vertex.
///
/// Seen from a direction `v`, no vector is longer than the larger one of `surface` and `dist |n x v|`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Deviation {
    /// In any direction.
    pub surface: f32,
    /// In the direction of the normal.
    pub dist: f32,
}

/// Computes the deviation of each step; `normals` are those of the vertices.
pub(super) fn of_steps(refinable: &RefinableMesh, normals: &[[f32; 3]]) -> Vec<Deviation> {
    let FragmentedMesh { mesh, fragments } = &FragmentedMesh::from_collapses(refinable);
    let point = |v: u32| DVec3::from(mesh.positions[v as usize].map(f64::from));
    let corners = |face: u32| fragments.faces()[face as usize].corners.map(point);
    let mut points: Vec<Vec<u32>> = vec![Vec::new(); fragments.faces().len()];
    let mut deviations = vec![Deviation::default(); fragments.step_count()];
    for step in (0..fragments.step_count() as u32).rev() {
        let vertex = fragments.levels().step_vertices(step as usize).start;
        let mut moved = vec![vertex];
        fragments.ceiling(step).for_each(|face| moved.append(&mut points[face as usize]));
        let vectors = moved.iter().filter_map(|&moved| {
            let (face, to) = nearest(fragments, step, point(moved), corners)?;
            points[face as usize].push(moved);
            Some(to - point(moved))
        });
        let vectors: Vec<DVec3> = vectors.collect();
        let normal = DVec3::from(normals[vertex as usize].map(f64::from));
        deviations[step as usize] = Deviation::of(&vectors, normal);
    }
    deviations
}

/// The face of a step's floor that is nearest to a point, and its nearest point.
fn nearest(
    fragments: &FragmentSequence,
    step: u32,
    point: DVec3,
    corners: impl Fn(u32) -> [DVec3; 3],
) -> Option<(u32, DVec3)> {
    let candidates = fragments.floor(step).iter().map(|&face| (face, nearest_point(corners(face), point)));
    candidates.min_by(|a, b| a.1.distance_squared(point).total_cmp(&b.1.distance_squared(point)))
}

impl Deviation {
    /// Bounds vectors; their extents fix the ratio of the two scalars, as in \[Hop97\].
    pub(super) fn of(vectors: &[DVec3], normal: DVec3) -> Self {
        let parts = || {
            vectors.iter().map(|vector| {
                let across = vector.dot(normal);
                (across.abs(), (*vector - normal * across).length())
            })
        };
        let (across, along) =
            parts().fold((0.0f64, 0.0f64), |all, part| (all.0.max(part.0), all.1.max(part.1)));
        if across <= along * 1e-6 {
            let length = vectors.iter().map(|vector| vector.length()).fold(0.0, f64::max);
            return Self { surface: up(length), dist: 0.0 };
        }
        // At a point at which both bounds are equal, they have to cover the sum of both parts.
        let ratio = across / along.max(across * 1e-6);
        let surface = parts().map(|(across, along)| along + across / ratio).fold(0.0, f64::max);
        Self { surface: up(surface), dist: up(surface * ratio) }
    }
}

/// Rounds up to a float.
fn up(number: f64) -> f32 {
    (number as f32).next_up()
}

/// The point of a triangle that is nearest to a point.
fn nearest_point([a, b, c]: [DVec3; 3], point: DVec3) -> DVec3 {
    let on_edge = |p: DVec3, q: DVec3| {
        let edge = q - p;
        let along = (point - p).dot(edge) / edge.length_squared().max(f64::MIN_POSITIVE);
        p + edge * along.clamp(0.0, 1.0)
    };
    let normal = (b - a).cross(c - a);
    let is_inside = |p: DVec3, q: DVec3| (q - p).cross(point - p).dot(normal) >= 0.0;
    if normal.length_squared() > 0.0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a) {
        return point - normal * ((point - a).dot(normal) / normal.length_squared());
    }
    let edges = [on_edge(a, b), on_edge(b, c), on_edge(c, a)];
    let nearer = |p: &DVec3, q: &DVec3| p.distance_squared(point).total_cmp(&q.distance_squared(point));
    edges.into_iter().min_by(nearer).unwrap_or(a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use striata::mesh::Random;

    #[test]
    fn no_vector_looks_longer_than_its_bound() {
        let mut random = Random::new(5);
        let mut vector = |z: f64| {
            let [x, y, w] = [(); 3].map(|()| random.unit() - 0.5);
            DVec3::new(x, y, z * w)
        };
        for round in 0..300 {
            let normal = vector(1.0).normalize();
            let flat = [1.0, 0.05, 20.0, 0.0][round % 4];
            let vectors: Vec<DVec3> = (0..5).map(|_| vector(flat)).collect();
            let Deviation { surface, dist } = Deviation::of(&vectors, normal);
            for _ in 0..100 {
                let view = vector(1.0).normalize();
                let bound = f64::from(surface).max(f64::from(dist) * normal.cross(view).length());
                for vector in &vectors {
                    let seen = vector.cross(view).length();
                    assert!(seen <= bound * 1.000001, "{vector} is seen as {seen}, not {bound}");
                }
            }
        }
    }

    #[test]
    fn nearest_points_are_on_the_triangle() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y];
        assert_eq!(nearest_point(corners, DVec3::new(0.2, 0.3, 4.0)), DVec3::new(0.2, 0.3, 0.0));
        assert_eq!(nearest_point(corners, DVec3::new(-1.0, -1.0, 2.0)), DVec3::ZERO);
        assert_eq!(nearest_point(corners, DVec3::new(1.0, 1.0, 0.0)), DVec3::new(0.5, 0.5, 0.0));
        assert_eq!(nearest_point([DVec3::X; 3], DVec3::ZERO), DVec3::X);
    }
}
