//! Why bytes are no sequence of patterns.

use striata::mesh::FragmentError;

/// What is wrong with bytes that should tell a sequence of fragments.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SequentialPatternsError {
    /// There are too few bytes.
    #[error("{what} take {needed} bytes, but {found} are left")]
    Short {
        /// What is missing.
        what: &'static str,
        /// Bytes that it takes at least.
        needed: u64,
        /// Bytes that there are.
        found: usize,
    },
    /// A number of the head cannot be.
    #[error("there are {found} {what}, but at most {limit} are possible")]
    Count {
        /// Of what.
        what: &'static str,
        /// The number.
        found: u64,
        /// The largest that is possible.
        limit: u64,
    },
    /// A triangle of the base is none of a surface.
    #[error("triangle {triangle} of the base {reason}")]
    Base {
        /// The triangle.
        triangle: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// A rule is none.
    #[error("rule {rule} {reason}")]
    Rule {
        /// The rule.
        rule: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// A fragment has no place.
    #[error("step {step} {reason}")]
    Step {
        /// The step.
        step: usize,
        /// What is wrong.
        reason: &'static str,
    },
    /// Something follows the last fragment.
    #[error("{bits} bits follow the last fragment, some of them set")]
    Trailing {
        /// How many.
        bits: usize,
    },
    /// The fragments do not follow each other.
    #[error(transparent)]
    Fragments(#[from] FragmentError),
}
