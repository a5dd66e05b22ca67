//! The error type of the decoder.

use striata::mesh::FragmentError;

/// Error of decoding a sequence of fragments.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SequentialPatternsError {
    /// The data is too short.
    #[error("{what} take {needed} bytes, but {found} are left")]
    Short {
        /// The part that is missing.
        what: &'static str,
        /// Minimum number of bytes it needs.
        needed: u64,
        /// Number of bytes left.
        found: usize,
    },
    /// A count in the header is impossible.
    #[error("there are {found} {what}, but at most {limit} are possible")]
    Count {
        /// The objects that are counted.
        what: &'static str,
        /// The count in the header.
        found: u64,
        /// The largest possible count.
        limit: u64,
    },
    /// A triangle of the base cannot be part of a surface.
    #[error("triangle {triangle} of the base {reason}")]
    Base {
        /// Index of the triangle.
        triangle: usize,
        /// The reason.
        reason: &'static str,
    },
    /// A rule is invalid.
    #[error("rule {rule} {reason}")]
    Rule {
        /// Index of the rule.
        rule: usize,
        /// The reason.
        reason: &'static str,
    },
    /// A fragment does not fit the previous level.
    #[error("step {step} {reason}")]
    Step {
        /// The step.
        step: usize,
        /// The reason.
        reason: &'static str,
    },
    /// Set bits follow the last fragment.
    #[error("{bits} bits follow the last fragment, some of them set")]
    Trailing {
        /// Number of bits that follow.
        bits: usize,
    },
    /// The fragments do not form a sequence.
    #[error(transparent)]
    Fragments(#[from] FragmentError),
}
