//! Scenes for a camera: refined where errors would be seen, coarse elsewhere, within a budget.

use striata::mesh::{TriangleTree, shapes};
use striata::view::{Camera, ScreenError};
use striata::{LodOptions, Target};
use striata_io::{Scene, Source, read_scene_bytes};
use striata_scene::LodScene;
use striata_testing::scenes;

fn error(eye: [f32; 3], target: [f32; 3], pixels: f32) -> ScreenError {
    let camera = Camera::new(eye, target, [0.0, 1.0, 0.0], 0.5, [1280, 720]).unwrap();
    ScreenError::new(camera, pixels)
}

fn lods_of(scene: &Scene) -> LodScene {
    LodScene::build(scene, &LodOptions::default().with_guaranteed_errors(true)).unwrap()
}

fn sample(sample: &scenes::TestScene) -> LodScene {
    lods_of(&read_scene_bytes(&sample.to_glb(), &Source::new("test.glb")).unwrap())
}

#[test]
fn near_views_have_more_triangles_than_far_ones() {
    let all = [scenes::hierarchy(), scenes::skinned(), scenes::morphed(), scenes::without_nodes()];
    for scene in all.map(|scene| sample(&scene)) {
        let bounds = scene.full_scene().bounds().unwrap();
        let center = [0, 1, 2].map(|i| f32::midpoint(bounds.min[i], bounds.max[i]));
        let radius = bounds.diagonal() as f32;
        let counts = [1.2, 20.0, 5000.0].map(|distance| {
            let eye = [center[0], center[1], center[2] + distance * radius];
            scene.view_scene(&error(eye, center, 1.0)).triangle_count()
        });
        assert!(counts.is_sorted_by(|near, far| near >= far) && counts[0] > counts[2], "{counts:?}");
        assert!(counts[0] <= scene.triangle_count());
    }
}

#[test]
fn every_vertex_is_within_the_tolerance_on_the_screen() {
    let mesh = shapes::torus(64, 32, 1.0, 0.4);
    let scene = lods_of(&Scene::from_mesh(mesh.clone()).unwrap());
    let (eye, pixels) = ([0.3, 0.4, 3.0], 2.0);
    let shown = scene.view_scene(&error(eye, [0.0; 3], pixels));
    let shown = shown.meshes()[0].as_ref().unwrap();
    assert!(shown.triangle_count() < mesh.triangle_count() / 2, "{}", shown.triangle_count());
    let tree = TriangleTree::new(shown).unwrap();
    let mut triangle = usize::MAX;
    for position in &mesh.positions {
        let to_eye: f64 = (0..3).map(|i| f64::from(position[i] - eye[i]).powi(2)).sum::<f64>().sqrt();
        // The torus is seen as a whole, so only what faces away may be coarser.
        let faces_eye = position[2] > 0.35;
        let distance = tree.distance_within(position.map(f64::from), 0.0, &mut triangle);
        let on_screen = distance * 720.0 / (2.0 * 0.5) / (to_eye - distance);
        assert!(!faces_eye || on_screen <= f64::from(pixels), "{on_screen} pixels at {position:?}");
    }
}

#[test]
fn the_budget_counts_instances_and_relaxes_the_tolerance() {
    let scene = sample(&scenes::hierarchy());
    let bounds = scene.full_scene().bounds().unwrap();
    let center = [0, 1, 2].map(|i| f32::midpoint(bounds.min[i], bounds.max[i]));
    let eye = [center[0], center[1], center[2] + bounds.diagonal() as f32];
    let fine = error(eye, center, 1e-4);
    let (all, factor) = scene.view_scene_within(&fine, usize::MAX);
    assert_eq!(factor, 1.0);
    let limit = all.triangle_count() / 3;
    let (some, factor) = scene.view_scene_within(&fine, limit);
    assert!(some.triangle_count() <= limit && some.triangle_count() > limit / 4, "{}", some.triangle_count());
    assert!(factor > 1.0);
    let (least, _) = scene.view_scene_within(&fine, 0);
    assert_eq!(least.triangle_count(), base_of(&scene));
}

#[test]
fn nothing_behind_the_camera_is_refined() {
    let scene = sample(&scenes::hierarchy());
    let away = scene.view_scene(&error([0.0, 0.0, 1e4], [0.0, 0.0, 2e4], 1e-3));
    assert_eq!(away.triangle_count(), base_of(&scene));
}

/// Number of triangles that the base scene shows.
fn base_of(scene: &LodScene) -> usize {
    scene.level_scene(&scene.level(Target::Detail(0.0))).triangle_count()
}
