//! Lists and strips that the CPU edits and uploads.

use std::ops::Range;

use striata::model::{LodModel, LodStrips, LodStripsState};
use striata_gpu::{Drawing, Gpu, GpuIndices, GpuLodStrips, GpuMultiDraw};
use striata_lab::baseline::{ProgressiveMeshes, ProgressiveMeshesState};

use super::super::bench_scene::BenchScene;
use super::way::{Way, whole};
use striata_command::failure::Failure;

/// A progressive mesh whose triangle list is uploaded whole.
pub(super) struct SentList {
    model: ProgressiveMeshes,
    state: ProgressiveMeshesState,
    scratch: Vec<u32>,
    sent: GpuIndices,
    drawn: Range<u32>,
}

/// The strips of LodStrips, uploaded whole.
pub(super) struct SentStrips {
    model: LodStrips<'static>,
    state: LodStripsState,
    scratch: Vec<u32>,
    sent: GpuIndices,
    drawn: Range<u32>,
}

/// The strips of LodStrips, of which only the changed ranges are uploaded.
pub(super) struct ChangedStrips {
    model: LodStrips<'static>,
    state: LodStripsState,
    strips: GpuLodStrips,
    /// A draw command for each strip, if restarts are not drawn.
    draws: Option<GpuMultiDraw>,
}

impl SentList {
    pub(super) fn new(bench: &BenchScene<'_>) -> Result<Self, Failure> {
        let model = ProgressiveMeshes::build(&bench.refinable);
        let (state, sent) = (model.new_state(), GpuIndices::new(bench.gpu, 0)?);
        Ok(Self { model, state, scratch: Vec::new(), sent, drawn: 0..0 })
    }
}

impl SentStrips {
    pub(super) fn new(bench: &BenchScene<'_>) -> Result<Self, Failure> {
        let model = LodStrips::build(&bench.refinable, &bench.strips)?;
        let (state, sent) = (model.new_state(), GpuIndices::new(bench.gpu, 0)?);
        Ok(Self { model, state, scratch: Vec::new(), sent, drawn: 0..0 })
    }
}

impl ChangedStrips {
    pub(super) fn new(bench: &BenchScene<'_>, has_draws: bool) -> Result<Self, Failure> {
        let model = LodStrips::build(&bench.refinable, &bench.strips)?;
        let mut state = model.new_state();
        let strips = GpuLodStrips::new(bench.gpu, &model, &mut state)?;
        let draws = has_draws.then(|| GpuMultiDraw::new(bench.gpu, strips.buffer().strip_ranges().count()));
        Ok(Self { model, state, strips, draws: draws.transpose()? })
    }
}

impl Way for SentList {
    fn move_to(&mut self, gpu: &Gpu, split_count: usize) -> Result<(), Failure> {
        self.model.move_to(&mut self.state, split_count);
        self.scratch.clear();
        self.model.indices_into(&self.state, &mut self.scratch);
        self.drawn = whole(self.scratch.len());
        Ok(self.sent.write(gpu, &self.scratch)?)
    }

    fn drawing(&self) -> Drawing<'_> {
        Drawing::List { indices: &self.sent, groups: std::slice::from_ref(&self.drawn) }
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

impl Way for SentStrips {
    fn move_to(&mut self, gpu: &Gpu, split_count: usize) -> Result<(), Failure> {
        self.model.move_to(&mut self.state, split_count);
        self.scratch.clear();
        self.model.indices_into(&self.state, &mut self.scratch);
        self.drawn = whole(self.scratch.len());
        Ok(self.sent.write(gpu, &self.scratch)?)
    }

    fn drawing(&self) -> Drawing<'_> {
        Drawing::Strips { indices: &self.sent, groups: std::slice::from_ref(&self.drawn) }
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

impl Way for ChangedStrips {
    fn move_to(&mut self, gpu: &Gpu, split_count: usize) -> Result<(), Failure> {
        self.model.move_to(&mut self.state, split_count);
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
