//! From a mesh to its simplification sequence: half-edge collapses ordered by cost.

mod options;

pub use options::{
    AttributeWeights, BoundaryRule, BuiltSequence, CollapseCost, Placement, SequenceOptions, Simplified,
    SimplifyError, SimplifyOptions, StopReason, Target,
};
