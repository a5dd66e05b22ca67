//! The part of a collapse sequence that a model keeps: vertex ranges and targets.

use std::borrow::Cow;
use std::ops::Range;

use super::{ModelError, PackedVertices};
use crate::mesh::{CollapseSequence, LevelTable, PositionIndex};

/// For each step, the vertices that it restores and the targets that they collapse to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StepVertices<'a> {
    pub(crate) vertex_count: usize,
    pub(crate) base_vertex_count: u32,
    /// First vertex of each step, followed by the vertex count; empty if every step has exactly one vertex.
    /// Target of each vertex above the base, or empty if targets are not kept.
    pub(crate) firsts: Cow<'a, [u32]>,
    pub(crate) targets: Cow<'a, [u32]>,
}

impl StepVertices<'_> {
    /// Number of steps from the base mesh to the full mesh.
    #[inline]
    pub fn step_count(&self) -> usize {
        if self.firsts.is_empty() {
            self.vertex_count.saturating_sub(self.base_vertex_count as usize)
        } else {
            self.firsts.len() - 1
        }
    }

    /// Number of vertices of the full mesh.
    #[inline]
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// Number of vertices of the base mesh, which come first in refinement order.
    #[inline]
    pub fn base_vertex_count(&self) -> u32 {
        self.base_vertex_count
    }

    /// Number of stored 32-bit words: first vertices and targets.
    pub fn word_count(&self) -> usize {
        self.firsts.len() + self.targets.len()
    }

    /// Returns the vertices that a step restores.
    ///
    /// # Panics
    /// If the step does not exist and `firsts` is not empty.
    #[inline]
    pub fn of_step(&self, step: usize) -> Range<u32> {
        if self.firsts.is_empty() {
            let first = self.base_vertex_count + step as u32;
            first..first + 1
        } else {
            self.firsts[step]..self.firsts[step + 1]
        }
    }

    /// Number of vertices that a level shows.
    ///
    /// # Panics
    /// If the split count exceeds the step count.
    #[inline]
    pub fn count_at(&self, split_count: usize) -> usize {
        if self.firsts.is_empty() {
            let vertex_count = (self.base_vertex_count as usize).saturating_add(split_count);
            if vertex_count > self.vertex_count {
                self.no_such_level(split_count);
            }
            return vertex_count;
        }
        match self.firsts.get(split_count) {
            Some(&first) => first as usize,
            None => self.no_such_level(split_count),
        }
    }

    #[cold]
    fn no_such_level(&self, split_count: usize) -> ! {
        panic!("split count {split_count} of {}", self.step_count());
    }

    /// Returns the step that restores a vertex above the base.
    #[inline]
    pub(super) fn step_of(&self, vertex: u32) -> usize {
        if self.firsts.is_empty() {
            (vertex - self.base_vertex_count) as usize
        } else {
            self.firsts.partition_point(|&first| first <= vertex) - 1
        }
    }

    /// Returns the vertex that a vertex above the base collapses to.
    ///
    /// # Panics
    /// If the vertex does not exist or is in the base, or if targets are not kept.
    #[inline]
    pub fn target(&self, vertex: u32) -> u32 {
        self.targets[(vertex - self.base_vertex_count) as usize]
    }

    /// Checks that the first vertices match the number of steps.
    ///
    /// # Errors
    /// [`ModelError`] naming the first mismatch.
    pub(crate) fn check_firsts(&self, step_count: usize) -> Result<(), ModelError> {
        let vertex_count = self.vertex_count;
        let length = |what, found, expected| {
            if found == expected { Ok(()) } else { Err(ModelError::Length { what, found, expected }) }
        };
        if self.firsts.is_empty() {
            length("steps", (self.base_vertex_count as usize).saturating_add(step_count), vertex_count)?;
        } else {
            length("first vertices", self.firsts.len(), step_count + 1)?;
            length("vertices of the base", self.firsts[0] as usize, self.base_vertex_count as usize)?;
            length("vertices", self.firsts[step_count] as usize, vertex_count)?;
            if let Some(i) = self.firsts.windows(2).position(|w| w[0] >= w[1]) {
                let [found, expected] = [i + 1, i].map(|i| self.firsts[i] as usize);
                return Err(ModelError::Length { what: "first vertices", found, expected });
            }
        }
        Ok(())
    }

    /// Checks that the arrays match the number of steps, and that every vertex collapses to an older one.
    ///
    /// # Errors
    /// [`ModelError`] naming the first mismatch.
    pub(super) fn check(&self, step_count: usize, targets: &PackedVertices<'_>) -> Result<(), ModelError> {
        self.check_firsts(step_count)?;
        let base = self.base_vertex_count;
        let (found, expected) = (targets.len(), self.vertex_count - base as usize);
        if found != expected {
            return Err(ModelError::Length { what: "targets", found, expected });
        }
        for step in 0..step_count {
            let range = self.of_step(step);
            if range.clone().any(|v| targets.get((v - base) as usize) >= range.start) {
                return Err(ModelError::Record { step, reason: "collapses to a later vertex" });
            }
        }
        Ok(())
    }
}

impl StepVertices<'static> {
    /// Returns steps with one vertex each and no targets.
    pub fn one_per_step(base_vertex_count: u32, step_count: usize) -> Self {
        Self {
            vertex_count: base_vertex_count as usize + step_count,
            base_vertex_count,
            firsts: Cow::Borrowed(&[]),
            targets: Cow::Borrowed(&[]),
        }
    }

    /// Returns the vertices of the steps of `levels`, without targets.
    pub fn of_levels(levels: &LevelTable) -> Self {
        let positions = levels.positions();
        let firsts = &positions.first_vertices()[levels.base_position_count()..];
        let vertices = Self {
            vertex_count: positions.vertex_count(),
            base_vertex_count: levels.base_vertex_count() as u32,
            firsts: firsts.to_vec().into(),
            targets: Cow::Borrowed(&[]),
        };
        vertices.shortened()
    }
}

impl<'a> StepVertices<'a> {
    /// Returns the vertices and targets of the steps of a sequence, borrowed from it.
    pub fn of_sequence(sequence: &'a CollapseSequence) -> Self {
        let positions = sequence.positions();
        let firsts = &positions.first_vertices()[sequence.base_position_count()..];
        Self {
            vertex_count: positions.vertex_count(),
            base_vertex_count: sequence.base_vertex_count() as u32,
            firsts: if positions.is_identity() { [].as_slice().into() } else { firsts.into() },
            targets: sequence.targets().into(),
        }
    }

    /// Returns positions and their wedges. Base vertices that share a position cannot be recognized here,
    /// so each gets a position of its own.
    pub fn positions(&self) -> PositionIndex {
        let base = 0..self.base_vertex_count;
        let steps = (0..self.step_count()).map(|step| self.of_step(step).start);
        PositionIndex::from_first(base.chain(steps).chain([self.vertex_count as u32]).collect())
    }

    /// Drops the array of first vertices if it is redundant, that is, if each step has one vertex.
    pub(super) fn shortened(mut self) -> Self {
        if self.firsts.len() == 1 + self.vertex_count - self.base_vertex_count as usize {
            self.firsts = Cow::Borrowed(&[]);
        }
        self
    }

    /// Returns an owned copy without targets.
    pub fn without_targets(mut self) -> StepVertices<'static> {
        self.targets = Cow::Borrowed(&[]);
        self.into_owned()
    }

    /// Returns a copy that owns its arrays.
    pub fn into_owned(self) -> StepVertices<'static> {
        StepVertices {
            vertex_count: self.vertex_count,
            base_vertex_count: self.base_vertex_count,
            firsts: self.firsts.into_owned().into(),
            targets: self.targets.into_owned().into(),
        }
    }
}
