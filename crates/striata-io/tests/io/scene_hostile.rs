//! Broken scenes give an error that names the place and the reason, or a scene; large ones take seconds.

use serde_json::{Value, json};
use striata::mesh::{IndexedMesh, shapes};
use striata_io::{Format, Scene, Source, WriteOptions, read_bytes, read_scene_bytes, scene_to_bytes};
use striata_testing::scenes::{self, TestScene};

fn read(scene: &TestScene) -> Result<Scene, String> {
    read_scene_bytes(&scene.to_glb(), &Source::new("scene.glb")).map_err(|error| error.to_string())
}

/// Checks that reading fails with a message that contains all the words.
fn refused(scene: &TestScene, words: &[&str]) {
    let message = match read(scene) {
        Err(message) => message,
        Ok(_) => panic!("{} was read", scene.name),
    };
    assert!(message.len() < 400 && message.starts_with("scene.glb: "), "{message}");
    for word in words {
        assert!(message.contains(word), "`{word}` is missing in: {message}");
    }
}

/// Writes a scene, reads it again, and flattens it.
fn survives(scene: &Scene) -> Scene {
    let bytes = scene_to_bytes(Format::Glb, scene, &WriteOptions::default()).unwrap();
    let again = read_scene_bytes(&bytes, &Source::new("again.glb")).unwrap();
    assert_eq!(again.instances(), scene.instances());
    let flat = scene.flattened().unwrap();
    assert_eq!(flat.triangle_count(), scene.triangle_count());
    again
}

/// A scene with one mesh of 20 triangles and one node.
fn ball() -> TestScene {
    let mut scene = scenes::empty();
    let mesh = scene.push_mesh("ball", &shapes::icosphere(0, 1.0));
    scene.push("nodes", json!({ "mesh": mesh }));
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    scene.document["scene"] = json!(0);
    scene
}

#[test]
fn nodes_must_form_a_tree() {
    let with_nodes = |nodes: Value| {
        let mut scene = ball();
        scene.document["nodes"] = nodes;
        scene
    };
    let cycle = with_nodes(json!([{ "children": [1] }, { "children": [2] }, { "children": [1], "mesh": 0 }]));
    refused(&cycle, &["nodes[2].children[0]", "nodes[1] is reached twice", "tree"]);
    refused(&with_nodes(json!([{ "children": [0] }])), &["nodes[0].children[0]", "reached twice"]);
    let shared = with_nodes(json!([{ "children": [1, 2] }, { "children": [3] }, { "children": [3] }, {}]));
    refused(&shared, &["nodes[2].children[0]", "nodes[3] is reached twice"]);
    refused(&with_nodes(json!([{ "children": [7] }])), &["nodes[7] does not exist"]);
    refused(&with_nodes(json!([{ "mesh": 3 }])), &["nodes[0].mesh", "meshes[3] does not exist"]);
    refused(&with_nodes(json!([{ "mesh": 0, "rotation": [0, 0, 0, 0] }])), &["nodes[0]", "no length"]);
    refused(&with_nodes(json!([{ "mesh": 0, "skin": 0 }])), &["nodes[0].skin", "skins[0] does not exist"]);
    // Nodes outside of the default scene may be broken.
    survives(&read(&with_nodes(json!([{ "mesh": 0 }, { "children": [2] }, { "children": [1] }]))).unwrap());
    // Numbers that are too large for matrices.
    let huge = with_nodes(json!([{ "scale": [1e300, 1e300, 1e300], "children": [1] },
        { "scale": [1e300, 1, 1], "mesh": 0 }]));
    assert_eq!(read(&huge).unwrap().instances().len(), 1);
}

#[test]
fn deep_json_is_refused() {
    let text = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"extras\":{}{}}}",
        "[".repeat(1 << 20),
        "]".repeat(1 << 20)
    );
    let error = read_scene_bytes(text.as_bytes(), &Source::new("x.gltf")).unwrap_err().to_string();
    assert!(error.contains("x.gltf") && error.contains("recursion"), "{error}");
}

#[test]
fn counts_are_compared_with_the_data() {
    let with_count = |count: u64| {
        let mut scene = ball();
        scene.document["accessors"][0]["count"] = json!(count);
        scene
    };
    refused(&with_count(1 << 28), &["accessors[0]", "elements"]);
    refused(&with_count(u64::MAX), &["accessors[0]", "more than can be handled"]);
    let mut zeros = with_count(1 << 28);
    zeros.document["accessors"][0].as_object_mut().unwrap().remove("bufferView");
    refused(&zeros, &["accessors[0]", "268435456 zeros in a file of"]);
    let sparse = |count: u64, index: u64| {
        let mut scene = ball();
        let indices = scene.push_view(&(index as u32).to_le_bytes());
        let values = scene.push_view(&[0; 12]);
        scene.document["accessors"][0]["sparse"] = json!({
            "count": count,
            "indices": { "bufferView": indices, "componentType": 5125 },
            "values": { "bufferView": values },
        });
        scene
    };
    survives(&read(&sparse(1, 11)).unwrap());
    refused(&sparse(1, 12), &["accessors[0].sparse.indices", "element 12 of 12 does not exist"]);
    refused(&sparse(2, 0), &["accessors[0].sparse", "but the view has 4"]);
    refused(&sparse(1 << 40, 0), &["accessors[0].sparse", "replacements for 12 elements"]);
}

#[test]
fn broken_skins_are_scenes_or_errors() {
    for (pointer, value) in [
        ("/skins/0/joints", json!([1, 99])),
        ("/skins/0/joints", json!([1, 2, 1, 2])),
        ("/skins/0/joints", json!([])),
        ("/skins/0", json!({})),
        ("/accessors/6/count", json!(1)),
        ("/accessors/6/type", json!("VEC4")),
        ("/nodes/0", json!({ "skin": 0 })),
        ("/meshes/0/primitives/0/attributes/WEIGHTS_0", json!(0)),
    ] {
        let mut scene = scenes::skinned();
        *scene.document.pointer_mut(pointer).unwrap() = value.clone();
        match read(&scene) {
            Ok(found) => drop(survives(&found)),
            Err(message) => {
                assert!(message.contains("accessors[") || message.contains("skins["), "{message}")
            }
        }
    }
    let mut unweighted = scenes::skinned();
    let attributes = &mut unweighted.document["meshes"][0]["primitives"][0]["attributes"];
    attributes.as_object_mut().unwrap().remove("WEIGHTS_0");
    survives(&read(&unweighted).unwrap());
    let mut no_numbers = scenes::skinned();
    no_numbers.document["skins"][0]["joints"] = json!(["a", null]);
    refused(&no_numbers, &["skins[0].joints[0]", "whole number"]);
    let mut missing = scenes::skinned();
    missing.document["skins"][0]["inverseBindMatrices"] = json!(999);
    refused(&missing, &["accessors[999] does not exist"]);
}

#[test]
fn primitives_may_differ_in_morph_targets() {
    let mut scene = scenes::morphed();
    let mut fewer = scene.document["meshes"][0]["primitives"][0].clone();
    fewer["targets"].as_array_mut().unwrap().pop();
    let mut none = fewer.clone();
    none.as_object_mut().unwrap().remove("targets");
    let primitives = scene.document["meshes"][0]["primitives"].as_array_mut().unwrap();
    primitives.extend([fewer, none]);
    scene.document["meshes"][0]["weights"] = json!([1.0, 2.0, 3.0, 4.0, 5.0]);
    scene.document["nodes"][0]["weights"] = json!(["x"]);
    let again = survives(&read(&scene).unwrap());
    let targets = |primitive: usize| {
        let primitive = &again.document()["meshes"][0]["primitives"][primitive];
        primitive.get("targets").map_or(0, |targets| targets.as_array().unwrap().len())
    };
    assert_eq!([targets(0), targets(1), targets(2)], [2, 1, 0]);
    // A target of another number of vertices.
    let mut short = scenes::morphed();
    let target = short.push_floats("VEC3", 3, &[0.0; 9]);
    short.document["meshes"][0]["primitives"][0]["targets"][1]["POSITION"] = json!(target);
    refused(&short, &["accessors", "3 elements for"]);
}

#[test]
fn image_paths_stay_in_the_folder() {
    let folder = tempfile::tempdir().unwrap();
    let inner = folder.path().join("model");
    std::fs::create_dir(&inner).unwrap();
    std::fs::write(folder.path().join("secret.png"), scenes::PNG).unwrap();
    std::fs::write(inner.join("own.png"), scenes::PNG).unwrap();
    let outside = folder.path().join("secret.png").display().to_string();
    let uris = [
        "own.png",
        "lost.png",
        "../secret.png",
        "%2e%2e/secret.png",
        "..%2Fsecret.png",
        "a/../../secret.png",
        &outside,
        "file:../secret.png",
        "file:///etc/passwd",
        "/etc/passwd",
        "http://localhost/x.png",
        "..\\secret.png",
        "%zz.png",
        "own.png\0",
        ".",
    ];
    let mut scene = ball();
    scene.document["images"] = uris.iter().map(|uri| json!({ "uri": uri })).collect();
    std::fs::write(inner.join("scene.glb"), scene.to_glb()).unwrap();
    // A program that serves files of others allows nothing outside.
    let bytes = std::fs::read(inner.join("scene.glb")).unwrap();
    let found = read_scene_bytes(&bytes, &Source::new("scene.glb").with_folder(&inner)).unwrap();
    assert_eq!(found.images()[0].bytes, scenes::PNG);
    assert!(found.images()[1..].iter().all(|image| image.bytes.is_empty()));
    let warnings: Vec<String> = found.warnings().iter().map(ToString::to_string).collect();
    assert_eq!(warnings.len(), uris.len() - 1, "{warnings:#?}");
    assert!(warnings[0].contains("images[1]") && warnings[0].contains("lost.png"), "{}", warnings[0]);
    assert!(warnings[5].contains("absolute path"), "{}", warnings[5]);
    for warning in &warnings[1..5] {
        assert!(warning.contains("leaves the folder"), "{warning}");
    }
    survives(&found);
}

/// A number of nodes that no recursion survives.
fn many() -> usize {
    striata_testing::large(1_000_000)
}

/// Returns a file with that many nodes.
fn with_nodes(mesh: &IndexedMesh, roots: &str, node: impl Fn(usize) -> String) -> Vec<u8> {
    let mut scene = scenes::empty();
    scene.push_mesh("mesh", mesh);
    scene.document["nodes"] = json!("NODES");
    scene.document["scenes"] = json!([{ "nodes": "ROOTS" }]);
    let nodes: Vec<String> = (0..many()).map(node).collect();
    let nodes = format!("[{}]", nodes.join(","));
    scene.to_glb_with(&[("NODES", nodes), ("ROOTS", roots.to_owned())])
}

fn triangle() -> IndexedMesh {
    IndexedMesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]])
}

#[test]
fn chains_of_a_million_nodes_do_not_overflow_the_stack() {
    let end = many() - 1;
    let node = |i: usize| match i {
        _ if i == end => r#"{"mesh":0}"#.to_owned(),
        _ => format!(r#"{{"children":[{}],"translation":[0.5,0,0]}}"#, i + 1),
    };
    let glb = with_nodes(&triangle(), "[0]", node);
    let scene = read_scene_bytes(&glb, &Source::new("scene.glb")).unwrap();
    let [instance] = scene.instances() else { panic!("the last node shows the mesh") };
    assert_eq!(instance.transform[12], end as f64 / 2.0);
    let bytes = scene_to_bytes(Format::Glb, &scene, &WriteOptions::default()).unwrap();
    drop(scene);
    assert_eq!(
        read_bytes(&bytes, &Source::new("x.glb")).unwrap().file_position(0),
        [end as f64 / 2.0, 0.0, 0.0]
    );
}

#[test]
fn a_million_nodes_may_show_one_mesh() {
    let roots: Vec<String> = (0..many()).map(|i| i.to_string()).collect();
    let node = |i: usize| format!(r#"{{"mesh":0,"translation":[{i},0,0]}}"#);
    let glb = with_nodes(&triangle(), &format!("[{}]", roots.join(",")), node);
    let scene = read_scene_bytes(&glb, &Source::new("scene.glb")).unwrap();
    assert_eq!((scene.instances().len(), scene.triangle_count()), (many(), many()));
    assert_eq!(scene.bounds().unwrap().max, [many() as f32, 1.0, 0.0]);
    drop(scene);
    assert_eq!(read_bytes(&glb, &Source::new("x.glb")).unwrap().triangle_count(), many());
}

#[test]
fn long_names_are_copied_only_within_limits() {
    let mut scene = ball();
    scene.document["meshes"][0]["name"] = json!("n".repeat(10_000_000));
    let found = read(&scene).unwrap();
    assert_eq!(found.mesh_name(0).len(), 10_000_000);
    survives(&found);
    scene.document["nodes"] = (0..1000).map(|_| json!({ "mesh": 0 })).collect();
    scene.document["scenes"][0]["nodes"] = (0..1000).collect();
    let found = read(&scene).unwrap();
    assert_eq!(found.triangle_count(), 20_000);
    // Each of the thousand groups would get the name.
    let message = read_bytes(&scene.to_glb(), &Source::new("x.glb")).unwrap_err().to_string();
    assert!(message.starts_with("x.glb: ") && message.contains("with all names"), "{message}");
}
