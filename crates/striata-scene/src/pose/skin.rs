//! Skins: joints that deform a mesh.

use glam::DMat4;
use serde_json::Value;
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};
use striata_io::SceneError;

use super::numbers::{AccessorNumbers, index, transformed};
use crate::document::entries;

/// Joints of a skin, with the matrices from the mesh to each joint in its bind pose.
#[derive(Clone, Debug)]
pub(super) struct Skin {
    joints: Vec<usize>,
    inverse_binds: Vec<DMat4>,
}

impl Skin {
    pub(super) fn read(skin: &Value, accessors: &mut AccessorNumbers<'_>) -> Result<Self, SceneError> {
        let joints: Vec<usize> = entries(skin, "joints").iter().filter_map(index).collect();
        let mut inverse_binds = Vec::new();
        if let Some(accessor) = skin.get("inverseBindMatrices").and_then(Value::as_u64) {
            let (numbers, width) = accessors.read(accessor)?;
            let (matrices, _) = numbers.as_chunks::<16>();
            if width == 16 {
                let matrix = |columns: &[f32; 16]| DMat4::from_cols_array(&columns.map(f64::from));
                inverse_binds = matrices.iter().take(joints.len()).map(matrix).collect();
            }
        }
        inverse_binds.resize(joints.len(), DMat4::IDENTITY);
        Ok(Self { joints, inverse_binds })
    }

    /// Returns the matrix of each joint, from the mesh to the scene.
    pub(super) fn joint_matrices(&self, matrices: &[DMat4]) -> Vec<DMat4> {
        let matrix = |(&joint, inverse_bind): (&usize, &DMat4)| {
            matrices.get(joint).copied().unwrap_or(DMat4::IDENTITY) * *inverse_bind
        };
        self.joints.iter().zip(&self.inverse_binds).map(matrix).collect()
    }

    /// Moves positions with the joints that their vertices belong to; vertices without weights stay.
    pub(super) fn deform(&self, matrices: &[DMat4], mesh: &IndexedMesh, positions: &mut [[f32; 3]]) {
        let joint_matrices = self.joint_matrices(matrices);
        let joints = VertexJoints::of(mesh);
        for (vertex, position) in positions.iter_mut().enumerate() {
            if let Some(matrix) = joints.matrix(vertex, &joint_matrices) {
                *position = transformed(&matrix, *position);
            }
        }
    }
}

/// Joints and weights of the vertices of a mesh.
pub(crate) struct VertexJoints<'m> {
    sets: Vec<(&'m AttributeLayer, &'m AttributeLayer)>,
}

impl<'m> VertexJoints<'m> {
    pub(crate) fn of(mesh: &'m IndexedMesh) -> Self {
        let sets = (0..=u8::MAX)
            .map_while(|set| mesh.layer(&Semantic::Joints(set)).zip(mesh.layer(&Semantic::Weights(set))));
        Self { sets: sets.collect() }
    }

    /// Returns the mean of the matrices of a vertex' joints; [`None`] for a vertex without weights.
    pub(crate) fn matrix(&self, vertex: usize, joint_matrices: &[DMat4]) -> Option<DMat4> {
        let (mut sum, mut total) = (DMat4::ZERO, 0.0);
        for &(joints, weights) in &self.sets {
            let width = joints.component_count.min(weights.component_count) as usize;
            for slot in 0..width {
                let weight = f64::from(weights.get(vertex, slot));
                let joint = joint_of(joints, vertex, slot);
                if let Some(matrix) = joint_matrices.get(joint).filter(|_| weight != 0.0) {
                    sum += *matrix * weight;
                    total += weight;
                }
            }
        }
        (total != 0.0).then(|| sum * (1.0 / total))
    }
}

/// Returns a joint of a vertex as an integer, whatever the type of the layer.
fn joint_of(joints: &AttributeLayer, vertex: usize, slot: usize) -> usize {
    let at = vertex * joints.component_count as usize + slot;
    match &joints.data {
        LayerData::U8(data) => usize::from(data[at]),
        LayerData::U16(data) => usize::from(data[at]),
        data => data.number(at) as usize,
    }
}
