//! Point-to-surface distance queries, by a tree of boxes over the triangles of a mesh.
//!
//! A [tree of boxes](BoxTree) in f32 finds the few triangles that can be nearest; their distances are
//! computed in f64. Boxes are enlarged, and search limits raised, by more than f32 rounds, so no box that
//! contains a nearer triangle is ever skipped: the result is the exact minimum, the same on every machine.
//! The boxes use a frame in which the mesh spans -1..1, while the triangles keep their own coordinates, so
//! nothing is lost for coordinates around 1e7 or 1e-7. If a few triangles are very far from the others, the
//! others span -1..1, because they would be a single point otherwise, and each query would compare all of them.
//!
//! Cost: O(n log n) to build, O(log n) expected per query near the surface; about 80 bytes per triangle.

use glam::{DVec3, Vec3A};

use super::axis_box::AxisBox;
use super::box_tree::BoxTree;
use super::{IndexedMesh, MeshError};

/// Margin added to every box on all sides, in a frame in which the mesh spans -1..1, where f32 rounds by 6e-8;
/// relative to the coordinate outside.
const BOX_MARGIN: f32 = 1e-6;

/// Factor on search limits, which covers the rounding of f32 for points far away.
const COST_MARGIN: f64 = 1.0 + 2e-6;

/// Distance in half extents beyond which the mesh is a single point in f64.
const FAR: f64 = 1e17;

/// How many times larger the mesh must be than most of its triangles, so that those define the frame.
const STRETCHED: f64 = 1e3;

/// Largest extent of a mesh in the frame, so that squares are finite in f32.
const MAX_EXTENT: f64 = 1e12;

/// Number of triangles that each search of a [`TriangleSearch`] adds to the limit of all.
const VISITS: usize = 1 << 7;

/// Number of triangles that are examined to find out where most of them are.
const SAMPLES: usize = 1 << 10;

/// The triangle nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Distance, in mesh units.
    pub distance: f64,
    /// Index of the triangle in its mesh; if several are equally near, any of them.
    pub triangle: u32,
}

/// A spatial index over the triangles of a mesh, which finds the triangle nearest to a point.
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
    /// Corners of the triangles, in the order and the coordinates of the mesh.
    corners: Vec<[[f32; 3]; 3]>,
    /// Center of the boxes' frame, in mesh units.
    center: DVec3,
    /// Frame units per mesh unit.
    scale: f64,
    /// Whether the mesh spans more than -1..1 in the frame.
    is_stretched: bool,
}

/// A series of searches, each of which begins where another one ended, that compares a limited number of triangles.
///
/// A point near an edge of very many thin triangles lies in the boxes of most of them, so that searches for all
/// points of them would take quadratic time. In an ordinary mesh, the limit is never reached.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TriangleSearch {
    /// The triangle at which the next search begins and that the last one found; `usize::MAX` for any.
    pub triangle: usize,
    /// Number of triangles that may still be compared.
    left: usize,
}

impl TriangleSearch {
    pub(crate) fn new() -> Self {
        Self { triangle: usize::MAX, left: 1 << 20 }
    }
}

impl TriangleTree {
    /// Builds the tree; the mesh may contain degenerate triangles, or none at all.
    ///
    /// # Errors
    /// [`MeshError`] if the mesh is inconsistent or a coordinate is not finite.
    pub fn new(mesh: &IndexedMesh) -> Result<Self, MeshError> {
        mesh.check()?;
        Ok(Self::of_triangles(mesh.triangles.iter().map(|t| t.map(|v| mesh.positions[v as usize])).collect()))
    }

    /// Builds the tree of triangles with these corners, which must be finite.
    pub fn of_triangles(corners: Vec<[[f32; 3]; 3]>) -> Self {
        let points = || corners.iter().flatten().map(|&p| to_dvec3(p));
        let min = points().fold(DVec3::INFINITY, DVec3::min);
        let max = points().fold(DVec3::NEG_INFINITY, DVec3::max);
        let half_extent = 0.5 * (max - min).max_element();
        let center = if corners.is_empty() { DVec3::ZERO } else { 0.5 * (min + max) };
        let scale = if half_extent > 0.0 { half_extent.recip() } else { 1.0 };
        let mut tree = Self { boxes: BoxTree::default(), corners, center, scale, is_stretched: false };
        if let Some((center, bulk)) = bulk_of(&tree.corners)
            && half_extent > STRETCHED * bulk
        {
            let scale = bulk.max(half_extent / MAX_EXTENT).recip();
            tree = Self { center, scale, is_stretched: true, ..tree };
        }
        tree.boxes = BoxTree::new(tree.corners.len(), |index| tree.box_of(index));
        tree
    }

    /// Follows triangles whose corners have moved: quicker than a new tree, whose searches are quicker if triangles have
    /// moved apart. `corners` must be finite, and as many as before.
    ///
    /// # Panics
    /// If there are fewer of them.
    pub fn move_corners(&mut self, corners: impl Iterator<Item = [[f32; 3]; 3]>) {
        self.corners.clear();
        self.corners.extend(corners);
        let mut boxes = std::mem::take(&mut self.boxes);
        boxes.refit(|index| self.box_of(index));
        self.boxes = boxes;
    }

    /// Whether no point of `points`' convex hull is farther than `distance` from one triangle.
    pub(crate) fn is_within(&self, triangle: usize, points: &[DVec3; 3], distance: f64) -> bool {
        // The distance from a convex set is a convex function, so it is largest at a corner.
        let is_near = |corners| {
            let mut squared = points.iter().map(|&point| squared_distance_to_triangle(point, corners));
            squared.all(|squared| squared <= distance * distance)
        };
        self.corners.get(triangle).is_some_and(is_near)
    }

    /// Corners of a triangle, in mesh units.
    pub(crate) fn corners(&self, triangle: usize) -> [[f32; 3]; 3] {
        self.corners[triangle]
    }

    /// Distance between a finite point and the nearest triangle that `search` finds within its limit, mesh units.
    pub(crate) fn searched_distance(&self, point: [f64; 3], search: &mut TriangleSearch) -> f64 {
        search.left += VISITS;
        let TriangleSearch { triangle, left } = search;
        self.distance_while(point, 0.0, triangle, || {
            *left -= usize::from(*left > 0);
            *left > 0
        })
    }

    /// Visits triangles like [`Self::visit_within`], as many as the limit of `search` allows.
    pub(crate) fn visit_searched(
        &self,
        point: [f64; 3],
        reach: f64,
        search: &mut TriangleSearch,
        mut visit: impl FnMut(usize, f64) -> f64,
    ) {
        search.left += VISITS;
        self.visit_while(point, reach, |candidate, distance| {
            search.left -= usize::from(search.left > 0);
            Some(visit(candidate, distance)).filter(|_| search.left > 0)
        });
    }

    /// Distance between a point and the surface, in mesh units; infinite if there are no triangles.
    pub fn distance_to(&self, point: [f64; 3]) -> f64 {
        self.nearest(point).map_or(f64::INFINITY, |nearest| nearest.distance)
    }

    /// The triangle nearest to a point; `None` if there are no triangles or the point is not finite.
    pub fn nearest(&self, point: [f64; 3]) -> Option<Nearest> {
        let mut triangle = usize::MAX;
        let is_finite = point.iter().all(|x| x.is_finite());
        let distance = if is_finite { self.distance_within(point, 0.0, &mut triangle) } else { 0.0 };
        (triangle != usize::MAX).then_some(Nearest { distance, triangle: triangle as u32 })
    }

    /// Distance of a finite point whose nearest triangle is probably the one found by the previous query.
    ///
    /// `triangle` passes that triangle on from query to query; start with `usize::MAX`. It affects the speed,
    /// never the distance.
    pub fn distance_from_hint(&self, point: [f64; 3], triangle: &mut usize) -> f64 {
        self.distance_within(point, 0.0, triangle)
    }

    /// Distance like [`Self::distance_from_hint`], but stops at any triangle that is no farther than
    /// `enough`.
    pub fn distance_within(&self, point: [f64; 3], enough: f64, triangle: &mut usize) -> f64 {
        self.distance_while(point, enough, triangle, || true)
    }

    /// Distance like [`Self::distance_within`] that compares triangles while `goes_on` allows.
    fn distance_while(
        &self,
        point: [f64; 3],
        enough: f64,
        triangle: &mut usize,
        mut goes_on: impl FnMut() -> bool,
    ) -> f64 {
        let point = DVec3::from_array(point);
        let in_frame = (point - self.center) * self.scale;
        let is_far = in_frame.abs().max_element() > FAR;
        if is_far && self.is_stretched {
            return self.distance_to_all(point, triangle);
        }
        if is_far || *triangle >= self.corners.len() {
            *triangle = 0;
        }
        let Some(corners) = self.corners.get(*triangle) else {
            *triangle = usize::MAX;
            return f64::INFINITY;
        };
        // Squared, so that only one square root is needed per query.
        let mut squared = squared_distance_to_triangle(point, corners);
        let enough = enough * enough;
        if !is_far && squared > enough {
            let squared_scale = self.scale * self.scale * COST_MARGIN;
            let limit = (squared * squared_scale) as f32;
            self.boxes.visit_near(in_frame.as_vec3a(), limit, |candidate| {
                let other = squared_distance_to_triangle(point, &self.corners[candidate]);
                if other < squared {
                    (squared, *triangle) = (other, candidate);
                }
                if squared <= enough || !goes_on() { 0.0 } else { (squared * squared_scale) as f32 }
            });
        }
        squared.sqrt()
    }

    /// Distance to the nearest of all triangles, without boxes.
    #[cold]
    fn distance_to_all(&self, point: DVec3, triangle: &mut usize) -> f64 {
        let distances = self.corners.iter().map(|corners| squared_distance_to_triangle(point, corners));
        let nearest = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1));
        *triangle = nearest.map_or(usize::MAX, |(index, _)| index);
        nearest.map_or(f64::INFINITY, |(_, squared)| squared.sqrt())
    }

    /// Visits the triangles within `reach` of a finite point, roughly from near to far, with their
    /// distances in mesh units.
    ///
    /// `visit` returns the reach for the rest of the search, which may shrink. A few triangles beyond the
    /// reach are visited as well.
    pub fn visit_within(&self, point: [f64; 3], reach: f64, mut visit: impl FnMut(usize, f64) -> f64) {
        self.visit_while(point, reach, |candidate, distance| Some(visit(candidate, distance)));
    }

    /// Visits triangles like [`Self::visit_within`] until `visit` returns `None`.
    fn visit_while(&self, point: [f64; 3], reach: f64, mut visit: impl FnMut(usize, f64) -> Option<f64>) {
        let point = DVec3::from_array(point);
        let in_frame = (point - self.center) * self.scale;
        let distance_to =
            |candidate: usize| squared_distance_to_triangle(point, &self.corners[candidate]).sqrt();
        if in_frame.abs().max_element() > FAR {
            (0..self.corners.len())
                .try_for_each(|candidate| visit(candidate, distance_to(candidate)).map(drop));
            return;
        }
        // A reach of 0 must not skip the boxes that contain the point.
        let limit = |reach: f64| (((reach * self.scale).powi(2) * COST_MARGIN) as f32).max(f32::MIN_POSITIVE);
        self.boxes.visit_near(in_frame.as_vec3a(), limit(reach), |candidate| {
            visit(candidate, distance_to(candidate)).map_or(0.0, limit)
        });
    }

    fn box_of(&self, triangle: u32) -> AxisBox {
        let [a, b, c] = self.corners[triangle as usize]
            .map(|corner| ((to_dvec3(corner) - self.center) * self.scale).as_vec3a());
        let (min, max) = (a.min(b).min(c), a.max(b).max(c));
        let margin = |corner: Vec3A| corner.abs().max(Vec3A::ONE) * BOX_MARGIN;
        AxisBox { min: min - margin(min), max: max + margin(max) }
    }
}

/// Returns the center and the half extent of most triangles; [`None`] for a few triangles.
fn bulk_of(corners: &[[[f32; 3]; 3]]) -> Option<(DVec3, f64)> {
    let samples = corners.iter().step_by(corners.len().div_ceil(SAMPLES).max(1));
    let bounds = [0, 1, 2].map(|axis| {
        let mut values: Vec<f32> = samples.clone().map(|corners| corners[0][axis]).collect();
        values.sort_unstable_by(f32::total_cmp);
        let tail = values.len() / 16;
        let last = values.len().checked_sub(1 + tail)?;
        (tail > 0).then(|| (f64::from(values[tail]), f64::from(values[last])))
    });
    let [x, y, z] = bounds;
    let (low, high): (DVec3, DVec3) = (DVec3::new(x?.0, y?.0, z?.0), DVec3::new(x?.1, y?.1, z?.1));
    let half_extent = 0.5 * (high - low).max_element();
    (half_extent > 0.0).then_some((0.5 * (low + high), half_extent))
}

/// Squared distance between a point and a triangle, which may be degenerate.
///
/// Above the interior it is the distance to the plane; elsewhere the nearest point is on an edge that faces
/// the point. Corners are f32, so their differences are almost exact in f64, and the normal of a needle is
/// as good as any other.
#[inline]
fn squared_distance_to_triangle(point: DVec3, corners: &[[f32; 3]; 3]) -> f64 {
    let [a, b, c] = corners.map(|corner| to_dvec3(corner) - point);
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

/// Squared distance between the origin and the segment from `start` to `start + side`.
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

/// Converts a position to f64, which is exact.
#[inline]
pub(super) fn to_dvec3(position: [f32; 3]) -> DVec3 {
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
    fn distances_are_right_in_every_region_around_a_triangle() {
        assert_eq!(distance([1., 1., -2.], &CORNERS), 2.0);
        assert_eq!(distance([1., 1., 0.], &CORNERS), 0.0);
        assert_eq!(distance([2., -3., 4.], &CORNERS), 5.0);
        assert_eq!(distance([-3., 1., 4.], &CORNERS), 5.0);
        assert_eq!(distance([-3., -4., 12.], &CORNERS), 13.0);
        assert_eq!(distance([7., -4., 0.], &CORNERS), 5.0);
        assert_eq!(distance([0., 8., 12.], &CORNERS), 13.0);
        // Above the middle of the long side, which runs along (-4, 3).
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
    fn the_tree_agrees_with_brute_force() {
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

    /// Triangles far from all others stretch the frame, which must change no distance.
    #[test]
    fn the_tree_of_a_stretched_mesh_agrees_with_brute_force() {
        let mut random = crate::mesh::Random::new(5);
        for far in [1e4, 1e7, 1e12, 1e20] {
            let mut corners: Vec<[[f32; 3]; 3]> = (0..200)
                .map(|_| {
                    let center = [(); 3].map(|()| random.between(-1.0, 1.0));
                    [(); 3].map(|()| center.map(|x| x + random.between(-0.1, 0.1)))
                })
                .collect();
            corners.push([[far, 0.0, 0.0], [far, 1.0, 0.0], [far, 0.0, 0.5 * far]]);
            let tree = TriangleTree::of_triangles(corners.clone());
            assert!(tree.is_stretched, "{far}");
            let mut visited = 0;
            for scale in [1.0, 3.0, far, 1e30] {
                for _ in 0..50 {
                    let point = [(); 3].map(|()| f64::from(random.between(-scale, scale)));
                    let expected = corners.iter().map(|c| distance(point, c)).fold(f64::INFINITY, f64::min);
                    assert_eq!(tree.distance_to(point), expected, "{far} {point:?}");
                    tree.visit_within(point, expected, |_, _| {
                        visited += usize::from(scale == 1.0);
                        expected
                    });
                }
            }
            // Boxes that are points would let each query visit all triangles.
            assert!(far > 1e12 || visited < 50 * 20, "{far}: {visited}");
        }
    }

    /// Thin triangles around one edge, whose boxes all contain the points near it.
    #[test]
    fn searches_among_thin_triangles_are_limited() {
        let count = 4000;
        let blade = |i: usize| {
            let (sine, cosine) = (i as f32 / count as f32 * std::f32::consts::FRAC_PI_2).sin_cos();
            [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [cosine, sine, 0.5]]
        };
        let tree = TriangleTree::of_triangles((0..count).map(blade).collect());
        let point = |i: usize| {
            let [_, _, [x, y, _]] = blade(i * 7919 % count);
            [x, y, 50.0].map(|x| f64::from(x) * 0.01)
        };
        let mut search = TriangleSearch::new();
        let (mut visits, mut exact) = (0, 0);
        for i in 0..20_000 {
            let near = tree.searched_distance(point(i), &mut search);
            assert!(near < 0.011 && search.triangle < count, "{near}");
            exact += usize::from(near < 1e-6);
            tree.visit_searched(point(i), 0.01, &mut search, |_, _| {
                visits += 1;
                0.01
            });
        }
        assert!(exact > 0, "the first searches have no limit");
        assert!((1 << 18..=(1 << 20) + 40_000 * VISITS).contains(&visits), "{visits}");
    }

    #[test]
    fn empty_meshes_and_nan_points_have_no_nearest_triangle() {
        let empty = TriangleTree::new(&IndexedMesh::default()).unwrap();
        assert_eq!(empty.nearest([0.0; 3]), None);
        assert_eq!(empty.distance_to([0.0; 3]), f64::INFINITY);
        let mesh = IndexedMesh::new(CORNERS.to_vec(), vec![[0, 1, 2]]);
        assert_eq!(TriangleTree::new(&mesh).unwrap().nearest([f64::NAN, 0.0, 0.0]), None);
        let broken = IndexedMesh::new(CORNERS.to_vec(), vec![[0, 1, 3]]);
        assert!(matches!(TriangleTree::new(&broken), Err(MeshError::IndexOutOfRange { vertex: 3, .. })));
    }

    #[test]
    fn distances_are_exact_for_very_distant_points() {
        let mesh = IndexedMesh::new(CORNERS.to_vec(), vec![[0, 1, 2], [0, 2, 1]]);
        let tree = TriangleTree::new(&mesh).unwrap();
        for z in [1e6, 1e16, 1e19, 1e37, 1e150] {
            assert_eq!(tree.distance_to([0.5, 0.5, z]), z);
        }
        assert_eq!(tree.distance_to([f64::INFINITY, 0.0, 0.0]), f64::INFINITY);
    }

    #[test]
    fn equal_triangles_do_not_degenerate_the_tree() {
        let mesh = IndexedMesh::new(CORNERS.to_vec(), vec![[0, 1, 2]; 100_000]);
        assert_eq!(TriangleTree::new(&mesh).unwrap().distance_to([1., 1., 7.]), 7.0);
    }
}
