//! Options of simplification in batches.

use crate::setters::setters;
use crate::simplify::options::{SequenceOptions, SimplifyError};

/// Options of [`build_batches`](super::build_batches).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct BatchOptions {
    /// How collapses are ordered, and what they must respect. `pair_distance` must be none or 0, since
    /// merges of separate parts cannot be undone in batches.
    pub sequence: SequenceOptions,
    /// Whether to use general batches as well, whose collapses are applied one after another and may be
    /// of any kind: at non-manifold positions, and where the topology changes as far as
    /// `sequence.topology` allows. Default true; without them, a mesh of many parts has a large base.
    pub general: bool,
    /// No general batch begins once this many triangles are left, since its steps take many bits; default 8. In scenes of
    /// many parts, a first picture then takes half or a third of the bytes that it takes with 300, for about 1 % more of
    /// all bytes.
    pub general_floor: usize,
    /// Each batch selects only from the cheapest removable positions: this share of them, above 0 and
    /// at most 1; default 0.35. Batches near the full mesh use up to twice as much, and batches after
    /// the first general one 0.7 of it. A larger share gives fewer and larger batches, which are coded
    /// in fewer bits, but less accurate levels.
    pub share: f64,
    /// Collapse short edges first: each edge costs as much as an error of this size, in mesh units, over the
    /// square of its length. The remaining mesh is then more regular, which a coder predicts better. Default
    /// none. One to two steps of the grid to which positions will be rounded cost almost no error compared
    /// with the rounding, even in flat regions, and save a twentieth of a stream.
    pub shape_step: Option<f64>,
    /// Largest valence of a removed position, at least 3; default 7. At a boundary, the virtual
    /// triangles that close the hole count too.
    pub max_valence: usize,
    /// Valence above which kept positions add to the cost of a collapse; default 6.
    pub fair_valence: usize,
    /// Added cost for each triangle beyond [`Self::fair_valence`], as a share of the cost, at the full
    /// mesh; the share falls with the number of positions left. Default 1.5; 0 ignores valences.
    pub valence_weight: f64,
    /// Stop after a batch with fewer steps than this, since tiny batches cost more than they save;
    /// default 4. With 1, simplification goes on as far as possible.
    pub min_batch_size: usize,
}

impl Default for BatchOptions {
    fn default() -> Self {
        Self {
            sequence: SequenceOptions::default(),
            general: true,
            general_floor: 8,
            share: 0.35,
            shape_step: None,
            max_valence: 7,
            fair_valence: 6,
            valence_weight: 1.5,
            min_batch_size: 4,
        }
    }
}

impl BatchOptions {
    /// Checks that every option is within its range.
    ///
    /// # Errors
    /// [`SimplifyError::Option`] with the first option that is out of range.
    pub fn check(&self) -> Result<(), SimplifyError> {
        self.sequence.check()?;
        let fail = |option, value: String, expected| Err(SimplifyError::Option { option, value, expected });
        if let Some(distance) = self.sequence.pair_distance.filter(|&d| d > 0.0) {
            return fail("pair_distance", distance.to_string(), "none or 0 when simplifying in batches");
        }
        if !(self.share > 0.0 && self.share <= 1.0) {
            return fail("share", self.share.to_string(), "above 0 and at most 1");
        }
        if let Some(step) = self.shape_step.filter(|step| !(*step >= 0.0 && step.is_finite())) {
            return fail("shape_step", step.to_string(), "a finite number of at least 0");
        }
        if !(self.valence_weight >= 0.0 && self.valence_weight.is_finite()) {
            return fail("valence_weight", self.valence_weight.to_string(), "a finite number of at least 0");
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
        with_min_batch_size, min_batch_size: usize;
    }
}
