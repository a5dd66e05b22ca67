//! Pieces of a binary STL file.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use super::{Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::ReadError;
use crate::error::Place;

const HEADER_BYTES: u64 = 84;
const FACET_BYTES: u64 = 50;

/// A binary STL file.
pub(super) struct StlPieces {
    path: PathBuf,
    summary: PieceSummary,
    piece_triangle_count: u64,
}

impl StlPieces {
    /// Opens a file; `None` if it is not a binary STL file.
    pub(super) fn open(path: &Path, options: &PieceOptions) -> Result<Option<Self>, ReadError> {
        let name = path.display().to_string();
        let failed = |source| ReadError::Io { file: name.clone(), source };
        let mut file = File::open(path).map_err(failed)?;
        let byte_count = file.metadata().map_err(failed)?.len();
        let mut head = [0; HEADER_BYTES as usize];
        if byte_count < HEADER_BYTES || file.read_exact(&mut head).is_err() {
            return Ok(None);
        }
        let triangle_count = u64::from(u32::from_le_bytes([head[80], head[81], head[82], head[83]]));
        if HEADER_BYTES + FACET_BYTES * triangle_count != byte_count {
            return Ok(None);
        }
        let summary = PieceSummary {
            name,
            groups: vec![PieceGroup::default()],
            triangle_count,
            byte_count,
            ..PieceSummary::default()
        };
        let piece_triangle_count = options.piece_triangle_count.max(1) as u64;
        Ok(Some(Self { path: path.to_owned(), summary, piece_triangle_count }))
    }
}

impl PieceSource for StlPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.summary.triangle_count.div_ceil(self.piece_triangle_count)
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let failed = |source| ReadError::Io { file: self.summary.name.clone(), source };
        let first = (index * self.piece_triangle_count).min(self.summary.triangle_count);
        let count = self.piece_triangle_count.min(self.summary.triangle_count - first);
        let mut file = File::open(&self.path).map_err(failed)?;
        file.seek(SeekFrom::Start(HEADER_BYTES + FACET_BYTES * first)).map_err(failed)?;
        let mut bytes = vec![0; (FACET_BYTES * count) as usize];
        file.read_exact(&mut bytes).map_err(failed)?;
        let mut piece = Piece::default();
        for (i, facet) in (first..).zip(bytes.chunks_exact(FACET_BYTES as usize)) {
            let corners: Vec<f32> = bytemuck::pod_collect_to_vec(&facet[12..48]);
            if corners.iter().any(|x| !x.is_finite()) {
                return Err(ReadError::Malformed {
                    file: self.summary.name.clone(),
                    place: Place::Byte(HEADER_BYTES + FACET_BYTES * i + 12),
                    reason: format!("facet {i} has a coordinate that is not a number"),
                });
            }
            let v = piece.positions.len() as u32;
            piece.positions.extend(corners.as_chunks::<3>().0);
            piece.triangles.push([v, v + 1, v + 2]);
        }
        Ok(piece)
    }
}
