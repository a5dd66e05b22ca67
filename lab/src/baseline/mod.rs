//! Published models, as baselines: each follows its paper and is as fast as that allows.
//!
//! They show the same triangles over the same vertex buffer as the library's models, so that only the data
//! structures are compared.

pub mod discrete_levels;
pub mod efficient_lod_strips;
pub mod general_patterns;
pub mod hoppe_progressive_meshes;
pub mod loop_patterns;
pub mod multi_triangulation;
pub mod ordered_meshes;
pub mod original_lod_strips;
pub mod progressive_meshes;
pub mod published_fans;
pub mod sequential_patterns;
pub mod skip_strips;
pub mod view_dependent;

mod repetitions;
mod step_set;

pub use discrete_levels::{DiscreteLevels, DiscreteLevelsError, DiscreteLevelsState};
pub use efficient_lod_strips::{EfficientLodStrips, EfficientLodStripsState, Winding};
pub use general_patterns::{GeneralPatterns, GeneralPatternsState};
pub use hoppe_progressive_meshes::{
    HoppeProgressiveMeshes, HoppeProgressiveMeshesError, HoppeProgressiveMeshesState,
};
pub use loop_patterns::{LoopPatterns, LoopPatternsState};
pub use multi_triangulation::{MtQuery, MtTriangle, MultiTriangulation, MultiTriangulationState};
pub use ordered_meshes::{OrderedMeshes, OrderedMeshesState};
pub use original_lod_strips::{OriginalLodStrips, OriginalLodStripsState};
pub use progressive_meshes::{ProgressiveMeshes, ProgressiveMeshesState};
pub use published_fans::{
    PublishedChanges, PublishedFans, PublishedFansError, PublishedFansState, PublishedView, VertexCriterion,
};
pub use sequential_patterns::{
    SequentialDecoder, SequentialPatterns, SequentialPatternsError, decode_sequential,
};
pub use skip_strips::{SkipStrips, SkipStripsState};
pub use view_dependent::{Adapted, ViewDependentError, ViewDependentMeshes, ViewDependentState};
