//! Measures the error of a mesh on the screen: the distance in pixels between what should be visible and
//! what is shown.
//!
//! It samples points of the full mesh that are in the picture, on triangles that face the camera: the
//! vertices and the centers of these triangles. For each point, the distance to the nearest point shown is
//! converted to pixels at that depth, as if it were perpendicular to the line of sight. Occluded points
//! are included, which only makes the measure stricter; back faces may be arbitrarily coarse.

use striata::mesh::{IndexedMesh, MeshError, TriangleTree};

use super::paths::{PathFrame, cross, dot, minus};

/// Maximum number of points per frame; if there are more, every second or third is used, and so on.
const MAX_POINTS: usize = 40_000;

/// Errors of the sampled points, in pixels.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct ScreenErrors {
    pixels: Vec<f64>,
}

/// The sampled points of a view.
#[derive(Clone, Debug)]
pub(super) struct VisiblePoints {
    /// Points, each with the number of pixels per unit length there.
    points: Vec<([f64; 3], f64)>,
}

impl VisiblePoints {
    /// Samples the points of a frame.
    pub(super) fn new(mesh: &IndexedMesh, frame: &PathFrame) -> Self {
        let mut is_seen = vec![false; mesh.vertex_count()];
        let mut points = Vec::new();
        let mut add = |point: [f64; 3]| {
            if let Some(pixels) = frame.pixels_at(point) {
                points.push((point, pixels));
            }
        };
        for triangle in &mesh.triangles {
            let [a, b, c] = triangle.map(|v| mesh.positions[v as usize].map(f64::from));
            if dot(cross(minus(b, a), minus(c, a)), minus(frame.eye(), a)) <= 0.0 {
                continue;
            }
            for (&vertex, corner) in triangle.iter().zip([a, b, c]) {
                if !std::mem::replace(&mut is_seen[vertex as usize], true) {
                    add(corner);
                }
            }
            add([0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0));
        }
        let every = points.len().div_ceil(MAX_POINTS).max(1);
        Self { points: points.into_iter().step_by(every).collect() }
    }

    /// Measures the distance of these points from the triangles shown.
    ///
    /// # Errors
    /// If the triangles refer to missing vertices.
    pub(super) fn errors(
        &self,
        mesh: &IndexedMesh,
        triangles: &[[u32; 3]],
    ) -> Result<ScreenErrors, MeshError> {
        let shown = IndexedMesh::new(mesh.positions.clone(), triangles.to_vec());
        let tree = TriangleTree::new(&shown)?;
        let pixels = self.points.iter().map(|&(point, pixels)| pixels * tree.distance_to(point));
        Ok(ScreenErrors { pixels: pixels.collect() })
    }
}

impl ScreenErrors {
    /// Adds the errors of another view.
    pub(super) fn merge(&mut self, other: &Self) {
        self.pixels.extend_from_slice(&other.pixels);
    }

    /// The largest error, or `None` if there are no points.
    pub(super) fn max(&self) -> Option<f64> {
        self.pixels.iter().copied().reduce(f64::max)
    }

    /// The 99th percentile.
    pub(super) fn p99(&self) -> Option<f64> {
        let mut sorted = self.pixels.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        sorted.get((99 * sorted.len()).div_ceil(100).saturating_sub(1)).copied()
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::super::paths::Path;
    use super::*;

    #[test]
    fn errors_are_pixel_distances_of_front_facing_points() {
        let mesh = shapes::icosphere(3, 1.0);
        // Half a turn on, far enough away for the whole sphere to be in the picture.
        let frame = Path::Orbit.frames(&mesh)[180];
        let visible = VisiblePoints::new(&mesh, &frame);
        // From 3.8 radii away, 37 % of a sphere's surface is visible, here of 642 vertices and 1,280
        // triangles.
        assert!((620..=800).contains(&visible.points.len()), "{}", visible.points.len());
        for (point, _) in &visible.points {
            assert!(dot(*point, frame.eye()) > 0.5, "{point:?} is behind");
        }
        let none = visible.errors(&mesh, &mesh.triangles).unwrap();
        assert!(none.max().unwrap() < 1e-3, "{:?}", none.max());
        // Only one octant of the sphere: the rest is up to a diameter away.
        let part: Vec<[u32; 3]> = mesh
            .triangles
            .iter()
            .filter(|t| t.iter().all(|&v| mesh.positions[v as usize].iter().all(|&x| x >= 0.0)))
            .copied()
            .collect();
        let some = visible.errors(&mesh, &part).unwrap();
        let farthest = visible.points.iter().map(|(_, pixels)| 2.0 * pixels).fold(0.0, f64::max);
        assert!(some.max().unwrap() > 100.0 && some.max().unwrap() <= farthest);
        assert!(some.p99().unwrap() <= some.max().unwrap());
    }

    #[test]
    fn percentiles_are_counted_from_the_smallest_error() {
        let errors = ScreenErrors { pixels: (1..=200).rev().map(f64::from).collect() };
        assert_eq!((errors.max(), errors.p99()), (Some(200.0), Some(198.0)));
        assert_eq!(ScreenErrors { pixels: vec![3.0] }.p99(), Some(3.0));
        assert_eq!((ScreenErrors::default().max(), ScreenErrors::default().p99()), (None, None));
    }
}
