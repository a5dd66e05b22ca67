//! Equal parts are merged, and keyframes that others imply are left out.

use serde_json::{Value, json};
use striata::mesh::shapes;
use striata_io::{Format, QuantizeOptions, Scene, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_testing::scenes::{self, TestScene};

fn read(scene: &TestScene) -> Scene {
    read_scene_bytes(&scene.to_glb(), &Source::new("x.glb")).expect("the scene is valid")
}

/// Writes a scene and reads it again.
fn again(scene: &Scene) -> Scene {
    let glb = scene_to_bytes(Format::Glb, scene, &WriteOptions::default()).expect("it can be written");
    read_scene_bytes(&glb, &Source::new("x.glb")).expect("what was written can be read")
}

/// Six nodes of six equal balls, with materials, textures and images of their own, of which some are equal.
fn doubles() -> TestScene {
    let mut scene = scenes::empty();
    scene.push_mesh("ball", &shapes::icosphere(2, 1.0));
    let ball = scene.document["meshes"][0].clone();
    let mesh = |material: usize| {
        let mut mesh = ball.clone();
        mesh["primitives"][0]["material"] = json!(material);
        mesh
    };
    let pixels = |number: u8| [b"\x89PNG\r\n\x1a\n", &[number][..]].concat();
    let views: Vec<usize> = [1, 1, 2].into_iter().map(|number| scene.push_view(&pixels(number))).collect();
    let image =
        |&view: &usize| json!({ "name": format!("{view}"), "bufferView": view, "mimeType": "image/png" });
    scene.document["images"] = views.iter().map(image).collect();
    scene.document["samplers"] = json!([{}, { "name": "other" }, { "wrapS": 33071 }]);
    let sources = [(0, 0), (1, 1), (2, 1), (0, 2)];
    let texture = |(source, sampler)| json!({ "source": source, "sampler": sampler });
    scene.document["textures"] = sources.into_iter().map(texture).collect();
    let textured = |name: &str, texture: usize| json!({ "name": name, "pbrMetallicRoughness": { "baseColorTexture": { "index": texture } } });
    let materials = [("a", 0), ("a", 1), ("b", 1), ("a", 2), ("a", 3), ("a", 0)];
    scene.document["materials"] = materials.into_iter().map(|(name, index)| textured(name, index)).collect();
    scene.document["meshes"] = (0..6).map(mesh).collect();
    scene.document["nodes"] = (0..6).map(|mesh| json!({ "mesh": mesh })).collect();
    scene.document["scenes"] = json!([{ "nodes": [0, 1, 2, 3, 4, 5] }]);
    scene
}

fn count(scene: &Scene, list: &str) -> usize {
    scene.document()[list].as_array().map_or(0, Vec::len)
}

/// Bytes of the color image of each instance, with the settings of its sampler.
fn colors(scene: &Scene) -> Vec<(Vec<u8>, Value)> {
    let document = scene.document();
    let number = |value: &Value| value.as_u64().expect("an index") as usize;
    let color = |mesh: usize| {
        let material = scene.primitive_materials(mesh)[0].expect("a material");
        let texture = &document["materials"][material]["pbrMetallicRoughness"]["baseColorTexture"]["index"];
        let texture = &document["textures"][number(texture)];
        let sampler = &document["samplers"][number(&texture["sampler"])]["wrapS"];
        (scene.images()[number(&texture["source"])].bytes.clone(), sampler.clone())
    };
    scene.instances().iter().map(|instance| color(instance.mesh)).collect()
}

#[test]
fn equal_parts_are_merged() {
    let scene = read(&doubles());
    let (merged, counts) = scene.clone().deduplicated();
    assert_eq!((counts.images, counts.textures, counts.materials, counts.meshes), (1, 1, 2, 2));
    let found = ["images", "samplers", "textures", "materials", "meshes"].map(|list| count(&merged, list));
    assert_eq!(found, [2, 2, 3, 4, 4]);
    assert_eq!(merged.meshes().len(), 4);
    for scene in [again(&merged), merged] {
        assert_eq!(colors(&scene), colors(&read(&doubles())));
        assert_eq!(scene.triangle_count(), 6 * 320);
    }
    let (same, counts) = again(&scene.deduplicated().0).deduplicated();
    assert_eq!((counts, count(&same, "materials")), (Default::default(), 4));
}

/// Materials that animations change stay apart, and the animations find them again.
#[test]
fn animated_materials_stay_apart() {
    let mut sample = doubles();
    let pointer = |material: usize| {
        let pointer = format!("/materials/{material}/pbrMetallicRoughness/baseColorFactor");
        json!({ "sampler": 0, "target": {
            "path": "pointer", "extensions": { "KHR_animation_pointer": { "pointer": pointer } },
        } })
    };
    let [times, colors] = [(1, "SCALAR"), (4, "VEC4")].map(|(width, kind)| {
        let numbers: Vec<f32> = (0..2 * width).map(|x| x as f32).collect();
        let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        let view = sample.push_view(&bytes);
        let accessor = json!({ "bufferView": view, "componentType": 5126, "count": 2, "type": kind });
        sample.push("accessors", accessor)
    });
    sample.document["extensionsUsed"] = json!(["KHR_animation_pointer"]);
    sample.document["animations"] = json!([{
        "samplers": [{ "input": times, "output": colors }], "channels": [pointer(0), pointer(5)],
    }]);
    let (merged, counts) = read(&sample).deduplicated();
    assert_eq!((counts.materials, count(&merged, "materials")), (0, 6));
    // Without those of the animation, one of the others goes, and the last is named by its new number.
    sample.document["materials"][3] = sample.document["materials"][1].clone();
    let (merged, counts) = read(&sample).deduplicated();
    assert_eq!(counts.materials, 1);
    let channel = &merged.document()["animations"][0]["channels"][1];
    let pointer = &channel["target"]["extensions"]["KHR_animation_pointer"]["pointer"];
    assert_eq!(pointer, "/materials/4/pbrMetallicRoughness/baseColorFactor");
}

/// Keyframes of a node: of a turn, a move along a line that then rests, and steps.
fn moving(count: usize) -> TestScene {
    let mut scene = scenes::empty();
    scene.push_mesh("ball", &shapes::icosphere(1, 1.0));
    scene.document["nodes"] = json!([{ "mesh": 0 }]);
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    let time = |key: usize| key as f32 / 30.0;
    let half = count / 2;
    let turn = |key: usize| {
        let (sin, cos) = (0.2 * time(key)).sin_cos();
        vec![0.0, sin, 0.0, cos]
    };
    let line = |key: usize| vec![time(key.min(half)) * 3.0, 1.0, -time(key.min(half))];
    let step = |key: usize| vec![1.0 + (key / 10) as f32; 3];
    let mut push = |width: usize, numbers: Vec<f32>| {
        let bytes: Vec<u8> = numbers.iter().flat_map(|x| x.to_le_bytes()).collect();
        let view = scene.push_view(&bytes);
        let kind = ["SCALAR", "VEC3", "VEC4"][[1, 3, 4].iter().position(|&w| w == width).expect("a type")];
        let accessor = json!({
            "bufferView": view, "componentType": 5126, "count": numbers.len() / width, "type": kind,
        });
        scene.push("accessors", accessor)
    };
    let mut samplers = Vec::new();
    type OfKey<'v> = &'v dyn Fn(usize) -> Vec<f32>;
    let tracks: [(usize, &str, OfKey<'_>); 3] =
        [(4, "LINEAR", &turn), (3, "LINEAR", &line), (3, "STEP", &step)];
    for (width, interpolation, value) in tracks {
        let input = push(1, (0..count).map(time).collect());
        let output = push(width, (0..count).flat_map(value).collect());
        samplers.push(json!({ "input": input, "output": output, "interpolation": interpolation }));
    }
    let channel =
        |(sampler, path): (usize, &str)| json!({ "sampler": sampler, "target": { "node": 0, "path": path } });
    let channels: Vec<Value> =
        ["rotation", "translation", "scale"].into_iter().enumerate().map(channel).collect();
    scene.document["animations"] = json!([{ "samplers": samplers, "channels": channels }]);
    scene
}

#[test]
fn keyframes_that_others_imply_are_left_out() {
    let scene = read(&moving(200));
    // Equal times are stored once in any case.
    assert_eq!(count(&scene, "accessors"), 4);
    let (found, counts) = scene.clone().resampled(1e-4).expect("the data are valid");
    // A turn at constant speed needs two; the line three; 200 steps have 20 values, and the end stays.
    assert_eq!(counts, [600, 2 + 3 + 21]);
    let found = again(&found);
    let counts: Vec<u64> = found.document()["animations"][0]["samplers"]
        .as_array()
        .expect("samplers")
        .iter()
        .flat_map(|sampler| [sampler["input"].clone(), sampler["output"].clone()])
        .map(|accessor| {
            let accessor = &found.document()["accessors"][accessor.as_u64().expect("an index") as usize];
            accessor["count"].as_u64().expect("a count")
        })
        .collect();
    assert_eq!(counts, [2, 2, 3, 3, 21, 21]);
    assert!(found.buffer().len() < scene.buffer().len() / 8);
    // Nothing is left out of what bends.
    let mut bent = moving(5);
    bent.document["animations"][0]["samplers"][2]["interpolation"] = json!("CUBICSPLINE");
    let (_, counts) = read(&bent).resampled(1e-4).expect("the data are valid");
    assert_eq!(counts, [10, 2 + 3]);
}

/// Keyframes of an animation as floats: for each sampler its times and values.
fn keyframes(scene: &Scene) -> Vec<Vec<f64>> {
    let document = scene.document();
    let samplers = document["animations"][0]["samplers"].as_array().expect("samplers");
    let numbers = |accessor: &Value| -> Vec<f64> {
        let accessor = &document["accessors"][accessor.as_u64().expect("an index") as usize];
        let view = &document["bufferViews"][accessor["bufferView"].as_u64().expect("a view") as usize];
        let at = |value: &Value| value["byteOffset"].as_u64().unwrap_or(0) as usize;
        let bytes = &scene.buffer()[at(view) + at(accessor)..];
        let width = match accessor["type"].as_str() {
            Some("SCALAR") => 1,
            Some("VEC3") => 3,
            _ => 4,
        };
        let count = width * accessor["count"].as_u64().expect("a count") as usize;
        match accessor["componentType"].as_u64() {
            Some(5122) => bytes.as_chunks().0[..count]
                .iter()
                .map(|&word| f64::from(i16::from_le_bytes(word)) / 32767.0)
                .collect(),
            _ => bytes.as_chunks().0[..count].iter().map(|&word| f32::from_le_bytes(word).into()).collect(),
        }
    };
    samplers.iter().flat_map(|sampler| [numbers(&sampler["input"]), numbers(&sampler["output"])]).collect()
}

#[test]
fn keyframes_are_rounded_within_bounds() {
    let scene = read(&moving(200));
    let plain = WriteOptions::default().with_quantize(QuantizeOptions::default());
    for (options, bounds) in [
        (plain.clone(), [0.0, 1e-3, 0.0, 0.0, 0.0, 0.0]),
        (plain.with_meshopt(true), [2e-4, 2e-3, 2e-4, 2e-4, 2e-4, 4e-4]),
    ] {
        let glb = scene_to_bytes(Format::Glb, &scene, &options).expect("it can be written");
        let found = keyframes(&read_scene_bytes(&glb, &Source::new("x.glb")).expect("it can be read"));
        for ((found, exact), bound) in found.iter().zip(keyframes(&scene)).zip(bounds) {
            assert_eq!(found.len(), exact.len());
            let most = found.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(most <= bound, "{most} {bound}");
        }
    }
    let exact = scene_to_bytes(Format::Glb, &scene, &WriteOptions::default().with_meshopt(true));
    let exact = read_scene_bytes(&exact.expect("it can be written"), &Source::new("x.glb"));
    assert_eq!(keyframes(&exact.expect("it can be read")), keyframes(&scene));
}

/// Vertices that are equal in position and attributes become one, and triangles keep their order.
#[test]
fn equal_vertices_are_merged() {
    let mut sample = scenes::empty();
    let ball = shapes::icosphere(2, 1.0);
    let mut soup = ball.clone();
    soup.positions = ball.triangles.iter().flatten().map(|&v| ball.positions[v as usize]).collect();
    soup.layers = ball.layers.iter().map(|layer| layer.gather(ball.triangles.as_flattened())).collect();
    soup.triangles = (0..ball.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    sample.push_mesh("ball", &soup);
    sample.document["nodes"] = json!([{ "mesh": 0 }]);
    sample.document["scenes"] = json!([{ "nodes": [0] }]);
    let (merged, counts) = read(&sample).deduplicated();
    assert_eq!(counts.vertices, soup.positions.len() - ball.positions.len());
    let mesh = merged.meshes()[0].as_ref().expect("a mesh");
    let corners = mesh.triangles.iter().flatten().map(|&v| mesh.positions[v as usize]);
    assert!(corners.eq(soup.positions.iter().copied()));
}
