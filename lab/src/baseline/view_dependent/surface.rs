//! The surface during the build: triangles with adjacency, collapsed from the full mesh to the base.

use striata::mesh::{Adjacency, IndexedMesh};

use super::error::ViewDependentError;
use super::{NONE, corner_of};

/// A manifold surface whose vertices are removed one by one.
pub(super) struct ShrinkingSurface {
    /// Current corners of the triangles; removed ones keep their last corners.
    pub corners: Vec<[u32; 3]>,
    /// The neighbor opposite each corner, or [`NONE`] at a border.
    pub neighbors: Vec<[u32; 3]>,
    /// One triangle of each vertex, or [`NONE`].
    triangle_at: Vec<u32>,
    /// Number of triangles of each vertex.
    valences: Vec<u32>,
    /// The step that last marked each vertex.
    marks: Vec<usize>,
    star: Vec<u32>,
    target_star: Vec<u32>,
}

/// The triangles that a collapse removes, and their neighbors.
pub(super) struct Removed {
    /// The triangles left and right of the edge from the target to the vertex.
    pub triangles: [u32; 2],
    /// Neighbors of the left triangle at the target and at the vertex, then of the right triangle.
    pub neighbors: [u32; 4],
}

impl ShrinkingSurface {
    /// # Errors
    /// If an edge is not that of a manifold surface.
    ///
    /// # Panics
    /// If a triangle refers to a vertex beyond the vertex count.
    pub(super) fn new(mesh: &IndexedMesh) -> Result<Self, ViewDependentError> {
        let corners = mesh.triangles.clone();
        let mut neighbors = vec![[NONE; 3]; corners.len()];
        let adjacency = Adjacency::of_vertices(mesh);
        for edge in adjacency.edges() {
            match (edge.forward, edge.backward) {
                (&[a], &[b]) => {
                    for (side, other) in [(a, b), (b, a)] {
                        neighbors[side as usize / 3][(side as usize + 2) % 3] = other / 3;
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
            neighbors,
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
    /// The reason why the result would not be a manifold surface.
    pub(super) fn collapse(
        &mut self,
        step: usize,
        vertex: u32,
        target: u32,
    ) -> Result<Removed, &'static str> {
        let (mut star, mut target_star) =
            (std::mem::take(&mut self.star), std::mem::take(&mut self.target_star));
        let is_closed =
            self.star_into(vertex, &mut star).ok_or("the triangles of the vertex are not one fan")?;
        let is_target_closed =
            self.star_into(target, &mut target_star).ok_or("the triangles of the target are not one fan")?;
        let removed = self.removed(&star, vertex, target)?;
        let removed_count = removed.triangles.iter().filter(|&&t| t != NONE).count();
        if removed_count == 2 && !is_closed && !is_target_closed {
            return Err("both are on borders but their edge is not");
        }
        if self.common_neighbors(step, &star, &target_star, [vertex, target]) != removed_count {
            return Err("they have further neighbors in common");
        }
        self.remove(&star, vertex, target, &removed);
        (self.star, self.target_star) = (star, target_star);
        Ok(removed)
    }

    /// Lists the triangles of a vertex in order and returns whether they form a closed ring, or `None` if
    /// they are not one fan.
    fn star_into(&self, vertex: u32, out: &mut Vec<u32>) -> Option<bool> {
        out.clear();
        let first = self.triangle_at[vertex as usize];
        if first == NONE {
            return None;
        }
        let limit = self.valences[vertex as usize] as usize;
        let next = |triangle: u32, turn: usize| {
            let corner = corner_of(&self.corners[triangle as usize], vertex);
            self.neighbors[triangle as usize][(corner + turn) % 3]
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

    fn removed(&self, star: &[u32], vertex: u32, target: u32) -> Result<Removed, &'static str> {
        let mut removed = Removed { triangles: [NONE; 2], neighbors: [NONE; 4] };
        for &triangle in star {
            let corners = &self.corners[triangle as usize];
            let corner = corner_of(corners, vertex);
            let neighbors = self.neighbors[triangle as usize];
            if corners[(corner + 2) % 3] == target {
                removed.triangles[0] = triangle;
                removed.neighbors[..2].copy_from_slice(&[neighbors[corner], neighbors[(corner + 2) % 3]]);
            } else if corners[(corner + 1) % 3] == target {
                removed.triangles[1] = triangle;
                removed.neighbors[2..].copy_from_slice(&[neighbors[corner], neighbors[(corner + 1) % 3]]);
            }
        }
        if removed.triangles == [NONE; 2] {
            return Err("no triangle contains both");
        }
        for (side, &triangle) in removed.triangles.iter().enumerate() {
            let neighbors = &removed.neighbors[2 * side..2 * side + 2];
            if triangle != NONE && neighbors == [NONE; 2] {
                return Err("a triangle vanishes that has no neighbor");
            }
            if neighbors.iter().any(|&t| t != NONE && removed.triangles.contains(&t)) {
                return Err("the triangles that vanish share two edges");
            }
        }
        Ok(removed)
    }

    /// Number of vertices adjacent to both ends of the edge.
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

    fn remove(&mut self, star: &[u32], vertex: u32, target: u32, removed: &Removed) {
        for &triangle in star {
            if removed.triangles.contains(&triangle) {
                for &v in &self.corners[triangle as usize] {
                    self.valences[v as usize] -= 1;
                }
            } else {
                let corner = corner_of(&self.corners[triangle as usize], vertex);
                self.corners[triangle as usize][corner] = target;
                self.valences[target as usize] += 1;
            }
        }
        for side in 0..2 {
            let [at_target, at_vertex] = [removed.neighbors[2 * side], removed.neighbors[2 * side + 1]];
            // Connects the triangles across the vanished one, whose side is found relative to the target.
            let mut join = |triangle: u32, turn: usize, other: u32| {
                if triangle != NONE {
                    let corner = corner_of(&self.corners[triangle as usize], target);
                    self.neighbors[triangle as usize][(corner + turn) % 3] = other;
                }
            };
            let turns = if side == 0 { [2, 1] } else { [1, 2] };
            join(at_target, turns[0], at_vertex);
            join(at_vertex, turns[1], at_target);
        }
        for &gone in removed.triangles.iter().filter(|&&t| t != NONE) {
            for v in self.corners[gone as usize] {
                if removed.triangles.contains(&self.triangle_at[v as usize]) {
                    let stays = |&&t: &&u32| t != NONE && self.corners[t as usize].contains(&v);
                    self.triangle_at[v as usize] =
                        removed.neighbors.iter().find(stays).copied().unwrap_or(NONE);
                }
            }
        }
    }
}
