//! Levels of skinned and morphing meshes: their vertices keep all data, and their errors hold in poses.

use crate::vertices::vertex_data;
use striata::mesh::{IndexedMesh, Semantic, TriangleTree};
use striata::simplify::{AttributeWeights, BatchOptions, SequenceOptions};
use striata::{Level, Lod, LodOptions, Target};
use striata_io::{Scene, SceneInstance, Source, read_scene_bytes};
use striata_scene::stream::{SceneStreamDecoder, SceneStreamOptions, encode_scene};
use striata_scene::{Deformation, GlbStreamOptions, LodScene, Pose, Poser, ScenePoses, read_glb_with_stream};
use striata_testing::scenes::{self, TestScene};

const SHARES: [usize; 3] = [10, 25, 50];
/// Fractions of the duration of an animation, none of which is examined when meshes are simplified.
const TIMES: [f32; 5] = [0.07, 0.28, 0.49, 0.71, 0.995];

fn read(scene: &TestScene) -> Scene {
    read_scene_bytes(&scene.to_glb(), &Source::new("test.glb")).unwrap()
}

fn build(scene: &Scene) -> LodScene {
    LodScene::build(scene, &LodOptions::default()).unwrap()
}

fn without_poses() -> SequenceOptions {
    let weights = AttributeWeights { displacement: 0.0, ..AttributeWeights::default() };
    SequenceOptions::default().with_attribute_weights(weights)
}

fn deformed_scenes() -> Vec<TestScene> {
    vec![
        scenes::skinned(),
        scenes::morphed(),
        scenes::bending_tube(),
        scenes::folding_grid(),
        scenes::two_sizes(),
    ]
}

/// Poses at times of all animations, and with each morph target of an instance alone at several weights.
fn poses(poser: &Poser, instance: &SceneInstance, mesh: &IndexedMesh) -> Vec<(String, Pose)> {
    let mut poses = Vec::new();
    for animation in 0..poser.animation_count() {
        let duration = poser.duration(animation);
        poses.extend(TIMES.map(|time| (format!("at {time}"), poser.pose(animation, time * duration))));
    }
    let is_target = |semantic: &Semantic| matches!(semantic, Semantic::MorphPosition(_));
    let targets = mesh.layers.iter().filter(|layer| is_target(&layer.semantic)).count();
    for target in 0..targets {
        for weight in [0.0, 0.5, 1.0] {
            let mut weights = vec![0.0; targets];
            weights[target] = weight;
            let pose = poser.rest_pose().with_morph_weights(instance, weights).unwrap();
            poses.push((format!("target {target} at {weight}"), pose));
        }
    }
    poses
}

/// The largest distance of a vertex of the full mesh from a level, in a pose, divided by the instance's
/// scale.
fn posed_distance(
    poser: &Poser,
    pose: &Pose,
    instance: &SceneInstance,
    full: &IndexedMesh,
    level: &IndexedMesh,
) -> f64 {
    let posed = poser.positions(pose, instance, full);
    let positions = poser.positions(pose, instance, level);
    assert_eq!(positions, posed[..positions.len()], "a level shows a prefix of the full mesh's vertices");
    let tree = TriangleTree::new(&IndexedMesh::new(positions, level.triangles.clone())).unwrap();
    let distances = posed.iter().map(|position| tree.distance_to(position.map(f64::from)));
    distances.fold(0.0, f64::max) / instance.scale
}

/// Returns the first distance in a pose that exceeds the error of its level.
fn first_violation(scene: &Scene, lods: &[(usize, Lod)]) -> Option<String> {
    let poser = Poser::new(scene).unwrap();
    for (index, lod) in lods {
        let full = lod.mesh();
        for instance in scene.instances().iter().filter(|instance| instance.mesh == *index) {
            for share in SHARES {
                let level = lod.level(Target::Triangles(full.triangle_count() * share / 100));
                let shown = shown(lod, &level);
                let limit = f64::from(level.error()) * (1.0 + 1e-6) + 1e-6 * full.diagonal();
                for (name, pose) in poses(&poser, instance, full) {
                    let distance = posed_distance(&poser, &pose, instance, full, &shown);
                    if distance > limit {
                        return Some(format!("mesh {index}, {share} %, {name}: {distance} > {limit}"));
                    }
                }
            }
        }
    }
    None
}

/// A level with the prefix of the full mesh's vertices, even if some of them have no triangle.
fn shown(lod: &Lod, level: &Level) -> IndexedMesh {
    let kept: Vec<u32> = (0..level.vertex_count() as u32).collect();
    let full = lod.mesh();
    let mut mesh = IndexedMesh::new(full.positions[..kept.len()].to_vec(), level.triangles().to_vec());
    mesh.layers = full.layers.iter().map(|layer| layer.gather(&kept)).collect();
    mesh
}

fn lods(lods: &LodScene) -> Vec<(usize, Lod)> {
    lods.lods().iter().enumerate().filter_map(|(index, lod)| Some((index, lod.clone()?))).collect()
}

#[test]
fn kept_vertices_have_the_layers_of_the_full_mesh_and_no_others() {
    for sample in deformed_scenes() {
        let scene = read(&sample);
        let lods = build(&scene);
        for share in SHARES {
            let coarse =
                lods.level_scene(&lods.level(Target::Triangles(lods.triangle_count() * share / 100)));
            for (full, mesh) in scene.meshes().iter().zip(coarse.meshes()) {
                let (Some(full), Some(mesh)) = (full, mesh) else { continue };
                let semantics =
                    |mesh: &IndexedMesh| mesh.layers.iter().map(|l| l.semantic.clone()).collect::<Vec<_>>();
                assert_eq!(semantics(full), semantics(mesh), "{}", sample.name);
                let known = vertex_data(full);
                for (position, vertices) in vertex_data(mesh) {
                    for vertex in vertices {
                        assert!(known[&position].contains(&vertex), "{} at {share} %", sample.name);
                    }
                }
            }
        }
    }
}

#[test]
fn errors_of_levels_hold_at_times_that_were_not_examined() {
    for sample in deformed_scenes() {
        let scene = read(&sample);
        let violation = first_violation(&scene, &lods(&build(&scene)));
        assert_eq!(violation, None, "{}", sample.name);
    }
}

#[test]
fn without_poses_errors_do_not_hold() {
    for sample in [scenes::bending_tube(), scenes::folding_grid()] {
        let scene = read(&sample);
        let options = LodOptions::default().with_sequence(without_poses());
        let ignored = LodScene::build(&scene, &options).unwrap();
        assert!(first_violation(&scene, &lods(&ignored)).is_some(), "{}: poses have no weight", sample.name);
    }
}

#[test]
fn a_straight_tube_keeps_rings_to_bend_at() {
    let scene = read(&scenes::bending_tube());
    let poser = Poser::new(&scene).unwrap();
    let instance = &scene.instances()[0];
    let bent = poser.pose(0, poser.duration(0));
    let distance_of = |lod: &Lod| {
        let level = lod.level(Target::Triangles(lod.mesh().triangle_count() / 10));
        posed_distance(&poser, &bent, instance, lod.mesh(), &shown(lod, &level))
    };
    let ours = distance_of(build(&scene).lods()[0].as_ref().unwrap());
    let plain = Lod::build(scene.meshes()[0].as_ref().unwrap(), &LodOptions::default()).unwrap();
    assert!(ours < 0.25 * distance_of(&plain), "{ours} against {}", distance_of(&plain));
}

/// Encodes a scene, and returns the levels of its first mesh as they are decoded.
fn streamed(scene: &Scene, sequence: SequenceOptions) -> Lod {
    let batches = BatchOptions::default().with_sequence(sequence);
    let encoded = encode_scene(scene, &SceneStreamOptions::default().with_batches(batches)).unwrap();
    let mut decoder = SceneStreamDecoder::new();
    decoder.push(&encoded.bytes).unwrap();
    decoder.finish().unwrap();
    decoder.lods().remove(0).unwrap()
}

/// Writes a scene as a GLB file with streams, and returns the levels of its first mesh as they are decoded.
fn from_glb(scene: &Scene, sequence: SequenceOptions) -> Lod {
    let options = GlbStreamOptions::default().with_batches(BatchOptions::default().with_sequence(sequence));
    let bytes = build(scene).to_glb_with_stream(&options).unwrap();
    let lods = read_glb_with_stream(&bytes, &Source::new("tube.glb")).unwrap().unwrap();
    lods.lods()[0].clone().unwrap()
}

#[test]
fn levels_of_streams_bend_too() {
    let scene = read(&scenes::bending_tube());
    let poser = Poser::new(&scene).unwrap();
    let instance = &scene.instances()[0];
    let bent = poser.pose(0, poser.duration(0));
    for decoded in [streamed, from_glb] {
        let distance_and_error = |lod: &Lod, share: usize| {
            let level = lod.level(Target::Triangles(lod.mesh().triangle_count() * share / 100));
            let distance = posed_distance(&poser, &bent, instance, lod.mesh(), &shown(lod, &level));
            (distance, f64::from(level.error()))
        };
        let ours = decoded(&scene, SequenceOptions::default());
        let plain = decoded(&scene, without_poses());
        assert_eq!(ours.mesh().layers.len(), 2, "joints and weights only");
        for share in SHARES {
            let (distance, error) = distance_and_error(&ours, share);
            // Positions are rounded.
            assert!(distance <= error + scene.diagonal() / 1000.0, "{share} %: {distance} > {error}");
            let (torn, _) = distance_and_error(&plain, share);
            assert!(distance < 0.5 * torn, "{share} %: {distance} against {torn}");
        }
    }
}

#[test]
fn rigid_meshes_have_no_poses() {
    let scene = read(&scenes::hierarchy());
    let poses = ScenePoses::new(&scene).unwrap();
    for (index, mesh) in scene.meshes().iter().enumerate() {
        assert!(Deformation::of(&scene, &poses, index, mesh.as_ref().unwrap()).is_none());
    }
}

#[test]
fn guaranteed_errors_and_error_limits_keep_their_meaning() {
    let scene = read(&scenes::bending_tube());
    let options = LodOptions::default().with_guaranteed_errors(true);
    let guaranteed = LodScene::build(&scene, &options).unwrap();
    assert!(guaranteed.lods()[0].as_ref().unwrap().has_guaranteed_errors());
    assert_eq!(first_violation(&scene, &lods(&guaranteed)), None);
    let limit = 0.05;
    let options = LodOptions::default().with_sequence(SequenceOptions::default().with_max_error(limit));
    let limited = LodScene::build(&scene, &options).unwrap();
    let lod = limited.lods()[0].as_ref().unwrap();
    assert!(f64::from(lod.sequence().error_at(0)) <= limit && lod.step_count() > 0);
    assert_eq!(first_violation(&scene, &lods(&limited)), None);
}
