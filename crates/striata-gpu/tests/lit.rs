//! Lit surfaces: textures, blending, light, and poses give the pictures that formulas predict.

mod support;

use std::f32::consts::PI;
use std::sync::{Arc, LazyLock};

use bytemuck::cast_slice;
use glam::{DMat4, DVec3};
use striata::mesh::{AttributeLayer, IndexedMesh, LayerData, Semantic, shapes};
use striata_gpu::{
    AlphaMode, Canvas, Environment, Gpu, GpuError, GpuIndices, LitCamera, LitFrame, LitImage, LitLight,
    LitLightKind, LitMaterial, LitMaterials, LitObject, LitPainter, LitPart, LitScene, LitVertices, Picture,
    TextureFilter, TextureSampler, TextureUse, linear_to_srgb, wgpu,
};
use support::{differing_pixels, gpu};

const SIDE: u32 = 64;

/// A camera that sees the square from -1 to 1 exactly, from 10 units away.
fn camera() -> LitCamera {
    let fov = 2.0 * (0.1f64).atan();
    LitCamera { eye: [0.0, 0.0, 10.0], look_at: [0.0; 3], up: [0.0, 1.0, 0.0], fov }
}

/// A device and a painter for all tests: opening and compiling takes longer than drawing.
static SHARED: LazyLock<(Gpu, Arc<LitPainter>)> = LazyLock::new(|| {
    let gpu = gpu();
    let painter = LitPainter::new(&gpu, Canvas::FORMAT, 1);
    (gpu, Arc::new(painter))
});

struct LitTest {
    gpu: Gpu,
    painter: Arc<LitPainter>,
    canvas: Canvas,
    environment: Environment,
    lights: Vec<LitLight>,
    materials: Vec<LitMaterial>,
    images: Vec<LitImage>,
    camera: LitCamera,
}

/// A mesh in a pose, as a test wants it drawn.
struct Shown<'a> {
    mesh: &'a IndexedMesh,
    material: Option<usize>,
    world_from_mesh: DMat4,
    joints: &'a [DMat4],
    morph_weights: &'a [f32],
}

impl<'a> Shown<'a> {
    fn new(mesh: &'a IndexedMesh) -> Self {
        let world_from_mesh = DMat4::IDENTITY;
        Self { mesh, material: Some(0), world_from_mesh, joints: &[], morph_weights: &[] }
    }

    fn at(mesh: &'a IndexedMesh, world_from_mesh: DMat4) -> Self {
        Self { world_from_mesh, ..Self::new(mesh) }
    }
}

impl LitTest {
    fn new(material: LitMaterial) -> Self {
        let (gpu, painter) = SHARED.clone();
        Self {
            painter,
            canvas: Canvas::new(&gpu, [SIDE; 2], 1).unwrap(),
            gpu,
            environment: Environment::uniform([1.0; 3]),
            lights: Vec::new(),
            materials: vec![material],
            images: Vec::new(),
            camera: camera(),
        }
    }

    fn draw(&self, shown: &[Shown<'_>]) -> Picture {
        self.try_draw(shown).unwrap()
    }

    fn try_draw(&self, shown: &[Shown<'_>]) -> Result<Picture, GpuError> {
        let materials = LitMaterials::upload(&self.gpu, &self.painter, &self.materials, &self.images)?;
        let mut uploaded = Vec::new();
        for shown in shown {
            let vertices = LitVertices::upload(&self.gpu, &self.painter, shown.mesh)?;
            let indices = GpuIndices::upload(&self.gpu, cast_slice(&shown.mesh.triangles))?;
            let range = 0..3 * shown.mesh.triangle_count() as u32;
            uploaded.push((vertices, indices, [LitPart { range, material: shown.material }]));
        }
        let objects: Vec<LitObject<'_>> = uploaded
            .iter()
            .zip(shown)
            .map(|((vertices, indices, parts), shown)| LitObject {
                vertices,
                indices,
                parts,
                world_from_mesh: shown.world_from_mesh,
                joints: shown.joints,
                morph_weights: shown.morph_weights,
            })
            .collect();
        let mut frame = LitFrame::new(&self.gpu, &self.painter, &self.environment)?;
        let scene = LitScene {
            camera: self.camera,
            size: [SIDE; 2],
            lights: &self.lights,
            materials: &materials,
            objects: &objects,
        };
        frame.update(&self.gpu, &self.painter, &scene)?;
        self.canvas.paint(&self.gpu, [0.0; 4], |pass| frame.draw(pass))
    }
}

/// The square from -1 to 1, facing the camera, with texture coordinates from the upper left as in glTF.
fn quad() -> IndexedMesh {
    let positions = vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
    let mut mesh = IndexedMesh::new(positions, vec![[0, 1, 2], [0, 2, 3]]);
    let normals = [[0.0, 0.0, 1.0]; 4].concat();
    let uv = vec![0.0, 1.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0];
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(0), 2, uv));
    mesh
}

fn unlit(base_color: [f32; 4]) -> LitMaterial {
    LitMaterial { base_color, is_unlit: true, ..LitMaterial::default() }
}

fn image(width: u32, height: u32, pixel: impl Fn(u32, u32) -> [u8; 4]) -> LitImage {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    LitImage { width, height, rgba: places.flat_map(|(x, y)| pixel(x, y)).collect() }
}

fn pixel(picture: &Picture, x: u32, y: u32) -> [u8; 4] {
    let start = 4 * (y * picture.width + x) as usize;
    std::array::from_fn(|k| picture.rgba[start + k])
}

fn srgb(light: f32) -> u8 {
    (255.0 * linear_to_srgb(light) + 0.5) as u8
}

#[track_caller]
fn assert_near(found: [u8; 4], expected: [u8; 4], tolerance: u8) {
    let is_near = found.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= tolerance);
    assert!(is_near, "{found:?}, not {expected:?}");
}

#[test]
fn an_unlit_textured_quad_shows_its_pixels() {
    let mut test = LitTest::new(LitMaterial {
        base_color_texture: Some(TextureUse {
            sampler: TextureSampler { mag_filter: TextureFilter::Nearest, ..Default::default() },
            ..TextureUse::of(0)
        }),
        ..unlit([1.0; 4])
    });
    let colors = |x: u32, y: u32| [(x * 60) as u8, (y * 60) as u8, 200 - (x * y) as u8, 255];
    test.images = vec![image(4, 4, colors)];
    let picture = test.draw(&[Shown::new(&quad())]);
    for y in 0..4 {
        for x in 0..4 {
            assert_near(pixel(&picture, 16 * x + 8, 16 * y + 8), colors(x, y), 1);
        }
    }
}

#[test]
fn a_white_furnace_returns_the_light_that_arrives() {
    let sphere = sphere();
    for metallic in [0.0, 1.0] {
        for roughness in [0.0, 0.2, 0.5, 0.8, 1.0] {
            let test = LitTest::new(LitMaterial { metallic, roughness, ..Default::default() });
            let picture = test.draw(&[Shown::new(&sphere)]);
            // Middle, halfway and near the edge.
            for x in [32, 46, 58] {
                let found = pixel(&picture, x, 32);
                let name = format!("metallic {metallic}, roughness {roughness}, at {x}: {found:?}");
                assert!(found[..3].iter().all(|&byte| byte >= 248), "{name}");
            }
        }
    }
}

/// A sphere of radius 1 with normals.
fn sphere() -> IndexedMesh {
    let mut mesh = shapes::icosphere(4, 1.0);
    mesh.layers.retain(|layer| layer.semantic != Semantic::Normal);
    let normals = mesh.positions.iter().copied().flatten().collect();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::Normal, 3, normals));
    mesh
}

#[test]
fn masked_pixels_are_there_or_not() {
    let mut test = LitTest::new(LitMaterial {
        base_color_texture: Some(TextureUse::of(0)),
        alpha_mode: AlphaMode::Mask { cutoff: 0.5 },
        ..unlit([1.0; 4])
    });
    test.images = vec![image(64, 64, |x, _| [255, 0, 0, if x < 32 { 120 } else { 135 }])];
    let picture = test.draw(&[Shown::new(&quad())]);
    assert_eq!(pixel(&picture, 16, 32), [0; 4]);
    assert_near(pixel(&picture, 48, 32), [255, 0, 0, 255], 1);
    // Opaque materials ignore the opacity.
    test.materials[0].alpha_mode = AlphaMode::Opaque;
    assert_near(pixel(&test.draw(&[Shown::new(&quad())]), 16, 32), [255, 0, 0, 255], 1);
}

#[test]
fn blended_quads_show_what_is_behind_them_in_any_order() {
    let blend = |color| LitMaterial { alpha_mode: AlphaMode::Blend, ..unlit(color) };
    let mut test = LitTest::new(unlit([1.0, 0.0, 0.0, 1.0]));
    test.materials.extend([blend([0.0, 1.0, 0.0, 0.5]), blend([0.0, 0.0, 1.0, 0.5])]);
    let mesh = quad();
    let layer = |material: usize, z| Shown {
        material: Some(material),
        ..Shown::at(&mesh, DMat4::from_translation(DVec3::new(0.0, 0.0, z)))
    };
    // Half of blue over half of green over red.
    let expected = [srgb(0.25), srgb(0.25), srgb(0.5), 255];
    for order in [[0, 1, 2], [2, 1, 0], [1, 2, 0]] {
        let layers = order.map(|material| layer(material, material as f64));
        assert_near(pixel(&test.draw(&layers), 32, 32), expected, 2);
    }
    // What is behind an opaque quad stays hidden.
    let hidden = test.draw(&[layer(1, -1.0), layer(0, 0.0)]);
    assert_near(pixel(&hidden, 32, 32), [255, 0, 0, 255], 1);
}

/// Light toward the scene along a direction, without any environment.
fn lamp(direction: [f32; 3]) -> LitLight {
    let kind = LitLightKind::Directional;
    LitLight { kind, color: [2.0; 3], position: [0.0; 3], direction, range: None }
}

fn lamp_test(material: LitMaterial, light: LitLight) -> LitTest {
    let mut test = LitTest::new(material);
    test.environment = Environment::uniform([0.0; 3]);
    test.lights = vec![light];
    test
}

/// A rough dielectric without highlights worth mentioning.
fn chalk() -> LitMaterial {
    LitMaterial { metallic: 0.0, roughness: 1.0, base_color: [0.8, 0.8, 0.8, 1.0], ..Default::default() }
}

#[test]
fn lamps_follow_the_formulas() {
    // Light and eye along the normal: every angle is 0, and the distribution of a roughness of 1 is 1 / pi.
    let f0 = 0.04;
    let diffuse = 0.8 / PI * (1.0 - f0);
    let specular = f0 / (4.0 * PI);
    let expected = 2.0 * (diffuse + specular);
    let front = lamp_test(chalk(), lamp([0.0, 0.0, -1.0]));
    let found = pixel(&front.draw(&[Shown::new(&quad())]), 32, 32);
    assert_near(found, [srgb(expected), srgb(expected), srgb(expected), 255], 2);

    // A point at twice the distance, and a spot that is off its axis.
    let place = |kind, position: [f64; 3]| LitLight { kind, position, ..lamp([0.0, 0.0, -1.0]) };
    let brightness = |light| pixel(&lamp_test(chalk(), light).draw(&[Shown::new(&quad())]), 32, 32)[0];
    let point = brightness(place(LitLightKind::Point, [0.0, 0.0, 2.0]));
    assert!(point.abs_diff(srgb(expected / 4.0)) <= 2, "{point}");
    let spot = LitLightKind::Spot { inner_angle: 0.1, outer_angle: 0.3 };
    assert_eq!(brightness(place(spot, [1.0, 0.0, 2.0])), 0);
    assert!(brightness(place(spot, [0.0, 0.0, 2.0])).abs_diff(point) <= 1);
    let near = LitLight { range: Some(1.9), ..place(LitLightKind::Point, [0.0, 0.0, 2.0]) };
    assert_eq!(brightness(near), 0);
}

#[test]
fn normal_maps_turn_the_shading_with_and_without_tangents() {
    // Tilted by 45 degrees toward the right of the image, or toward its top.
    let tilted = [[218, 128, 218, 255], [128, 218, 218, 255]];
    for (pixel_of_map, from) in tilted.into_iter().zip([[1.0, 0.0], [0.0, 1.0]]) {
        let material = LitMaterial { normal_texture: Some(TextureUse::of(0)), ..chalk() };
        let [x, y] = from;
        let mut test = lamp_test(material, lamp([-x, -y, -1.0]));
        test.images = vec![image(2, 2, |_, _| pixel_of_map)];
        let mut with_tangents = quad();
        let tangents = [[1.0, 0.0, 0.0, 1.0]; 4].concat();
        with_tangents.layers.push(AttributeLayer::from_f32(Semantic::Tangent, 4, tangents));
        for mesh in [quad(), with_tangents] {
            let towards = pixel(&test.draw(&[Shown::new(&mesh)]), 32, 32)[0];
            // The light is on the normal now: as bright as a quad that faces its light.
            let facing = lamp_test(chalk(), lamp([0.0, 0.0, -1.0]));
            let expected = pixel(&facing.draw(&[Shown::new(&mesh)]), 32, 32)[0];
            assert!(towards.abs_diff(expected) <= 4, "{from:?}: {towards}, not {expected}");
            test.lights = vec![lamp([x, y, -1.0])];
            let away = pixel(&test.draw(&[Shown::new(&mesh)]), 32, 32)[0];
            assert!(away < 20, "{from:?}: {away}");
            test.lights = vec![lamp([-x, -y, -1.0])];
        }
    }
}

#[test]
fn mirrored_and_flattened_nodes() {
    let mesh = quad();
    let mut test = LitTest::new(LitMaterial {
        base_color_texture: Some(TextureUse::of(0)),
        normal_texture: Some(TextureUse::of(1)),
        base_color: [1.0; 4],
        ..chalk()
    });
    test.environment = Environment::studio();
    test.images = vec![
        image(16, 16, |x, y| [(16 * x) as u8, (16 * y) as u8, 90, 255]),
        image(16, 16, |x, _| if x < 8 { [200, 128, 230, 255] } else { [128, 190, 238, 255] }),
    ];
    test.environment.lobes[0].direction = [0.0, 0.65, 0.75];
    test.environment.lobes[1].direction = [0.0, 0.25, 0.45];
    test.environment.lobes[2].direction = [0.0, 0.5, -0.85];
    let straight = test.draw(&[Shown::new(&mesh)]);
    let mirror = DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0));
    let mirrored = test.draw(&[Shown::at(&mesh, mirror)]);
    let rows = mirrored.rgba.chunks(4 * SIDE as usize);
    let turned_back = rows.flat_map(|row| row.chunks(4).rev().flatten().copied()).collect();
    let turned_back = Picture { rgba: turned_back, ..mirrored };
    assert!(differing_pixels(&straight, &turned_back, 3) <= 2 * SIDE as usize);
    // One flat axis keeps the normals; no size at all draws nothing.
    let flat = test.draw(&[Shown::at(&mesh, DMat4::from_scale(DVec3::new(1.0, 1.0, 0.0)))]);
    assert!(differing_pixels(&straight, &flat, 1) == 0);
    let nothing = test.draw(&[Shown::at(&mesh, DMat4::ZERO)]);
    assert!(nothing.rgba.iter().all(|&byte| byte == 0));
    for strange in [f64::NAN, f64::INFINITY, 1e300] {
        test.draw(&[Shown::at(&mesh, DMat4::from_scale(DVec3::splat(strange)))]);
    }
}

#[test]
fn single_sided_surfaces_have_no_back_and_double_sided_ones_are_lit_on_both() {
    let mesh = quad();
    let turned = DMat4::from_rotation_y(std::f64::consts::PI);
    let mut test = lamp_test(chalk(), lamp([0.0, 0.0, -1.0]));
    let front = pixel(&test.draw(&[Shown::new(&mesh)]), 32, 32);
    assert_eq!(pixel(&test.draw(&[Shown::at(&mesh, turned)]), 32, 32), [0; 4]);
    test.materials[0].is_double_sided = true;
    assert_near(pixel(&test.draw(&[Shown::at(&mesh, turned)]), 32, 32), front, 1);
    // Without normals, surfaces are flat and face the viewer.
    let mut without = mesh.clone();
    without.layers.retain(|layer| layer.semantic != Semantic::Normal);
    assert_near(pixel(&test.draw(&[Shown::at(&without, turned)]), 32, 32), front, 1);
}

#[test]
fn fine_checkers_fade_to_their_mean_light() {
    let mut test =
        LitTest::new(LitMaterial { base_color_texture: Some(TextureUse::of(0)), ..unlit([1.0; 4]) });
    test.images = vec![image(512, 512, |x, y| if (x + y) % 2 == 0 { [255; 4] } else { [0, 0, 0, 255] })];
    let mean = pixel(&test.draw(&[Shown::new(&quad())]), 31, 31);
    assert_near(mean, [188, 188, 188, 255], 2);
    let sampler = TextureSampler { mip_filter: None, ..Default::default() };
    test.materials[0].base_color_texture = Some(TextureUse {
        sampler: TextureSampler { min_filter: TextureFilter::Nearest, ..sampler },
        ..TextureUse::of(0)
    });
    let aliased = pixel(&test.draw(&[Shown::new(&quad())]), 31, 31);
    assert!([0, 255].contains(&aliased[0]), "{aliased:?}");
}

#[test]
fn texture_coordinates_are_chosen_and_transformed() {
    let mut mesh = quad();
    let second = vec![0.75; 8];
    mesh.layers.push(AttributeLayer::from_f32(Semantic::TexCoord(1), 2, second));
    let nearest = TextureSampler { mag_filter: TextureFilter::Nearest, ..Default::default() };
    let used = |uv_set, uv_transform| TextureUse { uv_set, uv_transform, sampler: nearest, image: 0 };
    let shown = |used, at: [u32; 2]| {
        let mut test = LitTest::new(LitMaterial { base_color_texture: Some(used), ..unlit([1.0; 4]) });
        test.images = vec![image(2, 2, |x, y| [(255 * x) as u8, (255 * y) as u8, 0, 255])];
        pixel(&test.draw(&[Shown::new(&mesh)]), at[0], at[1])
    };
    let same = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    assert_near(shown(used(1, same), [5, 5]), [255, 255, 0, 255], 1);
    // Shifted by half the image, which repeats.
    assert_near(shown(used(0, [[1.0, 0.0, 0.5], [0.0, 1.0, 0.0]]), [10, 10]), [255, 0, 0, 255], 1);
    // Turned: v becomes u.
    assert_near(shown(used(0, [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]), [10, 50]), [255, 0, 0, 255], 1);
}

#[test]
fn vertex_colors_are_linear_and_multiply_the_base_color() {
    let mut mesh = quad();
    let data = LayerData::U8([128u8, 64, 255, 255].repeat(4));
    mesh.layers.push(AttributeLayer {
        semantic: Semantic::Color(0),
        component_count: 4,
        normalized: true,
        data,
    });
    let picture = LitTest::new(unlit([0.5, 1.0, 0.25, 1.0])).draw(&[Shown::new(&mesh)]);
    let expected = [srgb(0.5 * 128.0 / 255.0), srgb(64.0 / 255.0), srgb(0.25), 255];
    assert_near(pixel(&picture, 32, 32), expected, 1);
}

/// A strip of squares from x = -1 to 1, whose joints' weights change from left to right in sets of four.
fn bending_strip(joint_count: usize) -> (IndexedMesh, Vec<[f32; 8]>) {
    let columns = 16;
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    let mut weights = Vec::new();
    for column in 0..=columns {
        let part = column as f32 / columns as f32;
        for y in [-0.2, 0.2] {
            positions.push([2.0 * part - 1.0, y, 0.0]);
            let at = part * (joint_count - 1) as f32;
            weights.push(std::array::from_fn(|joint| {
                if joint < joint_count { (1.0 - (at - joint as f32).abs()).max(0.0) * 0.7 } else { 0.0 }
            }));
        }
        if column < columns {
            let a = 2 * column as u32;
            triangles.extend([[a, a + 2, a + 1], [a + 1, a + 2, a + 3]]);
        }
    }
    let mut mesh = IndexedMesh::new(positions, triangles);
    for set in 0..2u8 {
        let first = 4 * u16::from(set);
        let joints = vec![[first, first + 1, first + 2, first + 3]; mesh.vertex_count()].concat();
        let of_set = weights.iter().flat_map(|w: &[f32; 8]| w[usize::from(first)..][..4].to_vec()).collect();
        mesh.layers.push(AttributeLayer {
            semantic: Semantic::Joints(set),
            component_count: 4,
            normalized: false,
            data: LayerData::U16(joints),
        });
        mesh.layers.push(AttributeLayer::from_f32(Semantic::Weights(set), 4, of_set));
    }
    (mesh, weights)
}

#[test]
fn skinned_vertices_are_where_the_processor_puts_them() {
    for joint_count in [2, 4, 7, 8] {
        let (mesh, weights) = bending_strip(joint_count);
        let joints: Vec<DMat4> = (0..joint_count)
            .map(|joint| {
                let turn = DMat4::from_rotation_z(0.35 * joint as f64 / joint_count as f64);
                DMat4::from_translation(DVec3::new(0.02 * joint as f64, -0.1, 0.0)) * turn
            })
            .collect();
        let mut posed = mesh.clone();
        for (position, weights) in posed.positions.iter_mut().zip(&weights) {
            let total: f32 = weights.iter().sum();
            let point = DVec3::from(position.map(f64::from));
            let moved: DVec3 = joints
                .iter()
                .zip(weights)
                .map(|(j, &w)| j.transform_point3(point) * f64::from(w / total))
                .sum();
            *position = moved.as_vec3().into();
        }
        posed.layers.clear();
        let mut test = LitTest::new(unlit([1.0; 4]));
        test.materials[0].is_double_sided = true;
        let elsewhere = DMat4::from_translation(DVec3::splat(100.0));
        let by_gpu = test.draw(&[Shown { joints: &joints, ..Shown::at(&mesh, elsewhere) }]);
        let by_processor = test.draw(&[Shown::new(&posed)]);
        assert!(differing_pixels(&by_gpu, &by_processor, 1) <= 2, "{joint_count} joints");
        assert!(support::drawn_pixels(&by_gpu) > 300);
        // Joints that the skin does not have move nothing; without any, the vertices stay.
        let still = test.draw(&[Shown::new(&mesh)]);
        assert!(differing_pixels(&by_gpu, &still, 1) > 100);
        test.draw(&[Shown { joints: &joints[..1], ..Shown::new(&mesh) }]);
    }
}

#[test]
fn morphed_vertices_are_where_the_processor_puts_them() {
    let mut mesh = sphere();
    let count = mesh.vertex_count();
    let displacements = [0usize, 2].map(|target| -> Vec<f32> {
        (0..3 * count).map(|at| 0.3 * ((at * (target + 3)) as f32).sin()).collect()
    });
    for (target, data) in [0u16, 2].into_iter().zip(&displacements) {
        mesh.layers.push(AttributeLayer::from_f32(Semantic::MorphPosition(target), 3, data.clone()));
    }
    // Normals follow only the second target.
    let normals: Vec<f32> = vec![[0.3, 0.0, 0.2]; count].concat();
    mesh.layers.push(AttributeLayer::from_f32(Semantic::MorphNormal(2), 3, normals));
    let weights = [0.4, 9.0, -0.25];
    let mut posed = mesh.clone();
    posed.layers.retain(|layer| layer.semantic == Semantic::Normal);
    for (at, position) in posed.positions.as_flattened_mut().iter_mut().enumerate() {
        *position += weights[0] * displacements[0][at] + weights[2] * displacements[1][at];
    }
    let LayerData::F32(posed_normals) = &mut posed.layers[0].data else { unreachable!() };
    for (normal, [x, y, z]) in
        posed_normals.as_chunks_mut::<3>().0.iter_mut().zip(&vec![[0.3, 0.0, 0.2]; count])
    {
        for (value, by) in normal.iter_mut().zip([x, y, z]) {
            *value += weights[2] * by;
        }
    }
    let mut test = LitTest::new(chalk());
    test.environment = Environment::studio();
    let by_gpu = test.draw(&[Shown { morph_weights: &weights, ..Shown::new(&mesh) }]);
    let by_processor = test.draw(&[Shown::new(&posed)]);
    assert!(differing_pixels(&by_gpu, &by_processor, 3) <= 8);
    assert!(differing_pixels(&by_gpu, &test.draw(&[Shown::new(&mesh)]), 3) > 500);
}

#[test]
fn scenes_far_from_the_origin_look_the_same() {
    let mut test = LitTest::new(LitMaterial { roughness: 0.3, ..Default::default() });
    test.environment = Environment::studio();
    let mesh = sphere();
    let near = test.draw(&[Shown::new(&mesh)]);
    let far_away = DVec3::new(6.4e6, -2.0e6, 1.0e7);
    let moved = |point: [f64; 3]| (DVec3::from(point) + far_away).into();
    test.camera =
        LitCamera { eye: moved(test.camera.eye), look_at: moved(test.camera.look_at), ..test.camera };
    let far = test.draw(&[Shown::at(&mesh, DMat4::from_translation(far_away))]);
    assert!(differing_pixels(&near, &far, 1) <= 4);
}

#[test]
fn targets_without_srgb_get_encoded_colors() {
    let mut test = LitTest::new(unlit([0.2, 0.5, 0.8, 1.0]));
    let expected = pixel(&test.draw(&[Shown::new(&quad())]), 32, 32);
    test.painter = Arc::new(LitPainter::new(&test.gpu, wgpu::TextureFormat::Rgba8Unorm, 1));
    let (gpu, size) = (&test.gpu, wgpu::Extent3d { width: SIDE, height: SIDE, depth_or_array_layers: 1 });
    let make = |format, usage| {
        gpu.device().create_texture(&wgpu::TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage,
            view_formats: &[],
        })
    };
    let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT;
    let color = make(wgpu::TextureFormat::Rgba8Unorm, drawn | wgpu::TextureUsages::COPY_SRC);
    let depth = make(striata_gpu::DEPTH_FORMAT, drawn).create_view(&Default::default());
    let mesh = quad();
    let vertices = LitVertices::upload(gpu, &test.painter, &mesh).unwrap();
    let indices = GpuIndices::upload(gpu, cast_slice(&mesh.triangles)).unwrap();
    let parts = [LitPart { range: 0..6, material: Some(0) }];
    let materials = LitMaterials::upload(gpu, &test.painter, &test.materials, &[]).unwrap();
    let mut frame = LitFrame::new(gpu, &test.painter, &test.environment).unwrap();
    let objects = [LitObject::new(&vertices, &indices, &parts)];
    let scene =
        LitScene { camera: camera(), size: [SIDE; 2], lights: &[], materials: &materials, objects: &objects };
    frame.update(gpu, &test.painter, &scene).unwrap();
    let mut encoder = gpu.device().create_command_encoder(&Default::default());
    frame.draw(&mut encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &color.create_view(&Default::default()),
            depth_slice: None,
            resolve_target: None,
            ops: Default::default(),
        })],
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &depth,
            depth_ops: Some(wgpu::Operations {
                load: wgpu::LoadOp::Clear(0.0),
                store: wgpu::StoreOp::Discard,
            }),
            stencil_ops: None,
        }),
        ..Default::default()
    }));
    gpu.queue().submit([encoder.finish()]);
    assert_near(pixel(&Picture::read(gpu, &color).unwrap(), 32, 32), expected, 1);
}

#[test]
fn mistakes_are_errors_that_name_their_place() {
    let textured =
        LitMaterial { name: "wood".into(), base_color_texture: Some(TextureUse::of(1)), ..unlit([1.0; 4]) };
    let mut test = LitTest::new(textured);
    let mesh = quad();
    let error = |test: &LitTest, shown: Shown<'_>| test.try_draw(&[shown]).unwrap_err().to_string();
    test.images = vec![image(2, 2, |_, _| [255; 4])];
    assert_eq!(error(&test, Shown::new(&mesh)), "material \"wood\" uses image 1, but there are 1 images");
    for (width, height) in [(0, 0), (3, 2), (u32::MAX, u32::MAX)] {
        test.images.truncate(1);
        test.images.push(LitImage { width, height, rgba: [0; 16].into() });
        assert!(error(&test, Shown::new(&mesh)).contains("image 1"), "{width} x {height}");
    }
    test.materials[0].base_color_texture = None;
    let shown = Shown { material: Some(7), ..Shown::new(&mesh) };
    assert_eq!(error(&test, shown), "a part uses material 7, but there are 1 materials");
    test.draw(&[Shown { material: None, ..Shown::new(&mesh) }]);
    let mut broken = mesh.clone();
    broken.triangles[1][2] = 4;
    assert!(error(&test, Shown::new(&broken)).contains("triangle 1 uses vertex 4"));
    let mut short = mesh.clone();
    short.layers[1].data = LayerData::F32(vec![0.0; 7]);
    assert!(error(&test, Shown::new(&short)).contains("texcoord_0"));
    test.lights = vec![lamp([0.0, 0.0, -1.0]); LitFrame::MAX_LIGHT_COUNT + 1];
    assert!(error(&test, Shown::new(&mesh)).contains("33 lamps"));
    test.lights.clear();

    let vertices = LitVertices::upload(&test.gpu, &test.painter, &mesh).unwrap();
    let indices = GpuIndices::upload(&test.gpu, &[0, 1, 2]).unwrap();
    let materials = LitMaterials::upload(&test.gpu, &test.painter, &[], &[]).unwrap();
    let mut frame = LitFrame::new(&test.gpu, &test.painter, &test.environment).unwrap();
    let parts = [LitPart { range: 0..6, material: None }];
    let objects = [LitObject::new(&vertices, &indices, &parts)];
    let scene =
        LitScene { camera: camera(), size: [SIDE; 2], lights: &[], materials: &materials, objects: &objects };
    let beyond = frame.update(&test.gpu, &test.painter, &scene).unwrap_err();
    assert_eq!(beyond.to_string(), "a part uses the indices 0..6, but the buffer has 3");
    // Empty scenes and meshes are no mistake.
    let empty = IndexedMesh::new(Vec::new(), Vec::new());
    let nothing = test.draw(&[Shown::new(&empty)]);
    assert!(nothing.rgba.iter().all(|&byte| byte == 0) && test.draw(&[]) == nothing);
}

#[test]
fn images_can_be_replaced() {
    let mut test =
        LitTest::new(LitMaterial { base_color_texture: Some(TextureUse::of(0)), ..unlit([1.0; 4]) });
    test.images = vec![image(1, 1, |_, _| [200, 0, 0, 255])];
    let gpu = &test.gpu;
    let mut materials = LitMaterials::upload(gpu, &test.painter, &test.materials, &test.images).unwrap();
    let mesh = quad();
    let vertices = LitVertices::upload(gpu, &test.painter, &mesh).unwrap();
    let indices = GpuIndices::upload(gpu, cast_slice(&mesh.triangles)).unwrap();
    let parts = [LitPart { range: 0..6, material: Some(0) }];
    let mut frame = LitFrame::new(gpu, &test.painter, &test.environment).unwrap();
    let mut color = |materials: &LitMaterials| {
        let objects = [LitObject::new(&vertices, &indices, &parts)];
        let scene = LitScene { camera: camera(), size: [SIDE; 2], lights: &[], materials, objects: &objects };
        frame.update(gpu, &test.painter, &scene).unwrap();
        pixel(&test.canvas.paint(gpu, [0.0; 4], |pass| frame.draw(pass)).unwrap(), 32, 32)
    };
    assert_near(color(&materials), [200, 0, 0, 255], 1);
    let finer = image(8, 8, |_, _| [0, 150, 0, 255]);
    materials.replace_image(gpu, &test.painter, (0, &finer)).unwrap();
    assert_near(color(&materials), [0, 150, 0, 255], 1);
    assert!(materials.replace_image(gpu, &test.painter, (1, &finer)).is_err());
}
