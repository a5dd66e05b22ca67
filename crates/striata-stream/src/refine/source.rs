//! What the loop of both sides asks a writer: what is to come, in the reader's numbers.

use std::ops::Range;

use crate::base::coder::BaseOrder;
use crate::base::mesh::Base;
use crate::general::step::{CodedStep, KnownStep};
use crate::layers::hood::LayerValues;
use crate::topology::surface::{Cut, Surface};

/// What a writer knows of what is to come.
pub(crate) trait Source {
    /// The base is numbered anew.
    fn order_base(&mut self, base: &Base, order: &BaseOrder);
    /// A batch begins.
    fn begin_batch(&mut self);
    /// How a vertex splits in this batch, if it does.
    fn cut(&self, vertex: u32) -> Option<Cut>;
    /// A vertex has been split off another one.
    fn born(&mut self, vertex: u32, kept: u32);
    /// What the corners around a new vertex show is asked next: A's, those of its patch, B's.
    fn refine(&mut self, vertex: u32, corners: &[u32]);
    /// The vertex of the mesh that is given which a corner shows, where that is not one for each position.
    fn wedge(&self, corner: u32) -> u32;
    /// The vertex of the stream that a corner shows.
    fn vertex_at(&self, corner: u32) -> u32;
    /// The vertices, of the mesh that is given, of a position.
    fn wedges(&self, vertex: u32) -> Range<u32>;
    /// The vertex of the stream that a vertex of the mesh that is given collapses to.
    fn target(&self, wedge: u32) -> u32;
    /// The next vertices of the stream are these of the mesh that is given.
    fn name(&mut self, wedges: impl IntoIterator<Item = u32>);
    /// All attribute layers, in the order of the mesh that is given.
    fn layers(&self) -> &[LayerValues];
    /// The group of a triangle.
    fn group(&self, triangle: u32) -> u32;
    /// The grid coordinates of a vertex.
    fn place(&self, vertex: u32) -> [i32; 3];
    /// Where a vertex is exactly, mesh units.
    fn exact(&self, vertex: u32) -> [f32; 3];
    /// Steps of the batch that has begun, if it is a general one; else 0.
    fn general_count(&self) -> u32;
    /// The next step of a general batch.
    fn general_step(&mut self) -> KnownStep;
    /// That step has been done.
    fn born_general(&mut self, step: &CodedStep);
    /// A general batch has ended, and the surface has been built anew.
    fn rebuilt(&mut self, surface: &Surface);
}

/// A reader's source: nothing is known.
pub(crate) struct Unknown;

impl Source for Unknown {
    fn order_base(&mut self, _: &Base, _: &BaseOrder) {}
    fn begin_batch(&mut self) {}
    fn cut(&self, _: u32) -> Option<Cut> {
        None
    }
    fn born(&mut self, _: u32, _: u32) {}
    fn refine(&mut self, _: u32, _: &[u32]) {}
    fn wedge(&self, _: u32) -> u32 {
        0
    }
    fn vertex_at(&self, _: u32) -> u32 {
        0
    }
    fn wedges(&self, _: u32) -> Range<u32> {
        0..0
    }
    fn target(&self, _: u32) -> u32 {
        0
    }
    fn layers(&self) -> &[LayerValues] {
        &[]
    }
    fn name(&mut self, _: impl IntoIterator<Item = u32>) {}
    fn group(&self, _: u32) -> u32 {
        0
    }
    fn place(&self, _: u32) -> [i32; 3] {
        [0; 3]
    }
    fn exact(&self, _: u32) -> [f32; 3] {
        [0.0; 3]
    }
    fn general_count(&self) -> u32 {
        0
    }
    fn general_step(&mut self) -> KnownStep {
        KnownStep::default()
    }
    fn born_general(&mut self, _: &CodedStep) {}
    fn rebuilt(&mut self, _: &Surface) {}
}
