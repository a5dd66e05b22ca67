//! General batches: steps that are no splits of a surface.
//!
//! Where parts vanish, sheets touch, or more than two triangles meet at an edge, a step may bring any number of triangles, or
//! take any of a position's triangles over. Such steps come in batches of their own, one after another, told by the triangles at the
//! position that splits. After such a batch both sides build their surface anew from the triangles that are there. A mesh that needs no such steps pays nothing.
//!
//! | file | what it does |
//! | --- | --- |
//! | `complex.rs` | [`Complex`]: triangles by their positions |
//! | `step.rs` | [`KnownStep`], [`CodedStep`]: a step as a writer knows it, and as both sides see it |
//! | `model.rs` | which position splits, what moves, what comes, and where |
//! | `shown.rs` | what corners show |
//! | `stage.rs` | a general batch within the loop that both sides run |

mod complex;
mod model;
mod shown;
mod stage;
pub(crate) mod step;

use model::GeneralModel;
use shown::ShownModel;

use crate::entropy::{AdaptiveBit, AdaptiveNumber, Coder, Rate};

use complex::Complex;
use step::CodedStep;

/// What a refinement with general batches keeps beside its surface.
#[derive(Clone, Debug)]
pub(super) struct General {
    is_general: AdaptiveBit,
    count: AdaptiveNumber,
    model: GeneralModel,
    shown: ShownModel,
    /// Grid coordinates by position.
    places: Vec<[i32; 3]>,
    /// The triangles, during a general batch.
    complex: Complex,
    /// Steps of the batch that are still to come.
    left: u32,
    step: CodedStep,
}

impl General {
    /// Nothing learned; `places` are those of the base's positions.
    pub(super) fn new(places: Vec<[i32; 3]>) -> Self {
        Self {
            is_general: AdaptiveBit::new(Rate::Steady),
            count: AdaptiveNumber::new(1, Rate::Steady),
            model: GeneralModel::new(),
            shown: ShownModel::new(),
            places,
            complex: Complex::default(),
            left: 0,
            step: CodedStep::default(),
        }
    }

    /// Whether a general batch is under way.
    pub(super) fn is_under_way(&self) -> bool {
        self.left > 0
    }

    /// Notes where a position is that a split of the surface has brought.
    pub(super) fn push_place(&mut self, place: [i32; 3]) {
        self.places.push(place);
    }

    /// Codes of how many general steps the next batch is; 0 where it is one of the surface.
    fn begin<C: Coder>(&mut self, coder: &mut C, meant: u32) -> u32 {
        if !self.is_general.code(coder, meant > 0) {
            return 0;
        }
        self.model.begin_batch();
        self.count.unsigned(coder, 0, meant.wrapping_sub(1)).saturating_add(1)
    }
}
