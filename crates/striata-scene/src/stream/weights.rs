//! Weights of joints, which add up to 1.

use striata::mesh::{IndexedMesh, LayerData, Semantic};

/// Sums that differ less from 1 are left alone: floats are not more precise.
const EXACT: f64 = 1e-6;

/// Sums that differ more from 1 are not due to rounding.
const ROUNDED: f64 = 0.25;

/// Divides the weights of each vertex, which were rounded one by one, by their sum.
pub(crate) fn normalize_weights(mesh: &mut IndexedMesh) {
    let mut sums = vec![0.0f64; mesh.vertex_count()];
    for_each_weight(mesh, |vertex, weight| sums[vertex] += f64::from(*weight));
    for_each_weight(mesh, |vertex, weight| {
        let off = (sums[vertex] - 1.0).abs();
        if off > EXACT && off < ROUNDED {
            *weight = (f64::from(*weight) / sums[vertex]) as f32;
        }
    });
}

/// Calls `visit` with each weight that is a float, and the index of its vertex.
fn for_each_weight(mesh: &mut IndexedMesh, mut visit: impl FnMut(usize, &mut f32)) {
    for layer in &mut mesh.layers {
        let (Semantic::Weights(_), LayerData::F32(weights)) = (&layer.semantic, &mut layer.data) else {
            continue;
        };
        let components = usize::from(layer.component_count.max(1));
        weights.iter_mut().enumerate().for_each(|(at, weight)| visit(at / components, weight));
    }
}

#[cfg(test)]
mod tests {
    use striata::mesh::AttributeLayer;

    use super::*;

    #[test]
    fn rounded_weights_add_up_to_one_in_all_sets_together() {
        let mut mesh = IndexedMesh::new(vec![[0.0; 3]; 3], vec![[0, 1, 2]]);
        let layer = |set, weights: [[f32; 4]; 3]| {
            AttributeLayer::from_f32(Semantic::Weights(set), 4, weights.as_flattened().to_vec())
        };
        let none = [0.0; 4];
        mesh.layers = vec![
            layer(0, [[0.3, 0.3, 0.1, 0.1], [1.0, 0.0, 0.0, 0.0], none]),
            layer(1, [[0.21, 0.0, 0.0, 0.0], none, none]),
        ];
        normalize_weights(&mut mesh);
        let sum = |vertex| {
            (0..4).map(|i| mesh.layers[0].get(vertex, i) + mesh.layers[1].get(vertex, i)).sum::<f32>()
        };
        assert!((sum(0) - 1.0).abs() < 1e-6);
        assert_eq!((sum(1), sum(2)), (1.0, 0.0));
        assert!((mesh.layers[1].get(0, 0) - 0.21 / 1.01).abs() < 1e-6);
    }
}
