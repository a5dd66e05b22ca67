//! What a caller may ask of batches.

use crate::setters::setters;
use crate::simplify::options::{SequenceOptions, SimplifyError};

/// Options of [`build_batches`](super::build_batches).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct BatchOptions {
    /// What orders the collapses and what they must respect; `pair_distance` must be none or 0, since parts that do not touch
    /// cannot be split in batches.
    pub sequence: SequenceOptions,
    /// Whether there are general batches as well, whose collapses are done one after another and may be any: where the mesh is not
    /// manifold, and where the topology changes, as far as `sequence.topology` lets it. Default true; without them, the base of a
    /// mesh of many parts is large.
    pub general: bool,
    /// No general batch begins once this many triangles are left, since its steps take many bits; default 300.
    pub general_floor: usize,
    /// Each batch takes from the cheapest of the removable positions only: this share of them, over 0 and up to 1; default 0.35. Near the
    /// full mesh batches take up to twice as much, and once general batches have come 0.7 of it.
    /// More makes fewer, larger batches, which are coded in fewer bits, and worse levels.
    pub share: f64,
    /// Short edges go first, as if each brought an error of this over its own square, mesh units: what is left is more
    /// regular, which a coder foretells better. Default none. One to two steps of the grid that positions will be rounded
    /// to cost next to no error beside the rounding, on flat parts too, and save a twentieth of a stream.
    pub shape_step: Option<f64>,
    /// Most triangles around a removed position, those to the middle of a closed hole included, at least 3; default 7.
    pub max_valence: usize,
    /// Kept positions are discouraged from having more triangles than this; default 6.
    pub fair_valence: usize,
    /// What each triangle beyond [`Self::fair_valence`] adds to the cost of a collapse, as a share of it, at the full mesh;
    /// the share falls with the positions that are left. Default 1.5, and 0 lets valences be.
    pub valence_weight: f64,
    /// Stop after a batch of fewer steps than this, since tiny batches cost more than they bring; default 4, and 1 goes on
    /// as far as it goes.
    pub least_batch: usize,
}

impl Default for BatchOptions {
    fn default() -> Self {
        Self {
            sequence: SequenceOptions::default(),
            general: true,
            general_floor: 300,
            share: 0.35,
            shape_step: None,
            max_valence: 7,
            fair_valence: 6,
            valence_weight: 1.5,
            least_batch: 4,
        }
    }
}

impl BatchOptions {
    /// Checks that every option is in its range.
    ///
    /// # Errors
    /// [`SimplifyError::Option`] naming the first that is not.
    pub fn check(&self) -> Result<(), SimplifyError> {
        self.sequence.check()?;
        let fail = |option, value: String, expected| Err(SimplifyError::Option { option, value, expected });
        if let Some(distance) = self.sequence.pair_distance.filter(|&d| d > 0.0) {
            return fail("pair_distance", distance.to_string(), "none or 0 where collapses come in batches");
        }
        if !(self.share > 0.0 && self.share <= 1.0) {
            return fail("share", self.share.to_string(), "over 0 and up to 1");
        }
        if let Some(step) = self.shape_step.filter(|step| !(*step >= 0.0 && step.is_finite())) {
            return fail("shape_step", step.to_string(), "a number of at least 0");
        }
        if !(self.valence_weight >= 0.0 && self.valence_weight.is_finite()) {
            return fail("valence_weight", self.valence_weight.to_string(), "a number of at least 0");
        }
        if self.max_valence < 3 {
            return fail("max_valence", self.max_valence.to_string(), "at least 3");
        }
        Ok(())
    }

    setters! {
        with_sequence, sequence: SequenceOptions;
        with_general, general: bool;
        with_general_floor, general_floor: usize;
        with_share, share: f64;
        with_shape_step, shape_step: Option<f64>;
        with_max_valence, max_valence: usize;
        with_fair_valence, fair_valence: usize;
        with_valence_weight, valence_weight: f64;
        with_least_batch, least_batch: usize;
    }
}
