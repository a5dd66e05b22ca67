//! Buffers that one instance of progressive fans owns on the GPU.

use std::ops::Range;

use bytemuck::cast_slice;
use striata::model::{FanIndices, FanInstance};
use wgpu::{BindGroup, Buffer, BufferUsages, CommandEncoder};

use crate::gpu::copy_back::copy_back;
use crate::gpu::device::Gpu;
use crate::gpu::drawing::Drawing;
use crate::gpu::fan_extractor::{Bindings, FanExtractor};
use crate::gpu::gpu_error::GpuError;
use crate::gpu::gpu_fans::GpuFans;
use crate::gpu::indices::COMMAND_WORDS;

/// Runs of changed words with fewer unchanged words than this between them are uploaded as one range, since
/// a write has a fixed cost of about this many words.
const JOIN_GAP: usize = 4096;

/// GPU buffers of one fan instance: the bits of its steps, the extracted indices, and the draw commands.
#[derive(Debug)]
pub struct GpuFanInstance {
    bits: Buffer,
    indices: Buffer,
    commands: Buffer,
    passes: [BindGroup; 3],
    /// Copy of the bits that are on the GPU.
    uploaded_words: Vec<u64>,
    block_count: u32,
    group_count: u32,
    bytes: usize,
    uploaded_bytes: u64,
}

impl GpuFanInstance {
    /// Creates an instance that shows the full mesh once it is [`extracted`](FanExtractor::extract).
    ///
    /// # Errors
    /// [`GpuError::TooLarge`] if a buffer exceeds the device's limit.
    pub fn new(gpu: &Gpu, extractor: &FanExtractor, table: &GpuFans) -> Result<Self, GpuError> {
        let uploaded_words = vec![0; table.step_count.div_ceil(64)];
        let capacity = 3 * table.triangle_count;
        let (storage, read) = (BufferUsages::STORAGE, BufferUsages::COPY_SRC);
        let words = |what, count: usize, usage| gpu.empty_buffer(what, 4 * count as u64, storage | usage);
        let bits = words("fan step bits", 2 * uploaded_words.len(), BufferUsages::COPY_DST)?;
        let arcs = words("fan arcs", table.fan_count, BufferUsages::empty())?;
        let sums = words("fan block sums", table.block_count as usize + 1, BufferUsages::empty())?;
        let indices = words("fan indices", capacity, BufferUsages::INDEX | read)?;
        let command_words = COMMAND_WORDS * table.group_count.max(1) as usize;
        let commands = words("fan draws", command_words, BufferUsages::INDIRECT | read)?;
        let bindings =
            Bindings { bits: &bits, arcs: &arcs, sums: &sums, indices: &indices, commands: &commands };
        let passes = extractor.bind(gpu, table, &bindings, capacity as u32)?;
        let buffers = [&bits, &arcs, &sums, &indices, &commands];
        let bytes = buffers.map(Buffer::size).iter().sum::<u64>() as usize;
        Ok(Self {
            passes,
            bits,
            indices,
            commands,
            uploaded_words,
            block_count: table.block_count,
            group_count: table.group_count,
            bytes,
            uploaded_bytes: 0,
        })
    }

    /// Uploads the bits that have changed: one per step, set if the step is collapsed.
    ///
    /// # Panics
    /// If the instance belongs to another table.
    pub fn write(&mut self, gpu: &Gpu, instance: &FanInstance) {
        let words = instance.words();
        assert_eq!(words.len(), self.uploaded_words.len(), "the instance belongs to another table");
        for Range { start, end } in changed_ranges(&self.uploaded_words, words) {
            let changed = &words[start..end];
            gpu.queue.write_buffer(&self.bits, 8 * start as u64, cast_slice(changed));
            self.uploaded_words[start..end].copy_from_slice(changed);
            self.uploaded_bytes += size_of_val(changed) as u64;
        }
    }

    /// Draw call for the extracted triangles. The shader learns their groups only if the device supports a
    /// first instance in indirect draws (`INDIRECT_FIRST_INSTANCE`).
    pub fn drawing(&self) -> Drawing<'_> {
        Drawing::Extracted {
            indices: &self.indices,
            commands: &self.commands,
            command_count: self.group_count,
        }
    }

    /// Bytes uploaded so far.
    pub fn uploaded_bytes(&self) -> u64 {
        self.uploaded_bytes
    }

    /// Size of the instance's buffers on the GPU, bytes.
    pub fn bytes(&self) -> usize {
        self.bytes
    }

    /// Waits for the last extraction and reads its result back, for inspection rather than drawing.
    ///
    /// # Errors
    /// [`GpuError::Failed`] if the device fails, [`GpuError::TooLarge`] if the copy exceeds the device's
    /// limit.
    pub fn read(&self, gpu: &Gpu) -> Result<FanIndices, GpuError> {
        let mut out = FanIndices::default();
        if self.block_count == 0 {
            out.group_ranges.resize(self.group_count as usize, 0..0);
            return Ok(out);
        }
        let commands: Vec<u32> = copy_back(gpu, &self.commands)?;
        let (commands, _) = commands.as_chunks::<COMMAND_WORDS>();
        out.group_ranges = commands.iter().map(|&[count, _, first, ..]| first..first + count).collect();
        out.indices = copy_back(gpu, &self.indices)?;
        out.indices.truncate(out.group_ranges.last().map_or(0, |range| range.end as usize));
        Ok(out)
    }
}

impl FanExtractor {
    /// Records the extraction of the triangles last [written](GpuFanInstance::write) to an instance; draw
    /// them afterward.
    pub fn extract(&self, encoder: &mut CommandEncoder, instance: &GpuFanInstance) {
        self.run(encoder, &instance.passes, instance.block_count);
    }
}

/// Ranges in which two lists of equal length differ, merged across small gaps.
fn changed_ranges(uploaded_words: &[u64], words: &[u64]) -> Vec<Range<usize>> {
    let mut out: Vec<Range<usize>> = Vec::new();
    for (at, _) in uploaded_words.iter().zip(words).enumerate().filter(|(_, (a, b))| a != b) {
        match out.last_mut() {
            Some(last) if at <= last.end + JOIN_GAP => last.end = at + 1,
            _ => out.push(at..at + 1),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::adapters::{AdapterKind, GpuOptions};
    use striata::mesh::shapes;
    use striata::model::{FanForm, Fans};
    use striata::simplify::build_sequence;

    #[test]
    fn near_changes_are_merged_into_one_range_and_far_ones_are_not() {
        let uploaded_words = vec![0u64; 10_000];
        let mut words = uploaded_words.clone();
        assert!(changed_ranges(&uploaded_words, &words).is_empty());
        for at in [0, 3, 3 + JOIN_GAP, 9999] {
            words[at] = 1;
        }
        assert_eq!(changed_ranges(&uploaded_words, &words), [0..4 + JOIN_GAP, 9999..10_000]);
    }

    /// Tables of more than 16 million fans need several rows on a device that allows 65,535 workgroups
    /// per row.
    #[test]
    fn dispatches_of_several_rows_extract_the_same_triangles() {
        let on_processor = Gpu::new(&GpuOptions { kind: AdapterKind::Cpu, ..GpuOptions::default() });
        let gpu = on_processor.or_else(|_| Gpu::new(&GpuOptions::default())).expect("an adapter");
        let mesh = shapes::icosphere(4, 1.0);
        let built = build_sequence(&mesh, &Default::default()).unwrap();
        let fans = Fans::build(&built.refinable);
        let table = GpuFans::upload(&gpu, &fans).unwrap();
        let mut extractor = FanExtractor::new(&gpu);
        for row in [1, 3, 4, 65_535] {
            extractor.row = row;
            let mut instance = GpuFanInstance::new(&gpu, &extractor, &table).unwrap();
            for split_count in [built.refinable.sequence.step_count(), 1000, 0] {
                let level = FanInstance::uniform(&fans, split_count);
                instance.write(&gpu, &level);
                let mut encoder = gpu.device.create_command_encoder(&Default::default());
                extractor.extract(&mut encoder, &instance);
                gpu.queue.submit([encoder.finish()]);
                let mut expected = FanIndices::default();
                level.emit_into(&fans, FanForm::Triangles, &mut expected);
                assert_eq!(
                    instance.read(&gpu).unwrap(),
                    expected,
                    "{row} workgroups per row, level {split_count}"
                );
            }
        }
    }
}
