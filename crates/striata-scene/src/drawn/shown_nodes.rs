//! Nodes that the default scene shows.

use serde_json::Value;

use crate::document::{entries, index};

/// Returns the nodes of the default scene with their JSON, by index; those of the first scene if no default
/// is named, and all nodes if the document has no scenes.
pub(super) fn shown_nodes(document: &Value) -> Vec<(usize, &Value)> {
    let nodes = entries(document, "nodes");
    let scene = entries(document, "scenes").get(index(document, "scene").unwrap_or(0));
    let Some(scene) = scene else { return nodes.iter().enumerate().collect() };
    let mut is_shown = vec![false; nodes.len()];
    let mut waiting: Vec<&Value> = entries(scene, "nodes").iter().collect();
    while let Some(node) = waiting.pop() {
        let Some(node) = node.as_u64().and_then(|node| usize::try_from(node).ok()) else { continue };
        if is_shown.get(node) == Some(&false) {
            is_shown[node] = true;
            waiting.extend(entries(&nodes[node], "children"));
        }
    }
    nodes.iter().enumerate().filter(|&(node, _)| is_shown[node]).collect()
}
