//! Compression effort of a stream.

/// Compression effort: how much decoding time is spent on a smaller stream.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Effort {
    /// Simple models: the fastest to decode.
    Fast,
    /// Mixed models: a compromise of size and speed.
    #[default]
    Default,
    /// The strongest models: the smallest streams, the slowest to decode.
    Small,
}
