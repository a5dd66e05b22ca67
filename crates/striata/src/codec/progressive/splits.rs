//! The writer's way down: the full surface is collapsed step by step, and each step remembers how to undo it.

use crate::mesh::RefinableMesh;

use super::cutting::Closed;
use super::shown::ShownDown;
use super::surface::{Surface, Undo, next, previous};

/// What keeps a step from being coded as a vertex split.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum StepDefect {
    /// The position is not manifold.
    #[error("its position is not manifold")]
    Locked,
    /// The position is not joined to its target by exactly one edge.
    #[error("it is not joined to its target by exactly one edge")]
    Edge,
    /// The triangles around the position do not form a simple ring, or too small a one.
    #[error("the triangles around it do not form a simple ring")]
    Ring,
    /// A boundary position leaves the boundary.
    #[error("it leaves the boundary")]
    Boundary,
}

/// Collapses a closed surface down to the base of a mesh's sequence; the undo of each step, coarse to fine. What
/// corners show is followed, if it is given.
///
/// # Errors
/// The first step, counted from the finest, that is no collapse of a manifold vertex along one edge.
pub(super) fn collapse_all(
    closed: &mut Closed,
    refinable: &RefinableMesh,
    mut shown: Option<&mut ShownDown>,
) -> Result<Vec<Undo>, (usize, StepDefect)> {
    let sequence = &refinable.sequence;
    let base = sequence.base_position_count() as u32;
    let mut undo = Vec::with_capacity(sequence.step_count());
    for step in (0..sequence.step_count()).rev() {
        let position = base + step as u32;
        let target = sequence.target(sequence.step_vertices(step).start);
        let target = sequence.positions().position_of(target);
        let step = collapse(closed, position, target).map_err(|defect| (step, defect))?;
        if let Some(shown) = &mut shown {
            shown.follow(&closed.surface, &step, refinable);
        }
        undo.push(step);
    }
    undo.reverse();
    Ok(undo)
}

fn collapse(closed: &mut Closed, position: u32, target: u32) -> Result<Undo, StepDefect> {
    if closed.is_locked[position as usize] {
        return Err(StepDefect::Locked);
    }
    let surface = &mut closed.surface;
    let virtual_count = surface.virtual_count();
    let vertex = virtual_count + position;
    let is_target = |v: u32| {
        v.checked_sub(virtual_count).is_some_and(|copy| closed.vertex_of_copy[copy as usize] == target)
    };
    let corner = {
        let mut edges = surface.ring(vertex).filter(|&c| is_target(surface.vertex(next(c))));
        match (edges.next(), edges.next()) {
            (Some(corner), None) => corner,
            _ => return Err(StepDefect::Edge),
        }
    };
    check_ring(surface, corner)?;
    Ok(surface.collapse(corner))
}

fn check_ring(surface: &Surface, corner: u32) -> Result<(), StepDefect> {
    let mut ring = Vec::with_capacity(8);
    let mut here = corner;
    loop {
        let vertex = surface.vertex(next(here));
        if ring.contains(&vertex) {
            return Err(StepDefect::Ring);
        }
        ring.push(vertex);
        here = surface.swing(here);
        if here == corner {
            break;
        }
    }
    // Ring: u, r0, .., rk. Only r0 or rk may stand for a boundary loop.
    if ring.len() < 3 {
        return Err(StepDefect::Ring);
    }
    if ring[2..ring.len() - 1].iter().any(|&v| surface.is_virtual(v)) {
        return Err(StepDefect::Boundary);
    }
    // What stays around the target must be a triangle at least beside the run that it takes over.
    let outside = surface.opposite(previous(surface.swing(corner)));
    if surface.vertex(outside) == ring[0] && ring.len() == 3 && surface.ring(ring[0]).count() == 3 {
        return Err(StepDefect::Ring);
    }
    Ok(())
}
