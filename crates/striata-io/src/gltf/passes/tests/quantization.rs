//! Quantized documents show the same.

use serde_json::{Value, json};

use super::world::{assert_same, floats};
use super::{Elements, Sketch, add_mesh, everything, sheet, sheet_triangles};
use crate::QuantizeOptions;
use crate::gltf::accessor::accessor;
use crate::gltf::component_type::GltfComponentType;
use crate::gltf::passes::parts::{GltfParts, array_length, entries, index, open};
use crate::gltf::passes::{Texcoords, quantize};
use crate::report::Warnings;

fn quantized(parts: &GltfParts) -> GltfParts {
    let mut out = parts.clone();
    quantize(&mut out, &QuantizeOptions::default(), Texcoords::Integers, &mut Warnings::default());
    out
}

#[test]
fn every_node_shows_the_same_positions() {
    let parts = everything();
    // The sheets are about 5 units long, and the largest scale of a node is 3. Positions and displacements
    // are rounded.
    let step = 5.0 / 16383.0;
    assert_same(&quantized(&parts), &parts, 3.0 * 3f64.sqrt() * step);
    let coarse = QuantizeOptions::default().with_position_bits(6);
    let mut out = parts.clone();
    quantize(&mut out, &coarse, Texcoords::Integers, &mut Warnings::default());
    assert_same(&out, &parts, 3.0 * 3f64.sqrt() * 5.0 / 63.0);
    let position = index(&out.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"]).unwrap();
    assert_eq!(out.root["accessors"][position as usize]["componentType"], 5121);
}

#[test]
fn vertices_that_fall_on_others_are_named() {
    let mut warnings = Warnings::of_file("x.glb");
    quantize(&mut everything(), &QuantizeOptions::default(), Texcoords::Integers, &mut warnings);
    assert!(warnings.into_list().is_empty());
    // One far vertex makes the grid coarser than the sheet.
    let mut far = sheet(0.0);
    far[0] = 1e9;
    let mut sketch = Sketch::new();
    let position = sketch.vertices("POSITION", &Elements::floats(&far, 3));
    let indices = sketch.indices(&sheet_triangles());
    let primitive = json!({ "attributes": { "POSITION": position }, "indices": indices });
    let mesh = sketch.add("meshes", json!({ "primitives": [primitive] }));
    sketch.node(json!({ "mesh": mesh }));
    let mut warnings = Warnings::of_file("x.glb");
    quantize(&mut sketch.finish(), &QuantizeOptions::default(), Texcoords::Integers, &mut warnings);
    let found: Vec<String> = warnings.into_list().iter().map(ToString::to_string).collect();
    let expected = "vertices fall on others; more bits or no quantization keeps them apart";
    assert!(found.len() == 1 && found[0].contains(expected), "{found:?}");
}

#[test]
fn nodes_with_other_tasks_get_a_child() {
    let out = quantized(&everything()).root;
    let nodes = entries(&out, "nodes");
    // 0 and 1 are leaves, 2 has a child and a camera, 3 is animated, 5 is a joint.
    assert_eq!(nodes.len(), 13);
    for (node, child) in [(2, 10), (3, 11), (5, 12)] {
        assert!(nodes[node].get("mesh").is_none());
        let children = entries(&nodes[node], "children");
        assert_eq!(children.last(), Some(&json!(child)));
        assert!(nodes[child].get("mesh").is_some() && nodes[child].get("scale").is_some());
    }
    assert_eq!(nodes[3]["translation"], json!([5.0, 0.0, 0.0]));
    assert_eq!((&nodes[10]["weights"], nodes[2].get("weights")), (&json!([0.75]), None));
    let channels = entries(&out["animations"][0], "channels");
    assert_eq!(channels[0]["target"]["node"], 10);
    assert_eq!(channels[1]["target"]["node"], 3);
    let pointer = &channels[2]["target"]["extensions"]["KHR_animation_pointer"]["pointer"];
    assert_eq!(pointer, "/nodes/10/weights/0");
    assert!(nodes[0].get("children").is_none() && nodes[1].get("children").is_none());
}

#[test]
fn skins_are_copied_for_each_grid() {
    let out = quantized(&everything()).root;
    let skin = |node: usize| out["nodes"][node]["skin"].as_u64().unwrap() as usize;
    assert_eq!(array_length(&out, "skins"), 3);
    assert_ne!(skin(6), skin(7));
    assert_eq!(skin(8), 1, "a skin with one grid is not copied");
    assert!(entries(&out, "skins").iter().all(|skin| skin.get("inverseBindMatrices").is_some()));
}

#[test]
fn attributes_get_small_types() {
    let parts = quantized(&everything());
    let document = open(&parts.root, &parts.binary);
    let attributes = &parts.root["meshes"][0]["primitives"][0]["attributes"];
    let kind = |value: &Value| {
        let accessor = accessor(&document, index(value).unwrap(), &document.root).ok().unwrap();
        (accessor.component, accessor.normalized)
    };
    for (name, component, normalized) in [
        ("POSITION", GltfComponentType::U16, false),
        ("NORMAL", GltfComponentType::I8, true),
        ("TANGENT", GltfComponentType::I8, true),
        ("TEXCOORD_0", GltfComponentType::U16, true),
        ("COLOR_0", GltfComponentType::U8, true),
    ] {
        assert_eq!(kind(&attributes[name]), (component, normalized), "{name}");
    }
    let attributes = &parts.root["meshes"][2]["primitives"][0]["attributes"];
    assert_eq!(kind(&attributes["JOINTS_0"]), (GltfComponentType::U8, false));
    assert_eq!(kind(&attributes["WEIGHTS_0"]), (GltfComponentType::U8, true));
    assert_eq!(kind(&parts.root["meshes"][0]["primitives"][0]["indices"]), (GltfComponentType::U16, false));
    let position = &parts.root["accessors"][index(&attributes["POSITION"]).unwrap() as usize];
    let max: Vec<u64> = entries(position, "max").iter().map(|x| x.as_u64().unwrap()).collect();
    assert_eq!(max.iter().max(), Some(&16383));
    assert_eq!(position["min"], json!([0, 0, 0]));
    let extensions = entries(&parts.root, "extensionsRequired");
    assert_eq!(extensions, [json!("KHR_mesh_quantization")]);
}

#[test]
fn weights_add_up_exactly() {
    let parts = quantized(&everything());
    let document = open(&parts.root, &parts.binary);
    let weights = index(&parts.root["meshes"][2]["primitives"][0]["attributes"]["WEIGHTS_0"]).unwrap();
    let weights = floats(&document, weights);
    let (exact, _) = super::weights();
    for (i, four) in weights.chunks(4).enumerate() {
        assert_eq!(four.iter().map(|x| (x * 255.0).round() as u32).sum::<u32>(), 255);
        for (j, weight) in four.iter().enumerate() {
            let error = f64::from(*weight) - exact.number(4 * i + j);
            assert!(error.abs() <= 1.0 / 255.0, "{error}");
        }
    }
}

#[test]
fn errors_are_at_most_half_a_step() {
    let before = everything();
    let after = quantized(&before);
    let numbers = |parts: &GltfParts, name: &str| {
        let document = open(&parts.root, &parts.binary);
        floats(&document, index(&parts.root["meshes"][0]["primitives"][0]["attributes"][name]).unwrap())
    };
    for (name, step) in [("NORMAL", 127.0), ("TANGENT", 127.0), ("TEXCOORD_0", 4095.0), ("COLOR_0", 255.0)] {
        let (before, after) = (numbers(&before, name), numbers(&after, name));
        let error = before.iter().zip(&after).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        // 16-bit texture coordinates cannot represent multiples of 1/4095 exactly.
        assert!(error <= 0.5 / step + 1e-5 && error > 0.0, "{name}: {error}");
    }
}

/// A mesh whose texture coordinates repeat a texture.
#[test]
fn texture_coordinates_outside_the_texture_stay_floats() {
    let mut sketch = Sketch::new();
    let position = sketch.vertices("POSITION", &Elements::floats(&sheet(0.0), 3));
    let texcoords: Vec<f32> = sheet(0.3).chunks(3).flat_map(|p| [p[0] * 7.0, -p[1]]).collect();
    let texcoord = sketch.vertices("TEXCOORD", &Elements::floats(&texcoords, 2));
    let indices = sketch.indices(&sheet_triangles());
    let attributes = json!({ "POSITION": position, "TEXCOORD_0": texcoord });
    let mesh =
        sketch.add("meshes", json!({ "primitives": [{ "attributes": attributes, "indices": indices }] }));
    sketch.node(json!({ "mesh": mesh }));
    let parts = quantized(&sketch.finish());
    let document = open(&parts.root, &parts.binary);
    let found = index(&parts.root["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"]).unwrap();
    for (found, expected) in floats(&document, found).iter().zip(&texcoords) {
        assert!((found - expected).abs() <= 0.5 / 4096.0 && (found * 4096.0).fract() == 0.0);
    }
}

#[test]
fn meshes_that_share_vertices_share_a_grid() {
    let mut sketch = Sketch::new();
    let mesh = add_mesh(&mut sketch, 0.0);
    let mut other = sketch.parts.root["meshes"][mesh].clone();
    let half = sketch.indices(&sheet_triangles()[..30]);
    other["primitives"][0]["indices"] = json!(half);
    let lines =
        json!({ "mode": 1, "attributes": { "POSITION": other["primitives"][0]["attributes"]["POSITION"] } });
    other["primitives"].as_array_mut().unwrap().push(lines);
    let other = sketch.add("meshes", other);
    sketch.node(json!({ "mesh": mesh }));
    sketch.node(json!({ "mesh": other, "rotation": [1.0, 0.0, 0.0, 0.0] }));
    let parts = sketch.finish();
    let out = quantized(&parts);
    assert_same(&out, &parts, 5.0 / 16383.0);
    assert_eq!(array_length(&out.root, "accessors"), array_length(&parts.root, "accessors"));
    assert!(out.binary.len() * 2 < parts.binary.len());
}

#[test]
fn what_cannot_be_quantized_stays() {
    let unchanged = |change: &dyn Fn(&mut GltfParts)| {
        let mut sketch = Sketch::new();
        let mesh = add_mesh(&mut sketch, 0.0);
        sketch.node(json!({ "mesh": mesh }));
        let mut parts = sketch.finish();
        change(&mut parts);
        let out = quantized(&parts);
        let position = index(&out.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"]).unwrap();
        assert_eq!(out.root["accessors"][position as usize]["componentType"], 5126);
        assert_eq!(out.root["nodes"], parts.root["nodes"]);
    };
    unchanged(&|parts| parts.root["nodes"] = json!([]));
    unchanged(&|parts| parts.root["nodes"][0]["skin"] = json!(7));
    unchanged(&|parts| parts.binary[0..4].copy_from_slice(&f32::NAN.to_le_bytes()));
    unchanged(&|parts| parts.binary[0..4].copy_from_slice(&f32::INFINITY.to_le_bytes()));
    unchanged(&|parts| {
        parts.root["meshes"][0]["primitives"][0]["extensions"] =
            json!({ "X_points_of_interest": [1.0, 2.0] });
    });
    unchanged(&|parts| {
        parts.root["nodes"][0]["extensions"] = json!({ "EXT_mesh_gpu_instancing": { "attributes": {} } });
    });
}

#[test]
fn degenerate_boxes_are_quantized() {
    for points in [[3.0; 9], [1e30, -1e30, 0.0, 5.0, 5.0, 5.0, 0.0, 0.0, 0.0], [1e-40; 9]] {
        let mut sketch = Sketch::new();
        let position = sketch.vertices("POSITION", &Elements::floats(&points, 3));
        let mesh =
            sketch.add("meshes", json!({ "primitives": [{ "attributes": { "POSITION": position } }] }));
        sketch.node(json!({ "mesh": mesh }));
        let parts = sketch.finish();
        assert_same(&quantized(&parts), &parts, 2e30 / 16383.0);
    }
}

#[test]
fn sparse_targets_stay_sparse() {
    let mut sketch = Sketch::new();
    let mesh = add_mesh(&mut sketch, 0.0);
    let values = Elements::floats(&[0.5, 0.25, -0.125], 3);
    let place = Elements::integers([17], 1, GltfComponentType::U16);
    let [mut at, mut of] = [json!({}), json!({})];
    sketch.additions.store(super::ViewKind::of_others("a", &place), &place, &mut at);
    sketch.additions.store(super::ViewKind::of_others("b", &values), &values, &mut of);
    at["componentType"] = json!(5123);
    let accessor = json!({
        "componentType": 5126, "type": "VEC3", "count": super::VERTEX_COUNT,
        "sparse": { "count": 1, "indices": at, "values": of },
    });
    let target = sketch.additions.push_accessor(accessor);
    sketch.parts.root["meshes"][mesh]["primitives"][0]["targets"] = json!([{ "POSITION": target }]);
    sketch.node(json!({ "mesh": mesh }));
    let parts = sketch.finish();
    let out = quantized(&parts);
    assert_same(&out, &parts, 5.0 / 16383.0);
    let target = index(&out.root["meshes"][0]["primitives"][0]["targets"][0]["POSITION"]).unwrap();
    let accessor = &out.root["accessors"][target as usize];
    assert_eq!((accessor["sparse"]["count"].as_u64(), accessor.get("bufferView")), (Some(1), None));
}
