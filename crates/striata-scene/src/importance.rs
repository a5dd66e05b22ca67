//! Importance of the objects of a scene, the third criterion of detail in \[BRR02\] 1, besides distance and speed.
//!
//! Nodes and meshes have it as the number `importance` of their `extras`, 1 if there is none. An error of an object of
//! importance 2 counts as if it were twice as large.

use serde_json::Value;
use striata_io::{Scene, SceneInstance};

use crate::document::entries;

/// Name of the importance among the extras of a node or of a mesh.
const KEY: &str = "importance";

/// The importance of each node and mesh of a scene.
#[derive(Clone, Debug)]
pub(crate) struct Importance {
    /// With that of all ancestors.
    nodes: Vec<f64>,
    meshes: Vec<f64>,
}

impl Importance {
    /// Reads the importance of everything in a scene. Values that are not positive numbers count as 1.
    pub(crate) fn of_scene(scene: &Scene) -> Self {
        let document = scene.document();
        let own = |key: &str| entries(document, key).iter().map(importance_of).collect::<Vec<f64>>();
        let (mut nodes, meshes) = (own("nodes"), own("meshes"));
        let children_of = |node: usize| {
            let children = entries(&entries(document, "nodes")[node], "children").iter();
            children.filter_map(|child| usize::try_from(child.as_u64()?).ok())
        };
        let count = nodes.len();
        let mut has_parent = vec![false; count];
        for child in (0..nodes.len()).flat_map(children_of) {
            if let Some(slot) = has_parent.get_mut(child) {
                *slot = true;
            }
        }
        // Ancestors come first; a node that is its own ancestor is never reached.
        let mut reached: Vec<usize> = (0..nodes.len()).filter(|&node| !has_parent[node]).collect();
        while let Some(node) = reached.pop() {
            for child in children_of(node).filter(|&child| child < count) {
                if std::mem::take(&mut has_parent[child]) {
                    nodes[child] = usable(nodes[child] * nodes[node]);
                    reached.push(child);
                }
            }
        }
        Self { nodes, meshes }
    }

    /// The importance of an instance: that of its mesh, times those of its node and all ancestors.
    pub(crate) fn of_instance(&self, instance: &SceneInstance) -> f64 {
        let of_node = instance.node.and_then(|node| self.nodes.get(node)).copied().unwrap_or(1.0);
        usable(of_node * self.meshes.get(instance.mesh).copied().unwrap_or(1.0))
    }
}

fn importance_of(entry: &Value) -> f64 {
    usable(entry.pointer(&format!("/extras/{KEY}")).and_then(Value::as_f64).unwrap_or(1.0))
}

/// Replaces what is not a positive number by 1.
pub(crate) fn usable(importance: f64) -> f64 {
    if importance > 0.0 && importance.is_finite() { importance } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use serde_json::json;
    use striata::mesh::shapes;
    use striata_io::SceneParts;

    use super::*;

    #[test]
    fn importance_is_inherited_and_bad_values_are_1() {
        let document = json!({
            "scene": 0,
            "scenes": [{ "nodes": [0, 3] }],
            "nodes": [
                { "children": [1, 2], "extras": { "importance": 2 } },
                { "mesh": 0, "extras": { "importance": 3 } },
                { "mesh": 0, "extras": { "importance": -3 } },
                { "mesh": 0 },
            ],
            "meshes": [{ "primitives": [{ "attributes": { "POSITION": null } }], "extras": { "importance": 0.5 } }],
        });
        let parts = SceneParts {
            document,
            buffer: Vec::new(),
            images: Vec::new(),
            meshes: vec![Some(shapes::tetrahedron())],
        };
        let scene = Scene::from_parts(parts).unwrap();
        let importance = Importance::of_scene(&scene);
        let found: Vec<f64> = scene.instances().iter().map(|i| importance.of_instance(i)).collect();
        assert_eq!(found, [3.0, 1.0, 0.5]);
    }
}
