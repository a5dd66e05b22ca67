//! Broken and enormous scenes are survived by levels, poses, streams, files and textures.

use proptest::prelude::*;
use serde_json::{Value, json};
use striata::mesh::{Image, IndexedMesh, shapes};
use striata::simplify::{BatchOptions, SequenceOptions};
use striata::{LodOptions, Target};
use striata_io::{Format, Scene, SceneParts, Source, WriteOptions, read_scene_bytes, scene_to_bytes};
use striata_scene::file::SceneFile;
use striata_scene::stream::{SceneStreamDecoder, SceneStreamOptions, encode_scene};
use striata_scene::textures::{TextureOptions, TextureRole, image_info, preview, recode, recode_scene};
use striata_scene::{LodScene, MeshWeight, Poser, read_glb_with_stream};
use striata_testing::scenes::{self, TestScene};
use striata_testing::strange::StrangeParts;

fn read(scene: &TestScene) -> Result<Scene, String> {
    read_scene_bytes(&scene.to_glb(), &Source::new("scene.glb")).map_err(|error| error.to_string())
}

fn streamed(scene: &Scene) -> Scene {
    let stream = encode_scene(scene, &SceneStreamOptions::default()).unwrap();
    let mut decoder = SceneStreamDecoder::new();
    for piece in stream.bytes.chunks(stream.bytes.len() / 3 + 1) {
        decoder.push(piece).unwrap();
    }
    assert!(decoder.is_complete());
    decoder.scene().unwrap()
}

/// Builds levels, poses, a stream, a file and a GLB with streams.
fn survives(scene: &Scene) {
    let lods = LodScene::build(scene, &LodOptions::default()).unwrap();
    let half = lods.level(Target::Detail(0.5));
    assert!(half.triangle_count <= lods.triangle_count());
    lods.level_scene(&half).flattened().unwrap();
    let file = lods.to_striata(&Default::default()).unwrap();
    let again = SceneFile::parse(&file).unwrap().lod_scene().unwrap();
    assert_eq!(again.triangle_count(), lods.triangle_count());
    let glb = lods.to_glb_with_stream(&Default::default()).unwrap();
    read_glb_with_stream(&glb, &Source::new("x.glb")).unwrap();
    assert_eq!(streamed(scene).instances().len(), scene.instances().len());
    pose(scene);
}

/// Evaluates all animations; what they refer to may not exist.
fn pose(scene: &Scene) {
    let Ok(poser) = Poser::new(scene) else { return };
    let mut poses = vec![poser.rest_pose()];
    for animation in 0..poser.animation_count() {
        let end = poser.duration(animation);
        poses.extend([-1.0, 0.0, end / 2.0, end, f32::NAN].map(|time| poser.pose(animation, time)));
    }
    for instance in scene.instances().iter().take(4) {
        let Some(mesh) = &scene.meshes()[instance.mesh] else { continue };
        for pose in &poses {
            assert_eq!(poser.positions(pose, instance, mesh).len(), mesh.vertex_count());
        }
    }
}

/// Checks a scene with one value of its document replaced: an error that names a place, or a scene.
fn with_value(mut scene: TestScene, pointer: &str, value: &Value) {
    *scene.document.pointer_mut(pointer).unwrap() = value.clone();
    match read(&scene) {
        Ok(found) => survives(&found),
        Err(message) => {
            assert!(message.starts_with("scene.glb: ") && message.contains('['), "{pointer}: {message}");
        }
    }
}

#[test]
fn broken_skins_are_survived() {
    for (pointer, value) in [
        ("/skins/0/joints", json!([1, 99])),
        ("/skins/0/joints", json!([1, 2, 1, 2, 1])),
        ("/skins/0/joints", json!([2])),
        ("/skins/0/joints", json!([])),
        ("/skins/0/joints", json!(["no node", 2])),
        ("/skins/0", json!({})),
        ("/skins/0/inverseBindMatrices", json!(0)),
        ("/skins/0/inverseBindMatrices", json!(999)),
        ("/accessors/6/count", json!(1)),
        ("/nodes/0", json!({ "skin": 0 })),
        ("/nodes/0/skin", json!(1)),
        ("/meshes/0/primitives/0/attributes/WEIGHTS_0", json!(0)),
        ("/meshes/0/primitives/0/attributes/JOINTS_0", json!(0)),
    ] {
        with_value(scenes::skinned(), pointer, &value);
    }
    for attribute in ["WEIGHTS_0", "JOINTS_0"] {
        let mut scene = scenes::skinned();
        let attributes = scene.document.pointer_mut("/meshes/0/primitives/0/attributes").unwrap();
        attributes.as_object_mut().unwrap().remove(attribute);
        survives(&read(&scene).unwrap());
    }
}

#[test]
fn broken_animations_are_survived() {
    let nan = |scene: &mut TestScene| scene.push_floats("SCALAR", 1, &[f32::NAN, f32::INFINITY]);
    for value in [
        json!({ "interpolation": "WAVES" }),
        json!({ "interpolation": "CUBICSPLINE" }),
        json!({ "interpolation": 7 }),
        json!({ "input": 0 }),
        json!({ "output": 0 }),
        json!({ "input": 12345 }),
        json!({ "output": "x" }),
        json!({ "input": null }),
    ] {
        for (number, sample) in [scenes::skinned(), scenes::morphed()].into_iter().enumerate() {
            let mut sample = sample;
            let (key, member) = value.as_object().unwrap().iter().next().unwrap();
            sample.document["animations"][0]["samplers"][0][key] = member.clone();
            match read(&sample) {
                Ok(found) => survives(&found),
                Err(message) => assert!(message.starts_with("scene.glb: "), "{number} {value}: {message}"),
            }
        }
    }
    for (pointer, value) in [
        ("/animations/0/channels/0/target/node", json!(99)),
        ("/animations/0/channels/0/target", json!({})),
        ("/animations/0/channels/0/target/path", json!("color")),
        ("/animations/0/channels/0/target/path", json!("scale")),
        ("/animations/0/channels/0/sampler", json!(5)),
        ("/animations/0/channels/0", json!(null)),
        ("/animations/0/samplers", json!([])),
        ("/animations/0", json!([])),
        ("/nodes/0/weights", json!([1e308, null, "x", -1.0])),
        ("/nodes/0/weights", json!({})),
        ("/meshes/0/weights", json!(vec![0.5; 100_000])),
    ] {
        with_value(scenes::morphed(), pointer, &value);
    }
    let mut sample = scenes::morphed();
    let times = nan(&mut sample);
    sample.document["animations"][0]["samplers"][0]["input"] = json!(times);
    survives(&read(&sample).unwrap());
}

#[test]
fn primitives_with_different_morph_targets_are_survived() {
    let mut sample = scenes::morphed();
    let mut fewer = sample.document["meshes"][0]["primitives"][0].clone();
    fewer["targets"].as_array_mut().unwrap().pop();
    sample.document["meshes"][0]["primitives"].as_array_mut().unwrap().push(fewer);
    survives(&read(&sample).unwrap());
}

/// The header of a PNG of 100,000 x 100,000 pixels, and a few more bytes.
fn bomb() -> Vec<u8> {
    let mut bytes = scenes::PNG.to_vec();
    bytes[16..20].copy_from_slice(&100_000u32.to_be_bytes());
    bytes[20..24].copy_from_slice(&100_000u32.to_be_bytes());
    // The checksum of the header, so that only the size is wrong.
    let checksum = crc32fast::hash(&bytes[12..29]);
    bytes[29..33].copy_from_slice(&checksum.to_be_bytes());
    bytes
}

fn with_image(bytes: Vec<u8>) -> Scene {
    let document = json!({
        "asset": { "version": "2.0" },
        "images": [{ "mimeType": "image/png", "name": "huge" }],
        "textures": [{ "source": 0 }],
        "materials": [{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } } }],
        "meshes": [{ "primitives": [{ "attributes": { "POSITION": null }, "material": 0 }] }],
    });
    let image = Image { mime_type: "image/png".to_owned(), bytes, ..Image::default() };
    let mesh = IndexedMesh { layers: vec![], ..shapes::icosphere(1, 1.0) };
    Scene::from_parts(SceneParts { document, buffer: vec![], images: vec![image], meshes: vec![Some(mesh)] })
        .unwrap()
}

#[test]
fn images_that_claim_to_be_enormous_are_carried_but_never_decoded() {
    let scene = with_image(bomb());
    let info = image_info(&scene.images()[0].bytes).unwrap();
    assert_eq!((info.width, info.height), (100_000, 100_000));
    assert_eq!(preview(&bomb(), TextureRole::default(), 64), None);
    let start = std::time::Instant::now();
    survives(&scene);
    assert_eq!(streamed(&scene).images(), scene.images());
    let options = TextureOptions::default().with_max_side(Some(64));
    let error = recode(&bomb(), TextureRole::default(), &options).unwrap_err().to_string();
    assert!(error.contains("100000 x 100000"), "{error}");
    let (recoded, report) = recode_scene(scene.clone(), &options).unwrap();
    assert_eq!(recoded.images(), scene.images());
    let [warning] = &report.warnings[..] else { panic!("{report:?}") };
    assert!(warning.contains("images[0]") && warning.contains("100000 x 100000"), "{warning}");
    assert!(start.elapsed().as_secs() < 60);
}

/// Reads a scene with [`many`] nodes, and the meshes and skins of a sample.
fn with_nodes(mut sample: TestScene, roots: &str, node: impl Fn(usize) -> String) -> Scene {
    sample.document["nodes"] = json!("NODES");
    sample.document["scenes"] = json!([{ "nodes": "ROOTS" }]);
    let nodes: Vec<String> = (0..many()).map(node).collect();
    let texts = [("NODES", format!("[{}]", nodes.join(","))), ("ROOTS", roots.to_owned())];
    read_scene_bytes(&sample.to_glb_with(&texts), &Source::new("scene.glb")).unwrap()
}

/// A number of nodes that no recursion survives.
fn many() -> usize {
    striata_testing::large(1_000_000)
}

#[test]
fn a_chain_of_a_million_nodes_is_posed_and_streamed() {
    let mut sample = scenes::empty();
    sample.push_mesh("ball", &shapes::icosphere(0, 1.0));
    let scene = with_nodes(sample, "[0]", |i| match many() - 1 - i {
        0 => r#"{"mesh":0,"scale":[2,2,2]}"#.to_owned(),
        _ => format!(r#"{{"children":[{}],"translation":[0.001,0,0]}}"#, i + 1),
    });
    let poser = Poser::new(&scene).unwrap();
    let mesh = scene.meshes()[0].as_ref().unwrap();
    let posed = poser.positions(&poser.rest_pose(), &scene.instances()[0], mesh);
    let center = posed.iter().map(|p| f64::from(p[0])).sum::<f64>() / posed.len() as f64;
    assert!((center - (many() - 1) as f64 / 1000.0).abs() < 1e-2, "{center}");
    drop(poser);
    assert_eq!(streamed(&scene).instances().len(), 1);
}

#[test]
fn a_million_instances_are_leveled() {
    let mut sample = scenes::empty();
    sample.push_mesh("ball", &shapes::icosphere(1, 1.0));
    sample.document["skins"] = json!([{ "joints": (0..1000).collect::<Vec<usize>>() }]);
    let roots: Vec<String> = (0..many()).map(|i| i.to_string()).collect();
    let scene = with_nodes(sample, &format!("[{}]", roots.join(",")), |i| match i % 2 {
        0 => r#"{"mesh":0}"#.to_owned(),
        _ => r#"{"mesh":0,"skin":0}"#.to_owned(),
    });
    let lods = LodScene::build(&scene, &LodOptions::default()).unwrap();
    assert_eq!(lods.triangle_count(), 80 * many());
    assert!(lods.level(Target::Triangles(40 * many())).triangle_count <= 40 * many());
    drop(lods);
    assert!(encode_scene(&scene, &SceneStreamOptions::default()).unwrap().sizes.drawable_at > many());
}

#[test]
fn instances_by_extension_count_in_weights_levels_and_poses() {
    let mut sample = scenes::instanced_by_extension();
    let scales = sample.push_floats("VEC3", 3, &[1.0, 1.0, 1.0, 4.0, 4.0, 4.0, 2.0, 2.0, 2.0]);
    let attributes = "/nodes/0/extensions/EXT_mesh_gpu_instancing/attributes";
    sample.document.pointer_mut(attributes).unwrap()["SCALE"] = json!(scales);
    let scene = read(&sample).unwrap();
    let weight = MeshWeight::of_scene(&scene)[0];
    assert_eq!(weight.instance_count, 3);
    assert!((weight.scale - 4.0).abs() < 1e-6, "{weight:?}");
    let sequence = SequenceOptions::default().with_base_triangle_count(4);
    let lods = LodScene::build(&scene, &LodOptions::default().with_sequence(sequence)).unwrap();
    let full = scene.meshes()[0].as_ref().unwrap().triangle_count();
    assert_eq!(lods.triangle_count(), 3 * full);
    let half = lods.level(Target::Triangles(3 * full / 2));
    assert!(half.triangle_count <= 3 * full / 2 && half.triangle_count.is_multiple_of(3), "{half:?}");
    assert_eq!(lods.level_scene(&half).flattened().unwrap().triangle_count(), half.triangle_count);
    let poser = Poser::new(&scene).unwrap();
    let instance = &scene.instances()[1];
    let mesh = scene.meshes()[0].as_ref().unwrap();
    let posed = poser.positions(&poser.rest_pose(), instance, mesh);
    for (posed, at) in posed.iter().zip(&mesh.positions) {
        assert!((posed[0] - (4.0 * at[0] + 5.0)).abs() < 1e-4, "{posed:?} {at:?}");
    }
    let stream = encode_scene(&scene, &SceneStreamOptions::default().with_batches(BatchOptions::default()));
    let mut decoder = SceneStreamDecoder::new();
    decoder.push(&stream.unwrap().bytes).unwrap();
    assert_eq!(decoder.scene().unwrap().instances(), scene.instances());
}

/// Writes and reads a scene until nothing changes any more.
fn settles(scene: &Scene) {
    let Ok(first) = scene_to_bytes(Format::Glb, scene, &WriteOptions::default()) else { return };
    let again = read_scene_bytes(&first, &Source::new("again.glb")).unwrap();
    assert_eq!(again.instances().len(), scene.instances().len());
    let second = scene_to_bytes(Format::Glb, &again, &WriteOptions::default()).unwrap();
    let third = read_scene_bytes(&second, &Source::new("again.glb")).unwrap();
    assert_eq!(third.document(), again.document());
    assert_eq!(third.buffer(), again.buffer());
}

proptest! {
    #![proptest_config(striata_testing::cases(if cfg!(debug_assertions) { 150 } else { 2000 }))]

    #[test]
    fn strange_values_are_errors_or_scenes(
        sample in 0usize..9,
        changes in prop::collection::vec(any::<u8>(), 0..40),
        checks in any::<u8>(),
    ) {
        let mut parts = StrangeParts::of_glb(&scenes::all()[sample].to_glb());
        parts.change(&changes);
        let Ok(scene) = read_scene_bytes(&parts.to_glb(), &Source::new("x.glb")) else { return Ok(()) };
        settles(&scene);
        pose(&scene);
        if checks < 32 && scene.triangle_count() < 3000 {
            let lods = LodScene::build(&scene, &LodOptions::default());
            if let Ok(lods) = lods {
                prop_assert!(lods.to_striata(&Default::default()).is_ok());
            }
            if encode_scene(&scene, &SceneStreamOptions::default()).is_ok() {
                streamed(&scene);
            }
        }
    }
}
