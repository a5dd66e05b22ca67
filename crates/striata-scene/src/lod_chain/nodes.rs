//! Nodes of the levels: for each node that shows a mesh, one for each coarser level.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::{Map, Value, json};

use crate::document::{array, extension_slot};

/// A coarser level of a mesh in the file.
pub(super) struct ChainLevel {
    /// Entry of `meshes`; [`None`] if the level shows nothing.
    pub mesh: Option<usize>,
    /// Largest screen coverage at which it is shown.
    pub coverage: f64,
}

/// Name of the extension.
pub(super) const EXTENSION: &str = "MSFT_lod";

/// Extension that shows the mesh of its node several times.
const INSTANCING: &str = "EXT_mesh_gpu_instancing";

/// Members of a node that belong to its mesh.
const OF_MESH: [&str; 3] = ["mesh", "skin", "weights"];

/// Members of a node that place it.
const OF_TRANSFORM: [&str; 4] = ["matrix", "translation", "rotation", "scale"];

/// Name of a level: the levels of `name` are `name_LOD1`, `name_LOD2` and so on.
pub(super) fn level_name(name: &str, number: usize) -> String {
    format!("{name}_LOD{number}")
}

/// Adds a node for each mesh to a document without nodes, and a scene with the roots to one without scenes:
/// nodes of levels have no parent either, but must not be shown.
pub(super) fn show_bare_meshes(document: &mut Value) {
    let count = |key: &str| document.get(key).and_then(Value::as_array).map_or(0, Vec::len);
    let (mesh_count, scene_count) = (count("meshes"), count("scenes"));
    if mesh_count == 0 {
        return;
    }
    if count("nodes") == 0 {
        document["nodes"] = (0..mesh_count).map(|mesh| json!({ "mesh": mesh })).collect();
        if scene_count > 0 {
            let shown = document.get("scene").and_then(Value::as_u64).unwrap_or(0);
            if let Some(scene) = document.pointer_mut(&format!("/scenes/{shown}")) {
                scene["nodes"] = (0..mesh_count).collect();
            }
        }
    }
    if scene_count == 0 {
        document["scenes"] = json!([{ "nodes": roots(document) }]);
        document["scene"] = json!(0);
    }
}

/// Returns the nodes that have no parent.
fn roots(document: &Value) -> Vec<usize> {
    let nodes = document.get("nodes").and_then(Value::as_array).map_or(&[][..], Vec::as_slice);
    let children = nodes.iter().filter_map(|node| node.get("children")?.as_array()).flatten();
    let children: BTreeSet<u64> = children.filter_map(Value::as_u64).collect();
    (0..nodes.len()).filter(|&node| !children.contains(&(node as u64))).collect()
}

/// Adds chains to the nodes of a document.
pub(super) struct ChainNodes<'d> {
    document: &'d mut Value,
    chains: &'d [Vec<ChainLevel>],
    /// Nodes whose transforms are animated, and joints.
    moving: BTreeSet<u64>,
    /// Levels of chains that the document had before.
    lower: BTreeSet<u64>,
    /// For each node that had a mesh with animated weights, the nodes that show its levels now.
    shown_by: BTreeMap<u64, Vec<usize>>,
}

impl<'d> ChainNodes<'d> {
    pub(super) fn new(document: &'d mut Value, chains: &'d [Vec<ChainLevel>]) -> Self {
        let (moving, lower) = (moving_nodes(document), lower_nodes(document));
        Self { document, chains, moving, lower, shown_by: BTreeMap::new() }
    }

    /// Adds a chain to each node whose mesh has levels.
    pub(super) fn add_all(mut self) {
        let node_count = self.nodes().len();
        for node in (0..node_count).filter(|&node| !self.lower.contains(&(node as u64))).collect::<Vec<_>>() {
            let mesh = self.nodes()[node].get("mesh").and_then(Value::as_u64);
            let chain = mesh.and_then(|mesh| self.chains.get(usize::try_from(mesh).ok()?));
            if let Some(chain) = chain.filter(|chain| !chain.is_empty()) {
                self.add_chain(node, chain);
            }
        }
        self.animate_levels();
    }

    fn nodes(&mut self) -> &mut Vec<Value> {
        array(self.document, "nodes").expect("the nodes of a scene are an array")
    }

    fn push(&mut self, node: Map<String, Value>) -> usize {
        let nodes = self.nodes();
        nodes.push(Value::Object(node));
        nodes.len() - 1
    }

    fn add_chain(&mut self, node: usize, chain: &[ChainLevel]) {
        let shows = if self.must_stay(node) { self.move_mesh_to_child(node) } else { node };
        let Some(finest) = self.nodes()[shows].as_object().cloned() else { return };
        let mut shown_by = vec![shows];
        let mut ids = Vec::with_capacity(chain.len());
        for (index, level) in chain.iter().enumerate() {
            let id = self.push(level_node(&finest, level, index + 1));
            ids.push(id);
            if level.mesh.is_some() {
                shown_by.push(id);
            }
        }
        // The last level is shown down to any size.
        let coverages: Vec<f64> = chain.iter().map(|level| level.coverage).chain([0.0]).collect();
        let at = &mut self.nodes()[shows];
        if let Some(slot) = extension_slot(at, EXTENSION) {
            *slot = json!({ "ids": ids });
        }
        at["extras"]["MSFT_screencoverage"] = json!(coverages);
        self.shown_by.insert(node as u64, shown_by);
    }

    /// Whether a node does more than to show a mesh at a fixed place.
    fn must_stay(&mut self, node: usize) -> bool {
        let is_moving = self.moving.contains(&(node as u64));
        let node = &self.nodes()[node];
        let has_children = node.get("children").and_then(Value::as_array).is_some_and(|c| !c.is_empty());
        let extensions = node.get("extensions").and_then(Value::as_object).into_iter().flatten();
        let has_extensions = extensions.into_iter().any(|(name, _)| name != INSTANCING && name != EXTENSION);
        let has_other_extras = node.get("extras").is_some_and(|extras| !extras.is_object());
        is_moving || has_children || has_extensions || has_other_extras || node.get("camera").is_some()
    }

    /// Moves the mesh of a node to a new child, and returns that.
    fn move_mesh_to_child(&mut self, node: usize) -> usize {
        let mut child = Map::new();
        let parent = &mut self.nodes()[node];
        if let Some(parent) = parent.as_object_mut() {
            for key in OF_MESH {
                child.extend(parent.remove_entry(key));
            }
            if let Some(Value::Object(extensions)) = parent.get_mut("extensions") {
                let moved = Map::from_iter(extensions.remove_entry(INSTANCING));
                // A chain that the node had before is replaced.
                extensions.remove(EXTENSION);
                if extensions.is_empty() {
                    parent.remove("extensions");
                }
                if !moved.is_empty() {
                    child.insert("extensions".to_owned(), Value::Object(moved));
                }
            }
        }
        let child = self.push(child);
        if let Some(children) = array(&mut self.nodes()[node], "children") {
            children.push(json!(child));
        }
        child
    }

    /// Lets animations of weights drive all levels of a mesh.
    fn animate_levels(self) {
        let Self { document, shown_by, .. } = self;
        let animations = document.get_mut("animations").and_then(Value::as_array_mut).into_iter().flatten();
        for animation in animations {
            let Some(channels) = animation.get_mut("channels").and_then(Value::as_array_mut) else {
                continue;
            };
            let animated = channels.iter().flat_map(|channel| for_all_levels(channel, &shown_by)).collect();
            *channels = animated;
        }
    }
}

/// Returns the node of a level, which shows its mesh like the finest one.
fn level_node(finest: &Map<String, Value>, level: &ChainLevel, number: usize) -> Map<String, Value> {
    let copied = |key: &str| Some((key.to_owned(), finest.get(key)?.clone()));
    let mut node: Map<String, Value> = OF_TRANSFORM.into_iter().filter_map(copied).collect();
    if let Some(name) = finest.get("name").and_then(Value::as_str) {
        node.insert("name".to_owned(), json!(level_name(name, number)));
    }
    let Some(mesh) = level.mesh else { return node };
    node.extend(OF_MESH.into_iter().filter_map(copied));
    node.insert("mesh".to_owned(), json!(mesh));
    if let Some(instancing) = finest.get("extensions").and_then(|extensions| extensions.get(INSTANCING)) {
        node.insert("extensions".to_owned(), json!({ INSTANCING: instancing }));
    }
    node
}

/// Returns the node whose weights a channel animates, and the rest of its pointer, if it has one.
fn animated_weights(channel: &Value) -> Option<(u64, Option<String>)> {
    let target = channel.get("target")?;
    match target.get("path")?.as_str()? {
        "weights" => Some((target.get("node")?.as_u64()?, None)),
        "pointer" => {
            let (node, rest) = pointed_node(target)?;
            rest.starts_with("weights").then(|| (node, Some(rest.to_owned())))
        }
        _ => None,
    }
}

/// Returns the node that the pointer of a channel refers to, and the rest of the pointer.
fn pointed_node(target: &Value) -> Option<(u64, &str)> {
    let pointer = target.pointer("/extensions/KHR_animation_pointer/pointer")?.as_str()?;
    let (node, rest) = pointer.strip_prefix("/nodes/")?.split_once('/')?;
    Some((node.parse().ok()?, rest))
}

/// Repeats a channel that animates weights for each node that shows a level of the mesh.
fn for_all_levels(channel: &Value, shown_by: &BTreeMap<u64, Vec<usize>>) -> Vec<Value> {
    let found = animated_weights(channel).and_then(|(node, rest)| Some((shown_by.get(&node)?, rest)));
    let Some((nodes, rest)) = found else { return vec![channel.clone()] };
    let of_node = |&node: &usize| {
        let mut channel = channel.clone();
        match &rest {
            None => channel["target"]["node"] = json!(node),
            Some(rest) => {
                let pointer = json!(format!("/nodes/{node}/{rest}"));
                channel["target"]["extensions"]["KHR_animation_pointer"]["pointer"] = pointer;
            }
        }
        channel
    };
    nodes.iter().map(of_node).collect()
}

/// Nodes that a chain of the document already lists as levels of another node.
fn lower_nodes(document: &Value) -> BTreeSet<u64> {
    let nodes = document.get("nodes").and_then(Value::as_array).into_iter().flatten();
    let ids = nodes.filter_map(|node| node.pointer("/extensions/MSFT_lod/ids")?.as_array());
    ids.flatten().filter_map(Value::as_u64).collect()
}

/// Nodes whose transforms are animated, and joints of skins.
fn moving_nodes(document: &Value) -> BTreeSet<u64> {
    let list = |value: &'_ Value, key: &str| -> Vec<Value> {
        value.get(key).and_then(Value::as_array).cloned().unwrap_or_default()
    };
    let mut moving = BTreeSet::new();
    for channel in list(document, "animations").iter().flat_map(|animation| list(animation, "channels")) {
        if animated_weights(&channel).is_none()
            && let Some(target) = channel.get("target")
        {
            moving.extend(target.get("node").and_then(Value::as_u64));
            moving.extend(pointed_node(target).map(|(node, _)| node));
        }
    }
    for skin in list(document, "skins") {
        moving.extend(list(&skin, "joints").iter().filter_map(Value::as_u64));
        moving.extend(skin.get("skeleton").and_then(Value::as_u64));
    }
    moving
}
