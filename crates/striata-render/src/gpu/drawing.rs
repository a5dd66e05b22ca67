//! Draw calls over a vertex buffer: lists, strips, or indirect draws whose arguments the GPU reads itself.

use std::ops::Range;

use wgpu::Buffer;

use crate::gpu::indices::{GpuIndices, GpuMultiDraw};

/// Indices and how to draw them. Groups (materials) are consecutive ranges of the indices; the n-th group
/// gets the n-th palette color if the [`Look`](crate::gpu::Look) shows groups.
#[derive(Clone, Copy, Debug)]
pub enum Drawing<'a> {
    /// Triangle list: three indices per triangle.
    List {
        /// The indices.
        indices: &'a GpuIndices,
        /// Index range of each group.
        groups: &'a [Range<u32>],
    },
    /// Strips separated by the restart index (`u32::MAX`).
    Strips {
        /// The indices.
        indices: &'a GpuIndices,
        /// Index range of each group.
        groups: &'a [Range<u32>],
    },
    /// Strips without restart indices, one indirect draw each; all in the color of the first group.
    MultiStrips {
        /// The indices.
        indices: &'a GpuIndices,
        /// The draws.
        draws: &'a GpuMultiDraw,
    },
    /// Triangle lists whose lengths are known only to the GPU.
    Extracted {
        /// The indices.
        indices: &'a Buffer,
        /// Indirect indexed draws, one per group, starting at byte 0 of the buffer.
        commands: &'a Buffer,
        /// Number of draws.
        command_count: u32,
    },
}

impl Drawing<'_> {
    /// Whether the topology is a triangle strip.
    pub(crate) fn is_strips(&self) -> bool {
        matches!(self, Drawing::Strips { .. } | Drawing::MultiStrips { .. })
    }

    pub(crate) fn index_buffer(&self) -> &Buffer {
        match self {
            Drawing::List { indices, .. }
            | Drawing::Strips { indices, .. }
            | Drawing::MultiStrips { indices, .. } => &indices.buffer,
            Drawing::Extracted { indices, .. } => indices,
        }
    }

    /// Issues the draw calls; the pipeline, bind groups and buffers are already set.
    pub(crate) fn issue(&self, pass: &mut wgpu::RenderPass<'_>) {
        match self {
            Drawing::List { groups, .. } | Drawing::Strips { groups, .. } => {
                for (group, range) in groups.iter().enumerate().filter(|(_, r)| !r.is_empty()) {
                    let group = group as u32;
                    // The shader reads the group from the instance index.
                    pass.draw_indexed(range.clone(), 0, group..group + 1);
                }
            }
            Drawing::MultiStrips { draws, .. } => {
                if draws.command_count() > 0 {
                    pass.multi_draw_indexed_indirect(draws.commands(), 0, draws.command_count());
                }
            }
            Drawing::Extracted { commands, command_count, .. } => {
                if *command_count > 0 {
                    pass.multi_draw_indexed_indirect(commands, 0, *command_count);
                }
            }
        }
    }
}
