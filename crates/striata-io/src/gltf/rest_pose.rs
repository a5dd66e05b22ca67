//! The pose of the nodes, applied to the vertices of a mesh: weights of morph targets, then skins.
//!
//! A mesh without a scene has nothing else to be posed by, and the vertices of a skinned mesh may be in any
//! units: quantization changes them and the inverse bind matrices together.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use glam::DMat4;
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic};

use super::accessor::accessor;
use super::document::GltfDocument;
use super::json::JsonNode;
use super::transform::{Transform, transform_values};
use crate::error::Fault;

/// Matrices of the joints of a skin, from the mesh to the scene.
pub(crate) struct SkinPose {
    /// Index of the skin.
    index: u64,
    matrices: Vec<DMat4>,
}

/// Weights of the morph targets of a node and the pose of its skin.
#[derive(Clone, Default)]
pub(crate) struct RestPose {
    /// Bits of the weight of each morph target; none if all are 0.
    morph_weights: Arc<[u32]>,
    skin: Option<Arc<SkinPose>>,
}

/// Identity of a pose: the skin, and the bits of the weights.
pub(crate) type PoseKey = (Option<u64>, Arc<[u32]>);

/// Reads the poses of nodes; each skin is read once.
pub(super) struct RestPoses {
    /// Transform of each node of the scene.
    matrix_of: BTreeMap<usize, DMat4>,
    skins: BTreeMap<u64, Arc<SkinPose>>,
}

impl RestPoses {
    /// Starts with the transform of each node of the scene.
    pub(super) fn new(matrix_of: BTreeMap<usize, DMat4>) -> Self {
        Self { matrix_of, skins: BTreeMap::new() }
    }

    /// Returns the pose of a mesh that a node shows.
    pub(super) fn of_node(
        &mut self,
        document: &GltfDocument<'_>,
        node: &JsonNode<'_>,
        mesh: &JsonNode<'_>,
    ) -> Result<RestPose, Fault> {
        let skin = node.get("skin").map(|at| self.skin(document, &at)).transpose()?;
        // Like the poses of scenes, malformed weights count as none.
        let weights = node.get("weights").or_else(|| mesh.get("weights"));
        let weights = weights.and_then(|at| at.value.as_array()).into_iter().flatten();
        let weights: Vec<f32> = weights.map(|weight| weight.as_f64().unwrap_or(0.0) as f32).collect();
        let is_at_rest = weights.iter().all(|&weight| weight == 0.0);
        let bits = weights.iter().map(|weight| weight.to_bits()).filter(|_| !is_at_rest);
        Ok(RestPose { morph_weights: bits.collect(), skin })
    }

    fn skin(&mut self, document: &GltfDocument<'_>, from: &JsonNode<'_>) -> Result<Arc<SkinPose>, Fault> {
        let index = from.as_unsigned()?;
        if let Some(known) = self.skins.get(&index) {
            return Ok(Arc::clone(known));
        }
        let at = document.item("skins", index, from)?;
        let joints = at.entries("joints")?;
        let mut inverse_binds = Vec::new();
        if let Some(number) = at.unsigned("inverseBindMatrices")? {
            let found = accessor(document, number, &at)?;
            // Without usable matrices the joints move the mesh from the origin, as if there were none.
            if found.component_count == 16 {
                let numbers = found.floats();
                let (matrices, _) = numbers.as_chunks::<16>();
                inverse_binds.extend(matrices.iter().map(|m| DMat4::from_cols_array(&m.map(f64::from))));
            }
        }
        let mut matrices = Vec::with_capacity(joints.len());
        for (joint, node) in joints.iter().enumerate() {
            let node = usize::try_from(node.as_unsigned()?).ok();
            let placed = node.and_then(|node| self.matrix_of.get(&node)).copied().unwrap_or_default();
            matrices.push(placed * inverse_binds.get(joint).copied().unwrap_or_default());
        }
        let pose = Arc::new(SkinPose { index, matrices });
        self.skins.insert(index, Arc::clone(&pose));
        Ok(pose)
    }
}

impl RestPose {
    /// Returns the key of the pose: its skin and its morph weights.
    pub(crate) fn key(&self) -> PoseKey {
        (self.skin.as_ref().map(|skin| skin.index), Arc::clone(&self.morph_weights))
    }

    /// Whether joints move the vertices.
    pub(crate) fn has_skin(&self) -> bool {
        self.skin.is_some()
    }

    /// Moves a range of vertices: first by the morph targets, then by the joints.
    pub(crate) fn apply(&self, mesh: &mut IndexedMesh, range: Range<usize>) {
        self.morph(mesh, range.clone());
        if let Some(skin) = &self.skin {
            skin.deform(mesh, range);
        }
    }

    fn morph(&self, mesh: &mut IndexedMesh, range: Range<usize>) {
        let weights = self.morph_weights.iter().map(|&bits| f32::from_bits(bits));
        for (target, weight) in weights.enumerate().filter(|&(_, weight)| weight != 0.0) {
            let Ok(target) = u16::try_from(target) else { return };
            let IndexedMesh { positions, layers, .. } = mesh;
            if let Some(deltas) = place_of(layers, &Semantic::MorphPosition(target)) {
                let deltas = &layers[deltas];
                for vertex in range.clone() {
                    for (axis, x) in positions[vertex].iter_mut().enumerate() {
                        *x += weight * finite(deltas.get(vertex, axis));
                    }
                }
            }
            add_directions(mesh, &Semantic::Normal, &Semantic::MorphNormal(target), weight, range.clone());
            add_directions(mesh, &Semantic::Tangent, &Semantic::MorphTangent(target), weight, range.clone());
        }
        if !self.morph_weights.is_empty() {
            for semantic in [Semantic::Normal, Semantic::Tangent] {
                normalize(mesh, &semantic, range.clone());
            }
        }
    }
}

/// A number, or 0 if it is not finite, as `repair` has it afterwards.
fn finite(number: f32) -> f32 {
    if number.is_finite() { number } else { 0.0 }
}

/// Adds displacements, in proportion to a weight, to the directions of a layer.
fn add_directions(
    mesh: &mut IndexedMesh,
    directions: &Semantic,
    deltas: &Semantic,
    weight: f32,
    range: Range<usize>,
) {
    let Some(deltas) = part_of(mesh, deltas, &range) else { return };
    let Some((data, width)) = floats_of(mesh, directions) else { return };
    for (own, vertex) in range.enumerate() {
        for axis in 0..3 {
            data[vertex * width + axis] += weight * finite(deltas.get(own, axis));
        }
    }
}

/// Copies a range of the vertices of a layer.
fn part_of(mesh: &IndexedMesh, semantic: &Semantic, range: &Range<usize>) -> Option<AttributeLayer> {
    let layer = &mesh.layers[place_of(&mesh.layers, semantic)?];
    let vertices: Vec<u32> = range.clone().map(|vertex| vertex as u32).collect();
    Some(layer.gather(&vertices))
}

/// Returns the place of a layer. The layers of a flattened scene are sorted, and there may be any number.
fn place_of(layers: &[AttributeLayer], semantic: &Semantic) -> Option<usize> {
    debug_assert!(layers.is_sorted_by(|a, b| a.semantic < b.semantic), "layers are sorted");
    layers.binary_search_by(|layer| layer.semantic.cmp(semantic)).ok()
}

/// Makes the directions of a layer unit vectors again; those without a length stay.
fn normalize(mesh: &mut IndexedMesh, semantic: &Semantic, range: Range<usize>) {
    let Some((data, width)) = floats_of(mesh, semantic) else { return };
    for direction in data[range.start * width..range.end * width].chunks_exact_mut(width) {
        let (vector, _) = direction.split_at_mut(3);
        let wide = [vector[0], vector[1], vector[2]].map(f64::from);
        if let Some(unit) = crate::normals::unit(wide) {
            vector.copy_from_slice(&unit);
        }
    }
}

/// Returns the numbers of a layer of directions, and how many there are for each vertex.
fn floats_of<'m>(mesh: &'m mut IndexedMesh, semantic: &Semantic) -> Option<(&'m mut [f32], usize)> {
    let place = place_of(&mesh.layers, semantic)?;
    let layer = &mut mesh.layers[place];
    let width = layer.component_count as usize;
    match &mut layer.data {
        LayerData::F32(data) if width >= 3 => Some((data, width)),
        _ => None,
    }
}

impl SkinPose {
    /// Moves vertices, their directions and the displacements of their morph targets with their joints;
    /// vertices without weights stay.
    fn deform(&self, mesh: &mut IndexedMesh, range: Range<usize>) {
        let sets: Vec<(AttributeLayer, AttributeLayer)> = (0..=u8::MAX)
            .map_while(|set| {
                let part = |semantic| part_of(mesh, &semantic, &range);
                part(Semantic::Joints(set)).zip(part(Semantic::Weights(set)))
            })
            .collect();
        for (own, vertex) in range.enumerate() {
            let Some(transform) = self.matrix(&sets, own).and_then(Transform::new) else { continue };
            mesh.positions[vertex] = transform.point(mesh.positions[vertex]);
            for layer in &mut mesh.layers {
                let width = layer.component_count as usize;
                if let LayerData::F32(data) = &mut layer.data {
                    let own = &mut data[vertex * width..(vertex + 1) * width];
                    transform_values(&layer.semantic, own, &transform);
                }
            }
        }
    }

    /// Returns the mean of the matrices of the joints of a vertex; [`None`] if it has none.
    fn matrix(&self, sets: &[(AttributeLayer, AttributeLayer)], vertex: usize) -> Option<DMat4> {
        let (mut sum, mut total, mut is_strange) = (DMat4::ZERO, 0.0, false);
        for (joints, weights) in sets {
            for slot in 0..joints.component_count.min(weights.component_count) as usize {
                let weight = weights.get(vertex, slot);
                is_strange |= !weight.is_finite();
                let weight = f64::from(finite(weight));
                let joint = joints.get(vertex, slot) as usize;
                if let Some(matrix) = self.matrices.get(joint).filter(|_| weight != 0.0) {
                    sum += *matrix * weight;
                    total += weight;
                }
            }
        }
        if total == 0.0 && is_strange {
            // Then `repair` gives all weight to the first joint.
            let (joints, _) = sets.first()?;
            return self.matrices.get(joints.get(vertex, 0) as usize).copied();
        }
        (total != 0.0).then(|| sum * (1.0 / total))
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn weights_that_are_no_numbers_move_nothing_to_nowhere() {
        let matrices = vec![DMat4::from_translation(DVec3::X), DMat4::IDENTITY];
        let skin = SkinPose { index: 0, matrices };
        let joints = LayerData::U8(vec![0, 1, 0, 1]);
        let joints =
            AttributeLayer { data: joints, ..AttributeLayer::from_f32(Semantic::Joints(0), 2, Vec::new()) };
        let weights =
            AttributeLayer::from_f32(Semantic::Weights(0), 2, vec![f32::NAN, 1.0, f32::NAN, f32::INFINITY]);
        let sets = [(joints, weights)];
        assert_eq!(skin.matrix(&sets, 0), Some(DMat4::IDENTITY));
        assert_eq!(skin.matrix(&sets, 1), Some(DMat4::from_translation(DVec3::X)));
    }
}
