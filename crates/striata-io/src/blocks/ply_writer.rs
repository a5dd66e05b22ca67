//! Writes a temporary binary PLY file, whose counts are only known at the end. Its layers are those of the
//! input as they are: texture coordinates count from the top of the image.

use std::fs::File;
use std::io::{self, BufWriter, Seek as _, SeekFrom, Write as _};

use super::scratch::ScratchFolder;
use crate::ReadError;
use crate::error::Place;
use crate::pieces::PieceSummary;
use crate::ply::header::Scalar;
use crate::ply::vertex_header;

/// Number of digits that are left for counts.
const DIGITS: usize = 10;

/// PLY file under construction: vertices, and faces in another file until all vertices are known.
pub(super) struct PlyWriter<'a> {
    out: BufWriter<File>,
    faces: BufWriter<File>,
    row: Vec<u8>,
    vertex_count: u32,
    face_count: u32,
    /// Offsets of the counts of vertices and of faces in the file, bytes.
    counts_at: [u64; 2],
    scratch: &'a ScratchFolder,
}

impl<'a> PlyWriter<'a> {
    /// Begins a file whose vertices have the layers of an input.
    pub(super) fn new(summary: &PieceSummary, scratch: &'a ScratchFolder) -> Result<Self, ReadError> {
        let buffered = || Ok::<_, ReadError>(BufWriter::with_capacity(1 << 16, scratch.file()?));
        let (mut out, faces) = (buffered()?, buffered()?);
        let layers: Vec<_> = summary.layers.iter().map(|kind| kind.empty_layer()).collect();
        let zeros = format!("{:0DIGITS$}", 0);
        let mut head =
            vertex_header(Scalar::F32, &layers, &[], "binary_little_endian", &zeros).map_err(|refusal| {
                let (file, what) = (summary.name.clone(), refusal.into_reason());
                ReadError::Unsupported { file, place: Place::File, what }
            })?;
        let vertices_at = head.rfind(&format!("{zeros}\n")).unwrap_or(0) as u64;
        head += "element face ";
        let counts_at = [vertices_at, head.len() as u64];
        head += &format!("{zeros}\nproperty list uchar uint vertex_indices\nend_header\n");
        out.write_all(head.as_bytes()).map_err(|error| scratch.error(error))?;
        Ok(Self { out, faces, row: Vec::new(), vertex_count: 0, face_count: 0, counts_at, scratch })
    }

    /// Adds the vertex whose row `push_row` appends; returns its number.
    pub(super) fn vertex(&mut self, push_row: impl FnOnce(&mut Vec<u8>)) -> Result<u32, ReadError> {
        self.row.clear();
        push_row(&mut self.row);
        self.vertex_count += 1;
        self.out.write_all(&self.row).map_err(|error| self.scratch.error(error))?;
        Ok(self.vertex_count - 1)
    }

    /// Adds a triangle.
    pub(super) fn face(&mut self, corners: [u32; 3]) -> Result<(), ReadError> {
        let mut row = [3; 13];
        for (bytes, corner) in row[1..].chunks_exact_mut(4).zip(corners) {
            bytes.copy_from_slice(&corner.to_le_bytes());
        }
        self.face_count += 1;
        self.faces.write_all(&row).map_err(|error| self.scratch.error(error))
    }

    /// Returns the complete file.
    pub(super) fn finish(self) -> Result<File, ReadError> {
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
