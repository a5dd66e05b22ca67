//! Writes the textured scene of the demo: an amphora that turns on a potter's wheel.
//!
//! ```sh
//! cargo run --release -p striata-scene --example write_amphora -- crates/striata-cli/assets/amphora.glb
//! ```

mod paint;
mod shape;

use serde_json::{Value, json};
use striata_io::{Format, QuantizeOptions, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_testing::scenes::TestScene;

/// Seconds of one turn.
const TURN_SECS: f32 = 12.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).ok_or("usage: write_amphora OUT.glb")?;
    let mut scene = TestScene::named("amphora");
    let vase = scene.push_mesh("vase", &shape::vase());
    let handle = scene.push_mesh("handle", &shape::handle());
    let wheel = scene.push_mesh("wheel", &shape::wheel());
    let stand = scene.push_mesh("stand", &shape::stand());
    add_nodes(&mut scene, [vase, handle, wheel, stand]);
    add_materials(&mut scene, [vase, handle, wheel, stand]);
    let scene = read_scene_bytes(&scene.to_glb(), &Source::new("amphora.glb"))?;
    let options = WriteOptions::default().with_quantize(QuantizeOptions::default()).with_meshopt(true);
    std::fs::write(path, scene_to_bytes(Format::Glb, &scene, &options)?)?;
    Ok(())
}

/// Adds the nodes: a stand, and on it the wheel, which turns with the vase and its two handles.
fn add_nodes(scene: &mut TestScene, [vase, handle, wheel, stand]: [usize; 4]) {
    scene.document["nodes"] = json!([
        { "name": "pottery", "children": [1, 2] },
        { "name": "stand", "mesh": stand },
        { "name": "turning", "children": [3, 4, 5, 6] },
        { "name": "wheel", "mesh": wheel },
        { "name": "vase", "mesh": vase, "translation": [0.0, shape::WHEEL_TOP, 0.0] },
        { "name": "left handle", "mesh": handle, "translation": [0.0, shape::WHEEL_TOP, 0.0] },
        { "name": "right handle", "mesh": handle, "translation": [0.0, shape::WHEEL_TOP, 0.0],
          "rotation": [0.0, 1.0, 0.0, 0.0] },
    ]);
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    scene.document["scene"] = json!(0);
    let times: Vec<f32> = (0..=4).map(|quarter| TURN_SECS * quarter as f32 / 4.0).collect();
    let half = std::f32::consts::FRAC_1_SQRT_2;
    let turns: Vec<f32> = [[0.0, 1.0], [half, half], [1.0, 0.0], [half, -half], [0.0, -1.0]]
        .iter()
        .flat_map(|[sin, cos]| [0.0, *sin, 0.0, *cos])
        .collect();
    let (times, turns) = (scene.push_floats("SCALAR", 1, &times), scene.push_floats("VEC4", 4, &turns));
    let channels = json!([{ "sampler": 0, "target": { "node": 2, "path": "rotation" } }]);
    let samplers = json!([{ "input": times, "output": turns }]);
    scene.push("animations", json!({ "name": "turn", "channels": channels, "samplers": samplers }));
}

/// Adds images and materials: painted clay, plain clay, wood and iron.
fn add_materials(scene: &mut TestScene, meshes: [usize; 4]) {
    let texture = |scene: &mut TestScene, name: &str, image: image::RgbImage| {
        let view = scene.push_view(&paint::jpeg(&image));
        let source =
            scene.push("images", json!({ "bufferView": view, "mimeType": "image/jpeg", "name": name }));
        let sampler = json!({ "magFilter": 9729, "minFilter": 9987, "wrapS": 10497, "wrapT": 10497 });
        if scene.document["samplers"].is_null() {
            scene.push("samplers", sampler);
        }
        scene.push("textures", json!({ "source": source, "sampler": 0 }))
    };
    let figures = texture(scene, "vase color", paint::vase_color());
    let relief = texture(scene, "vase relief", paint::vase_relief());
    let gloss = texture(scene, "vase gloss", paint::vase_gloss());
    let grain = texture(scene, "wood", paint::wood());
    let use_of = |index: usize| json!({ "index": index });
    let painted: Value = json!({
        "name": "painted clay", "normalTexture": use_of(relief),
        "pbrMetallicRoughness": { "baseColorTexture": use_of(figures), "metallicRoughnessTexture": use_of(gloss) },
    });
    let plain = |name: &str, color: [f32; 3], metallic: f32, roughness: f32| {
        let [r, g, b] = color;
        let factors = json!({
            "baseColorFactor": [r, g, b, 1.0], "metallicFactor": metallic, "roughnessFactor": roughness,
        });
        json!({ "name": name, "pbrMetallicRoughness": factors })
    };
    let mut wood = plain("wood", [1.0; 3], 0.0, 0.6);
    wood["pbrMetallicRoughness"]["baseColorTexture"] = use_of(grain);
    let materials = [painted, plain("black glaze", [0.02, 0.017, 0.016], 0.0, 0.3), wood];
    let iron = plain("iron", [0.42, 0.4, 0.38], 1.0, 0.45);
    for (mesh, material) in meshes.into_iter().zip(materials.into_iter().chain([iron])) {
        let material = scene.push("materials", material);
        scene.document["meshes"][mesh]["primitives"][0]["material"] = json!(material);
    }
}
