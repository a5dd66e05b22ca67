//! Positions of all vertices that a document shows, as a viewer computes them.

use std::collections::BTreeMap;

use glam::{DMat4, DQuat, DVec3};
use serde_json::Value;

use crate::gltf::accessor::accessor;
use crate::gltf::document::GltfDocument;
use crate::gltf::passes::parts::{GltfParts, entries, index, index_at, open};

/// Reads an accessor as floats.
pub(super) fn floats(document: &GltfDocument<'_>, index: u64) -> Vec<f32> {
    accessor(document, index, &document.root).unwrap_or_else(|_| panic!("accessor {index}")).floats()
}

fn numbers<const N: usize>(node: &Value, key: &str) -> Option<[f64; N]> {
    let list: Vec<f64> = node.get(key)?.as_array()?.iter().map(|x| x.as_f64().unwrap()).collect();
    list.try_into().ok()
}

fn local(node: &Value) -> DMat4 {
    if let Some(matrix) = numbers::<16>(node, "matrix") {
        return DMat4::from_cols_array(&matrix);
    }
    DMat4::from_scale_rotation_translation(
        DVec3::from_array(numbers(node, "scale").unwrap_or([1.0; 3])),
        DQuat::from_array(numbers(node, "rotation").unwrap_or([0.0, 0.0, 0.0, 1.0])),
        DVec3::from_array(numbers(node, "translation").unwrap_or([0.0; 3])),
    )
}

/// Transforms that a node applies to its mesh: one, or one for each instance; skins use their first joint.
fn transforms(document: &GltfDocument<'_>, node: &Value, world: DMat4) -> Vec<DMat4> {
    if let Some(skin) = index_at(node, "skin") {
        let skin = &entries(document.root.value, "skins")[skin];
        let matrices = skin.get("inverseBindMatrices").map(|value| floats(document, index(value).unwrap()));
        let matrix = matrices.map_or(DMat4::IDENTITY, |list| {
            DMat4::from_cols_array(&list[..16].first_chunk::<16>().unwrap().map(f64::from))
        });
        return vec![matrix];
    }
    let Some(attributes) = node.pointer("/extensions/EXT_mesh_gpu_instancing/attributes") else {
        return vec![world];
    };
    let list = |name: &str| Some(floats(document, index(attributes.get(name)?).unwrap()));
    let (moves, turns, scales) = (list("TRANSLATION").unwrap(), list("ROTATION").unwrap(), list("SCALE"));
    let vector = |list: &[f32], i: usize| DVec3::from_array([0, 1, 2].map(|c| f64::from(list[3 * i + c])));
    let instance = |i: usize| {
        let turn = DQuat::from_array([0, 1, 2, 3].map(|c| f64::from(turns[4 * i + c]))).normalize();
        let scale = scales.as_ref().map_or(DVec3::ONE, |scales| vector(scales, i));
        world * DMat4::from_scale_rotation_translation(scale, turn, vector(&moves, i))
    };
    (0..moves.len() / 3).map(instance).collect()
}

/// Returns the positions that each node of the original document shows, after their morph targets have been
/// applied with the weight 1; children that a pass has added belong to their parents.
pub(super) fn shown(parts: &GltfParts, node_count: usize) -> BTreeMap<usize, Vec<[f64; 3]>> {
    let document = open(&parts.root, &parts.binary);
    let nodes = entries(&parts.root, "nodes");
    let mut parents = vec![None; nodes.len()];
    for (number, node) in nodes.iter().enumerate() {
        for child in entries(node, "children") {
            parents[index(child).unwrap() as usize] = Some(number);
        }
    }
    let mut shown: BTreeMap<usize, Vec<[f64; 3]>> = BTreeMap::new();
    for (number, node) in nodes.iter().enumerate() {
        let Some(mesh) = index_at(node, "mesh") else { continue };
        let mut world = local(node);
        let mut at = number;
        while let Some(parent) = parents[at] {
            world = local(&nodes[parent]) * world;
            at = parent;
        }
        let owner = if number < node_count { number } else { parents[number].unwrap() };
        for transform in transforms(&document, node, world) {
            for primitive in entries(&entries(&parts.root, "meshes")[mesh], "primitives") {
                let positions = floats(&document, index(&primitive["attributes"]["POSITION"]).unwrap());
                let mut points: Vec<DVec3> =
                    positions.chunks(3).map(|p| DVec3::new(p[0].into(), p[1].into(), p[2].into())).collect();
                for target in entries(primitive, "targets") {
                    let moves = floats(&document, index(&target["POSITION"]).unwrap());
                    for (point, d) in points.iter_mut().zip(moves.chunks(3)) {
                        *point += DVec3::new(d[0].into(), d[1].into(), d[2].into());
                    }
                }
                let points = points.into_iter().map(|point| transform.transform_point3(point).to_array());
                shown.entry(owner).or_default().extend(points);
            }
        }
    }
    shown
}

/// Asserts that two documents show the same positions, up to `tolerance`.
pub(super) fn assert_same(found: &GltfParts, expected: &GltfParts, tolerance: f64) {
    let node_count = entries(&expected.root, "nodes").len();
    let (found, expected) = (shown(found, node_count), shown(expected, node_count));
    assert_eq!(found.keys().collect::<Vec<_>>(), expected.keys().collect::<Vec<_>>());
    for (node, points) in &expected {
        assert_eq!(found[node].len(), points.len(), "node {node}");
        for (a, b) in found[node].iter().zip(points) {
            let is_near = a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance);
            assert!(is_near, "node {node}: {a:?} is not {b:?}");
        }
    }
}
