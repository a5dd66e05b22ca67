//! Importance of the objects of a scene, the third criterion of detail in \[BRR02\] 1, besides distance and speed.
//!
//! Nodes and meshes have it as the number `importance` of their `extras`. That of a node counts for all below it.

use serde_json::Value;

use super::json::{JsonNode, describe};
use crate::error::{Fault, Place};
use crate::report::Warnings;

/// Least and largest importance. Within them, no product of squared errors overflows or vanishes.
const RANGE: [f64; 2] = [1e-6, 1e6];

/// Returns an importance within the limits; [`None`] for what is no positive number.
pub(crate) fn usable(importance: f64) -> Option<f64> {
    let is_usable = importance > 0.0 && importance.is_finite();
    is_usable.then(|| importance.clamp(RANGE[0], RANGE[1]))
}

/// Returns the importance of an object below others, whose importance is `above`.
pub(super) fn below(above: f64, object: &JsonNode<'_>) -> f64 {
    let own = stated(object.value).and_then(Value::as_f64).and_then(usable);
    (above * own.unwrap_or(1.0)).clamp(RANGE[0], RANGE[1])
}

/// Warns about each importance that is no positive number.
pub(super) fn check(root: &JsonNode<'_>, warnings: &mut Warnings) -> Result<(), Fault> {
    for key in ["nodes", "meshes"] {
        for (index, value) in root.values(key)?.iter().enumerate() {
            if let Some(found) = stated(value).filter(|found| found.as_f64().and_then(usable).is_none()) {
                let place = Place::Json(format!("{key}[{index}].extras.importance"));
                warnings.push(
                    place,
                    format!("expected a positive number, found {}; it counts as 1", describe(found)),
                );
            }
        }
    }
    Ok(())
}

fn stated(object: &Value) -> Option<&Value> {
    object.get("extras")?.get("importance")
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use striata::mesh::shapes;

    use super::*;
    use crate::{Scene, SceneParts};

    #[test]
    fn importance_is_inherited_and_bad_values_are_1() {
        let document = json!({
            "scene": 0,
            "scenes": [{ "nodes": [0, 3, 4] }],
            "nodes": [
                { "children": [1, 2], "extras": { "importance": 2 } },
                { "mesh": 0, "extras": { "importance": 3 } },
                { "mesh": 0, "extras": { "importance": -3 } },
                { "mesh": 0, "extras": { "importance": 1e300 } },
                { "mesh": 0, "extras": { "importance": "high" } },
            ],
            "meshes": [{ "primitives": [{ "attributes": { "POSITION": null } }], "extras": { "importance": 0.5 } }],
        });
        let mut warnings = Warnings::of_file("scene.gltf");
        check(&JsonNode { value: &document, path: String::new() }, &mut warnings).unwrap();
        let warned: Vec<String> =
            warnings.into_list().iter().map(|warning| warning.place.to_string()).collect();
        assert_eq!(warned, ["nodes[2].extras.importance", "nodes[4].extras.importance"]);
        let meshes = vec![Some(shapes::tetrahedron())];
        let scene = Scene::from_parts(SceneParts { document, meshes, ..SceneParts::default() }).unwrap();
        let found: Vec<f64> = scene.instances().iter().map(|instance| instance.importance).collect();
        assert_eq!(found, [3.0, 1.0, 0.5e6, 0.5]);
    }
}
