//! A run of batches of collapses on a surface in the writer's descent.

use std::ops::Range;

use striata::mesh::RefinableMesh;

use crate::topology::cutting::Closed;
use crate::topology::surface::{NONE, Surface, Undo, next, previous, triangle_of};
use crate::writer::defect::BatchDefect;
use crate::writer::level::{LevelTriangles, close_level};

/// A surface that is collapsed in batches.
#[derive(Debug)]
pub(crate) struct SurfaceStage {
    /// The surface at the coarse end. Its triangles and vertices keep the numbering of the fine end.
    pub surface: Surface,
    /// Position of each vertex that is not virtual.
    pub position_of_copy: Vec<u32>,
    /// Number of copies that are the first of their position. They precede the other copies and are in
    /// ascending order.
    first_copy_count: usize,
    /// Whether each position must not be removed.
    is_locked: Vec<bool>,
    /// For each vertex, the last batch, counted from 1, in which another vertex collapsed to it.
    kept_in: Vec<u32>,
    /// The mesh's triangle for each triangle that is not virtual.
    pub triangles: Vec<u32>,
    /// The collapses. They are in coarse to fine order after [`Self::finish`], and so are the lists below.
    pub undo: Vec<Undo>,
    /// Vertices of the corners of each patch before its collapse, stored consecutively; only if corners
    /// are tracked.
    patches: Vec<u32>,
    patch_begins: Vec<u32>,
    /// Range of the batches in this stage.
    batches: Range<usize>,
    /// First step of the sequence in this stage.
    pub first_step: u32,
    tracks_corners: bool,
}

impl SurfaceStage {
    /// Builds the surface of a level. The next batch to collapse is `batch_end - 1`.
    pub(crate) fn new(level: &LevelTriangles, refinable: &RefinableMesh, batch_end: usize) -> Self {
        let Closed { surface, vertex_of_copy, is_locked } = close_level(level, refinable);
        let first_copy_count = vertex_of_copy.windows(2).position(|w| w[1] <= w[0]);
        Self {
            kept_in: vec![0; surface.vertex_count()],
            surface,
            first_copy_count: first_copy_count.map_or(vertex_of_copy.len(), |last| last + 1),
            position_of_copy: vertex_of_copy,
            is_locked,
            triangles: level.alive.clone(),
            undo: Vec::new(),
            patches: Vec::new(),
            patch_begins: Vec::new(),
            batches: batch_end..batch_end,
            first_step: 0,
            tracks_corners: !refinable.sequence.positions().is_identity() || refinable.mesh.groups.len() > 1,
        }
    }

    /// Number of vertices that the surface currently has, including virtual ones.
    pub(crate) fn vertex_count(&self) -> usize {
        self.surface.vertex_count() - self.undo.len()
    }

    /// Range of the batches in this stage.
    pub(crate) fn batches(&self) -> Range<usize> {
        self.batches.clone()
    }

    /// Applies the collapses of a batch, the last one first. Returns false, and leaves the surface unchanged,
    /// if a step is not a valid collapse of a surface or depends on another step of the batch.
    ///
    /// # Errors
    /// [`BatchDefect::Wedges`] if a triangle would not become degenerate.
    pub(crate) fn collapse(
        &mut self,
        level: &mut LevelTriangles,
        refinable: &RefinableMesh,
        batch: usize,
        steps: Range<usize>,
    ) -> Result<bool, BatchDefect> {
        let before = self.undo.len();
        let sequence = &refinable.sequence;
        let base = sequence.base_position_count() as u32;
        for step in steps.clone().rev() {
            let position = base + step as u32;
            let target =
                sequence.positions().position_of(sequence.target(sequence.step_vertices(step).start));
            let found = self.find(position, target).filter(|&corner| {
                let mark = batch as u32 + 1;
                let kept = self.surface.vertex(next(corner)) as usize;
                let is_free = std::mem::replace(&mut self.kept_in[kept], mark) != mark;
                is_free && self.mark_ring(corner, mark)
            });
            let Some(corner) = found else {
                while self.undo.len() > before {
                    let undo = self.undo.pop();
                    undo.iter().for_each(|undo| self.surface.undo_collapse(undo));
                }
                return Ok(false);
            };
            let undo = self.surface.collapse(corner);
            self.undo.push(undo);
        }
        for (at, step) in (before..self.undo.len()).zip(steps.clone().rev()) {
            self.check_removed(at, step, level, refinable)?;
            self.update_corners(at, level, refinable);
        }
        self.batches.start = batch;
        self.first_step = steps.start as u32;
        Ok(true)
    }

    /// Returns the corner from which a position's collapse to its target can be applied, if it can.
    fn find(&self, position: u32, target: u32) -> Option<u32> {
        if self.is_locked[position as usize] {
            return None;
        }
        let surface = &self.surface;
        let virtual_count = surface.virtual_count();
        // A position with one copy has the same index as the copy, relative to the used positions.
        let copy = self.copy_of(position)?;
        let is_target = |v: u32| {
            v.checked_sub(virtual_count).is_some_and(|copy| self.position_of_copy[copy as usize] == target)
        };
        let mut edges = surface.ring(virtual_count + copy).filter(|&c| is_target(surface.vertex(next(c))));
        // A second edge to the target would become a loop.
        let corner = edges.next()?;
        (edges.next().is_none() && can_collapse(surface, corner)).then_some(corner)
    }

    /// Returns the first copy of a position.
    fn copy_of(&self, position: u32) -> Option<u32> {
        let firsts = &self.position_of_copy[..self.first_copy_count];
        if firsts.get(position as usize) == Some(&position) {
            return Some(position);
        }
        firsts.binary_search(&position).ok().map(|copy| copy as u32)
    }

    /// Marks the triangles around a corner's vertex. Returns false if one of them already belongs to
    /// another step of the batch.
    fn mark_ring(&mut self, corner: u32, mark: u32) -> bool {
        let mut here = corner;
        loop {
            if self.surface.mark(triangle_of(here)) == mark {
                return false;
            }
            here = self.surface.swing(here);
            if here == corner {
                break;
            }
        }
        loop {
            self.surface.set_mark(triangle_of(here), mark);
            here = self.surface.swing(here);
            if here == corner {
                return true;
            }
        }
    }

    /// Checks that the triangles removed by a step become degenerate.
    ///
    /// # Errors
    /// [`BatchDefect::Wedges`] if one of them does not.
    fn check_removed(
        &self,
        at: usize,
        step: usize,
        level: &LevelTriangles,
        refinable: &RefinableMesh,
    ) -> Result<(), BatchDefect> {
        let undo = &self.undo[at];
        let virtual_count = self.surface.virtual_count();
        let position = |vertex: u32| self.position_of_copy[(vertex - virtual_count) as usize];
        let ends = [self.surface.vertex(undo.removed_corners[0]), undo.kept].map(position);
        let mut removed = undo.removed_corners.iter().filter_map(|&corner| self.mesh_corner(corner));
        let is_valid =
            !self.tracks_corners || removed.all(|(triangle, _)| level.vanishes(refinable, triangle, ends));
        is_valid.then_some(()).ok_or(BatchDefect::Wedges { step })
    }

    /// Updates the vertices of a patch's corners to their targets after a step.
    fn update_corners(&mut self, at: usize, level: &mut LevelTriangles, refinable: &RefinableMesh) {
        self.patch_begins.push(self.patches.len() as u32);
        if !self.tracks_corners {
            return;
        }
        let cut = self.undo[at].cut;
        let mut corner = cut.first;
        for _ in 0..cut.length {
            let shown = self.mesh_corner(corner).map(|(t, i)| &mut level.shown[t as usize][i]);
            self.patches.push(shown.as_ref().map_or(NONE, |shown| **shown));
            if let Some(shown) = shown {
                *shown = refinable.sequence.target(*shown);
            }
            corner = self.surface.swing(corner);
        }
    }

    /// Returns the mesh's triangle at a corner, and the index of the corner in it; `None` for virtual
    /// triangles.
    pub(crate) fn mesh_corner(&self, corner: u32) -> Option<(u32, usize)> {
        let triangle = self.triangles.get(triangle_of(corner) as usize)?;
        Some((*triangle, (corner & 3) as usize))
    }

    /// Ends the stage and updates the level to match the surface.
    pub(crate) fn finish(&mut self, level: &mut LevelTriangles) {
        self.undo.reverse();
        self.patch_begins.reverse();
        let mut removed: Vec<u32> = self
            .undo
            .iter()
            .flat_map(|undo| undo.removed_corners)
            .filter_map(|c| Some(self.mesh_corner(c)?.0))
            .collect();
        removed.sort_unstable();
        level.alive.retain(|t| removed.binary_search(t).is_err());
        if self.tracks_corners {
            return;
        }
        // Vertices are positions, so the triangles can be read off the surface.
        let virtual_count = self.surface.virtual_count();
        let mut alive = level.alive.iter().peekable();
        for (fine, triangle) in (0..).zip(&self.triangles) {
            if alive.next_if(|t| *t == triangle).is_some() {
                let corners = self.surface.triangle(fine);
                let shown = corners.map(|v| self.position_of_copy[(v - virtual_count) as usize]);
                level.shown[*triangle as usize] = shown;
            }
        }
    }

    /// Returns the vertices of a patch's corners before its step; empty if corners are not tracked.
    pub(crate) fn patch(&self, at: usize) -> &[u32] {
        let first = self.patch_begins[at] as usize;
        let length = if self.tracks_corners { self.undo[at].cut.length as usize } else { 0 };
        &self.patches[first..first + length]
    }

    /// Whether a surface built from the level's triangles joins them in the same way as this one.
    pub(crate) fn matches_rebuilt(&self, level: &LevelTriangles, refinable: &RefinableMesh) -> bool {
        let rebuilt = close_level(level, refinable).surface;
        let mut index = vec![NONE; self.triangles.len()];
        let mut alive = level.alive.iter().zip(0..).peekable();
        for (fine, triangle) in self.triangles.iter().enumerate() {
            if let Some((_, new)) = alive.next_if(|(t, _)| *t == triangle) {
                index[fine] = new;
            }
        }
        let real = |corner: u32| index.get(triangle_of(corner) as usize).copied();
        (0..self.triangles.len() as u32).filter(|&t| index[t as usize] != NONE).all(|t| {
            (4 * t..4 * t + 3).all(|corner| {
                let across = self.surface.opposite(corner);
                let found = rebuilt.opposite(4 * index[t as usize] + (corner & 3));
                match real(across) {
                    Some(triangle) => found == 4 * triangle + (across & 3),
                    None => triangle_of(found) as usize >= level.alive.len(),
                }
            })
        })
    }
}

/// Whether the ring around a corner's vertex allows a collapse: it is simple and large enough, and the vertex
/// does not leave a boundary.
fn can_collapse(surface: &Surface, corner: u32) -> bool {
    let mut ring = Vec::with_capacity(8);
    let mut here = corner;
    loop {
        let vertex = surface.vertex(next(here));
        if ring.contains(&vertex) {
            return false;
        }
        ring.push(vertex);
        here = surface.swing(here);
        if here == corner {
            break;
        }
    }
    // Ring: u, r0, .., rk. Only r0 or rk may be virtual.
    if ring.len() < 3 || ring[2..ring.len() - 1].iter().any(|&v| surface.is_virtual(v)) {
        return false;
    }
    // At least one triangle must remain around the target next to the run that it receives.
    let outside = surface.opposite(previous(surface.swing(corner)));
    surface.vertex(outside) != ring[0] || ring.len() != 3 || surface.ring(ring[0]).count() != 3
}
