//! In which form a stream is coded.

/// How hard the coder tries.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Effort {
    /// Simple models, quickest to read.
    Fast,
    /// Good models.
    #[default]
    Default,
    /// The smallest files, slowest to read.
    Small,
}

/// What the bits of a stream mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum StreamVersion {
    /// The first one: splits of a surface only. It can still be written, for readers that know no other.
    One,
    /// The present one.
    #[default]
    Two,
}

impl StreamVersion {
    /// As the head of a stream has it.
    pub fn number(self) -> u8 {
        match self {
            Self::One => 1,
            Self::Two => 2,
        }
    }
}
