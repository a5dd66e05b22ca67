//! Levels of one mesh, with errors in units of the scene, and the order in which meshes are coarsened.

use std::cmp::Reverse;
use std::collections::binary_heap::PeekMut;
use std::collections::{BTreeMap, BinaryHeap};

use striata::mesh::LevelTable;

use super::weight::MeshWeight;

/// Levels of one mesh.
#[derive(Clone, Debug)]
pub(super) struct MeshLevels {
    pub levels: LevelTable,
    pub weight: MeshWeight,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct LevelCounts {
    pub triangles: usize,
    pub vertices: usize,
}

impl MeshLevels {
    /// Error of a level in units of the scene.
    pub(super) fn error_at(&self, split_count: usize) -> f64 {
        self.scaled(self.levels.error_at(split_count))
    }

    fn scaled(&self, error: f32) -> f64 {
        // Adding zero turns -0 into 0, so that the order of the bits is that of the numbers.
        self.weight.scale * f64::from(error) + 0.0
    }

    pub(super) fn counts_at(&self, split_count: usize) -> LevelCounts {
        let triangles = self.levels.triangle_count_at(split_count);
        LevelCounts {
            triangles: triangles.saturating_mul(self.weight.instance_count),
            vertices: self.levels.vertex_count_at(split_count),
        }
    }

    /// Split count of the coarsest level whose error does not exceed `error`, in units of the scene.
    pub(super) fn split_count_for_error(&self, error: f64) -> usize {
        self.levels.errors().partition_point(|&e| self.scaled(e) > error)
    }
}

impl LevelCounts {
    pub(super) fn plus(self, other: Self) -> Self {
        Self {
            triangles: self.triangles.saturating_add(other.triangles),
            vertices: self.vertices.saturating_add(other.vertices),
        }
    }

    pub(super) fn minus(self, other: Self) -> Self {
        Self {
            triangles: self.triangles.saturating_sub(other.triangles),
            vertices: self.vertices.saturating_sub(other.vertices),
        }
    }
}

/// Returns for each mesh the first one with the same levels and the same scale, which may be itself.
pub(super) fn first_meshes(meshes: &[Option<MeshLevels>]) -> Vec<usize> {
    let mut first_of: BTreeMap<_, usize> = BTreeMap::new();
    let first = |(index, mesh): (usize, &Option<MeshLevels>)| {
        let Some(mesh) = mesh else { return index };
        let errors = mesh.levels.errors();
        let sum: u64 = errors.iter().fold(0, |sum: u64, x| sum.rotate_left(5) ^ u64::from(x.to_bits()));
        let MeshWeight { scale, instance_count, importance } = mesh.weight;
        let key = (errors.len(), sum, scale.to_bits(), importance.to_bits(), instance_count == 0);
        let first = *first_of.entry(key).or_insert(index);
        let is_same = |other: &MeshLevels| other.levels == mesh.levels;
        if meshes[first].as_ref().is_some_and(is_same) { first } else { index }
    };
    meshes.iter().enumerate().map(first).collect()
}

/// Returns the mesh of each step of coarsening, ordered by the key of the step, then by mesh. `key_of` has the keys of
/// the steps of a mesh, by the split count after each; they are not negative, and do not fall as the mesh gets coarser.
pub(super) fn merged_order(
    meshes: &[Option<MeshLevels>],
    key_of: impl Fn(&MeshLevels, usize, usize) -> f64,
) -> Vec<u32> {
    let step_count = meshes.iter().flatten().map(|mesh| mesh.levels.step_count()).sum();
    let mut order = Vec::with_capacity(step_count);
    // The bits of numbers that are not negative have their order.
    let key = |mesh: usize, split_count: usize| {
        let key = meshes[mesh].as_ref().map_or(0.0, |levels| key_of(levels, mesh, split_count));
        Reverse((key.to_bits(), mesh as u32, split_count))
    };
    let with_steps = meshes.iter().enumerate().filter_map(|(mesh, levels)| {
        let split_count = levels.as_ref()?.levels.step_count().checked_sub(1)?;
        Some(key(mesh, split_count))
    });
    let mut next: BinaryHeap<_> = with_steps.collect();
    while let Some(mut top) = next.peek_mut() {
        let Reverse((_, mesh, split_count)) = *top;
        order.push(mesh);
        match split_count.checked_sub(1) {
            Some(coarser) => *top = key(mesh as usize, coarser),
            None => drop(PeekMut::pop(top)),
        }
    }
    order
}
