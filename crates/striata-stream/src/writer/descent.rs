//! The writer's way down: the full mesh is collapsed step by step, and each step remembers how to undo it.
//!
//! Batches whose steps are independent splits of the surface go down on it (`surface_stage.rs`). A batch of others goes down on the
//! triangles alone (`general_stage.rs`), and the surface is built anew below it, as a reader builds it anew above.

use std::ops::Range;

use striata::mesh::RefinableMesh;

use crate::format::form::StreamVersion;
use crate::writer::defect::BatchDefect;
use crate::writer::general_stage::GeneralStage;
use crate::writer::level::{LevelTriangles, check_base};
use crate::writer::surface_stage::SurfaceStage;

/// A stretch of the way.
#[derive(Debug)]
pub(crate) enum Stage {
    Surface(SurfaceStage),
    General(GeneralStage),
}

/// All of the way.
#[derive(Debug)]
pub(crate) struct Descent {
    /// Coarse to fine; the first one is a surface's, with the base.
    pub(crate) stages: Vec<Stage>,
    /// The vertices that the corners of each triangle of the mesh show at the coarsest level that has it.
    pub(crate) shown: Vec<[u32; 3]>,
    /// What a reader spends on each batch, at most: vertices and triangles looked at.
    pub(crate) visits: Vec<u64>,
}

/// What became of going down.
enum Attempt {
    Arrived(Descent),
    /// The surface of these batches is not what a reader would build.
    Differs(Range<usize>),
}

impl Descent {
    /// Goes down; `batches` are split counts at which batches begin, closed by the number of steps.
    ///
    /// # Errors
    /// Where the version knows no general batches and one would be needed.
    pub(crate) fn new(
        refinable: &RefinableMesh,
        batches: &[u32],
        version: StreamVersion,
    ) -> Result<Self, BatchDefect> {
        let mut must_be_general = vec![false; batches.len() - 1];
        // A surface that is built anew may differ from the one that was collapsed if the steps are not those of a simplifier that looks
        // at all copies of a position. Such batches are general ones, and the way begins again.
        loop {
            match Self::attempt(refinable, batches, (version, &must_be_general))? {
                Attempt::Arrived(descent) => return Ok(descent),
                Attempt::Differs(range) => must_be_general[range].fill(true),
            }
        }
    }

    fn attempt(
        refinable: &RefinableMesh,
        batches: &[u32],
        (version, must_be_general): (StreamVersion, &[bool]),
    ) -> Result<Attempt, BatchDefect> {
        let mut level = LevelTriangles::new(refinable);
        let mut stage = SurfaceStage::new(&level, refinable, batches.len() - 1);
        let mut stages = Vec::new();
        let mut visits = vec![0; batches.len() - 1];
        for batch in (0..batches.len() - 1).rev() {
            let steps = batches[batch] as usize..batches[batch + 1] as usize;
            let result = match must_be_general[batch] {
                true => Err(BatchDefect::Dependent { batch }),
                false => stage.collapse(&mut level, refinable, (batch, steps.clone())),
            };
            match result {
                Ok(()) => visits[batch] = stage.vertex_count() as u64,
                Err(defect @ BatchDefect::Wedges { .. }) => return Err(defect),
                Err(defect) if version == StreamVersion::One => return Err(defect),
                Err(_) => {
                    stage.finish(&mut level);
                    if !stage.batches().is_empty() && !stage.is_built_anew(&level, refinable) {
                        return Ok(Attempt::Differs(stage.batches()));
                    }
                    stages.push(Stage::Surface(stage));
                    let general = GeneralStage::new(&mut level, refinable, steps)?;
                    visits[batch] = general.visits;
                    stages.push(Stage::General(general));
                    stage = SurfaceStage::new(&level, refinable, batch);
                    visits[batch] += (stage.vertex_count() + level.alive.len()) as u64;
                }
            }
        }
        stage.finish(&mut level);
        check_base(&level, refinable)?;
        stages.push(Stage::Surface(stage));
        stages.reverse();
        Ok(Attempt::Arrived(Self { stages, shown: level.shown, visits }))
    }

    /// Most triangles that a split of the surface moves.
    pub(crate) fn max_patch(&self) -> u32 {
        let undo = self.stages.iter().flat_map(|stage| match stage {
            Stage::Surface(stage) => stage.undo.as_slice(),
            Stage::General(_) => &[],
        });
        undo.map(|undo| undo.cut.length).max().unwrap_or(0)
    }

    /// Whether there are general batches.
    pub(crate) fn has_general(&self) -> bool {
        self.stages.len() > 1
    }
}
