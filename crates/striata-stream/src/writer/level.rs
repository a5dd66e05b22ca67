//! A level of the way down: the triangles that are there.

use striata::mesh::RefinableMesh;

use crate::topology::cutting;
use crate::writer::defect::BatchDefect;

/// The triangles of the mesh that a level has, and what they show.
#[derive(Debug)]
pub(crate) struct LevelTriangles {
    /// Those that are there, ascending.
    pub(crate) alive: Vec<u32>,
    /// Vertices of the corners of each triangle of the mesh; what they were last for those that are gone.
    pub(crate) shown: Vec<[u32; 3]>,
}

impl LevelTriangles {
    /// The full mesh.
    pub(crate) fn new(refinable: &RefinableMesh) -> Self {
        let shown = refinable.mesh.triangles.clone();
        Self { alive: (0..shown.len() as u32).collect(), shown }
    }

    /// Whether a triangle loses a corner where a position collapses to another one of its positions.
    pub(crate) fn vanishes(&self, refinable: &RefinableMesh, triangle: u32, [from, to]: [u32; 2]) -> bool {
        let positions = self.positions(refinable, triangle);
        let corner = |wanted: u32| positions.iter().position(|&p| p == wanted);
        let (Some(from), Some(to)) = (corner(from), corner(to)) else { return false };
        let shown = self.shown[triangle as usize];
        refinable.sequence.target(shown[from]) == shown[to]
    }

    /// The positions of a triangle.
    pub(crate) fn positions(&self, refinable: &RefinableMesh, triangle: u32) -> [u32; 3] {
        self.shown[triangle as usize].map(|v| refinable.sequence.positions().position_of(v))
    }
}

/// # Errors
/// Where a position of the base is in no triangle: a base is told by its triangles.
pub(crate) fn check_base(level: &LevelTriangles, refinable: &RefinableMesh) -> Result<(), BatchDefect> {
    let mut is_used = vec![false; refinable.sequence.base_position_count()];
    for &triangle in &level.alive {
        level.positions(refinable, triangle).iter().for_each(|&p| is_used[p as usize] = true);
    }
    match is_used.iter().position(|is_used| !is_used) {
        None => Ok(()),
        Some(position) => Err(BatchDefect::Lonely { position }),
    }
}

/// What is there of a mesh at a level, cut into a closed surface.
pub(crate) fn close_level(level: &LevelTriangles, refinable: &RefinableMesh) -> cutting::Closed {
    let positions = refinable.sequence.positions();
    let of = |&t: &u32| level.shown[t as usize].map(|v| positions.position_of(v));
    let triangles: Vec<[u32; 3]> = level.alive.iter().map(of).collect();
    cutting::close_used(&triangles, positions.position_count())
}
