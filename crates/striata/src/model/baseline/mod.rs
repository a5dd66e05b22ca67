//! The models that ours are measured against, each with the data structures of its publication.
//!
//! A weak baseline makes every ratio against it worthless, so each is built as somebody would who wants it to win:
//! flat arrays, no allocation and no search in a move. What they show is what the oracle shows, at every level.

pub mod discrete_levels;
pub mod original_lod_strips;
pub mod progressive_meshes;
pub mod skip_strips;

mod repetitions;

pub use discrete_levels::{DiscreteLevels, DiscreteLevelsError, DiscreteLevelsState};
pub use original_lod_strips::{OriginalLodStrips, OriginalLodStripsState};
pub use progressive_meshes::{ProgressiveMeshes, ProgressiveMeshesState};
pub use skip_strips::{SkipStrips, SkipStripsState};
