//! Numbers the vertices of triangles whose corners have keys, and writes both to a binary PLY file.
//!
//! Equal keys are one vertex, numbered where it occurs first. Keys are found again by sorting, so that memory
//! does not grow with the mesh:
//!
//! ```text
//! corners --sort by key----> (corner, first corner with its key)
//!         --sort by corner-> number of each corner; a first corner gets the next number and writes its row
//! ```
//!
//! The temporary files take 156 bytes per triangle, besides the PLY file itself.

use std::fs::File;
use std::io::{self, BufWriter, Seek as _, SeekFrom, Write};
use std::sync::Arc;

use super::paged::PagedFile;
use super::scratch::ScratchFolder;
use super::sorter::{Record, SortedRecords, Sorter};
use crate::ReadError;
use crate::error::{Fault, Place};
use crate::file_view::FileView;

/// Number of digits that are left for counts.
const DIGITS: usize = 10;

/// Triangles whose corners have keys; corners with equal keys are the same vertex.
pub(super) trait KeyedTriangles {
    /// Name of the input, for messages.
    fn name(&self) -> &str;

    /// Names of the vertex properties after the position; all are floats.
    fn properties(&self) -> Vec<String>;

    /// Passes the keys of all triangles to `visit`, always in the same order.
    fn for_each(
        &self,
        visit: &mut dyn FnMut([[u32; 3]; 3]) -> Result<(), ReadError>,
    ) -> Result<(), ReadError>;

    /// Appends the values of the vertex with this key, as little-endian floats.
    fn push_row(&self, key: [u32; 3], row: &mut Vec<u8>);
}

/// Writes triangles whose vertices are those with keys `[0, none, none]`, `[1, none, none]` and so on.
pub(super) fn write_in_file_order(
    triangles: &dyn KeyedTriangles,
    vertex_count: usize,
    scratch: &ScratchFolder,
) -> Result<File, ReadError> {
    let mut ply = PlyWriter::new(triangles, scratch)?;
    for vertex in 0..vertex_count as u32 {
        ply.vertex(triangles, [vertex, u32::MAX, u32::MAX])?;
    }
    triangles.for_each(&mut |keys| ply.face(keys.map(|key| key[0])))?;
    ply.finish()
}

/// Writes triangles whose corners share vertices if their keys are equal.
pub(super) fn write_shared(
    triangles: &dyn KeyedTriangles,
    scratch: &ScratchFolder,
) -> Result<File, ReadError> {
    let mut firsts = first_corners(triangles, scratch)?;
    let io = |error| scratch.error(error);
    let mut ply = PlyWriter::new(triangles, scratch)?;
    let numbers_file = scratch.file()?;
    let numbers_bytes = 4 * firsts.corner_count;
    numbers_file.set_len(numbers_bytes).map_err(io)?;
    let mut numbers = PagedFile::new(FileView::new(Arc::new(numbers_file)), 0, numbers_bytes);
    triangles.for_each(&mut |keys| {
        let mut corners = [0; 3];
        for (corner, key) in corners.iter_mut().zip(keys) {
            let Some(Record { key: place, index: first, .. }) = firsts.sorted.next().map_err(io)? else {
                return Err(scratch.error(io::ErrorKind::UnexpectedEof.into()));
            };
            *corner = if place == u64::from(first) {
                let number = ply.vertex_count;
                ply.vertex(triangles, key)?;
                numbers.write_u32(first, number).map_err(io)?;
                number
            } else {
                numbers.read_u32(first).map_err(io)?
            };
        }
        ply.face(corners)
    })?;
    ply.finish()
}

/// For each corner the first one with the same key, in the order of corners.
struct FirstCorners {
    sorted: SortedRecords,
    corner_count: u64,
}

fn first_corners(triangles: &dyn KeyedTriangles, scratch: &ScratchFolder) -> Result<FirstCorners, ReadError> {
    let io = |error| scratch.error(error);
    let mut by_key = Sorter::new(scratch.file()?);
    let mut next = 0u32;
    triangles.for_each(&mut |keys| {
        for [a, b, c] in keys {
            let key = u64::from(a) << 32 | u64::from(b);
            by_key.push(Record { key, index: c, corners: [next, 0, 0] }).map_err(io)?;
            next = next.checked_add(1).ok_or_else(|| {
                let reason = format!("more than {} triangles cannot be numbered", u32::MAX / 3);
                Fault::Malformed(Place::File, reason).in_file(triangles.name())
            })?;
        }
        Ok(())
    })?;
    let mut by_corner = Sorter::new(scratch.file()?);
    let mut sorted = by_key.merged().map_err(io)?;
    let mut last: Option<Record> = None;
    while let Some(record) = sorted.next().map_err(io)? {
        let same = last.filter(|last| (last.key, last.index) == (record.key, record.index));
        let first = same.unwrap_or(record);
        last = Some(first);
        let (corner, first) = (record.corners[0], first.corners[0]);
        by_corner.push(Record { key: u64::from(corner), index: first, corners: [0; 3] }).map_err(io)?;
    }
    drop(sorted);
    Ok(FirstCorners { sorted: by_corner.merged().map_err(io)?, corner_count: u64::from(next) })
}

/// PLY file under construction: vertices, and faces in another file until all vertices are known.
struct PlyWriter<'a> {
    out: BufWriter<File>,
    faces: BufWriter<File>,
    row: Vec<u8>,
    vertex_count: u32,
    face_count: u32,
    /// Where the counts of vertices and of faces belong.
    counts_at: [u64; 2],
    scratch: &'a ScratchFolder,
}

impl<'a> PlyWriter<'a> {
    fn new(triangles: &dyn KeyedTriangles, scratch: &'a ScratchFolder) -> Result<Self, ReadError> {
        let buffered = || Ok::<_, ReadError>(BufWriter::with_capacity(1 << 16, scratch.file()?));
        let (mut out, faces) = (buffered()?, buffered()?);
        let mut head = "ply\nformat binary_little_endian 1.0\nelement vertex ".to_owned();
        let vertices_at = head.len() as u64;
        head += &format!("{:0DIGITS$}\n", 0);
        for name in ["x", "y", "z"].map(str::to_owned).into_iter().chain(triangles.properties()) {
            head += &format!("property float {name}\n");
        }
        head += "element face ";
        let counts_at = [vertices_at, head.len() as u64];
        head += &format!("{:0DIGITS$}\nproperty list uchar uint vertex_indices\nend_header\n", 0);
        out.write_all(head.as_bytes()).map_err(|error| scratch.error(error))?;
        Ok(Self { out, faces, row: Vec::new(), vertex_count: 0, face_count: 0, counts_at, scratch })
    }

    fn vertex(&mut self, triangles: &dyn KeyedTriangles, key: [u32; 3]) -> Result<(), ReadError> {
        self.row.clear();
        triangles.push_row(key, &mut self.row);
        self.vertex_count += 1;
        self.out.write_all(&self.row).map_err(|error| self.scratch.error(error))
    }

    fn face(&mut self, corners: [u32; 3]) -> Result<(), ReadError> {
        let mut row = [3; 13];
        for (bytes, corner) in row[1..].chunks_exact_mut(4).zip(corners) {
            bytes.copy_from_slice(&corner.to_le_bytes());
        }
        self.face_count += 1;
        self.faces.write_all(&row).map_err(|error| self.scratch.error(error))
    }

    fn finish(self) -> Result<File, ReadError> {
        let scratch = self.scratch;
        self.joined().map_err(|error| scratch.error(error))
    }

    /// Appends the faces and fills in the counts.
    fn joined(self) -> io::Result<File> {
        let Self { mut out, faces, vertex_count, face_count, counts_at, .. } = self;
        let mut faces = faces.into_inner().map_err(io::IntoInnerError::into_error)?;
        faces.seek(SeekFrom::Start(0))?;
        io::copy(&mut faces, &mut out)?;
        for (at, count) in counts_at.into_iter().zip([vertex_count, face_count]) {
            out.seek(SeekFrom::Start(at))?;
            out.write_all(format!("{count:0DIGITS$}").as_bytes())?;
        }
        out.into_inner().map_err(io::IntoInnerError::into_error)
    }
}
