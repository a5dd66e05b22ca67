//! glTF files with chains of `MSFT_lod`.

use std::collections::BTreeSet;

use serde_json::Value;
use striata::mesh::shapes;
use striata::strip::fifo_cache_cost;
use striata::{LodOptions, Target};
use striata_io::{Format, Scene, Source, read_scene_bytes};
use striata_scene::{LodChainOptions, LodScene, SceneLevel, lod_chain};
use striata_testing::scenes::{self, TestScene};

fn build(scene: &TestScene) -> LodScene {
    let scene = read_scene_bytes(&scene.to_glb(), &Source::new("test.glb")).unwrap();
    LodScene::build(&scene, &LodOptions::default()).unwrap()
}

fn levels(lods: &LodScene) -> Vec<SceneLevel> {
    [0.1, 0.5, 0.25].map(|detail| lods.level(Target::Detail(detail))).to_vec()
}

fn chain_json(sample: &TestScene) -> (LodScene, Value) {
    let lods = build(sample);
    let options = LodChainOptions::default().with_format(Format::Gltf);
    let bytes = lod_chain(&lods, &levels(&lods), &options, None).unwrap().bytes;
    (lods, serde_json::from_slice(&bytes).unwrap())
}

fn indices(value: &Value, pointer: &str) -> Vec<usize> {
    let list = value.pointer(pointer).and_then(Value::as_array);
    list.into_iter().flatten().map(|index| index.as_u64().unwrap() as usize).collect()
}

/// Nodes with chains, with their levels.
fn chains(json: &Value) -> Vec<(usize, Vec<usize>)> {
    let nodes = json["nodes"].as_array().cloned().unwrap_or_default();
    let chain = |(node, value): (usize, &Value)| (node, indices(value, "/extensions/MSFT_lod/ids"));
    nodes.iter().enumerate().map(chain).filter(|(_, ids)| !ids.is_empty()).collect()
}

#[test]
fn every_node_with_levels_has_a_chain_of_falling_coverages() {
    for sample in scenes::all() {
        let (lods, json) = chain_json(&sample);
        let chains = chains(&json);
        assert_eq!(chains.is_empty(), lods.lods().iter().all(Option::is_none), "{}", sample.name);
        for (node, ids) in &chains {
            let node = &json["nodes"][node];
            let coverages = node["extras"]["MSFT_screencoverage"].as_array().unwrap();
            assert_eq!(coverages.len(), ids.len() + 1);
            let coverages: Vec<f64> = coverages.iter().map(|x| x.as_f64().unwrap()).collect();
            assert!(coverages.windows(2).all(|pair| pair[0] >= pair[1]), "{coverages:?}");
            assert!(coverages[0] <= 1.0 && coverages[ids.len()] == 0.0);
            for id in ids {
                for key in ["matrix", "translation", "rotation", "scale"] {
                    assert_eq!(json["nodes"][id].get(key), node.get(key), "{}", sample.name);
                }
                if json["nodes"][id].get("mesh").is_some() {
                    assert_eq!(json["nodes"][id].get("skin"), node.get("skin"));
                    assert_eq!(json["nodes"][id].get("weights"), node.get("weights"));
                }
            }
        }
    }
}

#[test]
fn the_levels_are_not_part_of_any_scene() {
    for sample in scenes::all() {
        let (lods, json) = chain_json(&sample);
        let levels: BTreeSet<usize> = chains(&json).into_iter().flat_map(|(_, ids)| ids).collect();
        let nodes = json["nodes"].as_array().cloned().unwrap_or_default();
        let children = nodes.iter().flat_map(|node| indices(node, "/children"));
        let scenes = json["scenes"].as_array().cloned().unwrap_or_default();
        let roots: Vec<usize> = scenes.iter().flat_map(|scene| indices(scene, "/nodes")).collect();
        assert!(children.chain(roots).all(|node| !levels.contains(&node)), "{}", sample.name);
        // Viewers without the extension show what they showed before.
        let again = read_scene_bytes(json.to_string().as_bytes(), &Source::new("chain.gltf")).unwrap();
        assert_eq!(again.triangle_count(), lods.full_scene().triangle_count(), "{}", sample.name);
        let close = |a: f32, b: f32| (a - b).abs() <= 1e-5 * (1.0 + a.abs());
        if let (Some(found), Some(expected)) = (again.bounds(), lods.full_scene().bounds()) {
            let pairs = found.min.iter().zip(expected.min).chain(found.max.iter().zip(expected.max));
            assert!(pairs.into_iter().all(|(&a, b)| close(a, b)), "{}", sample.name);
        }
    }
}

#[test]
fn all_levels_of_a_mesh_share_its_vertices() {
    for sample in scenes::all() {
        let (lods, json) = chain_json(&sample);
        for (node, ids) in chains(&json) {
            let mesh_of = |node: usize| {
                let mesh = json["nodes"][node].get("mesh")?.as_u64()? as usize;
                json["meshes"][mesh]["primitives"].as_array()
            };
            let full = mesh_of(node).unwrap();
            let mut fewest = usize::MAX;
            for id in ids {
                let Some(primitives) = mesh_of(id) else { continue };
                let mut count = 0;
                for primitive in primitives.iter().filter(|p| p.get("indices").is_some()) {
                    let original = full.iter().find(|other| {
                        other.get("material") == primitive.get("material") && other.get("indices").is_some()
                    });
                    assert_eq!(original.unwrap()["attributes"], primitive["attributes"], "{}", sample.name);
                    assert_eq!(original.unwrap().get("targets"), primitive.get("targets"));
                    let accessor = primitive["indices"].as_u64().unwrap() as usize;
                    count += json["accessors"][accessor]["count"].as_u64().unwrap() as usize;
                }
                assert!(count < fewest, "{}", sample.name);
                fewest = count;
            }
        }
        let bytes = json["buffers"][0]["byteLength"].as_u64().unwrap_or(0) as usize;
        let full = lods.full_scene();
        let vertices: usize = full.meshes().iter().flatten().map(|mesh| mesh.vertex_count()).sum();
        let triangles: usize = full.meshes().iter().flatten().map(|mesh| mesh.triangle_count()).sum();
        // Joints and weights take 24 bytes, two morph targets as well; nothing is stored twice.
        assert!(bytes <= vertices * 72 + triangles * 6 * 2 + 1000, "{}: {bytes}", sample.name);
    }
}

#[test]
fn nodes_that_do_more_than_show_a_mesh_keep_their_place() {
    let (_, json) = chain_json(&scenes::hierarchy());
    // The node with children got another one, which has the mesh.
    let right = &json["nodes"][2];
    assert_eq!(right.get("mesh"), None);
    let child = indices(right, "/children")[2];
    assert_eq!(json["nodes"][child]["mesh"], 0);
    // So did the node with the light, which keeps it.
    assert!(json["nodes"][3]["extensions"].get("KHR_lights_punctual").is_some());
    assert_eq!(json["nodes"][3].get("mesh"), None);
    // The node with nothing else has the chain itself, and keeps its extras.
    let left = &json["nodes"][1];
    assert_eq!((&left["mesh"], &left["extras"]["tag"]), (&0.into(), &"kept".into()));
    let level = indices(left, "/extensions/MSFT_lod/ids")[0];
    assert_eq!(json["nodes"][level]["name"], "left_LOD1");
}

#[test]
fn animated_weights_drive_all_levels() {
    let (_, json) = chain_json(&scenes::morphed());
    let channels = json["animations"][0]["channels"].as_array().unwrap();
    let mut targets = BTreeSet::new();
    for channel in channels {
        let target = &channel["target"];
        let node = target["node"].as_u64().unwrap();
        assert!(targets.insert((node, target["path"].to_string())), "two channels for node {node}");
        if target["path"] == "weights" {
            assert!(json["nodes"][node as usize].get("mesh").is_some());
        }
    }
    let weights = targets.iter().filter(|(_, path)| path.contains("weights")).count();
    // Two nodes, each with the full mesh and three levels.
    assert_eq!(weights, 8);
    assert!(targets.contains(&(2, "\"translation\"".to_owned())));
}

#[test]
fn instancing_by_an_extension_applies_to_all_levels() {
    let (_, json) = chain_json(&scenes::instanced_by_extension());
    for level in &chains(&json)[0].1 {
        let instancing = &json["nodes"][level]["extensions"]["EXT_mesh_gpu_instancing"];
        assert_eq!(instancing, &json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]);
    }
}

#[test]
fn equal_levels_are_written_once_and_old_chains_replaced() {
    let lods = build(&scenes::skinned());
    let coarse = lods.level(Target::Detail(0.2));
    let options = LodChainOptions::default();
    let twice = [coarse.clone(), lods.level(Target::Detail(1.0)), coarse];
    let bytes = lod_chain(&lods, &twice, &options, None).unwrap().bytes;
    let scene = read_scene_bytes(&bytes, &Source::new("chain.glb")).unwrap();
    assert_eq!(scene.meshes().len(), 2);
    let again = LodScene::build(&scene, &LodOptions::default()).unwrap();
    let bytes = lod_chain(&again, &levels(&again), &options, None).unwrap().bytes;
    let document = read_scene_bytes(&bytes, &Source::new("chain.glb")).unwrap();
    assert_eq!(chains(document.document()).len(), 1);
    let bytes = lod_chain(&lods, &[], &options, None).unwrap().bytes;
    assert!(!String::from_utf8_lossy(&bytes).contains("MSFT_lod"));
    assert!(lod_chain(&lods, &[], &options.with_format(Format::Ply), None).is_err());
}

#[test]
fn every_level_is_in_cache_order() {
    let scene = Scene::from_mesh(shapes::terrain(48, 3)).unwrap();
    let lods = LodScene::build(&scene, &LodOptions::default()).unwrap();
    let bytes = lod_chain(&lods, &levels(&lods), &LodChainOptions::default(), None).unwrap().bytes;
    let scene = read_scene_bytes(&bytes, &Source::new("chain.glb")).unwrap();
    assert_eq!(scene.meshes().len(), 4);
    for mesh in scene.meshes().iter().flatten() {
        let cost = fifo_cache_cost(mesh.triangles.as_flattened(), mesh.triangle_count(), 16);
        assert!(cost.acmr < 0.9, "{} triangles: {}", mesh.triangle_count(), cost.acmr);
    }
}
