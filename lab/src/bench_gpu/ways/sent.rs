//! Models whose indices the CPU writes and uploads whole in every frame.

use std::ops::Range;

use striata::model::{LodModel, Topology};
use striata_render::gpu::{Drawing, Gpu, GpuIndices};

use super::super::bench_scene::BenchScene;
use super::way::{Way, whole};
use striata_command::failure::Failure;

/// A model whose list or strips are uploaded whole.
pub(super) struct Sent<M: LodModel> {
    model: M,
    state: M::State,
    scratch: Vec<u32>,
    sent: GpuIndices,
    drawn: Range<u32>,
}

impl<M: LodModel> Sent<M> {
    /// Wraps a model that shows the full mesh.
    ///
    /// # Errors
    /// If the GPU is out of memory.
    pub(super) fn new(bench: &BenchScene<'_>, model: M) -> Result<Self, Failure> {
        let (state, sent) = (model.new_state(), GpuIndices::new(bench.gpu, 0)?);
        Ok(Self { model, state, scratch: Vec::new(), sent, drawn: 0..0 })
    }
}

impl<M: LodModel> Way for Sent<M> {
    fn move_to(&mut self, split_count: usize) {
        self.model.move_to(&mut self.state, split_count);
    }

    fn send(&mut self, gpu: &Gpu) -> Result<(), Failure> {
        self.scratch.clear();
        self.model.indices_into(&self.state, &mut self.scratch);
        self.drawn = whole(self.scratch.len());
        Ok(self.sent.write(gpu, &self.scratch)?)
    }

    fn drawing(&self) -> Drawing<'_> {
        let (indices, groups) = (&self.sent, std::slice::from_ref(&self.drawn));
        match self.model.topology() {
            Topology::Triangles => Drawing::List { indices, groups },
            Topology::Strips => Drawing::Strips { indices, groups },
        }
    }

    fn index_count(&self) -> usize {
        self.drawn.len()
    }

    fn uploaded_bytes(&self) -> u64 {
        self.sent.uploaded_bytes()
    }

    fn gpu_bytes(&self) -> usize {
        4 * self.sent.capacity()
    }
}
