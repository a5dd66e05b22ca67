//! Triangles of a file, block by block.

use std::fs::File;
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;
use std::sync::Arc;

use striata::mesh::{AttributeLayer, Bounds};
use striata_strip::{Block, BlockCurve, BlockSource, BlockTriangle, block_length};

use super::binary_ply::BinaryPly;
use super::paged::CachedFile;
use super::scratch::ScratchFolder;
use super::sorter::{SortRecord, SortedRecords, Sorter};
use crate::error::{Fault, Place};
use crate::file_view::FileView;
use crate::lost_data::{self, name_of};
use crate::pieces::PieceSource;
use crate::ply::PlyStream;
use crate::repair::check_triangles;
use crate::report::Warnings;
use crate::{Format, ReadError, Warning};

/// Mesh of a file as blocks of triangles for [`stripify_blocks`](striata_strip::stripify_blocks).
#[derive(Debug)]
pub struct TriangleBlocks {
    pub(super) stream: PlyStream,
    warnings: Vec<Warning>,
    /// Layers of the triangles, without values.
    triangle_layers: Vec<AttributeLayer>,
    scratch: ScratchFolder,
    /// Corners of all triangles, block by block.
    triangles: File,
    /// First triangle of each block, followed by the triangle count.
    starts: Vec<u64>,
    /// Last block that uses each vertex.
    last_blocks: CachedFile,
    bounds: Option<Bounds>,
}

const TRIANGLE_BYTES: usize = 12;

impl TriangleBlocks {
    /// Cuts the mesh of a file into blocks of at most `block_triangles` triangles (at least one).
    ///
    /// Binary PLY is read in place. Text PLY, STL, OBJ, OFF, glTF, terrains (with the feature `terrain`), and
    /// compressed files are converted first. Temporary files are created in the folder `scratch`.
    ///
    /// # Errors
    /// Returns [`ReadError`] if the file has another format or is damaged, or if a file cannot be read or
    /// written.
    pub fn open(path: &Path, block_triangles: usize, scratch: &Path) -> Result<Self, ReadError> {
        let scratch = ScratchFolder { folder: scratch.to_owned() };
        let ply = BinaryPly::open(path, &scratch)?;
        let (ply, bounds) = match bounds_of(&ply.stream)? {
            Ok(bounds) => (ply, bounds),
            // Vertices that are no points: the file cannot be read in place.
            Err(_) => BinaryPly::repaired(path, &scratch).and_then(bounded)?,
        };
        Self::cut(ply, bounds, block_triangles, scratch)
    }

    /// Cuts pieces into blocks, as [`open`](Self::open) does with a file.
    ///
    /// Vertices with equal positions and attributes become one.
    ///
    /// # Errors
    /// See [`open`](Self::open).
    pub fn of_pieces(
        pieces: &dyn PieceSource,
        block_triangles: usize,
        scratch: &Path,
    ) -> Result<Self, ReadError> {
        let scratch = ScratchFolder { folder: scratch.to_owned() };
        let (ply, bounds) = BinaryPly::of_pieces(pieces, &scratch).and_then(bounded)?;
        Self::cut(ply, bounds, block_triangles, scratch)
    }

    fn cut(
        ply: BinaryPly,
        bounds: Option<Bounds>,
        block_triangles: usize,
        scratch: ScratchFolder,
    ) -> Result<Self, ReadError> {
        let BinaryPly { stream, warnings, triangle_layers } = ply;
        let sorted = sorted_triangles(&stream, bounds, &scratch)?;
        let cutter = BlockCutter::new(&stream, &scratch)?;
        let BlockFiles { triangles, starts, last_blocks } =
            cutter.run(sorted, block_triangles.max(1)).map_err(|error| scratch.error(error))?;
        let triangle_count = starts.last().copied().unwrap_or(0) as usize;
        let known = Warnings::of_list(stream.name(), warnings.clone());
        check_triangles([stream.vertex_count as usize, triangle_count], triangle_count, &known)?;
        Ok(Self { stream, warnings, triangle_layers, scratch, triangles, starts, last_blocks, bounds })
    }

    /// Returns remarks on what was left out, such as materials.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// Returns the number of vertices of the mesh.
    pub fn vertex_count(&self) -> u32 {
        self.stream.vertex_count
    }

    /// Returns the number of triangles of the mesh, including degenerate ones.
    pub fn triangle_count(&self) -> u64 {
        self.starts.last().copied().unwrap_or(0)
    }

    /// Returns the point of the file's coordinates that positions are relative to.
    pub fn origin(&self) -> [f64; 3] {
        self.stream.origin
    }

    /// Returns remarks on what a file of strips in this format cannot store: data of triangles, and values
    /// of attributes that the format has no place for.
    ///
    /// # Errors
    /// Returns [`ReadError`] if the vertices cannot be read.
    pub fn losses(&self, format: Format) -> Result<Vec<Warning>, ReadError> {
        let mut warnings = Warnings::of_file(self.stream.name());
        for layer in &self.triangle_layers {
            let reason = format!("the property {} of faces is left out: strips have none", name_of(layer));
            warnings.push(Place::File, reason);
        }
        self.stream.for_each_row_batch(|_, rows| {
            lost_data::warn(format, &self.stream.vertices(rows)?, &mut warnings);
            Ok::<_, ReadError>(())
        })?;
        Ok(warnings.into_list())
    }

    /// Returns the bounds of the mesh relative to its [`origin`](Self::origin), or [`None`] if it has no
    /// vertices.
    pub fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }
}

impl BlockSource for TriangleBlocks {
    type Error = ReadError;

    fn block_count(&self) -> u32 {
        (self.starts.len() - 1) as u32
    }

    fn read_block(&mut self, index: u32, block: &mut Block) -> Result<(), ReadError> {
        self.fill(index as usize, block).map_err(|error| self.scratch.error(error))
    }
}

impl TriangleBlocks {
    /// Reads a block from the temporary files.
    fn fill(&mut self, index: usize, block: &mut Block) -> io::Result<()> {
        let (start, end) = (self.starts[index], self.starts[index + 1]);
        let mut bytes = vec![0; (end - start) as usize * TRIANGLE_BYTES];
        self.triangles.seek(SeekFrom::Start(start * TRIANGLE_BYTES as u64))?;
        self.triangles.read_exact(&mut bytes)?;
        block.group = 0;
        block.triangles.clear();
        for corners in bytes.as_chunks::<TRIANGLE_BYTES>().0.iter().map(corners_of) {
            let [a, b, c] = corners;
            let mut last = |vertex| self.last_blocks.read_u32(vertex);
            let last_blocks = [last(a)?, last(b)?, last(c)?];
            block.triangles.push(BlockTriangle { corners, last_blocks });
        }
        Ok(())
    }
}

fn corners_of(bytes: &[u8; TRIANGLE_BYTES]) -> [u32; 3] {
    [0, 4, 8].map(|at| u32::from_le_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]))
}

/// Adds the bounds of all vertices; fails if a coordinate is not finite.
fn bounded(ply: BinaryPly) -> Result<(BinaryPly, Option<Bounds>), ReadError> {
    let bounds = bounds_of(&ply.stream)?.map_err(|fault| fault.in_file(ply.stream.name()))?;
    Ok((ply, bounds))
}

/// Computes the bounds of all vertices; the inner result says which coordinate is not finite.
fn bounds_of(stream: &PlyStream) -> Result<Result<Option<Bounds>, Fault>, ReadError> {
    let mut bounds: Option<Bounds> = None;
    let mut strange = None;
    stream.for_each_row_batch(|first, rows| {
        for (vertex, row) in (first..).zip(rows.chunks_exact(stream.stride)) {
            let position = stream.position(row);
            if let Some(axis) = position.iter().position(|x| !x.is_finite()) {
                strange.get_or_insert((vertex, axis, position[axis]));
            }
            let all = bounds.get_or_insert(Bounds { min: position, max: position });
            for (axis, x) in position.into_iter().enumerate() {
                all.min[axis] = all.min[axis].min(x);
                all.max[axis] = all.max[axis].max(x);
            }
        }
        Ok(())
    })?;
    let Some((vertex, axis, value)) = strange else { return Ok(Ok(bounds)) };
    let place = Place::Byte(stream.vertices_offset + u64::from(vertex) * stream.stride as u64);
    let reason = format!("vertex {vertex} has the coordinate {value} on axis {axis}");
    Ok(Err(Fault::Malformed(place, reason)))
}

/// Sorts all triangles in the order in which a space-filling curve visits their centers.
fn sorted_triangles(
    stream: &PlyStream,
    bounds: Option<Bounds>,
    scratch: &ScratchFolder,
) -> Result<SortedRecords, ReadError> {
    let curve = BlockCurve::new(bounds);
    let mut sorter = Sorter::new(scratch.file()?);
    let vertices_bytes = u64::from(stream.vertex_count) * stream.stride as u64;
    let mut vertices = CachedFile::new(stream.file(), stream.vertices_offset, vertices_bytes);
    let mut row = vec![0; stream.stride];
    let mut index = 0u32;
    stream.for_each_triangle(|corners| {
        let mut points = [[0.0; 3]; 3];
        for (point, vertex) in points.iter_mut().zip(corners) {
            let at = u64::from(vertex) * stream.stride as u64;
            vertices.read(at, &mut row).map_err(|error| stream.io(error))?;
            *point = stream.position(&row);
        }
        let record = SortRecord { key: curve.key(points), index, corners };
        index = index.checked_add(1).ok_or_else(|| {
            let reason = format!("more than {} triangles cannot be numbered", u32::MAX);
            Fault::Malformed(Place::File, reason).in_file(stream.name())
        })?;
        sorter.push(record).map_err(|error| scratch.error(error))
    })?;
    sorter.merged().map_err(|error| scratch.error(error))
}

/// Files and offsets of all blocks, as in [`TriangleBlocks`].
struct BlockFiles {
    triangles: File,
    starts: Vec<u64>,
    last_blocks: CachedFile,
}

/// Cuts sorted triangles into blocks, and records the last block that uses each vertex.
struct BlockCutter {
    triangles: BufWriter<File>,
    last_blocks: CachedFile,
    starts: Vec<u64>,
    /// The next triangles, in the order of their keys.
    ahead: Vec<SortRecord>,
}

impl BlockCutter {
    fn new(stream: &PlyStream, scratch: &ScratchFolder) -> Result<Self, ReadError> {
        let last_blocks = scratch.file()?;
        let bytes = u64::from(stream.vertex_count) * 4;
        last_blocks.set_len(bytes).map_err(|error| scratch.error(error))?;
        Ok(Self {
            triangles: BufWriter::with_capacity(1 << 16, scratch.file()?),
            last_blocks: CachedFile::new(FileView::new(Arc::new(last_blocks)), 0, bytes),
            starts: vec![0],
            ahead: Vec::new(),
        })
    }

    fn run(mut self, mut sorted: SortedRecords, longest: usize) -> io::Result<BlockFiles> {
        loop {
            while self.ahead.len() <= longest {
                let Some(record) = sorted.next()? else { break };
                self.ahead.push(record);
            }
            let length = block_length(&self.ahead, |record| record.key, longest);
            if length == 0 {
                break;
            }
            self.end_block(length)?;
        }
        let triangles = self.triangles.into_inner().map_err(io::IntoInnerError::into_error)?;
        Ok(BlockFiles { triangles, starts: self.starts, last_blocks: self.last_blocks })
    }

    fn end_block(&mut self, length: usize) -> io::Result<()> {
        let block = (self.starts.len() - 1) as u32;
        // Neighbors in a file are often neighbors in a row of triangles, which strips follow well.
        self.ahead[..length].sort_unstable_by_key(|record| record.index);
        for record in self.ahead.drain(..length) {
            for vertex in record.corners {
                self.last_blocks.write_u32(vertex, block)?;
                self.triangles.write_all(&vertex.to_le_bytes())?;
            }
        }
        self.starts.push(self.starts[block as usize] + length as u64);
        Ok(())
    }
}
