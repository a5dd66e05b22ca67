//! General batches: vertex splits that are not splits of a closed surface.
//!
//! If parts vanish, sheets touch, or more than two triangles meet at an edge, a step may create any number
//! of triangles and move any of the split position's triangles to the new one. Such steps come in batches
//! of their own. They are coded one after another, relative to the triangles at the split position. After
//! such a batch, both sides rebuild their surface from the current triangles. A mesh that needs no such
//! steps pays nothing for them.
//!
//! | file | what it does |
//! | --- | --- |
//! | `complex.rs` | [`Complex`]: triangles indexed by position |
//! | `step.rs` | [`ReferenceStep`]: a step as the writer knows it; [`CodedStep`]: as both sides know it |
//! | `model.rs` | models of the split position, moved triangles, new triangles and new position |
//! | `wedges.rs` | models of the wedges and groups |
//! | `batch.rs` | coding a general batch within the loop that writer and reader share |

mod batch;
mod complex;
mod model;
pub(crate) mod step;
mod wedges;

use model::GeneralModel;
use wedges::GeneralWedgeModel;

use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Rate};

use complex::Complex;
use step::CodedStep;

/// State of general batches: the models, and the triangles while a batch is in progress.
#[derive(Clone, Debug)]
pub(super) struct GeneralBatches {
    is_general: AdaptiveBit,
    count: AdaptiveNumber,
    model: GeneralModel,
    wedges: GeneralWedgeModel,
    /// Grid coordinates of each position.
    grid_points: Vec<[i32; 3]>,
    /// The triangles, only during a general batch.
    complex: Complex,
    /// Number of steps left in the current batch.
    steps_left: u32,
    step: CodedStep,
}

impl GeneralBatches {
    /// Creates untrained models; `grid_points` are the grid coordinates of the base positions.
    pub(super) fn new(grid_points: Vec<[i32; 3]>) -> Self {
        Self {
            is_general: AdaptiveBit::new(Rate::Steady),
            count: AdaptiveNumber::new(1, Rate::Steady),
            model: GeneralModel::new(),
            wedges: GeneralWedgeModel::new(),
            grid_points,
            complex: Complex::default(),
            steps_left: 0,
            step: CodedStep::default(),
        }
    }

    /// Whether a general batch is in progress.
    pub(super) fn is_active(&self) -> bool {
        self.steps_left > 0
    }

    /// Appends the grid coordinates of a position created by a surface split.
    pub(super) fn push_grid_point(&mut self, grid_point: [i32; 3]) {
        self.grid_points.push(grid_point);
    }

    /// Codes the number of general steps of the next batch, or 0 if it is a batch of surface splits.
    fn begin<C: Coder>(&mut self, coder: &mut C, actual_count: u32) -> u32 {
        if !self.is_general.code(coder, actual_count > 0) {
            return 0;
        }
        self.model.begin_batch();
        self.count.unsigned(coder, 0, actual_count.wrapping_sub(1)).saturating_add(1)
    }
}
