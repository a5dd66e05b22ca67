//! Compression effort and format version of a stream.

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

/// Version of the stream format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum StreamVersion {
    /// Version 1: surface splits only. It can still be written, for readers that know no other version.
    One,
    /// Version 2, the current one: adds general batches.
    #[default]
    Two,
}

impl StreamVersion {
    /// Returns the version number stored in the header.
    pub fn number(self) -> u8 {
        match self {
            Self::One => 1,
            Self::Two => 2,
        }
    }
}
