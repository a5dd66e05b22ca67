//! Compaction drops what is unused, and nothing else.

use std::collections::BTreeSet;

use serde_json::{Value, json};

use super::world::{assert_same, floats};
use super::{Elements, GltfParts, Sketch, add_mesh, everything};
use crate::QuantizeOptions;
use crate::gltf::passes::compact::compact;
use crate::gltf::passes::parts::{array_length, entries, open, push_entries};
use crate::gltf::passes::{Texcoords, quantize};
use crate::report::Warnings;

fn image_bytes(parts: &GltfParts) -> &[u8] {
    let view = parts.root["images"][0]["bufferView"].as_u64().unwrap() as usize;
    let view = &parts.root["bufferViews"][view];
    let [start, length] = ["byteOffset", "byteLength"].map(|key| view[key].as_u64().unwrap() as usize);
    &parts.binary[start..start + length]
}

#[test]
fn used_data_survive() {
    let parts = everything();
    let mut out = parts.clone();
    compact(&mut out, &BTreeSet::new());
    assert_same(&out, &parts, 0.0);
    assert_eq!(out, parts, "everything was in use");
    assert_eq!(image_bytes(&out), [137, 80, 78, 71, 13, 10, 26]);
}

#[test]
fn unused_data_are_dropped_and_the_rest_renumbered() {
    let parts = everything();
    let mut out = parts.clone();
    out.root["meshes"][0] = out.root["meshes"][1].clone();
    compact(&mut out, &BTreeSet::new());
    let unused = 7;
    let count = |parts: &GltfParts| array_length(&parts.root, "accessors");
    assert_eq!(count(&out), count(&parts) - unused);
    assert!(out.binary.len() < parts.binary.len() * 3 / 4);
    assert_eq!(out.root["buffers"][0]["byteLength"], out.binary.len());
    assert_eq!(image_bytes(&out), image_bytes(&parts));
    let document = open(&out.root, &out.binary);
    let times = out.root["animations"][0]["samplers"][0]["input"].as_u64().unwrap();
    assert_eq!(floats(&document, times), [0.0, 0.4, 1.0]);
}

#[test]
fn slots_stay_if_an_unknown_extension_may_refer_to_them() {
    let mut parts = everything();
    parts.root["extensionsUsed"].as_array_mut().unwrap().push(json!("X_charts"));
    parts.root["extensions"] = json!({ "X_charts": { "accessor": 5 } });
    // Something that only the extension knows about.
    let mut sketch = Sketch::new();
    sketch.others(&Elements::floats(&[1.0, 2.0], 1));
    let extra = sketch.finish();
    let accessor = array_length(&parts.root, "accessors");
    let mut view = parts.push_bytes(&extra.binary);
    view["byteLength"] = json!(8);
    let mut slot = extra.root["accessors"][0].clone();
    slot["bufferView"] = json!(array_length(&parts.root, "bufferViews"));
    push_entries(&mut parts.root, "bufferViews", vec![view]);
    push_entries(&mut parts.root, "accessors", vec![slot]);
    let before = parts.clone();
    quantize(&mut parts, &QuantizeOptions::default(), Texcoords::Integers, &mut Warnings::default());
    let slots = entries(&parts.root, "accessors");
    assert!(slots.len() > entries(&before.root, "accessors").len());
    assert_eq!((&slots[0]["count"], slots[0].get("bufferView")), (&json!(1), None));
    assert!(parts.binary.len() < before.binary.len() * 2 / 3, "the bytes of replaced accessors are dropped");
    let document = open(&parts.root, &parts.binary);
    assert_eq!(floats(&document, accessor as u64), [1.0, 2.0]);
    assert_same(&parts, &before, 3.0 * 3f64.sqrt() * 5.0 / 16383.0);
    // Nodes that the extension may refer to keep their transforms.
    assert_eq!(parts.root["nodes"][0]["translation"], before.root["nodes"][0]["translation"]);
}

#[test]
fn interleaved_views_are_cut_in_whole_steps() {
    let numbers: Vec<f32> = (0..60).map(|i| i as f32).collect();
    let binary: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
    let accessor = |offset: usize, count: usize, kind: &str| {
        let mut accessor = json!({ "bufferView": 0, "byteOffset": offset, "componentType": 5126 });
        accessor["count"] = json!(count);
        accessor["type"] = json!(kind);
        accessor
    };
    // Steps of 5 floats. Used are the positions of vertices 0, 1, 4 and 5, and texture coordinates of 8.
    let accessors = [
        accessor(0, 2, "VEC3"),
        accessor(12, 2, "VEC2"),
        accessor(80, 2, "VEC3"),
        accessor(120, 6, "VEC3"),
        accessor(172, 1, "VEC2"),
    ];
    let of = |position: usize| json!({ "primitives": [{ "attributes": { "POSITION": position } }] });
    let root = json!({
        "asset": { "version": "2.0" },
        "meshes": [of(0), { "primitives": [{ "attributes": { "POSITION": 2, "TEXCOORD_0": 4 } }] }],
        "accessors": accessors,
        "bufferViews": [{ "buffer": 0, "byteLength": binary.len(), "byteStride": 20 }],
        "buffers": [{ "byteLength": binary.len() }],
    });
    let mut parts = GltfParts { root, binary, ..GltfParts::default() };
    compact(&mut parts, &BTreeSet::new());
    let view: &Value = &parts.root["bufferViews"][0];
    assert_eq!((view["byteLength"].as_u64(), view["byteStride"].as_u64()), (Some(100), Some(20)));
    let document = open(&parts.root, &parts.binary);
    assert_eq!(array_length(&parts.root, "accessors"), 3);
    assert_eq!(floats(&document, 0), [0.0, 1.0, 2.0, 5.0, 6.0, 7.0]);
    assert_eq!(floats(&document, 1), [20.0, 21.0, 22.0, 25.0, 26.0, 27.0]);
    assert_eq!(floats(&document, 2), [43.0, 44.0]);
}

#[test]
fn overlapping_views_keep_sharing_bytes() {
    let mut sketch = Sketch::new();
    let mesh = add_mesh(&mut sketch, 0.0);
    sketch.node(json!({ "mesh": mesh }));
    let mut parts = sketch.finish();
    let position = parts.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"].as_u64().unwrap();
    let mut copy = parts.root["accessors"][position as usize].clone();
    let view = parts.root["bufferViews"][copy["bufferView"].as_u64().unwrap() as usize].clone();
    copy["bufferView"] = json!(array_length(&parts.root, "bufferViews"));
    let number = array_length(&parts.root, "accessors");
    push_entries(&mut parts.root, "bufferViews", vec![view]);
    push_entries(&mut parts.root, "accessors", vec![copy]);
    parts.root["meshes"][0]["primitives"][0]["attributes"]["_COPY"] = json!(number);
    let before = parts.clone();
    compact(&mut parts, &BTreeSet::new());
    assert_eq!(parts.binary.len(), before.binary.len());
    let document = open(&parts.root, &parts.binary);
    assert_eq!(floats(&document, number as u64), floats(&document, position));
}
