//! Tests of scenes in the viewer: pictures, animation, budgets and nodes.

use std::path::Path;

use serde_json::json;
use striata::mesh::{AttributeLayer, IndexedMesh, Semantic};
use striata_gpu::{Gpu, GpuOptions, Picture};
use striata_scene::drawn::{ImageLimits, lights, posed_mesh};
use striata_testing::scenes::{self, TestScene};

use super::*;
use crate::picture::{Camera, Paint, PictureRenderer, SceneLook, Shot, Style};
use crate::window::scene_renderer::SceneRenderer;

/// A viewer with a renderer, as in a window.
struct Drawing {
    test: TestViewer,
    renderer: SceneRenderer,
    gpu: Gpu,
    _folder: tempfile::TempDir,
}

impl Drawing {
    fn of(scene: &TestScene) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("scene.glb");
        std::fs::write(&path, scene.to_glb()).expect("a file");
        let test = TestViewer::with(path, ViewerState::default());
        let fallback = Gpu::new(&GpuOptions::default().with_fallback(true));
        let gpu = fallback
            .or_else(|_| Gpu::new(&GpuOptions::default()))
            .expect("these tests need a graphics adapter; install mesa-vulkan-drivers for a CPU one");
        let mut renderer = SceneRenderer::new(gpu.clone());
        renderer.load(test.viewer.subject().expect("the scene is open")).expect("it fits");
        Self { test, renderer, gpu, _folder: folder }
    }

    /// Returns the picture that the window would show now.
    fn picture(&mut self) -> Picture {
        self.picture_of([160, 120])
    }

    fn picture_of(&mut self, size: [u32; 2]) -> Picture {
        self.test.frame(vec![], vec![]);
        self.test.viewer.area.size = size;
        self.test.viewer.follow();
        // The frame of the test has taken the news.
        self.test.viewer.is_new = true;
        let frame = self.test.viewer.draw(&mut self.renderer, Instant::now()).expect("it is drawn");
        assert!(frame.is_drawn);
        self.renderer.read(&self.gpu).expect("it can be read")
    }

    fn scene(&mut self) -> (Arc<SceneSubject>, &mut ShownScene, &mut Playback) {
        self.test.viewer.scene_mut().expect("a scene is shown")
    }
}

/// A square whose left half is red and whose right half is blue, without lighting.
fn painted_square() -> TestScene {
    let mut png = Vec::new();
    let mut encoder = png::Encoder::new(&mut png, 2, 1);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&[200, 10, 20, 10, 20, 200]).expect("two pixels");
    writer.finish().expect("an image");
    let corners = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    let mut mesh = IndexedMesh::new(corners.to_vec(), vec![[0, 1, 2], [0, 2, 3]]);
    let uv = vec![0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uv));
    let mut scene = TestScene::named("painted square");
    let view = scene.push_view(&png);
    scene.push("images", json!({ "bufferView": view, "mimeType": "image/png" }));
    scene.push("samplers", json!({ "magFilter": 9728, "minFilter": 9728 }));
    scene.push("textures", json!({ "source": 0, "sampler": 0 }));
    scene.push(
        "materials",
        json!({
            "name": "paint",
            "doubleSided": true,
            "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } },
            "extensions": { "KHR_materials_unlit": {} },
        }),
    );
    let mesh = scene.push_mesh("square", &mesh);
    scene.document["meshes"][mesh]["primitives"][0]["material"] = json!(0);
    scene.document["nodes"] = json!([{ "mesh": mesh, "name": "wall" }]);
    scene.document["scenes"] = json!([{ "nodes": [0] }]);
    scene
}

fn pixel(picture: &Picture, x: f32, y: f32) -> [u8; 3] {
    let at = |share: f32, side: u32| (share * side as f32) as u32;
    let index = 4 * (at(y, picture.height) * picture.width + at(x, picture.width)) as usize;
    [0, 1, 2].map(|k| picture.rgba[index + k])
}

fn is_near(found: [u8; 3], expected: [u8; 3]) -> bool {
    found.iter().zip(expected).all(|(&a, b)| a.abs_diff(b) <= 3)
}

fn differing_share(a: &Picture, b: &Picture) -> f64 {
    let pixels = a.rgba.chunks(4).zip(b.rgba.chunks(4));
    let count = pixels.filter(|(a, b)| a.iter().zip(*b).any(|(x, y)| x.abs_diff(*y) > 8)).count();
    count as f64 / (a.rgba.len() / 4) as f64
}

#[test]
fn scenes_are_shown_with_their_textures() {
    let mut drawing = Drawing::of(&painted_square());
    let picture = drawing.picture();
    let [left, right] = [0.4, 0.6].map(|x| pixel(&picture, x, 0.5));
    assert!(is_near(left, [200, 10, 20]) && is_near(right, [10, 20, 200]), "{left:?} {right:?}");
    let (subject, ..) = drawing.scene();
    assert_eq!(subject.rows.iter().map(|row| &row.name[..]).collect::<Vec<_>>(), ["wall"]);
}

#[test]
fn the_window_shows_what_pictures_show() {
    let mut tube = scenes::skinned();
    tube.document["meshes"][0]["primitives"][0]["material"] = json!(0);
    for (scene, time) in [(painted_square(), 0.0), (scenes::hierarchy(), 0.0), (tube, 0.5)] {
        let mut drawing = Drawing::of(&scene);
        let (subject, _, playback) = drawing.scene();
        playback.animation = (subject.poser.animation_count() > 0).then_some(0);
        playback.time = time;
        let pose = playback.animation.map_or(subject.poser.rest_pose(), |at| subject.poser.pose(at, time));
        let full = subject.lods.full_scene();
        let mesh = posed_mesh(&full, &subject.poser, &pose).expect("it is small");
        let look = SceneLook::of(&full, &ImageLimits::default()).with_lights(lights(&full, &pose));
        let shot = Shot { look: Some(&look), ..Shot::of(&mesh, Paint::Surface, Style::SMOOTH) };
        // Large and near, so that edges, which pictures smooth more, are few pixels.
        drawing.test.viewer.orbit.zoom(0.5);
        let found = drawing.picture_of([480, 360]);
        let Viewpoint { eye, look_at, up, fov } = drawing.test.viewer.orbit.viewpoint();
        let size = drawing.test.viewer.area.size.map(|side| side as usize);
        let mut renderer = PictureRenderer::best(&Output::quiet());
        let expected = renderer.draw(&shot, &Camera { eye, look_at, up, fov }, size).canvas;
        let drawn_count = expected.pixels().iter().filter(|pixel| pixel[3] > 0.5).count();
        assert!(drawn_count > 500, "{}: {drawn_count} pixels", scene.name);
        let viewer = &drawing.test.viewer;
        let background = viewer.state.look(viewer.area.is_dark, 1.0).background;
        let difference = mean_difference(&found, &expected, background) * found.rgba.len() as f64 / 4.0;
        let mean = difference / drawn_count as f64;
        assert!(mean < 4.0, "{}: mean difference {mean} of 255", scene.name);
    }
}

/// Mean difference per channel of a picture and a canvas over a background of linear light, of 255.
fn mean_difference(picture: &Picture, canvas: &crate::picture::Canvas, background: [f32; 4]) -> f64 {
    let pairs = picture.rgba.chunks(4).zip(canvas.pixels());
    let sum: f64 = pairs
        .flat_map(|(found, &expected)| {
            let behind = 1.0 - expected[3];
            [0, 1, 2].map(|k| {
                let light = expected[k] + behind * background[k];
                (f64::from(found[k]) - 255.0 * f64::from(striata_gpu::linear_to_srgb(light))).abs()
            })
        })
        .sum();
    sum / (3 * canvas.pixels().len()) as f64
}

#[test]
fn wireframes_and_colors_of_scenes_are_drawn_in_their_pose() {
    let mut drawing = Drawing::of(&painted_square());
    let lit = drawing.picture();
    drawing.test.press(Key::W);
    let edges = drawing.picture();
    assert!(differing_share(&lit, &edges) > 0.05);
    drawing.test.press(Key::W);
    drawing.test.viewer.state.colors = Colors::Triangles;
    let triangles = drawing.picture();
    assert_ne!(pixel(&triangles, 0.4, 0.4), pixel(&triangles, 0.6, 0.6), "two triangles, two colors");
    drawing.test.viewer.state.colors = Colors::Surface;
    assert_eq!(drawing.picture(), lit);
    let mut drawing = Drawing::of(&scenes::bending_tube());
    let outline = |picture: &Picture| -> Vec<bool> {
        let background = &picture.rgba[..4];
        picture.rgba.chunks(4).map(|pixel| pixel != background).collect()
    };
    let (subject, _, playback) = drawing.scene();
    let end = subject.poser.duration(0);
    (playback.animation, playback.time) = (Some(0), end);
    let surface = outline(&drawing.picture());
    drawing.test.press(Key::W);
    let edges = outline(&drawing.picture());
    let differing = surface.iter().zip(&edges).filter(|(a, b)| a != b).count();
    assert!(differing < surface.len() / 100, "{differing} pixels");
}

#[test]
fn hidden_nodes_disappear_and_come_back() {
    let mut drawing = Drawing::of(&painted_square());
    let before = drawing.picture();
    let (subject, shown, _) = drawing.scene();
    shown.set_hidden(&subject, 0, true);
    let hidden = drawing.picture();
    assert_eq!(drawing.test.triangle_count(), 0);
    assert_eq!(pixel(&hidden, 0.4, 0.5), pixel(&hidden, 0.01, 0.01), "only the background is left");
    let (subject, shown, _) = drawing.scene();
    shown.set_hidden(&subject, 0, false);
    assert_eq!(drawing.picture(), before);
}

#[test]
fn hiding_a_node_hides_what_is_below_it() {
    let mut drawing = Drawing::of(&scenes::hierarchy());
    let all = drawing.test.triangle_count();
    let (subject, shown, _) = drawing.scene();
    let row = subject.rows.iter().position(|row| row.name == "right").expect("it shows meshes");
    assert_eq!(subject.rows[row].end, row + 3, "with two nodes below");
    shown.set_hidden(&subject, row, true);
    drawing.test.frame(vec![], vec![]);
    let fewer = drawing.test.triangle_count();
    let (subject, shown, _) = drawing.scene();
    shown.set_hidden(&subject, row + 1, true);
    shown.set_hidden(&subject, row, false);
    drawing.test.frame(vec![], vec![]);
    let some = drawing.test.triangle_count();
    assert!(fewer < some && some < all, "{fewer} {some} {all}");
}

#[test]
fn the_time_slider_moves_vertices_and_not_indices() {
    let mut drawing = Drawing::of(&scenes::bending_tube());
    let rest = drawing.picture();
    let bytes = drawing.renderer.uploaded_bytes();
    let (subject, _, playback) = drawing.scene();
    let duration = subject.poser.duration(0);
    playback.choose(Some(0));
    playback.time = duration;
    let bent = drawing.picture();
    assert!(differing_share(&rest, &bent) > 0.02, "{}", differing_share(&rest, &bent));
    assert_eq!(drawing.renderer.uploaded_bytes(), bytes, "no index was uploaded");
    let (_, _, playback) = drawing.scene();
    playback.choose(None);
    assert_eq!(drawing.picture(), rest);
}

#[test]
fn space_plays_and_pauses_and_time_begins_again_at_the_end() {
    let mut drawing = Drawing::of(&scenes::bending_tube());
    drawing.test.press(Key::Space);
    let (subject, _, playback) = drawing.scene();
    assert_eq!((playback.animation, playback.is_playing), (Some(0), true));
    let duration = subject.poser.duration(0);
    playback.advance(0.25 * duration, &subject.poser);
    let early = playback.time;
    playback.advance(0.9 * duration, &subject.poser);
    assert!(playback.time < duration && playback.time > 0.0 && early > 0.0, "{early} {playback:?}");
    drawing.test.press(Key::Space);
    let (_, _, playback) = drawing.scene();
    let paused = *playback;
    drawing.test.frame(vec![], vec![]);
    assert_eq!(*drawing.scene().2, paused);
}

#[test]
fn budgets_and_levels_hold_for_the_whole_scene() {
    let mut drawing = Drawing::of(&scenes::hierarchy());
    let full = drawing.test.triangle_count();
    for goal in [GoalKind::Triangles, GoalKind::Budget] {
        drawing.test.viewer.state.set_goal(goal);
        for count in [full / 2, full / 3] {
            (drawing.test.viewer.state.triangles, drawing.test.viewer.state.budget) =
                (Some(count), Some(count));
            let before = drawing.picture();
            let found = drawing.test.triangle_count();
            assert!(found <= count && found > count / 4, "{goal:?}: {found} of {count}");
            drawing.test.press(Key::ArrowLeft);
            assert!(drawing.test.triangle_count() <= count, "{goal:?}");
            assert_ne!(drawing.picture(), before);
        }
    }
    drawing.test.viewer.state.set_goal(GoalKind::Pixels);
    drawing.picture();
    let near = drawing.test.triangle_count();
    (0..20).for_each(|_| drawing.test.press(Key::Minus));
    assert!(drawing.test.triangle_count() < near, "a far camera needs fewer triangles");
}

#[test]
fn focusing_a_node_frames_it() {
    let mut drawing = Drawing::of(&scenes::hierarchy());
    let (subject, shown, _) = drawing.scene();
    let row = subject.rows.iter().position(|row| row.name == "left").expect("it shows a mesh");
    let bounds = shown.bounds_of(&subject, row).expect("it has vertices");
    let before = drawing.test.viewer.orbit.viewpoint();
    drawing.test.viewer.orbit.frame(&bounds);
    let view = drawing.test.viewer.orbit.viewpoint();
    assert_ne!(view.look_at, before.look_at);
    let center = [0, 1, 2].map(|k| f32::midpoint(bounds.min[k], bounds.max[k]));
    assert!(center.iter().zip(view.look_at).all(|(a, b)| (a - b).abs() < 1e-4), "{center:?} {view:?}");
}

fn opened(path: &Path, as_scene: bool) -> TestViewer {
    TestViewer::with(path, ViewerState { as_scene, ..ViewerState::default() })
}

#[test]
fn materials_decide_whether_a_mesh_is_shown_as_a_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    std::fs::write(at("a.mtl"), "newmtl paint\nKd 1 0 0\n").expect("a file");
    std::fs::write(at("paint.obj"), format!("mtllib a.mtl\n{triangle}usemtl paint\nf 1 2 3\n"))
        .expect("a file");
    std::fs::write(at("bare.obj"), format!("{triangle}f 1 2 3\n")).expect("a file");
    assert!(opened(&at("paint.obj"), true).viewer.scene().is_some());
    let as_mesh = opened(&at("paint.obj"), false);
    assert!(as_mesh.viewer.instance().is_some());
    assert!(as_mesh.viewer.subject().is_some_and(|subject| subject.origin().has_scene));
    let bare = opened(&at("bare.obj"), true);
    assert!(bare.viewer.instance().is_some());
    assert!(!bare.viewer.subject().is_some_and(|subject| subject.origin().has_scene));
}

#[test]
fn the_next_model_of_a_scene_is_that_of_its_mesh_and_back() {
    let mut drawing = Drawing::of(&scenes::hierarchy());
    let full = drawing.test.triangle_count();
    drawing.test.press(Key::M);
    drawing.test.settle();
    assert_eq!(drawing.test.viewer.instance().map(ModelInstance::kind), Some(ShownModel::LodStrips));
    drawing.test.viewer.show_as_scene();
    drawing.test.settle();
    assert!(drawing.test.viewer.scene().is_some());
    assert_eq!(drawing.test.triangle_count(), full);
}

#[test]
fn poses_of_flags_need_a_scene_with_this_animation() {
    let pose = |time: f32, animation: Option<&str>| PoseArgs {
        time: Some(time),
        animation: animation.map(str::to_owned),
    };
    let drawing = Drawing::of(&scenes::bending_tube());
    let subject = drawing.test.viewer.subject().expect("a scene").clone();
    let found = first_playback(&pose(0.5, None), &subject).expect("there is an animation");
    assert_eq!((found.animation, found.time, found.is_playing), (Some(0), 0.5, false));
    assert!(first_playback(&pose(0.5, Some("jump")), &subject).is_err());
    let cube = TestViewer::new("shape:cube");
    let cube = cube.viewer.subject().expect("a mesh");
    assert!(first_playback(&pose(0.5, None), cube).is_err());
    assert!(first_playback(&PoseArgs::default(), cube).is_ok());
}
