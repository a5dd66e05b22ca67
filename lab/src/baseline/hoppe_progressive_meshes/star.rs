//! The surface during the build: its faces, and the star of a vertex that is about to collapse.

use std::collections::HashMap;

use striata::mesh::{PositionIndex, RefinableMesh, is_proper};

use super::HoppeProgressiveMeshesError;
use super::faces::{HalfEdgeFaces, NONE, next, prev};

/// A manifold surface whose positions are removed one by one.
pub(super) struct CollapsingSurface<'r> {
    positions: &'r PositionIndex,
    /// Faces in the order of the mesh's triangles; removed ones keep their last corners.
    pub faces: HalfEdgeFaces,
    /// The split count from which each face is shown.
    pub shown_from: Vec<u32>,
    /// Half-edges that leave each position, possibly with some that no longer do.
    leaving: Vec<Vec<u32>>,
}

/// The faces around a position that collapses.
#[derive(Debug)]
pub(super) struct CollapseStar {
    /// First half-edge of each vanishing face, which leaves the position: toward the target in the left
    /// face, away from it in the right one; or [`NONE`].
    pub vanishing: [u32; 2],
    /// Half-edges that leave the position in the other faces, beginning next to the left face.
    pub run: Vec<u32>,
    /// After a border, those that begin next to the right face.
    pub second_run: Option<Vec<u32>>,
}

impl<'r> CollapsingSurface<'r> {
    /// # Errors
    /// If an edge is not that of an oriented manifold surface.
    pub(super) fn new(refinable: &'r RefinableMesh) -> Result<Self, HoppeProgressiveMeshesError> {
        let positions = refinable.sequence.positions();
        let triangles = &refinable.mesh.triangles;
        let is_shown = |triangle: &[u32; 3]| is_proper(triangle);
        let corners = triangles.as_flattened().to_vec();
        let mut surface = Self {
            positions,
            faces: HalfEdgeFaces { twins: vec![NONE; corners.len()], corners },
            shown_from: triangles.iter().map(|t| if is_shown(t) { 0 } else { u32::MAX }).collect(),
            leaving: vec![Vec::new(); positions.position_count()],
        };
        surface.pair()?;
        Ok(surface)
    }

    /// Pairs opposite half-edges, by position.
    fn pair(&mut self) -> Result<(), HoppeProgressiveMeshesError> {
        let mut half_edge_of = HashMap::new();
        for half_edge in 0..self.faces.corners.len() as u32 {
            let triangle = half_edge as usize / 3;
            if self.shown_from[triangle] != 0 {
                continue;
            }
            let ends = [half_edge, next(half_edge)].map(|h| self.position(h));
            self.leaving[ends[0] as usize].push(half_edge);
            if half_edge_of.insert(ends, half_edge).is_some() {
                return Err(HoppeProgressiveMeshesError::Edge { triangle, ends });
            }
            if let Some(&twin) = half_edge_of.get(&[ends[1], ends[0]]) {
                self.faces.link(half_edge, twin);
            }
        }
        Ok(())
    }

    /// The position that a half-edge leaves.
    pub(super) fn position(&self, half_edge: u32) -> u32 {
        self.positions.position_of(self.faces.corner(half_edge))
    }

    /// Finds the faces around a position and which of them vanish when it collapses to another.
    ///
    /// # Errors
    /// The reason why the faces are not those of a vertex split.
    pub(super) fn star(&mut self, position: u32, target: u32) -> Result<CollapseStar, &'static str> {
        let around = std::mem::take(&mut self.leaving[position as usize]);
        let is_here = |&h: &u32| self.shown_from[h as usize / 3] == 0 && self.position(h) == position;
        let around: Vec<u32> = around.into_iter().filter(is_here).collect();
        let only = |is_that: &dyn Fn(u32) -> bool| {
            let mut found = around.iter().copied().filter(|&h| is_that(h));
            match (found.next(), found.next()) {
                (found, None) => Ok(found.unwrap_or(NONE)),
                _ => Err("more than two of its triangles contain the target"),
            }
        };
        let left = only(&|h| self.position(next(h)) == target)?;
        let right = only(&|h| self.position(prev(h)) == target)?;
        if left == right {
            return Err("no triangle contains both, or one contains it twice");
        }
        let star = self.runs(left, right, around.len());
        let found = star.run.len() + star.second_run.as_ref().map_or(0, Vec::len);
        if found + star.vanishing.iter().filter(|&&face| face != NONE).count() != around.len() {
            return Err("its triangles are not one fan");
        }
        Ok(star)
    }

    /// Walks around a position from the vanishing faces, at most `limit` faces far.
    fn runs(&self, left: u32, right: u32, limit: usize) -> CollapseStar {
        let faces = &self.faces;
        let walk = |from: u32, turn: &dyn Fn(u32) -> u32, stop: u32| {
            let steps = std::iter::successors(Some(turn(from)), |&h| (h != NONE).then(|| turn(h)));
            let run: Vec<u32> = steps.take_while(|&h| h != NONE && h != stop).take(limit).collect();
            let is_closed = turn(run.last().copied().unwrap_or(from)) == stop && stop != NONE;
            (run, is_closed)
        };
        let forward = |h| faces.turned(h);
        let backward = |h| faces.turned_back(h);
        let vanishing = [left, right];
        if left == NONE {
            let (mut run, _) = walk(right, &backward, NONE);
            run.reverse();
            return CollapseStar { vanishing, run, second_run: None };
        }
        let (run, is_closed) = walk(left, &forward, right);
        let second_run = (right != NONE && !is_closed).then(|| walk(right, &backward, NONE).0);
        CollapseStar { vanishing, run, second_run }
    }

    /// Passes the half-edges of a run to the target, whose corners have been set, and removes the vanishing
    /// faces.
    pub(super) fn collapse(&mut self, star: &CollapseStar, step: usize, target: u32) {
        let [left, right] = star.vanishing;
        let faces = &mut self.faces;
        if left != NONE && right != NONE && faces.twin(prev(left)) == right {
            faces.link(faces.twin(next(left)), faces.twin(next(right)));
        } else {
            if left != NONE {
                faces.link(faces.twin(prev(left)), faces.twin(next(left)));
            }
            if right != NONE {
                faces.link(faces.twin(right), faces.twin(next(right)));
            }
        }
        for face in star.vanishing.into_iter().filter(|&face| face != NONE) {
            self.shown_from[face as usize / 3] = step as u32 + 1;
        }
        let run = star.run.iter().chain(star.second_run.iter().flatten());
        self.leaving[target as usize].extend(run);
    }
}
