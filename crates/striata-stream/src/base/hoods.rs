//! What is known around a vertex of the base when its attributes are coded.
//!
//! The triangles and places of the base come first, then attributes vertex by vertex. So a vertex can be predicted from those
//! coded before it that it shares triangles with, and from those across an edge of such a triangle, which together span a
//! parallelogram; and its normal from all its triangles. Looking around a vertex takes bounded time.

use crate::base::mesh::Base;
use crate::topology::surface::NONE;

/// Triangles of a vertex that are looked at.
const MOST_TRIANGLES: usize = 64;
/// Vertices around that are of use.
const MOST_AROUND: usize = 16;

/// The triangles of the base by the vertices that their corners show.
#[derive(Debug)]
pub(crate) struct BaseHoods<'a> {
    base: &'a Base,
    /// First corner of each vertex, closed by the number of corners.
    first_corner: Vec<u32>,
    /// Corners by vertex, three a triangle.
    corners: Vec<u32>,
}

impl<'a> BaseHoods<'a> {
    /// Of a base whose corners are known.
    pub(crate) fn new(base: &'a Base) -> Self {
        let vertex_count = base.first_vertex.last().copied().unwrap_or(0) as usize;
        let mut ends = vec![0u32; vertex_count + 1];
        let shown = || base.shown.iter().flatten().enumerate().filter(|(_, vertex)| **vertex != NONE);
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
            let place = &mut ends[vertex as usize];
            *place -= 1;
            corners[*place as usize] = corner as u32;
        }
        Self { base, first_corner: ends, corners }
    }

    fn shown(&self, corner: u32) -> u32 {
        self.base.shown[corner as usize / 3][corner as usize % 3]
    }

    fn place(&self, corner: u32) -> [i32; 3] {
        self.base.place(self.base.triangles[corner as usize / 3][corner as usize % 3])
    }

    /// Finds the vertices before a vertex that are around it, and where they are; gives the sum of the normals of its
    /// triangles.
    pub(crate) fn gather(&self, vertex: u32, ring: &mut Vec<u32>, places: &mut Vec<[i32; 3]>) -> [i64; 3] {
        ring.clear();
        places.clear();
        let range =
            self.first_corner[vertex as usize] as usize..self.first_corner[vertex as usize + 1] as usize;
        let corners = &self.corners[range];
        let mut normal = [0; 3];
        let mut add = |corner: u32| {
            let other = self.shown(corner);
            if other < vertex && ring.len() < MOST_AROUND && !ring.contains(&other) {
                ring.push(other);
                places.push(self.place(corner));
            }
        };
        for &corner in corners.iter().take(MOST_TRIANGLES) {
            let [next, previous] = [next(corner), previous(corner)];
            add(next);
            add(previous);
            let turned = across([corner, next, previous].map(|c| self.place(c)));
            (0..3).for_each(|axis| normal[axis] += turned[axis]);
        }
        // Vertices across edges come last: those that share triangles are nearer.
        for &corner in corners.iter().take(MOST_TRIANGLES) {
            let ends = [next(corner), previous(corner)].map(|c| self.shown(c));
            let other = self.base.opposite[corner as usize];
            let across = [previous(other), next(other)].map(|c| self.shown(c));
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

/// The normal of a triangle, twice its area long.
fn across([a, b, c]: [[i32; 3]; 3]) -> [i64; 3] {
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
    fn parallelograms_and_normals_are_found() {
        // Two triangles of a square and their backs, which are virtual.
        let base = Base {
            virtual_count: 1,
            position_of_copy: vec![0, 1, 2, 3],
            triangles: vec![[1, 2, 3], [2, 1, 4], [0, 3, 2], [0, 1, 3], [0, 4, 1], [0, 2, 4]],
            opposite: vec![6, 9, 3, 2, 15, 12, 0, 13, 16, 1, 0, 0, 5, 7, 0, 4, 8, 0],
            places: vec![[0, 0, 0], [9, 9, 0], [0, 9, 0], [9, 0, 0]],
            first_vertex: vec![0, 1, 2, 3, 4],
            shown: vec![[0, 1, 2], [1, 0, 3], [NONE; 3], [NONE; 3], [NONE; 3], [NONE; 3]],
            groups: vec![0; 6],
        };
        let mut base = base;
        // What matters: the corners that face the diagonal face each other.
        base.opposite[2] = 5;
        base.opposite[5] = 2;
        let hoods = BaseHoods::new(&base);
        let (mut ring, mut places) = (Vec::new(), Vec::new());
        let normal = hoods.gather(3, &mut ring, &mut places);
        assert_eq!(ring, [1, 0, 2]);
        assert_eq!(places, [[9, 9, 0], [0, 0, 0], [0, 9, 0]]);
        assert_eq!(normal, [0, 0, 81]);
        hoods.gather(0, &mut ring, &mut places);
        assert!(ring.is_empty() && places.is_empty());
    }
}
