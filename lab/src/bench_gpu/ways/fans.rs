//! Progressive fans, expanded to triangles by the CPU or by the GPU.

use striata::model::{FanForm, FanIndices, FanInstance, Fans, FansLevel, LodModel};
use striata_render::gpu::wgpu::CommandEncoder;
use striata_render::gpu::{Drawing, FanExtractor, Gpu, GpuFanInstance, GpuFans, GpuIndices};

use super::super::bench_scene::BenchScene;
use super::way::Way;
use striata_command::failure::Failure;

/// Fans that the CPU writes as a list or as strips and uploads whole.
pub(super) struct SentFans {
    fans: Fans,
    level: FansLevel,
    form: FanForm,
    expanded: FanIndices,
    sent: GpuIndices,
}

/// Fans that the GPU expands; only the set of refined steps is uploaded.
pub(super) struct ComputedFans<'s> {
    bench: &'s BenchScene<'s>,
    fans: Fans,
    extractor: FanExtractor,
    table: GpuFans,
    instance: GpuFanInstance,
    split_count: usize,
}

impl SentFans {
    pub(super) fn new(bench: &BenchScene<'_>, form: FanForm) -> Result<Self, Failure> {
        let fans = Fans::build(&bench.refinable);
        let (level, expanded) = (fans.new_state(), FanIndices::default());
        Ok(Self { fans, level, form, expanded, sent: GpuIndices::new(bench.gpu, 0)? })
    }
}

impl<'s> ComputedFans<'s> {
    pub(super) fn new(bench: &'s BenchScene<'_>) -> Result<Self, Failure> {
        let fans = Fans::build(&bench.refinable);
        let extractor = FanExtractor::new(bench.gpu);
        let table = GpuFans::upload(bench.gpu, &fans)?;
        let instance = GpuFanInstance::new(bench.gpu, &extractor, &table)?;
        let split_count = bench.step_count();
        Ok(Self { bench, fans, extractor, table, instance, split_count })
    }
}

impl Way for SentFans {
    fn move_to(&mut self, split_count: usize) {
        self.fans.move_to(&mut self.level, split_count);
    }

    fn send(&mut self, gpu: &Gpu) -> Result<(), Failure> {
        self.fans.emit_level_into(&self.level, self.form, &mut self.expanded);
        Ok(self.sent.write(gpu, &self.expanded.indices)?)
    }

    fn drawing(&self) -> Drawing<'_> {
        let (indices, groups) = (&self.sent, &self.expanded.group_ranges[..]);
        match self.form {
            FanForm::Triangles => Drawing::List { indices, groups },
            _ => Drawing::Strips { indices, groups },
        }
    }

    fn index_count(&self) -> usize {
        self.expanded.group_ranges.iter().map(|group| group.len()).sum()
    }

    fn uploaded_bytes(&self) -> u64 {
        self.sent.uploaded_bytes()
    }

    fn gpu_bytes(&self) -> usize {
        4 * self.sent.capacity()
    }
}

impl Way for ComputedFans<'_> {
    fn move_to(&mut self, split_count: usize) {
        self.split_count = split_count;
    }

    fn send(&mut self, gpu: &Gpu) -> Result<(), Failure> {
        self.instance.write(gpu, &FanInstance::uniform(&self.fans, self.split_count));
        Ok(())
    }

    fn extract(&self, encoder: &mut CommandEncoder) {
        self.extractor.extract(encoder, &self.instance);
    }

    fn drawing(&self) -> Drawing<'_> {
        self.instance.drawing()
    }

    fn index_count(&self) -> usize {
        3 * self.bench.refinable.sequence.triangle_count_at(self.split_count)
    }

    fn uploaded_bytes(&self) -> u64 {
        self.instance.uploaded_bytes()
    }

    fn gpu_bytes(&self) -> usize {
        self.table.bytes() + self.instance.bytes()
    }
}
