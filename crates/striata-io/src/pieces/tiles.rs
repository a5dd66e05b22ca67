//! Copies of an input side by side, for measurements with large inputs.

use super::{Piece, PieceSource, PieceSummary};
use crate::error::Place;
use crate::{ReadError, Warning};

/// Distance of two copies, in extents of the input.
const SPACING: f64 = 1.02;

/// Copies of an input on a grid in the plane of x and y.
pub struct Tiles {
    source: Box<dyn PieceSource>,
    summary: PieceSummary,
    columns: u32,
    rows: u32,
    /// Distance of two copies along x and y, in mesh units.
    step: [f64; 2],
}

impl Tiles {
    /// Places `columns` copies along x and `rows` along y. All pieces are read once to find the extent.
    ///
    /// # Errors
    /// [`ReadError`] of the source.
    pub fn new(source: Box<dyn PieceSource>, columns: u32, rows: u32) -> Result<Self, ReadError> {
        let (mut min, mut max) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for index in 0..source.piece_count() {
            for position in source.read_piece(index)?.positions {
                for axis in 0..2 {
                    min[axis] = min[axis].min(f64::from(position[axis]));
                    max[axis] = max[axis].max(f64::from(position[axis]));
                }
            }
        }
        let step = [0, 1].map(|axis| ((max[axis] - min[axis]) * SPACING).max(0.0));
        let copies = u64::from(columns) * u64::from(rows);
        let mut summary = source.summary().clone();
        summary.name = format!("{columns} x {rows} copies of {}", summary.name);
        summary.triangle_count = summary.triangle_count.saturating_mul(copies);
        summary.byte_count = summary.byte_count.saturating_mul(copies);
        Ok(Self { source, summary, columns, rows, step })
    }
}

impl PieceSource for Tiles {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        let copies = u64::from(self.columns) * u64::from(self.rows);
        self.source.piece_count().saturating_mul(copies)
    }

    fn warnings(&self) -> Vec<Warning> {
        self.source.warnings()
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        if index >= self.piece_count() {
            let (file, place) = (self.summary.name.clone(), Place::File);
            return Err(ReadError::Malformed {
                file,
                place,
                reason: format!("piece {index} does not exist"),
            });
        }
        let (tile, inner) = (index / self.source.piece_count(), index % self.source.piece_count());
        let columns = u64::from(self.columns);
        let cell = [tile % columns, tile / columns];
        let mut piece = self.source.read_piece(inner)?;
        for position in &mut piece.positions {
            for axis in 0..2 {
                position[axis] = (f64::from(position[axis]) + cell[axis] as f64 * self.step[axis]) as f32;
            }
        }
        Ok(piece)
    }
}
