//! Neighborhoods of base vertices, from which their attributes are predicted.
//!
//! The triangles and positions of the base are coded first, then its attributes vertex by vertex. A vertex
//! can thus be predicted from the vertices coded earlier that share a triangle with it, and from those
//! across the far edge of such a triangle (parallelogram rule); its normal can be predicted from all its
//! triangles. Gathering a neighborhood takes bounded time.

use crate::base::mesh::Base;
use crate::topology::surface::NONE;

/// Maximum number of triangles visited around a vertex.
const MAX_TRIANGLES: usize = 64;
/// Maximum number of neighbors gathered.
const MAX_NEIGHBORS: usize = 16;

/// The corners of the base mesh, indexed by mesh vertex.
#[derive(Debug)]
pub(crate) struct BaseNeighborhoods<'a> {
    base: &'a Base,
    /// Start of each vertex's range in `corners`, followed by the number of corners.
    first_corner: Vec<u32>,
    /// Corners (three per triangle), sorted by vertex.
    corners: Vec<u32>,
}

impl<'a> BaseNeighborhoods<'a> {
    /// Indexes the corners of a base whose wedges are known.
    pub(crate) fn new(base: &'a Base) -> Self {
        let vertex_count = base.first_vertex.last().copied().unwrap_or(0) as usize;
        let mut ends = vec![0u32; vertex_count + 1];
        let shown =
            || base.corner_vertices.iter().flatten().enumerate().filter(|(_, vertex)| **vertex != NONE);
        for (_, &vertex) in shown() {
            ends[vertex as usize] += 1;
        }
        let mut sum = 0;
        for end in &mut ends {
            sum += *end;
            *end = sum;
        }
        let mut corners = vec![0; sum as usize];
        for (corner, &vertex) in shown() {
            let slot = &mut ends[vertex as usize];
            *slot -= 1;
            corners[*slot as usize] = corner as u32;
        }
        Self { base, first_corner: ends, corners }
    }

    fn vertex_at(&self, corner: u32) -> u32 {
        self.base.corner_vertices[corner as usize / 3][corner as usize % 3]
    }

    fn grid_point(&self, corner: u32) -> [i32; 3] {
        self.base.grid_point(self.base.triangles[corner as usize / 3][corner as usize % 3])
    }

    /// Gathers the already coded neighbors of a vertex and their grid coordinates; returns the sum of the
    /// area-weighted normals of its triangles.
    pub(crate) fn gather(
        &self,
        vertex: u32,
        ring: &mut Vec<u32>,
        grid_points: &mut Vec<[i32; 3]>,
    ) -> [i64; 3] {
        ring.clear();
        grid_points.clear();
        let range =
            self.first_corner[vertex as usize] as usize..self.first_corner[vertex as usize + 1] as usize;
        let corners = &self.corners[range];
        let mut normal = [0; 3];
        let mut add = |corner: u32| {
            let other = self.vertex_at(corner);
            if other < vertex && ring.len() < MAX_NEIGHBORS && !ring.contains(&other) {
                ring.push(other);
                grid_points.push(self.grid_point(corner));
            }
        };
        for &corner in corners.iter().take(MAX_TRIANGLES) {
            let [next, previous] = [next(corner), previous(corner)];
            add(next);
            add(previous);
            let scaled = scaled_normal([corner, next, previous].map(|c| self.grid_point(c)));
            (0..3).for_each(|axis| normal[axis] += scaled[axis]);
        }
        // Vertices across edges come last, since those that share a triangle are nearer.
        for &corner in corners.iter().take(MAX_TRIANGLES) {
            let ends = [next(corner), previous(corner)].map(|c| self.vertex_at(c));
            let other = self.base.opposite[corner as usize];
            let across = [previous(other), next(other)].map(|c| self.vertex_at(c));
            if ends == across && ends.iter().all(|&end| end < vertex) {
                add(other);
            }
        }
        normal
    }
}

fn next(corner: u32) -> u32 {
    if corner % 3 == 2 { corner - 2 } else { corner + 1 }
}

fn previous(corner: u32) -> u32 {
    if corner.is_multiple_of(3) { corner + 2 } else { corner - 1 }
}

/// Returns the normal of a triangle, scaled to twice its area.
fn scaled_normal([a, b, c]: [[i32; 3]; 3]) -> [i64; 3] {
    let [p, q]: [[i64; 3]; 2] = [b, c].map(|d| std::array::from_fn(|i| i64::from(d[i]) - i64::from(a[i])));
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        p[j] * q[k] - p[k] * q[j]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gathers_parallelogram_neighbors_and_normals() {
        // Two triangles of a square, and the virtual triangles along their boundary.
        let base = Base {
            virtual_count: 1,
            position_of_copy: vec![0, 1, 2, 3],
            triangles: vec![[1, 2, 3], [2, 1, 4], [0, 3, 2], [0, 1, 3], [0, 4, 1], [0, 2, 4]],
            opposite: vec![6, 9, 3, 2, 15, 12, 0, 13, 16, 1, 0, 0, 5, 7, 0, 4, 8, 0],
            grid_points: vec![[0, 0, 0], [9, 9, 0], [0, 9, 0], [9, 0, 0]],
            first_vertex: vec![0, 1, 2, 3, 4],
            corner_vertices: vec![[0, 1, 2], [1, 0, 3], [NONE; 3], [NONE; 3], [NONE; 3], [NONE; 3]],
            groups: vec![0; 6],
        };
        let mut base = base;
        // Only the two corners opposite to the diagonal matter here: they face each other.
        base.opposite[2] = 5;
        base.opposite[5] = 2;
        let neighborhoods = BaseNeighborhoods::new(&base);
        let (mut ring, mut grid_points) = (Vec::new(), Vec::new());
        let normal = neighborhoods.gather(3, &mut ring, &mut grid_points);
        assert_eq!(ring, [1, 0, 2]);
        assert_eq!(grid_points, [[9, 9, 0], [0, 0, 0], [0, 9, 0]]);
        assert_eq!(normal, [0, 0, 81]);
        neighborhoods.gather(0, &mut ring, &mut grid_points);
        assert!(ring.is_empty() && grid_points.is_empty());
    }
}
