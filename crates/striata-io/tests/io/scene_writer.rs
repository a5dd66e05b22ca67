//! Scenes written with additions: shared vertex buffers, attached data, empty primitives.

use serde_json::{Value, json};
use striata_io::{Format, Scene, SceneWriter, SharedMesh, Source, WriteOptions, mesh_data, read_scene_bytes};
use striata_testing::scenes::{self, TestScene};

fn read(scene: &TestScene) -> Scene {
    read_scene_bytes(&scene.to_glb(), &Source::new("test.glb")).unwrap()
}

/// A scene with a second entry of `meshes`, like the first one but without triangles of its own.
fn with_second_entry(sample: &TestScene) -> Scene {
    let mut parts = read(sample).into_parts();
    let entry = parts.document["meshes"][0].clone();
    parts.document["meshes"].as_array_mut().unwrap().push(entry);
    parts.meshes.push(None);
    Scene::from_parts(parts).unwrap()
}

fn shared(index_lists: Vec<Vec<u32>>) -> SharedMesh {
    SharedMesh { vertices_of: 0, vertex_count: usize::MAX, index_lists }
}

fn json_of(writer: &SceneWriter<'_>) -> Result<Value, String> {
    let bytes = writer.to_bytes(Format::Gltf, &WriteOptions::default()).map_err(|error| error.to_string())?;
    Ok(serde_json::from_slice(&bytes).unwrap())
}

#[test]
fn index_lists_share_the_vertices_of_another_mesh() {
    let scene = with_second_entry(&scenes::with_unknown_references());
    let writer = SceneWriter::new(&scene).with_shared_mesh(1, shared(vec![vec![0, 1, 2, 2, 1, 3]]));
    let json = json_of(&writer).unwrap();
    let [first, second] = [0, 1].map(|mesh| json["meshes"][mesh]["primitives"][0].clone());
    assert_eq!(first["attributes"], second["attributes"]);
    let accessor = second["indices"].as_u64().unwrap() as usize;
    assert_eq!(json["accessors"][accessor]["count"], 6);
    let again = read_scene_bytes(json.to_string().as_bytes(), &Source::new("a.gltf")).unwrap();
    assert_eq!(again.meshes()[1].as_ref().unwrap().triangle_count(), 2);
}

#[test]
fn a_shared_mesh_without_triangles_shows_one_point() {
    let scene = with_second_entry(&scenes::with_unknown_references());
    let json = json_of(&SceneWriter::new(&scene).with_shared_mesh(1, shared(vec![vec![]]))).unwrap();
    assert_eq!(json["meshes"][1]["primitives"].as_array().unwrap().len(), 1);
    assert!(read_scene_bytes(json.to_string().as_bytes(), &Source::new("a.gltf")).is_ok());
}

#[test]
fn shared_meshes_that_do_not_fit_are_refused() {
    let scene = with_second_entry(&scenes::with_unknown_references());
    let error =
        |shared: SharedMesh| json_of(&SceneWriter::new(&scene).with_shared_mesh(1, shared)).unwrap_err();
    assert!(error(shared(vec![])).ends_with("meshes[1]: 0 index lists for 1 triangle primitives"));
    assert!(error(shared(vec![vec![0, 1]])).ends_with("meshes[1]: 2 indices do not form triangles"));
    let few = SharedMesh { vertex_count: 2, ..shared(vec![vec![0, 1, 2]]) };
    assert!(error(few).ends_with("meshes[1]: vertex 2 of 2"));
    let itself = SharedMesh { vertices_of: 1, ..shared(vec![vec![]]) };
    assert!(error(itself).ends_with("meshes[1] shows nothing"));
    assert!(SceneWriter::new(&scene).to_bytes(Format::Stl, &WriteOptions::default()).is_err());
}

#[test]
fn attachments_come_back_from_the_extension_of_their_mesh() {
    let mut parts = read(&scenes::hierarchy()).into_parts();
    parts.document["meshes"][1]["extensions"] = json!({ "VENDOR_data": { "bufferView": 0, "size": 3 } });
    let scene = Scene::from_parts(parts).unwrap();
    let pointer = "/meshes/1/extensions/VENDOR_data/bufferView";
    let writer = SceneWriter::new(&scene).with_attachment(pointer, &b"attached"[..]);
    for format in [Format::Gltf, Format::Glb] {
        let bytes = writer.to_bytes(format, &WriteOptions::default()).unwrap();
        let found = mesh_data(&bytes, &Source::new("a.glb"), "VENDOR_data").unwrap();
        assert_eq!((found.len(), found[0].is_some(), found[2].is_some()), (3, false, false));
        let data = found[1].as_ref().unwrap();
        assert_eq!((&data.bytes[..], &data.extension["size"]), (&b"attached"[..], &json!(3)));
    }
    let missing = SceneWriter::new(&scene).with_attachment("/nowhere/at", &b"attached"[..]);
    assert!(json_of(&missing).unwrap_err().ends_with("the document has no value at /nowhere/at"));
}

#[test]
fn empty_primitives_keep_their_places_on_request() {
    let scene = read(&scenes::hierarchy());
    let meshes = scene.meshes().iter().cloned().map(|mesh| {
        let mut mesh = mesh?;
        if let [first, second] = &mut mesh.groups[..] {
            // The second primitive loses its triangles.
            mesh.triangles.truncate(first.count as usize);
            second.count = 0;
        }
        Some(mesh)
    });
    let meshes = meshes.collect();
    let scene = scene.with_meshes(meshes).unwrap();
    let count = |writer: &SceneWriter<'_>| {
        json_of(writer).unwrap()["meshes"][0]["primitives"].as_array().unwrap().len()
    };
    assert_eq!(count(&SceneWriter::new(&scene)), 1);
    assert_eq!(count(&SceneWriter::new(&scene).keeping_primitives()), 2);
}

#[test]
fn rounded_weights_are_written_with_a_sum_of_one() {
    use striata::mesh::{LayerData, Semantic};
    let scene = read(&scenes::skinned());
    let mut mesh = scene.meshes()[0].clone().unwrap();
    let exact = mesh.layer(&Semantic::Weights(0)).unwrap().clone();
    let layer = mesh.layers.iter_mut().find(|layer| layer.semantic == Semantic::Weights(0)).unwrap();
    let LayerData::F32(weights) = &mut layer.data else { panic!("weights are floats") };
    weights.iter_mut().for_each(|weight| *weight *= 1.001);
    let written = |scene: Scene| {
        let bytes = SceneWriter::new(&scene).to_bytes(Format::Glb, &WriteOptions::default()).unwrap();
        let again = read_scene_bytes(&bytes, &Source::new("a.glb")).unwrap();
        again.meshes()[0].as_ref().unwrap().layer(&Semantic::Weights(0)).unwrap().clone()
    };
    assert_eq!(written(scene.clone()), exact);
    let normalized = written(scene.with_meshes(vec![Some(mesh)]).unwrap());
    for vertex in 0..exact.data.len() / 4 {
        let total: f64 = (0..4).map(|c| f64::from(normalized.get(vertex, c))).sum();
        assert!((total - 1.0).abs() < 4e-7, "vertex {vertex}: {total}");
    }
}
