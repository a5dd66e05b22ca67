//! A tree of boxes over triangles that answers "how far is this point from the surface?".
//!
//! Triangles are halved at the median of their centres along the widest axis until few are left, so the
//! tree is balanced whatever the mesh looks like (flat, a needle, all in one place). Boxes hold the mesh's own
//! coordinates, all arithmetic is f64 on differences: coordinates around 1e7 lose nothing. A query
//! descends into the nearer box first and skips boxes farther away than the best triangle so far.
//!
//! Cost: O(n log n) to build, O(log n) expected for a point near the surface; about 70 bytes a triangle.

use glam::DVec3;

use super::{IndexedMesh, MeshError};

/// Triangles in a leaf; larger leaves save boxes, smaller ones triangle tests.
const LEAF_TRIANGLES: usize = 4;

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
#[derive(Clone, Debug)]
pub struct TriangleTree {
    /// Inner nodes; the root is the first. Empty where all triangles fit one leaf.
    nodes: Vec<Node>,
    /// Corners of the triangles, leaf by leaf.
    corners: Vec<[[f32; 3]; 3]>,
    /// Index in the mesh, in the order of `corners`.
    triangles: Vec<u32>,
}

/// Two children with their boxes side by side, so that one cache line decides on both.
#[derive(Clone, Copy, Debug)]
struct Node {
    boxes: [[[f32; 3]; 2]; 2],
    children: [Child; 2],
}

/// An inner node (`count` 0, `start` its index) or a run of triangles.
#[derive(Clone, Copy, Debug, Default)]
struct Child {
    start: u32,
    count: u32,
}

/// Best so far, squared: roots are taken once per query.
#[derive(Clone, Copy)]
struct Best {
    squared: f64,
    slot: usize,
}

/// Deeper than any tree of 2^30 triangles halved at the median.
const STACK: usize = 40;

impl TriangleTree {
    /// Builds the tree; triangles may be degenerate, and there may be none.
    ///
    /// # Errors
    /// [`MeshError`] where an index is out of range or a coordinate not finite.
    pub fn new(mesh: &IndexedMesh) -> Result<Self, MeshError> {
        mesh.check()?;
        let mut items: Vec<Item> = (0..mesh.triangles.len()).map(|t| Item::of(mesh, t)).collect();
        let mut nodes = Vec::with_capacity(items.len() / (LEAF_TRIANGLES / 2).max(1));
        if items.len() > LEAF_TRIANGLES {
            split(&mut items, 0, &mut nodes);
        }
        let triangles: Vec<u32> = items.iter().map(|item| item.triangle).collect();
        let corners = triangles
            .iter()
            .map(|&t| mesh.triangles[t as usize].map(|v| mesh.positions[v as usize]))
            .collect();
        Ok(Self { nodes, corners, triangles })
    }

    /// Distance of the point to the surface, mesh units; infinite where there is no triangle.
    pub fn distance_to(&self, point: [f64; 3]) -> f64 {
        self.nearest(point).map_or(f64::INFINITY, |nearest| nearest.distance)
    }

    /// The nearest triangle; `None` where there is none, or where the point is not finite.
    pub fn nearest(&self, point: [f64; 3]) -> Option<Nearest> {
        let mut slot = usize::MAX;
        let distance = self.distance_from_hint(DVec3::from_array(point), &mut slot);
        (slot != usize::MAX).then(|| Nearest { distance, triangle: self.triangles[slot] })
    }

    /// Distance of a point whose nearest triangle is probably that of the query before.
    ///
    /// `slot` carries that triangle from query to query; it changes the work, never the distance.
    pub(super) fn distance_from_hint(&self, point: DVec3, slot: &mut usize) -> f64 {
        let mut best = Best { squared: f64::INFINITY, slot: *slot };
        if let Some(corners) = self.corners.get(*slot) {
            best.squared = squared_distance_to_triangle(point, corners);
        }
        if self.nodes.is_empty() {
            self.visit_leaf(point, 0..self.corners.len(), &mut best);
        } else {
            self.descend(point, &mut best);
        }
        *slot = best.slot;
        best.squared.sqrt()
    }

    fn descend(&self, point: DVec3, best: &mut Best) {
        let mut stack = [(0.0, Child::default()); STACK];
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let (squared, child) = stack[depth];
            if squared >= best.squared {
                continue;
            }
            if child.count > 0 {
                let start = child.start as usize;
                self.visit_leaf(point, start..start + child.count as usize, best);
                continue;
            }
            let node = &self.nodes[child.start as usize];
            let squared = node.boxes.map(|b| squared_distance_to_box(point, &b));
            let near = usize::from(squared[1] < squared[0]);
            // The nearer child goes on top of the stack, so it comes first.
            for side in [1 - near, near] {
                if squared[side] < best.squared {
                    stack[depth] = (squared[side], node.children[side]);
                    depth += 1;
                }
            }
        }
    }

    fn visit_leaf(&self, point: DVec3, range: std::ops::Range<usize>, best: &mut Best) {
        for slot in range {
            let squared = squared_distance_to_triangle(point, &self.corners[slot]);
            if squared < best.squared {
                *best = Best { squared, slot };
            }
        }
    }
}

/// A triangle while the tree is built.
struct Item {
    triangle: u32,
    min: [f32; 3],
    max: [f32; 3],
}

impl Item {
    fn of(mesh: &IndexedMesh, triangle: usize) -> Self {
        let [a, b, c] = mesh.triangles[triangle].map(|v| mesh.positions[v as usize]);
        let pick = |f: fn(f32, f32) -> f32| std::array::from_fn(|axis| f(f(a[axis], b[axis]), c[axis]));
        Self { triangle: triangle as u32, min: pick(f32::min), max: pick(f32::max) }
    }

    /// The middle of the triangle's box; halves keep the sum finite.
    fn center(&self, axis: usize) -> f32 {
        0.5 * self.min[axis] + 0.5 * self.max[axis]
    }
}

/// Splits the items in two, makes a node of them, and returns the node's index.
fn split(items: &mut [Item], first: u32, nodes: &mut Vec<Node>) -> u32 {
    let index = nodes.len();
    let axis = widest_axis(items);
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |a, b| {
        a.center(axis).total_cmp(&b.center(axis)).then(a.triangle.cmp(&b.triangle))
    });
    let (left, right) = items.split_at_mut(middle);
    nodes.push(Node { boxes: [box_of(left), box_of(right)], children: [Child::default(); 2] });
    let starts = [first, first + middle as u32];
    for (side, half) in [left, right].into_iter().enumerate() {
        nodes[index].children[side] = if half.len() <= LEAF_TRIANGLES {
            Child { start: starts[side], count: half.len() as u32 }
        } else {
            Child { start: split(half, starts[side], nodes), count: 0 }
        };
    }
    index as u32
}

fn widest_axis(items: &[Item]) -> usize {
    let mut low = [f32::INFINITY; 3];
    let mut high = [f32::NEG_INFINITY; 3];
    for item in items {
        for axis in 0..3 {
            low[axis] = low[axis].min(item.center(axis));
            high[axis] = high[axis].max(item.center(axis));
        }
    }
    let extent = |axis: usize| f64::from(high[axis]) - f64::from(low[axis]);
    (1..3).fold(0, |widest, axis| if extent(axis) > extent(widest) { axis } else { widest })
}

fn box_of(items: &[Item]) -> [[f32; 3]; 2] {
    let mut bounds = [items[0].min, items[0].max];
    for item in items {
        for axis in 0..3 {
            bounds[0][axis] = bounds[0][axis].min(item.min[axis]);
            bounds[1][axis] = bounds[1][axis].max(item.max[axis]);
        }
    }
    bounds
}

#[inline]
fn squared_distance_to_box(point: DVec3, [min, max]: &[[f32; 3]; 2]) -> f64 {
    let outside = (exact(*min) - point).max(point - exact(*max)).max(DVec3::ZERO);
    outside.length_squared()
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
    fn a_hundred_thousand_equal_triangles_still_make_a_tree() {
        let mesh = IndexedMesh::new(CORNERS.to_vec(), vec![[0, 1, 2]; 100_000]);
        assert_eq!(TriangleTree::new(&mesh).unwrap().distance_to([1., 1., 7.]), 7.0);
    }
}
