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
use std::io;
use std::sync::Arc;

use super::paged::CachedFile;
use super::ply_writer::PlyWriter;
use super::scratch::ScratchFolder;
use super::sorter::{SortRecord, SortedRecords, Sorter};
use crate::ReadError;
use crate::error::{Fault, Place};
use crate::file_view::FileView;
use crate::pieces::PieceSummary;

/// Identifies a vertex.
pub(super) type Key = [u32; 3];

/// Triangle whose corners have keys.
pub(super) struct KeyedTriangle<'a> {
    pub keys: [Key; 3],
    /// Appends the row of a corner: position and layers, little-endian.
    pub push_row: &'a dyn Fn(usize, &mut Vec<u8>),
}

/// Triangles whose corners have keys; corners with equal keys are the same vertex.
pub(super) trait KeyedTriangles {
    /// Name and layers of the input.
    fn summary(&self) -> &PieceSummary;

    /// Passes all triangles to `visit`, always in the same order.
    fn for_each(
        &self,
        visit: &mut dyn FnMut(&KeyedTriangle<'_>) -> Result<(), ReadError>,
    ) -> Result<(), ReadError>;
}

/// Writes triangles whose corners share vertices if their keys are equal.
pub(super) fn write_shared(
    triangles: &dyn KeyedTriangles,
    scratch: &ScratchFolder,
) -> Result<File, ReadError> {
    let mut firsts = first_corners(triangles, scratch)?;
    let io = |error| scratch.error(error);
    let mut ply = PlyWriter::new(triangles.summary(), scratch)?;
    let numbers_file = scratch.file()?;
    let numbers_bytes = 4 * firsts.corner_count;
    numbers_file.set_len(numbers_bytes).map_err(io)?;
    let mut numbers = CachedFile::new(FileView::new(Arc::new(numbers_file)), 0, numbers_bytes);
    triangles.for_each(&mut |triangle| {
        let mut corners = [0; 3];
        for (k, corner) in corners.iter_mut().enumerate() {
            let Some(SortRecord { key: place, index: first, .. }) = firsts.sorted.next().map_err(io)? else {
                return Err(scratch.error(io::ErrorKind::UnexpectedEof.into()));
            };
            *corner = if place == u64::from(first) {
                let number = ply.vertex(|row| (triangle.push_row)(k, row))?;
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
    triangles.for_each(&mut |triangle| {
        for [a, b, c] in triangle.keys {
            let key = u64::from(a) << 32 | u64::from(b);
            by_key.push(SortRecord { key, index: c, corners: [next, 0, 0] }).map_err(io)?;
            next = next.checked_add(1).ok_or_else(|| {
                let reason = format!("more than {} triangles cannot be numbered", u32::MAX / 3);
                Fault::Malformed(Place::File, reason).in_file(&triangles.summary().name)
            })?;
        }
        Ok(())
    })?;
    let mut by_corner = Sorter::new(scratch.file()?);
    let mut sorted = by_key.merged().map_err(io)?;
    let mut last: Option<SortRecord> = None;
    while let Some(record) = sorted.next().map_err(io)? {
        let same = last.filter(|last| (last.key, last.index) == (record.key, record.index));
        let first = same.unwrap_or(record);
        last = Some(first);
        let (corner, first) = (record.corners[0], first.corners[0]);
        by_corner.push(SortRecord { key: u64::from(corner), index: first, corners: [0; 3] }).map_err(io)?;
    }
    drop(sorted);
    Ok(FirstCorners { sorted: by_corner.merged().map_err(io)?, corner_count: u64::from(next) })
}
