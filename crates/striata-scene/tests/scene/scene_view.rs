//! Triangles for renderers: levels of the whole scene, and detail for a camera that moves.

use striata::Target;
use striata::view::{Camera, ScreenError};
use striata::{
    LodOptions,
    mesh::{Bounds, shapes},
};
use striata_io::{Scene, SceneParts, Source, read_scene_bytes};
use striata_scene::drawn::DrawnInstance;
use striata_scene::{LodScene, Poser, SceneView};
use striata_testing::scenes;

fn sample(sample: &scenes::TestScene) -> LodScene {
    let scene = read_scene_bytes(&sample.to_glb(), &Source::new("test.glb")).unwrap();
    LodScene::build(&scene, &LodOptions::default()).unwrap()
}

fn all() -> [LodScene; 5] {
    [
        scenes::hierarchy(),
        scenes::skinned(),
        scenes::morphed(),
        scenes::without_nodes(),
        scenes::instanced_by_extension(),
    ]
    .map(|scene| sample(&scene))
}

fn rest(lods: &LodScene) -> Vec<DrawnInstance> {
    let poser = Poser::new(lods.scene()).unwrap();
    poser.instances(lods.scene(), &poser.rest_pose())
}

/// A view of the scene from a distance in multiples of its diagonal.
fn error(lods: &LodScene, distance: f32, pixels: f32) -> ScreenError {
    let Bounds { min, max } = lods.full_scene().bounds().unwrap();
    let center = [0, 1, 2].map(|i| f32::midpoint(min[i], max[i]));
    let diagonal = lods.full_scene().diagonal() as f32;
    let eye = [center[0], center[1] + 0.2 * diagonal, center[2] + distance * diagonal];
    ScreenError::new(Camera::new(eye, center, [0.0, 1.0, 0.0], 0.5, [1280, 720]).unwrap(), pixels)
}

fn sum_of_instances(view: &SceneView, lods: &LodScene) -> usize {
    let instances = 0..lods.scene().instances().len();
    instances.filter_map(|at| Some(view.shown(at)?.indices.len() / 3)).sum()
}

#[test]
fn levels_show_what_their_scenes_contain() {
    for lods in all() {
        let mut view = lods.view();
        for detail in [0.0, 0.4, 1.0] {
            let level = lods.level(Target::Detail(detail));
            view.show_level(&level);
            let scene = lods.level_scene(&level);
            assert_eq!(view.triangle_count(), scene.triangle_count(), "at {detail}");
            assert_eq!(sum_of_instances(&view, &lods), view.triangle_count());
            for (at, instance) in scene.instances().iter().enumerate() {
                let shown = view.shown(at).unwrap();
                let groups = scene.primitive_materials(instance.mesh).len();
                assert_eq!(shown.groups.len(), groups, "a range for each primitive");
            }
        }
    }
}

#[test]
fn unchanged_lists_keep_their_revision() {
    let lods = sample(&scenes::hierarchy());
    let mut view = lods.view();
    let revisions = |view: &SceneView| -> Vec<(usize, u64)> {
        let instances = 0..lods.scene().instances().len();
        instances.filter_map(|at| view.shown(at)).map(|shown| (shown.list, shown.revision)).collect()
    };
    view.show_level(&lods.level(Target::Detail(0.5)));
    let before = revisions(&view);
    view.show_level(&lods.level(Target::Detail(0.5)));
    assert_eq!(revisions(&view), before);
    view.show_level(&lods.level(Target::Detail(1.0)));
    assert_ne!(revisions(&view), before);
    let (drawn, near) = (rest(&lods), error(&lods, 0.8, 0.5));
    view.update(&near, &drawn);
    let before = revisions(&view);
    view.update(&near, &drawn);
    assert_eq!(revisions(&view), before, "a camera that rests changes nothing");
}

#[test]
fn near_cameras_see_more_triangles_than_far_ones() {
    for lods in all() {
        let (mut view, drawn) = (lods.view(), rest(&lods));
        let mut counts = Vec::new();
        for distance in [1.2, 20.0, 5000.0] {
            view.update(&error(&lods, distance, 0.5), &drawn);
            counts.push(view.triangle_count());
        }
        assert!(counts.is_sorted_by(|near, far| near >= far) && counts[0] > counts[2], "{counts:?}");
    }
}

#[test]
fn a_single_rigid_instance_shows_what_the_scene_of_the_view_contains() {
    let lods = sample(&scenes::without_nodes());
    let (mut view, error) = (lods.view(), error(&lods, 0.8, 1.0));
    view.update(&error, &rest(&lods));
    assert_eq!(view.triangle_count(), lods.view_scene(&error).triangle_count());
}

#[test]
fn budgets_hold_while_the_camera_moves() {
    for lods in all() {
        let (mut view, drawn) = (lods.view(), rest(&lods));
        let full = lods.triangle_count();
        let base = lods.levels().base_triangle_count();
        for limit in [full / 2, full / 5] {
            for step in 0..12 {
                let near = 0.6 + 0.3 * (step as f32 * 0.9).sin();
                view.update_to_budget(&error(&lods, near, 0.01), &drawn, limit);
                let count = view.triangle_count();
                assert!(count <= limit.max(base), "{count} of {limit}, base {base}");
            }
        }
        view.update_to_budget(&error(&lods, 0.6, 0.01), &drawn, 0);
        assert_eq!(view.triangle_count(), base, "at least the base is shown");
        let factor = view.update_to_budget(&error(&lods, 0.6, 0.5), &drawn, usize::MAX);
        assert_eq!(factor, 1.0, "a large limit changes nothing");
    }
}

#[test]
fn hidden_instances_do_not_count() {
    let lods = sample(&scenes::hierarchy());
    let (mut view, drawn) = (lods.view(), rest(&lods));
    view.show_level(&lods.level(Target::Detail(1.0)));
    let (all, first) = (view.triangle_count(), view.shown(0).unwrap().indices.len() / 3);
    view.set_hidden(0, true);
    assert!(view.is_hidden(0) && !view.is_hidden(1));
    assert_eq!(view.triangle_count(), all - first);
    view.update_to_budget(&error(&lods, 0.6, 0.01), &drawn, all / 3);
    assert!(view.triangle_count() <= all / 3);
    view.set_hidden(usize::MAX, true);
}

#[test]
fn detail_follows_instances_that_move() {
    let lods = sample(&scenes::without_nodes());
    let (mut view, mut drawn) = (lods.view(), rest(&lods));
    let error = error(&lods, 0.7, 0.5);
    view.update(&error, &drawn);
    let near = view.triangle_count();
    for instance in &mut drawn {
        instance.world[14] -= 1e5;
    }
    view.update(&error, &drawn);
    assert!(view.triangle_count() < near, "{} of {near}", view.triangle_count());
    for instance in &mut drawn {
        instance.world = [f64::NAN; 16];
    }
    view.update(&error, &drawn);
    assert!(view.triangle_count() > 0, "broken places show some level");
}

/// Two equal spheres side by side, of which the second has an importance.
fn two_spheres(importance: f64) -> LodScene {
    let node = |x: f64, mesh: usize| serde_json::json!({ "mesh": mesh, "translation": [x, 0, 0] });
    let mut second = node(2.0, 1);
    second["extras"] = serde_json::json!({ "importance": importance });
    let mesh = serde_json::json!({ "primitives": [{ "attributes": { "POSITION": null } }] });
    let parts = SceneParts {
        document: serde_json::json!({
            "scene": 0, "scenes": [{ "nodes": [0, 1] }], "nodes": [node(-2.0, 0), second], "meshes": [mesh, mesh],
        }),
        buffer: Vec::new(),
        images: Vec::new(),
        meshes: vec![Some(shapes::icosphere(4, 1.0)); 2],
    };
    LodScene::build(&Scene::from_parts(parts).unwrap(), &LodOptions::default()).unwrap()
}

#[test]
fn important_objects_get_more_triangles() {
    let counts = |lods: &LodScene| {
        let level = lods.level(Target::Triangles(lods.triangle_count() / 10));
        let scene = lods.level_scene(&level);
        [0, 1].map(|mesh| scene.meshes()[mesh].as_ref().unwrap().triangle_count())
    };
    let [first, second] = counts(&two_spheres(1.0));
    assert_eq!(first, second);
    let important = two_spheres(4.0);
    let [first, second] = counts(&important);
    assert!(second > 2 * first, "{first} and {second} triangles");
    assert!(first + second <= important.triangle_count() / 10);
    // An error is not exceeded anywhere, whatever the importance.
    let largest = important.level(Target::Triangles(500)).error;
    let by_error =
        [1.0, 4.0].map(|importance| two_spheres(importance).level(Target::Error(largest)).split_counts);
    assert_eq!(by_error[0], by_error[1]);

    let (mut view, drawn) = (important.view(), rest(&important));
    let error = error(&important, 1.0, 1.0);
    let mut shown = |importance: f64| {
        view.set_importance(1, importance);
        view.update(&error, &drawn);
        [0, 1].map(|instance| view.shown(instance).unwrap().indices.len() / 3)
    };
    let ([near, important_near], [_, equal], [_, negligible]) = (shown(4.0), shown(1.0), shown(0.25));
    assert!(important_near > 2 * near && important_near > 2 * equal && equal > 2 * negligible);
    assert_eq!(shown(f64::NAN), shown(-1.0), "what is no importance changes nothing");
    for (extreme, largest) in [(1e300, 1e6), (1e-300, 1e-6)] {
        let levels =
            [extreme, largest].map(|importance| two_spheres(importance).level(Target::Triangles(2000)));
        assert_eq!(levels[0], levels[1], "importance has limits");
    }
    let scene = important.view_scene(&error);
    let of_scene = [0, 1].map(|mesh| scene.meshes()[mesh].as_ref().unwrap().triangle_count());
    assert_eq!(of_scene, [near, important_near]);
}
