//! glTF: round trips, documents for every rule of the reader, and the crate `gltf` for comparison.

use crate::meshes::{group, read, refused, round_trip, sheet, soup, square, square_with_everything, written};
use serde_json::{Value, json};
use striata::mesh::{AttributeLayer, ColorSpace, Image, IndexedMesh, LayerData, Material, Semantic};
use striata_io::{Format, Source, WriteOptions, read_bytes, to_bytes};

/// Builds a glTF whose only buffer contains the parts one after another, each in a view of its own.
fn document(parts: &[&[u8]], mut root: Value) -> Vec<u8> {
    let (mut bytes, mut views) = (Vec::new(), Vec::new());
    for part in parts {
        views.push(json!({ "buffer": 0, "byteOffset": bytes.len(), "byteLength": part.len() }));
        bytes.extend_from_slice(part);
    }
    // Percent escapes instead of base64, so that the test shares no code with the writer.
    let escaped: String = bytes.iter().map(|b| format!("%{b:02x}")).collect();
    root["asset"] = json!({ "version": "2.0" });
    root["buffers"] = json!([{ "byteLength": bytes.len(), "uri": format!("data:;x=y,{escaped}") }]);
    if root.get("bufferViews").is_none() {
        root["bufferViews"] = json!(views);
    }
    root.to_string().into_bytes()
}

fn f32s(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|x| x.to_le_bytes()).collect()
}

fn square_bytes() -> Vec<u8> {
    f32s(square().positions.as_flattened())
}

/// Document with the square's positions as accessor 0, the indices as accessor 1, and one primitive.
fn indexed(indices: &[u8], mode: u32) -> Value {
    json!({
        "accessors": [
            { "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3" },
            { "bufferView": 1, "componentType": 5121, "count": indices.len(), "type": "SCALAR" },
        ],
        "meshes": [{ "name": "m", "primitives": [{ "attributes": { "POSITION": 0 }, "indices": 1, "mode": mode }] }],
    })
}

fn everything() -> IndexedMesh {
    let mut mesh = square_with_everything();
    mesh.groups = vec![group("a", Some(1), 0, 1), group("b", None, 1, 1)];
    let looks = &mut mesh.appearance;
    looks.color_space = ColorSpace::Linear;
    let gltf_json = json!({
        "name": "lacquer",
        "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 }, "roughnessFactor": 0.1 },
        "extensions": { "KHR_materials_clearcoat": { "clearcoatFactor": 1.0 } },
    });
    looks.materials = vec![
        Material { name: String::new(), gltf_json: "{}".to_owned() },
        Material { name: "lacquer".to_owned(), gltf_json: gltf_json.to_string() },
    ];
    looks.textures_json = vec![r#"{"sampler":0,"source":0}"#.to_owned()];
    looks.samplers_json = vec![r#"{"magFilter":9729,"wrapS":33071}"#.to_owned()];
    looks.extensions_used = vec!["KHR_materials_clearcoat".to_owned()];
    let (name, mime_type) = ("dot".to_owned(), "image/png".to_owned());
    looks.images = vec![
        Image { name, mime_type, bytes: b"\x89PNG and so on".to_vec(), ..Image::default() },
        Image { uri: "not%20there.jpg".to_owned(), ..Image::default() },
    ];
    mesh
}

#[test]
fn a_round_trip_changes_nothing() {
    let mut mesh = everything();
    mesh.layers.sort_by(|a, b| a.semantic.cmp(&b.semantic));
    assert_eq!(round_trip(Format::Glb, &mesh), mesh);
    assert_eq!(round_trip(Format::Gltf, &mesh), mesh);
    let root: Value = serde_json::from_slice(&written(Format::Gltf, &mesh)).unwrap();
    assert_eq!(root["extensionsUsed"], json!(["KHR_materials_clearcoat"]));
    assert_eq!(root["meshes"].as_array().unwrap().len(), 2);
}

#[test]
fn groups_share_their_vertices_when_read_again() {
    let mut mesh = sheet(300);
    let half = mesh.triangle_count() as u32 / 2;
    mesh.groups = vec![group("s", None, 0, half), group("s", None, half, half)];
    assert!(mesh.vertex_count() > 65_535, "the indices must need 32 bits");
    assert_eq!(round_trip(Format::Glb, &mesh), mesh);
    let empty = IndexedMesh::default();
    assert_eq!(round_trip(Format::Glb, &empty), empty);
}

#[test]
fn an_independent_reader_agrees() {
    let mesh = everything();
    let bytes = written(Format::Glb, &mesh);
    let gltf = gltf::Gltf::from_slice(&bytes).unwrap();
    let blob = gltf.blob.as_deref().unwrap();
    let mut triangles: Vec<u32> = Vec::new();
    for primitive in gltf.meshes().flat_map(|m| m.primitives()) {
        let reader = primitive.reader(|_| Some(blob));
        assert_eq!(reader.read_positions().unwrap().collect::<Vec<_>>(), mesh.positions);
        assert!(reader.read_normals().unwrap().all(|n| n == [0.0, 0.6, 0.8]));
        let texcoords: Vec<f32> = reader.read_tex_coords(0).unwrap().into_f32().flatten().collect();
        assert_eq!(mesh.layer(&Semantic::TexCoord(0)).unwrap().data, LayerData::F32(texcoords));
        let colors: Vec<u8> = reader.read_colors(0).unwrap().into_rgb_u8().flatten().collect();
        assert_eq!(mesh.layer(&Semantic::Color(0)).unwrap().data, LayerData::U8(colors));
        let joints: Vec<u16> = reader.read_joints(0).unwrap().into_u16().flatten().collect();
        assert_eq!(joints, (0..16).collect::<Vec<u16>>());
        assert_eq!(primitive.morph_targets().count(), 2);
        triangles.extend(reader.read_indices().unwrap().into_u32());
    }
    assert_eq!(triangles, mesh.triangles.as_flattened());
}

#[test]
fn fans_are_a_primitive_each_and_one_group() {
    let mut mesh = square();
    mesh.triangles = vec![[0, 1, 2], [0, 2, 3], [3, 2, 1]];
    mesh.groups = vec![group("a", None, 0, 2), group("b", None, 2, 1)];
    let fans = vec![vec![vec![0, 1, 2], vec![0, 2, 3]], vec![vec![3, 2, 1]]];
    for format in [Format::Glb, Format::Gltf] {
        let bytes = to_bytes(format, &mesh, &WriteOptions::default().with_fans(fans.clone())).unwrap();
        let found = read_bytes(&bytes, &Source::new("x.glb")).unwrap();
        assert_eq!(found.triangles, mesh.triangles);
        assert_eq!(found.groups, mesh.groups);
    }
    let text = to_bytes(Format::Gltf, &mesh, &WriteOptions::default().with_fans(fans)).unwrap();
    let root: Value = serde_json::from_slice(&text).unwrap();
    let primitives: Vec<&Value> =
        root["meshes"].as_array().unwrap().iter().flat_map(|m| m["primitives"].as_array().unwrap()).collect();
    assert_eq!(primitives.len(), 3);
    assert!(primitives.iter().all(|primitive| primitive["mode"] == 6));
    let long = vec![vec![vec![0, 1, 2, 3]], vec![vec![3, 2, 1]]];
    let bytes = to_bytes(Format::Glb, &mesh, &WriteOptions::default().with_fans(long)).unwrap();
    assert_eq!(read_bytes(&bytes, &Source::new("x.glb")).unwrap().triangles, mesh.triangles);
    for wrong in [vec![], vec![vec![vec![0, 1]], vec![]], vec![vec![vec![0, 1, 4]], vec![]]] {
        assert!(to_bytes(Format::Glb, &mesh, &WriteOptions::default().with_fans(wrong)).is_err());
    }
}

#[test]
fn strips_are_written_and_read_as_strips() {
    let mesh = square();
    // The second triangle of a strip has the opposite winding: 2 0 3 is read as 0 2 3.
    let options = WriteOptions::default().with_strips(vec![vec![1, 2, 0, 3]]);
    let bytes = to_bytes(Format::Gltf, &mesh, &options).unwrap();
    let root: Value = serde_json::from_slice(&bytes).unwrap();
    assert_eq!(root["meshes"][0]["primitives"][0]["mode"], 5);
    let back = read("x.gltf", &bytes).unwrap();
    assert_eq!(back.triangles, [[1, 2, 0], [0, 2, 3]]);
    let stitched = WriteOptions::default().with_strips(vec![vec![0, 1, 2, 2, 0, 0, 0, 2, 3]]);
    let back = read("x.glb", &to_bytes(Format::Glb, &mesh, &stitched).unwrap()).unwrap();
    assert_eq!(back.triangles, [[0, 1, 2], [0, 2, 3]]);
    for wrong in [vec![], vec![vec![0, 1, 9]], vec![vec![0, 1]], vec![vec![], vec![]]] {
        assert!(to_bytes(Format::Glb, &mesh, &WriteOptions::default().with_strips(wrong)).is_err());
    }
}

#[test]
fn groups_may_be_strips_triangles_or_nothing() {
    let mut mesh = square();
    mesh.triangles.push([0, 1, 3]);
    mesh.groups = vec![group("strip", None, 0, 2), group("nothing", None, 2, 0), group("plain", None, 2, 1)];
    let options = WriteOptions::default().with_strips(vec![vec![1, 2, 0, 3], vec![], vec![]]);
    let bytes = to_bytes(Format::Gltf, &mesh, &options).unwrap();
    let root: Value = serde_json::from_slice(&bytes).unwrap();
    let modes: Vec<_> =
        root["meshes"].as_array().unwrap().iter().map(|m| &m["primitives"][0]["mode"]).collect();
    assert_eq!(modes, [5, 4], "a group without triangles is no mesh");
    let back = read("x.gltf", &bytes).unwrap();
    assert_eq!(back.triangles, [[1, 2, 0], [0, 2, 3], [0, 1, 3]]);
}

#[test]
fn every_mode_that_draws_triangles() {
    type Case<'a> = (u32, &'a [u8], &'a [[u32; 3]]);
    let cases: [Case<'_>; 3] = [
        (4, &[0, 1, 2, 0, 2, 3], &[[0, 1, 2], [0, 2, 3]]),
        (5, &[1, 2, 0, 3], &[[1, 2, 0], [0, 2, 3]]),
        (6, &[0, 1, 2, 3], &[[0, 1, 2], [0, 2, 3]]),
    ];
    for (mode, indices, triangles) in cases {
        let mesh = read("x.gltf", &document(&[&square_bytes(), indices], indexed(indices, mode))).unwrap();
        assert_eq!(mesh.triangles, triangles, "mode {mode}");
    }
    for (mode, found) in [(0, "the file has 4 points and no triangles"), (3, "1 set of lines and no")] {
        let message = refused("x.gltf", &document(&[&square_bytes(), &[0, 1]], indexed(&[0, 1], mode)));
        assert!(message.contains(found), "{message}");
    }
    let mut bare = indexed(&[], 6);
    bare["meshes"][0]["primitives"][0].as_object_mut().unwrap().remove("indices");
    let mesh = read("x.gltf", &document(&[&square_bytes()], bare)).unwrap();
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]]);
    assert_eq!(mesh.groups, [group("m", None, 0, 2)]);
}

#[test]
fn nodes_translate_rotate_and_mirror() {
    let indices = [0, 1, 2, 0, 2, 3];
    let normals = f32s(&[0.0, 0.0, 1.0].repeat(4));
    let tangents = f32s(&[1.0, 0.0, 0.0, 1.0].repeat(4));
    let mut root = indexed(&indices, 4);
    let accessors = root["accessors"].as_array_mut().unwrap();
    accessors.push(json!({ "bufferView": 2, "componentType": 5126, "count": 4, "type": "VEC3" }));
    accessors.push(json!({ "bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC4" }));
    root["meshes"][0]["primitives"][0]["attributes"] = json!({ "POSITION": 0, "NORMAL": 2, "TANGENT": 3 });
    let half = std::f64::consts::FRAC_1_SQRT_2;
    root["nodes"] = json!([
        { "children": [1, 2], "translation": [10, 0, 0] },
        { "mesh": 0, "rotation": [half, 0, 0, half], "scale": [2, 2, 2] },
        { "mesh": 0, "scale": [-1, 1, 3] },
        { "mesh": 0, "translation": [99, 99, 99] },
    ]);
    root["scenes"] = json!([{ "nodes": [3] }, { "nodes": [0] }]);
    root["scene"] = json!(1);
    let mesh = read("x.gltf", &document(&[&square_bytes(), &indices, &normals, &tangents], root)).unwrap();
    assert_eq!(mesh.groups, [group("m", None, 0, 2), group("m", None, 2, 2)]);
    let near = |a: [f32; 3], b: [f32; 3]| a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-5);
    // A quarter turn about x maps y to z, and z to -y.
    assert!(near(mesh.positions[2], [12.0, -0.2, 2.0]), "{:?}", mesh.positions[2]);
    assert!(near(mesh.positions[6], [9.0, 1.0, 0.3]), "{:?}", mesh.positions[6]);
    assert_eq!(mesh.triangles[2..], [[4, 6, 5], [4, 7, 6]], "a mirrored triangle turns around");
    let at = |semantic: Semantic, vertex, n| {
        let layer = mesh.layer(&semantic).unwrap();
        (0..n).map(|c| layer.get(vertex, c)).collect::<Vec<f32>>()
    };
    assert!(near(at(Semantic::Normal, 0, 3).try_into().unwrap(), [0.0, -1.0, 0.0]));
    assert!(near(at(Semantic::Normal, 4, 3).try_into().unwrap(), [0.0, 0.0, 1.0]));
    assert_eq!(at(Semantic::Tangent, 4, 4), [-1.0, 0.0, 0.0, -1.0]);
    mesh.check().unwrap();
}

#[test]
fn nodes_that_form_no_tree_are_refused() {
    let indices = [0, 1, 2];
    for nodes in [
        json!([{ "children": [0] }]),
        json!([{ "children": [1] }, { "children": [0] }]),
        json!([{ "children": [1, 1] }, { "mesh": 0 }]),
        json!([{ "children": [7] }]),
    ] {
        let mut root = indexed(&indices, 4);
        root["nodes"] = nodes;
        root["scenes"] = json!([{ "nodes": [0] }]);
        let message = refused("x.gltf", &document(&[&square_bytes(), &indices], root));
        assert!(message.contains("tree") || message.contains("nodes[7] does not exist"), "{message}");
    }
}

#[test]
fn attribute_sets_are_merged() {
    let indices = [0, 1, 2, 0, 2, 3];
    let colors = [200u8; 12];
    let normals = f32s(&[1.0, 0.0, 0.0].repeat(4));
    let mut root = indexed(&indices, 4);
    let accessors = root["accessors"].as_array_mut().unwrap();
    accessors.push(
        json!({ "bufferView": 2, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC3" }),
    );
    accessors.push(json!({ "bufferView": 3, "componentType": 5126, "count": 4, "type": "VEC3" }));
    accessors.push(json!({ "componentType": 5123, "normalized": true, "count": 4, "type": "VEC4" }));
    root["meshes"][0]["primitives"] = json!([
        { "attributes": { "POSITION": 0, "COLOR_0": 2 }, "indices": 1 },
        { "attributes": { "POSITION": 0, "NORMAL": 3, "_SPEED": 1 }, "indices": 1 },
        { "attributes": { "POSITION": 0, "COLOR_0": 4 }, "indices": 1 },
    ]);
    let six = document(&[&square_bytes(), &indices, &colors, &normals], root.clone());
    assert!(refused("x.gltf", &six).contains("accessors[1]: 6 elements for 4 vertices"));
    root["meshes"][0]["primitives"][1]["attributes"].as_object_mut().unwrap().remove("_SPEED");
    let mesh = read("x.gltf", &document(&[&square_bytes(), &indices, &colors, &normals], root)).unwrap();
    assert_eq!(mesh.vertex_count(), 12);
    let color = mesh.layer(&Semantic::Color(0)).unwrap();
    assert_eq!(color.component_count, 4);
    assert_eq!(
        [color.get(0, 0), color.get(0, 3), color.get(4, 0), color.get(8, 3)],
        [200.0 / 255.0, 1.0, 1.0, 0.0]
    );
    let normal = mesh.layer(&Semantic::Normal).unwrap();
    assert_eq!(normal.get(4, 0), 1.0);
    assert!(normal.get(0, 2) > 0.9, "computed where it is missing");
    mesh.check().unwrap();
}

#[test]
fn sparse_and_quantized_accessors() {
    let indices = [0, 1, 2, 0, 2, 3];
    let shorts: Vec<u8> = [0i16, 0, 0, 0, 32767, 0, 0, 0, 32767, -32768, 0, 0, 0, 100, 0, 0]
        .iter()
        .flat_map(|x| x.to_le_bytes())
        .collect();
    let replaced = f32s(&[5.0, 6.0, 7.0]);
    let mut root = indexed(&indices, 4);
    root["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    root["accessors"] = json!([
        { "bufferView": 0, "componentType": 5122, "normalized": true, "count": 4, "type": "VEC3" },
        { "bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR" },
        { "componentType": 5126, "count": 4, "type": "VEC3", "sparse": {
            "count": 1,
            "indices": { "bufferView": 2, "componentType": 5121 },
            "values": { "bufferView": 3 } } },
    ]);
    root["bufferViews"] = json!([
        { "buffer": 0, "byteOffset": 0, "byteLength": 32, "byteStride": 8 },
        { "buffer": 0, "byteOffset": 32, "byteLength": 6 },
        { "buffer": 0, "byteOffset": 38, "byteLength": 1 },
        { "buffer": 0, "byteOffset": 39, "byteLength": 12 },
    ]);
    root["meshes"][0]["primitives"][0]["targets"] = json!([{ "POSITION": 2 }]);
    let mesh = read("x.gltf", &document(&[&shorts, &indices, &[3], &replaced], root.clone())).unwrap();
    assert_eq!(mesh.positions, [[0.0; 3], [1.0, 0.0, 0.0], [1.0, -1.0, 0.0], [0.0, 100.0 / 32767.0, 0.0]]);
    let morph = mesh.layer(&Semantic::MorphPosition(0)).unwrap();
    let expected = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.0, 6.0, 7.0];
    assert_eq!(morph.data, LayerData::F32(expected.to_vec()));
    let bad = document(&[&shorts, &indices, &[4], &replaced], root);
    assert!(refused("x.gltf", &bad).contains("element 4 of 4 does not exist"));
}

#[test]
fn instances_are_baked_up_to_a_limit() {
    let indices = [0, 1, 2];
    let mut root = indexed(&indices, 4);
    let nodes: Vec<Value> = (0..100).map(|i| json!({ "mesh": 0, "translation": [i, 0, 0] })).collect();
    root["nodes"] = json!(nodes);
    let mesh = read("x.gltf", &document(&[&square_bytes(), &indices], root.clone())).unwrap();
    assert_eq!((mesh.vertex_count(), mesh.triangle_count()), (400, 100));
    // Again, but each node shows a mesh with a huge number of primitives.
    let primitive = root["meshes"][0]["primitives"][0].clone();
    root["meshes"][0]["primitives"] = json!(vec![primitive; 20_000]);
    let message = refused("x.gltf", &document(&[&square_bytes(), &indices], root));
    assert!(message.contains("more than 1048576 primitives"), "{message}");
}

#[test]
fn unsupported_features_are_reported() {
    let indices = [0, 1, 2];
    let parts: [&[u8]; 2] = [&square_bytes(), &indices];
    let changed = |change: fn(&mut Value)| {
        let mut root = indexed(&indices, 4);
        change(&mut root);
        refused("x.gltf", &document(&parts, root))
    };
    type Case = (fn(&mut Value), &'static str);
    let cases: [Case; 12] = [
        (|r| r["extensionsRequired"] = json!(["VENDOR_shapes"]), "VENDOR_shapes"),
        (|r| r["extensionsRequired"] = json!(["MPEG_mesh_linking"]), "MPEG_mesh_linking"),
        (|r| r["accessors"][0]["count"] = json!(5), "accessors[0]: 5 elements from byte 0 on take 60 bytes"),
        (|r| r["accessors"][0]["count"] = json!(4_000_000_000u32), "more than can be handled"),
        (|r| r["accessors"][0]["count"] = json!(-1), "accessors[0].count: expected a whole number, found -1"),
        (|r| r["accessors"][0]["byteOffset"] = json!(u64::MAX), "elements from byte"),
        (|r| r["accessors"][0]["bufferView"] = json!(9), "bufferViews[9] does not exist: there are 2"),
        (|r| r["accessors"][0]["type"] = json!("VEC9"), "no accessor type is called `VEC9`"),
        (|r| r["accessors"][1]["componentType"] = json!(5126), "accessors[1]"),
        (|r| r["meshes"][0]["primitives"][0]["material"] = json!(0), "materials[0] does not exist"),
        (|r| r["meshes"][0]["primitives"][0]["attributes"] = json!({}), "POSITION is missing"),
        (
            |r| r["accessors"][0] = json!({"componentType":5126,"type":"VEC3","count":900_000_000}),
            "zeros in a file",
        ),
    ];
    for (change, expected) in cases {
        let message = changed(change);
        assert!(message.contains(expected), "expected {expected}, found {message}");
    }
    let out_of_range = [0, 1, 4];
    let bytes = document(&[&square_bytes(), &out_of_range], indexed(&out_of_range, 4));
    assert!(refused("x.gltf", &bytes).contains("index 2 is vertex 4, but there are 4"));
    assert!(refused("x.gltf", b"{ \"asset\": }").contains("line 1: the JSON is not well-formed"));
    assert!(refused("x.gltf", br#"{"asset":{"version":"1.0"}}"#).contains("glTF version `1.0`"));
}

#[test]
fn invalid_gltf_is_not_written() {
    let refusal =
        |mesh: &IndexedMesh| to_bytes(Format::Glb, mesh, &WriteOptions::default()).unwrap_err().to_string();
    let mut nan = square();
    nan.positions[1][2] = f32::NAN;
    assert!(refusal(&nan).contains("vertex 1 has the value NaN in POSITION"));
    let mut broken = square();
    broken.triangles[1][0] = 17;
    assert!(refusal(&broken).contains("triangle 1 uses vertex 17"));
}

#[test]
fn integers_keep_their_type_or_are_left_out() {
    let mut mesh = square();
    let layer = |name: &str, data| AttributeLayer {
        semantic: Semantic::Generic(name.to_owned()),
        component_count: 1,
        normalized: false,
        data,
    };
    let kept = vec![
        layer("char", LayerData::I8(vec![-128, 0, 1, 127])),
        layer("short", LayerData::I16(vec![-32768, 0, 1, 32767])),
    ];
    mesh.layers = kept.clone();
    mesh.layers.push(layer("small", LayerData::I32(vec![-5, 0, 1, 1 << 24])));
    mesh.layers.push(layer("id", LayerData::U32(vec![0, 1, 2, u32::MAX])));
    let back = round_trip(Format::Glb, &mesh);
    assert_eq!(back.layers[..2], kept);
    assert_eq!(back.layers[2].data, LayerData::F32(vec![-5.0, 0.0, 1.0, 16_777_216.0]));
    assert_eq!(back.layers.len(), 3, "no float represents all values of the last layer");
}

#[test]
fn files_beside_the_document_are_found() {
    let folder = tempfile::tempdir().unwrap();
    let mut root: Value = serde_json::from_slice(&written(Format::Gltf, &square())).unwrap();
    let glb = written(Format::Glb, &square());
    let json_bytes = u32::from_le_bytes(*glb[12..].first_chunk().unwrap()) as usize;
    std::fs::write(folder.path().join("a b.bin"), &glb[20 + json_bytes + 8..]).unwrap();
    std::fs::write(folder.path().join("image.png"), b"\x89PNG...").unwrap();
    root["buffers"][0]["uri"] = json!("a%20b.bin");
    root["images"] = json!([{ "uri": "image.png" }, { "uri": "lost.png" }, { "uri": "../image.png" }]);
    let path = folder.path().join("scene.gltf");
    std::fs::write(&path, root.to_string()).unwrap();
    let mesh = striata_io::read(&path).unwrap();
    assert_eq!(soup(&mesh), soup(&square()));
    let images = &mesh.appearance.images;
    assert_eq!((images[0].bytes.as_slice(), images[0].mime_type.as_str()), (&b"\x89PNG..."[..], "image/png"));
    assert_eq!((images[1].bytes.len(), images[1].uri.as_str()), (0, "lost.png"));
    assert!(images[2].bytes.is_empty());
    for (uri, reason) in [("../a b.bin", "leaves the folder"), ("lost.bin", "`lost.bin`")] {
        root["buffers"][0]["uri"] = json!(uri);
        let source = Source::new("scene.gltf").with_folder(folder.path());
        let error = read_bytes(root.to_string().as_bytes(), &source).unwrap_err().to_string();
        assert!(error.contains("buffers[0]") && error.contains(reason), "{error}");
    }
}
