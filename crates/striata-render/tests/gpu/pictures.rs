//! One level gives the same picture as a list, as strips with restart, with one draw per strip, and as
//! single triangles.

use std::ops::Range;

use crate::support::{differing_pixels, drawn_pixels, gpu};
use bytemuck::cast_slice;
use striata::mesh::{IndexedMesh, RefinableMesh, shapes};
use striata::model::{Fans, LodModel, LodStrips, StoredModel, StripBuffer};
use striata::simplify::build_sequence;
use striata::strip::stripify;
use striata_render::Camera;
use striata_render::gpu::{
    Canvas, Drawing, Gpu, GpuIndices, GpuMultiDraw, GpuVertices, Inspection, Look, Painter, Picture, Scene,
    wgpu,
};

const SIZE: [u32; 2] = [240, 200];

struct PictureTest {
    gpu: Gpu,
    painter: Painter,
    canvas: Canvas,
    vertices: GpuVertices,
    scene: Scene,
    look: Look,
}

impl PictureTest {
    fn new(mesh: &IndexedMesh, look: Look) -> Self {
        let gpu = gpu();
        let painter = Painter::new(&gpu, 1);
        let canvas = Canvas::new(&gpu, SIZE, 1).unwrap();
        let vertices = GpuVertices::upload(&gpu, mesh).unwrap();
        let view = Camera::portrait(&mesh.bounds().unwrap(), 0.7, 0.35, 0.6);
        let scene = painter.scene(&gpu, &vertices, (&view, SIZE), &look).unwrap();
        Self { gpu, painter, canvas, vertices, scene, look }
    }

    fn draw(&self, drawing: Drawing<'_>) -> Picture {
        let paint = |pass: &mut wgpu::RenderPass<'_>| {
            self.painter.draw(pass, &self.scene, &self.vertices, drawing);
        };
        self.canvas.paint(&self.gpu, self.look.background, paint).unwrap()
    }

    fn list(&self, triangles: &[[u32; 3]]) -> Picture {
        let indices = GpuIndices::upload(&self.gpu, cast_slice(triangles)).unwrap();
        let whole = 0..3 * triangles.len() as u32;
        self.draw(Drawing::List { indices: &indices, groups: std::slice::from_ref(&whole) })
    }
}

fn refinable(mesh: &IndexedMesh) -> RefinableMesh {
    build_sequence(mesh, &Default::default()).unwrap().refinable
}

fn lod_strips(refinable: &RefinableMesh) -> LodStrips<'static> {
    let strips = stripify(&refinable.mesh).unwrap();
    LodStrips::build(refinable, &strips).unwrap()
}

fn levels(step_count: usize) -> impl DoubleEndedIterator<Item = usize> {
    (0..=12).map(move |part| step_count * part / 12)
}

/// Draws every level in every way. Back faces are culled, so that a flipped triangle leaves a hole.
fn all_ways_agree(mesh: &IndexedMesh, name: &str) {
    let refinable = refinable(mesh);
    let test =
        PictureTest::new(&refinable.mesh, Look { hides_back: true, shows_groups: true, ..Look::default() });
    let (model, fans) = (lod_strips(&refinable), Fans::build(&refinable));
    let (mut state, mut fan_state) = (model.new_state(), fans.new_state());
    let mut buffer = StripBuffer::new(&model, &mut state);
    let mut strips = GpuIndices::upload(&test.gpu, buffer.indices()).unwrap();
    let mut draws = GpuMultiDraw::new(&test.gpu, 16).unwrap();
    let mut drawn = 0;
    for split_count in levels(refinable.sequence.step_count()).rev() {
        model.move_to(&mut state, split_count);
        buffer.sync(&model, &mut state);
        let changed = buffer.take_changed_ranges();
        strips.write_ranges(&test.gpu, buffer.indices(), &changed);
        let groups: Vec<Range<u32>> = buffer.group_ranges().collect();
        let by_strips = test.draw(Drawing::Strips { indices: &strips, groups: &groups });

        let (mut list, mut list_groups) = (Vec::new(), Vec::new());
        for group in 0..model.group_count() {
            let first = list.len() as u32;
            fans.move_to(&mut fan_state, split_count);
            let mut triangles = Vec::new();
            fans.group_triangles_into(&fan_state, group, &mut triangles);
            list.extend(triangles.into_iter().flatten());
            list_groups.push(first..list.len() as u32);
        }
        let indices = GpuIndices::upload(&test.gpu, &list).unwrap();
        let by_list = test.draw(Drawing::List { indices: &indices, groups: &list_groups });
        drawn += drawn_pixels(&by_list);
        let differing = differing_pixels(&by_list, &by_strips, 2);
        assert!(differing <= 4, "{name}, level {split_count}: strips differ in {differing} pixels");

        if model.group_count() == 1 {
            draws.write(&test.gpu, buffer.strip_ranges()).unwrap();
            let by_draws = test.draw(Drawing::MultiStrips { indices: &strips, draws: &draws });
            let differing = differing_pixels(&by_list, &by_draws, 2);
            assert!(differing <= 4, "{name}, level {split_count}: draws differ in {differing} pixels");
        }
    }
    assert!(drawn > 13 * 500, "{name}: too little was drawn: {drawn} pixels");
}

#[test]
fn lists_strips_and_draws_give_one_picture_at_all_levels() {
    all_ways_agree(&shapes::icosphere(4, 1.0), "sphere");
    all_ways_agree(&shapes::terrain(40, 7), "terrain");
    all_ways_agree(&shapes::two_material_sphere(16, 24), "two materials");
    all_ways_agree(&shapes::uv_cylinder(40, 12), "seams");
    all_ways_agree(&shapes::moebius_strip(40), "moebius");
}

#[test]
fn single_triangles_match_and_show_their_colors_and_edges() {
    let mesh = shapes::icosphere(3, 2.0);
    let mut test = PictureTest::new(&mesh, Look::default());
    let by_list = test.list(&mesh.triangles);
    let [r, g, b] = test.look.base.map(|x| (255.0 * x + 0.5) as u8);
    let colors = vec![[r, g, b, 255]; mesh.triangle_count()];
    let inspect = |test: &PictureTest, colors: &[[u8; 4]]| {
        let PictureTest { gpu, painter, vertices, .. } = test;
        let inspection = Inspection::new(gpu, painter, vertices, &mesh.triangles, colors).unwrap();
        let paint = |pass: &mut wgpu::RenderPass<'_>| test.painter.inspect(pass, &test.scene, &inspection);
        test.canvas.paint(&test.gpu, test.look.background, paint).unwrap()
    };
    let plain = inspect(&test, &colors);
    assert!(differing_pixels(&by_list, &plain, 3) <= 4);

    let striped: Vec<[u8; 4]> = (0..colors.len() as u32).map(striata_render::gpu::palette_color).collect();
    let colored = inspect(&test, &striped);
    assert!(differing_pixels(&by_list, &colored, 8) > drawn_pixels(&by_list) / 2);

    let view = Camera::portrait(&mesh.bounds().unwrap(), 0.7, 0.35, 0.6);
    let look = Look { edges: [0.0, 0.0, 0.0, 1.0], ..test.look };
    test.scene.update(&test.gpu, &test.vertices, (&view, SIZE), &look);
    let edged = inspect(&test, &colors);
    let lines = differing_pixels(&plain, &edged, 30);
    assert!(lines > 2000 && lines < drawn_pixels(&plain), "{lines} pixels of lines");
}

#[test]
fn a_mesh_far_from_zero_or_tiny_looks_the_same() {
    let mesh = shapes::icosphere(3, 1.0);
    let near = PictureTest::new(&mesh, Look::default()).list(&mesh.triangles);
    for (scale, shift) in [(1e-7f32, 0.0f32), (1e6, 0.0), (1.0, 4096.0)] {
        let mut moved = mesh.clone();
        for position in &mut moved.positions {
            *position = position.map(|x| x * scale + shift);
        }
        let picture = PictureTest::new(&moved, Look::default()).list(&moved.triangles);
        // Moving the mesh rounds positions to 0.0005, so silhouettes shift by a fraction of a pixel.
        let differing = differing_pixels(&near, &picture, 12);
        assert!(differing < 60, "x {scale} + {shift}: {differing} pixels");
    }
}

#[test]
fn empty_drawings_and_impossible_sizes() {
    let gpu = gpu();
    let mesh = IndexedMesh::new(Vec::new(), Vec::new());
    let vertices = GpuVertices::upload(&gpu, &mesh).unwrap();
    let painter = Painter::new(&gpu, 4);
    let view = Camera { eye: [0.0, 0.0, 3.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov: 0.8 };
    let canvas = Canvas::new(&gpu, [65, 3], 4).unwrap();
    let scene = painter.scene(&gpu, &vertices, (&view, [65, 3]), &Look::default()).unwrap();
    let indices = GpuIndices::upload(&gpu, &[]).unwrap();
    let nothing = Drawing::List { indices: &indices, groups: &[] };
    let picture = canvas.paint(&gpu, [1.0, 0.0, 0.0, 1.0], |p| painter.draw(p, &scene, &vertices, nothing));
    let picture = picture.unwrap();
    assert_eq!((picture.width, picture.height, picture.rgba.len()), (65, 3, 4 * 65 * 3));
    assert!(picture.rgba.chunks(4).all(|pixel| pixel == [255, 0, 0, 255]));
    assert!(Canvas::new(&gpu, [0, 5], 1).is_err());
    let error = Canvas::new(&gpu, [5, 1 << 20], 1).unwrap_err();
    assert!(error.to_string().contains("5 x 1048576"), "{error}");
}
