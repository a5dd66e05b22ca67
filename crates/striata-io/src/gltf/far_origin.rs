//! The origin of a scene whose nodes place meshes far from zero.
//!
//! Vertices are single precision and nodes are doubles: placed far away, a vertex needs both. The origin is
//! chosen from the bounds that accessors declare, so that nothing needs to be decoded, and readers of whole
//! files and of pieces agree.

use serde_json::Value;
use striata::mesh::origin_of;

use super::document::GltfDocument;
use super::primitive::Primitive;
use super::transform::Transform;

/// Number of diagonals from which on a scene is far from zero.
const FAR: f64 = 16.0;

/// Returns the corners of the bounds that a primitive declares, where a node places them.
pub(crate) fn placed_corners(
    document: &GltfDocument<'_>,
    primitive: &Primitive<'_>,
    transform: Option<&Transform>,
) -> Vec<[f64; 3]> {
    let Ok(accessor) = document.item("accessors", primitive.position, &primitive.at) else {
        return Vec::new();
    };
    let is_normalized = accessor.value.get("normalized") == Some(&Value::Bool(true));
    let scale = match accessor.value.get("componentType").and_then(Value::as_u64) {
        Some(5120) if is_normalized => 1.0 / 127.0,
        Some(5121) if is_normalized => 1.0 / 255.0,
        Some(5122) if is_normalized => 1.0 / 32_767.0,
        Some(5123) if is_normalized => 1.0 / 65_535.0,
        _ => 1.0,
    };
    let corner = |key: &str| {
        let numbers = accessor.value.get(key)?.as_array()?;
        let number = |axis: usize| Some((numbers.get(axis)?.as_f64()? * scale) as f32);
        Some([number(0)?, number(1)?, number(2)?])
    };
    let corners = [corner("min"), corner("max")].into_iter().flatten();
    let placed = corners.map(|point| match transform {
        Some(transform) => transform.exact_point(point),
        None => point.map(f64::from),
    });
    placed.collect()
}

/// Chooses the origin of a scene from the corners of what it shows; zero unless all of it is far from there.
pub(crate) fn origin_of_corners(mut corners: Vec<[f64; 3]>) -> [f64; 3] {
    corners.retain(|point| point.iter().all(|x| x.is_finite()));
    corners.sort_by_key(|point| point.map(f64::to_bits));
    corners.dedup();
    let largest = corners.iter().flatten().map(|x| x.abs()).fold(0.0, f64::max);
    let extent = |axis: usize| {
        let values = corners.iter().map(|point| point[axis]);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    let diagonal = [0, 1, 2].map(extent).iter().map(|x| x * x).sum::<f64>().sqrt();
    if diagonal > 0.0 && largest > FAR * diagonal { origin_of(&corners) } else { [0.0; 3] }
}
