//! Compressed documents contain the same.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::world::{assert_same, floats};
use super::{Elements, GltfParts, Sketch, add_mesh, everything, sheet, sheet_triangles};
use crate::gltf::accessor::accessor;
use crate::gltf::passes::parts::{entries, index, open};
use crate::report::Warnings;
use crate::{QuantizeOptions, WriteOptions};

fn applied(parts: &GltfParts, options: &WriteOptions) -> GltfParts {
    let mut out = parts.clone();
    out.apply(options, &mut Warnings::default()).unwrap();
    out
}

/// All attributes and morph targets of the corners of each triangle, in an order that does not depend on
/// how triangles and vertices are sorted.
fn corners(parts: &GltfParts, mesh: usize) -> Vec<Vec<Vec<u32>>> {
    let mut triangles = drawn(parts, mesh);
    triangles.sort();
    triangles
}

/// Attributes of the corners of each triangle like [`corners`], in the order in which they are drawn.
fn drawn(parts: &GltfParts, mesh: usize) -> Vec<Vec<Vec<u32>>> {
    let document = open(&parts.root, &parts.binary);
    let mut triangles = Vec::new();
    for primitive in entries(&parts.root["meshes"][mesh], "primitives") {
        let targets = entries(primitive, "targets").iter().flat_map(|target| target.as_object().unwrap());
        let named: BTreeMap<String, &Value> = primitive["attributes"]
            .as_object()
            .unwrap()
            .iter()
            .map(|(name, value)| (name.clone(), value))
            .chain(targets.map(|(name, value)| (format!("target {name}"), value)))
            .collect();
        let layers: Vec<(usize, Vec<f32>)> = named
            .values()
            .map(|value| {
                let index = index(value).unwrap();
                let source = accessor(&document, index, &document.root).ok().unwrap();
                (source.component_count, source.floats())
            })
            .collect();
        let corner = |vertex: u32| -> Vec<u32> {
            let of_layer = |(width, numbers): &(usize, Vec<f32>)| {
                let start = vertex as usize * width;
                numbers[start..start + width].iter().map(|x| x.to_bits()).collect::<Vec<u32>>()
            };
            layers.iter().flat_map(of_layer).collect()
        };
        let indices =
            accessor(&document, index(&primitive["indices"]).unwrap(), &document.root).ok().unwrap();
        for &[a, b, c] in indices.integers().unwrap().as_chunks::<3>().0 {
            let turns = [[a, b, c], [b, c, a], [c, a, b]].map(|turn| turn.map(corner).to_vec());
            triangles.extend(turns.into_iter().min());
        }
    }
    triangles
}

fn used(parts: &GltfParts) -> Vec<&str> {
    entries(&parts.root, "extensionsRequired").iter().filter_map(Value::as_str).collect()
}

#[cfg(feature = "meshopt")]
#[test]
fn meshoptimizer_keeps_everything() {
    let parts = everything();
    let out = applied(&parts, &WriteOptions::default().with_meshopt(true));
    assert!(out.binary.len() * 4 < parts.binary.len() * 3);
    assert_eq!(used(&out), ["EXT_meshopt_compression"]);
    for mesh in 0..4 {
        assert_eq!(corners(&out, mesh), corners(&parts, mesh));
    }
    let (before, after) = (open(&parts.root, &parts.binary), open(&out.root, &out.binary));
    for sampler in entries(&parts.root["animations"][0], "samplers") {
        for key in ["input", "output"] {
            let accessor = index(&sampler[key]).unwrap();
            assert_eq!(floats(&before, accessor), floats(&after, accessor));
        }
    }
    let buffers = entries(&out.root, "buffers");
    assert_eq!(buffers.len(), 2);
    assert_eq!(buffers[1]["extensions"]["EXT_meshopt_compression"]["fallback"], true);
    let declared: u64 = entries(&out.root, "bufferViews")
        .iter()
        .filter(|view| view["buffer"] == 1)
        .map(|view| view["byteLength"].as_u64().unwrap())
        .sum();
    assert!(declared <= buffers[1]["byteLength"].as_u64().unwrap());
}

#[cfg(feature = "meshopt")]
#[test]
fn quantized_documents_are_compressed_well() {
    let parts = everything();
    let options = WriteOptions::default().with_quantize(QuantizeOptions::default());
    let quantized = applied(&parts, &options);
    let out = applied(&parts, &options.with_meshopt(true));
    assert!(out.binary.len() * 3 < quantized.binary.len() * 2);
    // Positions are not sorted alike, so only their bounds are compared.
    let view =
        |accessor: &Value| out.root["bufferViews"][index(&accessor["bufferView"]).unwrap() as usize].clone();
    let attributes = &out.root["meshes"][0]["primitives"][0]["attributes"];
    let kind = |name: &str| {
        let accessor = &out.root["accessors"][index(&attributes[name]).unwrap() as usize];
        view(accessor)["extensions"]["EXT_meshopt_compression"].clone()
    };
    assert_eq!(kind("NORMAL")["filter"], "OCTAHEDRAL");
    assert_eq!(kind("POSITION").get("filter"), None);
    let document = open(&out.root, &out.binary);
    for direction in floats(&document, index(&attributes["NORMAL"]).unwrap()).chunks(3) {
        let length: f32 = direction.iter().map(|x| x * x).sum::<f32>().sqrt();
        assert!((length - 1.0).abs() < 0.02, "{length}");
    }
}

#[cfg(feature = "meshopt")]
#[test]
fn floats_that_are_multiples_are_stored_as_integers() {
    let mut sketch = Sketch::new();
    let position = sketch.vertices("POSITION", &Elements::floats(&sheet(0.0), 3));
    let texcoords: Vec<f32> = sheet(0.3)
        .chunks(3)
        .flat_map(|p| [p[0] * 7.0, -p[1]])
        .map(|x| (x * 4096.0).round() / 4096.0)
        .collect();
    let texcoord = sketch.vertices("TEXCOORD_", &Elements::floats(&texcoords, 2));
    let indices = sketch.indices(&sheet_triangles());
    let attributes = json!({ "POSITION": position, "TEXCOORD_0": texcoord });
    let mesh =
        sketch.add("meshes", json!({ "primitives": [{ "attributes": attributes, "indices": indices }] }));
    sketch.node(json!({ "mesh": mesh }));
    let parts = sketch.finish();
    let out = applied(&parts, &WriteOptions::default().with_meshopt(true));
    assert_eq!(corners(&out, 0), corners(&parts, 0));
    let filters = entries(&out.root, "bufferViews").iter();
    let filters = filters.filter_map(|view| view.pointer("/extensions/EXT_meshopt_compression/filter"));
    assert_eq!(filters.collect::<Vec<_>>(), ["EXPONENTIAL"]);
}

#[cfg(feature = "meshopt")]
#[test]
fn blended_triangles_keep_their_order() {
    let mut sketch = Sketch::new();
    let mesh = add_mesh(&mut sketch, 0.0);
    let mut triangles = sheet_triangles();
    triangles.reverse();
    let indices = sketch.indices(&triangles);
    sketch.add("materials", json!({ "alphaMode": "BLEND" }));
    let primitive = &mut sketch.parts.root["meshes"][0]["primitives"][0];
    primitive["indices"] = json!(indices);
    primitive["material"] = json!(0);
    sketch.node(json!({ "mesh": mesh }));
    let mut parts = sketch.finish();
    let options = WriteOptions::default().with_meshopt(true);
    assert_eq!(drawn(&applied(&parts, &options), 0), drawn(&parts, 0));
    parts.root["materials"][0]["alphaMode"] = json!("MASK");
    assert_ne!(drawn(&applied(&parts, &options), 0), drawn(&parts, 0));
}

#[cfg(feature = "meshopt")]
#[test]
fn vertices_with_other_users_keep_their_order() {
    let mut sketch = Sketch::new();
    let mesh = add_mesh(&mut sketch, 0.0);
    let mut triangles = sheet_triangles();
    triangles.reverse();
    sketch.parts.root["meshes"][0]["primitives"][0]["indices"] = json!(sketch.indices(&triangles));
    let position = sketch.parts.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"].clone();
    let points = json!({ "mode": 0, "attributes": { "POSITION": position } });
    sketch.parts.root["meshes"][0]["primitives"].as_array_mut().unwrap().push(points);
    sketch.node(json!({ "mesh": mesh }));
    let mut parts = sketch.finish();
    let out = applied(&parts, &WriteOptions::default().with_meshopt(true));
    assert_same(&out, &parts, 0.0);
    // Without the points, they are sorted.
    parts.root["meshes"][0]["primitives"].as_array_mut().unwrap().pop();
    let out = applied(&parts, &WriteOptions::default().with_meshopt(true));
    assert_eq!(corners(&out, 0), corners(&parts, 0));
    let order = |parts: &GltfParts| floats(&open(&parts.root, &parts.binary), position.as_u64().unwrap());
    assert_ne!(order(&out), order(&parts));
}

#[cfg(feature = "draco")]
#[test]
fn draco_keeps_triangles() {
    let parts = everything();
    let out = applied(&parts, &WriteOptions::default().with_draco(true));
    assert_eq!(used(&out), ["KHR_draco_mesh_compression"]);
    let extension = |mesh: usize| {
        let primitive = &out.root["meshes"][mesh]["primitives"][0];
        primitive.pointer("/extensions/KHR_draco_mesh_compression").is_some()
    };
    // The first two have morph targets.
    assert_eq!([0, 1, 2, 3].map(extension), [false, false, true, true]);
    for mesh in [2, 3] {
        assert_eq!(decoded(&out, mesh), decoded(&parts, mesh));
    }
}

#[cfg(feature = "draco")]
#[test]
fn draco_declares_what_it_decodes() {
    let parts = everything();
    let options = WriteOptions::default().with_draco(true).with_quantize(QuantizeOptions::default());
    let out = applied(&parts, &options);
    assert!(out.binary.len() < parts.binary.len());
    let mesh = crate::read_bytes(&glb(&out), &crate::Source::new("x.glb")).unwrap();
    // Nine nodes show a mesh, one of them twice.
    assert_eq!(mesh.triangle_count(), 10 * 128);
    for primitive in [2, 3].map(|mesh| &out.root["meshes"][mesh]["primitives"][0]) {
        let position = &out.root["accessors"][index(&primitive["attributes"]["POSITION"]).unwrap() as usize];
        assert_eq!((position["count"].as_u64(), position.get("bufferView")), (Some(81), None));
        let indices = &out.root["accessors"][index(&primitive["indices"]).unwrap() as usize];
        assert_eq!((indices["count"].as_u64(), indices["componentType"].as_u64()), (Some(384), Some(5123)));
    }
}

#[cfg(feature = "draco")]
#[test]
fn draco_drops_unused_vertices_and_unrolls_strips() {
    let mut sketch = Sketch::new();
    let position = sketch.vertices("POSITION", &Elements::floats(&sheet(0.0), 3));
    let row = |y: u32| (0..9).flat_map(move |x| [y * 9 + x, y * 9 + 9 + x]);
    // Rows of the upper half, joined by degenerate triangles; the lower half is unused.
    let strip: Vec<u32> = (0..4).flat_map(|y| row(y).chain([y * 9 + 17, y * 9 + 9])).collect();
    let (first, last) = (sketch.indices(&strip), sketch.indices(&sheet_triangles()[288..]));
    let attributes = json!({ "POSITION": position });
    let primitive =
        |mode: u32, indices: usize| json!({ "mode": mode, "attributes": attributes, "indices": indices });
    let mesh = sketch.add("meshes", json!({ "primitives": [primitive(5, first), primitive(4, last)] }));
    sketch.node(json!({ "mesh": mesh }));
    let options = WriteOptions::default().with_draco(true).with_quantize(QuantizeOptions::default());
    let out = applied(&sketch.finish(), &options);
    let primitives = entries(&out.root["meshes"][0], "primitives");
    assert!(primitives.iter().all(|primitive| primitive["mode"] == 4));
    let mesh = crate::read_bytes(&glb(&out), &crate::Source::new("x.glb")).unwrap();
    assert_eq!((mesh.vertex_count(), mesh.triangle_count()), (45 + 27, 64 + 32));
    let up = mesh.triangles.iter().map(|triangle| {
        let [a, b, c] = triangle.map(|v| mesh.positions[v as usize]);
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    });
    // The strip starts upside down, and so do all of its triangles.
    assert_eq!(up.filter(|&area| area < 0.0).count(), 64);
}

#[cfg(feature = "draco")]
fn glb(parts: &GltfParts) -> Vec<u8> {
    let json = parts.root.to_string().into_bytes();
    crate::gltf::container::joined(json, parts.binary.clone()).unwrap()
}

/// Attributes of the corners of a mesh without morph targets, as the reader returns them.
#[cfg(feature = "draco")]
fn decoded(parts: &GltfParts, mesh: usize) -> Vec<Vec<Vec<u32>>> {
    let mut parts = parts.clone();
    parts.root["nodes"] = json!([{ "mesh": mesh }]);
    parts.root["scenes"] = json!([{ "nodes": [0] }]);
    let mesh = crate::read_bytes(&glb(&parts), &crate::Source::new("x.glb")).unwrap();
    let corner = |vertex: u32| -> Vec<u32> {
        let vertex = vertex as usize;
        let mut layers: Vec<_> = mesh.layers.iter().collect();
        layers.sort_by_key(|layer| layer.semantic.to_string());
        let of_layer = |layer: &&striata::mesh::AttributeLayer| {
            (0..layer.component_count.into()).map(|c| layer.get(vertex, c).to_bits()).collect::<Vec<_>>()
        };
        let position = mesh.positions[vertex].map(f32::to_bits);
        position.into_iter().chain(layers.iter().flat_map(of_layer)).collect()
    };
    let turn = |&[a, b, c]: &[u32; 3]| {
        let turns = [[a, b, c], [b, c, a], [c, a, b]].map(|turn| turn.map(corner).to_vec());
        turns.into_iter().min().unwrap()
    };
    let mut triangles: Vec<_> = mesh.triangles.iter().map(turn).collect();
    triangles.sort();
    triangles
}

#[test]
fn only_one_compression_is_allowed() {
    let both = WriteOptions::default().with_draco(true).with_meshopt(true);
    assert!(everything().apply(&both, &mut Warnings::default()).is_err());
    let mut untouched = everything();
    untouched.apply(&WriteOptions::default(), &mut Warnings::default()).unwrap();
    assert_eq!(untouched, everything());
}
