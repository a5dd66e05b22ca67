//! Instances of `EXT_mesh_gpu_instancing` count as instances of the scene.

use serde_json::{Value, json};
use striata::mesh::shapes;
use striata_io::{Format, Scene, Source, WriteOptions, read_bytes, read_scene_bytes, scene_to_bytes};
use striata_testing::scenes::{self, TestScene};

/// A node at x = 10, twice as large, that shows a ball with the attributes of its instances.
fn forest(attributes: impl FnOnce(&mut TestScene) -> Value) -> TestScene {
    let mut scene = scenes::empty();
    let mesh = scene.push_mesh("tree", &shapes::icosphere(1, 1.0));
    let extension = json!({ "EXT_mesh_gpu_instancing": { "attributes": attributes(&mut scene) } });
    let node =
        json!({ "mesh": mesh, "translation": [10, 0, 0], "scale": [2, 2, 2], "extensions": extension });
    scene.document["nodes"] = json!([node]);
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    scene.document["extensionsUsed"] = json!(["EXT_mesh_gpu_instancing"]);
    scene
}

fn read(scene: &TestScene) -> Result<Scene, String> {
    read_scene_bytes(&scene.to_glb(), &Source::new("x.glb")).map_err(|error| error.to_string())
}

/// Three places; the second is three times as large, and the third is turned by a quarter about z.
fn places(scene: &mut TestScene) -> Value {
    let translations = scene.push_floats("VEC3", 3, &[0.0, 0.0, 0.0, 5.0, 0.0, 0.0, 0.0, 5.0, 0.0]);
    let scales = scene.push_floats("VEC3", 3, &[1.0, 1.0, 1.0, 3.0, 3.0, 3.0, 1.0, 1.0, 1.0]);
    let bytes = [0i8, 0, 0, 127, 0, 0, 0, 127, 0, 0, 90, 90].map(|byte| byte as u8);
    let view = scene.push_view(&bytes);
    let rotations = json!({
        "bufferView": view, "componentType": 5120, "normalized": true, "count": 3, "type": "VEC4",
    });
    let rotations = scene.push("accessors", rotations);
    json!({ "TRANSLATION": translations, "SCALE": scales, "ROTATION": rotations, "_ID": scales })
}

#[test]
fn instances_have_the_transform_of_the_node_and_their_own() {
    let sample = forest(places);
    let scene = read(&sample).unwrap();
    assert_eq!(scene.triangle_count(), 3 * 80);
    let instances = scene.instances();
    assert_eq!(instances.iter().map(|instance| instance.node).collect::<Vec<_>>(), vec![Some(0); 3]);
    let scales: Vec<f64> = instances.iter().map(|instance| (instance.scale * 1e6).round() / 1e6).collect();
    assert_eq!(scales, [2.0, 6.0, 2.0]);
    let origin = |i: usize| [12, 13, 14].map(|at| instances[i].transform[at]);
    assert_eq!([origin(0), origin(1), origin(2)], [[10.0, 0.0, 0.0], [20.0, 0.0, 0.0], [10.0, 10.0, 0.0]]);
    // The third maps x to y.
    let image = [0, 1, 2].map(|at| instances[2].transform[at].round());
    assert_eq!(image, [0.0, 2.0, 0.0]);
    assert_eq!(instances[1].in_node.as_ref().map(|columns| columns[12]), Some(5.0));

    let bytes = scene_to_bytes(Format::Glb, &scene, &WriteOptions::default()).unwrap();
    let again = read_scene_bytes(&bytes, &Source::new("x.glb")).unwrap();
    assert_eq!(again.instances(), instances);
}

#[test]
fn flat_meshes_show_all_instances() {
    let sample = forest(places);
    let scene = read(&sample).unwrap();
    let flat = scene.flattened().unwrap();
    assert_eq!(flat.triangle_count(), 240);
    assert_eq!(flat.groups.len(), 3);
    let (found, expected) = (flat.bounds().unwrap(), scene.bounds().unwrap());
    for axis in 0..3 {
        assert!((found.min[axis] - expected.min[axis]).abs() < 1.0, "{found:?} {expected:?}");
        assert!((found.max[axis] - expected.max[axis]).abs() < 1.0, "{found:?} {expected:?}");
    }
    let direct = read_bytes(&sample.to_glb(), &Source::new("x.glb")).unwrap();
    assert_eq!(direct.triangle_count(), 240);
}

#[test]
fn instances_without_places_are_counted_too() {
    let only_ids = forest(|scene| {
        let ids = scene.push_floats("SCALAR", 1, &[0.0, 1.0, 2.0, 3.0]);
        json!({ "_ID": ids })
    });
    assert_eq!(read(&only_ids).unwrap().instances().len(), 4);
    let none = forest(|_| json!({}));
    assert_eq!(read(&none).unwrap().instances().len(), 1);
    let zeros = forest(|scene| {
        let zeros = json!({ "componentType": 5126, "count": 7, "type": "VEC3" });
        json!({ "TRANSLATION": scene.push("accessors", zeros) })
    });
    let scene = read(&zeros).unwrap();
    assert_eq!(scene.instances().len(), 7);
    assert_eq!(scene.flattened().unwrap().triangle_count(), 7 * 80);
    // A skin decides where its mesh is, so there is one instance.
    let mut skinned = forest(places);
    skinned.document["skins"] = json!([{ "joints": [1] }]);
    skinned.document["nodes"].as_array_mut().unwrap().push(json!({}));
    skinned.document["nodes"][0]["skin"] = json!(0);
    skinned.document["scenes"][0]["nodes"] = json!([0, 1]);
    assert_eq!(read(&skinned).unwrap().instances().len(), 1);
}

#[test]
fn malformed_instances_are_refused() {
    let refused = |attributes: &dyn Fn(&mut TestScene) -> Value, words: &[&str]| {
        let sample = forest(attributes);
        let flat = read_bytes(&sample.to_glb(), &Source::new("x.glb")).unwrap_err().to_string();
        for message in [read(&sample).unwrap_err(), flat] {
            assert!(words.iter().all(|word| message.contains(word)), "{message}");
        }
    };
    refused(&|_| json!({ "TRANSLATION": 99 }), &["accessors[99] does not exist"]);
    refused(&|scene| json!({ "SCALE": scene.push_floats("SCALAR", 1, &[1.0]) }), &["SCALE", "VEC3"]);
    refused(
        &|scene| json!({ "ROTATION": scene.push_floats("VEC4", 4, &[0.0; 4]) }),
        &["instance 0", "no length"],
    );
    let different = |scene: &mut TestScene| {
        json!({
            "SCALE": scene.push_floats("VEC3", 3, &[1.0; 6]),
            "TRANSLATION": scene.push_floats("VEC3", 3, &[1.0; 3]),
        })
    };
    refused(&different, &["attributes.TRANSLATION", "1 elements, but another attribute has 2"]);
    let zeros = |count: u64| {
        move |scene: &mut TestScene| {
            let zeros = json!({ "componentType": 5126, "count": count, "type": "VEC3" });
            json!({ "TRANSLATION": scene.push("accessors", zeros) })
        }
    };
    refused(&zeros(1 << 29), &["accessors", "zeros in a file of"]);
}

#[test]
fn shared_accessors_of_many_nodes_are_limited() {
    let mut sample = forest(|scene| json!({ "TRANSLATION": scene.push_floats("VEC3", 3, &[0.5; 3000]) }));
    let node = sample.document["nodes"][0].clone();
    sample.document["nodes"] = json!(vec![node; 1000]);
    sample.document["scenes"][0]["nodes"] = (0..1000).collect();
    let message = read(&sample).unwrap_err();
    assert!(message.contains("instances are too many for a file of"), "{message}");
}
