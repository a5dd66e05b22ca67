//! [`StreamInfo`]: properties of a stream that can be read from its header alone.

use crate::format::effort::Effort;
use crate::format::error::DecodeError;
use crate::format::header::{ChunkEntry, FIXED_HEADER_BYTES, StreamHeader, header_length};

/// Counts, sizes and settings of a stream, read from its header without decoding anything.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct StreamInfo {
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
    /// Whether positions are lossless: bit for bit the floats of the encoded mesh.
    pub is_exact: bool,
    /// Bits per coordinate of the position grid.
    pub grid_bits: u32,
    /// Spacing of the position grid, mesh units.
    pub grid_step: f64,
    /// Origin of the positions in the coordinates of the mesh's source, mesh units.
    pub origin: [f64; 3],
    /// Number of positions of the full mesh.
    pub position_count: usize,
    /// Number of vertices of the full mesh.
    pub vertex_count: usize,
    /// Number of triangles of the full mesh.
    pub triangle_count: usize,
    /// Number of groups of triangles, or 0 if the mesh has none.
    pub group_count: usize,
    /// Number of steps from the base mesh to the full mesh.
    pub step_count: usize,
    /// Whether the steps are fragments instead of vertex splits.
    pub has_fragments: bool,
    /// Error of the base mesh, mesh units.
    pub error_max: f32,
    /// Metadata of the stream, as pairs of key and value.
    pub metadata: Vec<(String, String)>,
    /// Chunks in the order of the stream.
    pub chunks: Vec<ChunkInfo>,
}

/// Properties of a chunk of a stream.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ChunkInfo {
    /// Length of the chunk with its checksum, bytes.
    pub bytes: u64,
    /// Number of vertex splits in this chunk and all chunks before it.
    pub split_count: usize,
    /// Error of the level before this chunk, mesh units.
    pub error: f32,
}

impl StreamInfo {
    /// Reads the header of a stream; returns `None` if `bytes` ends within the header.
    ///
    /// # Errors
    /// [`DecodeError`] if the bytes are not a stream of the known version, or if the header is damaged.
    pub fn read(bytes: &[u8]) -> Result<Option<Self>, DecodeError> {
        let Some(header) = header_length(bytes)?.and_then(|length| bytes.get(..length)) else {
            return Ok(None);
        };
        Ok(Some(Self::of(&StreamHeader::from_bytes(header)?)))
    }

    /// Reads the header of a stream whose base mesh has to be there.
    ///
    /// # Errors
    /// See [`read`](Self::read), and [`DecodeError::Incomplete`] if `bytes` ends within the header or the base mesh.
    pub(crate) fn with_base(bytes: &[u8]) -> Result<Self, DecodeError> {
        let found = bytes.len() as u64;
        let incomplete = |needed| Err(DecodeError::Incomplete { found, needed });
        let Some(info) = Self::read(bytes)? else {
            return incomplete(header_length(bytes)?.unwrap_or(FIXED_HEADER_BYTES) as u64);
        };
        if found < info.base_bytes { incomplete(info.base_bytes) } else { Ok(info) }
    }

    /// Returns the properties that a header states.
    pub(crate) fn of(header: &StreamHeader) -> Self {
        let base_bytes = header.chunks.first().map_or(0, |chunk| chunk.stored_bytes());
        let chunk = |entry: &ChunkEntry| ChunkInfo {
            bytes: entry.stored_bytes(),
            split_count: entry.split_count as usize,
            error: entry.error,
        };
        Self {
            stream_bytes: header.length
                + header.chunks.iter().map(|chunk| chunk.stored_bytes()).sum::<u64>()
                + header.triangle_data.as_ref().map_or(0, |data| u64::from(data.bytes)),
            head_bytes: header.length,
            base_bytes: header.length + base_bytes,
            chunk_count: header.chunks.len(),
            effort: header.effort,
            is_exact: header.is_exact,
            grid_bits: header.grid.bits,
            grid_step: header.grid.step,
            origin: header.origin,
            position_count: header.position_count as usize,
            vertex_count: header.vertex_count as usize,
            triangle_count: header.triangle_count as usize,
            group_count: header.groups.len(),
            step_count: header.step_count as usize,
            has_fragments: header.has_fragments,
            error_max: header.chunks.first().map_or(0.0, |chunk| chunk.error),
            metadata: header.metadata.clone(),
            chunks: header.chunks.iter().map(chunk).collect(),
        }
    }
}
