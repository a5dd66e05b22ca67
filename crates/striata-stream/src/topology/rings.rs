//! Finds the corners around several vertices in parallel.
//!
//! Each step around a vertex depends on the previous one and mostly waits for memory. Interleaving
//! several walks overlaps their waiting times, so all of them finish in about the time of one.

use crate::topology::surface::{NONE, Surface, next};

/// Number of interleaved walks.
const INTERLEAVED_WALKS: usize = 12;
/// Maximum ring length for an interleaved walk; longer rings are walked separately.
const SHORT_RING: usize = 16;

/// Lists of the corners around several vertices, stored consecutively.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rings {
    corners: Vec<u32>,
    /// End of each vertex's corners in that list.
    ends: Vec<u32>,
    /// Neighbor of each corner, once looked up.
    neighbors: Vec<Neighbor>,
}

/// A ring neighbor: the next vertex of one of the ring's corners.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Neighbor {
    /// Index of the vertex.
    pub vertex: u32,
    /// Its grid coordinates.
    pub grid_point: [i32; 3],
}

impl Rings {
    /// Finds the corners around each vertex, counterclockwise from [`Surface::corner_of`].
    pub(crate) fn find(&mut self, surface: &Surface, vertices: &[u32]) {
        self.corners.clear();
        self.ends.clear();
        for vertices in vertices.chunks(INTERLEAVED_WALKS) {
            self.find_few(surface, vertices);
        }
    }

    /// Finds the corners around at most [`INTERLEAVED_WALKS`] vertices.
    fn find_few(&mut self, surface: &Surface, vertices: &[u32]) {
        let mut walks = [[NONE; SHORT_RING]; INTERLEAVED_WALKS];
        let mut here = [NONE; INTERLEAVED_WALKS];
        let mut counts = [0; INTERLEAVED_WALKS];
        for (here, &vertex) in here.iter_mut().zip(vertices) {
            *here = surface.corner_of(vertex);
        }
        let first = here;
        let mut open = vertices.len();
        for step in 0..SHORT_RING {
            for (walk, ring) in walks.iter_mut().enumerate().take(vertices.len()) {
                if counts[walk] == 0 {
                    ring[step] = here[walk];
                    here[walk] = surface.swing(here[walk]);
                    if here[walk] == first[walk] {
                        counts[walk] = step + 1;
                        open -= 1;
                    }
                }
            }
            if open == 0 {
                break;
            }
        }
        for (walk, &vertex) in vertices.iter().enumerate() {
            match counts[walk] {
                0 => self.corners.extend(surface.ring(vertex)),
                count => self.corners.extend_from_slice(&walks[walk][..count]),
            }
            self.ends.push(self.corners.len() as u32);
        }
    }

    /// Looks up the grid coordinates of all neighbors in one pass, so that cache misses overlap.
    pub(crate) fn look_up_neighbors(&mut self, surface: &Surface, grid_points: &[[i32; 3]]) {
        self.neighbors.clear();
        self.neighbors.extend(self.corners.iter().map(|&corner| {
            let vertex = surface.vertex(next(corner));
            Neighbor { vertex, grid_point: grid_points[vertex as usize] }
        }));
    }

    /// Range of the corners around one of the vertices, by its index in the list.
    #[inline]
    fn range(&self, at: usize) -> std::ops::Range<usize> {
        let first = at.checked_sub(1).map_or(0, |before| self.ends[before] as usize);
        first..self.ends[at] as usize
    }

    /// Returns the neighbors of one of the vertices in the order of its corners, after
    /// [`look_up_neighbors`](Self::look_up_neighbors).
    #[inline]
    pub(crate) fn neighbors(&self, at: usize) -> &[Neighbor] {
        &self.neighbors[self.range(at)]
    }

    /// Returns the corners around one of the vertices.
    #[inline]
    pub(crate) fn of(&self, at: usize) -> &[u32] {
        &self.corners[self.range(at)]
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::shapes;

    use super::*;
    use crate::topology::cutting::close;

    #[test]
    fn finds_the_same_rings_as_the_surface() {
        // The virtual vertex of a grid has more corners than an interleaved walk allows.
        let mesh = shapes::grid(9, 7);
        let surface = close(&mesh.triangles, mesh.positions.len()).surface;
        let vertices: Vec<u32> = (0..surface.vertex_count() as u32).collect();
        let grid_points: Vec<[i32; 3]> = vertices.iter().map(|&v| [7 * v as i32, 0, 0]).collect();
        assert!(surface.ring(0).count() > SHORT_RING);
        let mut rings = Rings::default();
        for vertices in [&vertices[..], &vertices[5..6], &[], &vertices[3..14]] {
            rings.find(&surface, vertices);
            rings.look_up_neighbors(&surface, &grid_points);
            for (at, &vertex) in vertices.iter().enumerate() {
                assert_eq!(rings.of(at), surface.ring(vertex).collect::<Vec<_>>());
                let around = rings.neighbors(at).iter().map(|n| (n.vertex, n.grid_point[0] as u32));
                let expected = surface.ring(vertex).map(|c| surface.vertex(next(c)));
                assert!(around.eq(expected.map(|v| (v, 7 * v))));
            }
        }
    }
}
