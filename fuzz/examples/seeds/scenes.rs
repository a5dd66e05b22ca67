//! Inputs for the targets of scenes and compressed glTF.

use std::error::Error;

use serde_json::Value;
use striata::LodOptions;
use striata::file::WriteOptions;
use striata::mesh::{Random, shapes};
use striata_fuzz::unpacked;
use striata_io::{Format, QuantizeOptions, Scene, Source, read_scene_bytes, scene_to_bytes};
use striata_scene::stream::{SceneStreamOptions, encode_scene};
use striata_scene::{GlbStreamOptions, LodScene};
use striata_testing::scenes;
use striata_testing::strange::StrangeParts;

/// Target, file name and contents of each input.
pub type Input = (&'static str, String, Vec<u8>);

/// Checks that an input of `scene` asks for.
const ALL_CHECKS: u8 = 15;

/// Returns the inputs of all targets that concern scenes.
pub fn inputs() -> Result<Vec<Input>, Box<dyn Error>> {
    let mut inputs = Vec::new();
    for (number, scene) in scenes::all().iter().enumerate() {
        let name = scene.name;
        let glb = scene.to_glb();
        let parts = StrangeParts::of_glb(&glb);
        inputs.push(("scene", name.to_owned(), vec![number as u8, ALL_CHECKS]));
        let text = parts.document.to_string().into_bytes();
        let plain = [&[scenes::all().len() as u8, 0][..], &text, &[0], &parts.buffer].concat();
        inputs.push(("scene", format!("{name}.txt"), plain));
        inputs.push(("glb_stream", name.to_owned(), vec![number as u8]));
        // Changes of every kind, because libFuzzer would take long to reach such a length.
        let mut random = Random::new(number as u64);
        let changes = std::iter::repeat_with(|| random.between(0.0, 256.0) as u8).take(48);
        inputs.push((
            "glb_stream",
            format!("{name}.changed"),
            [number as u8].into_iter().chain(changes).collect(),
        ));
        let scene = read_scene_bytes(&glb, &Source::new("scene.glb"))?;
        let stream = encode_scene(&scene, &SceneStreamOptions::default())?;
        inputs.push((
            "scene_stream",
            name.to_owned(),
            [&[60, 90, 20][..], &unpacked(&stream.bytes)].concat(),
        ));
        inputs.extend(compressed(name, &scene)?);
        let lods = LodScene::build(&scene, &LodOptions::default())?;
        inputs.push(("scene_file", format!("{name}.striata"), lods.to_striata(&WriteOptions::default())?));
        inputs.push((
            "scene_file",
            format!("{name}.glb"),
            lods.to_glb_with_stream(&GlbStreamOptions::default())?,
        ));
    }
    let small = Scene::from_mesh(shapes::torus(8, 6, 1.0, 0.4))?;
    inputs.extend(compressed("torus", &small)?);
    Ok(inputs)
}

/// Returns the compressed views of a scene that is written with each compression.
fn compressed(name: &str, scene: &Scene) -> Result<Vec<Input>, Box<dyn Error>> {
    let mut inputs = Vec::new();
    let exact = striata_io::WriteOptions::default();
    let rounded = exact.clone().with_quantize(QuantizeOptions::default());
    for (form, options) in [("exact", exact), ("rounded", rounded)] {
        let meshopt = scene_to_bytes(Format::Glb, scene, &options.clone().with_meshopt(true))?;
        let parts = StrangeParts::of_glb(&meshopt);
        for (view, entry) in entries(&parts.document, "bufferViews").enumerate() {
            let Some(extension) = entry.pointer("/extensions/EXT_meshopt_compression") else { continue };
            let input = [&meshopt_head(extension)[..], range(&parts.buffer, extension)].concat();
            inputs.push(("gltf_meshopt", format!("{name}-{form}-{view}"), input));
        }
        let draco = scene_to_bytes(Format::Glb, scene, &options.with_draco(true))?;
        let parts = StrangeParts::of_glb(&draco);
        let primitives = entries(&parts.document, "meshes").flat_map(|mesh| entries(mesh, "primitives"));
        for (number, primitive) in primitives.enumerate() {
            let Some(extension) = primitive.pointer("/extensions/KHR_draco_mesh_compression") else {
                continue;
            };
            let view = extension["bufferView"].as_u64().unwrap_or(0) as usize;
            let bytes = range(&parts.buffer, &parts.document["bufferViews"][view]);
            inputs.push(("gltf_draco", format!("{name}-{form}-{number}"), bytes.to_vec()));
        }
    }
    Ok(inputs)
}

/// The bytes before the compressed data that the target `gltf_meshopt` reads: mode and filter, stride, count.
fn meshopt_head(extension: &Value) -> [u8; 4] {
    let text = |key: &str| extension[key].as_str().unwrap_or("NONE");
    let number = |key: &str| extension[key].as_u64().unwrap_or(0);
    let place =
        |texts: &[&str], key: &str| texts.iter().position(|known| *known == text(key)).unwrap_or(0) as u8;
    let mode = place(&["ATTRIBUTES", "TRIANGLES", "INDICES"], "mode");
    let filter = place(&["NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"], "filter");
    let strides = [2, 4, 8, 12, 16, 20, 128, 256];
    let stride = strides.iter().position(|&stride| stride == number("byteStride")).unwrap_or(0);
    let [low, high] = (number("count") as u16).to_le_bytes();
    [mode + 3 * filter, stride as u8, low, high]
}

fn entries<'v>(value: &'v Value, key: &str) -> impl Iterator<Item = &'v Value> {
    value.get(key).and_then(Value::as_array).into_iter().flatten()
}

fn range<'b>(buffer: &'b [u8], of: &Value) -> &'b [u8] {
    let number = |key: &str| of[key].as_u64().unwrap_or(0) as usize;
    &buffer[number("byteOffset")..][..number("byteLength")]
}
