//! Cameras of the document, placed in the scene.

use glam::DVec3;
use serde_json::Value;
use striata_io::Scene;

use super::json::number;
use super::shown_nodes::shown_nodes;
use crate::Pose;
use crate::document::{entries, index};

/// Projection of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Projection {
    /// Perspective, with this vertical field of view in radians.
    Perspective {
        /// Vertical field of view, radians.
        fov: f32,
    },
    /// Parallel, with half this height of the picture in scene units.
    Orthographic {
        /// Half the height of the picture, scene units.
        half_height: f32,
    },
}

/// A camera of the document, as a node places it.
#[derive(Clone, Debug, PartialEq)]
pub struct DocumentCamera {
    /// Name of the camera or else of its node; may be empty.
    pub name: String,
    /// Projection.
    pub projection: Projection,
    /// Position of the eye, scene units.
    pub eye: [f32; 3],
    /// Unit vector in which the camera looks.
    pub forward: [f32; 3],
    /// Unit vector that is up in the picture.
    pub up: [f32; 3],
}

/// Returns the cameras that the default scene shows in a pose, in the order of the nodes. Cameras without a valid projection
/// or position are left out.
pub fn cameras(scene: &Scene, pose: &Pose) -> Vec<DocumentCamera> {
    let known = entries(scene.document(), "cameras");
    let nodes = shown_nodes(scene.document()).into_iter();
    let placed = nodes.filter_map(|(node, value)| {
        let camera = known.get(index(value, "camera")?)?;
        let matrix = pose.node_matrix(node)?;
        let [eye, forward, up] = [
            matrix.transform_point3(DVec3::ZERO),
            matrix.transform_vector3(DVec3::NEG_Z).try_normalize()?,
            matrix.transform_vector3(DVec3::Y).try_normalize()?,
        ]
        .map(|v| v.as_vec3());
        let name = |value: &Value| value.get("name").and_then(Value::as_str).map(str::to_owned);
        Some(DocumentCamera {
            name: name(camera).or_else(|| name(value)).unwrap_or_default(),
            projection: projection(camera)?,
            eye: eye.is_finite().then(|| eye.to_array())?,
            forward: forward.to_array(),
            up: up.to_array(),
        })
    });
    placed.collect()
}

fn projection(camera: &Value) -> Option<Projection> {
    if let Some(perspective) = camera.get("perspective") {
        let fov = number(perspective, "yfov").filter(|&fov| fov > 0.0 && fov < std::f32::consts::PI)?;
        return Some(Projection::Perspective { fov });
    }
    let half_height = number(camera.get("orthographic")?, "ymag").filter(|&height| height != 0.0)?;
    Some(Projection::Orthographic { half_height: half_height.abs() })
}
