//! A mesh in memory, as pieces.

use std::ops::Range;

use striata::mesh::IndexedMesh;

use super::input::PieceInput;
use super::local::localize;
use super::{LayerKind, Piece, PieceGroup, PieceOptions, PieceSource, PieceSummary};
use crate::error::Place;
use crate::{ReadError, Warning};

/// A mesh in memory that is served piece by piece.
#[derive(Clone, Debug)]
pub struct MeshPieces {
    mesh: IndexedMesh,
    summary: PieceSummary,
    piece_size: usize,
    /// Why the mesh is unusable.
    defect: Option<String>,
}

impl MeshPieces {
    /// Wraps a mesh. If it is inconsistent, every piece is an error.
    pub fn new(mesh: IndexedMesh) -> Self {
        let defect = mesh.check().err().map(|error| error.to_string());
        let whole = mesh.groups_or_whole().into_iter();
        let summary = PieceSummary {
            name: "mesh in memory".to_owned(),
            origin: mesh.origin,
            layers: mesh.layers.iter().map(LayerKind::of).collect(),
            triangle_layers: mesh.triangle_layers.iter().map(LayerKind::of).collect(),
            groups: whole.map(|group| PieceGroup { name: group.name, material: group.material }).collect(),
            appearance: mesh.appearance.clone(),
            triangle_count: mesh.triangle_count() as u64,
            ..PieceSummary::default()
        };
        let piece_size = PieceOptions::default().piece_size();
        Self { mesh, summary, piece_size, defect }
    }

    /// Sets the name for messages.
    #[must_use]
    pub fn with_name(mut self, name: impl Into<String>) -> Self {
        self.summary.name = name.into();
        self
    }

    /// Sets the number of triangles per piece, at least 1.
    #[must_use]
    pub fn with_piece_triangle_count(mut self, piece_triangle_count: u32) -> Self {
        self.piece_size = piece_triangle_count.max(1) as usize;
        self
    }

    /// Sets the size of the file, the files that it refers to, and the remarks on it.
    pub(super) fn with_file(mut self, input: &PieceInput, warnings: Vec<Warning>) -> Self {
        (self.summary.byte_count, self.summary.warnings) = (input.file_bytes, warnings);
        self.summary.companions = input.companions();
        self
    }

    /// Refuses a mesh that is inconsistent.
    pub(super) fn check(&self) -> Result<(), ReadError> {
        match &self.defect {
            None => Ok(()),
            Some(defect) => Err(self.error(defect.clone())),
        }
    }

    fn error(&self, reason: String) -> ReadError {
        ReadError::Malformed { file: self.summary.name.clone(), place: Place::File, reason }
    }

    /// Group of each triangle of a range; empty if there is only one group.
    fn groups(&self, range: Range<usize>) -> Vec<u32> {
        if self.summary.groups.len() < 2 {
            return Vec::new();
        }
        let groups = &self.mesh.groups;
        let mut group = groups.partition_point(|g| g.range().end <= range.start);
        let group_of = |triangle: usize| {
            while groups.get(group).is_some_and(|g| g.range().end <= triangle) {
                group += 1;
            }
            group as u32
        };
        range.map(group_of).collect()
    }
}

impl PieceSource for MeshPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.mesh.triangles.len().div_ceil(self.piece_size) as u64
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        self.check()?;
        if index >= self.piece_count() {
            return Err(self.error(format!("piece {index} does not exist")));
        }
        let first = index as usize * self.piece_size;
        let range = first..self.mesh.triangles.len().min(first + self.piece_size);
        let mut triangles = self.mesh.triangles[range.clone()].to_vec();
        let vertices = localize(&mut triangles);
        Ok(Piece {
            positions: vertices.iter().map(|&v| self.mesh.positions[v as usize]).collect(),
            layers: self.mesh.layers.iter().map(|layer| layer.gather(&vertices)).collect(),
            triangles,
            triangle_layers: {
                let rows: Vec<u32> = (range.start as u32..range.end as u32).collect();
                self.mesh.triangle_layers.iter().map(|layer| layer.gather(&rows)).collect()
            },
            groups: self.groups(range),
        })
    }
}
