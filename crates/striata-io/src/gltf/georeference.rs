//! Terrains in glTF: their place on the Earth, and which way is up.
//!
//! Meshes with a georeference are z up; glTF is y up. The nodes of such a mesh are therefore turned when it is
//! written, and turned back when the scene is read as one mesh, so that its coordinates stay those of the map. A
//! [`Scene`](crate::Scene) keeps its nodes as they are, and is y up like any other.

use glam::{DMat4, DVec3, DVec4};
use serde_json::{Value, json};

use striata::mesh::Appearance;

/// Name of the place of a terrain among the extras of a scene.
const GEOREFERENCE: &str = "georeference";

/// Matrix that turns z up into y up. It is exact, unlike a rotation by a quaternion.
const Z_UP_TO_Y_UP: DMat4 = DMat4::from_cols(DVec4::X, DVec4::NEG_Z, DVec4::Y, DVec4::W);

/// Returns the place of a terrain on the Earth that the default scene of a document has.
pub(crate) fn georeference_in(document: &Value) -> Option<&Value> {
    let scene = document.get("scene").and_then(Value::as_u64).unwrap_or(0);
    let scene = document.get("scenes")?.get(usize::try_from(scene).ok()?)?;
    scene.get("extras")?.get(GEOREFERENCE).filter(|place| place.is_object())
}

/// Returns the matrix from y up to z up for a scene with a georeference, which gives back the coordinates of the map.
pub(super) fn turn_of_terrain(document: &Value) -> Option<DMat4> {
    georeference_in(document).map(|_| Z_UP_TO_Y_UP.transpose())
}

/// Adds the georeference of a mesh to the entry of the scene that shows it.
pub(crate) fn add_georeference(scene: &mut Value, appearance: &Appearance) {
    if let Ok(georeference) = serde_json::from_str::<Value>(&appearance.georeference) {
        scene["extras"] = json!({ GEOREFERENCE: georeference });
    }
}

/// Whether a mesh has a georeference, so that its z axis is up.
pub(crate) fn is_terrain(appearance: &Appearance) -> bool {
    !appearance.georeference.is_empty()
}

/// Places a node at the origin of its mesh, and turns the z axis to the y axis if it is up.
pub(crate) fn place_node(node: &mut Value, origin: [f64; 3], is_z_up: bool) {
    if is_z_up {
        let matrix = Z_UP_TO_Y_UP * DMat4::from_translation(DVec3::from_array(origin));
        // Adding 0 turns −0 into 0.
        node["matrix"] = json!(matrix.to_cols_array().map(|x| x + 0.0));
    } else if origin != [0.0; 3] {
        node["translation"] = json!(origin);
    }
}
