//! The header of a stream: counts, position grid, layers, names, and the table of chunks.
//!
//! ```text
//! 0   4 bytes  89 53 54 52
//! 4   u8       version, 3
//! 5   u8       effort
//! 6   u16      flags; bit 0: positions are exact; bit 1: there are general batches;
//!              bit 2: positions have an origin, three f64 after the grid;
//!              bit 3: data of triangles follow the chunks; bit 4: steps are fragments
//! 8   u32      length of the header, including these 16 bytes
//! 12  u32      CRC-32 of the header without this field
//! 16           counts, grid, layers, groups, appearance, metadata, chunks, data of triangles
//! ```
//!
//! All lengths and counts are varints. The checksum of a chunk is in front of it rather than in the header, since the
//! first picture waits for the header.

use striata::file::{EncodeError, STREAM_MAGIC, appearance_from_bytes, appearance_to_bytes};
use striata::mesh::Appearance;

use crate::format::byte_reader::{ByteReader, put_block, write_varint};
use crate::format::effort::Effort;
use crate::format::error::{DecodeError, StreamDefect};
use crate::format::grid::PositionGrid;
use crate::layers::form::{LayerForm, ValueTransform};
use crate::layers::triangle_data::TriangleData;

/// The version that is written, and the only one that can be read.
const VERSION: u8 = 3;
/// Length of the fixed first part of the header, bytes.
pub(crate) const FIXED_HEADER_BYTES: usize = 16;
const EXACT_FLAG: u16 = 1;
const GENERAL_FLAG: u16 = 2;
const ORIGIN_FLAG: u16 = 4;
const TRIANGLE_DATA_FLAG: u16 = 8;
const FRAGMENTS_FLAG: u16 = 16;
/// A chunk of `n` bytes contains at most `n + 1` times this number of splits. A writer that needs fewer
/// bytes appends zeros.
const MAX_SPLITS_PER_BYTE: u64 = 256;
/// A first chunk of `n` bytes contains at most `n + 1` times this number of base triangles.
const MAX_BASE_TRIANGLES_PER_BYTE: u32 = 256;

/// The first `n` bytes of all chunks together create at most `n + 1` times this number of vertices beyond
/// one per position.
const MAX_EXTRA_WEDGES_PER_BYTE: u64 = 256;

/// The first `n` bytes of all chunks together exchange at most `n + 1` times this number of triangles, if steps are
/// fragments.
const MAX_EXCHANGED_PER_BYTE: u64 = 256;

/// Returns the minimum total length of all chunks of fragments that exchange this number of triangles.
pub(crate) fn min_bytes_of_fragments(triangles: u32) -> usize {
    (u64::from(triangles) / MAX_EXCHANGED_PER_BYTE) as usize
}

/// Maximum number of components per vertex in all layers together: each of them has its own models.
pub(crate) const MAX_COMPONENTS: usize = 4096;

/// Returns the minimum total length of a chunk and all chunks before it.
pub(crate) fn min_total_bytes(extra_wedges: usize) -> usize {
    extra_wedges / MAX_EXTRA_WEDGES_PER_BYTE as usize
}

/// Returns how many vertices beyond one per position may be coded in `bytes` bytes.
pub(crate) fn max_extra_wedges(bytes: u64) -> u64 {
    (bytes + 1) * MAX_EXTRA_WEDGES_PER_BYTE
}

/// Returns the minimum length of a chunk.
pub(crate) fn min_chunk_bytes(splits: usize, base_triangles: usize) -> usize {
    (splits / MAX_SPLITS_PER_BYTE as usize).max(base_triangles / MAX_BASE_TRIANGLES_PER_BYTE as usize)
}

/// Name and material of a group of triangles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct GroupName {
    pub name: String,
    pub material: Option<u32>,
}

/// Entry of the chunk table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ChunkEntry {
    /// Length of the chunk without its checksum, bytes.
    pub bytes: u32,
    /// Number of splits in this chunk and all chunks before it.
    pub split_count: u32,
    /// Error of the level before this chunk, mesh units, rounded up.
    pub error: f32,
}

impl ChunkEntry {
    /// Length of the chunk with its checksum, bytes.
    pub(crate) fn stored_bytes(self) -> u64 {
        CHECKSUM_BYTES as u64 + u64::from(self.bytes)
    }
}

/// Length of the CRC-32 in front of each chunk, bytes.
pub(crate) const CHECKSUM_BYTES: usize = 4;

/// Appends a chunk and its checksum to a stream.
pub(crate) fn put_chunk(chunk: &[u8], stream: &mut Vec<u8>) {
    stream.extend(crc32fast::hash(chunk).to_le_bytes());
    stream.extend_from_slice(chunk);
}

/// The header of a stream: all that a reader knows before the first chunk.
#[derive(Clone, Debug)]
pub(crate) struct StreamHeader {
    /// Length of the header, bytes.
    pub length: u64,
    pub effort: Effort,
    /// Whether corrections are stored, so that positions are bit for bit the floats of the mesh.
    pub is_exact: bool,
    pub position_count: u32,
    pub vertex_count: u32,
    pub triangle_count: u32,
    pub step_count: u32,
    /// Largest number of triangles that a split moves; if steps are fragments, the number of triangles of all floors and
    /// ceilings.
    pub max_patch: u32,
    /// Whether steps are fragments instead of vertex splits.
    pub has_fragments: bool,
    /// Whether the stream may contain general batches.
    pub has_general: bool,
    pub grid: PositionGrid,
    /// Origin of all positions in the coordinates of the mesh's source, mesh units.
    pub origin: [f64; 3],
    pub layers: Vec<LayerForm>,
    pub groups: Vec<GroupName>,
    pub appearance: Appearance,
    pub metadata: Vec<(String, String)>,
    pub chunks: Vec<ChunkEntry>,
    /// Data of triangles, after the last chunk.
    pub triangle_data: Option<TriangleData>,
}

/// Upper 16 bits of the largest finite error.
const MAX_ERROR_CODE: u32 = 0x7f7f;

/// Returns the upper 16 bits of an error, rounded up.
fn error_code(error: f32) -> u32 {
    let bits = error.max(0.0).to_bits();
    ((bits >> 16) + u32::from(bits & 0xffff != 0)).min(MAX_ERROR_CODE)
}

/// Returns the length of a header from its first bytes, or `None` if there are too few of them.
///
/// # Errors
/// [`DecodeError`] if the bytes do not begin a stream of the known version.
pub(crate) fn header_length(bytes: &[u8]) -> Result<Option<usize>, DecodeError> {
    let shown = bytes.len().min(4);
    if bytes[..shown] != STREAM_MAGIC[..shown] {
        return Err(DecodeError::Magic { found: bytes[..bytes.len().min(8)].to_vec() });
    }
    let Some(fixed) = bytes.get(..FIXED_HEADER_BYTES) else { return Ok(None) };
    if fixed[4] != VERSION {
        let (found, supported) = (u32::from(fixed[4]), u32::from(VERSION));
        return Err(DecodeError::Version { found, supported });
    }
    let length = u32::from_le_bytes([fixed[8], fixed[9], fixed[10], fixed[11]]) as usize;
    if length < FIXED_HEADER_BYTES {
        let reason = "the header is shorter than its fixed part";
        return Err(DecodeError::Malformed { offset: 8, reason });
    }
    Ok(Some(length))
}

fn checksum(header: &[u8]) -> u32 {
    let mut hasher = crc32fast::Hasher::new();
    hasher.update(&header[..12]);
    hasher.update(&header[FIXED_HEADER_BYTES..]);
    hasher.finalize()
}

impl StreamHeader {
    /// Serializes the header.
    ///
    /// # Errors
    /// [`EncodeError::TooLong`] if a text or the header is too long.
    pub(crate) fn to_bytes(&self) -> Result<Vec<u8>, EncodeError> {
        let mut out = STREAM_MAGIC.to_vec();
        let effort = match self.effort {
            Effort::Fast => 0,
            Effort::Compact => 1,
        };
        out.extend([VERSION, effort]);
        let has_origin = self.origin != [0.0; 3];
        let flags = [
            (self.is_exact, EXACT_FLAG),
            (self.has_general, GENERAL_FLAG),
            (has_origin, ORIGIN_FLAG),
            (self.triangle_data.is_some(), TRIANGLE_DATA_FLAG),
            (self.has_fragments, FRAGMENTS_FLAG),
        ];
        let flags = flags.iter().filter(|(is_set, _)| *is_set).fold(0, |all, (_, flag)| all | flag);
        out.extend(flags.to_le_bytes());
        out.extend([0; 8]);
        let counts = [self.position_count, self.vertex_count, self.triangle_count, self.step_count];
        counts.into_iter().chain([self.max_patch]).for_each(|n| write_varint(n, &mut out));
        out.push(self.grid.bits as u8);
        self.grid.origin.iter().for_each(|x| out.extend(x.to_le_bytes()));
        out.extend(self.grid.step.to_le_bytes());
        if has_origin {
            self.origin.iter().for_each(|x| out.extend(x.to_le_bytes()));
        }
        write_varint(self.layers.len() as u32, &mut out);
        self.layers.iter().for_each(|layer| layer.write(&mut out));
        self.names_to_bytes(&mut out)?;
        write_varint(self.chunks.len() as u32, &mut out);
        let (mut splits_before, mut code_before) = (0, MAX_ERROR_CODE);
        for chunk in &self.chunks {
            write_varint(chunk.bytes, &mut out);
            write_varint(chunk.split_count - splits_before, &mut out);
            // Errors never increase from level to level.
            let code = error_code(chunk.error).min(code_before);
            write_varint(code_before - code, &mut out);
            (splits_before, code_before) = (chunk.split_count, code);
        }
        if let Some(data) = &self.triangle_data {
            write_varint(data.forms.len() as u32, &mut out);
            data.forms.iter().for_each(|form| form.write(&mut out));
            write_varint(data.bytes, &mut out);
            out.extend(data.checksum.to_le_bytes());
        }
        let length = u32::try_from(out.len())
            .map_err(|_| EncodeError::TooLong { what: "the header", length: out.len() })?;
        out[8..12].copy_from_slice(&length.to_le_bytes());
        let checksum = checksum(&out);
        out[12..16].copy_from_slice(&checksum.to_le_bytes());
        Ok(out)
    }

    fn names_to_bytes(&self, out: &mut Vec<u8>) -> Result<(), EncodeError> {
        write_varint(self.groups.len() as u32, out);
        for group in &self.groups {
            write_varint(group.material.map_or(0, |m| m + 1), out);
            put_block("a group's name", group.name.as_bytes(), out)?;
        }
        let appearance =
            if self.appearance.is_empty() { Vec::new() } else { appearance_to_bytes(&self.appearance)? };
        put_block("the appearance", &appearance, out)?;
        write_varint(self.metadata.len() as u32, out);
        for text in self.metadata.iter().flat_map(|(key, value)| [key, value]) {
            put_block("metadata", text.as_bytes(), out)?;
        }
        Ok(())
    }

    /// Returns the maximum number of base triangles, given the length of the first chunk.
    pub(crate) fn max_base_triangles(&self) -> u32 {
        let bytes = self.chunks.first().map_or(0, |chunk| chunk.bytes);
        bytes.saturating_add(1).saturating_mul(MAX_BASE_TRIANGLES_PER_BYTE)
    }

    /// Parses a header whose length is the one returned by [`header_length`].
    ///
    /// # Errors
    /// [`DecodeError`] if anything in it is invalid.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Result<Self, DecodeError> {
        let expected = u32::from_le_bytes([bytes[12], bytes[13], bytes[14], bytes[15]]);
        let found = checksum(bytes);
        if found != expected {
            return Err(DecodeError::HeaderChecksum { found, expected });
        }
        let mut reader = ByteReader::new(bytes);
        // Magic and version, which `header_length` has checked.
        reader.bytes(5)?;
        let effort = match reader.u8()? {
            0 => Effort::Fast,
            1 => Effort::Compact,
            _ => return Err(reader.malformed("unknown effort")),
        };
        let flags = reader.bytes(2)?;
        let flags = u16::from_le_bytes([flags[0], flags[1]]);
        let known = EXACT_FLAG | GENERAL_FLAG | ORIGIN_FLAG | TRIANGLE_DATA_FLAG | FRAGMENTS_FLAG;
        if flags & !known != 0 {
            return Err(reader.malformed("unknown flags"));
        }
        reader.bytes(8)?;
        let [position_count, vertex_count, triangle_count, step_count, max_patch] =
            [reader.varint()?, reader.varint()?, reader.varint()?, reader.varint()?, reader.varint()?];
        let grid = read_grid(&mut reader)?;
        let origin = if flags & ORIGIN_FLAG == 0 { [0.0; 3] } else { read_origin(&mut reader)? };
        let layer_count = reader.short_count(5)?;
        let layers: Vec<LayerForm> =
            (0..layer_count).map(|_| LayerForm::read(&mut reader)).collect::<Result<_, _>>()?;
        if layers.iter().map(LayerForm::integer_count).sum::<usize>() > MAX_COMPONENTS {
            return Err(reader.malformed("the layers have too many components per vertex"));
        }
        let groups = read_groups(&mut reader)?;
        let appearance = match reader.block()? {
            [] => Appearance::default(),
            bytes => appearance_from_bytes(bytes).map_err(DecodeError::Appearance)?,
        };
        let mut metadata = Vec::new();
        for _ in 0..reader.short_count(2)? {
            metadata.push((reader.text()?, reader.text()?));
        }
        let chunks = read_chunks(&mut reader)?;
        let has_triangle_data = flags & TRIANGLE_DATA_FLAG != 0;
        let triangle_data = has_triangle_data.then(|| read_triangle_data(&mut reader)).transpose()?;
        if chunks.last().map(|chunk| chunk.split_count) != Some(step_count) {
            return Err(reader.malformed("the chunks do not contain all steps"));
        }
        if step_count > position_count || vertex_count < position_count {
            return Err(
                reader.malformed("there are fewer positions than steps, or fewer vertices than positions")
            );
        }
        let chunk_bytes: u64 = chunks.iter().map(|chunk| u64::from(chunk.bytes)).sum();
        if u64::from(vertex_count - position_count) > max_extra_wedges(chunk_bytes) {
            return Err(reader.malformed("there are more vertices than the length of the chunks allows"));
        }
        let has_fragments = flags & FRAGMENTS_FLAG != 0;
        if has_fragments && u64::from(max_patch) > MAX_EXCHANGED_PER_BYTE * (chunk_bytes + 1) {
            return Err(reader.malformed("there are more triangles than the length of the chunks allows"));
        }
        if has_fragments && (has_triangle_data || flags & GENERAL_FLAG != 0) {
            return Err(reader.malformed("fragments with general batches or data of triangles"));
        }
        if groups.iter().filter_map(|g| g.material).any(|m| m as usize >= appearance.materials.len()) {
            return Err(reader.malformed("a group has an unknown material"));
        }
        reader.end()?;
        Ok(Self {
            length: bytes.len() as u64,
            effort,
            is_exact: flags & EXACT_FLAG != 0,
            has_general: flags & GENERAL_FLAG != 0,
            has_fragments,
            position_count,
            vertex_count,
            triangle_count,
            step_count,
            max_patch,
            grid,
            origin,
            layers,
            groups,
            appearance,
            metadata,
            chunks,
            triangle_data,
        })
    }
}

fn read_grid(reader: &mut ByteReader<'_>) -> Result<PositionGrid, DecodeError> {
    let bits = u32::from(reader.u8()?);
    let origin = [reader.f32()?, reader.f32()?, reader.f32()?];
    let step = reader.f64()?;
    let grid = PositionGrid { origin, step, bits };
    grid.check().map_err(|error| DecodeError::Stream(StreamDefect::Grid(error)))
}

fn read_origin(reader: &mut ByteReader<'_>) -> Result<[f64; 3], DecodeError> {
    let origin = [reader.f64()?, reader.f64()?, reader.f64()?];
    if origin.iter().all(|x| x.is_finite()) {
        return Ok(origin);
    }
    Err(reader.malformed("the origin is not finite"))
}

fn read_groups(reader: &mut ByteReader<'_>) -> Result<Vec<GroupName>, DecodeError> {
    let mut groups = Vec::new();
    for _ in 0..reader.short_count(2)? {
        let material = reader.varint()?.checked_sub(1);
        groups.push(GroupName { name: reader.text()?, material });
    }
    Ok(groups)
}

fn read_triangle_data(reader: &mut ByteReader<'_>) -> Result<TriangleData, DecodeError> {
    let count = reader.short_count(5)?;
    let forms: Vec<LayerForm> = (0..count).map(|_| LayerForm::read(reader)).collect::<Result<_, _>>()?;
    let number_count = forms.iter().map(LayerForm::integer_count).sum::<usize>();
    if number_count > MAX_COMPONENTS || forms.iter().any(|form| form.transform != ValueTransform::Exact) {
        return Err(reader.malformed("the data of triangles have too many components, or are not exact"));
    }
    Ok(TriangleData { forms, bytes: reader.varint()?, checksum: reader.u32()? })
}

fn read_chunks(reader: &mut ByteReader<'_>) -> Result<Vec<ChunkEntry>, DecodeError> {
    let count = reader.short_count(3)?;
    let mut chunks = Vec::with_capacity(count);
    let (mut split_count, mut code) = (0u32, MAX_ERROR_CODE);
    for _ in 0..count {
        let (bytes, splits, fall) = (reader.varint()?, reader.varint()?, reader.varint()?);
        split_count = split_count.checked_add(splits).ok_or_else(|| reader.malformed("too many steps"))?;
        let fallen = code.checked_sub(fall);
        code = fallen.ok_or_else(|| reader.malformed("the error of a chunk is negative"))?;
        if u64::from(splits) > MAX_SPLITS_PER_BYTE * (u64::from(bytes) + 1) {
            return Err(reader.malformed("a chunk has more splits than its length allows"));
        }
        chunks.push(ChunkEntry { bytes, split_count, error: f32::from_bits(code << 16) });
    }
    Ok(chunks)
}
