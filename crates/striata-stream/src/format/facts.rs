//! [`StreamFacts`]: properties of a stream that can be read from its header alone.

use crate::format::error::DecodeError;
use crate::format::form::{Effort, StreamVersion};
use crate::format::head::{Head, head_length};

/// Counts, sizes and settings of a stream, read from its header without decoding anything.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StreamFacts {
    /// Length of the whole stream, bytes.
    pub stream_bytes: u64,
    /// Length of the header, bytes.
    pub head_bytes: u64,
    /// Length of the prefix that contains the base mesh, bytes.
    pub base_bytes: u64,
    /// Number of chunks, each with its own checksum; the first contains the base mesh.
    pub chunk_count: usize,
    /// Compression effort that the stream was encoded with.
    pub effort: Effort,
    /// Version of the stream format.
    pub version: StreamVersion,
    /// Whether positions are lossless: bit for bit the floats of the encoded mesh.
    pub is_exact: bool,
    /// Bits per coordinate of the position grid.
    pub grid_bits: u32,
    /// Spacing of the position grid, mesh units.
    pub grid_step: f64,
    /// Number of positions of the full mesh.
    pub position_count: usize,
    /// Number of vertices of the full mesh.
    pub vertex_count: usize,
    /// Number of triangles of the full mesh.
    pub triangle_count: usize,
    /// Number of groups of triangles, or 0 if the mesh has none.
    pub group_count: usize,
    /// Number of vertex splits from the base mesh to the full mesh.
    pub step_count: usize,
    /// Error of the base mesh, mesh units.
    pub error_max: f32,
    /// Metadata of the stream, as pairs of key and value.
    pub metadata: Vec<(String, String)>,
}

impl StreamFacts {
    /// Reads the header of a stream; returns `None` if `bytes` ends within the header.
    ///
    /// # Errors
    /// [`DecodeError`] if the bytes are not a stream of a known version, or if the header is damaged.
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
