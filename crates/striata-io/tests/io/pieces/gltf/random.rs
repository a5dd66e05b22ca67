//! Random scenes: everything at once.

use proptest::prelude::*;
use serde_json::{Value, json};
use striata_io::{Format, QuantizeOptions, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_testing::scenes::TestScene;
use striata_testing::support::Random;

use super::scene::{Numbers, width};
use super::{check_bytes, check_file, with_files};

/// A scene of random meshes under random nodes.
pub(super) fn scene(random: &mut Random) -> TestScene {
    let mut scene = TestScene::named("random");
    scene.document["materials"] = json!([{ "name": "a" }, { "name": "b" }]);
    let mesh_count = 1 + random.below(3);
    for _ in 0..mesh_count {
        push_mesh(&mut scene, random);
    }
    if random.below(8) > 0 {
        push_nodes(&mut scene, mesh_count, random);
    }
    scene
}

/// Adds an accessor of random values, perhaps with gaps or replacements; the type is one of these.
fn push_values(
    scene: &mut TestScene,
    count: usize,
    kind: &'static str,
    types: &[(u32, bool)],
    random: &mut Random,
) -> usize {
    let (component, normalized) = types[random.below(types.len())];
    let mut numbers = Numbers::new(component, kind).with_gap([0, 0, 4, 1][random.below(4)]);
    if normalized {
        numbers = numbers.normalized();
    }
    if random.below(6) == 0 {
        let replaced: Vec<usize> = (0..count).filter(|_| random.below(4) == 0).collect();
        numbers = numbers.sparse(&replaced);
    }
    let values: Vec<f64> = (0..count * width(kind)).map(|_| random.below(100) as f64).collect();
    numbers.push(scene, &values)
}

const FLOATS: (u32, bool) = (5126, false);

fn push_attributes(scene: &mut TestScene, count: usize, random: &mut Random) -> (Value, Vec<Value>) {
    let positions = [FLOATS, FLOATS, (5122, false), (5123, true), (5121, false), (5120, true)];
    let mut attributes = json!({ "POSITION": push_values(scene, count, "VEC3", &positions, random) });
    let color = ["VEC3", "VEC4"][random.below(2)];
    let fractions = [FLOATS, (5121, true), (5123, true)];
    let identifiers = [FLOATS, (5121, false), (5123, false), (5125, false)];
    let directions = [FLOATS, FLOATS, (5120, true), (5122, true)];
    for (name, kind, types) in [
        ("NORMAL", "VEC3", &directions[..]),
        ("TANGENT", "VEC4", &directions),
        ("TEXCOORD_0", "VEC2", &fractions),
        ("COLOR_0", color, &fractions),
        ("_ID", "SCALAR", &identifiers),
    ] {
        if random.below(2) == 0 {
            attributes[name] = json!(push_values(scene, count, kind, types, random));
        }
    }
    if random.below(3) == 0 {
        let joints: Vec<f64> = (0..4 * count).map(|_| random.below(3) as f64).collect();
        let component = [5121, 5123][random.below(2)];
        attributes["JOINTS_0"] = json!(Numbers::new(component, "VEC4").push(scene, &joints));
        attributes["WEIGHTS_0"] = json!(push_values(scene, count, "VEC4", &fractions, random));
    }
    let mut targets = Vec::new();
    for _ in 0..random.below(3) {
        let mut target = json!({});
        for name in ["POSITION", "NORMAL", "TANGENT"] {
            if random.below(2) == 0 {
                target[name] = json!(push_values(scene, count, "VEC3", &directions, random));
            }
        }
        targets.push(target);
    }
    (attributes, targets)
}

/// Adds a mesh whose primitives share some of their vertices.
fn push_mesh(scene: &mut TestScene, random: &mut Random) {
    let mut sets = Vec::new();
    for _ in 0..1 + random.below(2) {
        let count = 3 + random.below(60);
        sets.push((count, push_attributes(scene, count, random)));
    }
    let mut primitives = Vec::new();
    for _ in 0..1 + random.below(4) {
        let (count, (attributes, targets)) = &sets[random.below(sets.len())];
        let mode = [0, 4, 4, 4, 4, 5, 5, 6, 6, 6][random.below(10)];
        let mut primitive = json!({ "attributes": attributes, "mode": mode });
        if !targets.is_empty() {
            primitive["targets"] = json!(targets);
        }
        if random.below(4) > 0 {
            // Few different numbers in a row, so that strips have degenerate triangles.
            let index_count = random.below(120);
            let values: Vec<f64> = (0..index_count).map(|_| random.below(*count) as f64).collect();
            let mut numbers = Numbers::new([5121, 5123, 5125][random.below(3)], "SCALAR");
            if random.below(5) == 0 {
                numbers = numbers.sparse(&(0..index_count).step_by(3).collect::<Vec<_>>());
            }
            primitive["indices"] = json!(numbers.push(scene, &values));
        }
        if random.below(2) == 0 {
            primitive["material"] = json!(random.below(2));
        }
        primitives.push(primitive);
    }
    let mut mesh = json!({ "primitives": primitives, "weights": [0.5, -0.25] });
    if random.below(2) == 0 {
        mesh["name"] = json!(["a mesh", "another"][random.below(2)]);
    }
    scene.push("meshes", mesh);
}

fn push_nodes(scene: &mut TestScene, mesh_count: usize, random: &mut Random) {
    let count = 1 + random.below(7);
    let mut nodes: Vec<Value> = Vec::new();
    for index in 0..count {
        let mut node = json!({ "children": [] });
        let mut small = || random.below(9) as f64 / 2.0 - 2.0;
        let (x, y, z) = (small(), small(), small());
        match random.below(4) {
            0 => {}
            1 => node["translation"] = json!([x, y, z]),
            2 => node["scale"] = json!([x, 1.5, -0.5]),
            _ => {
                node["rotation"] = json!([0.5, -0.5, 0.5, 0.5]);
                node["translation"] = json!([x, y, z]);
            }
        }
        if random.below(4) > 0 {
            node["mesh"] = json!(random.below(mesh_count));
            match random.below(6) {
                0 => node["skin"] = json!(0),
                1 => {
                    let places: Vec<f64> = (0..9).map(|_| random.below(9) as f64).collect();
                    let places = Numbers::new(5126, "VEC3").push(scene, &places);
                    let instancing = json!({ "attributes": { "TRANSLATION": places } });
                    node["extensions"] = json!({ "EXT_mesh_gpu_instancing": instancing });
                }
                2 => node["weights"] = json!([0.0, 0.75]),
                _ => {}
            }
        }
        if index > 0 {
            let parent = &mut nodes[random.below(index)]["children"];
            parent.as_array_mut().unwrap().push(json!(index));
        }
        nodes.push(node);
    }
    for node in &mut nodes {
        if node["children"].as_array().unwrap().is_empty() {
            node.as_object_mut().unwrap().remove("children");
        }
    }
    let joints: Vec<usize> = (0..3).map(|_| random.below(count)).collect();
    scene.document["nodes"] = json!(nodes);
    scene.document["skins"] = json!([{ "joints": joints }]);
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
}

proptest! {
    #![proptest_config(striata_testing::cases(400))]

    #[test]
    fn random_scenes_are_the_same_in_pieces(seed in any::<u64>(), size in 1u32..200) {
        let mut random = Random::new(seed);
        let scene = scene(&mut random);
        check_bytes(&scene.to_glb(), &[size, 1 + size / 7]);
        let folder = tempfile::tempdir().unwrap();
        check_file(&with_files(&scene, folder.path()), &[size]);
    }

    #[test]
    fn random_scenes_are_the_same_in_compressed_pieces(seed in any::<u64>(), size in 1u32..200) {
        check_compressed(seed, size);
    }
}

/// Compares the pieces of a random scene with the whole, in each form that the writer has.
fn check_compressed(seed: u64, size: u32) {
    let scene = scene(&mut Random::new(seed)).to_glb();
    // Some draw only points and lines.
    let Ok(scene) = read_scene_bytes(&scene, &Source::new("x.glb")) else { return };
    let plain = WriteOptions::default();
    let quantized = plain.clone().with_quantize(QuantizeOptions::default());
    for options in [
        quantized.clone(),
        plain.clone().with_meshopt(cfg!(feature = "meshopt")),
        quantized.with_meshopt(cfg!(feature = "meshopt")),
        plain.with_draco(cfg!(feature = "draco")),
    ] {
        // Not everything can be written.
        if let Ok(bytes) = scene_to_bytes(Format::Glb, &scene, &options) {
            check_bytes(&bytes, &[size]);
        }
    }
}

/// A mesh so small that it is far from zero: its translation is its origin, and leaves no transform.
#[test]
fn a_translation_that_is_the_origin() {
    check_compressed(16_213_598_557_056_892_453, 1);
}
