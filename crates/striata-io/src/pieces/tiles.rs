//! Copies of an input side by side, for benchmarks.

use super::{Piece, PieceSource, PieceSummary};
use crate::ReadError;

/// Gap between copies, as a share of their extent.
const GAP: f32 = 1.02;

/// Copies of an input side by side, on a square grid along x and y.
pub struct Tiles {
    source: Box<dyn PieceSource>,
    summary: PieceSummary,
    columns: u64,
    count: u64,
    /// Distance of neighboring copies along x and y, mesh units.
    step: [f32; 2],
}

impl Tiles {
    /// Repeats a source; reads it once to find its extent.
    ///
    /// # Errors
    /// [`ReadError`] if the source cannot be read.
    pub fn new(source: Box<dyn PieceSource>, count: u32) -> Result<Self, ReadError> {
        let (mut min, mut max) = ([f32::MAX; 2], [f32::MIN; 2]);
        for piece in 0..source.piece_count() {
            for p in source.read_piece(piece)?.positions {
                for axis in 0..2 {
                    min[axis] = min[axis].min(p[axis]);
                    max[axis] = max[axis].max(p[axis]);
                }
            }
        }
        let count = u64::from(count);
        let mut summary = source.summary().clone();
        summary.triangle_count *= count;
        summary.byte_count *= count;
        let step = [0, 1].map(|axis| GAP * (max[axis] - min[axis]).max(0.0));
        Ok(Self { source, summary, columns: count.isqrt().max(1), count, step })
    }
}

impl PieceSource for Tiles {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.source.piece_count() * self.count
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let per_tile = self.source.piece_count().max(1);
        let (tile, piece) = (index / per_tile, index % per_tile);
        let offset = [tile % self.columns, tile / self.columns];
        let mut piece = self.source.read_piece(piece)?;
        for p in &mut piece.positions {
            for axis in 0..2 {
                p[axis] += offset[axis] as f32 * self.step[axis];
            }
        }
        Ok(piece)
    }
}
