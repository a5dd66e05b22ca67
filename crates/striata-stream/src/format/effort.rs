//! Compression effort of a stream.

/// Compression effort: how much decoding time is spent on a smaller stream.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Effort {
    /// Simple models: three times as fast to decode. On lines above about 1 Mbit/s, a mesh is complete sooner than with
    /// [`Compact`](Self::Compact).
    #[default]
    Fast,
    /// Mixed models: streams that are 6 to 26 % smaller, for slow lines and for storage.
    Compact,
}
