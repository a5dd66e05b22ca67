//! Binary STL in pieces: facets have the same size, so that each can be found by its number.

use super::input::Input;
use super::{Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::ReadError;
use crate::error::{Fault, Place};
use crate::stl::{FACET_BYTES, HEADER_BYTES, VertexTable, facet_count, is_ascii, position_at};

/// Binary STL file.
pub(super) struct StlPieces {
    input: Input,
    summary: PieceSummary,
    facet_count: usize,
    piece_size: usize,
}

impl StlPieces {
    /// Opens a file; an ASCII file is given back.
    pub(super) fn open(input: Input, options: &PieceOptions) -> Result<Result<Self, Input>, ReadError> {
        if is_ascii(&input.bytes) {
            return Ok(Err(input));
        }
        let facet_count = facet_count(&input.bytes).map_err(|fault| fault.in_file(&input.name))?;
        let summary = PieceSummary {
            name: input.name.clone(),
            groups: vec![PieceGroup::default()],
            triangle_count: facet_count as u64,
            byte_count: input.file_bytes,
            ..PieceSummary::default()
        };
        Ok(Ok(Self { input, summary, facet_count, piece_size: options.piece_size() }))
    }

    fn facets(&self, first: usize) -> Result<Piece, Fault> {
        let count = self.piece_size.min(self.facet_count - first);
        let start = HEADER_BYTES + first * FACET_BYTES;
        let bytes = &self.input.bytes[start..start + count * FACET_BYTES];
        let mut vertices = VertexTable::with_capacity(count / 2 + 2);
        let mut triangles = Vec::with_capacity(count);
        for (facet, bytes) in bytes.chunks_exact(FACET_BYTES).enumerate() {
            let mut triangle = [0; 3];
            for (corner, at) in triangle.iter_mut().zip([12, 24, 36]) {
                let position = position_at(bytes, at);
                if let Some(value) = position.iter().find(|x| !x.is_finite()) {
                    let reason = format!("{value} is not a usable coordinate");
                    return Err(Fault::at_byte(start + facet * FACET_BYTES + at, reason));
                }
                *corner = vertices.vertex(position);
            }
            triangles.push(triangle);
        }
        Ok(Piece { positions: vertices.positions, triangles, ..Piece::default() })
    }
}

impl PieceSource for StlPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.facet_count.div_ceil(self.piece_size) as u64
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let piece = if index < self.piece_count() {
            self.facets(index as usize * self.piece_size)
        } else {
            Err(Fault::Malformed(Place::File, format!("piece {index} does not exist")))
        };
        piece.map_err(|fault| fault.in_file(&self.input.name))
    }
}
