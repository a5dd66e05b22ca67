//! Writes `assets/arm.glb`, the scene of the guide: a textured arm that bends, and three balls that share
//! one mesh.
//!
//! ```sh
//! cargo run --release -p striata-scene --example write_arm -- assets/arm.glb
//! ```

use std::io::Cursor;

use serde_json::{Value, json};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, shapes};
use striata_io::{Format, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_testing::scenes::TestScene;

/// Joints of the arm.
const JOINTS: usize = 4;

/// Height and radius of the arm.
const ARM: [f32; 2] = [4.0, 0.35];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("usage: write_arm OUT.glb")?;
    let mut scene = TestScene::named("arm");
    let arm = scene.push_mesh("arm", &arm());
    let ball = scene.push_mesh("ball", &shapes::icosphere(4, 0.4));
    add_nodes(&mut scene, arm, ball);
    add_materials(&mut scene, arm, ball);
    let scene = read_scene_bytes(&scene.to_glb(), &Source::new("arm.glb"))?;
    let options = WriteOptions::default().with_meshopt(true);
    std::fs::write(path, scene_to_bytes(Format::Glb, &scene, &options)?)?;
    Ok(())
}

/// A cylinder with weights for the joints along it.
fn arm() -> IndexedMesh {
    let mut mesh = shapes::uv_cylinder(48, 64);
    let [height, radius] = ARM;
    let (mut joints, mut weights) = (Vec::new(), Vec::new());
    // The cylinder lies along z, and the arm stands along y.
    for position in &mut mesh.positions {
        let [x, y, along] = *position;
        *position = [x * radius, along * height, -y * radius];
        let at = along * (JOINTS - 1) as f32;
        let lower = (at as usize).min(JOINTS - 2);
        let shares = [lower as f32 + 1.0 - at, at - lower as f32];
        // A joint without weight has number 0.
        let joint = |which: usize| if shares[which] > 0.0 { (lower + which) as u16 } else { 0 };
        joints.extend([joint(0), joint(1), 0, 0]);
        weights.extend([shares[0], shares[1], 0.0, 0.0]);
    }
    for layer in mesh.layers.iter_mut().filter(|layer| layer.semantic == Semantic::Normal) {
        if let LayerData::F32(normals) = &mut layer.data {
            normals.as_chunks_mut::<3>().0.iter_mut().for_each(|[_, y, z]| (*y, *z) = (*z, -*y));
        }
    }
    let layer = |semantic, data| AttributeLayer { semantic, component_count: 4, normalized: false, data };
    mesh.layers.push(layer(Semantic::Joints(0), LayerData::U16(joints)));
    mesh.layers.push(layer(Semantic::Weights(0), LayerData::F32(weights)));
    mesh
}

/// Adds the joints with their animation, the balls, and a camera.
fn add_nodes(scene: &mut TestScene, arm: usize, ball: usize) {
    let part = ARM[0] / (JOINTS - 1) as f32;
    let mut nodes = vec![json!({ "name": "arm", "mesh": arm, "skin": 0 })];
    let mut binds = Vec::new();
    for joint in 0..JOINTS {
        let (name, height) = (format!("joint {joint}"), if joint == 0 { 0.0 } else { part });
        let mut node = json!({ "name": name, "translation": [0.0, height, 0.0] });
        if joint + 1 < JOINTS {
            node["children"] = json!([joint + 2]);
        }
        nodes.push(node);
        let down = -part * joint as f32;
        binds.extend([1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, down, 0.0, 1.0]);
    }
    for (name, place, size) in [("left", -1.5, 1.0), ("right", 1.5, 1.0), ("small", 2.4, 0.4)] {
        let place = [place, 0.4 * size, 0.0];
        nodes.push(json!({ "name": name, "mesh": ball, "translation": place, "scale": [size, size, size] }));
    }
    nodes.push(json!({ "name": "eye", "camera": 0, "translation": [0.0, 2.0, 8.0] }));
    let roots: Vec<usize> = (0..nodes.len()).filter(|&node| !(2..=JOINTS).contains(&node)).collect();
    scene.document["nodes"] = Value::Array(nodes);
    scene.document["scenes"] = json!([{ "nodes": roots }]);
    scene.document["scene"] = json!(0);
    let camera = json!({ "yfov": 0.8, "znear": 0.1 });
    scene.document["cameras"] = json!([{ "type": "perspective", "perspective": camera }]);
    let binds = scene.push_floats("MAT4", 16, &binds);
    let joints: Vec<usize> = (1..=JOINTS).collect();
    scene.push("skins", json!({ "joints": joints, "inverseBindMatrices": binds }));
    let times = scene.push_floats("SCALAR", 1, &[0.0, 1.0, 2.0]);
    let [cos, sin] = [0.25f32.cos(), 0.25f32.sin()];
    let turns = scene.push_floats("VEC4", 4, &[0.0, 0.0, -sin, cos, 0.0, 0.0, sin, cos, 0.0, 0.0, -sin, cos]);
    let channel = |node: usize| json!({ "sampler": 0, "target": { "node": node, "path": "rotation" } });
    let channels: Vec<Value> = (2..=JOINTS).map(channel).collect();
    let samplers = json!([{ "input": times, "output": turns }]);
    scene.push("animations", json!({ "name": "wave", "channels": channels, "samplers": samplers }));
}

/// Gives the arm stripes, and the balls a color.
fn add_materials(scene: &mut TestScene, arm: usize, ball: usize) {
    let view = scene.push_view(&stripes());
    scene.push("images", json!({ "bufferView": view, "mimeType": "image/png", "name": "stripes" }));
    scene.push("textures", json!({ "source": 0 }));
    let striped = json!({ "baseColorTexture": { "index": 0 }, "metallicFactor": 0.0 });
    scene.push("materials", json!({ "name": "striped", "pbrMetallicRoughness": striped }));
    let red = json!({ "baseColorFactor": [0.8, 0.2, 0.1, 1.0], "metallicFactor": 0.0 });
    scene.push("materials", json!({ "name": "red", "pbrMetallicRoughness": red }));
    for (material, mesh) in [arm, ball].into_iter().enumerate() {
        scene.document["meshes"][mesh]["primitives"][0]["material"] = json!(material);
    }
}

/// A PNG file with stripes along the arm and a fine pattern.
fn stripes() -> Vec<u8> {
    let image = image::RgbImage::from_fn(256, 256, |x, y| {
        let [stripe, dot] = [(y / 32) % 2, u32::from((x / 8 + y / 8) % 2 == 0)];
        image::Rgb([(40 + 180 * stripe + 20 * dot) as u8, (120 + 20 * dot) as u8, (200 - 150 * stripe) as u8])
    });
    let mut bytes = Cursor::new(Vec::new());
    image.write_to(&mut bytes, image::ImageFormat::Png).expect("a small image can be encoded");
    bytes.into_inner()
}
