//! How the scene converts grid steps back to lengths.
//!
//! The place of the conversion depends on the node:
//!
//! - A skinned mesh: into the inverse bind matrices, because the node's transform is ignored (`skins`).
//! - Instances (`EXT_mesh_gpu_instancing`): into the transforms of the instances, because they apply after
//!   the conversion and before the node's transform.
//! - A leaf node that does nothing else, and that nothing animates: into the node's own transform.
//! - Any other node: a new child shows the mesh, and takes over the weights of morph targets.

use std::collections::{BTreeMap, BTreeSet};

use glam::{DQuat, DVec3};
use serde_json::{Value, json};

use super::changes::DocumentChanges;
use super::grid::{Grids, MeshGrid};
use super::{skins, transforms};
use crate::gltf::accessor::accessor;
use crate::gltf::document::GltfDocument;
use crate::gltf::extensions::are_all_known;
use crate::gltf::passes::additions::ViewKind;
use crate::gltf::passes::elements::Elements;
use crate::gltf::passes::parts::{array_length, entries, entries_mut, index, index_at, push_entries};

const INSTANCING: &str = "/extensions/EXT_mesh_gpu_instancing/attributes";

/// How a node converts the positions of its mesh.
enum Conversion {
    Skin(usize),
    /// Translations and scales of instances.
    Instances(Elements, Elements),
    Node,
}

/// Node that shows a quantized mesh.
pub(super) struct ShownNode {
    node: usize,
    grid: usize,
    conversion: Conversion,
}

/// Finds out how each node converts positions; drops the grids of meshes that cannot be shown.
pub(super) fn placements(document: &GltfDocument<'_>, grids: &mut Grids) -> Vec<ShownNode> {
    let root = document.root.value;
    let mut placements = Vec::new();
    let mut are_shown = vec![false; grids.of_mesh.len()];
    for (node, value) in entries(root, "nodes").iter().enumerate() {
        let Some(mesh) = index_at(value, "mesh").filter(|&mesh| mesh < are_shown.len()) else { continue };
        are_shown[mesh] = true;
        let number = grids.of_mesh[mesh];
        let Some(grid) = grids.grids[number] else { continue };
        match conversion(document, value, &grid) {
            Some(conversion) => placements.push(ShownNode { node, grid: number, conversion }),
            None => grids.drop_grid(number),
        }
    }
    // An extension may show a mesh that no node shows.
    for (mesh, _) in are_shown.iter().enumerate().filter(|&(_, is_shown)| !is_shown) {
        grids.drop_grid(grids.of_mesh[mesh]);
    }
    placements.retain(|placement| grids.grids[placement.grid].is_some());
    placements
}

fn conversion(document: &GltfDocument<'_>, node: &Value, grid: &MeshGrid) -> Option<Conversion> {
    let instances = node.pointer("/extensions/EXT_mesh_gpu_instancing");
    match (node.get("skin"), instances) {
        (None, None) => Some(Conversion::Node),
        (Some(skin), None) => {
            let skin = usize::try_from(index(skin)?).ok()?;
            skins::matrices(document, skin, grid).map(|_| Conversion::Skin(skin))
        }
        (None, Some(_)) => instances_in(document, node, grid)
            .map(|[translations, scales]| Conversion::Instances(translations, scales)),
        (Some(_), Some(_)) => None,
    }
}

/// Returns the translations and scales of instances, with the conversion applied first.
fn instances_in(document: &GltfDocument<'_>, node: &Value, grid: &MeshGrid) -> Option<[Elements; 2]> {
    let attributes = node.pointer(INSTANCING)?;
    let read = |name: &str, width: usize| -> Option<Option<Vec<f32>>> {
        let Some(value) = attributes.get(name) else { return Some(None) };
        let source = accessor(document, index(value)?, &document.root).ok()?;
        (source.component_count == width).then(|| Some(source.floats()))
    };
    let (moves, turns, scales) = (read("TRANSLATION", 3)?, read("ROTATION", 4)?, read("SCALE", 3)?);
    let counts = [(&moves, 3), (&turns, 4), (&scales, 3)];
    let mut counts = counts.iter().filter_map(|(list, width)| Some(list.as_ref()?.len() / width));
    let count = counts.next()?;
    if count == 0 || counts.any(|other| other != count) {
        return None;
    }
    let vector = |list: &Option<Vec<f32>>, i: usize, default: DVec3| match list {
        Some(list) => DVec3::new(list[3 * i].into(), list[3 * i + 1].into(), list[3 * i + 2].into()),
        None => default,
    };
    let (mut new_moves, mut new_scales) = (Vec::new(), Vec::new());
    for i in 0..count {
        let turn = turns.as_ref().and_then(|list| list[4 * i..].first_chunk::<4>());
        // Rotations may be rounded to bytes.
        let turn = turn.map_or(DQuat::IDENTITY, |turn| DQuat::from_array(turn.map(f64::from)).normalize());
        let [translation, scale] =
            grid.folded(vector(&moves, i, DVec3::ZERO), turn, vector(&scales, i, DVec3::ONE));
        // Instances have no doubles: those that would move by more than the grid does stay as they are.
        let moved = (translation.as_vec3().as_dvec3() - translation).abs().max_element();
        if moved > 0.5 * scale.abs().min_element() {
            return None;
        }
        new_moves.extend(translation.as_vec3().to_array());
        new_scales.extend(scale.as_vec3().to_array());
    }
    let is_finite = new_moves.iter().chain(&new_scales).all(|x| x.is_finite());
    is_finite.then(|| [Elements::floats(&new_moves, 3), Elements::floats(&new_scales, 3)])
}

/// Changes the nodes, skins and instances of quantized meshes.
pub(super) fn apply(
    document: &GltfDocument<'_>,
    grids: &Grids,
    placements: Vec<ShownNode>,
    changes: &mut DocumentChanges<'_>,
) {
    let busy = busy_nodes(document.root.value);
    let mut uses = Vec::new();
    let mut heirs = BTreeMap::new();
    for ShownNode { node, grid: number, conversion } in placements {
        let Some(grid) = grids.grids[number] else { continue };
        match conversion {
            Conversion::Skin(skin) => uses.push(skins::SkinUse { node, skin, grid: number }),
            Conversion::Instances(translations, scales) => set_instances(changes, node, translations, scales),
            Conversion::Node => {
                let next = array_length(changes.root, "nodes");
                let Some(slot) = entries_mut(changes.root, "nodes").get_mut(node) else { continue };
                let is_folded = is_leaf(slot) && !busy.contains(&node) && transforms::fold(slot, &grid);
                if !is_folded {
                    let child = child_of(slot, next, &grid);
                    push_entries(changes.root, "nodes", vec![child]);
                    heirs.insert(node, next);
                }
            }
        }
    }
    skins::apply(document, grids, &uses, changes);
    redirect_weights(changes.root, &heirs);
}

/// Moves the mesh of a node to a new child, and returns that.
fn child_of(node: &mut Value, child: usize, grid: &MeshGrid) -> Value {
    let mut value = json!({});
    for key in ["mesh", "weights"] {
        if let Some(member) = node.as_object_mut().and_then(|node| node.remove(key)) {
            value[key] = member;
        }
    }
    transforms::set(&mut value, grid);
    match node.get_mut("children").and_then(Value::as_array_mut) {
        Some(children) => children.push(json!(child)),
        None => node["children"] = json!([child]),
    }
    value
}

/// Whether a node only shows a mesh.
fn is_leaf(node: &Value) -> bool {
    const HARMLESS: [&str; 8] =
        ["mesh", "name", "weights", "translation", "rotation", "scale", "matrix", "extras"];
    node.as_object().is_some_and(|node| node.keys().all(|key| HARMLESS.contains(&key.as_str())))
}

/// Returns nodes whose transforms something else uses; all nodes if that is unknown.
fn busy_nodes(root: &Value) -> BTreeSet<usize> {
    if !are_all_known(root) {
        return (0..array_length(root, "nodes")).collect();
    }
    let mut busy = BTreeSet::new();
    for skin in entries(root, "skins") {
        let joints = entries(skin, "joints").iter().filter_map(index);
        busy.extend(joints.filter_map(|joint| usize::try_from(joint).ok()));
        busy.extend(index_at(skin, "skeleton"));
    }
    for target in targets(root) {
        if target.get("path").and_then(Value::as_str) != Some("weights") {
            busy.extend(index_at(target, "node"));
        }
        busy.extend(pointer_of(target).and_then(node_in_pointer).map(|(node, _)| node));
    }
    busy
}

fn targets(root: &Value) -> impl Iterator<Item = &Value> {
    let channels = entries(root, "animations").iter().flat_map(|animation| entries(animation, "channels"));
    channels.filter_map(|channel| channel.get("target"))
}

fn pointer_of(target: &Value) -> Option<&str> {
    target.pointer("/extensions/KHR_animation_pointer/pointer")?.as_str()
}

/// Returns the node that an animated pointer refers to, and the rest of the pointer.
fn node_in_pointer(pointer: &str) -> Option<(usize, &str)> {
    let rest = pointer.strip_prefix("/nodes/")?;
    let end = rest.find('/').unwrap_or(rest.len());
    Some((rest[..end].parse().ok()?, &rest[end..]))
}

/// Makes animations of weights follow meshes to their new nodes.
fn redirect_weights(root: &mut Value, heirs: &BTreeMap<usize, usize>) {
    if heirs.is_empty() {
        return;
    }
    for animation in entries_mut(root, "animations") {
        for channel in entries_mut(animation, "channels") {
            let Some(target) = channel.get_mut("target") else { continue };
            if target.get("path").and_then(Value::as_str) == Some("weights") {
                let heir = index_at(target, "node").and_then(|node| heirs.get(&node));
                if let Some(&heir) = heir {
                    target["node"] = json!(heir);
                }
            }
            let moved = pointer_of(target).and_then(node_in_pointer).and_then(|(node, rest)| {
                let is_weights = rest == "/weights" || rest.starts_with("/weights/");
                Some(format!("/nodes/{}{rest}", heirs.get(&node).filter(|_| is_weights)?))
            });
            if let Some(moved) = moved {
                target["extensions"]["KHR_animation_pointer"]["pointer"] = json!(moved);
            }
        }
    }
}

fn set_instances(changes: &mut DocumentChanges<'_>, node: usize, translations: Elements, scales: Elements) {
    let Some(node) = entries_mut(changes.root, "nodes").get_mut(node) else { return };
    let Some(attributes) = node.pointer_mut(INSTANCING) else { return };
    for (name, elements) in [("TRANSLATION", translations), ("SCALE", scales)] {
        changes.replaced.extend(attributes.get(name).and_then(index));
        let kind = ViewKind::of_others("instances", &elements);
        attributes[name] = json!(changes.additions.push(kind, &elements, elements.accessor()));
    }
}
