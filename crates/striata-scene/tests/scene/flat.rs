//! A scene read as one mesh: posed as its nodes pose it, whatever units its vertices have.

use striata_io::scene_to_bytes;
use striata_io::{Format, QuantizeOptions, Scene, Source, WriteOptions, read_bytes, read_scene_bytes};
use striata_scene::Poser;
use striata_testing::scenes::{self, TestScene};

fn read(sample: &TestScene) -> Scene {
    read_scene_bytes(&sample.to_glb(), &Source::new("x.glb")).unwrap()
}

/// Positions of everything that the scene shows, in the pose of its nodes.
fn posed(scene: &Scene) -> Vec<[f32; 3]> {
    let poser = Poser::new(scene).unwrap();
    let pose = poser.rest_pose();
    let shown = scene.instances().iter().filter_map(|at| Some((at, scene.meshes()[at.mesh].as_ref()?)));
    shown.flat_map(|(instance, mesh)| poser.positions(&pose, instance, mesh)).collect()
}

/// Panics unless each corner of the flat mesh is where the pose puts it.
fn agree(flat: &[[f32; 3]], posed: &[[f32; 3]], tolerance: f32) {
    assert_eq!(flat.len(), posed.len());
    for (a, b) in flat.iter().zip(posed) {
        let distance = a.iter().zip(b).map(|(x, y)| (x - y).powi(2)).sum::<f32>().sqrt();
        assert!(distance <= tolerance, "{a:?} and {b:?} are {distance} apart");
    }
}

/// A skinned sample whose first joint is bent and raised in the pose of its nodes.
fn bent() -> TestScene {
    let mut sample = scenes::skinned();
    let joint = sample.document["skins"][0]["joints"][1].as_u64().unwrap() as usize;
    let turned = serde_json::json!([0.0, 0.0, 0.6, 0.8]);
    sample.document["nodes"][joint].as_object_mut().unwrap().remove("matrix");
    sample.document["nodes"][joint]["rotation"] = turned;
    sample.document["nodes"][joint]["scale"] = serde_json::json!([2.0, 2.0, 2.0]);
    sample
}

#[test]
fn flat_meshes_have_the_pose_of_the_nodes() {
    for sample in [scenes::skinned(), bent(), scenes::morphed(), scenes::hierarchy()] {
        let scene = read(&sample);
        let flat = read_bytes(&sample.to_glb(), &Source::new("x.glb")).unwrap();
        agree(&flat.positions, &posed(&scene), 1e-5 * scene.diagonal() as f32);
    }
    let (bind, bent) = (read(&scenes::skinned()), read(&bent()));
    assert_ne!(posed(&bind), posed(&bent), "the joint must move something");
}

#[test]
fn weights_of_nodes_move_morph_targets() {
    let mut sample = scenes::morphed();
    let still = posed(&read(&sample));
    let nodes = sample.document["nodes"].as_array_mut().unwrap();
    let node = nodes.iter_mut().find(|node| node.get("mesh").is_some()).unwrap();
    node["weights"] = serde_json::json!([0.75, 0.5]);
    let scene = read(&sample);
    assert_ne!(still, posed(&scene));
    let flat = read_bytes(&sample.to_glb(), &Source::new("x.glb")).unwrap();
    agree(&flat.positions, &posed(&scene), 1e-5 * scene.diagonal() as f32);
}

#[test]
fn quantized_skins_keep_their_size() {
    let scene = read(&bent());
    let options = WriteOptions::default().with_quantize(QuantizeOptions::default());
    let bytes = scene_to_bytes(Format::Glb, &scene, &options).unwrap();
    let (flat, expected) = (read_bytes(&bytes, &Source::new("x.glb")).unwrap(), posed(&scene));
    // Weights are bytes, and decide between places that are up to a diagonal apart.
    agree(&flat.positions, &expected, scene.diagonal() as f32 / 255.0);
    let normals = flat.layer(&striata::mesh::Semantic::Normal);
    for vertex in 0..normals.map_or(0, |_| flat.vertex_count()) {
        let length = (0..3).map(|axis| normals.unwrap().get(vertex, axis).powi(2)).sum::<f32>().sqrt();
        assert!((length - 1.0).abs() < 0.01, "normal {vertex} has length {length}");
    }
}
