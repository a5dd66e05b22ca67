//! Options for building a `Lod`.

use crate::simplify::SequenceOptions;

/// Options of [`Lod::build`](super::Lod::build).
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct LodOptions {
    /// How the mesh is simplified: cost, seams, boundaries, the coarsest level. Default:
    /// [`SequenceOptions::default`].
    pub sequence: SequenceOptions,
    /// Whether the error of every level and view is a guaranteed bound, which holds at every point of the
    /// original surface. Default `false`: errors are estimates. Computing bounds makes building several
    /// times slower.
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
