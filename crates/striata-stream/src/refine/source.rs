//! What the loop of both sides asks a writer: what is to come, in the reader's numbers.

use std::ops::Range;

use crate::base::coder::BaseOrder;
use crate::base::mesh::Base;
use crate::general::step::{CodedStep, KnownStep};
use crate::layers::hood::LayerValues;
use crate::topology::surface::{Cut, Surface};

/// One side of a stream: a writer has a plan, a reader has none.
pub(crate) trait Source {
    /// What is to come, if that is known.
    fn plan(&self) -> Option<&dyn Plan>;

    /// Whoever follows what has been coded, if anyone has to.
    fn follower(&mut self) -> Option<&mut dyn Follower>;
}

/// A reader: nothing is known before it is read.
pub(crate) struct Unknown;

impl Source for Unknown {
    #[inline]
    fn plan(&self) -> Option<&dyn Plan> {
        None
    }

    #[inline]
    fn follower(&mut self) -> Option<&mut dyn Follower> {
        None
    }
}

/// What a writer knows of what is to come.
pub(crate) trait Plan {
    /// How a vertex splits in this batch, if it does.
    fn cut(&self, vertex: u32) -> Option<Cut>;

    /// The grid coordinates of a vertex.
    fn place(&self, vertex: u32) -> [i32; 3];

    /// Where a vertex is exactly, mesh units.
    fn exact(&self, vertex: u32) -> [f32; 3];

    /// The vertices, of the mesh that is given, of a position.
    fn wedges(&self, vertex: u32) -> Range<u32>;

    /// The vertex of the mesh that is given which a corner shows, if that is not one for each position.
    fn wedge(&self, corner: u32) -> u32;

    /// The vertex of the stream that a corner shows.
    fn vertex_at(&self, corner: u32) -> u32;

    /// The vertex of the stream that a vertex of the mesh that is given collapses to.
    fn target(&self, wedge: u32) -> u32;

    /// The group of a triangle.
    fn group(&self, triangle: u32) -> u32;

    /// All attribute layers, in the order of the mesh that is given.
    fn layers(&self) -> &[LayerValues];

    /// Steps of the batch that has begun, if it is a general one; else 0.
    fn general_count(&self) -> u32;
}

/// What a writer is informed of, so that its plan is in the reader's numbers.
pub(crate) trait Follower {
    /// The base is numbered anew.
    fn order_base(&mut self, base: &Base, order: &BaseOrder);

    /// The next vertices of the stream are those of a position of the base.
    fn name_base(&mut self, vertex: u32);

    /// The next vertices of the stream are these of the mesh that is given.
    fn name(&mut self, wedges: &[u32]);

    /// A batch begins.
    fn begin_batch(&mut self);

    /// A vertex has been split off another one.
    fn born(&mut self, vertex: u32, kept: u32);

    /// What the corners around a new vertex show is asked next: A's, those of its patch, B's.
    fn refine(&mut self, vertex: u32, corners: &[u32]);

    /// The next step of a general batch begins, and here is what is known of it.
    fn general_step(&mut self) -> KnownStep;

    /// That step has been done.
    fn born_general(&mut self, step: &CodedStep);

    /// A general batch has ended, and the surface has been built anew.
    fn rebuilt(&mut self, surface: &Surface);
}
