//! The interface through which the refinement loop obtains a writer's data, in the reader's numbering.

use std::ops::Range;

use crate::base::coder::BaseOrder;
use crate::base::mesh::Base;
use crate::general::step::{CodedStep, ReferenceStep};
use crate::layers::layer_neighborhood::LayerValues;
use crate::topology::surface::{Cut, Surface};

/// One side of a stream. A writer has input, a reader has none.
pub(crate) trait StreamSide {
    /// Returns the data to encode, or `None` in a reader.
    fn input(&self) -> Option<&dyn EncoderInput>;

    /// Returns the observer to notify of what has been coded, if there is one.
    fn observer(&mut self) -> Option<&mut dyn CodingObserver>;
}

/// The source of a reader, which knows nothing in advance.
pub(crate) struct ReaderSource;

impl StreamSide for ReaderSource {
    #[inline]
    fn input(&self) -> Option<&dyn EncoderInput> {
        None
    }

    #[inline]
    fn observer(&mut self) -> Option<&mut dyn CodingObserver> {
        None
    }
}

/// The data that a writer encodes. Vertices, corners and triangles are those of the reader's surface
/// unless stated otherwise.
pub(crate) trait EncoderInput {
    /// Returns how a vertex splits in this batch, if it does.
    fn cut(&self, vertex: u32) -> Option<Cut>;

    /// Returns the grid coordinates of a vertex.
    fn coords(&self, vertex: u32) -> [i32; 3];

    /// Returns the exact position of a vertex, in mesh units.
    fn exact(&self, vertex: u32) -> [f32; 3];

    /// Returns the source mesh's vertices at the position of a vertex.
    fn wedges(&self, vertex: u32) -> Range<u32>;

    /// Returns the source mesh's vertex that a corner refers to. Only used if some positions have several
    /// vertices.
    fn wedge(&self, corner: u32) -> u32;

    /// Returns the stream's vertex that a corner refers to.
    fn vertex_at(&self, corner: u32) -> u32;

    /// Returns the stream's vertex that a vertex of the source mesh collapses to.
    fn target(&self, wedge: u32) -> u32;

    /// Returns the group of a triangle.
    fn group(&self, triangle: u32) -> u32;

    /// Returns all attribute layers, in the vertex order of the source mesh.
    fn layers(&self) -> &[LayerValues];

    /// Returns the number of steps in the current batch if it is a general one, otherwise 0.
    fn general_count(&self) -> u32;
}

/// Receives notifications about what has been coded, so that a writer can map its data to the reader's
/// numbering.
pub(crate) trait CodingObserver {
    /// The base mesh has been reordered.
    fn order_base(&mut self, base: &Base, order: &BaseOrder);

    /// The next vertices of the stream are those at a position of the base mesh.
    fn name_base(&mut self, vertex: u32);

    /// The next vertices of the stream are these vertices of the source mesh.
    fn name(&mut self, wedges: &[u32]);

    /// A batch begins.
    fn begin_batch(&mut self);

    /// `vertex` has been split off `kept`.
    fn split_applied(&mut self, vertex: u32, kept: u32);

    /// The corners around a new vertex are about to be coded, in the order of A, its patch and B.
    fn refine(&mut self, vertex: u32, corners: &[u32]);

    /// The next step of a general batch begins. Returns the data to encode for it.
    fn general_step(&mut self) -> ReferenceStep;

    /// The current step of a general batch has been applied.
    fn general_step_applied(&mut self, step: &CodedStep);

    /// A general batch has ended, and the surface has been rebuilt.
    fn surface_rebuilt(&mut self, surface: &Surface);
}
