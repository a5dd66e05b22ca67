//! The surface while the model is built: triangles that know their neighbors, collapsed from the full mesh to the base.

use striata::mesh::{Adjacency, IndexedMesh};

use super::error::ViewDependentError;
use super::{NONE, turn_of};

/// A manifold surface that loses vertices.
pub(super) struct Surface {
    /// The triangles as they stand; those that are gone as they went.
    pub(super) corners: Vec<[u32; 3]>,
    /// Behind the side opposite of each corner: a triangle, or [`NONE`] at a border.
    pub(super) beside: Vec<[u32; 3]>,
    /// Some triangle of each vertex; [`NONE`] where there is none.
    triangle_at: Vec<u32>,
    /// Triangles of each vertex.
    valences: Vec<u32>,
    /// The step that last marked a vertex.
    marks: Vec<usize>,
    star: Vec<u32>,
    target_star: Vec<u32>,
}

/// What a collapse takes from the surface, and what it leaves beside.
pub(super) struct Taken {
    /// The triangle left of the edge from the target to the vertex, and the one right of it.
    pub(super) triangles: [u32; 2],
    /// Beside the left one at the target and at the vertex, beside the right one at the target and at the vertex.
    pub(super) beside: [u32; 4],
}

impl Surface {
    /// # Errors
    /// Where an edge is none of a manifold surface.
    ///
    /// # Panics
    /// If a triangle names a vertex that is not below the count.
    pub(super) fn new(mesh: &IndexedMesh) -> Result<Self, ViewDependentError> {
        let corners = mesh.triangles.clone();
        let mut beside = vec![[NONE; 3]; corners.len()];
        let adjacency = Adjacency::of_vertices(mesh);
        for edge in adjacency.edges() {
            match (edge.forward, edge.backward) {
                (&[a], &[b]) => {
                    for (side, other) in [(a, b), (b, a)] {
                        beside[side as usize / 3][(side as usize + 2) % 3] = other / 3;
                    }
                }
                (&[_], &[]) | (&[], &[_]) => {}
                _ => {
                    return Err(ViewDependentError::Edge {
                        ends: edge.ends,
                        triangle_count: edge.side_count(),
                    });
                }
            }
        }
        let vertices = 0..mesh.vertex_count() as u32;
        let triangle_at = |v| adjacency.corners(v).first().map_or(NONE, |corner| corner / 3);
        Ok(Self {
            corners,
            beside,
            triangle_at: vertices.clone().map(triangle_at).collect(),
            valences: vertices.map(|v| adjacency.corners(v).len() as u32).collect(),
            marks: vec![usize::MAX; mesh.vertex_count()],
            star: Vec::new(),
            target_star: Vec::new(),
        })
    }

    /// Collapses a vertex to its target.
    ///
    /// # Errors
    /// Why that does not lead from a manifold surface to a manifold surface.
    pub(super) fn collapse(&mut self, step: usize, vertex: u32, target: u32) -> Result<Taken, &'static str> {
        let (mut star, mut target_star) =
            (std::mem::take(&mut self.star), std::mem::take(&mut self.target_star));
        let is_closed =
            self.star_into(vertex, &mut star).ok_or("the triangles of the vertex are not one fan")?;
        let is_target_closed =
            self.star_into(target, &mut target_star).ok_or("the triangles of the target are not one fan")?;
        let taken = self.taken(&star, vertex, target)?;
        let taken_count = taken.triangles.iter().filter(|&&t| t != NONE).count();
        if taken_count == 2 && !is_closed && !is_target_closed {
            return Err("both lie on borders and their edge does not");
        }
        if self.common_neighbors(step, &star, &target_star, [vertex, target]) != taken_count {
            return Err("they have further neighbors in common");
        }
        self.take(&star, vertex, target, &taken);
        (self.star, self.target_star) = (star, target_star);
        Ok(taken)
    }

    /// Finds the triangles of a vertex in order; whether they close a ring. `None` where they are not one fan.
    fn star_into(&self, vertex: u32, out: &mut Vec<u32>) -> Option<bool> {
        out.clear();
        let first = self.triangle_at[vertex as usize];
        if first == NONE {
            return None;
        }
        let limit = self.valences[vertex as usize] as usize;
        let next = |triangle: u32, turn: usize| {
            let corner = turn_of(&self.corners[triangle as usize], vertex);
            self.beside[triangle as usize][(corner + turn) % 3]
        };
        let mut at = first;
        while at != NONE && out.len() < limit {
            out.push(at);
            at = next(at, 2);
            if at == first {
                return (out.len() == limit).then_some(true);
            }
        }
        at = next(first, 1);
        while at != NONE && out.len() < limit {
            out.push(at);
            at = next(at, 1);
        }
        (out.len() == limit && at == NONE).then_some(false)
    }

    fn taken(&self, star: &[u32], vertex: u32, target: u32) -> Result<Taken, &'static str> {
        let mut taken = Taken { triangles: [NONE; 2], beside: [NONE; 4] };
        for &triangle in star {
            let corners = &self.corners[triangle as usize];
            let corner = turn_of(corners, vertex);
            let beside = self.beside[triangle as usize];
            if corners[(corner + 2) % 3] == target {
                taken.triangles[0] = triangle;
                taken.beside[..2].copy_from_slice(&[beside[corner], beside[(corner + 2) % 3]]);
            } else if corners[(corner + 1) % 3] == target {
                taken.triangles[1] = triangle;
                taken.beside[2..].copy_from_slice(&[beside[corner], beside[(corner + 1) % 3]]);
            }
        }
        if taken.triangles == [NONE; 2] {
            return Err("no triangle has both");
        }
        for (side, &triangle) in taken.triangles.iter().enumerate() {
            let beside = &taken.beside[2 * side..2 * side + 2];
            if triangle != NONE && beside == [NONE; 2] {
                return Err("a triangle vanishes that hangs on no other");
            }
            if beside.iter().any(|&t| t != NONE && taken.triangles.contains(&t)) {
                return Err("the triangles that vanish share two edges");
            }
        }
        Ok(taken)
    }

    /// Vertices that are next to both.
    fn common_neighbors(&mut self, step: usize, star: &[u32], target_star: &[u32], ends: [u32; 2]) -> usize {
        for &triangle in star {
            self.corners[triangle as usize].iter().for_each(|&v| self.marks[v as usize] = step);
        }
        ends.iter().for_each(|&v| self.marks[v as usize] = usize::MAX);
        let mut count = 0;
        for &triangle in target_star {
            for &v in &self.corners[triangle as usize] {
                if std::mem::replace(&mut self.marks[v as usize], usize::MAX) == step {
                    count += 1;
                }
            }
        }
        count
    }

    fn take(&mut self, star: &[u32], vertex: u32, target: u32, taken: &Taken) {
        for &triangle in star {
            if taken.triangles.contains(&triangle) {
                for &v in &self.corners[triangle as usize] {
                    self.valences[v as usize] -= 1;
                }
            } else {
                let corner = turn_of(&self.corners[triangle as usize], vertex);
                self.corners[triangle as usize][corner] = target;
                self.valences[target as usize] += 1;
            }
        }
        for side in 0..2 {
            let [at_target, at_vertex] = [taken.beside[2 * side], taken.beside[2 * side + 1]];
            // The side of a triangle that ends where the vanished one stood, seen from the target.
            let mut join = |triangle: u32, turn: usize, other: u32| {
                if triangle != NONE {
                    let corner = turn_of(&self.corners[triangle as usize], target);
                    self.beside[triangle as usize][(corner + turn) % 3] = other;
                }
            };
            let turns = if side == 0 { [2, 1] } else { [1, 2] };
            join(at_target, turns[0], at_vertex);
            join(at_vertex, turns[1], at_target);
        }
        for &gone in taken.triangles.iter().filter(|&&t| t != NONE) {
            for v in self.corners[gone as usize] {
                if taken.triangles.contains(&self.triangle_at[v as usize]) {
                    let stays = |&&t: &&u32| t != NONE && self.corners[t as usize].contains(&v);
                    self.triangle_at[v as usize] = taken.beside.iter().find(stays).copied().unwrap_or(NONE);
                }
            }
        }
    }
}
