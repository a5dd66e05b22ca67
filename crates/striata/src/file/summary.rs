//! Counts and bounds of a file, available without reading the large arrays.

use super::byte_reader::{SectionReader, put_u32};
use super::{DecodeError, SectionKind};
use crate::mesh::{Bounds, IndexedMesh, LevelTable, RefinableMesh};

/// Counts and bounds of the mesh in a file.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Summary {
    /// Number of vertices of the full mesh.
    pub vertex_count: usize,
    /// Number of positions of the full mesh.
    pub position_count: usize,
    /// Number of triangles of the full mesh.
    pub triangle_count: usize,
    /// Number of triangle groups; 0 if the mesh has none.
    pub group_count: usize,
    /// Number of steps from the base mesh to the full mesh.
    pub step_count: usize,
    /// Number of positions of the base mesh.
    pub base_position_count: usize,
    /// Number of vertices of the base mesh.
    pub base_vertex_count: usize,
    /// Number of triangles of the base mesh.
    pub base_triangle_count: usize,
    /// Error of the base mesh, in mesh units.
    pub error_max: f32,
    /// Bounds of the full mesh; `None` if it has no vertices.
    pub bounds: Option<Bounds>,
}

impl Summary {
    /// Summarizes a mesh with its collapse sequence.
    pub fn of(refinable: &RefinableMesh) -> Self {
        Self::of_levels(&refinable.mesh, refinable.sequence.levels())
    }

    /// Summarizes a mesh with its levels.
    pub fn of_levels(mesh: &IndexedMesh, sequence: &LevelTable) -> Self {
        Self {
            vertex_count: mesh.vertex_count(),
            position_count: sequence.positions().position_count(),
            triangle_count: mesh.triangle_count(),
            group_count: mesh.groups.len(),
            step_count: sequence.step_count(),
            base_position_count: sequence.base_position_count(),
            base_vertex_count: sequence.base_vertex_count(),
            base_triangle_count: sequence.triangle_count_at(0),
            error_max: sequence.error_at(0),
            bounds: mesh.bounds(),
        }
    }

    pub(super) fn to_bytes(self) -> Vec<u8> {
        let mut out = Vec::with_capacity(64);
        let counts = [
            self.vertex_count,
            self.position_count,
            self.triangle_count,
            self.group_count,
            self.step_count,
            self.base_position_count,
            self.base_vertex_count,
            self.base_triangle_count,
        ];
        counts.into_iter().for_each(|n| put_u32(n as u32, &mut out));
        put_u32(self.error_max.to_bits(), &mut out);
        put_u32(u32::from(self.bounds.is_some()), &mut out);
        let bounds = self.bounds.unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] });
        bounds.min.into_iter().chain(bounds.max).for_each(|x| put_u32(x.to_bits(), &mut out));
        out
    }

    pub(super) fn from_bytes(bytes: &[u8]) -> Result<Self, DecodeError> {
        let mut reader = SectionReader::new(SectionKind::SUMMARY, bytes);
        let mut count = || reader.u32().map(|n| n as usize);
        let mut summary = Self {
            vertex_count: count()?,
            position_count: count()?,
            triangle_count: count()?,
            group_count: count()?,
            step_count: count()?,
            base_position_count: count()?,
            base_vertex_count: count()?,
            base_triangle_count: count()?,
            error_max: 0.0,
            bounds: None,
        };
        summary.error_max = reader.f32()?;
        let has_bounds = reader.u32()? != 0;
        let mut point = || Ok::<_, DecodeError>([reader.f32()?, reader.f32()?, reader.f32()?]);
        let bounds = Bounds { min: point()?, max: point()? };
        summary.bounds = has_bounds.then_some(bounds);
        // Later versions may append fields, so any remaining bytes are ignored.
        Ok(summary)
    }
}
