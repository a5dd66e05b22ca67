//! A batch of general steps in the writer's descent.

use std::ops::Range;

use striata::mesh::RefinableMesh;

use crate::topology::surface::NONE;
use crate::writer::defect::BatchDefect;
use crate::writer::level::LevelTriangles;

/// How to undo a step: ranges in the lists of its stage.
#[derive(Clone, Debug)]
pub(crate) struct GeneralUndo {
    /// The position that the step's position collapsed to.
    pub target: u32,
    moved: Range<u32>,
    removed: Range<u32>,
}

/// The steps of a general batch.
#[derive(Debug)]
pub(crate) struct GeneralStage {
    first_step: u32,
    /// Indices of the steps in the sequence, coarse to fine.
    pub steps: Vec<u32>,
    undo: Vec<GeneralUndo>,
    /// Corners that moved to the target, as `3 triangle + corner`, and their vertices before.
    moved: Vec<(u32, u32)>,
    /// Removed triangles, and the third position of each.
    removed: Vec<u32>,
    thirds: Vec<u32>,
    first_position: u32,
    /// Number of corners that a reader visits around positions.
    pub visits: u64,
}

/// Corners of triangles by position, as linked lists that may contain removed triangles.
struct Incidence {
    /// First corner in the list of each position.
    first: Vec<u32>,
    /// Next corner in the same list.
    next: Vec<u32>,
    /// Whether each triangle has been removed.
    is_removed: Vec<bool>,
    /// Number of corners at each position, without removed triangles.
    counts: Vec<u32>,
}

impl Incidence {
    fn new(level: &LevelTriangles, refinable: &RefinableMesh) -> Self {
        let position_count = refinable.sequence.positions().position_count();
        let mut incidence = Self {
            first: vec![NONE; position_count],
            next: vec![NONE; 3 * level.shown.len()],
            is_removed: vec![false; level.shown.len()],
            counts: vec![0; position_count],
        };
        for &t in &level.alive {
            let positions = level.positions(refinable, t);
            positions
                .into_iter()
                .zip(3 * t..)
                .for_each(|(position, corner)| incidence.push(position, corner));
        }
        incidence
    }

    /// Adds a corner to the list of a position.
    fn push(&mut self, position: u32, corner: u32) {
        let first = &mut self.first[position as usize];
        self.next[corner as usize] = std::mem::replace(first, corner);
        self.counts[position as usize] += 1;
    }

    /// Empties the list of a position and returns its corners, without removed triangles.
    fn take(&mut self, position: u32, out: &mut Vec<u32>) {
        out.clear();
        let mut corner = std::mem::replace(&mut self.first[position as usize], NONE);
        while corner != NONE {
            if !self.is_removed[corner as usize / 3] {
                out.push(corner);
            }
            corner = self.next[corner as usize];
        }
        self.counts[position as usize] = 0;
    }
}

impl GeneralStage {
    /// Applies the collapses of a batch, the last one first.
    ///
    /// # Errors
    /// [`BatchDefect::Wedges`] if a triangle would remain with two corners at one position.
    pub(crate) fn new(
        level: &mut LevelTriangles,
        refinable: &RefinableMesh,
        steps: Range<usize>,
    ) -> Result<Self, BatchDefect> {
        let sequence = &refinable.sequence;
        let base = sequence.base_position_count() as u32;
        let mut incidence = Incidence::new(level, refinable);
        let mut stage = Self {
            first_step: steps.start as u32,
            steps: Vec::new(),
            undo: Vec::new(),
            moved: Vec::new(),
            removed: Vec::new(),
            thirds: Vec::new(),
            first_position: base + steps.start as u32,
            visits: 0,
        };
        let mut corners = Vec::new();
        for step in steps.rev() {
            let position = base + step as u32;
            let target =
                sequence.positions().position_of(sequence.target(sequence.step_vertices(step).start));
            let (moved, removed) = (stage.moved.len() as u32, stage.removed.len() as u32);
            incidence.take(position, &mut corners);
            for &corner in &corners {
                let triangle = corner / 3;
                let positions = level.positions(refinable, triangle);
                if positions.contains(&target) {
                    if !level.vanishes(refinable, triangle, [position, target]) {
                        return Err(BatchDefect::Wedges { step });
                    }
                    incidence.is_removed[triangle as usize] = true;
                    stage.removed.push(triangle);
                    let third = positions.into_iter().find(|&p| p != position && p != target);
                    stage.thirds.push(third.unwrap_or(NONE));
                    for other in positions.into_iter().filter(|&p| p != position) {
                        incidence.counts[other as usize] -= 1;
                    }
                    continue;
                }
                let shown = &mut level.shown[triangle as usize][corner as usize % 3];
                stage.moved.push((corner, *shown));
                *shown = sequence.target(*shown);
                incidence.push(target, corner);
            }
            let (moved, removed) = (moved..stage.moved.len() as u32, removed..stage.removed.len() as u32);
            let ring = u64::from(incidence.counts[target as usize]);
            stage.visits += (1 + ring) * (1 + removed.len() as u64);
            stage.steps.push(step as u32);
            stage.undo.push(GeneralUndo { target, moved, removed });
        }
        level.alive.retain(|&t| !incidence.is_removed[t as usize]);
        stage.steps.reverse();
        stage.undo.reverse();
        Ok(stage)
    }

    /// Whether the stage begins at this split count.
    pub(crate) fn begins(&self, split_count: u32) -> bool {
        self.first_step == split_count
    }

    /// Returns the triangles that a step moves or adds.
    pub(crate) fn triangles(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        let undo = &self.undo[step as usize];
        let moved = self.moved(undo).iter().map(|moved| moved.0 / 3);
        moved.chain(self.removed(undo).iter().copied())
    }

    /// Returns the steps of this stage that add the positions that a step needs.
    pub(crate) fn needs(&self, step: u32) -> impl Iterator<Item = u32> + '_ {
        let undo = &self.undo[step as usize];
        let step_of = |position: u32| position.checked_sub(self.first_position).unwrap_or(NONE);
        let thirds = self.thirds[undo.removed.start as usize..undo.removed.end as usize].iter();
        let needed = thirds.copied().chain([undo.target]).map(step_of);
        needed.filter(|&other| (other as usize) < self.undo.len())
    }

    /// Returns how to undo one of the steps.
    pub(crate) fn undo(&self, at: usize) -> &GeneralUndo {
        &self.undo[at]
    }

    /// Returns the corners that a step moved, with their vertices before.
    pub(crate) fn moved(&self, undo: &GeneralUndo) -> &[(u32, u32)] {
        &self.moved[undo.moved.start as usize..undo.moved.end as usize]
    }

    /// Returns the triangles that a step removed.
    pub(crate) fn removed(&self, undo: &GeneralUndo) -> &[u32] {
        &self.removed[undo.removed.start as usize..undo.removed.end as usize]
    }
}
