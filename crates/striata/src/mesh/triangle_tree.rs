//! A tree of boxes over triangles that answers "how far is this point from the surface?".
//!
//! A [tree of boxes](BoxTree) finds in f32 the few triangles that matter; their distances are computed in f64. Boxes are a little larger and costs a little dearer than the truth, by more than f32
//! rounds, so no box is skipped that holds a nearer triangle: the distance is the exact minimum, the same on
//! every machine. Boxes live in a frame where the mesh spans -1..1, triangles keep the mesh's own coordinates:
//! coordinates around 1e7 or 1e-7 lose nothing.
//!
//! Cost: O(n log n) to build, O(log n) expected for a point near the surface; about 70 bytes a triangle.

use glam::{DVec3, Vec3A};

use super::box_tree::{AxisBox, BoxTree};
use super::{IndexedMesh, MeshError};

/// Added to every box on all sides, in a frame where the mesh spans -1..1; f32 rounds by 6e-8 there.
const BOX_MARGIN: f32 = 1e-6;

/// Factor on costs of triangles, for what f32 rounds on points far away.
const COST_MARGIN: f64 = 1.0 + 2e-6;

/// Farther out than this many half extents, f64 sees the mesh as one point.
const FAR: f64 = 1e17;

/// The triangle nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Distance, mesh units.
    pub distance: f64,
    /// The triangle's index in its mesh; of several at the same distance, any one.
    pub triangle: u32,
}

/// A point-to-surface index over the triangles of one mesh.
///
/// ```
/// use striata::mesh::{IndexedMesh, TriangleTree};
/// let mesh = IndexedMesh::new(vec![[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]], vec![[0, 1, 2]]);
/// let tree = TriangleTree::new(&mesh)?;
/// assert_eq!(tree.distance_to([0.25, 0.25, 2.0]), 2.0);
/// # Ok::<(), striata::mesh::MeshError>(())
/// ```
pub struct TriangleTree {
    boxes: BoxTree,
    /// Corners of the triangles, in the mesh's order and coordinates.
    corners: Vec<[[f32; 3]; 3]>,
    /// Middle of the frame of the boxes, mesh units.
    center: DVec3,
    /// Frame units for a mesh unit.
    scale: f64,
}

impl TriangleTree {
    /// Builds the tree; triangles may be degenerate, and there may be none.
    ///
    /// # Errors
    /// [`MeshError`] where an index is out of range or a coordinate not finite.
    pub fn new(mesh: &IndexedMesh) -> Result<Self, MeshError> {
        mesh.check()?;
        let corners: Vec<[[f32; 3]; 3]> =
            mesh.triangles.iter().map(|t| t.map(|v| mesh.positions[v as usize])).collect();
        let points = || corners.iter().flatten().map(|&p| exact(p));
        let min = points().fold(DVec3::INFINITY, DVec3::min);
        let max = points().fold(DVec3::NEG_INFINITY, DVec3::max);
        let half_extent = 0.5 * (max - min).max_element();
        let center = if corners.is_empty() { DVec3::ZERO } else { 0.5 * (min + max) };
        let scale = if half_extent > 0.0 { half_extent.recip() } else { 1.0 };
        let mut tree = Self { boxes: BoxTree::default(), corners, center, scale };
        let boxes: Vec<AxisBox> = tree.corners.iter().map(|corners| tree.box_of(corners)).collect();
        tree.boxes = BoxTree::new(&boxes);
        Ok(tree)
    }

    /// Distance of the point to the surface, mesh units; infinite where there is no triangle.
    pub fn distance_to(&self, point: [f64; 3]) -> f64 {
        self.nearest(point).map_or(f64::INFINITY, |nearest| nearest.distance)
    }

    /// The nearest triangle; `None` where there is none, or where the point is not finite.
    pub fn nearest(&self, point: [f64; 3]) -> Option<Nearest> {
        let point = DVec3::from_array(point);
        let mut triangle = usize::MAX;
        let distance = if point.is_finite() { self.distance_from_hint(point, &mut triangle) } else { 0.0 };
        (triangle != usize::MAX).then_some(Nearest { distance, triangle: triangle as u32 })
    }

    /// Distance of a finite point whose nearest triangle is probably that of the query before.
    ///
    /// `triangle` carries that triangle from query to query; it changes the work, never the distance.
    pub(super) fn distance_from_hint(&self, point: DVec3, triangle: &mut usize) -> f64 {
        self.distance_within(point, 0.0, triangle)
    }

    /// Distance as [`Self::distance_from_hint`] finds it, or that of any triangle that is no farther than `enough`.
    pub(crate) fn distance_within(&self, point: DVec3, enough: f64, triangle: &mut usize) -> f64 {
        let in_frame = (point - self.center) * self.scale;
        let is_far = in_frame.abs().max_element() > FAR;
        if is_far || *triangle >= self.corners.len() {
            *triangle = 0;
        }
        let Some(corners) = self.corners.get(*triangle) else {
            *triangle = usize::MAX;
            return f64::INFINITY;
        };
        // Squared: roots are taken once per query.
        let mut squared = squared_distance_to_triangle(point, corners);
        let enough = enough * enough;
        if !is_far && squared > enough {
            let squared_scale = self.scale * self.scale * COST_MARGIN;
            let limit = (squared * squared_scale) as f32;
            self.boxes.visit_near(in_frame.as_vec3a(), limit, |tried| {
                let other = squared_distance_to_triangle(point, &self.corners[tried]);
                if other < squared {
                    (squared, *triangle) = (other, tried);
                }
                if squared <= enough { 0.0 } else { (squared * squared_scale) as f32 }
            });
        }
        squared.sqrt()
    }

    /// Hands over triangles that are within `reach` of a finite point, each with its distance, mesh units; near ones tend to
    /// come first. `visit` returns the reach from then on, which may shrink. A few triangles beyond the reach come as well.
    pub(super) fn visit_within(&self, point: DVec3, reach: f64, mut visit: impl FnMut(usize, f64) -> f64) {
        let in_frame = (point - self.center) * self.scale;
        let distance_to = |tried: usize| squared_distance_to_triangle(point, &self.corners[tried]).sqrt();
        if in_frame.abs().max_element() > FAR {
            for tried in 0..self.corners.len() {
                visit(tried, distance_to(tried));
            }
            return;
        }
        // A reach of 0 must not leave out the boxes that the point is in.
        let limit = |reach: f64| (((reach * self.scale).powi(2) * COST_MARGIN) as f32).max(f32::MIN_POSITIVE);
        self.boxes
            .visit_near(in_frame.as_vec3a(), limit(reach), |tried| limit(visit(tried, distance_to(tried))));
    }

    fn box_of(&self, corners: &[[f32; 3]; 3]) -> AxisBox {
        let [a, b, c] = corners.map(|corner| ((exact(corner) - self.center) * self.scale).as_vec3a());
        let margin = Vec3A::splat(BOX_MARGIN);
        AxisBox { min: a.min(b).min(c) - margin, max: a.max(b).max(c) + margin }
    }
}

/// Squared distance of a point to a triangle, which may be a segment or a point.
///
/// Over the inside it is the distance to the plane; elsewhere the nearest point lies on a side that turns its
/// back on the point. Corners are f32, so their differences are all but exact in f64, and a needle's normal
/// is as good as any other.
#[inline]
fn squared_distance_to_triangle(point: DVec3, corners: &[[f32; 3]; 3]) -> f64 {
    let [a, b, c] = corners.map(|corner| exact(corner) - point);
    let sides = [(a, b - a), (b, c - b), (c, a - c)];
    let normal = sides[0].1.cross(sides[1].1);
    let squared_normal = normal.length_squared();
    let mut squared = f64::INFINITY;
    for (start, side) in sides {
        if normal.dot(start.cross(side)) <= 0.0 || squared_normal == 0.0 {
            squared = squared.min(squared_distance_to_segment(start, side));
        }
    }
    if squared == f64::INFINITY {
        let height = normal.dot(a);
        squared = height * height / squared_normal;
    }
    squared
}

/// Squared distance of the origin to the segment from `start` along `side`.
#[inline]
fn squared_distance_to_segment(start: DVec3, side: DVec3) -> f64 {
    let along = -start.dot(side);
    let squared_length = side.length_squared();
    if along <= 0.0 || squared_length == 0.0 {
        start.length_squared()
    } else if along >= squared_length {
        (start + side).length_squared()
    } else {
        (start + along / squared_length * side).length_squared()
    }
}

/// A position without loss.
#[inline]
pub(super) fn exact(position: [f32; 3]) -> DVec3 {
    DVec3::from_array(position.map(f64::from))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f32; 3]; 3] = [[0., 0., 0.], [4., 0., 0.], [0., 3., 0.]];

    fn distance(point: [f64; 3], corners: &[[f32; 3]; 3]) -> f64 {
        squared_distance_to_triangle(DVec3::from_array(point), corners).sqrt()
    }

    #[test]
    fn every_region_of_a_triangle() {
        assert_eq!(distance([1., 1., -2.], &CORNERS), 2.0);
        assert_eq!(distance([1., 1., 0.], &CORNERS), 0.0);
        assert_eq!(distance([2., -3., 4.], &CORNERS), 5.0);
        assert_eq!(distance([-3., 1., 4.], &CORNERS), 5.0);
        assert_eq!(distance([-3., -4., 12.], &CORNERS), 13.0);
        assert_eq!(distance([7., -4., 0.], &CORNERS), 5.0);
        assert_eq!(distance([0., 8., 12.], &CORNERS), 13.0);
        // Over the middle of the long side, which runs along (-4, 3).
        assert!((distance([2. + 3., 1.5 + 4., 0.], &CORNERS) - 5.0).abs() < 1e-12);
    }

    #[test]
    fn triangles_without_area_are_segments_and_points() {
        let segment = [[0., 0., 0.], [2., 0., 0.], [1., 0., 0.]];
        assert_eq!(distance([1.5, 3., 4.], &segment), 5.0);
        assert_eq!(distance([5., 0., 4.], &segment), 5.0);
        assert_eq!(distance([1., 4., 4.], &[[1., 1., 0.]; 3]), 5.0);
    }

    #[test]
    fn the_tree_agrees_with_trying_all() {
        let mut random = crate::mesh::Random::new(3);
        let mut point = |scale: f32| [(); 3].map(|()| random.between(-scale, scale));
        let mut mesh = IndexedMesh::default();
        for t in 0..300u32 {
            let center = point(10.0);
            for _ in 0..3 {
                let offset = point(0.7);
                mesh.positions.push(std::array::from_fn(|axis| center[axis] + offset[axis]));
            }
            mesh.triangles.push([3 * t, 3 * t + 1, 3 * t + 2]);
        }
        let tree = TriangleTree::new(&mesh).unwrap();
        for _ in 0..500 {
            let p = point(15.0).map(f64::from);
            let all = mesh.triangles.iter().map(|t| distance(p, &t.map(|v| mesh.positions[v as usize])));
            let expected = all.fold(f64::INFINITY, f64::min);
            let found = tree.nearest(p).unwrap();
            assert_eq!(found.distance, expected);
            let corners = mesh.triangles[found.triangle as usize].map(|v| mesh.positions[v as usize]);
            assert_eq!(distance(p, &corners), expected);
        }
    }

    #[test]
    fn no_triangle_and_no_number() {
        let empty = TriangleTree::new(&IndexedMesh::default()).unwrap();
        assert_eq!(empty.nearest([0.0; 3]), None);
        assert_eq!(empty.distance_to([0.0; 3]), f64::INFINITY);
        let mesh = IndexedMesh::new(CORNERS.to_vec(), vec![[0, 1, 2]]);
        assert_eq!(TriangleTree::new(&mesh).unwrap().nearest([f64::NAN, 0.0, 0.0]), None);
        let broken = IndexedMesh::new(CORNERS.to_vec(), vec![[0, 1, 3]]);
        assert!(matches!(TriangleTree::new(&broken), Err(MeshError::IndexOutOfRange { vertex: 3, .. })));
    }

    #[test]
    fn points_as_far_as_numbers_reach() {
        let mesh = IndexedMesh::new(CORNERS.to_vec(), vec![[0, 1, 2], [0, 2, 1]]);
        let tree = TriangleTree::new(&mesh).unwrap();
        for z in [1e6, 1e16, 1e19, 1e37, 1e150] {
            assert_eq!(tree.distance_to([0.5, 0.5, z]), z);
        }
        assert_eq!(tree.distance_to([f64::INFINITY, 0.0, 0.0]), f64::INFINITY);
    }

    #[test]
    fn a_hundred_thousand_equal_triangles_still_make_a_tree() {
        let mesh = IndexedMesh::new(CORNERS.to_vec(), vec![[0, 1, 2]; 100_000]);
        assert_eq!(TriangleTree::new(&mesh).unwrap().distance_to([1., 1., 7.]), 7.0);
    }
}
