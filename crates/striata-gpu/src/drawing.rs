//! What is drawn over the vertices: a list, strips, or draws that the GPU reads itself.

use std::ops::Range;

use wgpu::Buffer;

use crate::indices::{GpuIndices, GpuMultiDraw};

/// Indices and how they are drawn. Groups (materials) are ranges one after the other; the n-th gets the n-th color where
/// a [`Look`](crate::Look) asks for colors of groups.
#[derive(Clone, Copy, Debug)]
pub enum Drawing<'a> {
    /// Three indices a triangle.
    List {
        /// The indices.
        indices: &'a GpuIndices,
        /// A range for each group.
        groups: &'a [Range<u32>],
    },
    /// Strips with a restart index (`u32::MAX`) between them.
    Strips {
        /// The indices.
        indices: &'a GpuIndices,
        /// A range for each group.
        groups: &'a [Range<u32>],
    },
    /// Strips, each by a draw of its own that the GPU reads from a buffer; all in the color of the first group.
    MultiStrips {
        /// The indices.
        indices: &'a GpuIndices,
        /// The draws.
        draws: &'a GpuMultiDraw,
    },
    /// Triangle lists whose lengths only the GPU knows.
    Extracted {
        /// The indices.
        indices: &'a Buffer,
        /// Indirect indexed draws, one for each group, from the buffer's first byte on.
        commands: &'a Buffer,
        /// How many.
        command_count: u32,
    },
}

impl Drawing<'_> {
    /// Whether strips are drawn.
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

    /// Issues the draws; pipeline, bindings and buffers are set.
    pub(crate) fn issue(&self, pass: &mut wgpu::RenderPass<'_>) {
        match self {
            Drawing::List { groups, .. } | Drawing::Strips { groups, .. } => {
                for (group, range) in groups.iter().enumerate().filter(|(_, r)| !r.is_empty()) {
                    let group = group as u32;
                    // The instance tells the shader its group.
                    pass.draw_indexed(range.clone(), 0, group..group + 1);
                }
            }
            Drawing::MultiStrips { draws, .. } => {
                if draws.command_count() > 0 {
                    pass.multi_draw_indexed_indirect(&draws.commands, 0, draws.command_count());
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
