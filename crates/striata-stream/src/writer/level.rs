//! The triangles of a level during the writer's descent.

use striata::mesh::RefinableMesh;

use crate::topology::cutting;
use crate::writer::defect::BatchDefect;

/// The triangles of a level, and the vertices that they refer to.
#[derive(Debug)]
pub(crate) struct LevelTriangles {
    /// Indices of the triangles that exist, ascending.
    pub alive: Vec<u32>,
    /// Vertices of each triangle of the mesh; for removed triangles, the last ones they had.
    pub shown: Vec<[u32; 3]>,
}

impl LevelTriangles {
    /// Starts with the full mesh.
    pub(crate) fn new(refinable: &RefinableMesh) -> Self {
        let shown = refinable.mesh.triangles.clone();
        Self { alive: (0..shown.len() as u32).collect(), shown }
    }

    /// Whether a triangle becomes degenerate when one of its positions collapses to another one.
    pub(crate) fn vanishes(&self, refinable: &RefinableMesh, triangle: u32, [from, to]: [u32; 2]) -> bool {
        let positions = self.positions(refinable, triangle);
        let corner = |wanted: u32| positions.iter().position(|&p| p == wanted);
        let (Some(from), Some(to)) = (corner(from), corner(to)) else { return false };
        let shown = self.shown[triangle as usize];
        refinable.sequence.target(shown[from]) == shown[to]
    }

    /// Returns the positions of a triangle.
    pub(crate) fn positions(&self, refinable: &RefinableMesh, triangle: u32) -> [u32; 3] {
        self.shown[triangle as usize].map(|v| refinable.sequence.positions().position_of(v))
    }
}

/// Checks that every position of the base is used, since the base is coded by its triangles.
///
/// # Errors
/// [`BatchDefect::UnusedPosition`] with the first unused position.
pub(crate) fn check_base(level: &LevelTriangles, refinable: &RefinableMesh) -> Result<(), BatchDefect> {
    let mut is_used = vec![false; refinable.sequence.base_position_count()];
    for &triangle in &level.alive {
        level.positions(refinable, triangle).iter().for_each(|&p| is_used[p as usize] = true);
    }
    match is_used.iter().position(|is_used| !is_used) {
        None => Ok(()),
        Some(position) => Err(BatchDefect::UnusedPosition { position }),
    }
}

/// Turns the triangles of a level into a closed surface.
pub(crate) fn close_level(level: &LevelTriangles, refinable: &RefinableMesh) -> cutting::Closed {
    let positions = refinable.sequence.positions();
    let of = |&t: &u32| level.shown[t as usize].map(|v| positions.position_of(v));
    let triangles: Vec<[u32; 3]> = level.alive.iter().map(of).collect();
    cutting::close_used(&triangles, positions.position_count())
}
