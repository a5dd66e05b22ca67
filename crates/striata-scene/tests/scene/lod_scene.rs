//! Levels of test scenes: groups, vertices and their data, options in units of the scene.

use std::ops::ControlFlow;

use crate::vertices::vertex_data;
use serde_json::json;
use striata::levels::Levels as _;
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic, shapes};
use striata::simplify::{SequenceOptions, StopReason};
use striata::view::{Camera, ScreenError};
use striata::{LodOptions, Target};
use striata_io::{Format, Scene, Source, read_scene_bytes, scene_to_bytes};
use striata_scene::{LodScene, MeshWeight, SceneMismatch};
use striata_testing::scenes::{self, TestScene};

fn read(scene: &TestScene) -> Scene {
    read_scene_bytes(&scene.to_glb(), &Source::new("test.glb")).unwrap()
}

fn build(scene: &TestScene) -> LodScene {
    LodScene::build(&read(scene), &LodOptions::default()).unwrap()
}

#[test]
fn every_level_keeps_groups_and_the_data_of_each_vertex() {
    for sample in scenes::all() {
        let scene = read(&sample);
        let lods = LodScene::build(&scene, &LodOptions::default()).unwrap();
        assert_eq!(lods.scene().document(), scene.document());
        for detail in [0.0, 0.1, 0.5, 1.0] {
            let level = lods.level(Target::Detail(detail));
            let coarse = lods.level_scene(&level);
            for (source, mesh) in scene.meshes().iter().zip(coarse.meshes()) {
                let (Some(source), Some(mesh)) = (source, mesh) else {
                    assert_eq!(source.is_some(), mesh.is_some(), "{}", sample.name);
                    continue;
                };
                let materials =
                    |mesh: &IndexedMesh| mesh.groups.iter().map(|g| g.material).collect::<Vec<_>>();
                assert_eq!(materials(source), materials(mesh), "{} at {detail}", sample.name);
                let known = vertex_data(source);
                for (position, vertices) in vertex_data(mesh) {
                    assert!(
                        vertices.iter().all(|vertex| known[&position].contains(vertex)),
                        "{}",
                        sample.name
                    );
                }
            }
            let bytes = scene_to_bytes(Format::Glb, &coarse, &Default::default()).unwrap();
            let again = read_scene_bytes(&bytes, &Source::new("level.glb")).unwrap();
            assert_eq!(again.instances(), coarse.instances(), "{} at {detail}", sample.name);
        }
    }
}

#[test]
fn the_full_scene_has_all_triangles() {
    for sample in scenes::all() {
        let scene = read(&sample);
        let lods = build(&sample);
        for full in [lods.full_scene(), lods.level_scene(&lods.level(Target::Detail(1.0)))] {
            // The only triangle without area is in a scene made for it.
            let lost = usize::from(sample.name == "vanishing primitive");
            assert_eq!(full.triangle_count() + lost, scene.triangle_count(), "{}", sample.name);
            assert_eq!(full.bounds().map(|b| b.min), scene.bounds().map(|b| b.min), "{}", sample.name);
        }
    }
}

#[test]
fn instances_count_in_triangles_and_scale_counts_in_errors() {
    let lods = build(&scenes::hierarchy());
    let weights = MeshWeight::of_scene(lods.scene());
    assert_eq!(weights.iter().map(|w| w.instance_count).collect::<Vec<_>>(), [3, 1, 0]);
    let scales: Vec<f64> = weights.iter().map(|w| w.scale).collect();
    for (found, expected) in scales.iter().zip([8.0, 6.0, 1.0]) {
        assert!((found - expected).abs() < 1e-5, "{scales:?}");
    }
    let shown = lods.full_scene().triangle_count();
    assert_eq!(lods.triangle_count(), shown, "a mesh that nothing shows does not count");
    let limit = lods.triangle_count() / 3;
    let level = lods.level(Target::Triangles(limit));
    assert!(level.triangle_count <= limit && level.triangle_count + 10 > limit);
    assert!(lods.level_scene(&level).triangle_count() <= limit);
}

#[test]
fn lengths_in_options_are_in_units_of_the_scene() {
    let scene = read(&scenes::hierarchy());
    let options = LodOptions::default().with_sequence(SequenceOptions::default().with_max_error(0.05));
    let lods = LodScene::build(&scene, &options).unwrap();
    let base = lods.level(Target::Triangles(0));
    assert_eq!(base.stop_reason, StopReason::BaseReached);
    assert!(base.error <= 0.05 * (1.0 + 1e-6) && base.error > 0.02, "{}", base.error);
}

#[test]
fn options_that_cannot_apply_are_refused_with_the_mesh() {
    let scene = read(&scenes::hierarchy());
    let mut options = SequenceOptions::default();
    options.locked_vertices = vec![3];
    let error = LodScene::build(&scene, &LodOptions::default().with_sequence(options)).unwrap_err();
    assert!(error.to_string().starts_with("mesh 0 \"ball\": option locked_vertices"), "{error}");
}

#[test]
fn progress_covers_all_meshes_and_can_cancel() {
    let scene = read(&scenes::hierarchy());
    let (mut last, mut total) = (0, 0);
    let lods = LodScene::build_with_progress(&scene, &LodOptions::default(), &mut |now| {
        assert!(now.done >= last && now.done <= now.total);
        (last, total) = (now.done, now.total);
        ControlFlow::Continue(())
    });
    assert!(lods.is_ok());
    assert!(last > total * 9 / 10, "{last} of {total}");
    let cancelled =
        LodScene::build_with_progress(&scene, &LodOptions::default(), &mut |_| ControlFlow::Break(()));
    assert!(cancelled.unwrap_err().to_string().ends_with("cancelled"));
}

#[test]
fn levels_of_other_scenes_are_refused() {
    let (lods, other) = (build(&scenes::hierarchy()), build(&scenes::morphed()));
    let found = LodScene::from_lods(lods.scene().clone(), other.lods().to_vec()).unwrap_err();
    assert_eq!(found, SceneMismatch::MeshCount { found: 2, expected: 3 });
    let mut swapped = lods.lods().to_vec();
    swapped.swap(0, 1);
    let found = LodScene::from_lods(lods.scene().clone(), swapped).unwrap_err();
    assert!(matches!(found, SceneMismatch::GroupCount { mesh: 0, found: 0 | 1, expected: 2 }), "{found}");
    assert!(LodScene::from_lods(lods.full_scene(), lods.lods().to_vec()).is_ok());
}

#[test]
fn joints_and_morph_targets_stay_layers() {
    let semantics = |lods: &LodScene| {
        let coarse = lods.level_scene(&lods.level(Target::Detail(0.05)));
        let mesh = coarse.meshes()[0].as_ref().unwrap();
        mesh.layers.iter().map(|layer| layer.semantic.clone()).collect::<Vec<_>>()
    };
    let skinned = semantics(&build(&scenes::skinned()));
    assert!(skinned.contains(&Semantic::Joints(0)) && skinned.contains(&Semantic::Weights(0)));
    let morphed = semantics(&build(&scenes::morphed()));
    assert!(morphed.contains(&Semantic::MorphPosition(0)) && morphed.contains(&Semantic::MorphPosition(1)));
}

/// Texture coordinates count by what the texture sees, whatever their range in the file.
#[test]
fn texture_transforms_scale_the_weight_of_texture_coordinates() {
    let level_of = |unit: f32| {
        let mut ball = shapes::icosphere(3, 1.0);
        let uvs =
            ball.positions.iter().flat_map(|[x, y, z]| [unit * (0.3 * x + 0.2 * z), unit * (0.5 * y + 0.5)]);
        ball.layers = vec![AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uvs.collect())];
        let mut sample = scenes::empty();
        sample.push_mesh("ball", &ball);
        let transform = json!({ "KHR_texture_transform": { "scale": [1.0 / unit, 1.0 / unit] } });
        let texture = json!({ "index": 0, "extensions": transform });
        sample.document["textures"] = json!([{ "source": 0 }]);
        sample.document["images"] = json!([{ "uri": "none.png" }]);
        sample.document["materials"] = json!([{ "pbrMetallicRoughness": { "baseColorTexture": texture } }]);
        sample.document["meshes"][0]["primitives"][0]["material"] = json!(0);
        sample.document["nodes"] = json!([{ "mesh": 0 }]);
        sample.document["scenes"] = json!([{ "nodes": [0] }]);
        let lods = build(&sample);
        let level = lods.level(Target::Triangles(200));
        let mesh = lods.level_meshes(&level).remove(0).expect("a mesh");
        (level.error, mesh.positions, mesh.triangles)
    };
    assert!(level_of(1.0) == level_of(4096.0));
}

/// Equal meshes with other materials are simplified alike, so that a file can store them once.
#[test]
fn equal_meshes_have_equal_levels() {
    let mut sample = scenes::empty();
    sample.push_mesh("ball", &shapes::icosphere(3, 1.0));
    let ball = sample.document["meshes"][0].clone();
    let meshes = (0..20).map(|material| {
        let mut mesh = ball.clone();
        mesh["primitives"][0]["material"] = json!(material);
        mesh
    });
    sample.document["meshes"] = meshes.collect();
    sample.document["materials"] = json!(vec![json!({}); 20]);
    sample.document["nodes"] = (0..20).map(|mesh| json!({ "mesh": mesh })).collect();
    sample.document["scenes"] = json!([{ "nodes": (0..20).collect::<Vec<_>>() }]);
    let lods = build(&sample);
    for triangles in [20 * 1280, 20 * 640, 20 * 100 + 7, 500] {
        let level = lods.level(Target::Triangles(triangles));
        let meshes = lods.level_meshes(&level);
        assert!(level.triangle_count <= triangles && level.triangle_count + 20 * 4 > triangles);
        assert!(meshes.iter().all(|mesh| *mesh == meshes[0]), "{triangles}");
    }
    let one = scene_to_bytes(
        Format::Glb,
        &lods.level_scene(&lods.level(Target::Triangles(12_800))),
        &Default::default(),
    );
    assert!(one.unwrap().len() < 20_000);
}

/// An object that appears by growing from a thousandth of its size has the levels of its full size.
#[test]
fn animated_scales_count_in_weights() {
    let levels = |rest: f64, interpolation: &str, on_parent: bool| {
        let mut sample = scenes::empty();
        sample.push_mesh("ball", &shapes::icosphere(3, 1.0));
        let (child, parent) = (json!({ "mesh": 0 }), json!({ "children": [0] }));
        sample.document["nodes"] = json!([child, parent]);
        sample.document["nodes"][usize::from(on_parent)]["scale"] = json!([rest, rest, rest]);
        sample.document["scenes"] = json!([{ "nodes": [1] }]);
        let times = sample.push_floats("SCALAR", 1, &[0.0, 1.0]);
        let keys = match interpolation {
            "CUBICSPLINE" => [[9.0; 3], [0.001; 3], [9.0; 3], [9.0; 3], [1.0; 3], [9.0; 3]].concat(),
            _ => [[0.001; 3], [1.0; 3]].concat(),
        };
        let output = sample.push_floats("VEC3", 3, &keys);
        sample.document["animations"] = json!([{
            "samplers": [{ "input": times, "output": output, "interpolation": interpolation }],
            "channels": [{ "sampler": 0, "target": { "node": usize::from(on_parent), "path": "scale" } }],
        }]);
        build(&sample).level(Target::Error(0.02)).triangle_count
    };
    for interpolation in ["LINEAR", "CUBICSPLINE", "STEP"] {
        for on_parent in [false, true] {
            assert_eq!(levels(0.001, interpolation, on_parent), levels(1.0, interpolation, on_parent));
            assert!(levels(0.001, interpolation, on_parent) > 100);
        }
    }
}

/// Returns the corners of triangles, each triangle from its smallest corner on, sorted.
fn corners(mesh: &IndexedMesh, triangles: impl Iterator<Item = [u32; 3]>) -> Vec<[[u32; 3]; 3]> {
    let rotated = |t: [u32; 3]| {
        let mut corners = t.map(|v| mesh.positions[v as usize].map(f32::to_bits));
        let first = (0..3).min_by_key(|&k| corners[k]).unwrap_or(0);
        corners.rotate_left(first);
        corners
    };
    let mut all: Vec<_> = triangles.map(rotated).collect();
    all.sort_unstable();
    all
}

/// Index lists over the vertices of the full scene show what the scene of the level shows.
#[test]
fn indices_of_levels_refer_to_one_vertex_buffer() {
    for sample in scenes::all() {
        let lods = build(&sample);
        let full = lods.full_scene();
        for detail in [0.0, 0.3, 1.0] {
            let level = lods.level(Target::Detail(detail));
            let (lists, meshes) = (lods.indices(&level), lods.level_meshes(&level));
            assert_eq!(lists.len(), meshes.len());
            for ((lists, mesh), full) in lists.iter().zip(&meshes).zip(full.meshes()) {
                let (Some(mesh), Some(full)) = (mesh, full) else {
                    assert!(lists.is_empty() && mesh.is_none());
                    continue;
                };
                assert_eq!(lists.len(), mesh.groups_or_whole().len(), "{}", sample.name);
                for (list, group) in lists.iter().zip(mesh.groups_or_whole().iter()) {
                    let (lists, _) = list.as_chunks::<3>();
                    let (found, expected) = (
                        corners(full, lists.iter().copied()),
                        corners(mesh, mesh.triangles[group.range()].iter().copied()),
                    );
                    assert_eq!(found, expected, "{} at {detail}", sample.name);
                }
            }
        }
    }
}

#[test]
fn a_scene_is_a_source_of_levels() {
    for sample in scenes::all() {
        let mut lods = build(&sample);
        let facts = lods.facts();
        for target in [Target::Detail(0.0), Target::Detail(0.6), Target::Triangles(facts.triangle_count / 3)]
        {
            let Ok(found) = lods.find(target);
            let level = lods.level(target);
            assert_eq!(found.shape.meshes(), lods.level_scene(&level).meshes(), "{}", sample.name);
            assert_eq!((found.triangle_count, found.error), (level.triangle_count, Some(level.error)));
            assert_eq!(found.shape.triangle_count(), found.triangle_count, "{}", sample.name);
        }
        let Ok(Some(bounds)) = lods.bounds() else { continue };
        let center = [0, 1, 2].map(|axis| f32::midpoint(bounds.min[axis], bounds.max[axis]));
        let eye = [center[0], center[1], center[2] + 2.0 * (bounds.diagonal() as f32).max(1e-3)];
        let camera = Camera::new(eye, center, [0.0, 1.0, 0.0], 0.5, [800, 600]).unwrap();
        let criterion = ScreenError::new(camera, 0.1);
        let Ok(fine) = lods.find_for_view(&criterion, None);
        let Ok(within) = lods.find_for_view(&criterion, Some(fine.triangle_count / 2));
        let is_within = within.triangle_count <= fine.triangle_count / 2;
        assert!(is_within || within.stop_reason == StopReason::BaseReached, "{}", sample.name);
    }
}
