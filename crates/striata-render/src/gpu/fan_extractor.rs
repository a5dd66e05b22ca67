//! Compute pipelines that extract the triangles of progressive fans, and their bindings.

use bytemuck::{Pod, Zeroable, bytes_of};
use wgpu::{BindGroup, Buffer, BufferUsages, CommandEncoder, ComputePipeline, Features};

use crate::gpu::device::Gpu;
use crate::gpu::gpu_error::GpuError;
use crate::gpu::gpu_fans::GpuFans;

/// The three passes of an extraction, in order, each with the bindings of `fans.wgsl` that it uses.
const PASSES: [(&str, &[u32]); 3] =
    [("count", &[0, 1, 2, 3, 5, 6, 7]), ("allocate", &[0, 4, 7, 9]), ("write", &[0, 1, 2, 3, 6, 8, 10])];

/// Extracts the triangles of [`GpuFanInstance`](crate::gpu::GpuFanInstance)s in compute shaders. One extractor
/// serves all tables of a device.
#[derive(Debug)]
pub struct FanExtractor {
    pipelines: [ComputePipeline; 3],
    /// Maximum number of workgroups along one dimension of a dispatch.
    pub(crate) row: u32,
}

/// Buffers of one instance that the passes read and write.
pub(crate) struct Bindings<'a> {
    pub bits: &'a Buffer,
    pub arcs: &'a Buffer,
    pub sums: &'a Buffer,
    pub indices: &'a Buffer,
    pub commands: &'a Buffer,
}

/// Uniform parameters of an extraction, laid out as in `fans.wgsl`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct ExtractionParameters {
    block_count: u32,
    group_count: u32,
    capacity: u32,
    passes_group: u32,
}

impl FanExtractor {
    /// Compiles the shaders and creates the pipelines.
    pub fn new(gpu: &Gpu) -> Self {
        let code = concat!(include_str!("shaders/fan_rules.wgsl"), include_str!("shaders/fans.wgsl"));
        let module = gpu.compute_module("fans", code);
        let pipelines = PASSES.map(|(entry_point, _)| gpu.compute_pipeline(&module, entry_point));
        Self { pipelines, row: gpu.device.limits().max_compute_workgroups_per_dimension }
    }

    /// Records all passes over `block_count` blocks with an instance's bindings.
    pub(crate) fn run(&self, encoder: &mut CommandEncoder, passes: &[BindGroup; 3], block_count: u32) {
        if block_count == 0 {
            return;
        }
        let mut pass = encoder.begin_compute_pass(&Default::default());
        for (pass_index, (pipeline, bindings)) in self.pipelines.iter().zip(passes).enumerate() {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, bindings, &[]);
            // The second pass scans the sums of all blocks in a single workgroup.
            let [x, y] = if pass_index == 1 { [1, 1] } else { rows(block_count, self.row) };
            pass.dispatch_workgroups(x, y, 1);
        }
    }

    /// Creates an instance's bind groups, one per pass.
    pub(crate) fn bind(
        &self,
        gpu: &Gpu,
        table: &GpuFans,
        buffers: &Bindings<'_>,
        capacity: u32,
    ) -> Result<[BindGroup; 3], GpuError> {
        let passes_group = gpu.device.features().contains(Features::INDIRECT_FIRST_INSTANCE);
        let parameters = ExtractionParameters {
            block_count: table.block_count,
            group_count: table.group_count,
            capacity,
            passes_group: u32::from(passes_group),
        };
        let parameters =
            gpu.buffer_of("fan extraction parameters", bytes_of(&parameters), BufferUsages::UNIFORM)?;
        let bound = [
            &parameters,
            &table.fans,
            &table.words,
            &table.blocks,
            &table.group_blocks,
            buffers.bits,
            buffers.arcs,
            buffers.sums,
            buffers.indices,
            buffers.commands,
            buffers.sums,
        ];
        Ok(std::array::from_fn(|pass| gpu.bind_compute(&self.pipelines[pass], PASSES[pass].1, &bound)))
    }
}

/// Dispatch size `[x, y]` that covers this number of blocks with at most `row` workgroups along x.
fn rows(block_count: u32, row: u32) -> [u32; 2] {
    [block_count.min(row), block_count.div_ceil(row)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::gpu_fan_words::BLOCK;

    #[test]
    fn dispatches_cover_all_blocks_of_the_largest_tables() {
        for block_count in [1, 2, 65_535, 65_536, 65_537, u32::MAX / BLOCK as u32] {
            let [x, y] = rows(block_count, 65_535);
            assert!(x <= 65_535 && y <= 65_535 && u64::from(x) * u64::from(y) >= u64::from(block_count));
        }
    }
}
