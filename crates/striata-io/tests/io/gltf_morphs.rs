//! Morph targets in glTF: mostly zero displacements are written as sparse accessors and come back exactly.

use crate::meshes::{read, sheet};
use proptest::prelude::*;
use serde_json::Value;
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Random, Semantic};
use striata_io::{Format, QuantizeOptions, SceneWriter, Source, WriteOptions, read_scene_bytes, to_bytes};

/// Displacements of which `count` at random places are not zero.
fn displacements(vertex_count: usize, count: usize, random: &mut Random) -> Vec<f32> {
    let mut out = vec![0.0; 3 * vertex_count];
    let mut places: Vec<usize> = (0..vertex_count).collect();
    for i in 0..count {
        let other = i + random.below((vertex_count - i) as u32) as usize;
        places.swap(i, other);
        // One component is enough.
        out[3 * places[i] + random.below(3) as usize] = random.between(0.25, 1.0);
        out[3 * places[i]] -= random.between(0.0, 0.125);
    }
    out
}

fn with_targets(mut mesh: IndexedMesh, counts: &[usize], random: &mut Random) -> IndexedMesh {
    for (target, &count) in (0..).zip(counts) {
        let values = displacements(mesh.vertex_count(), count, random);
        mesh.layers.push(AttributeLayer::from_f32(Semantic::MorphPosition(target), 3, values));
        let values = displacements(mesh.vertex_count(), count, random);
        mesh.layers.push(AttributeLayer::from_f32(Semantic::MorphNormal(target), 3, values));
    }
    mesh.layers.sort_by(|a, b| a.semantic.cmp(&b.semantic));
    mesh
}

/// JSON and binary data of a GLB file.
fn parts(glb: &[u8]) -> (Value, &[u8]) {
    let word = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap()) as usize;
    let json = &glb[20..20 + word(12)];
    (serde_json::from_slice(json).unwrap(), &glb[20 + json.len() + 8..])
}

fn number(value: &Value, key: &str) -> usize {
    value.get(key).map_or(0, |number| number.as_u64().unwrap() as usize)
}

/// Bytes of a part of a view that is neither vertex data nor indices of triangles.
fn plain<'a>(json: &Value, binary: &'a [u8], at: &Value, [count, size, unit]: [usize; 3]) -> &'a [u8] {
    let view = &json["bufferViews"][number(at, "bufferView")];
    assert!(view.get("target").is_none() && view.get("byteStride").is_none(), "{view}");
    let (offset, end) = (number(at, "byteOffset"), number(at, "byteOffset") + count * size);
    assert!(end <= number(view, "byteLength"), "{at} in {view}");
    let start = number(view, "byteOffset") + offset;
    assert_eq!(start % unit, 0, "aligned");
    &binary[start..start + count * size]
}

/// How an accessor is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Sparse(usize),
    Dense,
}

/// Checks all accessors by the rules of the specification, and returns the kind of each target's attributes.
fn kinds(glb: &[u8]) -> Vec<[Kind; 2]> {
    let (json, binary) = parts(glb);
    let kind = |target: &Value, name: &str| {
        let accessor = &json["accessors"][number(target, name)];
        assert_eq!((accessor["type"].as_str(), number(accessor, "componentType")), (Some("VEC3"), 5126));
        assert_eq!(accessor.get("min").is_some(), name == "POSITION");
        let count = number(accessor, "count");
        let Some(sparse) = accessor.get("sparse") else {
            assert!(accessor.get("bufferView").is_some());
            return Kind::Dense;
        };
        assert!(accessor.get("bufferView").is_none());
        let size = if number(&sparse["indices"], "componentType") == 5123 { 2 } else { 4 };
        let used = number(sparse, "count");
        let indices = plain(&json, binary, &sparse["indices"], [used, size, size]);
        let indices: Vec<usize> = indices
            .chunks(size)
            .map(|bytes| bytes.iter().rev().fold(0, |sum, &byte| sum << 8 | usize::from(byte)))
            .collect();
        assert!(indices.is_sorted_by(|a, b| a < b) && indices.iter().all(|&i| i < count) && used > 0);
        let values = plain(&json, binary, &sparse["values"], [used, 12, 4]);
        // All-zero targets store one displacement, because some readers refuse accessors without data.
        assert!(used == 1 || values.chunks(12).all(|value| value.iter().any(|&byte| byte != 0)));
        Kind::Sparse(used)
    };
    let targets = json["meshes"][0]["primitives"][0]["targets"].as_array().unwrap();
    targets.iter().map(|target| ["POSITION", "NORMAL"].map(|name| kind(target, name))).collect()
}

fn glb(mesh: &IndexedMesh) -> Vec<u8> {
    to_bytes(Format::Glb, mesh, &WriteOptions::default()).unwrap()
}

/// Asserts that this crate and the crate `gltf` read the layers of a mesh.
fn assert_read(glb: &[u8], mesh: &IndexedMesh) {
    let found = read("x.glb", glb).unwrap();
    assert_eq!((&found.positions, &found.layers), (&mesh.positions, &mesh.layers));
    let document = gltf::Gltf::from_slice(glb).unwrap();
    let primitive = document.meshes().next().unwrap().primitives().next().unwrap();
    let reader = primitive.reader(|_| document.blob.as_deref());
    for (target, (positions, normals, _)) in (0..).zip(reader.read_morph_targets()) {
        for (semantic, found) in [
            (Semantic::MorphPosition(target), positions.unwrap().flatten().collect::<Vec<f32>>()),
            (Semantic::MorphNormal(target), normals.unwrap().flatten().collect()),
        ] {
            assert_eq!(LayerData::F32(found), mesh.layer(&semantic).unwrap().data, "{semantic}");
        }
    }
}

#[test]
fn displacements_are_sparse_if_that_is_smaller() {
    let mesh = sheet(20);
    let all = mesh.vertex_count();
    // 14 bytes for each displacement, and about 64 characters of JSON, instead of 12 bytes for each vertex.
    let most = (12 * all - 65) / 14;
    let counts = [0, 1, most, most + 1, all];
    let mesh = with_targets(mesh, &counts, &mut Random::new(1));
    let bytes = glb(&mesh);
    use Kind::{Dense, Sparse};
    let expected = [Sparse(1), Sparse(1), Sparse(most), Dense, Dense];
    assert_eq!(kinds(&bytes), expected.map(|kind| [kind; 2]));
    assert_read(&bytes, &mesh);
    let bytes = to_bytes(Format::Gltf, &mesh, &WriteOptions::default()).unwrap();
    assert_eq!(read("x.gltf", &bytes).unwrap().layers, mesh.layers);
}

#[test]
fn small_meshes_have_no_sparse_accessors() {
    let mesh = with_targets(sheet(1), &[0, 1, 4], &mut Random::new(2));
    let bytes = glb(&mesh);
    assert_eq!(kinds(&bytes), [[Kind::Dense; 2]; 3]);
    assert_read(&bytes, &mesh);
}

#[test]
fn negative_zeros_count_as_zeros() {
    let mut mesh = sheet(10);
    let zeros = vec![-0.0; 3 * mesh.vertex_count()];
    mesh.layers = vec![
        AttributeLayer::from_f32(Semantic::MorphPosition(0), 3, zeros.clone()),
        AttributeLayer::from_f32(Semantic::MorphNormal(0), 3, zeros),
    ];
    let bytes = glb(&mesh);
    assert_eq!(kinds(&bytes), [[Kind::Sparse(1); 2]]);
    assert_read(&bytes, &mesh);
}

#[test]
fn indices_beyond_16_bits_are_wide() {
    let mut mesh = sheet(260);
    let last = mesh.vertex_count() - 1;
    let mut values = vec![0.0; 3 * mesh.vertex_count()];
    values[3 * last + 1] = 2.5;
    values[4] = -1.5;
    for semantic in [Semantic::MorphPosition(0), Semantic::MorphNormal(0)] {
        mesh.layers.push(AttributeLayer::from_f32(semantic, 3, values.clone()));
    }
    let bytes = glb(&mesh);
    assert_eq!(kinds(&bytes), [[Kind::Sparse(2); 2]]);
    assert_read(&bytes, &mesh);
}

#[test]
fn many_local_targets_take_little_more_than_their_displacements() {
    let mesh = sheet(60);
    let plain = glb(&mesh).len();
    let counts = [mesh.vertex_count() / 100; 50];
    let mesh = with_targets(mesh, &counts, &mut Random::new(3));
    let size = glb(&mesh).len();
    let data = counts.iter().sum::<usize>() * 2 * 14;
    assert!(size < plain + data + 100 * 320, "{size} bytes for {plain} and {data}");
}

#[test]
fn sparse_targets_are_quantized_and_compressed() {
    let mesh = with_targets(sheet(40), &[0, 5, 80, 1600], &mut Random::new(4));
    let size = |options: &WriteOptions| to_bytes(Format::Glb, &mesh, options).unwrap().len();
    let quantized = WriteOptions::default().with_quantize(QuantizeOptions::default());
    let sizes = [
        WriteOptions::default(),
        quantized.clone(),
        WriteOptions::default().with_meshopt(true),
        quantized.with_meshopt(true),
        WriteOptions::default().with_draco(true),
    ]
    .map(|options| {
        let bytes = to_bytes(Format::Glb, &mesh, &options).unwrap();
        let found = read("x.glb", &bytes).unwrap();
        assert_eq!(found.layers.len(), mesh.layers.len());
        assert_near(&found, &mesh, if options.quantize.is_some() { 0.005 } else { 0.0 });
        size(&options)
    });
    assert!(sizes[1] < sizes[0] && sizes[2] < sizes[0] && sizes[3] < sizes[1], "{sizes:?}");
}

/// Compares what belongs to vertices at the same place, because compression reorders vertices.
fn assert_near(found: &IndexedMesh, expected: &IndexedMesh, tolerance: f32) {
    let rows = |mesh: &IndexedMesh| {
        let row = |v: usize| {
            let layers = mesh.layers.iter().flat_map(|layer| (0..3).map(move |c| layer.get(v, c)));
            (mesh.positions[v].map(|x| (x * 8.0).round() as i32), layers.collect::<Vec<f32>>())
        };
        let mut rows: Vec<_> = (0..mesh.vertex_count()).map(row).collect();
        rows.sort_by(|a, b| (a.0[1], a.0[0]).cmp(&(b.0[1], b.0[0])));
        rows
    };
    let (found, expected) = (rows(found), rows(expected));
    assert_eq!(found.len(), expected.len());
    for ((_, a), (_, b)) in found.iter().zip(&expected) {
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= tolerance), "{a:?} is not {b:?}");
    }
}

#[test]
fn targets_of_scenes_stay_sparse() {
    let mesh = with_targets(sheet(30), &[0, 3, 30, 961], &mut Random::new(5));
    let first = glb(&mesh);
    let scene = read_scene_bytes(&first, &Source::new("a.glb")).unwrap();
    let again = SceneWriter::new(&scene).to_bytes(Format::Glb, &WriteOptions::default()).unwrap();
    assert_eq!(kinds(&again), kinds(&first));
    assert_read(&again, &mesh);
    assert!(again.len() <= first.len() + 200, "{} became {} bytes", first.len(), again.len());
}

proptest! {
    #[test]
    fn random_targets_come_back_exactly(
        seed: u64,
        side in 1u32..24,
        shares in prop::collection::vec(0.0f64..=1.0, 1..6),
    ) {
        let mesh = sheet(side);
        let all = mesh.vertex_count() as f64;
        let counts: Vec<usize> = shares.iter().map(|share| (share * share * all) as usize).collect();
        let mesh = with_targets(mesh, &counts, &mut Random::new(seed));
        let bytes = glb(&mesh);
        for (kind, &count) in kinds(&bytes).iter().flatten().zip(counts.iter().flat_map(|count| [count; 2])) {
            let is_fit = match *kind {
                Kind::Sparse(used) => count.max(1) == used,
                Kind::Dense => 14 * count + 64 >= 12 * mesh.vertex_count(),
            };
            prop_assert!(is_fit, "{kind:?} for {count} of {all}");
        }
        assert_read(&bytes, &mesh);
    }
}

/// Displacements of texture coordinates, colors and custom attributes follow the vertices as well.
#[test]
fn targets_of_any_attribute_come_back() {
    let mut scene = striata_testing::scenes::empty();
    let mesh = sheet(8);
    let count = mesh.vertex_count();
    scene.push_mesh("sheet", &mesh);
    scene.document["nodes"] = serde_json::json!([{ "mesh": 0 }]);
    scene.document["scenes"] = serde_json::json!([{ "nodes": [0] }]);
    let mut push = |width: usize, of_vertex: &dyn Fn(usize) -> f32| {
        let numbers = (0..count * width).map(|i| of_vertex(i / width) + (i % width) as f32 / 4.0);
        let bytes: Vec<u8> = numbers.flat_map(f32::to_le_bytes).collect();
        let view = scene.push_view(&bytes);
        let kind = ["SCALAR", "VEC2", "VEC3", "VEC4"][width - 1];
        let accessor =
            serde_json::json!({ "bufferView": view, "componentType": 5126, "count": count, "type": kind });
        scene.push("accessors", accessor)
    };
    // Each value identifies its vertex, because levels and writers may renumber vertices.
    let vertex = |v: usize| v as f32;
    let base = serde_json::json!({
        "TEXCOORD_0": push(2, &vertex), "COLOR_0": push(4, &|_| 0.0), "_HEAT": push(1, &vertex),
    });
    let targets: Vec<Value> = (0..2)
        .map(|target| {
            let moved = |v: usize| 10.0 * v as f32 + target as f32;
            serde_json::json!({
                "TEXCOORD_0": push(2, &moved), "COLOR_0": push(4, &moved), "_HEAT": push(1, &moved),
            })
        })
        .collect();
    let primitive = &mut scene.document["meshes"][0]["primitives"][0];
    for (name, accessor) in base.as_object().unwrap() {
        primitive["attributes"][name] = accessor.clone();
    }
    primitive["targets"] = Value::Array(targets);
    let read = |glb: &[u8]| read_scene_bytes(glb, &Source::new("x.glb")).unwrap();
    let original = read(&scene.to_glb());
    let glb = SceneWriter::new(&original).to_bytes(Format::Glb, &WriteOptions::default()).unwrap();
    let (json, _) = parts(&glb);
    let written = json["meshes"][0]["primitives"][0]["targets"].as_array().unwrap();
    for target in written {
        let names: Vec<_> = target.as_object().unwrap().keys().collect();
        assert_eq!(names, ["COLOR_0", "TEXCOORD_0", "_HEAT"]);
    }
    let found = read(&glb);
    assert!(found.meshes() == original.meshes());
    let mesh = found.meshes()[0].as_ref().unwrap();
    for (target, (name, width)) in
        [("TEXCOORD_0", 2), ("COLOR_0", 4), ("_HEAT", 1)].into_iter().enumerate().map(|(i, x)| (i % 2, x))
    {
        let layer = mesh.layer(&Semantic::Generic(format!("morph_{target}_{name}"))).unwrap();
        let heat = mesh.layer(&Semantic::Generic("HEAT".to_owned())).unwrap();
        for v in 0..mesh.vertex_count() {
            assert_eq!(layer.component_count, width);
            assert_eq!(layer.get(v, 0), 10.0 * heat.get(v, 0) + target as f32);
        }
    }
    // In a single mesh too.
    let flat = striata_io::read_bytes(&glb, &Source::new("x.glb")).unwrap();
    let (json, _) = parts(&to_bytes(Format::Glb, &flat, &WriteOptions::default()).unwrap());
    assert_eq!(json["meshes"][0]["primitives"][0]["targets"].as_array().unwrap().len(), 2);
}

/// Displacements of points that are mostly zero stay sparse.
#[test]
fn sparse_targets_of_points_stay_sparse() {
    let mut scene = striata_testing::scenes::empty();
    // A file of points only is refused.
    scene.push_mesh("sheet", &sheet(2));
    let count = 2000;
    let points: Vec<f32> = (0..3 * count).map(|i| i as f32).collect();
    let positions = scene.push_floats("VEC3", 3, &points);
    let places = scene.push_view(&[3u16, 1999].map(u16::to_le_bytes).concat());
    let values = scene.push_view(&[1f32, 2.0, 3.0, 4.0, 5.0, 6.0].map(f32::to_le_bytes).concat());
    let target = scene.push(
        "accessors",
        serde_json::json!({
            "componentType": 5126, "count": count, "type": "VEC3", "min": [0, 0, 0], "max": [4, 5, 6],
            "sparse": { "count": 2, "indices": { "bufferView": places, "componentType": 5123 },
                        "values": { "bufferView": values } },
        }),
    );
    let primitive = serde_json::json!({
        "attributes": { "POSITION": positions }, "mode": 0, "targets": [{ "POSITION": target }],
    });
    scene.push("meshes", serde_json::json!({ "primitives": [primitive] }));
    scene.document["nodes"] = serde_json::json!([{ "mesh": 0 }, { "mesh": 1 }]);
    scene.document["scenes"] = serde_json::json!([{ "nodes": [0, 1] }]);
    let bytes = scene.to_glb();
    let read = |glb: &[u8]| read_scene_bytes(glb, &Source::new("x.glb")).unwrap();
    let numbers = |scene: &striata_io::Scene| {
        let target = &scene.document()["meshes"][1]["primitives"][0]["targets"][0]["POSITION"];
        scene.numbers(target.as_u64().unwrap()).unwrap()
    };
    let original = read(&bytes);
    let (moves, width) = numbers(&original);
    assert_eq!((moves.len(), width, moves[11], moves[5997]), (3 * count, 3, 3.0, 4.0));
    let glb = SceneWriter::new(&original).to_bytes(Format::Glb, &WriteOptions::default()).unwrap();
    assert!(glb.len() * 20 <= bytes.len() * 21, "{} bytes of {}", glb.len(), bytes.len());
    assert_eq!(numbers(&read(&glb)), (moves, width));
}
