//! The writer's descent: collapses the full mesh step by step and records how to undo each step.
//!
//! Batches of independent collapses of the surface are applied to the surface (`surface_stage.rs`). Other
//! batches are applied to the triangles alone (`general_stage.rs`). Below them, the surface is rebuilt in
//! the same way as a reader rebuilds it above them.

use std::ops::Range;

use striata::mesh::RefinableMesh;
use striata::{Progress, ProgressFn};

use crate::writer::defect::StreamError;
use crate::writer::general_stage::GeneralStage;
use crate::writer::level::{LevelTriangles, check_base};
use crate::writer::surface_stage::SurfaceStage;

/// A run of batches of the same kind.
#[derive(Debug)]
pub(crate) enum BatchRun {
    Surface(SurfaceStage),
    General(GeneralStage),
}

/// The complete descent.
#[derive(Debug)]
pub(crate) struct Descent {
    /// Stages from coarse to fine. The first one is a surface stage that ends with the base.
    pub stages: Vec<BatchRun>,
    /// Vertices of each triangle's corners at the coarsest level that contains the triangle.
    pub shown: Vec<[u32; 3]>,
    /// Upper bound on a reader's work for each batch, in visited vertices and triangles.
    pub visits: Vec<u64>,
}

/// Result of one attempt.
enum Attempt {
    Complete(Descent),
    /// In these batches, a reader would rebuild a different surface.
    SurfaceDiffers(Range<usize>),
}

impl Descent {
    /// Collapses the mesh. `batches` lists the split counts at which batches begin, followed by the
    /// number of steps.
    ///
    /// # Errors
    /// [`BatchDefect`](crate::writer::defect::BatchDefect) if a step is invalid; also if the callback cancels.
    pub(crate) fn new(
        refinable: &RefinableMesh,
        batches: &[u32],
        progress: &mut ProgressFn<'_>,
    ) -> Result<Self, StreamError> {
        let mut must_be_general = vec![false; batches.len() - 1];
        // A rebuilt surface may differ from the collapsed one if the sequence was not made by a
        // simplifier that considers all copies of a position. We turn the affected batches into general
        // ones and start again.
        loop {
            match Self::attempt(refinable, batches, &must_be_general, progress)? {
                Attempt::Complete(descent) => return Ok(descent),
                Attempt::SurfaceDiffers(range) => must_be_general[range].fill(true),
            }
        }
    }

    fn attempt(
        refinable: &RefinableMesh,
        batches: &[u32],
        must_be_general: &[bool],
        progress: &mut ProgressFn<'_>,
    ) -> Result<Attempt, StreamError> {
        let mut level = LevelTriangles::new(refinable);
        let mut stage = SurfaceStage::new(&level, refinable, batches.len() - 1);
        let mut stages = Vec::new();
        let mut visits = vec![0; batches.len() - 1];
        let step_count = refinable.sequence.step_count() as u64;
        for batch in (0..batches.len() - 1).rev() {
            let done = step_count.saturating_sub(u64::from(batches[batch + 1]));
            Progress { phase: "encode", done, total: 2 * step_count }.report(progress)?;
            let steps = batches[batch] as usize..batches[batch + 1] as usize;
            if !must_be_general[batch] && stage.collapse(&mut level, refinable, batch, steps.clone())? {
                visits[batch] = stage.vertex_count() as u64;
                continue;
            }
            stage.finish(&mut level);
            if !stage.batches().is_empty() && !stage.matches_rebuilt(&level, refinable) {
                return Ok(Attempt::SurfaceDiffers(stage.batches()));
            }
            stages.push(BatchRun::Surface(stage));
            let general = GeneralStage::new(&mut level, refinable, steps)?;
            visits[batch] = general.visits;
            stages.push(BatchRun::General(general));
            stage = SurfaceStage::new(&level, refinable, batch);
            visits[batch] += (stage.vertex_count() + level.alive.len()) as u64;
        }
        stage.finish(&mut level);
        check_base(&level, refinable)?;
        stages.push(BatchRun::Surface(stage));
        stages.reverse();
        Ok(Attempt::Complete(Self { stages, shown: level.shown, visits }))
    }

    /// Maximum number of triangles that a split of the surface moves.
    pub(crate) fn max_patch(&self) -> u32 {
        let undo = self.stages.iter().flat_map(|stage| match stage {
            BatchRun::Surface(stage) => stage.undo.as_slice(),
            BatchRun::General(_) => &[],
        });
        undo.map(|undo| undo.cut.length).max().unwrap_or(0)
    }

    /// Whether there are general batches.
    pub(crate) fn has_general(&self) -> bool {
        self.stages.len() > 1
    }
}
