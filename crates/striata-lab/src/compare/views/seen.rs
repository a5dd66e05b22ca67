//! How far off a mesh is on the screen, measured: how many pixels lie between what should be seen and what is shown.
//!
//! Looked at are points of the full mesh that are in the picture, on triangles that face the eye: their vertices, and the
//! middles of the triangles. The distance of each to the nearest point that is shown is told in the pixels that it takes
//! there, across the sight. What hides behind other parts is looked at too, which only makes it stricter; what turns its
//! back may be as coarse as it likes.

use striata::mesh::{IndexedMesh, MeshError, TriangleTree};

use super::paths::{Frame, cross, dot, minus};

/// Points looked at in a frame, at most: then every second, every third, and so on.
const MAX_POINTS: usize = 40_000;

/// Pixels of points of one view.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct SeenErrors {
    pixels: Vec<f64>,
}

/// The points of a view that are looked at.
#[derive(Clone, Debug)]
pub(super) struct Watched {
    /// Points, and how many pixels a unit takes there.
    points: Vec<([f64; 3], f64)>,
}

impl Watched {
    /// Those of a frame.
    pub(super) fn new(mesh: &IndexedMesh, frame: &Frame) -> Self {
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

    /// How far these points are from what is shown.
    ///
    /// # Errors
    /// Where what is shown names vertices that are not there.
    pub(super) fn errors(&self, mesh: &IndexedMesh, triangles: &[[u32; 3]]) -> Result<SeenErrors, MeshError> {
        let shown = IndexedMesh::new(mesh.positions.clone(), triangles.to_vec());
        let tree = TriangleTree::new(&shown)?;
        let pixels = self.points.iter().map(|&(point, pixels)| pixels * tree.distance_to(point));
        Ok(SeenErrors { pixels: pixels.collect() })
    }
}

impl SeenErrors {
    /// Takes those of another view in.
    pub(super) fn join(&mut self, other: &Self) {
        self.pixels.extend_from_slice(&other.pixels);
    }

    /// The largest; `None` where nothing was looked at.
    pub(super) fn max(&self) -> Option<f64> {
        self.pixels.iter().copied().reduce(f64::max)
    }

    /// What 99 of 100 points do not exceed.
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
    fn errors_are_distances_in_pixels_of_what_faces_the_eye() {
        let mesh = shapes::icosphere(3, 1.0);
        // Half a turn on, far enough away for all of the sphere to be in the picture.
        let frame = Path::Orbit.frames(&mesh)[180];
        let watched = Watched::new(&mesh, &frame);
        // From 3.8 radii away 37 of 100 parts of a sphere are seen, of 642 vertices and 1,280 triangles.
        assert!((620..=800).contains(&watched.points.len()), "{}", watched.points.len());
        for (point, _) in &watched.points {
            assert!(dot(*point, frame.eye()) > 0.5, "{point:?} is behind");
        }
        let none = watched.errors(&mesh, &mesh.triangles).unwrap();
        assert!(none.max().unwrap() < 1e-3, "{:?}", none.max());
        // One octant of the sphere alone: the rest is up to a diameter away.
        let part: Vec<[u32; 3]> = mesh
            .triangles
            .iter()
            .filter(|t| t.iter().all(|&v| mesh.positions[v as usize].iter().all(|&x| x >= 0.0)))
            .copied()
            .collect();
        let some = watched.errors(&mesh, &part).unwrap();
        let farthest = watched.points.iter().map(|(_, pixels)| 2.0 * pixels).fold(0.0, f64::max);
        assert!(some.max().unwrap() > 100.0 && some.max().unwrap() <= farthest);
        assert!(some.p99().unwrap() <= some.max().unwrap());
    }

    #[test]
    fn shares_are_counted_from_below() {
        let errors = SeenErrors { pixels: (1..=200).rev().map(f64::from).collect() };
        assert_eq!((errors.max(), errors.p99()), (Some(200.0), Some(198.0)));
        assert_eq!(SeenErrors { pixels: vec![3.0] }.p99(), Some(3.0));
        assert_eq!((SeenErrors::default().max(), SeenErrors::default().p99()), (None, None));
    }
}
