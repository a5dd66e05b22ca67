//! Levels whose detail varies over the mesh, made in one pass over the steps.
//!
//! Steps are undone from fine to coarse. One that is wanted is kept, and with it everything around it: a split
//! needs its whole ring. What is kept is therefore closed under dependencies, so the result has no cracks.

use striata::mesh::IndexedMesh;
use striata::view::{NormalCone, Part, Sphere};

use crate::Assembled;

const NONE: u32 = u32::MAX;

/// A level whose detail varies.
#[derive(Clone, Debug)]
pub struct Cut {
    /// The mesh, with the vertices of the assembled mesh that it uses.
    pub mesh: IndexedMesh,
    /// For each vertex of the mesh, the assembled vertex.
    pub source_vertex: Vec<u32>,
    /// Number of steps that are refined.
    pub refined_count: usize,
    /// Largest error of a step that is not refined, in mesh units.
    pub error: f32,
}

/// The triangles at each position while steps are undone.
struct Surface<'a> {
    assembled: &'a Assembled,
    corners: Vec<[u32; 3]>,
    is_alive: Vec<bool>,
    head: Vec<u32>,
    tail: Vec<u32>,
    next: Vec<u32>,
    star: Vec<u32>,
}

impl<'a> Surface<'a> {
    fn new(assembled: &'a Assembled) -> Self {
        let mesh = &assembled.refinable.mesh;
        let positions = assembled.refinable.sequence.positions();
        let mut surface = Self {
            assembled,
            corners: mesh.triangles.clone(),
            is_alive: vec![true; mesh.triangles.len()],
            head: vec![NONE; positions.position_count()],
            tail: vec![NONE; positions.position_count()],
            next: vec![NONE; 3 * mesh.triangles.len()],
            star: Vec::new(),
        };
        for (corner, &v) in (0..).zip(mesh.triangles.as_flattened()) {
            surface.link(positions.position_of(v), corner);
        }
        surface
    }

    fn link(&mut self, position: u32, corner: u32) {
        match self.tail[position as usize] {
            NONE => self.head[position as usize] = corner,
            last => self.next[last as usize] = corner,
        }
        self.tail[position as usize] = corner;
    }

    /// Finds the corners at a position.
    fn gather(&mut self, position: u32) {
        self.star.clear();
        let mut corner = std::mem::replace(&mut self.head[position as usize], NONE);
        self.tail[position as usize] = NONE;
        while corner != NONE {
            let next = std::mem::replace(&mut self.next[corner as usize], NONE);
            // Triangles that are gone leave the list, or hubs would be searched again and again.
            if self.is_alive[corner as usize / 3] {
                self.star.push(corner);
                self.link(position, corner);
            }
            corner = next;
        }
    }

    /// Squared length of the longest edge at the gathered position.
    fn radius_squared(&self, center: [f32; 3]) -> f32 {
        let positions = &self.assembled.refinable.mesh.positions;
        let ring = self.star.iter().flat_map(|&corner| self.corners[corner as usize / 3]);
        let squared = |v: u32| (0..3).map(|a| (positions[v as usize][a] - center[a]).powi(2)).sum::<f32>();
        ring.map(squared).fold(0.0, f32::max)
    }

    /// Undoes the step of the gathered position.
    fn collapse(&mut self) {
        let sequence = &self.assembled.refinable.sequence;
        let star = std::mem::take(&mut self.star);
        for &corner in &star {
            let t = corner as usize / 3;
            let slot = corner as usize % 3;
            let target = sequence.target(self.corners[t][slot]);
            self.corners[t][slot] = target;
            let at = self.corners[t].map(|v| sequence.positions().position_of(v));
            self.is_alive[t] = at[0] != at[1] && at[1] != at[2] && at[2] != at[0];
        }
        for &corner in &star {
            if !self.is_alive[corner as usize / 3] {
                continue;
            }
            let v = self.corners[corner as usize / 3][corner as usize % 3];
            self.next[corner as usize] = NONE;
            self.link(sequence.positions().position_of(v), corner);
        }
        self.star = star;
    }
}

impl Assembled {
    /// Makes the coarsest level that refines every step for which `is_wanted` says so, and what these need.
    ///
    /// A part has the position of the step, the length of the longest edge there as its radius, and the error of
    /// the surface without it.
    pub fn cut(&self, mut is_wanted: impl FnMut(&Part) -> bool) -> Cut {
        let sequence = &self.refinable.sequence;
        let base = sequence.base_position_count();
        let mut surface = Surface::new(self);
        let mut is_kept = vec![false; sequence.positions().position_count()];
        let (mut refined_count, mut error) = (0, 0.0f32);
        for step in (0..sequence.step_count()).rev() {
            let position = (base + step) as u32;
            surface.gather(position);
            let first = sequence.positions().first_vertex(position);
            let center = self.refinable.mesh.positions[first as usize];
            let radius = surface.radius_squared(center).sqrt();
            let part = Part {
                sphere: Sphere { center, radius },
                cone: NormalCone::ALL,
                error: self.step_errors[step],
            };
            if !is_kept[position as usize] && !is_wanted(&part) {
                error = error.max(part.error);
                surface.collapse();
                continue;
            }
            refined_count += 1;
            let target = sequence.positions().position_of(sequence.target(first));
            is_kept[target as usize] = true;
            for &corner in &surface.star {
                for v in surface.corners[corner as usize / 3] {
                    is_kept[sequence.positions().position_of(v) as usize] = true;
                }
            }
        }
        let (mesh, source_vertex) = self.mesh_of(&surface);
        Cut { mesh, source_vertex, refined_count, error }
    }

    /// The mesh of the triangles that are left.
    fn mesh_of(&self, surface: &Surface<'_>) -> (IndexedMesh, Vec<u32>) {
        let full = &self.refinable.mesh;
        let mut number = vec![NONE; full.positions.len()];
        for (corners, _) in surface.corners.iter().zip(&surface.is_alive).filter(|(_, is_alive)| **is_alive) {
            corners.iter().for_each(|&v| number[v as usize] = 0);
        }
        let used: Vec<u32> = (0..number.len() as u32).filter(|&v| number[v as usize] == 0).collect();
        for (new, &v) in (0..).zip(&used) {
            number[v as usize] = new;
        }
        let mut mesh = IndexedMesh {
            positions: used.iter().map(|&v| full.positions[v as usize]).collect(),
            layers: full.layers.iter().map(|layer| layer.gather(&used)).collect(),
            triangles: Vec::new(),
            groups: Vec::new(),
            appearance: full.appearance.clone(),
        };
        let push = |range: std::ops::Range<usize>, triangles: &mut Vec<[u32; 3]>| {
            let alive = range.filter(|&t| surface.is_alive[t]);
            triangles.extend(alive.map(|t| surface.corners[t].map(|v| number[v as usize])));
        };
        if full.groups.is_empty() {
            push(0..full.triangles.len(), &mut mesh.triangles);
        }
        for group in &full.groups {
            let first = mesh.triangles.len() as u32;
            push(group.range(), &mut mesh.triangles);
            let count = mesh.triangles.len() as u32 - first;
            mesh.groups.push(striata::mesh::TriangleGroup { first, count, ..group.clone() });
        }
        (mesh, used)
    }
}
