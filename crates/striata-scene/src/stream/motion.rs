//! How far animations may move what is rounded: growth by animated scales, and the sizes of morph targets.

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;
use striata::mesh::{IndexedMesh, LayerData, Semantic};
use striata_io::Scene;

use super::accessors::numbers;
use crate::document::{entries, index};

/// Growth is limited to this factor, so that an animation cannot ask for exact positions.
const MAX_GROWTH: f64 = 64.0;

/// Factor by which animations enlarge each node, compared with the document's own scales.
fn node_growth(document: &Value, buffer: &[u8]) -> Vec<f64> {
    let nodes = entries(document, "nodes");
    let mut own = vec![1.0f64; nodes.len()];
    let largest = |numbers: &[f64]| numbers.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    // Many channels may share an accessor.
    let mut largest_of: BTreeMap<usize, Option<f64>> = BTreeMap::new();
    for animation in entries(document, "animations") {
        for channel in entries(animation, "channels") {
            let Some(target) = channel.get("target") else { continue };
            let is_scale = target.get("path").and_then(Value::as_str) == Some("scale");
            let Some(node) = index(target, "node").filter(|&node| is_scale && node < own.len()) else {
                continue;
            };
            let Some(accessor) = sampler_output(animation, channel) else { continue };
            let read = || Some(largest(&numbers(document, buffer, accessor)?));
            let Some(of_keys) = *largest_of.entry(accessor).or_insert_with(read) else { continue };
            let at_rest: Vec<f64> = entries(&nodes[node], "scale").iter().filter_map(Value::as_f64).collect();
            let at_rest = if at_rest.is_empty() { 1.0 } else { largest(&at_rest) };
            let growth = of_keys / at_rest;
            if growth.is_finite() {
                own[node] = own[node].max(growth);
            }
        }
    }
    with_ancestors(nodes, &own).into_iter().map(|growth| growth.min(MAX_GROWTH)).collect()
}

/// Bound of the factor by which the ancestors of each node enlarge its translation, in the pose of the
/// document.
pub(super) fn node_stretch(document: &Value) -> Vec<f64> {
    let nodes = entries(document, "nodes");
    let sum_of_squares =
        |numbers: &[Value]| numbers.iter().filter_map(Value::as_f64).map(|x| x * x).sum::<f64>();
    let own = nodes.iter().map(|node| match (entries(node, "matrix"), entries(node, "scale")) {
        // The norm of the linear part, which no length grows by more than.
        (matrix @ [_, ..], _) => sum_of_squares(matrix.get(..12).unwrap_or(matrix)).sqrt(),
        (_, scale) => scale.iter().filter_map(Value::as_f64).fold(0.0, |most, x| x.abs().max(most)),
    });
    let own: Vec<f64> = own.map(|stretch| if stretch > 0.0 { stretch } else { 1.0 }).collect();
    let whole = with_ancestors(nodes, &own);
    whole.iter().zip(&own).map(|(whole, own)| whole / own).collect()
}

/// Multiplies the number of each node by those of its ancestors.
fn with_ancestors(nodes: &[Value], own: &[f64]) -> Vec<f64> {
    let mut parent = vec![None; nodes.len()];
    for (node, value) in nodes.iter().enumerate() {
        for child in entries(value, "children").iter().filter_map(Value::as_u64) {
            if let Some(slot) = usize::try_from(child).ok().and_then(|child| parent.get_mut(child)) {
                *slot = Some(node);
            }
        }
    }
    if own.iter().all(|&growth| growth == 1.0) {
        return own.to_vec();
    }
    let mut found = vec![None; nodes.len()];
    for start in 0..nodes.len() {
        // Upward to a known node, then down again; a scene has checked that nodes form a tree.
        let mut path = vec![start];
        while let Some(next) = parent[path[path.len() - 1]].filter(|&next| found[next].is_none()) {
            if path.len() > nodes.len() {
                break;
            }
            path.push(next);
        }
        for &node in path.iter().rev() {
            let above: f64 = parent[node].and_then(|parent: usize| found[parent]).unwrap_or(1.0);
            found[node] = Some(above * own[node]);
        }
    }
    found.into_iter().map(|product| product.unwrap_or(1.0)).collect()
}

/// The accessor of the values of a channel.
fn sampler_output(animation: &Value, channel: &Value) -> Option<usize> {
    let sampler = entries(animation, "samplers").get(index(channel, "sampler")?)?;
    index(sampler, "output")
}

/// Largest factor from units of each mesh to units of the scene, animations included; [`None`] for meshes
/// that the scene does not show.
pub(super) fn mesh_scales(scene: &Scene) -> Vec<Option<f64>> {
    let document = scene.document();
    let growth = node_growth(document, scene.buffer());
    let of_node = |node: usize| growth.get(node).copied().unwrap_or(1.0);
    let of_skin = |skin: &Value| {
        let joints = entries(skin, "joints").iter().filter_map(Value::as_u64);
        joints.fold(1.0, |most, joint| of_node(joint as usize).max(most))
    };
    // Once for each skin, which many instances may share.
    let skins: Vec<f64> = entries(document, "skins").iter().map(of_skin).collect();
    let mut scales = vec![None; scene.meshes().len()];
    for instance in scene.instances() {
        let of_skin = instance.skin.and_then(|skin| skins.get(skin)).copied();
        let grown = of_skin.unwrap_or_else(|| instance.node.map_or(1.0, of_node));
        let scale = instance.scale * grown;
        let slot = &mut scales[instance.mesh];
        *slot = Some(slot.map_or(scale, |most: f64| most.max(scale)));
    }
    scales
}

/// Longest side of the box of each morph target's displacements.
pub(super) fn morph_extents(mesh: &IndexedMesh) -> Vec<f64> {
    let mut extents = Vec::new();
    for layer in &mesh.layers {
        let (Semantic::MorphPosition(target), LayerData::F32(numbers)) = (&layer.semantic, &layer.data)
        else {
            continue;
        };
        let components = usize::from(layer.component_count.max(1));
        let side = |axis: usize| {
            let axis = numbers.iter().skip(axis).step_by(components).filter(|x| x.is_finite());
            let (low, high) =
                axis.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), &x| (low.min(x), high.max(x)));
            (f64::from(high) - f64::from(low)).max(0.0)
        };
        let target = usize::from(*target);
        extents.resize(extents.len().max(target + 1), 0.0f64);
        extents[target] = (0..components).map(side).fold(0.0, f64::max);
    }
    extents
}

/// Largest sum over the targets of weight times extent, at any keyframe; at least that of each target alone.
pub(super) fn weighted_extent(scene: &Scene, mesh: usize, extents: &[f64]) -> f64 {
    let document = scene.document();
    let sum =
        |weights: &[f64]| extents.iter().zip(weights).map(|(extent, weight)| extent * weight.abs()).sum();
    let listed = |of: &Value| entries(of, "weights").iter().filter_map(Value::as_f64).collect::<Vec<f64>>();
    let mut most = extents.iter().copied().fold(0.0, f64::max);
    let mut consider = |weights: &[f64]| most = f64::max(most, sum(weights));
    entries(document, "meshes").get(mesh).map(listed).iter().for_each(|weights| consider(weights));
    let nodes = entries(document, "nodes");
    let shows = |node: &Value| index(node, "mesh") == Some(mesh);
    nodes.iter().filter(|node| shows(node)).for_each(|node| consider(&listed(node)));
    let mut outputs = BTreeSet::new();
    for animation in entries(document, "animations") {
        for channel in entries(animation, "channels") {
            let Some(target) = channel.get("target") else { continue };
            let node = index(target, "node").and_then(|node| nodes.get(node));
            let is_weights = target.get("path").and_then(Value::as_str) == Some("weights");
            if is_weights && node.is_some_and(shows) {
                outputs.extend(sampler_output(animation, channel));
            }
        }
    }
    for accessor in outputs {
        let keys = numbers(document, scene.buffer(), accessor).unwrap_or_default();
        keys.chunks_exact(extents.len().max(1)).for_each(&mut consider);
    }
    most
}
