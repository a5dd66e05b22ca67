//! The corners around several vertices at once.
//!
//! Each step around a vertex waits for the one before, and mostly for memory. So several walks go on side by side: while one
//! waits, the others do too, and all are done in the time of one.

use crate::topology::surface::{NONE, Surface, next};

/// Walks that go on side by side.
const WALKS: usize = 12;
/// Corners of a walk that is done with others; longer ones go on by themselves.
const SHORT: usize = 16;

/// Corners around vertices, one after the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rings {
    corners: Vec<u32>,
    ends: Vec<u32>,
    neighbors: Vec<Neighbor>,
}

/// The next vertex of a corner of a ring.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Neighbor {
    pub(crate) vertex: u32,
    pub(crate) place: [i32; 3],
}

impl Rings {
    /// Finds the corners around vertices, each counter-clockwise from [`Surface::corner_of`].
    pub(crate) fn find(&mut self, surface: &Surface, vertices: &[u32]) {
        self.corners.clear();
        self.ends.clear();
        for vertices in vertices.chunks(WALKS) {
            self.find_few(surface, vertices);
        }
    }

    fn find_few(&mut self, surface: &Surface, vertices: &[u32]) {
        let mut walks = [[NONE; SHORT]; WALKS];
        let mut here = [NONE; WALKS];
        let mut counts = [0; WALKS];
        for (here, &vertex) in here.iter_mut().zip(vertices) {
            *here = surface.corner_of(vertex);
        }
        let first = here;
        let mut open = vertices.len();
        for step in 0..SHORT {
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

    /// Looks up where the neighbors of all vertices are: what one of them has to wait for, others have to as well.
    pub(crate) fn look(&mut self, surface: &Surface, places: &[[i32; 3]]) {
        self.neighbors.clear();
        self.neighbors.extend(self.corners.iter().map(|&corner| {
            let vertex = surface.vertex(next(corner));
            Neighbor { vertex, place: places[vertex as usize] }
        }));
    }

    /// Where the corners around one of the vertices lie.
    #[inline]
    fn range(&self, at: usize) -> std::ops::Range<usize> {
        let first = at.checked_sub(1).map_or(0, |before| self.ends[before] as usize);
        first..self.ends[at] as usize
    }

    /// The neighbors of one of the vertices that were looked up, in the order of its corners.
    #[inline]
    pub(crate) fn neighbors(&self, at: usize) -> &[Neighbor] {
        &self.neighbors[self.range(at)]
    }

    /// The corners around one of the vertices.
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
    fn rings_are_those_of_the_surface() {
        // The virtual vertex of a grid has more corners than go side by side.
        let mesh = shapes::grid(9, 7);
        let surface = close(&mesh.triangles, mesh.positions.len()).surface;
        let vertices: Vec<u32> = (0..surface.vertex_count() as u32).collect();
        let places: Vec<[i32; 3]> = vertices.iter().map(|&v| [7 * v as i32, 0, 0]).collect();
        assert!(surface.ring(0).count() > SHORT);
        let mut rings = Rings::default();
        for vertices in [&vertices[..], &vertices[5..6], &[], &vertices[3..14]] {
            rings.find(&surface, vertices);
            rings.look(&surface, &places);
            for (at, &vertex) in vertices.iter().enumerate() {
                assert_eq!(rings.of(at), surface.ring(vertex).collect::<Vec<_>>());
                let around = rings.neighbors(at).iter().map(|n| (n.vertex, n.place[0] as u32));
                let expected = surface.ring(vertex).map(|c| surface.vertex(next(c)));
                assert!(around.eq(expected.map(|v| (v, 7 * v))));
            }
        }
    }
}
