//! Levels as ranges of one index buffer, made in advance.

use super::Lod;
use crate::mesh::replay_into;
use crate::strip::cache_order;

/// Place of a level in an index buffer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IndexRange {
    /// First index of the level.
    pub first_index: usize,
    /// Number of indices, three per triangle.
    pub index_count: usize,
    /// Vertices that the indices refer to, from the start of the vertex buffer.
    pub vertex_count: usize,
    /// Largest distance of the full mesh from the level, in mesh units.
    pub error: f32,
}

/// An index buffer with several levels, one after another, over one vertex buffer.
///
/// This is what `SetLods` of a Unity mesh and `lods` of a Godot surface take.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LevelRanges {
    /// Vertex indices of all levels, three per triangle.
    pub indices: Vec<u32>,
    /// Place of each level in the indices.
    pub ranges: Vec<IndexRange>,
}

impl Lod {
    /// Makes levels of one group of the mesh as ranges of one index buffer; finer levels come first. [`None`] stands for
    /// all triangles of the mesh.
    ///
    /// The triangles of each level are in cache order. Cost: linear in the number of triangles.
    ///
    /// # Panics
    /// If the group does not exist, or if a split count exceeds the step count or the one before it.
    pub fn ranges(&self, split_counts: &[usize], group: Option<usize>) -> LevelRanges {
        assert!(split_counts.is_sorted_by(|a, b| a >= b), "finer levels come first");
        let (mesh, sequence) = (self.mesh(), self.sequence());
        let mut triangles = match group {
            Some(group) => mesh.triangles[mesh.groups_or_whole()[group].range()].to_vec(),
            None => mesh.triangles.clone(),
        };
        let mut made = LevelRanges::default();
        for &split_count in split_counts {
            let mut coarser = Vec::new();
            replay_into(sequence, split_count, &triangles, &mut coarser);
            triangles = coarser;
            made.ranges.push(IndexRange {
                first_index: made.indices.len(),
                index_count: 3 * triangles.len(),
                vertex_count: sequence.vertex_count_at(split_count),
                error: sequence.error_at(split_count),
            });
            made.indices.extend(cache_order(&triangles).iter().flat_map(|&t| triangles[t as usize]));
        }
        made
    }
}
