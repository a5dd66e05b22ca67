//! The progressive stream: one compressed bitstream, coarse to fine, whose every prefix is a mesh.
//!
//! A base mesh is followed by vertex splits in batches. In each batch both sides walk the surface; a flag says whether a
//! vertex splits, a cut which of its triangles go to the new vertex; then the new vertices' places and attributes
//! are told relative to what is around them. The idea of sending fragments coarse to fine is that of \[KG98\] (3.1), with
//! the batches of \[PR00\]; connectivity is not stored by rules but predicted from the geometry that is there.

mod attributes;
mod base;
mod base_coder;
mod base_hood;
mod chunks;
mod connectivity;
mod cutting;
mod decode;
mod descent;
mod direction_model;
mod directions;
mod encode;
mod facts;
mod general;
mod general_order;
mod general_stage;
mod grid;
mod growth;
mod head;
mod hidden_wedges;
mod hood;
mod layer_history;
mod layer_hood;
mod layer_model;
mod layers;
mod least_squares;
mod mixed_number;
mod number_model;
mod order;
mod positions;
mod quick;
mod quick_cuts;
mod refiner;
mod residuals;
mod ring_fit;
mod rings;
mod source;
mod surface;
mod surface_stage;
mod tangents;
mod truth;
mod walk;
mod wedges;

pub use chunks::BatchDefect;
pub use decode::{StreamDecoder, StreamUpdate};
pub use encode::{
    EncodedStream, Precision, SHAPE_STEPS, StreamError, StreamOptions, StreamSizes, encode_stream,
};
pub use facts::StreamFacts;
pub use grid::GridError;
pub use head::STREAM_MAGIC;
pub use layers::{LayerBitsError, LayerOptions};
pub use surface::SurfaceDefect;
pub use surface_stage::StepDefect;

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

/// What can be wrong within a stream whose bytes are as they were written.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StreamDefect {
    /// There are so many batches of so few splits that reading them would take for ever.
    #[error("{batch_count} batches were read, and they are too many for so few splits")]
    Batches {
        /// Batches read.
        batch_count: u32,
    },
    /// The grid is none.
    #[error(transparent)]
    Grid(#[from] GridError),
    /// The stream ends before its base mesh does.
    #[error("it ends before the base mesh does")]
    NoBase,
    /// The base is no closed surface.
    #[error("the base mesh is no surface: {0}")]
    Base(#[from] SurfaceDefect),
    /// A position lies off the grid.
    #[error("position {position} lies off the grid")]
    Place {
        /// The position, in the order of the stream.
        position: usize,
    },
    /// Positions have more vertices than so few bytes can tell.
    #[error("chunk {chunk} tells of more vertices than its bytes can")]
    Wedges {
        /// The chunk, from 0, which holds the base.
        chunk: usize,
    },
    /// A chunk's bytes are damaged.
    #[error("chunk {chunk} at byte {offset} is damaged: checksum {found:08x}, expected {expected:08x}")]
    Checksum {
        /// The chunk, from 0, which holds the base.
        chunk: usize,
        /// Where it begins in the stream.
        offset: u64,
        /// Checksum of the bytes.
        found: u32,
        /// Checksum that the head holds.
        expected: u32,
    },
    /// What was decoded is not what the head promises.
    #[error("it gives {found} {what}, but its head says {expected}")]
    Count {
        /// What is counted.
        what: &'static str,
        /// What came.
        found: u64,
        /// What was promised.
        expected: u64,
    },
    /// A step brings a triangle that has two corners at one position.
    #[error("step {step} brings a triangle without three different corners")]
    Step {
        /// The step, from 0.
        step: usize,
    },
    /// A batch splits nothing, so that the stream would never end.
    #[error("batch {batch} splits no vertex")]
    EmptyBatch {
        /// The batch, from 1.
        batch: u32,
    },
}
