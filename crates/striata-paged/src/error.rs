//! Errors of reading paged files: damaged heads and pages, and places that cannot be read.

use crate::PageId;

/// Error of reading a paged file.
#[derive(Debug, thiserror::Error)]
pub enum PagedError {
    /// A page contradicts itself, or its bytes do not describe one.
    #[error("page of level {}, cell {}: {defect}", id.level, id.cell)]
    Page {
        /// The page.
        id: PageId,
        /// Defect of the page.
        defect: PageDefect,
    },
    /// The head of a file is damaged.
    #[error("the head is damaged: {0}")]
    Head(HeadDefect),
    /// Bytes of a page do not match its checksum, or are too few.
    #[error("page of level {}, cell {}: the checksum does not match", id.level, id.cell)]
    Checksum {
        /// The page.
        id: PageId,
    },
    /// Bytes of an image do not match its checksum, or are too few.
    #[error("image {index}: the checksum does not match")]
    ImageChecksum {
        /// Index of the image.
        index: u32,
    },
    /// Pages do not fit together.
    #[error("page of level {}, cell {}: {reason}", id.level, id.cell)]
    Mismatch {
        /// The page.
        id: PageId,
        /// Reason in words.
        reason: &'static str,
    },
    /// Bytes cannot be read.
    #[error("{place}: {source}")]
    Io {
        /// File or address.
        place: String,
        /// Error of the system.
        source: std::io::Error,
    },
    /// Pages do not form a sequence of levels.
    #[error("the pages do not form a mesh: {0}")]
    Sequence(#[from] striata::mesh::SequenceError),
    /// An address needs a feature that is off.
    #[error("{address}: this build cannot read it: the feature `{feature}` is off")]
    FeatureOff {
        /// The address.
        address: String,
        /// Cargo feature of `striata-paged`.
        feature: &'static str,
    },
}

impl PagedError {
    /// The page that is damaged; [`None`] for errors that concern more than one page.
    pub fn page(&self) -> Option<PageId> {
        match self {
            Self::Page { id, .. } | Self::Checksum { id } | Self::Mismatch { id, .. } => Some(*id),
            _ => None,
        }
    }
}

/// Defect of a head.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum HeadDefect {
    /// The bytes end early.
    #[error("it is cut off")]
    Truncated,
    /// It is another kind of file.
    #[error("it does not begin like a paged file")]
    Magic,
    /// It is of another version.
    #[error("it has version {0}, but only version 1 is known")]
    Version(u32),
    /// A checksum does not match.
    #[error("the checksum of the {0} does not match")]
    Checksum(&'static str),
    /// Sizes contradict each other.
    #[error("its sizes contradict each other")]
    Sizes,
    /// A count is impossible.
    #[error("{0} is an impossible count")]
    Count(u64),
    /// A number is not finite.
    #[error("the directory has a number that is not finite")]
    NotFinite,
    /// A page is its own parent.
    #[error("page {page} of the directory has itself as a parent")]
    Parent {
        /// Index of the page.
        page: u32,
    },
    /// The metadata cannot be read.
    #[error("metadata: {0}")]
    Metadata(String),
}

impl From<HeadDefect> for PagedError {
    fn from(defect: HeadDefect) -> Self {
        Self::Head(defect)
    }
}

/// Defect of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PageDefect {
    /// The bytes end early.
    #[error("its bytes end within the counts")]
    Truncated,
    /// More is announced than the bytes can contain.
    #[error("{announced} {what} do not fit into its {byte_count} bytes")]
    TooMany {
        /// Name of the announced entries.
        what: &'static str,
        /// How many.
        announced: u64,
        /// Number of bytes of the page.
        byte_count: usize,
    },
    /// A list has the wrong length.
    #[error("{found} entries in the list of {what} instead of {expected}")]
    Length {
        /// The list.
        what: &'static str,
        /// Its length.
        found: usize,
        /// Length that the other lists require.
        expected: usize,
    },
    /// An entry of a list is impossible.
    #[error("entry {index} of the list of {what} {reason}")]
    Entry {
        /// The list.
        what: &'static str,
        /// Number of the entry.
        index: usize,
        /// Why it is impossible.
        reason: &'static str,
    },
}
