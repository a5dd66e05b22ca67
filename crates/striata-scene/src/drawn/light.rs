//! Lights of `KHR_lights_punctual`, placed in the scene.

use glam::{DMat4, DVec3};
use serde_json::Value;
use striata_io::Scene;

use super::json::{extension, number, numbers};
use super::shown_nodes::shown_nodes;
use crate::Pose;
use crate::document::{entries, index};

/// Shape of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightKind {
    /// Parallel light; its intensity is in lux.
    Directional,
    /// Light from a point in all directions; its intensity is in candela.
    Point,
    /// Light from a point within a cone; its intensity is in candela.
    Spot {
        /// Cosine of the angle up to which the light is full.
        inner_cos: f32,
        /// Cosine of the angle from which on there is no light.
        outer_cos: f32,
    },
}

/// A light of the document.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Shape.
    pub kind: LightKind,
    /// Color times intensity, linear.
    pub color: [f32; 3],
    /// Distance at which the light ends, scene units; [`None`] if it has no end.
    pub range: Option<f32>,
    /// Position, scene units.
    pub position: [f32; 3],
    /// Unit vector in which the light shines.
    pub direction: [f32; 3],
}

/// Most lights that are read: more would make pictures slow, and no scene looks different without them.
const MAX_LIGHTS: usize = 64;

/// Returns the lights that the default scene shows in a pose; at most 64.
pub fn lights(scene: &Scene, pose: &Pose) -> Vec<Light> {
    let document = scene.document();
    let Some(known) = extension(document, "KHR_lights_punctual") else { return Vec::new() };
    let known = entries(known, "lights");
    let nodes = shown_nodes(document).into_iter();
    let placed = nodes.filter_map(|(node, value)| {
        let light = known.get(index(extension(value, "KHR_lights_punctual")?, "light")?)?;
        read(light, &pose.node_matrix(node)?)
    });
    placed.take(MAX_LIGHTS).collect()
}

fn read(light: &Value, matrix: &DMat4) -> Option<Light> {
    let kind = match light.get("type")?.as_str()? {
        "directional" => LightKind::Directional,
        "point" => LightKind::Point,
        "spot" => {
            let empty = Value::Null;
            let spot = light.get("spot").unwrap_or(&empty);
            let half_circle = std::f32::consts::FRAC_PI_2;
            let outer = number(spot, "outerConeAngle").unwrap_or(half_circle / 2.0).clamp(0.0, half_circle);
            let inner = number(spot, "innerConeAngle").unwrap_or(0.0).clamp(0.0, outer);
            LightKind::Spot { inner_cos: inner.cos(), outer_cos: outer.cos() }
        }
        _ => return None,
    };
    let intensity = number(light, "intensity").unwrap_or(1.0).max(0.0);
    let color: [f32; 3] = numbers(light, "color").unwrap_or([1.0; 3]);
    let position = matrix.transform_point3(DVec3::ZERO).as_vec3();
    let direction = matrix.transform_vector3(DVec3::NEG_Z).normalize_or(DVec3::NEG_Z).as_vec3();
    Some(Light {
        kind,
        color: color.map(|x| (x.max(0.0) * intensity).min(f32::MAX)),
        range: number(light, "range").filter(|&range| range > 0.0),
        position: position.to_array(),
        direction: direction.to_array(),
    })
    .filter(|light| position.is_finite() && light.color.iter().any(|&x| x > 0.0))
}
