//! What the head of a stream says of the whole of it.

use crate::format::error::DecodeError;
use crate::format::form::{Effort, StreamVersion};
use crate::format::head::{Head, head_length};

/// What a stream holds, in numbers; all of it is known as soon as its head is there.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StreamFacts {
    /// Bytes of the whole stream.
    pub stream_bytes: u64,
    /// Bytes of the head.
    pub head_bytes: u64,
    /// Bytes after which the base mesh is there.
    pub base_bytes: u64,
    /// Stretches with a checksum of their own; the first holds the base mesh.
    pub chunk_count: usize,
    /// How hard the coder tried.
    pub effort: Effort,
    /// What its bits mean.
    pub version: StreamVersion,
    /// Whether positions are the very floats of the mesh that was coded.
    pub is_exact: bool,
    /// Bits of a coordinate on the grid of positions.
    pub grid_bits: u32,
    /// Distance of neighbors on that grid, mesh units.
    pub grid_step: f64,
    /// Positions of the full mesh.
    pub position_count: usize,
    /// Vertices of the full mesh.
    pub vertex_count: usize,
    /// Triangles of the full mesh.
    pub triangle_count: usize,
    /// Groups of triangles; 0 where the mesh names none.
    pub group_count: usize,
    /// Vertex splits from the base to the full mesh.
    pub step_count: usize,
    /// Error of the base mesh, mesh units.
    pub error_max: f32,
    /// Texts about the stream, key and value.
    pub metadata: Vec<(String, String)>,
}

impl StreamFacts {
    /// Reads the head of a stream; none where there are too few bytes of it.
    ///
    /// # Errors
    /// [`DecodeError`] where the bytes begin no stream that this version reads, or its head is damaged.
    pub fn read(bytes: &[u8]) -> Result<Option<Self>, DecodeError> {
        let Some(head) = head_length(bytes)?.and_then(|length| bytes.get(..length)) else {
            return Ok(None);
        };
        let head = Head::from_bytes(head)?;
        let base_bytes = head.rows.first().map_or(0, |row| u64::from(row.bytes));
        Ok(Some(Self {
            stream_bytes: head.length + head.rows.iter().map(|row| u64::from(row.bytes)).sum::<u64>(),
            head_bytes: head.length,
            base_bytes: head.length + base_bytes,
            chunk_count: head.rows.len(),
            effort: head.effort,
            version: head.version,
            is_exact: head.is_exact,
            grid_bits: head.grid.bits,
            grid_step: head.grid.step,
            position_count: head.position_count as usize,
            vertex_count: head.vertex_count as usize,
            triangle_count: head.triangle_count as usize,
            group_count: head.groups.len(),
            step_count: head.step_count as usize,
            error_max: head.rows.first().map_or(0.0, |row| row.error),
            metadata: head.metadata,
        }))
    }
}
