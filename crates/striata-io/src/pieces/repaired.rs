//! Pieces without values that are not finite: the last step of every reader of pieces.
//!
//! Omitted values are only found when a piece is read; a piece is counted once, however often it is read.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use striata::mesh::IndexedMesh;

use super::{Piece, PieceSource, PieceSummary};
use crate::error::Place;
use crate::repair::{check_triangles, is_lost, needs_repair, repair};
use crate::report::Warnings;
use crate::{ReadError, Warning};

/// A source whose pieces are repaired.
pub(crate) struct Repaired<S> {
    source: S,
    /// Warnings about parts left out of each piece that has been read.
    found: Mutex<BTreeMap<u64, Warnings>>,
}

impl<S: PieceSource> Repaired<S> {
    pub(crate) fn new(source: S) -> Self {
        Self { source, found: Mutex::default() }
    }
}

impl<S: PieceSource> PieceSource for Repaired<S> {
    fn summary(&self) -> &PieceSummary {
        self.source.summary()
    }

    fn piece_count(&self) -> u64 {
        self.source.piece_count()
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let mut piece = self.source.read_piece(index)?;
        if needs_repair(&piece.positions, &piece.layers) {
            let mut warnings = Warnings::of_file(&self.summary().name);
            piece = repaired(piece, &mut warnings);
            if self.piece_count() == 1 {
                let count = self.summary().triangle_count as usize;
                check_triangles([piece.positions.len(), count], piece.triangles.len(), &warnings)?;
            }
            warnings.set_place(&Place::Piece(index));
            self.found.lock().unwrap_or_else(PoisonError::into_inner).insert(index, warnings);
        }
        Ok(piece)
    }

    fn warnings(&self) -> Vec<Warning> {
        let summary = self.summary();
        let mut all = Warnings::of_list(&summary.name, self.source.warnings());
        let found = self.found.lock().unwrap_or_else(PoisonError::into_inner);
        found.values().for_each(|warnings| all.append(warnings.clone()));
        all.into_list()
    }
}

fn repaired(mut piece: Piece, warnings: &mut Warnings) -> Piece {
    let Piece { positions, layers, triangles, groups, triangle_layers } = &mut piece;
    if !groups.is_empty() {
        let is_kept = |t: &[u32; 3]| !t.iter().any(|&v| is_lost(&positions[v as usize]));
        let mut kept = triangles.iter().map(is_kept);
        groups.retain(|_| kept.next() != Some(false));
    }
    let (positions, triangles) = (std::mem::take(positions), std::mem::take(triangles));
    let mut mesh = IndexedMesh {
        layers: std::mem::take(layers),
        triangle_layers: std::mem::take(triangle_layers),
        ..IndexedMesh::new(positions, triangles)
    };
    repair(&mut mesh, warnings);
    let IndexedMesh { positions, triangles, layers, triangle_layers, .. } = mesh;
    Piece { positions, triangles, layers, triangle_layers, ..piece }
}
