//! The progressive stream: one compressed bitstream, coarse to fine, whose every prefix is a mesh.
//!
//! A base mesh is followed by vertex splits in batches. In each batch both sides walk the surface; a flag says whether a
//! vertex splits, a cut which of its triangles go to the new vertex; then the new vertices' places and attributes
//! are told relative to what is around them. The idea of sending fragments coarse to fine is that of \[KG98\] (3.1), with
//! the batches of \[PR00\]; connectivity is not stored by rules but predicted from the geometry that is there.

mod base;
mod chunks;
mod connectivity;
mod cutting;
mod growth;
mod hood;
mod positions;
mod refiner;
mod splits;
mod surface;
mod truth;
mod walk;

pub use chunks::BatchDefect;
pub use splits::StepDefect;

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

/// What can be wrong within a stream whose bytes are as they were written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum StreamDefect {
    /// A batch splits nothing, so that the stream would never end.
    #[error("batch {batch} splits no vertex")]
    EmptyBatch {
        /// The batch, from 1.
        batch: u32,
    },
}
