//! Files for Godot: every level of every surface, and what is left out.

use std::collections::BTreeSet;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde_json::json;
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic, canonical_triangles, shapes};
use striata::{LodOptions, Target};
use striata_io::Scene;
use striata_scene::LodScene;
use striata_scene::godot::{GodotError, GodotKind};

fn text_of(lods: &LodScene, kind: GodotKind, level_count: usize) -> String {
    let encoded = lods.to_godot(kind, level_count, None).expect("a Godot file");
    String::from_utf8(encoded.bytes).expect("text")
}

/// The values of a key in a text, in order.
fn values<'t>(text: &'t str, key: &str) -> Vec<&'t str> {
    let key = format!("\"{key}\": ");
    text.split(&key as &str).skip(1).map(|rest| rest.split(",\n").next().unwrap_or(rest)).collect()
}

fn bytes(value: &str) -> Vec<u8> {
    let packed = value.split("PackedByteArray(\"").nth(1).and_then(|rest| rest.split('"').next());
    BASE64_STANDARD.decode(packed.expect("packed bytes")).expect("base64")
}

/// Corners of each triangle, as the bits of their positions, turned back to counterclockwise.
fn corners(indices: &[u8], is_short: bool, vertices: &[u8]) -> BTreeSet<[[u32; 3]; 3]> {
    let indices: Vec<usize> = match is_short {
        true => indices.as_chunks::<2>().0.iter().map(|&pair| u16::from_le_bytes(pair).into()).collect(),
        false => indices.as_chunks::<4>().0.iter().map(|&four| u32::from_le_bytes(four) as usize).collect(),
    };
    let at = |index: usize| {
        [0, 1, 2].map(|axis| {
            let start = 12 * index + 4 * axis;
            u32::from_le_bytes([0, 1, 2, 3].map(|i| vertices[start + i]))
        })
    };
    let (triangles, rest) = indices.as_chunks::<3>();
    assert!(rest.is_empty());
    triangles.iter().map(|&[a, b, c]| sorted([a, c, b].map(at))).collect()
}

/// Turns a triangle so that its smallest corner is the first.
fn sorted(triangle: [[u32; 3]; 3]) -> [[u32; 3]; 3] {
    let [a, b, c] = triangle;
    [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().expect("three turns")
}

fn expected(mesh: &IndexedMesh) -> BTreeSet<[[u32; 3]; 3]> {
    let at = |v: u32| mesh.positions[v as usize].map(f32::to_bits);
    canonical_triangles(&mesh.triangles).iter().map(|triangle| sorted(triangle.map(at))).collect()
}

#[test]
fn every_level_is_that_of_its_error() {
    for (mesh, is_short) in [(shapes::torus(40, 20, 1.0, 0.4), true), (shapes::terrain(270, 2), false)] {
        let scene = Scene::from_mesh(mesh).expect("a scene");
        let lods = LodScene::build(&scene, &LodOptions::default()).expect("levels");
        for kind in [GodotKind::Mesh, GodotKind::Scene] {
            let text = text_of(&lods, kind, usize::MAX);
            let vertices = bytes(values(&text, "vertex_data")[0]);
            let full = lods.lods()[0].as_ref().expect("a mesh");
            let found = corners(&bytes(values(&text, "index_data")[0]), is_short, &vertices);
            assert_eq!(found, expected(full.mesh()));
            let list = values(&text, "lods")[0].trim_start_matches('[').trim_end_matches(']');
            let mut errors = Vec::new();
            for entry in list.split("), ") {
                let (error, packed) = entry.split_once(", ").expect("an error and indices");
                let error: f32 = error.parse().expect("a number");
                let level = full.level_mesh(Target::Error(error.into()));
                let found = corners(&bytes(packed), is_short, &vertices);
                // The level of the error is at most as fine.
                assert!(found.len() >= level.triangle_count(), "{error}");
                let same = full.level_mesh(Target::Triangles(found.len()));
                assert_eq!(found, expected(&same), "{error}");
                errors.push(error);
            }
            assert!(errors.len() > 5 && errors.is_sorted_by(|a, b| a < b), "{errors:?}");
        }
        assert_eq!(values(&text_of(&lods, GodotKind::Mesh, 1), "lods").len(), 0, "only the full mesh");
    }
}

#[test]
fn names_are_safe_and_instances_keep_their_places() {
    let torus = Scene::from_mesh(shapes::torus(12, 8, 1.0, 0.4)).expect("a scene");
    let mut parts = torus.into_parts();
    let half = std::f64::consts::FRAC_1_SQRT_2;
    parts.document["nodes"] = json!([
        { "name": "a/b\"c", "mesh": 0, "translation": [1, 2, 3] },
        { "name": "a/b\"c", "mesh": 0, "rotation": [0, 0, half, half] },
    ]);
    parts.document["scenes"] = json!([{ "nodes": [0, 1] }]);
    parts.document["materials"] = json!([{ "name": "car", "extensions": { "KHR_materials_clearcoat": {} } }]);
    parts.document["meshes"][0]["primitives"][0]["material"] = json!(0);
    parts.document["cameras"] = json!([{ "type": "perspective", "perspective": { "yfov": 1, "znear": 1 } }]);
    let scene = Scene::from_parts(parts).expect("a scene");
    let lods = LodScene::build(&scene, &LodOptions::default()).expect("levels");
    let encoded = lods.to_godot(GodotKind::Scene, 3, None).expect("a file");
    let text = String::from_utf8(encoded.bytes).expect("text");
    assert!(text.contains("[node name=\"a_b_c\" type=\"MeshInstance3D\" parent=\".\"]"), "{text:.0}");
    assert!(text.contains("[node name=\"a_b_c2\""));
    assert!(text.contains("transform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 2, 3)"));
    // A quarter turn around z: x becomes y.
    let turned = text.split("transform = Transform3D(").nth(2).and_then(|rest| rest.split(')').next());
    let turned: Vec<f32> = turned.expect("two").split(", ").map(|x| x.parse().expect("a number")).collect();
    let rounded: Vec<i32> = turned.iter().map(|x| x.round() as i32).collect();
    assert_eq!(rounded, [0, -1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0]);
    assert_eq!(text.matches("type=\"ArrayMesh\"").count(), 1, "instances share a mesh");
    let warnings: Vec<String> = encoded.warnings.iter().map(ToString::to_string).collect();
    assert!(warnings.iter().any(|warning| warning.contains("cameras are left out")), "{warnings:?}");
    let coat = "KHR_materials_clearcoat of material \"car\" is left out";
    assert!(warnings.iter().any(|warning| warning.contains(coat)), "{warnings:?}");
    assert!(matches!(lods.to_godot(GodotKind::Mesh, 3, None), Err(GodotError::MeshCount(2))));
}

#[test]
fn materials_keep_their_colors_and_images_lie_next_to_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let png = b"\x89PNG\r\n\x1a\n0000";
    let mut parts = Scene::from_mesh(shapes::torus(12, 8, 1.0, 0.4)).expect("a scene").into_parts();
    parts.document["images"] = json!([{ "uri": "skin.png" }]);
    parts.images =
        vec![striata::mesh::Image { uri: "skin.png".into(), bytes: png.to_vec(), ..Default::default() }];
    parts.document["textures"] = json!([{ "source": 0 }]);
    let transform = json!({ "KHR_texture_transform": { "scale": [2, 3], "offset": [0.5, 0] } });
    parts.document["materials"] = json!([{
        "name": "glass",
        "alphaMode": "BLEND",
        "doubleSided": true,
        "emissiveFactor": [0.5, 0, 0],
        "pbrMetallicRoughness": {
            "baseColorFactor": [1, 0.5, 0, 0.25],
            "roughnessFactor": 0.5,
            "baseColorTexture": { "index": 0, "extensions": transform },
        },
    }]);
    parts.document["meshes"][0]["primitives"][0]["material"] = json!(0);
    let scene = Scene::from_parts(parts).expect("a scene");
    let lods = LodScene::build(&scene, &LodOptions::default()).expect("levels");
    let path = folder.path().join("vase.tres");
    let encoded = lods.to_godot(GodotKind::Mesh, 4, Some(&path)).expect("a file");
    encoded.write(&path).expect("files");
    assert_eq!(std::fs::read(folder.path().join("skin.png")).expect("an image"), png);
    let text = std::fs::read_to_string(&path).expect("a file");
    for line in [
        "[ext_resource type=\"Texture2D\" path=\"skin.png\" id=\"image_0\"]",
        "resource_name = \"glass\"",
        "transparency = 1",
        "cull_mode = 2",
        "albedo_color = Color(1, 0.735357, 0, 0.25)",
        "albedo_texture = ExtResource(\"image_0\")",
        "roughness = 0.5",
        "emission = Color(0.735357, 0, 0, 1)",
        "uv1_scale = Vector3(2, 3, 1)",
        "uv1_offset = Vector3(0.5, 0, 0)",
    ] {
        assert!(
            text.lines().any(|found| found == line),
            "{line}:\n{}",
            text.split("_surfaces").next().unwrap_or("")
        );
    }
    assert!(text.contains("\"material\": SubResource(\"material_0\")"));
}

#[test]
fn colors_of_vertices_show_without_a_material_and_names_of_many_instances_differ() {
    let mut mesh = shapes::torus(12, 8, 1.0, 0.4);
    let colors = (0..3 * mesh.vertex_count()).map(|i| (i % 7) as f32 / 6.0).collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Color(0), 3, colors));
    let mut parts = Scene::from_mesh(mesh).expect("a scene").into_parts();
    if let Some(primitive) = parts.document["meshes"][0]["primitives"][0].as_object_mut() {
        primitive.remove("material");
    }
    let count = 30_000;
    parts.document["nodes"] = (0..count).map(|_| json!({ "name": "Leaf", "mesh": 0 })).collect();
    parts.document["scenes"] = json!([{ "nodes": (0..count).collect::<Vec<_>>() }]);
    let lods = LodScene::build(&Scene::from_parts(parts).expect("a scene"), &LodOptions::default());
    let text = text_of(&lods.expect("levels"), GodotKind::Scene, 2);
    assert!(text.contains("id=\"material_default\"") && text.contains("vertex_color_use_as_albedo = true"));
    assert!(text.contains("\"material\": SubResource(\"material_default\")"));
    let names: BTreeSet<&str> =
        text.split("[node name=\"").skip(2).filter_map(|rest| rest.split('"').next()).collect();
    assert_eq!(names.len(), count);
    assert!(names.contains("Leaf") && names.contains("Leaf30000"));
}
