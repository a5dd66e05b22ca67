//! How much each mesh counts in a scene.

use serde_json::{Value, json};
use striata_io::{Scene, SceneParts};

use crate::document::{entries, index};

/// How much the errors and triangles of a mesh count in a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeshWeight {
    /// Units of the scene per unit of the mesh: the largest scale among its instances.
    pub scale: f64,
    /// Number of times that its triangles are counted; 0 if nothing shows the mesh, whose errors then do not
    /// count either.
    pub instance_count: usize,
    /// How much its errors count when triangles are shared out among the meshes; 1 for as much as those of others.
    /// Errors that are reported, and levels by error, do not depend on it.
    pub importance: f64,
}

impl Default for MeshWeight {
    fn default() -> Self {
        Self { scale: 1.0, instance_count: 1, importance: 1.0 }
    }
}

impl MeshWeight {
    /// Returns the weights of all meshes, from their instances in the default scene.
    ///
    /// A mesh without an instance is coarsened together with the others, as if its scale were 1, but counts in
    /// no number; if nothing at all is shown, every mesh counts once. The scale is the largest one at rest and
    /// in all animations of the node and its ancestors, since an object that appears by growing needs the level of
    /// its full size. The scale of a mesh all of whose instances are flattened to a point is 1.
    ///
    /// The importance is the largest among its instances.
    pub fn of_scene(scene: &Scene) -> Vec<Self> {
        let mut weights = vec![Self { scale: 0.0, instance_count: 0, importance: 0.0 }; scene.meshes().len()];
        let largest = at_largest_scales(scene);
        for instance in largest.as_ref().unwrap_or(scene).instances() {
            let weight = &mut weights[instance.mesh];
            weight.instance_count += 1;
            weight.importance = weight.importance.max(instance.importance);
            if instance.scale.is_finite() {
                weight.scale = weight.scale.max(instance.scale);
            }
        }
        let shows_nothing = scene.instances().is_empty();
        for weight in &mut weights {
            if shows_nothing {
                weight.instance_count = 1;
            }
            if weight.scale == 0.0 {
                weight.scale = 1.0;
            }
            if weight.importance == 0.0 {
                weight.importance = 1.0;
            }
        }
        weights
    }
}

/// Returns the scene without meshes, each node with the largest scales of its animations; [`None`] if no
/// animation changes a scale.
fn at_largest_scales(scene: &Scene) -> Option<Scene> {
    let keyed = keyed_scales(scene.document());
    if keyed.is_empty() {
        return None;
    }
    let SceneParts { mut document, buffer, images, meshes } = scene.without_meshes().into_parts();
    for (node, output, is_spline) in keyed {
        let Ok((numbers, 3)) = scene.numbers(output) else { continue };
        let Some(node) = document.get_mut("nodes").and_then(|nodes| nodes.get_mut(node)) else { continue };
        let axis = |axis: usize| {
            let rest = node.pointer(&format!("/scale/{axis}")).and_then(Value::as_f64).unwrap_or(1.0);
            // Keys of splines have tangents around their values.
            let (first, step) = if is_spline { (1, 3) } else { (0, 1) };
            let keys = numbers.as_chunks::<3>().0.iter().skip(first).step_by(step);
            let keys = keys.map(|key| f64::from(key[axis])).filter(|x| x.is_finite());
            keys.fold(rest, |most, x| if x.abs() > most.abs() { x } else { most })
        };
        node["scale"] = json!([axis(0), axis(1), axis(2)]);
    }
    Scene::from_parts(SceneParts { document, buffer, images, meshes }).ok()
}

/// Returns the node, the accessor of the keys and whether they are a spline, of each animation of a scale.
fn keyed_scales(document: &Value) -> Vec<(usize, u64, bool)> {
    let mut found = Vec::new();
    for animation in entries(document, "animations") {
        for channel in entries(animation, "channels") {
            let Some(target) = channel.get("target") else { continue };
            let node = match target.get("path").and_then(Value::as_str) {
                Some("scale") => index(target, "node"),
                Some("pointer") => {
                    let pointer = target.pointer("/extensions/KHR_animation_pointer/pointer");
                    let rest = pointer.and_then(Value::as_str).and_then(|text| text.strip_prefix("/nodes/"));
                    rest.and_then(|rest| rest.strip_suffix("/scale")?.parse().ok())
                }
                _ => None,
            };
            let sampler =
                index(channel, "sampler").and_then(|sampler| entries(animation, "samplers").get(sampler));
            let output = sampler.and_then(|sampler| sampler.get("output")?.as_u64());
            let is_spline = sampler.is_some_and(|sampler| sampler["interpolation"] == "CUBICSPLINE");
            if let (Some(node), Some(output)) = (node, output) {
                found.push((node, output, is_spline));
            }
        }
    }
    found
}
