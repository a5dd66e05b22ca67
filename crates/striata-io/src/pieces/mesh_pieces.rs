//! Pieces of a mesh in memory.

use striata::mesh::{AttributeLayer, IndexedMesh, LayerData};

use super::{ComponentType, LayerKind, Piece, PieceGroup, PieceSource, PieceSummary};
use crate::ReadError;

/// A mesh in memory, served in pieces.
#[derive(Clone, Debug)]
pub struct MeshPieces {
    mesh: IndexedMesh,
    summary: PieceSummary,
    /// Group of each triangle; empty if there is one.
    groups: Vec<u32>,
    piece_triangle_count: usize,
}

impl MeshPieces {
    /// Wraps a mesh; `name` is used in messages.
    ///
    /// # Panics
    /// If the mesh is inconsistent: check it before.
    pub fn new(name: &str, mesh: IndexedMesh, piece_triangle_count: usize) -> Self {
        let mut groups = vec![0; if mesh.groups.len() > 1 { mesh.triangles.len() } else { 0 }];
        if mesh.groups.len() > 1 {
            for (index, group) in (0..).zip(&mesh.groups) {
                groups[group.range()].fill(index);
            }
        }
        let mut summary = PieceSummary {
            name: name.to_owned(),
            layers: mesh.layers.iter().map(LayerKind::of).collect(),
            groups: mesh
                .groups
                .iter()
                .map(|group| PieceGroup { name: group.name.clone(), material: group.material })
                .collect(),
            appearance: mesh.appearance.clone(),
            triangle_count: mesh.triangles.len() as u64,
            byte_count: 12 * (mesh.positions.len() + mesh.triangles.len()) as u64,
            ..PieceSummary::default()
        };
        if summary.groups.is_empty() {
            summary.groups.push(PieceGroup::default());
        }
        Self { mesh, summary, groups, piece_triangle_count: piece_triangle_count.max(1) }
    }
}

impl LayerKind {
    /// The kind of a layer.
    pub fn of(layer: &AttributeLayer) -> Self {
        let component_type = match layer.data {
            LayerData::F32(_) => ComponentType::F32,
            LayerData::U8(_) => ComponentType::U8,
            LayerData::U16(_) => ComponentType::U16,
            LayerData::U32(_) => ComponentType::U32,
        };
        Self {
            semantic: layer.semantic.clone(),
            component_count: layer.component_count,
            normalized: layer.normalized,
            component_type,
        }
    }
}

impl PieceSource for MeshPieces {
    fn summary(&self) -> &PieceSummary {
        &self.summary
    }

    fn piece_count(&self) -> u64 {
        self.mesh.triangles.len().div_ceil(self.piece_triangle_count) as u64
    }

    fn read_piece(&self, index: u64) -> Result<Piece, ReadError> {
        let count = self.mesh.triangles.len();
        let first = (index as usize).saturating_mul(self.piece_triangle_count).min(count);
        let range = first..(first + self.piece_triangle_count).min(count);
        let (triangles, vertices) = renumbered(&self.mesh.triangles[range.clone()]);
        Ok(Piece {
            positions: vertices.iter().map(|&v| self.mesh.positions[v as usize]).collect(),
            layers: self.mesh.layers.iter().map(|layer| layer.gather(&vertices)).collect(),
            triangles,
            groups: self.groups.get(range).unwrap_or_default().to_vec(),
        })
    }
}

/// Numbers the vertices that triangles use; returns the triangles and the sorted vertices.
pub(super) fn renumbered(triangles: &[[u32; 3]]) -> (Vec<[u32; 3]>, Vec<u32>) {
    let mut vertices: Vec<u32> = triangles.as_flattened().to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    let number = |v: u32| vertices.partition_point(|&w| w < v) as u32;
    (triangles.iter().map(|t| t.map(number)).collect(), vertices)
}
