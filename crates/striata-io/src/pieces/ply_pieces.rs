//! Pieces of a binary PLY file: vertices and faces are read where they are.

use std::fs::File;
use std::io::{BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

use super::mesh_pieces::renumbered;
use super::{LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::ReadError;
use crate::error::Place;
use crate::ply::PlyStream;

/// Rows closer than this are read at once, in bytes.
const GAP_BYTES: u64 = 1 << 14;
/// Bytes of a converted triangle.
const TRIANGLE_BYTES: usize = 12;

/// A binary PLY file.
pub(super) struct PlyPieces {
    stream: PlyStream,
    summary: PieceSummary,
    /// Triangles as three indices each, if the file does not have them in rows of constant length.
    converted: Option<Scratch>,
    triangle_count: u64,
    piece_triangle_count: u64,
}

/// A file without a name, which several threads read.
struct Scratch(std::sync::Mutex<File>);

impl PlyPieces {
    /// Opens a file.
    ///
    /// # Errors
    /// [`ReadError::NotInBlocks`] if rows of vertices cannot be located without reading the file.
    pub(super) fn open(path: &Path, options: &PieceOptions) -> Result<Self, ReadError> {
        let stream = PlyStream::open(path)?;
        let (plain, mut triangle_count) = (stream.plain_triangle_count()?, 0);
        let converted = match plain {
            Some(count) => {
                triangle_count = count;
                None
            }
            None => {
                let file = options.scratch_file().map_err(|error| stream.io(error))?;
                let mut writer = BufWriter::with_capacity(1 << 20, file);
                stream.for_each_triangle(|t| {
                    triangle_count += 1;
                    let write = |v: u32| writer.write_all(&v.to_le_bytes());
                    t.into_iter().try_for_each(write).map_err(|error| stream.io(error))
                })?;
                let file = writer.into_inner().map_err(|error| stream.io(error.into_error()))?;
                Some(Scratch(std::sync::Mutex::new(file)))
            }
        };
        let summary = PieceSummary {
            name: path.display().to_string(),
            layers: stream.vertices(&[])?.layers.iter().map(LayerKind::of).collect(),
            groups: vec![PieceGroup::default()],
            triangle_count,
            byte_count: std::fs::metadata(path).map_or(0, |metadata| metadata.len()),
            ..PieceSummary::default()
        };
        let piece_triangle_count = options.piece_triangle_count.max(1) as u64;
        Ok(Self { stream, summary, converted, triangle_count, piece_triangle_count })
    }

    fn triangles(&self, first: u64, count: usize) -> Result<Vec<[u32; 3]>, ReadError> {
        let failed = |error| self.stream.io(error);
        let Some(converted) = &self.converted else { return self.stream.plain_triangles(first, count) };
        let mut bytes = vec![0; count * TRIANGLE_BYTES];
        let poisoned = || failed(std::io::Error::other("another thread failed while it read"));
        let mut file = converted.0.lock().map_err(|_| poisoned())?;
        file.seek(SeekFrom::Start(first * TRIANGLE_BYTES as u64)).map_err(failed)?;
        file.read_exact(&mut bytes).map_err(failed)?;
        Ok(bytemuck::pod_collect_to_vec(&bytes))
    }

    /// Rows of vertices, given in ascending order.
    fn rows(&self, vertices: &[u32]) -> Result<Vec<u8>, ReadError> {
        let stride = self.stride() as u64;
        let failed = |error| self.stream.io(error);
        let mut file = self.stream.file()?;
        let mut rows = Vec::with_capacity(vertices.len() * stride as usize);
        let mut buffer = Vec::new();
        for run in vertices.chunk_by(|a, b| u64::from(b - a) * stride <= GAP_BYTES) {
            let (first, last) = (run[0], run[run.len() - 1]);
            buffer.resize(((u64::from(last - first) + 1) * stride) as usize, 0);
            file.seek(SeekFrom::Start(self.stream.vertices_offset + u64::from(first) * stride))
                .map_err(failed)?;
            file.read_exact(&mut buffer).map_err(failed)?;
            for v in run {
                rows.extend_from_slice(
                    &buffer[((v - first) as usize) * stride as usize..][..stride as usize],
                );
            }
        }
        Ok(rows)
    }

    fn stride(&self) -> usize {
        self.stream.stride
    }
}

impl PieceSource for PlyPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.triangle_count.div_ceil(self.piece_triangle_count)
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let first = (index * self.piece_triangle_count).min(self.triangle_count);
        let count = self.piece_triangle_count.min(self.triangle_count - first) as usize;
        let (triangles, vertices) = renumbered(&self.triangles(first, count)?);
        let mesh = self.stream.vertices(&self.rows(&vertices)?)?;
        if let Some(bad) = mesh.positions.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
            let vertex = vertices[bad];
            let at = self.stream.vertices_offset + u64::from(vertex) * self.stride() as u64;
            return Err(ReadError::Malformed {
                file: self.summary.name.clone(),
                place: Place::Byte(at),
                reason: format!("vertex {vertex} has a coordinate that is not a number"),
            });
        }
        Ok(Piece { positions: mesh.positions, layers: mesh.layers, triangles, groups: Vec::new() })
    }
}
