//! Reasons why a mesh or its sequence cannot be encoded.

use striata::Cancelled;
use striata::file::EncodeError;
use striata::mesh::MeshError;

use crate::format::grid::GridError;
use crate::format::header::MAX_COMPONENTS;
use crate::layers::options::LayerBitsError;

/// Why a sequence does not consist of valid batches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BatchDefect {
    /// Below this level, a triangle would have two corners at one position.
    #[error("step {step} leaves a triangle with two corners at one position")]
    Wedges {
        /// Index of the step, coarse to fine.
        step: usize,
    },
    /// A position of the base mesh is not used by any triangle.
    #[error("position {position} of the base mesh is not used by any triangle")]
    UnusedPosition {
        /// Index of the position.
        position: usize,
    },
    /// The splits of a batch depend on each other.
    #[error("the steps of batch {batch} depend on each other")]
    Dependent {
        /// Index of the batch, coarse to fine.
        batch: usize,
    },
    /// The batches do not cover all steps in ascending order.
    #[error("the batch boundaries do not rise from 0 to the step count, {step_count}")]
    Cover {
        /// Number of steps in the sequence.
        step_count: usize,
    },
}

/// Why a mesh cannot be encoded as a stream.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StreamError {
    /// The mesh is invalid.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The requested position grid does not exist.
    #[error(transparent)]
    Grid(#[from] GridError),
    /// A layer has an invalid number of bits.
    #[error(transparent)]
    Layers(#[from] LayerBitsError),
    /// The steps do not form valid batches.
    #[error(transparent)]
    Batches(#[from] BatchDefect),
    /// The attribute layers have too many components.
    #[error(
        "the attribute layers have {number_count} components per vertex, but a stream can store at most {}",
        MAX_COMPONENTS
    )]
    Numbers {
        /// Number of integers that the stream would store for each vertex.
        number_count: usize,
    },
    /// Streams of fragments have no place for data of triangles.
    #[error("a stream of fragments cannot store data of triangles ({name})")]
    TriangleData {
        /// Name of the first layer.
        name: String,
    },
    /// A metadata text is too long.
    #[error(transparent)]
    Text(#[from] EncodeError),
    /// The progress callback asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
