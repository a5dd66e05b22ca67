//! Transforms of nodes, combined with the conversion from grid steps to lengths.

use glam::{DMat4, DQuat, DVec3};
use serde_json::{Value, json};

use super::grid::MeshGrid;

impl MeshGrid {
    fn origin(&self) -> DVec3 {
        DVec3::from_array(self.origin)
    }

    /// Returns the conversion from grid coordinates to positions.
    pub(super) fn matrix(&self) -> DMat4 {
        DMat4::from_scale_rotation_translation(
            DVec3::splat(f64::from(self.step)),
            DQuat::IDENTITY,
            self.origin(),
        )
    }

    /// Returns how much rounding may change a translation and a scale, for steps of this size after scaling.
    fn tolerances(&self, step: DVec3) -> [f64; 2] {
        if self.is_shared { [0.0; 2] } else { [0.001 * step.abs().min_element(), f64::INFINITY] }
    }

    /// Returns translation and scale after the conversion has been applied first.
    pub(super) fn folded(&self, translation: DVec3, rotation: DQuat, scale: DVec3) -> [DVec3; 2] {
        [translation + rotation * (scale * self.origin()), scale * f64::from(self.step)]
    }
}

/// Returns a number in as few digits as the closest float needs, if they differ by at most `tolerance`.
fn short(number: f64, tolerance: f64) -> Value {
    let float = (number as f32).to_string().parse::<f64>();
    float.ok().filter(|float| (float - number).abs() <= tolerance).map_or(json!(number), |float| json!(float))
}

/// Returns the numbers of a vector.
fn short_list(vector: DVec3, tolerance: f64) -> Value {
    Value::Array(vector.to_array().map(|number| short(number, tolerance)).to_vec())
}

/// Writes the conversion to a node without a transform.
pub(super) fn set(node: &mut Value, grid: &MeshGrid) {
    let [translation, scale] = grid.folded(DVec3::ZERO, DQuat::IDENTITY, DVec3::ONE);
    set_parts(node, grid, translation, scale);
}

/// Translations of models far from the origin need more digits than a float has.
fn set_parts(node: &mut Value, grid: &MeshGrid, translation: DVec3, scale: DVec3) {
    let [moves, scales] = grid.tolerances(scale);
    node["translation"] = short_list(translation, moves);
    node["scale"] = short_list(scale, scales);
}

/// Applies the conversion before the transform of a node; false if the node's transform is malformed or
/// would overflow.
pub(super) fn fold(node: &mut Value, grid: &MeshGrid) -> bool {
    if node.get("matrix").is_some() {
        let Some(numbers) = numbers::<16>(node, "matrix", [0.0; 16]) else { return false };
        let matrix = (DMat4::from_cols_array(&numbers) * grid.matrix()).to_cols_array();
        if !matrix.iter().all(|&x| is_float(x)) {
            return false;
        }
        let axes = [0, 4, 8].map(|k| DVec3::new(matrix[k], matrix[k + 1], matrix[k + 2]).length());
        let [moves, scales] = grid.tolerances(DVec3::from_array(axes));
        let entry = |(k, x)| short(x, if k < 12 { scales } else { moves });
        node["matrix"] = Value::Array(matrix.into_iter().enumerate().map(entry).collect());
        return true;
    }
    let parts = numbers(node, "translation", [0.0; 3])
        .zip(numbers(node, "rotation", [0.0, 0.0, 0.0, 1.0]))
        .zip(numbers(node, "scale", [1.0; 3]));
    let Some(((translation, rotation), scale)) = parts else { return false };
    let rotation = DQuat::from_array(rotation);
    // Readers differ in what they make of others.
    if (rotation.length_squared() - 1.0).abs() > 1e-5 {
        return false;
    }
    let [translation, scale] =
        grid.folded(DVec3::from_array(translation), rotation, DVec3::from_array(scale));
    if !translation.to_array().into_iter().chain(scale.to_array()).all(is_float) {
        return false;
    }
    set_parts(node, grid, translation, scale);
    true
}

fn is_float(number: f64) -> bool {
    (number as f32).is_finite()
}

/// Returns the numbers of a member, or the default if it is missing.
fn numbers<const N: usize>(node: &Value, key: &str, default: [f64; N]) -> Option<[f64; N]> {
    let Some(value) = node.get(key) else { return Some(default) };
    let numbers: Option<Vec<f64>> = value.as_array()?.iter().map(Value::as_f64).collect();
    numbers?.try_into().ok()
}
