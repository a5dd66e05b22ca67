//! How a `Lod` is built.

use crate::simplify::SequenceOptions;

/// Options of [`Lod::build`](super::Lod::build).
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct LodOptions {
    /// How the mesh is simplified: cost, seams, boundaries, the smallest level. Default: [`SequenceOptions::default`].
    pub sequence: SequenceOptions,
    /// Whether the error of every level and view is a bound that holds at every point of the original; default `false`: an
    /// estimate. Bounds take several times as long to build.
    pub has_guaranteed_errors: bool,
}

impl LodOptions {
    /// Sets [`LodOptions::sequence`].
    #[must_use]
    pub fn with_sequence(mut self, sequence: SequenceOptions) -> Self {
        self.sequence = sequence;
        self
    }

    /// Sets [`LodOptions::has_guaranteed_errors`].
    #[must_use]
    pub fn with_guaranteed_errors(mut self, has_guaranteed_errors: bool) -> Self {
        self.has_guaranteed_errors = has_guaranteed_errors;
        self
    }
}
