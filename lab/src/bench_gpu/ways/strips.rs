//! Strips of LodStrips of which only the changed ranges are uploaded.

use striata::model::{LodModel, LodStrips, LodStripsState};
use striata_render::gpu::{Drawing, Gpu, GpuLodStrips, GpuMultiDraw};

use super::super::bench_scene::BenchScene;
use super::way::Way;
use striata_command::failure::Failure;

/// The strips of LodStrips, of which only the changed ranges are uploaded.
pub(super) struct ChangedStrips {
    model: LodStrips<'static>,
    state: LodStripsState,
    strips: GpuLodStrips,
    /// A draw command for each strip, if restarts are not drawn.
    draws: Option<GpuMultiDraw>,
}

impl ChangedStrips {
    pub(super) fn new(
        bench: &BenchScene<'_>,
        model: LodStrips<'static>,
        has_draws: bool,
    ) -> Result<Self, Failure> {
        let mut state = model.new_state();
        let strips = GpuLodStrips::new(bench.gpu, &model, &mut state)?;
        let draws = has_draws.then(|| GpuMultiDraw::new(bench.gpu, strips.buffer().strip_ranges().count()));
        Ok(Self { model, state, strips, draws: draws.transpose()? })
    }
}

impl Way for ChangedStrips {
    fn move_to(&mut self, split_count: usize) {
        self.model.move_to(&mut self.state, split_count);
    }

    fn send(&mut self, gpu: &Gpu) -> Result<(), Failure> {
        self.strips.follow(gpu, &self.model, &mut self.state);
        match &mut self.draws {
            Some(draws) => Ok(draws.write(gpu, self.strips.buffer().strip_ranges())?),
            None => Ok(()),
        }
    }

    fn drawing(&self) -> Drawing<'_> {
        match &self.draws {
            Some(draws) => Drawing::MultiStrips { indices: self.strips.indices(), draws },
            None => self.strips.drawing(),
        }
    }

    fn index_count(&self) -> usize {
        match self.draws {
            Some(_) => self.strips.buffer().strip_ranges().map(|strip| strip.len()).sum(),
            None => self.strips.buffer().group_ranges().map(|group| group.len()).sum(),
        }
    }

    fn uploaded_bytes(&self) -> u64 {
        self.strips.uploaded_bytes() + self.draws.as_ref().map_or(0, GpuMultiDraw::uploaded_bytes)
    }

    fn gpu_bytes(&self) -> usize {
        const DRAW_BYTES: usize = 20;
        let draws = self.draws.as_ref().map_or(0, |_| self.strips.buffer().strip_ranges().count());
        4 * self.strips.indices().capacity() + DRAW_BYTES * draws
    }
}
