//! The nodes of a document that show meshes, in the order of a tree.

use serde_json::Value;
use striata_io::Scene;

/// A node, or a mesh of a document without nodes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::window) struct TreeRow {
    pub name: String,
    /// Number of nodes above it.
    pub depth: usize,
    /// Index of the row after its last descendant.
    pub end: usize,
    /// Instances that the node itself shows.
    pub instances: Vec<usize>,
}

/// Rows with each parent before its children; nodes below which nothing is shown are left out.
pub(super) fn tree_rows(scene: &Scene) -> Vec<TreeRow> {
    let nodes = scene.document().get("nodes").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let mut shown: Vec<Vec<usize>> = vec![Vec::new(); nodes.len()];
    let mut rows = Vec::new();
    for (index, instance) in scene.instances().iter().enumerate() {
        match instance.node.and_then(|node| shown.get_mut(node)) {
            Some(shown) => shown.push(index),
            None => {
                let name = mesh_label(scene, instance.mesh);
                let end = rows.len() + 1;
                rows.push(TreeRow { name, depth: 0, end, instances: vec![index] });
            }
        }
    }
    rows.extend(node_rows(scene, nodes, shown, rows.len()));
    rows
}

/// Rows of nodes, of which the first has the index `first`.
fn node_rows(scene: &Scene, nodes: &[Value], shown: Vec<Vec<usize>>, first: usize) -> Vec<TreeRow> {
    let parents = parents(nodes);
    let mut is_used = vec![false; nodes.len()];
    for node in (0..nodes.len()).filter(|&node| !shown[node].is_empty()) {
        let mut above = Some(node);
        // The scene has checked that shown nodes form a tree.
        while let Some(node) = above.filter(|&node| !std::mem::replace(&mut is_used[node], true)) {
            above = parents[node];
        }
    }
    let mut shown = shown;
    let mut rows: Vec<TreeRow> = Vec::new();
    let roots = (0..nodes.len()).filter(|&node| is_used[node] && parents[node].is_none()).rev();
    let mut waiting: Vec<(usize, usize)> = roots.map(|node| (node, 0)).collect();
    // Rows whose last descendant has not been reached.
    let mut open: Vec<usize> = Vec::new();
    while let Some((node, depth)) = waiting.pop() {
        for row in open.drain(depth.min(open.len())..) {
            rows[row].end = first + rows.len();
        }
        open.push(rows.len());
        let instances = std::mem::take(&mut shown[node]);
        rows.push(TreeRow { name: node_label(scene, nodes, node, &instances), depth, end: 0, instances });
        // Each node is listed once, even if several lists of children name it.
        let is_below =
            |&child: &usize| parents.get(child) == Some(&Some(node)) && std::mem::take(&mut is_used[child]);
        let below: Vec<usize> = children(&nodes[node]).filter(is_below).collect();
        waiting.extend(below.into_iter().rev().map(|child| (child, depth + 1)));
    }
    for row in open {
        rows[row].end = first + rows.len();
    }
    rows
}

fn parents(nodes: &[Value]) -> Vec<Option<usize>> {
    let mut parents = vec![None; nodes.len()];
    for (parent, node) in nodes.iter().enumerate() {
        for child in children(node) {
            if let Some(slot) = parents.get_mut(child) {
                *slot = Some(parent);
            }
        }
    }
    parents
}

fn children(node: &Value) -> impl Iterator<Item = usize> {
    let children = node.get("children").and_then(Value::as_array).into_iter().flatten();
    children.filter_map(|child| usize::try_from(child.as_u64()?).ok())
}

fn node_label(scene: &Scene, nodes: &[Value], node: usize, instances: &[usize]) -> String {
    let name = nodes[node].get("name").and_then(Value::as_str).unwrap_or_default();
    match instances.first() {
        _ if !name.is_empty() => printable(name),
        Some(&instance) => mesh_label(scene, scene.instances()[instance].mesh),
        None => format!("node {node}"),
    }
}

fn mesh_label(scene: &Scene, mesh: usize) -> String {
    match scene.mesh_name(mesh) {
        "" => format!("mesh {mesh}"),
        name => printable(name),
    }
}

/// Shortens a name to what fits into a line.
pub(super) fn printable(name: &str) -> String {
    const LENGTH: usize = 80;
    name.chars().filter(|c| !c.is_control()).take(LENGTH).collect()
}

#[cfg(test)]
mod tests {
    use striata_io::{Source, read_scene_bytes};
    use striata_testing::scenes;

    use super::*;

    #[test]
    fn every_instance_is_in_one_row_and_rows_contain_their_descendants() {
        for sample in scenes::all() {
            let scene = read_scene_bytes(&sample.to_glb(), &Source::new("test.glb")).expect("a scene");
            let rows = tree_rows(&scene);
            let mut instances: Vec<usize> = rows.iter().flat_map(|row| row.instances.clone()).collect();
            instances.sort_unstable();
            assert!(instances.into_iter().eq(0..scene.instances().len()), "{}", sample.name);
            for (at, row) in rows.iter().enumerate() {
                let below = rows[at + 1..].iter().take_while(|other| other.depth > row.depth).count();
                assert_eq!(row.end, at + 1 + below, "{}: row {at}", sample.name);
                assert!(rows[at..row.end].iter().any(|row| !row.instances.is_empty()), "nothing is shown");
            }
        }
    }
}
