//! GLB files with the extension `STRIATA_lod`: what other viewers see, what ours see, damage.

use std::ops::ControlFlow;

use serde_json::Value;
use striata::file::STREAM_MAGIC;
use striata::mesh::IndexedMesh;
use striata::{LodOptions, Target};
use striata_io::{Format, Scene, Source, mesh_data, read_scene_bytes, scene_to_bytes};
use striata_scene::glb_stream::{
    GlbStreamError, GlbStreamReadError, STREAM_EXTENSION, read_glb_with_stream_and_progress,
};
use striata_scene::{GlbStreamOptions, LodScene, read_glb_with_stream};
use striata_stream::{Precision, StreamOptions};
use striata_testing::scenes::{self, TestScene};

fn source() -> Source<'static> {
    Source::new("test.glb")
}

fn build(scene: &TestScene) -> LodScene {
    LodScene::build(&read_scene_bytes(&scene.to_glb(), &source()).unwrap(), &LodOptions::default()).unwrap()
}

fn lossless() -> GlbStreamOptions {
    let stream = StreamOptions::default().with_precision(Precision::Lossless);
    GlbStreamOptions::default().with_stream(stream).with_coarse(Target::Detail(0.1))
}

/// The JSON and the binary chunk of a GLB file.
fn chunks(glb: &[u8]) -> (Value, &[u8]) {
    let word = |at: usize| u32::from_le_bytes(glb[at..at + 4].try_into().unwrap()) as usize;
    let end = 20 + word(12);
    (serde_json::from_slice(&glb[20..end]).unwrap(), glb.get(end + 8..).unwrap_or_default())
}

/// Positions of the corners of all triangles of each group, in any order of the triangles.
fn surfaces(mesh: &IndexedMesh) -> Vec<Vec<[[u32; 3]; 3]>> {
    let corners = |triangle: &[u32; 3]| {
        let mut corners = triangle.map(|v| mesh.positions[v as usize].map(|x| (x + 0.0).to_bits()));
        let least = (0..3).min_by_key(|&corner| corners[corner]).unwrap();
        corners.rotate_left(least);
        corners
    };
    let of_group = |range: std::ops::Range<usize>| {
        let mut triangles: Vec<_> = mesh.triangles[range].iter().map(corners).collect();
        triangles.sort_unstable();
        triangles
    };
    mesh.groups_or_whole().iter().map(|group| of_group(group.range())).collect()
}

/// Meshes that differ in their material only have one stream.
#[test]
fn equal_meshes_have_one_stream() {
    let lods = build(&scenes::shared_accessors());
    let glb = lods.to_glb_with_stream(&lossless()).unwrap();
    let (document, _) = chunks(&glb);
    let view = |mesh: usize| &document["meshes"][mesh]["extensions"]["STRIATA_lod"]["bufferView"];
    assert!(view(0).is_u64() && view(0) == view(1) && view(1) == view(2) && view(2) != view(3));
    let again = read_glb_with_stream(&glb, &Source::new("x.glb")).unwrap().unwrap();
    assert_eq!(again.triangle_count(), lods.triangle_count());
}

#[test]
fn the_full_scene_comes_back_without_the_extension() {
    for sample in scenes::all() {
        let lods = build(&sample);
        let glb = lods.to_glb_with_stream(&lossless()).unwrap();
        let Some(again) = read_glb_with_stream(&glb, &source()).unwrap() else {
            assert!(lods.lods().iter().all(Option::is_none), "{}", sample.name);
            continue;
        };
        let required = |lods: &LodScene| lods.scene().document().get("extensionsRequired").cloned();
        assert_eq!(required(&again), required(&lods));
        assert!(!again.scene().document().to_string().contains(STREAM_EXTENSION));
        assert_eq!(again.scene().instances(), lods.scene().instances(), "{}", sample.name);
        let (full, expected) = (again.full_scene(), lods.full_scene());
        for (found, expected) in full.meshes().iter().zip(expected.meshes()) {
            assert_eq!(found.as_ref().map(surfaces), expected.as_ref().map(surfaces), "{}", sample.name);
        }
        let written = scene_to_bytes(Format::Glb, &full, &Default::default()).unwrap();
        assert_eq!(read_scene_bytes(&written, &source()).unwrap().triangle_count(), full.triangle_count());
    }
}

#[test]
fn other_readers_see_a_complete_coarse_scene() {
    for sample in scenes::all() {
        let lods = build(&sample);
        let options = lossless().with_coarse(Target::Triangles(40));
        let glb = lods.to_glb_with_stream(&options).unwrap();
        let (json, _) = chunks(&glb);
        let coarse = read_scene_bytes(&glb, &source()).unwrap();
        assert!(coarse.triangle_count() <= lods.triangle_count(), "{}", sample.name);
        assert!(!coarse.document().to_string().contains(STREAM_EXTENSION));
        let original: Scene = lods.full_scene();
        for mesh in 0..original.meshes().len() {
            let materials = coarse.primitive_materials(mesh);
            assert_eq!(materials, original.primitive_materials(mesh), "{}", sample.name);
            assert_eq!(coarse.meshes()[mesh].is_some(), original.meshes()[mesh].is_some(), "{}", sample.name);
            let primitives = json["meshes"][mesh]["primitives"].as_array().unwrap();
            assert_eq!(
                primitives.len(),
                sample.document["meshes"][mesh]["primitives"].as_array().unwrap().len()
            );
        }
        assert_eq!(json.get("extensionsRequired"), original.document().get("extensionsRequired"));
    }
}

#[test]
fn streams_follow_all_other_data_and_are_described() {
    for sample in scenes::all() {
        let glb = build(&sample).to_glb_with_stream(&lossless()).unwrap();
        let (json, binary) = chunks(&glb);
        let views = json["bufferViews"].as_array().cloned().unwrap_or_default();
        let place = |view: &Value| {
            let number = |key: &str| view.get(key).map_or(0, |value| value.as_u64().unwrap()) as usize;
            number("byteOffset")..number("byteOffset") + number("byteLength")
        };
        let mut streams = Vec::new();
        for mesh in json["meshes"].as_array().into_iter().flatten() {
            let Some(extension) = mesh.pointer("/extensions/STRIATA_lod") else { continue };
            check_schema(extension);
            let view = extension["bufferView"].as_u64().unwrap() as usize;
            assert!(binary[place(&views[view])].starts_with(&STREAM_MAGIC));
            assert_eq!((views[view].get("target"), views[view].get("byteStride")), (None, None));
            streams.push(view);
        }
        let names = json["extensionsUsed"].to_string();
        assert_eq!(names.contains(STREAM_EXTENSION), !streams.is_empty(), "{}", sample.name);
        let first = streams.iter().map(|&view| place(&views[view]).start).min().unwrap_or(usize::MAX);
        for (index, view) in views.iter().enumerate().filter(|(index, _)| !streams.contains(index)) {
            assert!(place(view).end <= first, "view {index} of {}", sample.name);
        }
    }
}

/// Checks an object against the part of JSON Schema that the schema of the extension uses.
fn check_schema(extension: &Value) {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/STRIATA_lod.schema.json");
    let schema: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    let members = extension.as_object().unwrap();
    for name in schema["required"].as_array().unwrap() {
        assert!(members.contains_key(name.as_str().unwrap()), "{name} is missing");
    }
    for (name, value) in members {
        let rules = &schema["properties"][name];
        assert!(rules.is_object(), "the schema does not describe {name}");
        match rules["type"].as_str().unwrap() {
            "integer" => assert!(value.is_u64() || value.is_i64(), "{name}: {value}"),
            "number" => assert!(value.is_number(), "{name}: {value}"),
            other => panic!("{name} has the type {other}"),
        }
        if let Some(least) = rules.get("minimum") {
            assert!(value.as_f64() >= least.as_f64(), "{name}: {value}");
        }
        if let Some(only) = rules.get("const") {
            assert_eq!(value, only, "{name}");
        }
    }
}

#[test]
fn primitives_that_vanish_keep_their_places() {
    let lods = build(&scenes::vanishing_primitive());
    let glb = lods.to_glb_with_stream(&lossless().with_coarse(Target::Detail(0.0))).unwrap();
    let coarse = read_scene_bytes(&glb, &source()).unwrap();
    let mesh = coarse.meshes()[0].as_ref().unwrap();
    assert_eq!(mesh.groups.len(), 3);
    let is_flat = |triangle: &[u32; 3]| triangle.iter().all(|&v| v == triangle[0]);
    let shown: Vec<bool> =
        mesh.groups.iter().map(|g| !mesh.triangles[g.range()].iter().all(is_flat)).collect();
    assert_eq!(shown, [true, false, false]);
    let full = read_glb_with_stream(&glb, &source()).unwrap().unwrap();
    let counts = |scene: &LodScene| {
        let mesh = scene.lods()[0].as_ref().unwrap().mesh();
        mesh.groups.iter().map(|group| group.count).collect::<Vec<_>>()
    };
    assert_eq!(counts(&full), counts(&lods));
}

#[test]
fn the_default_is_a_small_share_of_the_triangles() {
    let lods = build(&scenes::hierarchy());
    let glb = lods.to_glb_with_stream(&GlbStreamOptions::default()).unwrap();
    let coarse = read_scene_bytes(&glb, &source()).unwrap();
    assert!((200..=512).contains(&coarse.triangle_count()), "{}", coarse.triangle_count());
    let full = read_glb_with_stream(&glb, &source()).unwrap().unwrap();
    assert_eq!(full.triangle_count(), lods.triangle_count());
}

#[test]
fn files_without_streams_are_left_to_others() {
    let glb = scenes::hierarchy().to_glb();
    assert!(read_glb_with_stream(&glb, &source()).unwrap().is_none());
    assert!(read_glb_with_stream(b"solid nothing\nendsolid\n", &Source::new("a.stl")).unwrap().is_none());
    assert!(mesh_data(&glb, &source(), "VENDOR_other").unwrap().iter().all(Option::is_none));
}

/// Replaces a text in the JSON by one of the same length.
fn replaced(glb: &[u8], from: &str, to: &str) -> Vec<u8> {
    assert_eq!(from.len(), to.len());
    let place = glb.windows(from.len()).position(|window| window == from.as_bytes()).unwrap();
    let mut out = glb.to_vec();
    out[place..place + to.len()].copy_from_slice(to.as_bytes());
    out
}

#[test]
fn damage_is_an_error_that_names_the_mesh_and_leaves_the_coarse_level() {
    let glb = build(&scenes::without_nodes()).to_glb_with_stream(&lossless()).unwrap();
    let version = replaced(&glb, "\"version\":1,\"vertex", "\"version\":2,\"vertex");
    let error = read_glb_with_stream(&version, &source()).unwrap_err();
    assert!(matches!(error, GlbStreamReadError::Version { mesh: 0, .. }), "{error}");

    let mut damaged = glb.clone();
    let last = damaged.len() - 9;
    damaged[last] ^= 16;
    let error = read_glb_with_stream(&damaged, &source()).unwrap_err().to_string();
    assert!(error.starts_with("meshes[1].extensions.STRIATA_lod: "), "{error}");
    assert!(read_scene_bytes(&damaged, &source()).is_ok());

    let (json, _) = chunks(&glb);
    let view = format!("\"bufferView\":{}", json["meshes"][0]["extensions"][STREAM_EXTENSION]["bufferView"]);
    let elsewhere = replaced(&glb, &view, &format!("\"bufferView\":{}", "9".repeat(view.len() - 13)));
    let error = read_glb_with_stream(&elsewhere, &source()).unwrap_err().to_string();
    assert!(error.contains("test.glb: meshes[0].extensions.STRIATA_lod"), "{error}");

    let other = replaced(&glb, &view, "\"bufferView\":0");
    assert!(read_glb_with_stream(&other, &source()).is_err());
}

#[test]
fn no_change_of_a_byte_panics() {
    let glb = build(&scenes::without_nodes()).to_glb_with_stream(&lossless()).unwrap();
    let mut damaged = glb.clone();
    for place in (0..glb.len()).step_by(11) {
        damaged[place] ^= 1 << (place % 8);
        if let Ok(Some(scene)) = read_glb_with_stream(&damaged, &source()) {
            let _ = scene.level_scene(&scene.level(Target::Detail(0.5)));
        }
        damaged[place] = glb[place];
    }
    for length in (0..glb.len()).step_by(101) {
        assert!(read_glb_with_stream(&glb[..length], &source()).is_err(), "{length}");
    }
}

/// Calls `work` with callbacks that cancel at the first, the second, ... report, until none is left.
fn cancel_at_each_report(mut work: impl FnMut(&mut striata::ProgressFn<'_>) -> Result<(), bool>) {
    for last in 1.. {
        let mut calls = 0;
        let outcome = work(&mut |_| {
            calls += 1;
            if calls < last { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        match outcome {
            Ok(()) => {
                assert!(calls < last && last > 2, "{calls} reports");
                return;
            }
            Err(is_cancelled) => assert!(is_cancelled && calls == last, "report {last} of {calls}"),
        }
    }
}

#[test]
fn writing_and_reading_can_be_cancelled_at_each_report() {
    let scene = build(&scenes::without_nodes());
    let glb = scene.to_glb_with_stream(&lossless()).unwrap();
    cancel_at_each_report(|progress| {
        let made = scene.to_glb_with_stream_and_progress(&lossless(), progress);
        made.map(|bytes| assert_eq!(bytes, glb)).map_err(|e| matches!(e, GlbStreamError::Cancelled(_)))
    });
    cancel_at_each_report(|progress| {
        let read = read_glb_with_stream_and_progress(&glb, &source(), progress);
        read.map(|scene| assert!(scene.is_some())).map_err(|e| matches!(e, GlbStreamReadError::Cancelled(_)))
    });
}
