//! The reader's front: bytes in as they arrive, vertices and triangles out.

use std::ops::Range;

use striata::mesh::{
    AttributeLayer, CollapseSequence, IndexedMesh, PositionIndex, RefinableMesh, SequenceParts, TriangleGroup,
};

use crate::base::coder::BaseLimits;
use crate::base::mesh::Base;
use crate::entropy::RangeReader;
use crate::format::error::{DecodeError, StreamDefect};
use crate::format::head::{FIXED_BYTES, GroupName, Head, Row, head_length, most_wedges_beyond};
use crate::layers::form::LayerForm;
use crate::reader::prefix::PrefixMesh;
use crate::refine::growth::Growth;
use crate::refine::refiner::{Ended, Refiner};
use crate::refine::source::Unknown;
use crate::refine::terms::Terms;

/// What some bytes have brought: append [`vertices`](Self::vertices) to a vertex buffer, write
/// [`changed_triangles`](Self::changed_triangles) of an index buffer anew, append [`triangles`](Self::triangles).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct StreamUpdate {
    /// Vertices that are new, at the end of the vertex buffer.
    pub vertices: Range<usize>,
    /// Triangles that are new, at the end of the index buffer.
    pub triangles: Range<usize>,
    /// Older triangles with other corners now, ascending.
    pub changed_triangles: Vec<u32>,
}

/// Reads a progressive stream: takes slices of bytes as they arrive, and holds the mesh of what has come.
///
/// A chunk is read once all its bytes are there and its checksum holds. Where the bytes end for good,
/// [`finish`](Self::finish) reads what the rest of them tell.
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
    /// Bytes that have come and are not read yet.
    waiting: Vec<u8>,
    /// Bytes that have been read.
    read: u64,
    head: Option<Head>,
    refiner: Option<Box<Refiner>>,
    /// Chunks read.
    chunk_count: usize,
    /// No more bytes are of use.
    is_over: bool,
}

impl StreamDecoder {
    /// Nothing read yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes the next bytes of the stream and reads all chunks that are complete.
    ///
    /// # Errors
    /// [`DecodeError`] if the bytes are no sound stream, or go on after its end ([`DecodeError::FileLength`] with the bytes found so far
    /// and the length of the stream). What was read before stays, and more bytes are of no use.
    pub fn push(&mut self, bytes: &[u8]) -> Result<StreamUpdate, DecodeError> {
        self.check_open()?;
        let before = self.sizes();
        let mut waiting = std::mem::take(&mut self.waiting);
        waiting.extend_from_slice(bytes);
        let start = self.read;
        let result = self.read_all(&waiting);
        self.catch_up();
        self.is_over = result.is_err();
        // Once for all chunks, since what follows them moves.
        waiting.drain(..(self.read - start) as usize);
        self.waiting = waiting;
        result?;
        Ok(self.update_since(before))
    }

    /// Reads the head and the chunks that are whole.
    fn read_all(&mut self, mut bytes: &[u8]) -> Result<(), DecodeError> {
        if self.head.is_none() {
            let Some(length) = head_length(bytes)?.filter(|&n| n <= bytes.len()) else { return Ok(()) };
            self.head = Some(Head::from_bytes(&bytes[..length])?);
            self.read += length as u64;
            bytes = &bytes[length..];
        }
        while let Some(row) = self.next_row().filter(|row| row.bytes as usize <= bytes.len()) {
            let (chunk, rest) = bytes.split_at(row.bytes as usize);
            self.check_chunk(chunk, row)?;
            self.read_chunk(chunk, row, (rest.len(), true))?;
            self.read += u64::from(row.bytes);
            self.chunk_count += 1;
            bytes = rest;
        }
        if self.next_row().is_some() {
            return Ok(());
        }
        self.check_counts()?;
        self.check_end(bytes.len())
    }

    /// The whole stream is read: no bytes may follow it.
    fn check_end(&self, more: usize) -> Result<(), DecodeError> {
        if more == 0 {
            return Ok(());
        }
        Err(DecodeError::FileLength { found: self.read + more as u64, expected: self.read })
    }

    /// # Errors
    /// Where what came before was no sound stream, or was said to be all.
    fn check_open(&self) -> Result<(), DecodeError> {
        if !self.is_over {
            return Ok(());
        }
        let offset = self.read as usize;
        Err(DecodeError::Malformed { offset, reason: "reading has ended here" })
    }

    /// Reads what a last, incomplete chunk tells, its checksum unknown. No more bytes can follow.
    ///
    /// # Errors
    /// [`DecodeError`] where the stream ends before its base mesh does, or what is there makes no sense.
    pub fn finish(&mut self) -> Result<StreamUpdate, DecodeError> {
        self.check_open()?;
        let before = self.sizes();
        if self.head.is_none() {
            let (found, expected) = (self.waiting.len() as u64, FIXED_BYTES as u64);
            return Err(DecodeError::FileLength { found, expected: expected.max(found + 1) });
        }
        if self.chunk_count == 0 {
            return Err(StreamDefect::NoBase.into());
        }
        self.is_over = true;
        if let Some(row) = self.next_row() {
            let rest = std::mem::take(&mut self.waiting);
            let result = self.read_chunk(&rest, row, (0, false));
            self.catch_up();
            result?;
        }
        Ok(self.update_since(before))
    }

    fn next_row(&self) -> Option<Row> {
        self.head.as_ref()?.rows.get(self.chunk_count).copied()
    }

    fn check_chunk(&self, chunk: &[u8], row: Row) -> Result<(), StreamDefect> {
        let found = crc32fast::hash(chunk);
        if found == row.checksum {
            return Ok(());
        }
        Err(StreamDefect::Checksum {
            chunk: self.chunk_count,
            offset: self.read,
            found,
            expected: row.checksum,
        })
    }

    /// Reads a chunk, whole or cut off; so many bytes behind it are there.
    fn read_chunk(
        &mut self,
        bytes: &[u8],
        row: Row,
        (more, is_complete): (usize, bool),
    ) -> Result<(), StreamDefect> {
        let mut reader = RangeReader::new(bytes, is_complete);
        let most_wedges = most_wedges_beyond(self.body_bytes() + bytes.len() as u64);
        let Some(refiner) = &mut self.refiner else {
            return self.read_base(&mut reader, (most_wedges, more));
        };
        refiner.limit_wedges(most_wedges);
        while refiner.split_count() < row.split_count as usize {
            let most = row.split_count as usize - refiner.split_count();
            if refiner.stretch(&mut reader, &mut Unknown, most)? == Ended::Whole {
                continue;
            }
            // The bytes of a whole chunk do not end.
            return if is_complete { Err(StreamDefect::Wedges { chunk: self.chunk_count }) } else { Ok(()) };
        }
        Ok(())
    }

    /// Bytes of the chunks that have been read.
    fn body_bytes(&self) -> u64 {
        self.head.as_ref().map_or(0, |head| self.read - head.length)
    }

    fn read_base(
        &mut self,
        reader: &mut RangeReader<'_>,
        (most_wedges, more): (u64, usize),
    ) -> Result<(), StreamDefect> {
        let Some(head) = &self.head else { return Ok(()) };
        let terms = Terms {
            version: head.version,
            has_general: head.has_general,
            effort: head.effort,
            grid: head.grid,
            is_exact: head.is_exact,
            max_patch: head.max_patch,
            position_count: head.position_count,
            base: BaseLimits {
                position_count: head.position_count - head.step_count,
                triangle_count: head.most_base_triangles(),
                wedges_beyond: u32::try_from(most_wedges).unwrap_or(u32::MAX),
            },
            vertex_count: head.vertex_count,
            group_count: head.groups.len() as u32,
            layers: head.layers.clone(),
        };
        let mut refiner = Refiner::begin(reader, &Base::default(), &terms, &mut Unknown)?;
        // As much as real streams need; what lies about its size gets no more than the bytes that are there are worth.
        refiner.reserve((head.step_count as usize).min(more));
        self.refiner = Some(Box::new(refiner));
        Ok(())
    }

    /// The whole stream is read: it must be what its head says.
    fn check_counts(&self) -> Result<(), StreamDefect> {
        let (Some(head), Some(growth)) = (&self.head, self.growth()) else { return Ok(()) };
        let counts = [
            ("vertices", growth.positions.len(), head.vertex_count),
            ("triangles", growth.triangle_count(), head.triangle_count),
            ("steps", growth.added.len(), head.step_count),
        ];
        for (what, found, expected) in counts {
            if found != expected as usize {
                return Err(StreamDefect::Count { what, found: found as u64, expected: u64::from(expected) });
            }
        }
        Ok(())
    }

    /// Brings the list of triangles up to date with what has been read.
    fn catch_up(&mut self) {
        if let Some(refiner) = &mut self.refiner {
            refiner.catch_up();
        }
    }

    fn growth(&self) -> Option<&Growth> {
        self.refiner.as_ref().map(|refiner| &refiner.level.growth)
    }

    fn sizes(&self) -> (usize, usize) {
        self.growth().map_or((0, 0), |growth| (growth.positions.len(), growth.triangles.len()))
    }

    fn update_since(&mut self, (vertices, triangles): (usize, usize)) -> StreamUpdate {
        let (vertices_now, triangles_now) = self.sizes();
        let mut changed_triangles = match &mut self.refiner {
            Some(refiner) => std::mem::take(&mut refiner.level.growth.changed),
            None => Vec::new(),
        };
        changed_triangles.retain(|&t| (t as usize) < triangles);
        changed_triangles.sort_unstable();
        changed_triangles.dedup();
        StreamUpdate {
            vertices: vertices..vertices_now,
            triangles: triangles..triangles_now,
            changed_triangles,
        }
    }

    /// Positions of the vertices that have come, mesh units.
    pub fn positions(&self) -> &[[f32; 3]] {
        self.growth().map_or(&[], |growth| &growth.positions)
    }

    /// The attribute layers of some of the vertices that have come.
    ///
    /// # Panics
    /// If some of the vertices have not.
    pub fn layers_of(&self, vertices: Range<usize>) -> Vec<AttributeLayer> {
        let (Some(head), Some(refiner)) = (&self.head, &self.refiner) else { return Vec::new() };
        let Some(attributes) = refiner.attributes() else { return Vec::new() };
        let layer = |(index, form): (usize, &LayerForm)| {
            let mut layer = form.empty_layer();
            let n = form.integer_count();
            form.append(&attributes.integers(index)[vertices.start * n..vertices.end * n], &mut layer.data);
            layer
        };
        head.layers.iter().enumerate().map(layer).collect()
    }

    /// Triangles of the level that has come, in the order in which they came.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.growth().map_or(&[], |growth| &growth.triangles)
    }

    /// The group of each of these triangles; empty where the mesh has no more than one.
    pub fn triangle_groups(&self) -> &[u32] {
        self.growth().map_or(&[], |growth| &growth.groups)
    }

    /// First vertex of each position that has come, closed by the number of vertices.
    pub fn first_vertices(&self) -> &[u32] {
        self.growth().map_or(&[], |growth| &growth.first_vertex)
    }

    /// The vertex that each vertex beyond the base collapses to; it has a smaller number.
    pub fn targets(&self) -> &[u32] {
        self.growth().map_or(&[], |growth| &growth.targets)
    }

    /// Triangles that each vertex split has brought.
    pub fn added_triangle_counts(&self) -> &[u8] {
        self.growth().map_or(&[], |growth| &growth.added)
    }

    /// What has come, as models that grow with it take it; empty before the base has come.
    pub fn prefix(&self) -> PrefixMesh<'_> {
        self.growth().map_or(PrefixMesh::default(), |growth| PrefixMesh {
            positions: &growth.positions,
            first_vertices: &growth.first_vertex,
            targets: &growth.targets,
            triangles: &growth.triangles,
            added_triangle_counts: &growth.added,
        })
    }

    /// Vertex splits that have come.
    pub fn split_count(&self) -> usize {
        self.refiner.as_ref().map_or(0, |refiner| refiner.split_count())
    }

    /// Vertex splits of the whole stream; none before its head has come.
    pub fn step_count(&self) -> Option<usize> {
        self.head.as_ref().map(|head| head.step_count as usize)
    }

    /// True where the whole stream has been read.
    pub fn is_complete(&self) -> bool {
        self.head.is_some() && self.next_row().is_none()
    }

    /// Bytes from the beginning of the stream after which a level is there; none before the head has come, or if
    /// there is no such level.
    pub fn bytes_for(&self, split_count: usize) -> Option<u64> {
        let head = self.head.as_ref()?;
        let chunks = head.rows.partition_point(|row| (row.split_count as usize) < split_count) + 1;
        let bytes: u64 = head.rows.get(..chunks)?.iter().map(|row| u64::from(row.bytes)).sum();
        Some(bytes + head.length)
    }

    /// How far the level is from the full mesh at most as far as the sequence tells, mesh units; 0 at the end.
    pub fn error(&self) -> Option<f32> {
        let head = self.head.as_ref()?;
        Some(head.rows.get(self.chunk_count).map_or(0.0, |row| row.error))
    }

    /// How far a level is from the full mesh at most as far as the sequence tells, mesh units; none before the head has come.
    pub fn error_at(&self, split_count: usize) -> Option<f32> {
        let head = self.head.as_ref()?;
        let chunk = head.rows.partition_point(|row| row.split_count as usize <= split_count);
        Some(head.rows.get(chunk).map_or(0.0, |row| row.error))
    }

    /// What has come as a mesh with the sequence that leads to it: models are built from it as from any other.
    ///
    /// None before the base has come.
    pub fn refinable_mesh(&self) -> Option<RefinableMesh> {
        let (head, growth) = (self.head.as_ref()?, self.growth()?);
        let (triangles, groups) = self.grouped_triangles();
        let mesh = IndexedMesh {
            positions: growth.positions.clone(),
            triangles,
            groups,
            layers: self.layers_of(0..growth.positions.len()),
            appearance: head.appearance.clone(),
        };
        let step_count = growth.added.len();
        let error_of = |step: usize| {
            let chunk = head.rows.partition_point(|row| row.split_count as usize <= step);
            head.rows.get(chunk).map_or(0.0, |row| row.error)
        };
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

    /// Triangles group after group, and the groups.
    fn grouped_triangles(&self) -> (Vec<[u32; 3]>, Vec<TriangleGroup>) {
        let (Some(head), Some(growth)) = (&self.head, self.growth()) else { return Default::default() };
        if head.groups.len() < 2 {
            let count = growth.triangles.len() as u32;
            let group = |name: &GroupName| TriangleGroup {
                name: name.name.clone(),
                material: name.material,
                first: 0,
                count,
            };
            return (growth.triangles.clone(), head.groups.iter().map(group).collect());
        }
        let mut counts = vec![0u32; head.groups.len()];
        growth.groups.iter().for_each(|&g| counts[g as usize] += 1);
        let mut first = 0;
        let mut groups = Vec::with_capacity(counts.len());
        for (name, &count) in head.groups.iter().zip(&counts) {
            groups.push(TriangleGroup { name: name.name.clone(), material: name.material, first, count });
            first += count;
        }
        let mut order: Vec<u32> = (0..growth.triangles.len() as u32).collect();
        order.sort_by_key(|&t| growth.groups[t as usize]);
        (order.iter().map(|&t| growth.triangles[t as usize]).collect(), groups)
    }
}
