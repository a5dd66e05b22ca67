//! Decodes a stream: takes bytes as they arrive and provides the vertices and triangles decoded so far.

use std::ops::Range;

use striata::mesh::{
    AttributeLayer, CollapseSequence, ColorSpace, IndexedMesh, PositionIndex, RefinableMesh, SequenceParts,
    Steps, TriangleGroup,
};
use striata::{Progress, ProgressFn};

use crate::base::coder::BaseLimits;
use crate::base::mesh::Base;
use crate::entropy::RangeReader;
use crate::format::error::{DecodeError, StreamDefect};
use crate::format::header::{
    CHECKSUM_BYTES, ChunkEntry, FIXED_HEADER_BYTES, GroupName, StreamHeader, header_length, max_extra_wedges,
};
use crate::format::info::StreamInfo;
use crate::layers::form::LayerForm;
use crate::layers::triangle_data;
use crate::reader::fragments::FragmentReader;
use crate::reader::prefix::PrefixMesh;
use crate::refine::growth::GrowingMesh;
use crate::refine::parameters::StreamParameters;
use crate::refine::refiner::{CodingResult, MeshRefiner};
use crate::refine::source::ReaderSource;

/// Number of bytes passed to a decoder at a time. The decoder moves pending bytes after each chunk, so large
/// pieces would be slow.
pub(crate) const PIECE_BYTES: usize = 1 << 16;

/// The changes that one call to the decoder made. To apply them, append [`vertices`](Self::vertices) to
/// the vertex buffer, rewrite [`changed_triangles`](Self::changed_triangles) in the index buffer and
/// append [`triangles`](Self::triangles).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct StreamUpdate {
    /// Range of the new vertices, at the end of the vertex buffer.
    pub vertices: Range<usize>,
    /// Range of the new triangles, at the end of the index buffer.
    pub triangles: Range<usize>,
    /// Indices of older triangles whose corners have changed, ascending.
    pub changed_triangles: Vec<u32>,
}

/// Decodes a progressive stream. It accepts slices of bytes as they arrive and keeps the mesh decoded so far.
///
/// A chunk is decoded once all its bytes have arrived and its checksum matches. If the stream is cut off
/// and no more bytes will arrive, [`finish`](Self::finish) decodes as much as possible of the last,
/// incomplete chunk.
///
/// # Example
/// ```
/// use striata_stream::{StreamDecoder, StreamOptions, encode_stream};
/// use striata::mesh::shapes;
/// use striata::simplify::{BatchOptions, build_batches};
///
/// let built = build_batches(&shapes::torus(32, 16, 1.0, 0.4), &BatchOptions::default())?;
/// let stream = encode_stream(&built.built.refinable, &built.batches, &StreamOptions::default())?;
/// let mut decoder = StreamDecoder::new();
/// for piece in stream.bytes.chunks(100) {
///     let update = decoder.push(piece)?;
///     println!("{} more vertices", update.vertices.len());
/// }
/// assert_eq!(decoder.triangles().len(), 1024);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct StreamDecoder {
    /// Bytes that have arrived but have not been decoded yet.
    waiting: Vec<u8>,
    /// Number of bytes decoded so far.
    read: u64,
    /// The decoded header, once it has arrived.
    header: Option<StreamHeader>,
    /// The refinement loop, once the base mesh has been decoded.
    refiner: Option<Box<MeshRefiner>>,
    /// The level that fragments refine, once the base mesh of a stream of fragments has been decoded.
    fragments: Option<Box<FragmentReader>>,
    /// Number of chunks decoded so far.
    chunk_count: usize,
    /// Layers of triangles in sorted order, once they have been decoded.
    triangle_layers: Option<Vec<AttributeLayer>>,
    /// Whether decoding has ended, by an error or by [`finish`](Self::finish); no more bytes are accepted.
    is_over: bool,
}

impl StreamDecoder {
    /// Creates a decoder that has not received any bytes.
    pub fn new() -> Self {
        Self::default()
    }

    /// Accepts the next bytes of the stream and decodes all chunks that are complete.
    ///
    /// # Errors
    /// [`DecodeError`] if the bytes are not a valid stream, or if they continue after its end
    /// ([`DecodeError::FileLength`] with the number of bytes received and the length of the stream).
    /// Whatever was decoded before remains available, but the decoder accepts no more bytes.
    pub fn push(&mut self, bytes: &[u8]) -> Result<StreamUpdate, DecodeError> {
        self.check_open()?;
        let (vertices, triangles) = self.sizes();
        let mut waiting = std::mem::take(&mut self.waiting);
        waiting.extend_from_slice(bytes);
        let start = self.read;
        let result = self.read_all(&waiting);
        self.catch_up();
        self.is_over = result.is_err();
        // Drained once after all chunks, since draining moves the remaining bytes.
        waiting.drain(..(self.read - start) as usize);
        self.waiting = waiting;
        result?;
        Ok(self.update_since(vertices, triangles))
    }

    /// Accepts bytes like [`push`](Self::push), piece by piece, and reports progress in bytes; the callback can
    /// cancel. Returns the number of bytes that were accepted: all of them, unless the callback cancelled.
    ///
    /// # Errors
    /// See [`push`](Self::push).
    pub fn push_with_progress(
        &mut self,
        bytes: &[u8],
        progress: &mut ProgressFn<'_>,
    ) -> Result<usize, DecodeError> {
        let mut accepted = 0;
        for piece in bytes.chunks(PIECE_BYTES) {
            let now = Progress { phase: "decode", done: accepted as u64, total: bytes.len() as u64 };
            if progress(now).is_break() {
                break;
            }
            self.push(piece)?;
            accepted += piece.len();
        }
        Ok(accepted)
    }

    /// Decodes the header and every complete chunk.
    fn read_all(&mut self, mut bytes: &[u8]) -> Result<(), DecodeError> {
        if self.header.is_none() {
            let Some(length) = header_length(bytes)?.filter(|&n| n <= bytes.len()) else { return Ok(()) };
            self.header = Some(StreamHeader::from_bytes(&bytes[..length])?);
            self.read += length as u64;
            bytes = &bytes[length..];
        }
        while let Some(entry) = self.next_entry().filter(|entry| entry.stored_bytes() <= bytes.len() as u64) {
            let (stored, rest) = bytes.split_at(entry.stored_bytes() as usize);
            let chunk = self.checked_chunk(stored)?;
            self.read_chunk(chunk, entry, rest.len(), true)?;
            self.read += entry.stored_bytes();
            self.chunk_count += 1;
            bytes = rest;
        }
        if self.next_entry().is_some() {
            return Ok(());
        }
        self.check_counts()?;
        let data = self.header.as_ref().and_then(|header| header.triangle_data.clone());
        if let Some(data) = data.filter(|_| self.triangle_layers.is_none()) {
            let Some((own, rest)) = bytes.split_at_checked(data.bytes as usize) else { return Ok(()) };
            let count = self.growth().map_or(0, |growth| growth.triangle_count());
            let layers = data.decode(own, count, self.chunk_count, self.read)?;
            self.triangle_layers = Some(layers);
            self.read += u64::from(data.bytes);
            bytes = rest;
        }
        self.check_end(bytes.len())
    }

    /// Checks that no bytes follow the end of a stream that has been decoded completely.
    fn check_end(&self, more: usize) -> Result<(), DecodeError> {
        if more == 0 {
            return Ok(());
        }
        Err(DecodeError::FileLength { found: self.read + more as u64, expected: self.read })
    }

    /// Checks that more bytes may follow.
    ///
    /// # Errors
    /// If an earlier call failed, or if [`finish`](Self::finish) has already been called.
    fn check_open(&self) -> Result<(), DecodeError> {
        if !self.is_over {
            return Ok(());
        }
        let offset = self.read as usize;
        Err(DecodeError::Malformed {
            offset,
            reason: "the decoder accepts no more bytes after an error or after finish",
        })
    }

    /// Decodes as much as possible of the last, incomplete chunk, without verifying its checksum. No more
    /// bytes are accepted afterward.
    ///
    /// # Errors
    /// [`DecodeError`] if the stream ends before its base mesh does, or if the remaining bytes are invalid.
    pub fn finish(&mut self) -> Result<StreamUpdate, DecodeError> {
        self.check_open()?;
        let (vertices, triangles) = self.sizes();
        if self.chunk_count == 0 {
            let (found, info) = (self.read + self.waiting.len() as u64, self.info());
            let needed = match info {
                Some(info) => info.base_bytes,
                None => header_length(&self.waiting)?.unwrap_or(FIXED_HEADER_BYTES) as u64,
            };
            return Err(DecodeError::Incomplete { found, needed });
        }
        self.is_over = true;
        if let Some(entry) = self.next_entry() {
            let rest = std::mem::take(&mut self.waiting);
            let result = self.read_chunk(rest.get(CHECKSUM_BYTES..).unwrap_or(&[]), entry, 0, false);
            self.catch_up();
            result?;
        }
        Ok(self.update_since(vertices, triangles))
    }

    /// Returns the table entry of the next chunk to decode, if any.
    fn next_entry(&self) -> Option<ChunkEntry> {
        self.header.as_ref()?.chunks.get(self.chunk_count).copied()
    }

    /// Returns the next chunk without the checksum in front of it, with which it is compared.
    fn checked_chunk<'a>(&self, stored: &'a [u8]) -> Result<&'a [u8], StreamDefect> {
        let (checksum, chunk) = stored.split_at(CHECKSUM_BYTES);
        let expected = checksum.iter().rev().fold(0, |bits, &byte| bits << 8 | u32::from(byte));
        let found = crc32fast::hash(chunk);
        if found == expected {
            return Ok(chunk);
        }
        Err(StreamDefect::Checksum { chunk: self.chunk_count, offset: self.read, found, expected })
    }

    /// Decodes a chunk, complete or truncated. `more` is the number of bytes that are available after it.
    fn read_chunk(
        &mut self,
        bytes: &[u8],
        entry: ChunkEntry,
        more: usize,
        is_complete: bool,
    ) -> Result<(), StreamDefect> {
        let mut reader = RangeReader::new(bytes, is_complete);
        let most_wedges = max_extra_wedges(self.body_bytes() + bytes.len() as u64);
        let Some(refiner) = &mut self.refiner else {
            self.read_base(&mut reader, most_wedges, more)?;
            self.begin_fragments();
            return Ok(());
        };
        if let (Some(fragments), Some(header)) = (&mut self.fragments, &self.header) {
            while fragments.len() < entry.split_count as usize {
                if !fragments.read(&mut reader, header.vertex_count.into())? {
                    let chunk = self.chunk_count;
                    return if is_complete { Err(StreamDefect::TooManyVertices { chunk }) } else { Ok(()) };
                }
            }
            return Ok(());
        }
        refiner.limit_wedges(most_wedges);
        while refiner.split_count() < entry.split_count as usize {
            let most = entry.split_count as usize - refiner.split_count();
            if refiner.stretch(&mut reader, &mut ReaderSource, most)? == CodingResult::Complete {
                continue;
            }
            // A complete chunk never runs out of data unless it is invalid.
            return if is_complete {
                Err(StreamDefect::TooManyVertices { chunk: self.chunk_count })
            } else {
                Ok(())
            };
        }
        Ok(())
    }

    /// Starts the fragments of the base mesh, if the stream has fragments.
    fn begin_fragments(&mut self) {
        let (Some(header), Some(refiner)) = (&self.header, &mut self.refiner) else { return };
        if header.has_fragments {
            refiner.catch_up();
            let integers =
                |layer: usize| refiner.attributes().map_or_else(Vec::new, |all| all.integers(layer).to_vec());
            let integers = (0..header.layers.len()).map(integers).collect();
            self.fragments = Some(Box::new(FragmentReader::new(header, &refiner.level.growth, integers)));
        }
    }

    /// Number of bytes in the chunks that have been decoded, without their checksums.
    fn body_bytes(&self) -> u64 {
        let checksums = (CHECKSUM_BYTES * self.chunk_count) as u64;
        self.header.as_ref().map_or(0, |header| self.read - header.length - checksums)
    }

    /// Decodes the base mesh and sets up the refiner.
    fn read_base(
        &mut self,
        reader: &mut RangeReader<'_>,
        most_wedges: u64,
        more: usize,
    ) -> Result<(), StreamDefect> {
        let Some(header) = &self.header else { return Ok(()) };
        let parameters = StreamParameters {
            has_general: header.has_general,
            effort: header.effort,
            grid: header.grid,
            is_exact: header.is_exact,
            max_patch: if header.has_fragments { 0 } else { header.max_patch },
            position_count: header.position_count,
            base: BaseLimits {
                position_count: header.position_count - header.step_count,
                triangle_count: header.max_base_triangles(),
                extra_wedges: u32::try_from(most_wedges).unwrap_or(u32::MAX),
            },
            vertex_count: header.vertex_count,
            group_count: header.groups.len() as u32,
            layers: header.layers.clone(),
        };
        let mut refiner = MeshRefiner::begin(reader, &Base::default(), &parameters, &mut ReaderSource)?;
        // Enough for any real stream. If the header claims far more steps than there are bytes, the bytes
        // limit what we reserve.
        refiner.reserve((header.step_count as usize).min(more));
        self.refiner = Some(Box::new(refiner));
        Ok(())
    }

    /// Checks that a completely decoded stream has the counts that its header promises.
    fn check_counts(&self) -> Result<(), StreamDefect> {
        let (Some(header), Some(growth)) = (&self.header, self.growth()) else { return Ok(()) };
        let found = match &self.fragments {
            Some(fragments) => [fragments.positions().len(), fragments.triangle_count(), fragments.len()],
            None => [growth.positions.len(), growth.triangle_count(), growth.added.len()],
        };
        let counts = [
            ("vertices", found[0], header.vertex_count),
            ("triangles", found[1], header.triangle_count),
            ("steps", found[2], header.step_count),
        ];
        for (what, found, expected) in counts {
            if found != expected as usize {
                return Err(StreamDefect::Count { what, found: found as u64, expected: u64::from(expected) });
            }
        }
        Ok(())
    }

    /// Brings the list of triangles up to date with the splits decoded so far.
    fn catch_up(&mut self) {
        if let Some(refiner) = self.refiner.as_mut().filter(|_| self.fragments.is_none()) {
            refiner.catch_up();
        }
    }

    /// Returns the mesh decoded so far.
    fn growth(&self) -> Option<&GrowingMesh> {
        self.refiner.as_ref().map(|refiner| &refiner.level.growth)
    }

    /// Number of vertices and of triangles decoded so far.
    fn sizes(&self) -> (usize, usize) {
        (self.positions().len(), self.triangle_count())
    }

    /// Lists the changes since the given vertex and triangle counts.
    fn update_since(&mut self, vertices: usize, triangles: usize) -> StreamUpdate {
        let (vertices_now, triangles_now) = self.sizes();
        let mut changed_triangles = match &mut self.refiner {
            Some(refiner) => std::mem::take(&mut refiner.level.growth.changed),
            None => Vec::new(),
        };
        if self.fragments.is_some() {
            // Fragments leave no triangle in its place.
            changed_triangles = (0..triangles_now as u32).collect();
        }
        changed_triangles.retain(|&t| (t as usize) < triangles);
        changed_triangles.sort_unstable();
        changed_triangles.dedup();
        StreamUpdate {
            vertices: vertices..vertices_now,
            triangles: triangles..triangles_now,
            changed_triangles,
        }
    }

    /// Positions of the vertices decoded so far, in mesh units.
    pub fn positions(&self) -> &[[f32; 3]] {
        match &self.fragments {
            Some(fragments) => fragments.positions(),
            None => self.growth().map_or(&[], |growth| &growth.positions),
        }
    }

    /// Returns the attribute layers of a range of the vertices decoded so far.
    ///
    /// # Panics
    /// If the range extends past the vertices decoded so far.
    pub fn layers_of(&self, vertices: Range<usize>) -> Vec<AttributeLayer> {
        let (Some(header), Some(refiner)) = (&self.header, &self.refiner) else { return Vec::new() };
        let Some(attributes) = refiner.attributes() else { return Vec::new() };
        let integers = |index| match &self.fragments {
            Some(fragments) => fragments.integers(index),
            None => attributes.integers(index),
        };
        let layer = |(index, form): (usize, &LayerForm)| {
            let mut layer = form.empty_layer();
            let n = form.integer_count();
            form.append(&integers(index)[vertices.start * n..vertices.end * n], &mut layer.data);
            layer
        };
        header.layers.iter().enumerate().map(layer).collect()
    }

    /// Number of triangles of the level decoded so far.
    pub fn triangle_count(&self) -> usize {
        match &self.fragments {
            Some(fragments) => fragments.triangle_count(),
            None => self.growth().map_or(0, |growth| growth.triangles.len()),
        }
    }

    /// Triangles of the level decoded so far, in decoding order; those of fragments are listed when they are asked for.
    pub fn triangles(&self) -> &[[u32; 3]] {
        match &self.fragments {
            Some(fragments) => fragments.triangles(),
            None => self.growth().map_or(&[], |growth| &growth.triangles),
        }
    }

    /// Group of each triangle in [`triangles`](Self::triangles); empty if the mesh has at most one group.
    pub fn triangle_groups(&self) -> &[u32] {
        match &self.fragments {
            Some(fragments) => fragments.groups(),
            None => self.growth().map_or(&[], |growth| &growth.groups),
        }
    }

    /// Index of the first vertex of each position decoded so far, followed by the vertex count.
    pub fn first_vertices(&self) -> &[u32] {
        match &self.fragments {
            Some(fragments) => fragments.first_vertex(),
            None => self.growth().map_or(&[], |growth| &growth.first_vertex),
        }
    }

    /// The vertex that each vertex beyond the base collapses to. Its index is always smaller.
    pub fn targets(&self) -> &[u32] {
        self.growth().map_or(&[], |growth| &growth.targets)
    }

    /// Number of triangles that each vertex split added.
    pub fn added_triangle_counts(&self) -> &[u8] {
        self.growth().map_or(&[], |growth| &growth.added)
    }

    /// Returns the mesh decoded so far, in the form that growing models use. It is empty before the base
    /// mesh has been decoded.
    pub fn prefix(&self) -> PrefixMesh<'_> {
        let growth = self.growth().filter(|_| self.fragments.is_none());
        growth.map_or(PrefixMesh::default(), |growth| PrefixMesh {
            positions: &growth.positions,
            first_vertices: &growth.first_vertex,
            targets: &growth.targets,
            triangles: &growth.triangles,
            added_triangle_counts: &growth.added,
        })
    }

    /// Number of vertex splits decoded so far.
    pub fn split_count(&self) -> usize {
        match &self.fragments {
            Some(fragments) => fragments.len(),
            None => self.refiner.as_ref().map_or(0, |refiner| refiner.split_count()),
        }
    }

    /// Properties of the whole stream, or `None` before its header has been decoded.
    pub fn info(&self) -> Option<StreamInfo> {
        self.header.as_ref().map(StreamInfo::of)
    }

    /// Meaning of the numbers of vertex colors; sRGB before the header has been decoded.
    pub fn color_space(&self) -> ColorSpace {
        self.header.as_ref().map_or(ColorSpace::Srgb, |header| header.appearance.color_space)
    }

    /// Place of a terrain on the Earth, JSON; empty if there is none, and before the header has been decoded.
    pub fn georeference(&self) -> &str {
        self.header.as_ref().map_or("", |header| &header.appearance.georeference)
    }

    /// Number of vertex splits in the whole stream, or `None` before its header has been decoded.
    pub fn step_count(&self) -> Option<usize> {
        self.header.as_ref().map(|header| header.step_count as usize)
    }

    /// Whether the whole stream has been decoded.
    pub fn is_complete(&self) -> bool {
        self.header.is_some() && !self.lacks_triangle_data() && self.next_entry().is_none()
    }

    /// Whether the triangles have data that have not arrived. They are at the end of a stream, so only a
    /// complete one gives them to its levels.
    pub fn lacks_triangle_data(&self) -> bool {
        let has_data = self.header.as_ref().is_some_and(|header| header.triangle_data.is_some());
        has_data && self.triangle_layers.is_none()
    }

    /// Number of bytes from the beginning of the stream needed to decode a level. `None` before the header
    /// has been decoded, or if the stream has no such level.
    pub fn bytes_for(&self, split_count: usize) -> Option<u64> {
        let header = self.header.as_ref()?;
        let chunks = header.chunks.partition_point(|entry| (entry.split_count as usize) < split_count) + 1;
        let bytes: u64 = header.chunks.get(..chunks)?.iter().map(|entry| entry.stored_bytes()).sum();
        Some(bytes + header.length)
    }

    /// Upper bound, according to the sequence, of the current level's distance to the full mesh, in mesh
    /// units; 0 at the full mesh. `None` before the header has been decoded.
    pub fn error(&self) -> Option<f32> {
        let header = self.header.as_ref()?;
        Some(header.chunks.get(self.chunk_count).map_or(0.0, |entry| entry.error))
    }

    /// Upper bound, according to the sequence, of a level's distance to the full mesh, in mesh units.
    /// `None` before the header has been decoded.
    pub fn error_at(&self, split_count: usize) -> Option<f32> {
        let header = self.header.as_ref()?;
        let chunk = header.chunks.partition_point(|entry| entry.split_count as usize <= split_count);
        Some(header.chunks.get(chunk).map_or(0.0, |entry| entry.error))
    }

    /// Returns the mesh decoded so far with its collapse sequence, from which every kind of model can be
    /// built.
    ///
    /// `None` before the base mesh has been decoded, and for [streams of fragments](Self::has_fragments).
    pub fn refinable_mesh(&self) -> Option<RefinableMesh> {
        let growth = self.growth().filter(|_| self.fragments.is_none())?;
        let mesh = self.mesh()?;
        let step_count = growth.added.len();
        let error_of = |step: usize| self.error_at(step).unwrap_or(0.0);
        let sequence = CollapseSequence::from_parts(SequenceParts {
            base_position_count: growth.first_vertex.len() - 1 - step_count,
            positions: PositionIndex::from_first(growth.first_vertex.clone()),
            targets: growth.targets.clone(),
            errors: (0..step_count).map(error_of).collect(),
            removed_triangle_counts: growth.added.clone(),
            triangle_count: mesh.triangle_count(),
        });
        Some(RefinableMesh { mesh, sequence: sequence.ok()? })
    }

    /// Whether the steps of the stream are fragments, which any simplifier can make, instead of vertex splits.
    pub fn has_fragments(&self) -> bool {
        self.header.as_ref().is_some_and(|header| header.has_fragments)
    }

    /// Returns the mesh decoded so far with its steps, collapses or fragments.
    ///
    /// `None` before the base mesh has been decoded, and if the fragments of a damaged stream are no sequence.
    pub fn steps(&self) -> Option<Steps> {
        match &self.fragments {
            None => self.refinable_mesh().map(Steps::Collapses),
            Some(fragments) => {
                let error_of = |step| self.error_at(step).unwrap_or(0.0);
                fragments.fragmented_mesh(self.mesh()?, error_of).ok().map(Steps::Fragments)
            }
        }
    }

    /// Returns the mesh decoded so far, its triangles sorted by group.
    fn mesh(&self) -> Option<IndexedMesh> {
        let header = self.header.as_ref()?;
        self.growth()?;
        let (triangles, groups) = self.grouped_triangles();
        let mut mesh = IndexedMesh {
            positions: self.positions().to_vec(),
            origin: header.origin,
            exact_positions: Vec::new(),
            triangles,
            groups,
            layers: self.layers_of(0..self.positions().len()),
            triangle_layers: Vec::new(),
            appearance: header.appearance.clone(),
        };
        triangle_data::attach(&mut mesh, self.triangle_layers.as_deref().unwrap_or_default());
        Some(mesh)
    }

    /// Returns the triangles sorted by group, and the groups.
    fn grouped_triangles(&self) -> (Vec<[u32; 3]>, Vec<TriangleGroup>) {
        let Some(header) = &self.header else { return Default::default() };
        let (triangles, groups_of) = (self.triangles(), self.triangle_groups());
        if header.groups.len() < 2 {
            let count = triangles.len() as u32;
            let group = |name: &GroupName| TriangleGroup {
                name: name.name.clone(),
                material: name.material,
                first: 0,
                count,
            };
            return (triangles.to_vec(), header.groups.iter().map(group).collect());
        }
        let mut counts = vec![0u32; header.groups.len()];
        groups_of.iter().for_each(|&g| counts[g as usize] += 1);
        let mut first = 0;
        let mut groups = Vec::with_capacity(counts.len());
        for (name, &count) in header.groups.iter().zip(&counts) {
            groups.push(TriangleGroup { name: name.name.clone(), material: name.material, first, count });
            first += count;
        }
        let mut order: Vec<u32> = (0..triangles.len() as u32).collect();
        order.sort_by_key(|&t| groups_of[t as usize]);
        (order.iter().map(|&t| triangles[t as usize]).collect(), groups)
    }
}
