//! Triangles of pieces whose vertices have positions only.

use super::shared_vertices::KeyedTriangles;
use crate::ReadError;
use crate::error::Place;
use crate::pieces::PieceSource;

/// Triangles whose corners are identified by their positions: pieces share vertices at their borders.
pub(super) struct PieceTriangles<'a> {
    pieces: &'a dyn PieceSource,
}

impl<'a> PieceTriangles<'a> {
    /// Refuses pieces with attributes, because a position does not identify their vertices.
    pub(super) fn new(pieces: &'a dyn PieceSource) -> Result<Self, ReadError> {
        let summary = pieces.summary();
        match summary.layers.first() {
            None => Ok(Self { pieces }),
            Some(layer) => Err(ReadError::Unsupported {
                file: summary.name.clone(),
                place: Place::File,
                what: format!("the layer {} of pieces, in blocks,", layer.semantic),
            }),
        }
    }
}

impl KeyedTriangles for PieceTriangles<'_> {
    fn name(&self) -> &str {
        &self.pieces.summary().name
    }

    fn properties(&self) -> Vec<String> {
        Vec::new()
    }

    fn for_each(
        &self,
        visit: &mut dyn FnMut([[u32; 3]; 3]) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        for index in 0..self.pieces.piece_count() {
            let piece = self.pieces.read_piece(index)?;
            // Adding zero makes -0 and 0 the same.
            let key = |vertex: u32| piece.positions[vertex as usize].map(|x| (x + 0.0).to_bits());
            piece.triangles.iter().try_for_each(|corners| visit(corners.map(key)))?;
        }
        Ok(())
    }

    fn push_row(&self, key: [u32; 3], row: &mut Vec<u8>) {
        row.extend(key.iter().flat_map(|bits| bits.to_le_bytes()));
    }
}
