//! Compute pipelines that refine a crowd, and their bindings.

use wgpu::{BindGroup, Buffer, CommandEncoder, ComputePipeline};

use crate::gpu::device::Gpu;

/// Number of passes.
pub(crate) const PASS_COUNT: usize = 7;

/// Number of passes that decide; the others emit.
pub(crate) const DECIDING_COUNT: usize = 5;

/// Number of bindings of `crowd.wgsl`.
const BINDING_COUNT: usize = 20;

/// Threads in a workgroup.
pub(crate) const THREADS: u32 = 64;

/// The passes in order, each with the bindings of `crowd.wgsl` that it uses.
const PASSES: [(&str, &[u32]); PASS_COUNT] = [
    ("plan", &[0, 1, 3, 12, 13, 14, 16, 17, 18]),
    ("arrange", &[0, 18]),
    ("classify", &[11, 13, 14, 16, 17, 19]),
    ("choose", &[0, 17]),
    ("decide", &[11, 13, 14, 15, 16, 17, 19]),
    ("place", &[0, 9, 13, 14, 16]),
    ("expand", &[0, 1, 2, 3, 5, 8, 16, 19]),
];

/// Number of workgroups of a pass.
#[derive(Clone, Copy, Debug)]
pub(crate) enum PassSize<'a> {
    Groups(u32),
    /// As many as a buffer says at an offset in bytes.
    Listed {
        work: &'a Buffer,
        offset: u64,
    },
}

/// The pipelines of all passes.
#[derive(Debug)]
pub(crate) struct CrowdPasses {
    pipelines: [ComputePipeline; PASS_COUNT],
}

impl CrowdPasses {
    /// Compiles the shaders and creates the pipelines.
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let code = concat!(include_str!("shaders/fan_rules.wgsl"), include_str!("shaders/crowd.wgsl"));
        let module = gpu.compute_module("crowd", code);
        Self { pipelines: PASSES.map(|(entry_point, _)| gpu.compute_pipeline(&module, entry_point)) }
    }

    /// Binds the buffers, listed by binding, to all passes.
    pub(crate) fn bind(&self, gpu: &Gpu, buffers: &[&Buffer; BINDING_COUNT]) -> [BindGroup; PASS_COUNT] {
        std::array::from_fn(|pass| gpu.bind_compute(&self.pipelines[pass], PASSES[pass].1, buffers))
    }

    /// Records passes with the size of each.
    pub(crate) fn run(
        &self,
        encoder: &mut CommandEncoder,
        bindings: &[BindGroup; PASS_COUNT],
        first_pass: usize,
        sizes: &[PassSize<'_>],
    ) {
        let mut pass = encoder.begin_compute_pass(&Default::default());
        for (at, size) in sizes.iter().enumerate() {
            pass.set_pipeline(&self.pipelines[first_pass + at]);
            pass.set_bind_group(0, &bindings[first_pass + at], &[]);
            match *size {
                PassSize::Groups(count) => pass.dispatch_workgroups(count, 1, 1),
                PassSize::Listed { work, offset } => pass.dispatch_workgroups_indirect(work, offset),
            }
        }
    }
}
